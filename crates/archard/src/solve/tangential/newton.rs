//! Semismooth Newton steps on the projection, solved by Krylov iterations, from coarse elements to fine.
//!
//! P. Alart and A. Curnier, *Comput. Methods Appl. Mech. Engrg.* 92 (1991) 353, for friction by projection.
//! The augmented traction q = t + r s says which pairs stick (|q| within the limit) and which slip. With
//! that fixed, a step makes the slip of the sticking pairs zero and puts the slipping ones on their
//! limit, where what remains unknown is the direction: across q, the change dt of the traction obeys
//!
//! ```text
//! B dt + (|q| - limit) / (r limit) dt = s |q| / limit
//! ```
//!
//! The linear systems are preconditioned by [`SlipMap::precondition`](crate::compliance::SlipMap::precondition). A step that does not lower the residual is shortened; where that does not help, steps
//! of projection and contraction come between. Without a solution to start from, the problem is solved
//! on elements of twice the size first, so that few steps remain on the finest whatever their number.

use super::blocks::Blocks;
use super::contraction::Contraction;
use super::pairs::{Pairs, State};
use super::{FrictionSolver, Outcome, PrescribedForce, Start, Step, TOLERANCE};
use crate::compliance::{Coarser, StickSlip};
use crate::frame::Measure;
use crate::numerics::gmres::{self, Solution, System};
use crate::numerics::vector::{in_pool, sum, sweep, update};
use crate::parameters::Choice;
use crate::solve::{PARAMETERS, Settings, Status, monolithic};

pub(super) const CHOICE: Choice<Box<dyn FrictionSolver>> = Choice {
    name: "newton",
    meaning: "semismooth Newton with Krylov iterations, from coarse elements to fine",
    parameters: PARAMETERS,
    build: |values| Ok(Box::new(Newton::new(Settings::read(values, Newton::default().settings)?))),
};

/// Residual of the linear system, relative to its right-hand side, while the sticking pairs change by more
/// than `SETTLED` of them, and by more than `FINAL`; after that what the aim needs.
const LOOSE: f64 = 0.5;
const TIGHT: f64 = 0.05;
const SETTLED: f64 = 0.03;
const FINAL: f64 = 0.005;
/// Krylov iterations of one step.
const KRYLOV: usize = 120;
/// Shortest step tried before others come between.
const SHORTEST: f64 = 0.1;
/// Steps of projection and contraction that come between.
const BETWEEN: usize = 5;
/// Fewest pairs in contact and elements along an axis that are worth coarser ones.
const COARSEST: (usize, usize) = (150, 12);
/// Residual that a coarser solution needs to start a finer one.
const COARSE_TOLERANCE: f64 = 1e-3;

/// Semismooth Newton with Krylov iterations, from coarse elements to fine, by default to 1e-6 in 200 iterations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Newton {
    settings: Settings,
}

impl Newton {
    /// The solver with these settings.
    pub fn new(settings: Settings) -> Self {
        Self { settings }
    }
}

impl Default for Newton {
    fn default() -> Self {
        Self::new(Settings { tolerance: TOLERANCE, max_iterations: 200 })
    }
}

impl FrictionSolver for Newton {
    fn solve(&self, step: &Step<'_>, start: Option<Start<'_>>) -> Outcome {
        in_pool(|| match start {
            Some(start) => self.iterate(step, Some(start)),
            None => self.descend(step),
        })
    }

    fn solve_jointly(
        &self,
        step: &monolithic::Step<'_>,
        start: &monolithic::Solution,
        foreseen: Option<&monolithic::Solution>,
    ) -> Option<monolithic::Outcome> {
        Some(in_pool(|| monolithic::solve(step, start, foreseen, self.settings)))
    }

    fn settings(&self) -> Settings {
        self.settings
    }
}

impl Newton {
    /// Solves on coarser elements first, if there are enough.
    fn descend(&self, step: &Step<'_>) -> Outcome {
        let pairs = step.limit.iter().filter(|&&limit| limit > 0.0).count();
        let fewest = step.elements[0].min(step.elements[1]);
        if pairs < COARSEST.0 || fewest < COARSEST.1 {
            return self.iterate(step, None);
        }
        let Some(Coarser { map, elements, slip: factor }) = step.map.coarser() else {
            return self.iterate(step, None);
        };
        let blocks = Blocks { fine: step.elements, coarse: elements };
        let [limit, one, two] = [step.limit, step.rigid[0], step.rigid[1]].map(|f| blocks.mean(f));
        let [one, two] =
            [one, two].map(|slip| slip.iter().map(|slip| factor * slip).collect::<Vec<_>>());
        let coarse = Step {
            map: &*map,
            elements,
            measure: Measure::even(4.0 * step.measure.area),
            limit: &limit,
            rigid: [&one, &two],
            prescribed: step.prescribed,
        };
        let settings =
            Settings { tolerance: self.settings.tolerance.max(COARSE_TOLERANCE), ..self.settings };
        let first = Newton { settings }.descend(&coarse);
        let [one, two] = first.traction.each_ref().map(|traction| blocks.interpolate(traction));
        let rigid_slip: Vec<f64> =
            first.rigid_slip.iter().map(|rigid_slip| rigid_slip / factor).collect();
        let limit = blocks.interpolate(&limit);
        let start = Start { traction: [&one, &two], limit: &limit, rigid_slip: &rigid_slip };
        let outcome = self.iterate(step, Some(start));
        let applications = outcome.applications + first.applications.div_ceil(4);
        Outcome { applications, ..outcome }
    }

    fn iterate(&self, step: &Step<'_>, start: Option<Start<'_>>) -> Outcome {
        let mut pairs = Pairs::of(step);
        let mut state = pairs.start(start);
        let mut residual = pairs.residual(&state);
        let mut last_stick = vec![];
        let mut count = 0;
        while residual > self.settings.tolerance && count < self.settings.max_iterations {
            count += 1;
            let mut linear = Linear::about(&state, &mut pairs);
            let tolerance = linear.tolerance(&last_stick, residual, self.settings.tolerance);
            last_stick.clone_from(&linear.rub.stick);
            let change = linear.solve(tolerance);
            match shorten(&state, &change, residual, &pairs) {
                Some(next) => (state, residual) = next,
                None => {
                    let mut between = Contraction::new(&pairs, state);
                    (0..BETWEEN).for_each(|_| between.advance(&mut pairs));
                    state = between.state;
                    residual = pairs.residual(&state);
                }
            }
        }
        let converged = residual <= self.settings.tolerance;
        let status = if converged { Status::Converged } else { Status::OutOfIterations };
        pairs.finish(state, status, count, residual)
    }
}

/// The state after as much of a change as lowers the residual; `None` where hardly any does.
fn shorten(
    state: &State,
    change: &State,
    residual: f64,
    pairs: &Pairs<'_>,
) -> Option<(State, f64)> {
    let mut length = 1.0;
    while length >= SHORTEST {
        let along = |from: &[f64], by: &[f64]| -> Vec<f64> {
            from.iter().zip(by).map(|(from, by)| from + length * by).collect()
        };
        let next = State {
            traction: along(&state.traction, &change.traction),
            rigid_slip: along(&state.rigid_slip, &change.rigid_slip),
            slip: along(&state.slip, &change.slip),
        };
        let lower = pairs.residual(&next);
        if lower < (1.0 - 1e-4 * length) * residual {
            return Some((next, lower));
        }
        length *= 0.5;
    }
    None
}

/// The projection linearised about a state. Vectors hold the changes of the tractions (Pa), then those of
/// the slips that are found, in the unit that makes them count like tractions.
struct Linear<'p, 'a> {
    pairs: &'p mut Pairs<'a>,
    /// What each pair of the frame does.
    rub: StickSlip,
    /// Ones where pairs in contact stick, zeros elsewhere.
    sticking: Vec<f64>,
    /// Components of the unit vector across the augmented traction of slipping pairs; zeros elsewhere.
    across: [Vec<f64>; 2],
    /// The diagonal beside B of slipping pairs (m/Pa), zeros elsewhere.
    diagonal: Vec<f64>,
    /// Change that puts slipping pairs on their limit (Pa).
    fixed: Vec<f64>,
    /// Slip that what is unknown has to take away, and forces that are missing, in its unit (m).
    right: Vec<f64>,
    /// Slip (m) of a rigid slip of one unit.
    unit: f64,
    border: Border,
    /// Slip (m) that the fixed change takes away, and that each change tried does.
    fixed_slip: Vec<f64>,
    tried: Vec<Vec<f64>>,
}

/// What a unit of each slip that is found does by the preconditioner: the tractions that take it away
/// again, and the inverse of the forces they amount to.
#[derive(Default)]
struct Border {
    responses: Vec<Vec<f64>>,
    inverse: [[f64; 2]; 2],
}

impl<'p, 'a> Linear<'p, 'a> {
    fn about(state: &State, pairs: &'p mut Pairs<'a>) -> Self {
        let count = pairs.len();
        let zeros = || vec![0.0; count];
        let frame = || vec![0.0; pairs.step.limit.len()];
        let mut rub = StickSlip { stick: frame(), slip: frame(), diagonal: frame() };
        let (mut sticking, mut across, mut diagonal) = (zeros(), [zeros(), zeros()], zeros());
        let (mut fixed, mut right) = (vec![0.0; 2 * count], vec![0.0; 2 * count]);
        for pair in 0..count {
            let at = |vector: &[f64]| [vector[pair], vector[count + pair]];
            let (t, s, limit) = (at(&state.traction), at(&state.slip), pairs.limit[pair]);
            let q = [0, 1].map(|axis| t[axis] + s[axis] / pairs.own);
            let length = q[0].hypot(q[1]);
            if length <= limit {
                rub.stick[pairs.places[pair]] = 1.0;
                sticking[pair] = 1.0;
                [right[pair], right[count + pair]] = s;
                continue;
            }
            let unit = q.map(|value| value / length);
            let normal = [-unit[1], unit[0]];
            diagonal[pair] = pairs.own * (length - limit) / limit;
            rub.slip[pairs.places[pair]] = 1.0;
            rub.diagonal[pairs.places[pair]] = diagonal[pair];
            let short = limit - (t[0] * unit[0] + t[1] * unit[1]);
            let slip = (s[0] * normal[0] + s[1] * normal[1]) * length / limit;
            for axis in 0..2 {
                across[axis][pair] = normal[axis];
                fixed[axis * count + pair] = short * unit[axis];
                right[axis * count + pair] = slip * normal[axis];
            }
        }
        let unit = pairs.own / (count.max(1) as f64).sqrt();
        let border = Border::default();
        let mut linear = Self {
            pairs,
            rub,
            sticking,
            across,
            diagonal,
            fixed,
            right,
            unit,
            border,
            fixed_slip: vec![0.0; 2 * count],
            tried: vec![],
        };
        if linear.fixed.iter().any(|&change| change != 0.0) {
            linear.fixed_slip = linear.pairs.apply(&linear.fixed);
            let mut taken = linear.fixed_slip.clone();
            linear.keep_unknown(&mut taken);
            update(&mut linear.right, [&taken], |right, [taken]| right - taken);
        }
        linear.add_border(state);
        linear
    }

    /// Prepares what the forces given need.
    fn add_border(&mut self, state: &State) {
        let pairs = &*self.pairs;
        let prescribed = pairs.step.prescribed;
        let after: Vec<f64> =
            state.traction.iter().zip(&self.fixed).map(|(t, change)| t + change).collect();
        let per_area = self.unit / pairs.step.measure.area;
        self.right.extend(pairs.missing(&after).iter().map(|missing| per_area * missing));
        let responses: Vec<Vec<f64>> = (0..prescribed.len())
            .map(|index| {
                let mut uniform = self.uniform(&prescribed[index]);
                self.keep_unknown(&mut uniform);
                self.precondition_tractions(&uniform)
            })
            .collect();
        let gain = |row: usize, column: usize| {
            per_area * self.pairs.force(&responses[column], prescribed[row].direction)
        };
        let inverse = match prescribed.len() {
            0 => [[0.0; 2]; 2],
            1 => [[1.0 / gain(0, 0), 0.0], [0.0; 2]],
            _ => {
                let [a, b, c, d] = [gain(0, 0), gain(0, 1), gain(1, 0), gain(1, 1)];
                let determinant = a * d - b * c;
                [[d / determinant, -b / determinant], [-c / determinant, a / determinant]]
            }
        };
        // Where all slips along the force, no slip changes it.
        let inverse =
            inverse.map(|row| row.map(|value| if value.is_finite() { value } else { 0.0 }));
        self.border = Border { responses, inverse };
    }

    /// How well to solve: roughly while the sticking pairs still change much.
    fn tolerance(&self, last_stick: &[f64], residual: f64, aim: f64) -> f64 {
        let [sticking] = sum([&self.rub.stick], |[stick]| [stick]);
        let changed = if last_stick.is_empty() {
            sticking
        } else {
            let [changed] =
                sum([&self.rub.stick, last_stick], |[now, before]| [(now - before).abs()]);
            changed
        };
        let enough = 0.3 * aim / residual;
        let within = |share: f64| changed <= (share * sticking).max(1.0);
        let tolerance = if within(FINAL) {
            TIGHT.min(residual)
        } else if within(SETTLED) {
            TIGHT
        } else {
            LOOSE
        };
        tolerance.max(enough).min(LOOSE)
    }

    /// Keeps the part of a vector along what is unknown: all of it where pairs stick, that across the
    /// augmented traction where they slip.
    fn keep_unknown(&self, vector: &mut [f64]) {
        let (one, two) = vector.split_at_mut(self.sticking.len());
        let [] = sweep(
            [one, two],
            [&self.across[0], &self.across[1], &self.sticking],
            |[x, y], [a, b, stick]| {
                let part = a * x + b * y;
                ([stick * x + a * part, stick * y + b * part], [])
            },
        );
    }

    /// The change of tractions, slip and rigid slip.
    fn solve(&mut self, tolerance: f64) -> State {
        let right = std::mem::take(&mut self.right);
        let Solution { vector: mut traction, weights } =
            gmres::solve(self, &right, tolerance, KRYLOV);
        let prescribed = self.pairs.step.prescribed;
        let rigid_slip = traction.split_off(2 * self.sticking.len());
        let rigid_slip: Vec<f64> =
            rigid_slip.iter().map(|rigid_slip| self.unit * rigid_slip).collect();
        update(&mut traction, [&self.fixed], |change, [fixed]| change + fixed);
        let mut slip: Vec<f64> = self.fixed_slip.iter().map(|taken| -taken).collect();
        for (taken, &weight) in self.tried.iter().zip(&weights) {
            update(&mut slip, [taken], |slip, [taken]| slip - weight * taken);
        }
        for (prescribed, &rigid_slip) in prescribed.iter().zip(&rigid_slip) {
            update(&mut slip, [&self.uniform(prescribed)], |slip, [unit]| slip + rigid_slip * unit);
        }
        State { traction, rigid_slip, slip }
    }

    /// A uniform slip of one along a direction.
    fn uniform(&self, prescribed: &PrescribedForce) -> Vec<f64> {
        let pairs = self.sticking.len();
        prescribed.direction.iter().flat_map(|&unit| std::iter::repeat_n(unit, pairs)).collect()
    }

    /// Nearly the tractions that take a slip away, of what is unknown.
    fn precondition_tractions(&mut self, slip: &[f64]) -> Vec<f64> {
        let mut traction = self.pairs.precondition(slip, &self.rub);
        self.keep_unknown(&mut traction);
        traction
    }
}

impl System for Linear<'_, '_> {
    fn apply(&mut self, vector: &[f64]) -> Vec<f64> {
        let count = self.sticking.len();
        let (traction, rigid_slip) = vector.split_at(2 * count);
        let mut image = self.pairs.apply(traction);
        self.tried.push(image.clone());
        for (prescribed, rigid_slip) in self.pairs.step.prescribed.iter().zip(rigid_slip) {
            let slip = self.unit * rigid_slip;
            for (image, unit) in image.chunks_mut(count).zip(prescribed.direction) {
                image.iter_mut().for_each(|image| *image -= slip * unit);
            }
        }
        self.keep_unknown(&mut image);
        for (image, traction) in image.chunks_mut(count).zip(traction.chunks(count)) {
            update(image, [traction, &self.diagonal], |image, [traction, diagonal]| {
                image + diagonal * traction
            });
        }
        let per_area = self.unit / self.pairs.step.measure.area;
        let prescribed = self.pairs.step.prescribed.iter();
        image.extend(
            prescribed
                .map(|prescribed| per_area * self.pairs.force(traction, prescribed.direction)),
        );
        image
    }

    fn precondition(&mut self, image: &[f64]) -> Vec<f64> {
        let (slip, force) = image.split_at(2 * self.sticking.len());
        let mut traction = self.precondition_tractions(slip);
        let prescribed = self.pairs.step.prescribed;
        if prescribed.is_empty() {
            return traction;
        }
        let per_area = self.unit / self.pairs.step.measure.area;
        let mut short = [0.0; 2];
        for ((short, prescribed), force) in short.iter_mut().zip(prescribed).zip(force) {
            *short = force - per_area * self.pairs.force(&traction, prescribed.direction);
        }
        let rigid_slip = self.border.inverse.map(|row| row[0] * short[0] + row[1] * short[1]);
        for (response, &rigid_slip) in self.border.responses.iter().zip(&rigid_slip) {
            update(&mut traction, [response], |traction, [response]| {
                traction + rigid_slip * response
            });
        }
        traction.extend(
            rigid_slip.iter().take(prescribed.len()).map(|rigid_slip| rigid_slip / self.unit),
        );
        traction
    }
}
