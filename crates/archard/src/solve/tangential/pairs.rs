//! The pairs in contact alone: what iterations of friction work on.

use super::{Outcome, Start, Status, Step};
use crate::compliance::PairStatus;
use crate::friction::onto_disc;
use crate::numerics::vector::{map, sum, update};
use crate::solve::residual::{norm, relative, worse};

/// The pairs in contact of a step. Vectors on them hold all values along t1, then all along t2.
pub(super) struct Pairs<'a> {
    pub step: &'a Step<'a>,
    /// Their indices on the frame.
    pub places: Vec<usize>,
    /// Largest traction (Pa) of each.
    pub limit: Vec<f64>,
    /// Slip of the rigid bodies (m).
    pub rigid: Vec<f64>,
    /// Slip (m) of a pair under a unit traction (Pa) on it alone.
    pub own: f64,
    /// What area each stands for relative to the mean, for both directions.
    pub weight: Vec<f64>,
    /// 2-norm over the area (Pa) and sum (N) of the limits.
    norm: f64,
    force: f64,
    /// Fields on the whole frame: tractions there, slip back.
    fields: [Vec<f64>; 2],
    images: [Vec<f64>; 2],
    /// What the pairs of the whole frame do.
    status: Vec<PairStatus>,
    pub applications: usize,
}

/// Tractions of the pairs in contact, and what belongs to them.
#[derive(Debug, Clone)]
pub(super) struct State {
    /// Tractions (Pa).
    pub traction: Vec<f64>,
    /// Uniform slip (m) along each direction whose force is given.
    pub rigid_slip: Vec<f64>,
    /// Slip (m).
    pub slip: Vec<f64>,
}

impl State {
    /// The state after a share of a change.
    pub fn moved(&self, change: &Self, length: f64) -> Self {
        let along = |from: &[f64], by: &[f64]| map([from, by], |[from, by]| from + length * by);
        Self {
            traction: along(&self.traction, &change.traction),
            rigid_slip: along(&self.rigid_slip, &change.rigid_slip),
            slip: along(&self.slip, &change.slip),
        }
    }
}

impl<'a> Pairs<'a> {
    pub fn of(step: &'a Step<'a>) -> Self {
        let places: Vec<usize> = (0..step.limit.len()).filter(|&i| step.limit[i] != 0.0).collect();
        let limit: Vec<f64> = places.iter().map(|&place| step.limit[place]).collect();
        let rigid = step.rigid.iter().flat_map(|rigid| places.iter().map(|&place| rigid[place]));
        let weights = [0, 1].into_iter().flat_map(|_| places.iter());
        let weight: Vec<f64> = weights.map(|&place| step.measure.weight.at(place)).collect();
        let [squares, total] = sum([&limit, &weight[..limit.len()]], |[limit, weight]| {
            [weight * (limit * limit), weight * limit]
        });
        let zeros = || vec![0.0; step.limit.len()];
        Self {
            step,
            rigid: rigid.collect(),
            own: step.map.own(),
            norm: squares.sqrt(),
            force: total * step.measure.area,
            weight,
            fields: [zeros(), zeros()],
            images: [zeros(), zeros()],
            status: vec![PairStatus::Open; step.limit.len()],
            applications: 0,
            places,
            limit,
        }
    }

    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// Puts a vector on the frame.
    fn scatter(&mut self, vector: &[f64]) {
        for (field, values) in self.fields.iter_mut().zip(vector.chunks(self.places.len().max(1))) {
            self.places.iter().zip(values).for_each(|(&place, value)| field[place] = *value);
        }
    }

    /// The slip (m) that tractions (Pa) take away, on the pairs in contact; it stays on the whole frame
    /// in `images`.
    pub fn apply(&mut self, traction: &[f64]) -> Vec<f64> {
        self.scatter(traction);
        self.applications += 1;
        let [one, two] = &mut self.images;
        self.step.map.apply([&self.fields[0], &self.fields[1]], [one, two]);
        self.gather()
    }

    /// Sets what the pairs do.
    pub fn put_status(&mut self, status: &[PairStatus]) {
        self.places.iter().zip(status).for_each(|(&place, status)| self.status[place] = *status);
    }

    /// Tractions (Pa) that nearly take a slip (m) away where the pairs do what they were set to.
    pub fn precondition(&mut self, slip: &[f64]) -> Vec<f64> {
        self.scatter(slip);
        let [one, two] = &mut self.images;
        self.step.map.precondition([&self.fields[0], &self.fields[1]], &self.status, [one, two]);
        self.gather()
    }

    fn gather(&self) -> Vec<f64> {
        let mut vector = Vec::with_capacity(2 * self.places.len());
        for image in &self.images {
            vector.extend(self.places.iter().map(|&place| image[place]));
        }
        vector
    }

    /// Tractions at rest, or those of an earlier solution brought within the limits.
    pub fn start(&mut self, start: Option<Start<'_>>) -> State {
        let mut traction = vec![0.0; 2 * self.len()];
        let mut rigid_slip = vec![0.0; self.step.prescribed.len()];
        if let Some(start) = start {
            let [one, two] = start.traction;
            let (first, second) = traction.split_at_mut(self.places.len());
            let limits = self.places.iter().zip(&self.limit);
            for ((x, y), (&place, limit)) in first.iter_mut().zip(second).zip(limits) {
                // A pair keeps its share of the limit: one that slips goes on to slip.
                let before = start.limit[place];
                let factor = if before > 0.0 { limit / before } else { 1.0 };
                (*x, *y) = (factor * one[place], factor * two[place]);
            }
            rigid_slip.copy_from_slice(start.rigid_slip);
            self.project(&mut traction);
        }
        let mut state = State { traction, rigid_slip, slip: vec![] };
        self.find_slip(&mut state);
        state
    }

    /// Goes along the slip by a step (Pa/m) and back within the limits, and by changes of the rigid slip (m).
    pub fn predict(&mut self, state: &mut State, step: f64, rigid_slip: &[f64]) {
        update(&mut state.traction, [&state.slip], |traction, [slip]| traction + step * slip);
        self.project(&mut state.traction);
        update(&mut state.rigid_slip, [rigid_slip], |before, [change]| before + change);
        self.find_slip(state);
    }

    /// Brings tractions within the limits.
    fn project(&self, traction: &mut [f64]) {
        let (one, two) = traction.split_at_mut(self.len());
        for ((x, y), &limit) in one.iter_mut().zip(two).zip(&self.limit) {
            [*x, *y] = onto_disc([*x, *y], limit);
        }
    }

    /// Computes the slip of the tractions.
    pub fn find_slip(&mut self, state: &mut State) {
        let taken = if state.traction.iter().all(|&traction| traction == 0.0) {
            self.images.iter_mut().for_each(|image| image.fill(0.0));
            vec![0.0; state.traction.len()]
        } else {
            self.apply(&state.traction)
        };
        state.slip = map([&self.rigid, &taken], |[rigid, taken]| rigid - taken);
        self.add_rigid_slip(&mut state.slip, &state.rigid_slip);
    }

    /// Adds a uniform slip (m) along each direction whose force is given, on as many pairs as there are.
    pub fn add_rigid_slip(&self, slip: &mut [f64], rigid_slip: &[f64]) {
        let pairs = slip.len() / 2;
        for (rigid_slip, prescribed) in rigid_slip.iter().zip(self.step.prescribed) {
            for (slip, unit) in slip.chunks_mut(pairs.max(1)).zip(prescribed.direction) {
                update(slip, [], |slip, []| slip + rigid_slip * unit);
            }
        }
    }

    /// Force (N) of tractions along a direction.
    pub fn force(&self, traction: &[f64], direction: [f64; 2]) -> f64 {
        let (one, two) = traction.split_at(self.len());
        let [force] = sum([one, two, &self.weight[..self.len()]], |[x, y, weight]| {
            [weight * (x * direction[0] + y * direction[1])]
        });
        force * self.step.measure.area
    }

    /// How much each force given is short of (N).
    pub fn missing(&self, traction: &[f64]) -> Vec<f64> {
        let missing = |prescribed: &super::PrescribedForce| {
            prescribed.force - self.force(traction, prescribed.direction)
        };
        self.step.prescribed.iter().map(missing).collect()
    }

    /// The residual of [`Outcome`].
    pub fn residual(&self, state: &State) -> f64 {
        let (t1, t2) = state.traction.split_at(self.len());
        let (s1, s2) = state.slip.split_at(self.len());
        let fields = [t1, t2, s1, s2, &self.limit, &self.weight[..self.len()]];
        let [squares] = sum(fields, |[t1, t2, s1, s2, limit, weight]| {
            let [x, y] = onto_disc([t1 + s1 / self.own, t2 + s2 / self.own], limit);
            [weight * ((t1 - x).powi(2) + (t2 - y).powi(2))]
        });
        let missing = norm(&self.missing(&state.traction));
        worse(relative(squares.sqrt(), self.norm), relative(missing, self.force))
    }

    /// Slip (m, 2-norm over the area) of pairs that stick that amounts to a residual.
    pub fn slip_of(&self, residual: f64) -> f64 {
        residual * self.own * self.norm
    }

    /// The solution on the whole frame.
    pub fn finish(
        mut self,
        mut state: State,
        status: Status,
        iterations: usize,
        residual: f64,
    ) -> Outcome {
        self.find_slip(&mut state);
        let [x, y] = [0, 1].map(|axis| {
            map([self.step.rigid[axis], &self.images[axis]], |[rigid, taken]| rigid - taken)
        });
        let mut slip = [x, y].concat();
        self.add_rigid_slip(&mut slip, &state.rigid_slip);
        let second = slip.split_off(self.status.len());
        self.fields.iter_mut().for_each(|field| field.fill(0.0));
        self.scatter(&state.traction);
        Outcome {
            status,
            traction: self.fields,
            slip: [slip, second],
            rigid_slip: state.rigid_slip,
            iterations,
            residual,
            applications: self.applications,
        }
    }
}
