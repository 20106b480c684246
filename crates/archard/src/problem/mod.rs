//! A contact problem: the choices composed, and what is known at the end of a step.

mod alone;
mod edge;
mod even;
mod gap;
mod grip;
mod heat;
mod rough;
mod strips;
mod surface;

pub(crate) use edge::GROWS;
#[doc(hidden)]
pub use gap::Gap;
#[doc(hidden)]
pub use heat::{Flash, Heating, NoTemperature};
#[doc(hidden)]
pub use rough::{Spots, UnwornRecess};
#[doc(hidden)]
pub use surface::Grid;
pub use surface::Surface;

use std::borrow::Cow;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::body::Body;
use crate::compliance::Compliance;
use crate::frame::{ContactFrame, Direction, VectorField};
use crate::friction::{Friction, Grip, Limits};
use crate::motion::{Drives, Motion};
use crate::numerics::WRITTEN;
use crate::numerics::vector;
use crate::wear::{Columns, Input, Per, Rubbing, WearLaw};

/// The slip (m) with which laws of wear are tried, and the rounding of what they give.
const PROBE: f64 = 1e-6;
/// The share of a pressure under which they are tried besides.
const HALF: f64 = 0.5;

/// Two bodies, where they may touch, how they deform there and how they move.
#[derive(Debug)]
pub struct ContactProblem {
    /// The bodies; body 1 first.
    pub bodies: [Body; 2],
    /// The pairs that may touch.
    pub frame: ContactFrame,
    /// How both bodies deform, seen from the frame.
    pub compliance: Arc<dyn Compliance>,
    /// How much tangential traction the pairs bear; `None` without friction.
    pub friction: Option<Arc<dyn Friction>>,
    /// How the pairs rub.
    pub motion: Motion,
    /// The bodies at the pairs before they wear, once anyone asks.
    pub unworn: UnwornRecess,
}

impl ContactProblem {
    /// Whether any body wears.
    pub fn wears(&self) -> bool {
        self.bodies.iter().any(|body| body.wear.is_some())
    }

    /// The pressure (Pa) under which the softer body yields; infinite where none does.
    pub fn hardness(&self) -> f64 {
        Body::softest(&self.bodies)
    }

    /// Whether a wear law asks for something.
    pub fn asks(&self, input: Input) -> bool {
        let asks =
            |body: &Body| body.wear.as_ref().is_some_and(|law| law.inputs().contains(&input));
        self.bodies.iter().any(asks)
    }

    /// Whether a wear law depends on what was before.
    pub fn ages(&self) -> bool {
        self.asks(Input::Distance) || self.asks(Input::Depth)
    }

    /// Whether wear, or the friction that wears, depends on what was before.
    pub fn remembers(&self) -> bool {
        self.ages() || self.counts_distance()
    }

    /// Whether each depth of wear is proportional to the pressure at one (Pa) and half of it, and the factor stays as it is
    /// while bodies slide. It may go by the direction of slip, so that there need be no coefficient k.
    pub fn is_proportional(&self, pressure: f64) -> bool {
        let rubbing = |pressure: f64| self.rubbing(pressure, PROBE, [1.0, 0.0]);
        let mut laws = self.bodies.iter().filter_map(|body| body.wear.as_deref());
        let straight = |law: &dyn WearLaw| {
            let [half, whole] = under(law, rubbing, pressure, HALF);
            (whole - 2.0 * half).abs() <= WRITTEN * whole
        };
        !self.remembers() && !self.goes_by_temperature() && laws.all(straight)
    }

    /// What a pair goes through that slides a distance (m) in some direction under a pressure (Pa), friction at its
    /// limit, with a [grip](crate::friction::Grip) of one.
    pub fn rubbing(&self, pressure: f64, slip: f64, direction: [f64; 2]) -> Rubbing {
        rubbing(self.friction.as_deref(), pressure, slip, direction)
            .at_speed(self.motion.sliding_speed().unwrap_or_default())
    }

    /// Which of some bodies wear by laws that take that at once.
    pub fn wearing(&self, bodies: [bool; 2], per: Per) -> [bool; 2] {
        let takes = |body: &Body| body.wear.as_ref().is_some_and(|law| law.per() == per);
        [0, 1].map(|body| bodies[body] && takes(&self.bodies[body]))
    }

    /// Tractions on body 1 (Pa) in the bases of the pairs; where all pairs slide, friction at its limit as body 2 slides
    /// forward over body 1.
    pub fn tractions(&self, state: &ContactState) -> VectorField {
        let mut tractions = state.tractions();
        let slides = state.tangential.is_none() && self.motion.slip(1.0) != 0.0;
        if let Some(friction) = self.friction.as_ref().filter(|_| slides) {
            let map = friction.map();
            for (pair, pressure) in state.pressure.iter().enumerate() {
                let heading = self.motion.heading(self.frame.place(pair));
                let limit = friction.limit(*pressure);
                let [x, y] = map.against(heading);
                (tractions.t1[pair], tractions.t2[pair]) = (limit * x, limit * y);
            }
        }
        tractions
    }

    /// What wears off the bodies that are meant, at many points; `before` says of a body and a point how far (m) it has
    /// slid and how deep (m) it has worn so far.
    pub fn wear(
        &self,
        points: impl Iterator<Item = Rubbing> + Clone,
        meant: [bool; 2],
        before: impl Fn(usize, usize) -> [f64; 2],
    ) -> Wear {
        let slips = points.clone().map(|one| if one.pressure > 0.0 { one.slip } else { 0.0 });
        let slip = slips.collect::<Vec<_>>();
        let none = || vec![0.0; slip.len()];
        let mut wear = Wear { depths: [none(), none()], slopes: none(), slip: vec![] };
        for (body, depths) in wear.depths.iter_mut().enumerate() {
            let Some(law) = self.bodies[body].wear.as_ref().filter(|_| meant[body]) else {
                continue;
            };
            let asked = law.inputs();
            let aged = asked.contains(&Input::Distance) || asked.contains(&Input::Depth);
            let columns = if aged {
                let after = |(point, one): (usize, Rubbing)| {
                    let [distance, depth] = before(body, point);
                    one.after(distance, depth)
                };
                Columns::of(points.clone().enumerate().map(after), asked)
            } else {
                Columns::of(points.clone(), asked)
            };
            let mut slopes = none();
            law.depths(&columns, depths, &mut slopes);
            vector::update(&mut wear.slopes, [&slopes], |sum, [slope]| sum + slope);
        }
        wear.slip = slip;
        wear
    }
}

/// What a law wears (m) under a share of a pressure (Pa) and under all of it.
fn under(law: &dyn WearLaw, at: impl Fn(f64) -> Rubbing, pressure: f64, share: f64) -> [f64; 2] {
    [share, 1.0].map(|share| law.depth(at(share * pressure)))
}

/// What a pair goes through that slides a distance (m) in some direction under a pressure (Pa), friction at its limit.
pub fn rubbing(
    friction: Option<&dyn Friction>,
    pressure: f64,
    slip: f64,
    direction: [f64; 2],
) -> Rubbing {
    let rubbing = Rubbing::new(pressure, slip);
    let length = direction[0].hypot(direction[1]);
    let slips = direction.map(|part| if length > 0.0 { slip * part / length } else { 0.0 });
    let Some(friction) = friction else { return rubbing.with_vectors(slips, [0.0; 2]) };
    let map = friction.map();
    let (limit, resistance) = (friction.limit(pressure), map.resistance(direction));
    let traction = map.against(direction).map(|part| limit * part);
    rubbing
        .with_friction(limit * resistance * slip, friction.slope(pressure) * resistance)
        .with_vectors(slips, traction)
}

/// What wears off two bodies, one value a point.
#[derive(Debug, Clone, PartialEq)]
pub struct Wear {
    /// Depth off body 1 and body 2 (m).
    pub depths: [Vec<f64>; 2],
    /// How the depth of both together grows with the pressure (m/Pa).
    pub slopes: Vec<f64>,
    /// Distance slid under pressure (m).
    pub slip: Vec<f64>,
}

impl Wear {
    /// The wear of all pairs from that of some of them; the others wear as the last of those.
    pub(crate) fn spread(&self, told: &[usize], pairs: usize) -> Self {
        let spread = |values: &Vec<f64>| {
            let mut all = vec![values.last().copied().unwrap_or_default(); pairs];
            told.iter().zip(values).for_each(|(&pair, value)| all[pair] = *value);
            all
        };
        let depths = self.depths.each_ref().map(spread);
        Self { depths, slopes: spread(&self.slopes), slip: spread(&self.slip) }
    }

    /// Depth (m) off both bodies at a point.
    pub fn depth(&self, point: usize) -> f64 {
        self.depths[0][point] + self.depths[1][point]
    }
}

/// What is known of the contact at the end of a step.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ContactState {
    /// How far the motion has gone (its own unit).
    pub progress: f64,
    /// Approach of the bodies from first touch (m).
    pub approach: f64,
    /// Normal force (N).
    pub load: f64,
    /// Pressure (Pa), one value a pair.
    pub pressure: Vec<f64>,
    /// Normal gap: see [`ContactState::gap_of`].
    pub gap: Gap,
    /// The worn surfaces of body 1 and body 2.
    pub surfaces: [Surface; 2],
    /// Friction, where the motion separates slip from stick.
    pub tangential: Option<Tangential>,
}

/// What is known of friction at the end of a step.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Tangential {
    /// Tractions on body 1 (Pa), along t1 and t2, one value a pair.
    pub traction: [Vec<f64>; 2],
    /// Slip of body 2 over body 1 (m), along t1 and t2, one value a pair; in rolling, on the
    /// passage to each pair, and outside the contact what the surfaces slide without touching.
    pub slip: [Vec<f64>; 2],
    /// Creepage along the direction of rolling and across it, given or found; zero where nothing rolls.
    pub creepage: [f64; 2],
    /// Displacement (m) of body 2 over body 1 along t1 and t2, given or found; zero in rolling.
    pub shift: [f64; 2],
    /// What the limits of friction were scaled by.
    pub grip: Grip,
}

impl Tangential {
    /// Force of the tangential tractions on body 1 along x and y (N).
    pub fn force(&self, frame: &ContactFrame) -> [f64; 2] {
        if frame.is_uniform() {
            return self.traction.each_ref().map(|traction| frame.integrate(traction));
        }
        let [t1, t2] = self.traction.clone();
        let n = vec![0.0; t1.len()];
        let [x, y, _] = frame.force(&VectorField { t1, t2, n });
        [x, y]
    }

    /// Moment on body 1 about n through x = y = 0 (N m).
    pub fn moment(&self, frame: &ContactFrame) -> f64 {
        let [t1, t2] = &self.traction;
        let moment = |pair: usize| {
            let [x, y] = frame.place(pair);
            x * t2[pair] - y * t1[pair]
        };
        if frame.mirrored() != [false; 2] {
            // The mirror image turns the other way.
            return 0.0;
        }
        let measure = frame.measure();
        let weighed = (0..frame.len()).map(|pair| measure.weight.at(pair) * moment(pair));
        weighed.sum::<f64>() * measure.area
    }

    /// The integral of the traction on body 1 along the direction of the motion times the square of the place across (N m^2).
    fn bowed(&self, frame: &ContactFrame, direction: Direction) -> f64 {
        let (forward, lateral) = (direction.forward(), direction.lateral());
        let along = |[x, y]: [f64; 2], unit: [f64; 2]| x * unit[0] + y * unit[1];
        let [t1, t2] = &self.traction;
        let measure = frame.measure();
        let of = |pair: usize| {
            let traction = along([t1[pair], t2[pair]], forward);
            measure.weight.at(pair) * traction * along(frame.place(pair), lateral).powi(2)
        };
        (0..frame.len()).map(of).sum::<f64>() * measure.area
    }

    /// Power of the creepages, the spin and the bow over the speed of rolling (N): what friction dissipates.
    pub fn creep_power(&self, problem: &ContactProblem, drives: &Drives) -> f64 {
        let frame = &problem.frame;
        let force = self.force(frame);
        let along = |unit: [f64; 2]| force[0] * unit[0] + force[1] * unit[1];
        let direction = problem.motion.direction;
        self.creepage[0] * along(direction.forward())
            + self.creepage[1] * along(direction.lateral())
            + drives.spin * self.moment(frame)
            + drives.bow * self.bowed(frame, direction)
    }

    /// Whether a pair is in contact and sticks: it bears less than the limit.
    pub fn sticks(&self, problem: &ContactProblem, pressure: &[f64], pair: usize) -> bool {
        let Some(friction) = &problem.friction else { return false };
        let [t1, t2] = &self.traction;
        let limit = Limits::new(&**friction, &self.grip).at(pair, pressure[pair]);
        friction.map().sticks([t1[pair], t2[pair]], limit)
    }

    /// Area (m^2) of the pairs in contact that stick.
    pub fn stick_area(&self, problem: &ContactProblem, pressure: &[f64]) -> f64 {
        let sticks = |&pair: &usize| self.sticks(problem, pressure, pair);
        problem.frame.area_where(|pair| sticks(&pair))
    }
}

impl ContactState {
    /// Bodies apart and unworn, whose surfaces stay.
    pub fn untouched(frame: &ContactFrame) -> Self {
        let surface = || Surface::unworn(Grid::of_pairs(frame.elements()), false, false);
        Self {
            progress: 0.0,
            approach: 0.0,
            load: 0.0,
            pressure: vec![0.0; frame.len()],
            gap: frame.gap().to_vec().into(),
            surfaces: [surface(), surface()],
            tangential: None,
        }
    }

    /// Depth worn off a body (m), one value a pair; of one that swings, in the middle position.
    pub fn worn(&self, body: usize) -> Cow<'_, [f64]> {
        self.surfaces[body].worn()
    }

    /// Depth (m) by which a body lies below its unworn shape, worn off and pressed in, one value a pair.
    pub fn lowered(&self, body: usize) -> Cow<'_, [f64]> {
        self.surfaces[body].lowered()
    }

    /// Normal gap (m) in a problem, one value a pair; zero in contact. Far from it it is computed from the pressures.
    pub fn gap_of(&self, problem: &ContactProblem) -> Cow<'_, [f64]> {
        self.gap.under(&self.pressure, &*problem.compliance)
    }

    /// Tractions on body 1 (Pa) in the bases of the pairs; those of friction as far as they are known.
    pub fn tractions(&self) -> VectorField {
        let n: Vec<f64> = self.pressure.iter().map(|pressure| -pressure).collect();
        let [t1, t2] = match &self.tangential {
            Some(tangential) => tangential.traction.clone(),
            None => [vec![0.0; n.len()], vec![0.0; n.len()]],
        };
        VectorField { t1, t2, n }
    }

    /// Depth worn off both bodies (m) at a pair.
    pub fn worn_at(&self, pair: usize) -> f64 {
        let [one, two] = self.surfaces.each_ref().map(|one| one.depth[one.grid.at(pair, [0; 2])]);
        one + two
    }

    /// Total wear depth (m), one value a pair.
    pub fn total_worn(&self) -> Vec<f64> {
        let [one, two] = [self.worn(0), self.worn(1)];
        one.iter().zip(&*two).map(|(a, b)| a + b).collect()
    }

    /// Number of pairs under pressure.
    pub fn pairs_in_contact(&self) -> usize {
        self.pressure.iter().filter(|&&pressure| pressure > 0.0).count()
    }
}
