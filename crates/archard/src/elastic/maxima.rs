//! The largest stresses below a contact, with their errors.
//!
//! Stresses of even elements of size h miss those of the tractions they stand for by a power of h: below the surface by the second.
//! The same field on elements of 2 h and 4 h, under the means of the tractions, says by how much. On the surface, next to an edge of
//! the contact, they miss them by h^(1/2): what is there is [extrapolated](super::edge).

use rayon::prelude::*;

use super::PressedHalfSpace;
use super::edge::{AtEdge, edges};
use super::interfaces::{Interface, SOUGHT, Side, interfaces};
use crate::compliance::half_space::inside::Below;
use crate::numerics::SAME;
use crate::stress::{Components, MEASURES};

/// A measure of a stress (Pa).
pub(super) type Of = fn(&Components) -> f64;

/// Ratio of two depths that follow each other: a maximum is sought from the largest stress at any. A choice of effort.
const RATIO: f64 = 1.25;
/// How closely a maximum is placed, relative to the size of an element; its value follows with the square of that. A choice of effort.
const CLOSE: f64 = 1.0 / 32.0;
/// Pressed elements around one that is away from the edge. A choice: what is left nearer to it counts as unknown, unless what is found
/// elsewhere is larger.
const AROUND: isize = 3;
/// The least and the greatest order that a field can have: that of a root of the distance, at an edge or where stick ends, and that of
/// even elements.
const ORDERS: [f64; 2] = [0.5, 2.0];

/// What the errors by elements of three sizes are multiplied by, as elements stand out from an edge otherwise on each of them
/// (P. J. Roache, *J. Fluids Eng.* 116 (1994) 405).
const SAFETY: f64 = 1.25;

/// A largest stress.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Maximum {
    /// How large (Pa).
    pub value: f64,
    /// How far off it may be (Pa) because of the size of the elements; the error of the tractions themselves comes on top.
    pub error: f64,
    /// The order in the size of the elements that the error follows from.
    pub order: f64,
    /// Where it is (m), in the axes of the body.
    pub place: [f64; 3],
}

/// What there is in a plane below the surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    /// How deep (m).
    pub depth: f64,
    /// The index of the layer it is in, from the surface down.
    pub piece: usize,
    /// The largest value of each measure (Pa) below a centre of an element, and where along x and y (m).
    pub largest: [(f64, [f64; 2]); 4],
    /// The mean of the equivalent stress (Pa) below all that is pressed.
    pub mean: f64,
    /// The area (relative to that pressed) that yields, where the strength is known.
    pub yields: Option<f64>,
    /// In a body with layers: the largest and the least normal stress along the surface, then across it (Pa, the least with its sign
    /// reversed), and the largest shear along it, each with its place along x and y (m).
    pub faces: Vec<(f64, [f64; 2])>,
}

/// The largest stresses of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct Maxima {
    /// Below the surface, in the order of [`MEASURES`].
    pub inside: [Maximum; 4],
    /// On the surface, at an edge of the contact extrapolated to elements without size; `None` where the pressure does not fall to
    /// zero there as it does at a smooth edge, so that the stress has no bound or is not resolved.
    pub surface: [Option<Maximum>; 4],
    /// The planes that were looked at, from above; interfaces of layers twice, from above and from below.
    pub layers: Vec<Layer>,
    /// The same of each layer and of what is below all: one of a body without layers.
    pub pieces: Vec<Piece>,
    /// What crosses the interfaces of layers, from above.
    pub interfaces: Vec<Interface>,
    /// The largest and the least normal stress along the surface of a body with layers; `None` where that is not known.
    pub face: [Option<Maximum>; 2],
}

/// The largest stresses in a layer, or below all of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// Its index, from the surface down.
    pub index: usize,
    /// How deep (m) it begins and ends.
    pub ends: [f64; 2],
    /// Below the surface, in the order of [`MEASURES`].
    pub inside: [Maximum; 4],
}

impl Maximum {
    /// Of the value on elements of once, twice and four times the size at that place.
    pub(super) fn of(values: [f64; 3], place: [f64; 3]) -> Self {
        Self::of_order(values, place, ORDERS[1])
    }

    /// The same of a field whose order is no more than that.
    pub(super) fn of_order([value, near, far]: [f64; 3], place: [f64; 3], most: f64) -> Self {
        let (first, second) = ((value - near).abs(), (near - far).abs());
        let order = (second / first).log2().clamp(ORDERS[0], most);
        let order = if order.is_nan() { most } else { order };
        let ratio = order.exp2();
        // One of both differences may vanish by chance.
        let error = SAFETY * first.max(second / ratio) / (ratio - 1.0);
        Self { value, error, order, place }
    }
}

impl Maxima {
    /// The larger of what is inside and what is on the surface; `None` where the latter is not known.
    pub fn largest(&self, measure: usize) -> Option<Maximum> {
        self.or_on_surface(self.inside[measure], measure)
    }

    /// The largest of a layer: of the uppermost with what is on the surface, `None` where that is not known.
    pub fn largest_in(&self, piece: &Piece, measure: usize) -> Option<Maximum> {
        let inside = piece.inside[measure];
        if piece.index == 0 { self.or_on_surface(inside, measure) } else { Some(inside) }
    }

    fn or_on_surface(&self, inside: Maximum, measure: usize) -> Option<Maximum> {
        self.surface[measure].map(|own| if own.value > inside.value { own } else { inside })
    }
}

impl PressedHalfSpace {
    /// Depths (m) in a constant ratio, from half an element to as deep as the contact is wide along its shorter side, as far as
    /// stresses are known; none where nothing is pressed.
    pub fn depths(&self) -> Vec<f64> {
        let [nx, _] = self.below.elements();
        let pressed = self.below.pressure().iter().enumerate().filter(|(_, p)| **p > 0.0);
        let none = [[usize::MAX, 0]; 2];
        let extents = pressed.fold(none, |known, (element, _)| {
            let index = [element % nx, element / nx];
            [0, 1].map(|axis| [known[axis][0].min(index[axis]), known[axis][1].max(index[axis])])
        });
        let spacing = self.below.spacing();
        let width = |axis: usize| {
            let [low, high] = extents[axis];
            (high + 1).saturating_sub(low) as f64 * spacing[axis]
        };
        let across = if self.below.is_line() { width(0) } else { width(0).min(width(1)) };
        let (first, last) = (0.5 * spacing[0].min(spacing[1]), across.min(self.known_depth()));
        if last < first {
            return vec![];
        }
        let count = ((last / first).ln() / RATIO.ln()).ceil() as usize + 1;
        let ratio = (last / first).powf(1.0 / (count.max(2) - 1) as f64);
        // The last is met, to all digits.
        (1..count).map(|index| first * ratio.powi(index as i32 - 1)).chain([last]).collect()
    }

    /// The largest shear (Pa) along the surface, by which a line of contact that passes again and again shakes down after Melan
    /// (K. L. Johnson & J. A. Jefferis, *Symposium on Rolling Contact Fatigue*, 1963): residual stresses xx and yy are free, and
    /// what is left is that shear, up to the strength in shear. `None` where it is no line, friction acts along it, the body has layers,
    /// whose strengths differ, or that shear is not known on the surface.
    pub fn shakes_down(&self, maxima: &Maxima) -> Option<f64> {
        let bare = self.below.pieces().len() == 1 && self.ground.is_infinite();
        let plane = bare && self.below.is_line() && !self.below.rubs_along(1);
        maxima.largest(3).filter(|_| plane).map(|largest| largest.value)
    }

    /// The largest stresses at these depths (m) and between them, with an even stress added, and what yields under the strength (Pa) of each
    /// layer and of what is below all, where that is known. Where there are layers, both sides of all interfaces are looked at too. `see` is
    /// shown the stresses in every plane, which are no numbers where they depend on pressures beyond the frame. `None` where nothing is
    /// known, and of a frame that repeats itself without [elements to judge by](PressedHalfSpace::halves).
    pub fn maxima(
        &self,
        depths: &[f64],
        (initial, strengths): (&Components, &[Option<f64>]),
        see: &mut dyn FnMut(f64, &[Vec<f64>; 6]),
    ) -> Option<Maxima> {
        if !self.is_judged() {
            return None;
        }
        let coarse = self.below.coarser();
        let levels = [&self.below, &coarse, &coarse.coarser()];
        let ends = self.below.pieces();
        let layered = ends.len() > 1 || self.ground.is_finite();
        let (mut layers, mut pieces) = (vec![], vec![]);
        for (index, ends) in ends.iter().enumerate() {
            let depths = self.depths_within(depths, *ends);
            if depths.is_empty() {
                continue;
            }
            let own = self.within(index);
            let strength = strengths.get(index).copied().flatten();
            let first = layers.len();
            for &depth in &depths {
                let plane = own.plane(depth, initial);
                see(depth, &plane);
                let looked_at = layer(&own.below, (depth, index), &plane, strength);
                let sought = |of: Of| largest(&own.below, &plane, of);
                let faces = if layered { SOUGHT.map(sought).to_vec() } else { vec![] };
                layers.push(Layer { faces, ..looked_at });
            }
            let levels = levels.map(|below| below.within(index));
            let inside = |measure: usize| -> Option<Maximum> {
                let looked_at = layers[first..].iter();
                let from = looked_at
                    .max_by(|a, b| a.largest[measure].0.total_cmp(&b.largest[measure].0))?;
                let [x, y] = from.largest[measure].1;
                let start = [x, y, -from.depth];
                let of = (MEASURES[measure].1, initial);
                Some(own.below_surface(levels.each_ref(), of, start, &depths))
            };
            let inside = [inside(0)?, inside(1)?, inside(2)?, inside(3)?];
            pieces.push(Piece { index, ends: *ends, inside });
        }
        let inside = |measure: usize| {
            let each = pieces.iter().map(|piece| piece.inside[measure]);
            each.reduce(|one, other| if other.value > one.value { other } else { one })
        };
        let inside = [inside(0)?, inside(1)?, inside(2)?, inside(3)?];
        let surface = self.within(0);
        let on_top = levels.map(|below| below.within(0));
        let [hx, hy] = self.below.spacing();
        let face = surface.below.plane(0.0);
        let edges = edges(&surface.below, &surface.plane(hx.max(hy), initial), &face);
        let total = surface.plane(0.0, initial);
        let on_face = |of: Of| {
            let own = (&surface, on_top.each_ref());
            on_surface(own, (of, initial), (&total, &edges))
        };
        let along = Side::MEASURES.map(|of| layered.then(|| on_face(of)).flatten());
        let interfaces = interfaces(self, levels, initial, &layers);
        Some(Maxima {
            inside,
            surface: MEASURES.map(|(_, of)| on_face(of)),
            layers,
            pieces,
            interfaces,
            face: Side::signed(along),
        })
    }

    /// The depths (m) within a layer: those of them that are, and its faces below the surface as far as stresses are known.
    fn depths_within(&self, depths: &[f64], [top, end]: [f64; 2]) -> Vec<f64> {
        let inner = |depth: &f64| *depth > top * (1.0 + SAME) && *depth < end * (1.0 - SAME);
        let known = self.known_depth() * (1.0 + SAME);
        let first = (top > 0.0 && top <= known).then_some(top);
        let last = (end.is_finite() && end <= known).then_some(end);
        let inner =
            depths.iter().copied().filter(|depth| inner(depth) || *depth == top && top == 0.0);
        first.into_iter().chain(inner).chain(last).collect()
    }

    /// The maximum below the surface next to a place, within these depths; the field there on elements of twice and four times the size
    /// says how far off it may be.
    pub(super) fn below_surface(
        &self,
        levels: [&Below; 3],
        (measure, initial): (Of, &Components),
        start: [f64; 3],
        depths: &[f64],
    ) -> Maximum {
        let value = |below: &Below, place: [f64; 3]| {
            let (mut stress, added) = (below.stress(place), self.added(initial, place));
            stress.iter_mut().zip(added).for_each(|(own, added)| *own += added);
            measure(&stress)
        };
        let [h, _] = levels[0].spacing();
        let ends = [depths[0], depths[depths.len() - 1]];
        let (mut place, mut best, mut step) = (start, value(levels[0], start), 0.5 * h);
        let axes: &[usize] = if levels[0].is_line() { &[0, 2] } else { &[0, 1, 2] };
        // Uphill along one axis after the other, by steps that double where they lead up and halve where none does: what only fades is
        // followed for ever by steps of one size, and never beyond what rounding leaves of it.
        let least = SAME * self.peak();
        while step > CLOSE * h {
            let mut higher = false;
            for (axis, side) in axes.iter().flat_map(|&axis| [(axis, -1.0), (axis, 1.0)]) {
                let mut next = place;
                next[axis] += side * step;
                next[2] = -(-next[2]).clamp(ends[0], ends[1]);
                if next == place || !self.knows(next) {
                    continue;
                }
                let there = value(levels[0], next);
                if there > best + least {
                    (place, best, higher) = (next, there, true);
                }
            }
            step *= if higher { 2.0 } else { 0.5 };
        }
        let mut found =
            Maximum::of([best, value(levels[1], place), value(levels[2], place)], place);
        found.error += levels[0].missed(-place[2]) + self.ends_miss(measure, place);
        found
    }
}

/// The largest in a plane, where it is known, and where along x and y (m).
fn largest(below: &Below, plane: &[Vec<f64>; 6], of: Of) -> (f64, [f64; 2]) {
    let value = |element: usize| of(&plane.each_ref().map(|field| field[element]));
    let known = (0..plane[0].len()).filter(|element| !plane[0][*element].is_nan());
    let all = known.map(|element| (value(element), element));
    let (value, element) = all.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((f64::NAN, 0));
    (value, below.place(element))
}

/// What there is in a plane.
fn layer(
    below: &Below,
    (depth, piece): (f64, usize),
    plane: &[Vec<f64>; 6],
    strength: Option<f64>,
) -> Layer {
    let of = |element: usize| plane.each_ref().map(|field| field[element]);
    let count = below.pressure().len();
    let known = |element: &usize| !plane[0][*element].is_nan();
    let all: Vec<[f64; 4]> = (0..count)
        .into_par_iter()
        .with_min_len(256)
        .map(|element| MEASURES.map(|(_, measure)| measure(&of(element))))
        .collect();
    let largest = [0, 1, 2, 3].map(|measure| {
        let known = (0..count).filter(known);
        let element = known.max_by(|&a, &b| all[a][measure].total_cmp(&all[b][measure]));
        let element = element.unwrap_or_default();
        (all[element][measure], below.place(element))
    });
    let pressed = |element: &usize| known(element) && below.pressure()[*element] > 0.0;
    let area = (0..count).filter(pressed).count().max(1) as f64;
    let mean = (0..count).filter(pressed).map(|element| all[element][0]).sum::<f64>() / area;
    let yields = strength.map(|own| all.iter().filter(|all| all[0] > own).count() as f64 / area);
    Layer { depth, piece, largest, mean, yields, faces: vec![] }
}

/// The maximum on the surface, by the stresses there: where all is pressed around, or at an edge; `None` where neither is known.
fn on_surface(
    (body, levels): (&PressedHalfSpace, [&Below; 3]),
    (measure, initial): (Of, &Components),
    (face, edges): (&[Vec<f64>; 6], &[AtEdge]),
) -> Option<Maximum> {
    let with = |mut stress: Components, added: &Components| {
        stress.iter_mut().zip(added).for_each(|(own, added)| *own += added);
        stress
    };
    let below = levels[0];
    let [nx, ny] = below.elements();
    let pressed = |element: usize, dx: isize, dy: isize| {
        let [mut i, mut j] = [(element % nx) as isize + dx, (element / nx) as isize + dy];
        if below.repeats() {
            (i, j) = (i.rem_euclid(nx as isize), j.rem_euclid(ny as isize));
        }
        let there = (0..nx as isize).contains(&i) && (0..ny as isize).contains(&j);
        there && below.pressure()[(i + nx as isize * j) as usize] > 0.0
    };
    let across = if below.is_line() { 0 } else { AROUND };
    let surrounded = |element: usize| {
        (-AROUND..=AROUND).all(|dx| (-across..=across).all(|dy| pressed(element, dx, dy)))
    };
    let largest = |plane: &[Vec<f64>; 6], counts: &(dyn Fn(usize) -> bool + Sync)| {
        let own = (0..below.pressure().len()).into_par_iter().with_min_len(256);
        let own = own.filter(|element| counts(*element));
        let own =
            own.map(|element| (element, measure(&plane.each_ref().map(|field| field[element]))));
        own.max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0)))
    };
    let middle = largest(face, &surrounded).map(|(element, value)| {
        let [x, y] = below.place(element);
        let place = [x, y, 0.0];
        let added = body.added(initial, place);
        let coarser = |level: usize| measure(&with(levels[level].stress(place), &added));
        Maximum::of([value, coarser(1), coarser(2)], place)
    });
    let beside = largest(face, &|element| !surrounded(element));
    let beside = beside.map_or(f64::NEG_INFINITY, |(_, value)| value);
    let edges = edges.iter().map(|edge| {
        let [x, y] = edge.place;
        let place = [x, y, 0.0];
        let added = body.added(initial, place);
        let [value, error] = edge.measure(|stress| measure(&with(stress, &added)));
        Maximum { value, error, order: ORDERS[0], place }
    });
    // The largest that is sure.
    let edge =
        edges.max_by(|one, other| (one.value - one.error).total_cmp(&(other.value - other.error)));
    let known = match (middle, edge) {
        (Some(middle), Some(edge)) if middle.value > edge.value => Some(middle),
        (middle, edge) => edge.or(middle),
    };
    // What elements have next to an edge that is not known is larger still at it.
    let known = known.filter(|known| known.value + known.error >= beside);
    known.map(|known| {
        let missed = below.missed(0.0) + body.ends_miss(measure, known.place);
        Maximum { error: known.error + missed, ..known }
    })
}
