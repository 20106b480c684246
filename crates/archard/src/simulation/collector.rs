//! How rubbing is collected into wear.
//!
//! Wear belongs to a surface, and surfaces move past each other. Where the surface of a body *stays*, each of its points
//! is under one pair and wears by what that pair goes through. Where it *passes*, its points go through all pairs on a
//! line along the motion, again and again, and [wear equally](super::passing).

use super::error::Error;
use super::passing::{Lines, OfLines};
use super::position::Position;
use super::turning::Turned;
use crate::friction::Circumstance;
use crate::motion::PassingSurfaces;
use crate::numerics::vector::{self, Values};
use crate::problem::{ContactProblem, ContactState, Surface, Wear};
use crate::wear::Rubbing;

/// Disagreement of the wear that a step foresaw with the wear it made, relative to the deepest: where laws alone are
/// linearised, and where friction is too, which in rolling changes with the wear.
const OF_LAWS: f64 = 1e-9;
const OF_LINES: f64 = 1e-6;
const OF_FRICTION: f64 = 0.02;

/// Wear coefficients (1/Pa) of the places on a body, one value an element; `None` where they are not needed.
pub(super) type Coefficients = Option<Vec<f64>>;

/// Collects the wear of both bodies.
#[derive(Debug)]
pub(super) struct Collector<'a> {
    problem: &'a ContactProblem,
    /// Which bodies stay.
    stays: [bool; 2],
    /// The lines of those that pass.
    lines: Option<Lines<'a>>,
    /// Of bodies whose laws take a whole cycle, where it is gone through in positions.
    pub coefficients: [Coefficients; 2],
}

/// What a step wears.
pub(super) struct Collected {
    /// Of surfaces that stay, one value a pair.
    pub pairs: Option<Wear>,
    /// Of surfaces that pass: of one passage, and the number of passages.
    lines: Option<(OfLines, f64)>,
}

/// The wear (m) of a step as straight lines in the pressures (Pa).
pub(super) struct Foreseen {
    /// Of surfaces that stay, one value a pair: the depth at zero pressure (m), and its slope (m/Pa).
    pairs: Option<[Vec<f64>; 2]>,
    /// Of surfaces that pass, the same, one value a line.
    lines: Option<[Vec<f64>; 2]>,
}

impl<'a> Collector<'a> {
    /// Of a motion in steps of wear.
    ///
    /// # Errors
    /// If surfaces do not pass along the frame.
    pub fn of(problem: &'a ContactProblem) -> Result<Self, Error> {
        let Some(PassingSurfaces { direction, bodies, passages, .. }) = problem.motion.passing()
        else {
            return Ok(Self { problem, stays: [true; 2], lines: None, coefficients: [None, None] });
        };
        let flow = problem.frame.flow(direction)?;
        let counts = problem.remembers();
        let lines = Some(Lines { problem, flow, bodies, passages, counts });
        let stays = bodies.map(|passes| !passes);
        Ok(Self { problem, stays, lines, coefficients: [None, None] })
    }

    /// The lines of surfaces that pass.
    pub fn lines(&self) -> Option<Lines<'a>> {
        self.lines
    }

    /// What a pair goes through in an advance (the motion's unit) under the contact as it is, in a position.
    pub fn rubbing<'s>(
        &'s self,
        state: &'s ContactState,
        advance: f64,
        position: &'s Position,
    ) -> impl Fn(usize) -> Rubbing + 's {
        let motion = &self.problem.motion;
        let distance = position.slips();
        let (direction, speed) = position.heading.unzip();
        let place = |pair| self.problem.frame.place(pair);
        let half = 0.5 * motion.slip(advance);
        let further = |pair| half * motion.lever(place(pair));
        let grip = self.problem.grip(state, further).unwrap_or_else(|last| last);
        let flash = self.problem.flash_for_laws(state);
        let warm = flash.and_then(|flash| Some(flash.temperatures()?.to_vec()));
        move |pair| {
            let own = position.headings.get(pair).copied();
            let heading = own.or(direction).unwrap_or_else(|| motion.heading(place(pair)));
            let rubbing = self
                .problem
                .rubbing(state.pressure[pair], distance.at(pair), heading)
                .gripping(grip.at(pair))
                .at_temperature(warm.as_ref().map_or(0.0, |warm| warm[pair]));
            speed.map_or(rubbing, |speed| rubbing.at_speed(speed))
        }
    }

    /// What an advance (the motion's unit) wears under the contact as it is, in a position.
    pub fn collect(&self, state: &ContactState, advance: f64, position: &Position) -> Collected {
        let pairs = self.any_stays().then(|| {
            let rubbing = self.rubbing(state, advance, position);
            let pairs = state.pressure.len();
            let even = matches!(position.slips(), Values::All(_))
                && !self.problem.goes_by_temperature()
                && !self.problem.remembers()
                && self.coefficients.iter().all(Option::is_none);
            if !even {
                let all = (0..pairs).collect::<Vec<_>>();
                return self.wear_at(&all, state, position, rubbing);
            }
            let told = pressed_and_one(&state.pressure);
            self.wear_at(&told, state, position, rubbing).spread(&told, pairs)
        });
        let lines = self.lines.map(|lines| {
            let times = advance * lines.passages;
            (OfLines::of(state, lines, times), times)
        });
        Collected { pairs, lines }
    }

    /// What pairs wear that are rubbed so, in a position.
    fn wear_at(
        &self,
        pairs: &[usize],
        state: &ContactState,
        position: &Position,
        rubbing: impl Fn(usize) -> Rubbing,
    ) -> Wear {
        let before = |body: usize, index: usize| {
            position.before((body, &state.surfaces[body]), pairs[index])
        };
        let by_law = [0, 1].map(|body| self.stays[body] && self.coefficients[body].is_none());
        let mut wear = self.problem.wear(pairs.iter().map(|&pair| rubbing(pair)), by_law, before);
        for (body, coefficients) in self.coefficients.iter().enumerate() {
            let Some(coefficients) = coefficients else { continue };
            for (index, &pair) in pairs.iter().enumerate() {
                let Rubbing { pressure, slip, .. } = rubbing(pair);
                let of = (body, state.surfaces[body].grid);
                let mut mean = 0.0;
                position.swept(of, pair, |element, share, _| mean += share * coefficients[element]);
                let slope = mean * slip;
                wear.depths[body][index] += slope * pressure;
                wear.slopes[index] += slope;
            }
        }
        wear
    }

    /// Whether any body stays that wears, or whose distance counts.
    fn any_stays(&self) -> bool {
        let counts = self.problem.grips_by(Circumstance::Distance);
        let wears = |body: usize| counts || self.problem.bodies[body].wear.is_some();
        (0..2).any(|body| self.stays[body] && wears(body))
    }

    /// Whether a step wears as it was foreseen.
    pub fn agrees(&self, foreseen: &Foreseen, state: &ContactState, made: &Collected) -> bool {
        let Collected { pairs, lines } = made;
        let pairs = foreseen.pairs.as_ref().zip(pairs.as_ref()).is_none_or(|(line, wear)| {
            let of = |pair: usize| (state.pressure[pair], wear.depth(pair));
            lies_on(line, (0..state.pressure.len()).map(of), OF_LAWS)
        });
        let lines = foreseen.lines.as_ref().zip(lines.as_ref());
        pairs
            && lines.is_none_or(|(line, (made, times))| {
                let of = |line: usize| (made.pressures[line], times * made.total(line));
                let rolls = self.problem.motion.lever_arm().is_none();
                let allowed = if rolls { OF_FRICTION } else { OF_LINES };
                lies_on(line, (0..made.pressures.len()).map(of), allowed)
            })
    }

    /// Wears both bodies in a position.
    pub fn wear(&self, state: &mut ContactState, made: &Collected, position: &Position) {
        for body in (0..2).filter(|&body| self.stays[body]) {
            let Some(wear) = &made.pairs else { break };
            let surface = &mut state.surfaces[body];
            let coefficients = self.coefficients[body].as_deref();
            if let Some(turned) = &position.turned[body] {
                wear_turned(surface, wear, (body, coefficients), (turned, position));
                continue;
            }
            let Some(own) = coefficients else {
                let [x, y] = position.offsets[body];
                for ([along, across], share) in &position.ways[body] {
                    let offset = [x + along, y + across];
                    surface.wear((&wear.depths[body], &wear.slip), offset, *share);
                }
                continue;
            };
            let of = (body, surface.grid);
            for (pair, (depth, slip)) in wear.depths[body].iter().zip(&wear.slip).enumerate() {
                if *depth == 0.0 && *slip == 0.0 {
                    continue;
                }
                let mut mean = 0.0;
                position.swept(of, pair, |element, share, _| mean += share * own[element]);
                position.swept(of, pair, |element, share, _| {
                    // What each place of the way has of the mean over it.
                    let part = if mean > 0.0 { own[element] / mean } else { 1.0 };
                    surface.wear_element(element, [share * part * depth, share * slip]);
                });
            }
        }
        let Some((lines, (made, times))) = self.lines.zip(made.lines.as_ref()) else { return };
        let passes = state.surfaces.iter_mut().enumerate().filter(|(body, _)| !self.stays[*body]);
        for (body, surface) in passes {
            let rows = surface.grid.passes().is_some();
            for (index, line) in lines.flow.lines().iter().enumerate() {
                // All pairs of a row have one element.
                let met = if rows { 1 } else { line.passages.len() };
                for one in &line.passages[..met.min(line.passages.len())] {
                    let element = surface.grid.at(one.pair, [0; 2]);
                    surface.depth[element] += times * one.share * made.depths[index][body];
                    if let Some(slid) = surface.slid.get_mut(element) {
                        *slid += times * one.share * made.slips[index];
                    }
                }
            }
        }
    }
}

impl Collected {
    /// The same as straight lines in the pressures (Pa), about those it was collected under.
    pub fn foresee(&self, pressure: &[f64]) -> Foreseen {
        let pairs = self.pairs.as_ref().map(|wear| {
            let [one, two] = &wear.depths;
            let constant =
                vector::map([one, two, &wear.slopes, pressure], |[one, two, slope, pressure]| {
                    (one + two) - slope * pressure
                });
            [constant, wear.slopes.clone()]
        });
        let lines = self.lines.as_ref().map(|(made, times)| {
            let slope = made.slopes.iter().map(|slope| times * slope).collect();
            let constant =
                |line: usize| times * (made.total(line) - made.slopes[line] * made.pressures[line]);
            [(0..made.pressures.len()).map(constant).collect(), slope]
        });
        Foreseen { pairs, lines }
    }

    /// Deepest wear (m) of both bodies together.
    pub fn deepest(&self) -> f64 {
        let pairs = self.pairs.as_ref().map_or(0.0, |wear| {
            (0..wear.slopes.len()).map(|pair| wear.depth(pair)).fold(0.0, f64::max)
        });
        pairs + self.lines.as_ref().map_or(0.0, |(made, times)| times * made.deepest())
    }
}

impl Foreseen {
    /// The gap (m) of surfaces at zero pressure, opened by what wears then.
    pub fn gap_by_friction(&self, gap: &[f64], lines: Option<Lines<'_>>) -> Vec<f64> {
        let mut gap_by_friction = match &self.pairs {
            Some([constant, _]) => vector::map([gap, constant], |[gap, constant]| gap + constant),
            None => gap.to_vec(),
        };
        if let (Some([constant, _]), Some(Lines { flow, .. })) = (&self.lines, lines) {
            for (line, depth) in flow.lines().iter().zip(constant) {
                line.passages.iter().for_each(|one| gap_by_friction[one.pair] += one.share * depth);
            }
        }
        gap_by_friction
    }

    /// How pairs give way by wear to their own pressure (m/Pa).
    pub fn pair_slopes(&self, pairs: usize) -> Vec<f64> {
        self.pairs.as_ref().map_or_else(|| vec![0.0; pairs], |[_, slope]| slope.clone())
    }

    /// How lines do to the pressure (Pa) on one of their pairs.
    pub fn line_slopes(&self) -> Option<&[f64]> {
        self.lines.as_ref().map(|[_, slope]| &slope[..])
    }
}

/// Wears a body that turns under the frame, by coefficients of its places or by what pairs wear, to the same volume.
fn wear_turned(
    surface: &mut Surface,
    wear: &Wear,
    (body, coefficients): (usize, Option<&[f64]>),
    (turned, position): (&Turned, &Position),
) {
    let (grid, depths) = (surface.grid, &wear.depths[body]);
    let over_mean = coefficients.map(|own| -> Vec<f64> {
        let each = depths.iter().enumerate().map(|(pair, depth)| {
            let mut mean = 0.0;
            position.swept((body, grid), pair, |element, share, _| mean += share * own[element]);
            if *depth > 0.0 { depth / mean } else { 0.0 }
        });
        each.collect()
    });
    let mut gathered = turned.gathered(grid, [over_mean.as_ref().unwrap_or(depths), &wear.slip]);
    if let Some(own) = coefficients {
        gathered.iter_mut().zip(own).for_each(|([depth, _], own)| *depth *= own);
    }
    let [all, laid] =
        [depths.iter().sum::<f64>(), gathered.iter().map(|[depth, _]| depth).sum::<f64>()];
    let share = if laid > 0.0 { all / laid } else { 0.0 };
    for (element, [depth, slip]) in gathered.into_iter().enumerate() {
        surface.wear_element(element, [share * depth, slip]);
    }
}

/// The pairs under pressure and one that is not: all others go through the same.
fn pressed_and_one(pressure: &[f64]) -> Vec<usize> {
    let presses = |&pair: &usize| pressure[pair] > 0.0;
    let open = (0..pressure.len()).find(|pair| !presses(pair));
    (0..pressure.len()).filter(presses).chain(open).collect()
}

/// Whether depths (m) at pressures (Pa) lie on straight lines, relative to the deepest.
fn lies_on(
    [constant, slope]: &[Vec<f64>; 2],
    found: impl Iterator<Item = (f64, f64)>,
    allowed: f64,
) -> bool {
    let (mut error, mut deepest) = (0.0f64, 0.0f64);
    for ((constant, slope), (pressure, depth)) in constant.iter().zip(slope).zip(found) {
        error = error.max((constant + slope * pressure - depth).abs());
        deepest = deepest.max(depth);
    }
    error <= allowed * deepest
}
