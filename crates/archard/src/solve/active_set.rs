//! Newton steps on the set of pairs in contact, each solved directly.
//!
//! The pressures that close the gaps of the pairs in contact are found from the factors of their matrix; pairs
//! with a negative pressure leave, pairs that overlap join, all at once. If the number of such pairs does not
//! fall for some steps, only one of them changes at a time until it does, which ends for every matrix whose
//! principal minors are positive (J. J. Judice and F. M. Pires, *Computers Ops Res.* 21 (1994) 587). The matrix
//! need not be symmetric.
//!
//! New factors cost the third power of the number of pairs in contact. The factors of one step serve the next
//! ones of the solve, [bordered](crate::numerics::bordered) by the pairs that have joined or left since, as long as
//! those are few. It suits meshed bodies, whose matrix is there; elsewhere making it takes an application a pair.

use faer::Mat;

use super::residual::Measure;
use super::start::first_guess;
use super::{Outcome, PARAMETERS, Settings, Solver, Start, Status, Step, TOLERANCE};
use crate::kinematics::Control;
use crate::numerics::bordered::Bordered;
use crate::numerics::dense::{Lu, Unsolved};
use crate::numerics::vector::{in_pool, update};
use crate::parameters::Choice;

pub(super) const CHOICE: Choice<Box<dyn Solver>> = Choice {
    name: "active_set",
    meaning: "Newton steps on the pairs in contact, solved directly; for meshed bodies",
    parameters: PARAMETERS,
    build: |values| Ok(Box::new(ActiveSet { settings: Settings::read(values, TOLERANCE, 500) })),
};

/// Steps in which the number of pairs that change may fail to fall.
const PATIENCE: usize = 5;
/// Share of the pairs in contact that may have joined or left before new factors are cheaper than a border.
const BORDER: f64 = 0.1;

/// See the module.
#[derive(Debug)]
struct ActiveSet {
    settings: Settings,
}

impl Solver for ActiveSet {
    fn solve(&self, step: &Step<'_>, start: Option<Start<'_>>) -> Outcome {
        in_pool(|| self.iterate(step, start))
    }

    fn settings(&self) -> Settings {
        self.settings
    }

    /// The factors that are kept and those that take their place.
    fn memory(&self, _pairs: f64, in_contact: f64) -> f64 {
        16.0 * in_contact * in_contact
    }
}

/// Pressures of a set and what follows from them.
struct State {
    pressure: Vec<f64>,
    displacement: Vec<f64>,
    gap: Vec<f64>,
    approach: f64,
    residual: f64,
}

impl ActiveSet {
    fn iterate(&self, step: &Step<'_>, start: Option<Start<'_>>) -> Outcome {
        let (pressure, approach) = match start {
            Some(start) => (start.pressure.to_vec(), start.approach),
            None => first_guess(step),
        };
        let approach = match step.control {
            Control::Approach(given) => given,
            Control::Load(_) => approach,
        };
        let mut state = state_of(step, pressure, approach);
        let (mut count, mut applications) = (0, 1);
        let (mut fewest, mut patience) = (usize::MAX, PATIENCE);
        let mut kept = None;
        let mut contact: Vec<bool> =
            (0..step.gap.len()).map(|pair| in_contact(&state, pair)).collect();
        while state.residual > self.settings.tolerance && count < self.settings.max_iterations {
            count += 1;
            let closed = close(step, &contact, state.approach, &mut kept);
            let Ok((pressure, approach)) = closed else { break };
            applications += 1;
            state = state_of(step, pressure, approach);
            let wrong: Vec<usize> = (0..contact.len())
                .filter(|&pair| match contact[pair] {
                    true => state.pressure[pair] < 0.0,
                    false => state.gap[pair] < 0.0,
                })
                .collect();
            if wrong.len() < fewest {
                (fewest, patience) = (wrong.len(), PATIENCE);
            } else {
                patience = patience.saturating_sub(1);
            }
            let changed = if patience > 0 { &wrong[..] } else { &wrong[wrong.len().max(1) - 1..] };
            changed.iter().for_each(|&pair| contact[pair] = !contact[pair]);
        }
        let full = !step.measure.closed && state.pressure.iter().all(|&pressure| pressure > 0.0);
        let status = match (state.residual <= self.settings.tolerance, full) {
            (true, false) => Status::Converged,
            (true, true) => Status::FrameFull,
            (false, _) => Status::OutOfIterations,
        };
        let State { pressure, displacement, gap, approach, residual } = state;
        Outcome {
            status,
            pressure: pressure.into_iter().map(|pressure| pressure.max(0.0)).collect(),
            displacement,
            gap,
            approach,
            iterations: count,
            residual,
            applications,
        }
    }
}

fn in_contact(state: &State, pair: usize) -> bool {
    state.pressure[pair] > 0.0 || state.gap[pair] < 0.0
}

/// The factors of the pairs that were in contact when they were made.
struct Kept {
    pairs: Vec<usize>,
    lu: Lu,
}

impl Kept {
    fn of(step: &Step<'_>, pairs: &[usize]) -> Result<Self, Unsolved> {
        Ok(Self { pairs: pairs.to_vec(), lu: Lu::of(&matrix_of(step, pairs))? })
    }

    /// The vectors of pairs now in contact that have some images there, one a column; `None` where too many of
    /// the pairs are others.
    fn solve(&self, step: &Step<'_>, pairs: &[usize], images: &Mat<f64>) -> Option<Mat<f64>> {
        let apart = |these: &[usize], those: &[usize]| -> Vec<usize> {
            these.iter().copied().filter(|pair| those.binary_search(pair).is_err()).collect()
        };
        let (joined, left) = (apart(pairs, &self.pairs), apart(&self.pairs, pairs));
        let (within, border) = (self.pairs.len(), joined.len() + left.len());
        if border as f64 > BORDER * pairs.len() as f64 {
            return None;
        }
        let place = |these: &[usize], pair: usize| these.binary_search(&pair).ok();
        let image = |pair: usize, column: usize| {
            place(pairs, pair).map_or(0.0, |row| images[(row, column)])
        };
        let count = images.ncols();
        let mut inner = Mat::from_fn(within, count, |row, column| image(self.pairs[row], column));
        // What leaves has no row any more, and no pressure.
        let mut outer = Mat::from_fn(border, count, |row, column| {
            joined.get(row).map_or(0.0, |&pair| image(pair, column))
        });
        if border == 0 {
            self.lu.solve_in_place(inner.as_mut());
        } else {
            let all = [&self.pairs[..], &joined].concat();
            let matrix = if joined.is_empty() { Mat::new() } else { matrix_of(step, &all) };
            let leaves =
                |index: usize, at: usize| f64::from(left[index - joined.len()] == self.pairs[at]);
            let columns = Mat::from_fn(within, border, |row, column| {
                if column < joined.len() {
                    matrix[(row, within + column)]
                } else {
                    leaves(column, row)
                }
            });
            let rows = Mat::from_fn(border, within, |row, column| {
                if row < joined.len() {
                    matrix[(within + row, column)]
                } else {
                    leaves(row, column)
                }
            });
            let corner = Mat::from_fn(border, border, |row, column| {
                if row.max(column) < joined.len() {
                    matrix[(within + row, within + column)]
                } else {
                    0.0
                }
            });
            let bordered = Bordered::new(&self.lu, columns, rows, corner.as_ref()).ok()?;
            bordered.solve_in_place(inner.as_mut(), outer.as_mut());
        }
        Some(Mat::from_fn(pairs.len(), count, |row, column| match place(&self.pairs, pairs[row]) {
            Some(row) => inner[(row, column)],
            None => place(&joined, pairs[row]).map_or(0.0, |row| outer[(row, column)]),
        }))
    }
}

/// Gap of pairs under the pressures of each other (m/Pa).
fn matrix_of(step: &Step<'_>, pairs: &[usize]) -> Mat<f64> {
    let mut matrix = step.compliance.normal_matrix(pairs, step.gap.len());
    for (index, &pair) in pairs.iter().enumerate() {
        matrix[(index, index)] += step.addition[pair];
    }
    matrix
}

/// The pressures (Pa) that close the gaps of the pairs in contact, and the approach (m) that belongs to them.
fn close(
    step: &Step<'_>,
    contact: &[bool],
    approach: f64,
    kept: &mut Option<Kept>,
) -> Result<(Vec<f64>, f64), Unsolved> {
    let mut pairs: Vec<usize> = (0..contact.len()).filter(|&pair| contact[pair]).collect();
    if let (true, Control::Load(_)) = (pairs.is_empty(), step.control) {
        // A load needs a pair to bear it.
        pairs.extend((0..contact.len()).min_by(|&a, &b| step.gap[a].total_cmp(&step.gap[b])));
    }
    let mut pressure = vec![0.0; contact.len()];
    if let (true, Control::Approach(approach)) = (pairs.is_empty(), step.control) {
        return Ok((pressure, approach));
    }
    // What closes the gaps at no approach, and what an approach of one adds.
    let mut images = Mat::from_fn(pairs.len(), 2, |row, column| match column {
        0 => -step.gap[pairs[row]],
        _ => step.measure.closing.at(pairs[row]),
    });
    match kept.as_ref().and_then(|kept| kept.solve(step, &pairs, &images)) {
        Some(solved) => images = solved,
        None => kept.insert(Kept::of(step, &pairs)?).lu.solve_in_place(images.as_mut()),
    }
    let field = |column: usize| {
        let mut field = vec![0.0; contact.len()];
        pairs.iter().enumerate().for_each(|(row, &pair)| field[pair] = images[(row, column)]);
        field
    };
    let (still, rate) = (field(0), field(1));
    let approach = match step.control {
        Control::Approach(approach) => approach,
        Control::Load(load) => {
            let found = (load - step.measure.load(&still)) / step.measure.load(&rate);
            if found.is_finite() { found } else { approach }
        }
    };
    update(&mut pressure, [&still, &rate], |_, [still, rate]| still + approach * rate);
    Ok((pressure, approach))
}

/// What follows from pressures, negative ones among them, at an approach.
fn state_of(step: &Step<'_>, pressure: Vec<f64>, approach: f64) -> State {
    let mut displacement = vec![0.0; pressure.len()];
    step.compliance.apply_normal(&pressure, &mut displacement);
    let gap: Vec<f64> = (0..pressure.len())
        .map(|pair| {
            step.gap[pair] + displacement[pair] + step.addition[pair] * pressure[pair]
                - step.measure.closing.at(pair) * approach
        })
        .collect();
    let met = match step.control {
        Control::Approach(_) => 0.0,
        Control::Load(load) => (step.measure.load(&pressure) / load - 1.0).abs(),
    };
    let residual = Measure::of(step).residual(step, &pressure, &gap).max(met);
    State { pressure, displacement, gap, approach, residual }
}
