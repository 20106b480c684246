//! Cams and followers that wear over many turns.

use std::ops::Range;

use super::sweep::{Passage, Sweep};
use super::{Cam, Station, shape};
use crate::line::worn;
use crate::march::{Depths, Limit, Marched, Moment, Wearing, deepest, march};

/// Points of a passage. A choice: half of them say how far off they are.
const POINTS: usize = 32;
/// Places of a follower to begin with. A choice: more are taken where what is left there is not straight between them.
const PLACES: usize = 128;
/// How far from straight between two places what is left may be, over the largest. A choice well below the error of wear laws.
const STRAIGHT: f64 = 1e-4;
/// Of the half-width: places are not divided further. What is left is smooth over the width of the contact.
const FINEST: f64 = 1.0 / 64.0;

/// A cam and its follower that are worn.
#[derive(Debug, Clone, PartialEq)]
pub struct WornCam {
    /// Angles (rad) of the cam and places (m) of the follower where depths are known.
    pub nodes: [Vec<f64>; 2],
    /// From new to worn.
    pub course: Vec<Moment>,
    /// Error (m) of the depths at the end: of steps, of the lift and of sums, and of what wear changes.
    pub errors: [Vec<f64>; 2],
    /// Worn volume (m^3) of the cam and of the follower, and its error.
    pub volumes: [[f64; 2]; 2],
    /// The limit that is reached first, and the error of the number of turns; `None` where none is.
    pub life: Option<(Limit, f64)>,
    /// By how much worn bodies wear otherwise than new ones where they are deepest, relative to it: by what their curvatures differ there
    /// from those of the new ones, where they touch each other instead, and the force of the spring.
    pub changed: [f64; 2],
}

impl WornCam {
    /// The end of the course.
    pub fn last(&self) -> &Moment {
        &self.course[self.course.len() - 1]
    }

    /// The node where a body is deepest, the depth (m) there and its error.
    pub fn deepest(&self, body: usize) -> (usize, [f64; 2]) {
        let (at, [depth, error]) = deepest(&self.last().depths[body], &self.errors[body]);
        // Between nodes it may be deeper.
        (at, [depth, error + STRAIGHT * depth])
    }
}

/// A cam and its follower on their way.
struct Surfaces<'a> {
    cam: &'a Cam,
    passages: [Vec<Passage>; 2],
}

impl Wearing for Surfaces<'_> {
    fn nodes(&self) -> [usize; 2] {
        self.passages.each_ref().map(Vec::len)
    }

    fn rates(&self, depths: &Depths) -> Depths {
        let friction = self.cam.friction.as_deref();
        [0, 1].map(|body| {
            let passages = self.passages[body].iter();
            let Some(law) = &self.cam.laws[body] else { return vec![0.0; passages.len()] };
            let of = |(passage, before): (&Passage, &f64)| {
                let parts = passage.parts.iter().copied();
                worn((&**law, friction), 1.0, passage.whole(), parts, *before)
            };
            passages.zip(&depths[body]).map(of).collect()
        })
    }
}

impl Cam {
    /// What the nodes of both bodies go through.
    fn surfaces(&self, sweep: &Sweep<'_>, nodes: &[Vec<f64>; 2]) -> Surfaces<'_> {
        let passages = [0, 1].map(|body| {
            let places = sweep.places(body);
            let of = |node: &f64| self.at_node(sweep, (body, &places), *node);
            nodes[body].iter().map(of).collect()
        });
        Surfaces { cam: self, passages }
    }

    /// What a node goes through; nothing of a body that does not wear.
    fn at_node(&self, sweep: &Sweep<'_>, (body, places): (usize, &[f64]), node: f64) -> Passage {
        if self.laws[body].is_none() {
            return Passage::default();
        }
        let place = if body == 0 { sweep.place(0, &self.station(node)) } else { node };
        sweep.passage(body, places, place)
    }

    /// The nodes of a body: between seeds, more where what is left is not straight between them.
    fn nodes(&self, sweep: &Sweep<'_>, body: usize) -> Vec<f64> {
        let places = sweep.places(body);
        let narrowest =
            sweep.stations.iter().map(|one| one.half_width).fold(f64::INFINITY, f64::min);
        let (mut seeds, finest) = if body == 0 {
            let fastest = sweep.stations.iter().map(|one| one.touch.speeds[0]).fold(0.0, f64::max);
            (sweep.stations.iter().map(|one| one.angle).collect(), FINEST * narrowest / fastest)
        } else {
            (seeds(sweep), FINEST * narrowest)
        };
        seeds.sort_by(f64::total_cmp);
        let end = seeds.last().copied();
        seeds.dedup_by(|next, last| *next - *last < 4.0 * finest);
        // The end of all stays.
        if let (Some(last), Some(end)) = (seeds.last_mut(), end) {
            *last = end;
        }
        let work = |node: f64| self.at_node(sweep, (body, &places), node).work();
        let works: Vec<f64> = seeds.iter().map(|seed| work(*seed)).collect();
        let straight = STRAIGHT * works.iter().copied().fold(0.0, f64::max);
        let mut nodes = vec![];
        for (pair, works) in seeds.windows(2).zip(works.windows(2)) {
            nodes.push(pair[0]);
            between(
                &work,
                [pair[0], pair[1]],
                [works[0], works[1]],
                [straight, finest],
                &mut nodes,
            );
        }
        nodes.extend(seeds.last());
        nodes
    }

    /// Wears cam and follower over so many turns, or until a limit is reached.
    pub fn wear(&self, turns: f64, limits: &[Limit]) -> WornCam {
        let sweep = Sweep::new(self, [self.angles(), POINTS]);
        let nodes = [0, 1].map(|body| self.nodes(&sweep, body));
        let surfaces = self.surfaces(&sweep, &nodes);
        let Marched { course, mut errors, life } = march(&surfaces, turns, limits);
        let last = &course[course.len() - 1];
        let places = [0, 1].map(|body| match body {
            0 => nodes[0].iter().map(|angle| sweep.place(0, &self.station(*angle))).collect(),
            _ => nodes[1].clone(),
        });
        self.add_coarser(&nodes, &places, last, &mut errors);
        let shapes = [0, 1].map(|body| Shape {
            places: &places[body],
            depths: &last.depths[body],
            around: if body == 0 { sweep.perimeter() } else { f64::INFINITY },
        });
        let changes = self.changes(&sweep, &shapes);
        let softer = changes.iter().map(|change| change.softer).fold(0.0, f64::max);
        let volumes = [0, 1].map(|body| {
            let of = |values: &[f64], every| self.width * area(&places[body], values, every);
            let [fine, coarse] = [1, 2].map(|every| of(&last.depths[body], every));
            let missed = of(&errors[body], 1);
            [fine, (fine - coarse).abs() + missed + softer * fine]
        });
        let changed = [0, 1].map(|body| {
            let by: Vec<f64> = surfaces.passages[body]
                .iter()
                .enumerate()
                .map(|(node, passage)| {
                    shapes[body].changed(node, &sweep.stations, &passage.during, &changes)
                })
                .collect();
            errors[body].iter_mut().zip(&by).for_each(|(error, by)| *error += by);
            let (at, [depth, _]) = deepest(&last.depths[body], &errors[body]);
            if depth > 0.0 { by[at] / depth } else { 0.0 }
        });
        let life = life.map(|(limit, until)| {
            let (at, [_, error]) = deepest(&last.depths[limit.body], &errors[limit.body]);
            let rate = surfaces.rates(&last.depths)[limit.body][at];
            (limit, until + error / rate)
        });
        WornCam { nodes, course, errors, volumes, life, changed }
    }

    /// Adds how far off depths are by half of what is known of the lift, of the angles and of the points of a passage.
    fn add_coarser(
        &self,
        nodes: &[Vec<f64>; 2],
        places: &[Vec<f64>; 2],
        last: &Moment,
        errors: &mut Depths,
    ) {
        let cam = Self { profile: self.profile.coarser(), ..self.clone() };
        let fits = shape::fits(&cam.profile, cam.follower, super::angles(self.angles())).is_ok();
        let sweep = Sweep::new(&cam, [self.angles() / 2, POINTS / 2]);
        let rough = fits.then(|| {
            let surfaces = cam.surfaces(&sweep, nodes);
            march(&surfaces, last.passages, &[]).course.pop()
        });
        let widest = sweep.stations.iter().map(|one| one.half_width).fold(0.0, f64::max);
        for body in 0..2 {
            let of = |(node, depth): (usize, &f64)| {
                // Where half of the rows give no cam, all of them may be wrong as well.
                let rough = rough.as_ref().and_then(Option::as_ref);
                rough.map_or(*depth, |rough| (rough.depths[body][node] - depth).abs())
            };
            let off: Vec<f64> = last.depths[body].iter().enumerate().map(of).collect();
            // Both agree by chance in places: within the width of the contact the largest counts.
            let near = |place: f64| {
                let from = places[body].partition_point(|known| *known < place - widest);
                let to = places[body].partition_point(|known| *known <= place + widest);
                off[from..to].iter().copied().fold(0.0, f64::max)
            };
            for (place, error) in places[body].iter().zip(&mut errors[body]) {
                *error += near(*place);
            }
        }
    }

    /// What wear changes, station by station.
    fn changes(&self, sweep: &Sweep<'_>, shapes: &[Shape<'_>; 2]) -> Vec<Change> {
        let places = [0, 1].map(|body| sweep.places(body));
        let at = |(index, station): (usize, &Station)| {
            let radius = station.touch.curvature.recip();
            let radii = self.radii(station);
            let mut change = Change { wider: 0.0, softer: 0.0, displaced: 0.0 };
            for body in 0..2 {
                let [depth, slope, bend] =
                    shapes[body].around(places[body][index], station.half_width);
                let lift = depth / station.touch.cosine;
                let force = station.load * self.width * station.touch.cosine;
                let smaller = (depth / radii[body]).abs();
                // A smaller body slides less, as a smaller force would rub it.
                change.softer += self.loading.stiffness() * lift / force + smaller;
                change.wider += radius * (bend.abs() + (smaller / radii[body]).abs());
                change.displaced += radius * slope.abs();
            }
            change
        };
        sweep.stations.iter().enumerate().map(at).collect()
    }
}

/// What wear changes at a station.
struct Change {
    /// The relative curvature, relative to it: as much as the speeds of the contact over the bodies.
    wider: f64,
    /// The load, or the way that is slid under it, relative to it.
    softer: f64,
    /// Where (m) the bodies touch: where the worn ones slope as much as the new ones away from there.
    displaced: f64,
}

/// A worn surface.
struct Shape<'a> {
    places: &'a [f64],
    depths: &'a [f64],
    /// After how much (m) it repeats itself.
    around: f64,
}

impl Shape<'_> {
    /// The depth (m) at a place, straight between nodes; none beyond.
    fn at(&self, place: f64) -> f64 {
        let [first, last] = [self.places[0], self.places[self.places.len() - 1]];
        let place = if self.around.is_finite() {
            first + (place - first).rem_euclid(self.around)
        } else {
            place
        };
        if !(first..=last).contains(&place) {
            return 0.0;
        }
        let next = self.next(place);
        let share = (place - self.places[next - 1]) / (self.places[next] - self.places[next - 1]);
        self.depths[next - 1] + share * (self.depths[next] - self.depths[next - 1])
    }

    /// The node after a place.
    fn next(&self, place: f64) -> usize {
        self.places.partition_point(|known| *known <= place).clamp(1, self.places.len() - 1)
    }

    /// Depth (m), slope and curvature (1/m) of what is worn about a place, over the half-width (m) of the contact or between nodes.
    fn around(&self, place: f64, half_width: f64) -> [f64; 3] {
        let next = self.next(place);
        let over = half_width.max(self.places[next] - self.places[next - 1]);
        let [before, here, after] = [-over, 0.0, over].map(|off| self.at(place + off));
        [here, (after - before) / (2.0 * over), (after + before - 2.0 * here) / (over * over)]
    }

    /// By how much (m) what wear changes may change the depth at a node, in contact between some angles: to first order, as if all was
    /// changed from the beginning.
    fn changed(
        &self,
        node: usize,
        stations: &[Station],
        during: &[[f64; 2]],
        changes: &[Change],
    ) -> f64 {
        let depth = self.depths[node];
        let known = |angle: f64| stations.partition_point(|station| station.angle < angle);
        let mut most = 0.0;
        for [from, to] in during {
            let span: Range<usize> =
                known(*from).saturating_sub(1)..(known(*to) + 1).min(stations.len());
            for (station, change) in stations[span.clone()].iter().zip(&changes[span]) {
                let slope = self.around(self.places[node], station.half_width)[1];
                let by = depth * (change.wider + change.softer) + slope.abs() * change.displaced;
                most = f64::max(most, by);
            }
        }
        most
    }
}

/// Places of a follower to begin with: all of its path, and where the contact is slow.
fn seeds(sweep: &Sweep<'_>) -> Vec<f64> {
    let ends =
        |station: &Station| [-1.0, 1.0].map(|side| station.touch.place + side * station.half_width);
    let ends: Vec<[f64; 2]> = sweep.stations.iter().map(ends).collect();
    let first = ends.iter().map(|ends| ends[0]).fold(f64::INFINITY, f64::min);
    let last = ends.iter().map(|ends| ends[1]).fold(f64::NEG_INFINITY, f64::max);
    let even = (0..=PLACES).map(|at| first + (last - first) * at as f64 / PLACES as f64);
    let slow = sweep.slow().flat_map(|station| {
        [-1.0, -0.5, 0.0, 0.5, 1.0].map(|off| station.touch.place + off * station.half_width)
    });
    let inside = |place: &f64| (first..=last).contains(place);
    even.chain(slow.filter(inside)).collect()
}

/// The nodes between two, as many as it takes.
fn between(
    work: &dyn Fn(f64) -> f64,
    [from, to]: [f64; 2],
    [low, high]: [f64; 2],
    bounds: [f64; 2],
    nodes: &mut Vec<f64>,
) {
    let [straight, finest] = bounds;
    if to - from <= finest {
        return;
    }
    let middle = 0.5 * (from + to);
    let here = work(middle);
    if (here - 0.5 * (low + high)).abs() <= straight {
        return;
    }
    between(work, [from, middle], [low, here], bounds, nodes);
    nodes.push(middle);
    between(work, [middle, to], [here, high], bounds, nodes);
}

/// The integral of values over places, by the trapezoidal rule over every so many.
fn area(places: &[f64], values: &[f64], every: usize) -> f64 {
    let last = places.len() - 1;
    let ends = || (0..last).step_by(every).chain([last]);
    let parts = ends().zip(ends().skip(1));
    parts.map(|(from, to)| 0.5 * (values[from] + values[to]) * (places[to] - places[from])).sum()
}

#[cfg(test)]
mod tests;
