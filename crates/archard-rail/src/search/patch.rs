//! The stretches of overlap, and the place and the direction of the contact in each.
//!
//! The reference point of a patch is the mean of its points, each weighted by the square of the overlap there, and then
//! put onto the rail. The contact angle is the mean of the rail's inclination with the same weights. Along x the overlap
//! is a parabola, h - x^2/2R, whose square integrates to (16/15) sqrt(2R) h^2.5: the weight of a point of the locus with
//! overlap h. This is the definition of the open program CONTACT (Vollebregt), so that places, angles and
//! creepages can be held against its. A foundation of springs would store its energy about this point.
//!
//! Forces do not depend on it but by the angle of the plane: it is where they are referred to. The centre of pressure
//! of strips in virtual penetration (Kik and Piotrowski 1996) has the weight h, since a strip 2 sqrt(2Rh) long bears its
//! semi-ellipse of pressure in proportion to the square of its length.

use glam::{DMat3, DVec3};

use super::{Possible, Search};
use crate::bounds;
use crate::roots;
use crate::setup::Turned;
use archard::parameters::Invalid;

/// Points by which the means over a stretch are taken.
const POINTS: usize = 200;
/// The power of the overlap that weighs a point of the locus.
const POWER: f64 = 2.5;
/// Distance (m) from edge to edge up to which two stretches are one patch where nobody says otherwise: that up to which
/// CONTACT combines them.
pub const JOIN: f64 = 4e-3;

/// A patch of overlap.
#[derive(Debug, Clone, PartialEq)]
pub struct Patch {
    /// The reference point (m) in the track: on the rail, and ahead of the axle where the wheel yaws.
    pub reference: DVec3,
    /// The contact angle (rad): the turn about x from the track to the frame of the contact; negative towards the flange.
    pub angle: f64,
    /// The turn (rad) about the axis of a roller before that; 0 of a straight rail.
    pub turn: f64,
    /// z (m) of the profile of the rail at the reference point: as in the track, but for a turn.
    pub on_profile: f64,
    /// Where the overlap begins and ends (m) along x, the reference point at 0: from the parabola of the wheel's circle.
    pub along: [f64; 2],
    /// Where the overlap begins and ends (m) along s, the reference point at 0.
    pub across: [f64; 2],
    /// Width (m) of its widest stretch of overlap: less than that of the patch if it joins several.
    pub widest: f64,
    /// Whether a profile ends there, or stands upright, before the overlap ends.
    pub cut: [bool; 2],
    /// The largest vertical overlap (m).
    pub depth: f64,
    /// Where the overlap is largest (m along the curve of the wheel).
    pub deepest: f64,
    /// The height (m) of the wheelset at which the patch was found.
    pub height: f64,
}

impl Patch {
    /// The frame of the contact: its columns are x, s (to the field side along the surfaces) and n (into the rail), in
    /// the axes of the track.
    pub fn frame(&self) -> DMat3 {
        DMat3::from_rotation_y(self.turn) * DMat3::from_rotation_x(self.angle)
    }

    /// A point of the profile of the rail (m), of a roller turned with the patch, in its frame: s and n.
    pub(crate) fn in_the_plane(&self, [y, z]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.angle.sin_cos();
        let (y, z) = (y - self.reference.y, z - self.on_profile);
        [y * cos + z * sin, z * cos - y * sin]
    }

    /// A point of the track (m) in the frame of the contact: x, s and n from the reference point.
    pub fn local(&self, point: DVec3) -> DVec3 {
        self.frame().transpose() * (point - self.reference)
    }
}

/// Sums over points of overlap, each with its weight.
#[derive(Debug, Clone, Copy)]
struct Means {
    weight: f64,
    /// Weighted sum of the points (m).
    point: DVec3,
    /// Weighted sum of the angles (rad).
    angle: f64,
}

impl Means {
    const NONE: Self = Self { weight: 0.0, point: DVec3::ZERO, angle: 0.0 };

    fn centre(&self) -> DVec3 {
        self.point / self.weight
    }

    fn angle(&self) -> f64 {
        self.angle / self.weight
    }

    fn with(self, other: Self) -> Self {
        Self {
            weight: self.weight + other.weight,
            point: self.point + other.point,
            angle: self.angle + other.angle,
        }
    }
}

/// A stretch of the locus in which wheel and rail overlap.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    /// The points of the rail (y and z, m) at the ends, in the order of the wheel: the first lies on the field side.
    edges: [[f64; 2]; 2],
    /// Width (m), that of the widest if it joins several.
    widest: f64,
    /// Whether the locus ends there before the overlap does.
    cut: [bool; 2],
    /// Least and largest x (m) of the overlap.
    along: [f64; 2],
    means: Means,
    depth: f64,
    deepest: f64,
}

impl Stretch {
    /// Distance (m) to the next stretch of the wheel.
    fn distance(&self, next: &Self) -> f64 {
        crate::curve::distance(self.edges[1], next.edges[0])
    }

    fn with(self, next: Self) -> Self {
        let deeper = if next.depth > self.depth { next } else { self };
        Self {
            edges: [self.edges[0], next.edges[1]],
            widest: self.widest.max(next.widest),
            cut: [self.cut[0], next.cut[1]],
            along: [self.along[0].min(next.along[0]), self.along[1].max(next.along[1])],
            means: self.means.with(next.means),
            ..deeper
        }
    }
}

impl Search<'_> {
    /// The patches of overlap at that height (m) of the wheelset, in the order of the profile of the wheel: from the field
    /// side to the flange. Stretches no farther than `join` (m) from edge to edge are one patch.
    ///
    /// # Errors
    /// If the height is not finite, or the distance is negative or not finite.
    pub fn patches(&self, height: f64, join: f64) -> Result<Vec<Patch>, Invalid> {
        let height = bounds::finite("height", height)?;
        if bounds::finite("join", join)? < 0.0 {
            return Err(Invalid::new("join", format!("{join} has to be 0 or more")));
        }
        let mut joined: Vec<Stretch> = vec![];
        for stretch in self.stretches(height) {
            match joined.last_mut() {
                Some(last) if last.distance(&stretch) <= join => *last = last.with(stretch),
                _ => joined.push(stretch),
            }
        }
        Ok(joined.iter().map(|stretch| self.patch(stretch, height)).collect())
    }

    fn patch(&self, stretch: &Stretch, height: f64) -> Patch {
        let rail = self.setup.rail();
        let Stretch { means, depth, deepest, along, edges, widest, cut } = *stretch;
        let centre = means.centre();
        let on_rail = self.setup.below(centre.y).map(|along| rail.point(along)[1]);
        let on_profile = on_rail.unwrap_or(centre.z);
        let Turned { z, turn, .. } =
            self.setup.roller().at(on_profile, centre.x).unwrap_or_default();
        let reference = DVec3::new(centre.x, centre.y, z);
        let mut patch = Patch {
            reference,
            angle: means.angle(),
            turn,
            on_profile,
            along: along.map(|x| x - reference.x),
            across: [0.0; 2],
            widest,
            cut: [cut[1], cut[0]],
            depth,
            deepest,
            height,
        };
        patch.across = [edges[1], edges[0]].map(|edge| patch.in_the_plane(edge)[0]);
        patch
    }

    /// The patch as the wheel at that height (m) begins to touch it: a point, where its overlap was largest.
    pub(crate) fn first_of(&self, patch: &Patch, height: f64) -> Patch {
        let Some(at) = self.possible(patch.deepest) else { return patch.clone() };
        let rail = self.setup.rail().place(at.on_rail);
        let ([along_y, along_z], on_profile) = (rail.tangent, rail.point[1]);
        let Turned { turn, .. } =
            self.setup.roller().at(on_profile, at.point.x).unwrap_or_default();
        Patch {
            reference: at.point + DVec3::Z * at.gap,
            angle: along_z.atan2(along_y),
            turn,
            on_profile,
            along: [0.0; 2],
            across: [0.0; 2],
            widest: 0.0,
            depth: 0.0,
            height,
            ..patch.clone()
        }
    }

    /// The stretches of the locus whose gap is below the height.
    fn stretches(&self, height: f64) -> Vec<Stretch> {
        let mut found = vec![];
        let mut start = None;
        for at in 0..self.locus.len() {
            let inside = self.locus[at].gap < height;
            if inside && start.is_none() {
                start = Some(at);
            }
            let last = at + 1 == self.locus.len() || !self.follows(at);
            if let Some(first) = start.filter(|_| !inside || last) {
                start = None;
                let end = if inside { at } else { at - 1 };
                found.extend(self.stretch(first, end, height));
            }
        }
        found
    }

    /// Whether the sample after this one is the next place of the wheel and has rail below it.
    fn follows(&self, at: usize) -> bool {
        self.locus[at + 1].on_wheel - self.locus[at].on_wheel < 1.5 * super::STEP
    }

    /// The stretch that holds the samples from the first to the last.
    fn stretch(&self, first: usize, last: usize, height: f64) -> Option<Stretch> {
        let cross = |inside: usize, outside: usize| {
            let [a, b] = [inside, outside].map(|at| self.locus[at].on_wheel);
            roots::zero(a, b, |along| self.gap_at(along) - height)
        };
        let before = first.checked_sub(1).filter(|&before| self.follows(before));
        let after = (last + 1 < self.locus.len() && self.follows(last)).then_some(last + 1);
        let own = |at: usize| self.locus[at].on_wheel;
        let from = before.map_or_else(|| own(first), |before| cross(first, before));
        let to = after.map_or_else(|| own(last), |after| cross(last, after));
        self.weigh([from, to], [before.is_none(), after.is_none()], height)
    }

    /// The stretch between those places of the wheel (m), with its means.
    fn weigh(&self, ends: [f64; 2], cut: [bool; 2], height: f64) -> Option<Stretch> {
        let rail = self.setup.rail();
        let place = |share: f64| self.possible(ends[0] + share * (ends[1] - ends[0]));
        let edge = |share: f64| place(share).map(|at| rail.point(at.on_rail));
        let edges = [edge(0.0)?, edge(1.0)?];
        let mut stretch = Stretch {
            edges,
            widest: crate::curve::distance(edges[0], edges[1]),
            cut,
            along: [f64::INFINITY, f64::NEG_INFINITY],
            means: Means::NONE,
            depth: 0.0,
            deepest: ends[0],
        };
        let mut after = place(0.0);
        for at in 0..POINTS {
            let before = after;
            let middle = place((at as f64 + 0.5) / POINTS as f64);
            after = place((at as f64 + 1.0) / POINTS as f64);
            if let [Some(before), Some(middle), Some(after)] = [before, middle, after] {
                self.take(&mut stretch, &middle, (before.point.y - after.point.y).abs(), height);
            }
        }
        (stretch.means.weight > 0.0).then_some(stretch)
    }

    /// Adds a point of overlap that stands for a width (m) along y.
    fn take(&self, stretch: &mut Stretch, at: &Possible, width: f64, height: f64) {
        let depth = (height - at.gap).max(0.0);
        let [along_y, along_z] = self.setup.rail().place(at.on_rail).tangent;
        let weight = depth.powf(POWER) * width;
        stretch.means = stretch.means.with(Means {
            weight,
            point: (at.point + DVec3::Z * height) * weight,
            angle: along_z.atan2(along_y) * weight,
        });
        let radius =
            self.setup.wheelset().nominal_radius + self.setup.wheel().point(at.on_wheel)[1];
        let rail = self.setup.roller().curvature(self.setup.rail().point(at.on_rail)[1]);
        let half = (2.0 * depth / (radius.recip() + rail)).sqrt();
        stretch.along =
            [stretch.along[0].min(at.point.x - half), stretch.along[1].max(at.point.x + half)];
        if depth > stretch.depth {
            (stretch.depth, stretch.deepest) = (depth, at.on_wheel);
        }
    }
}
