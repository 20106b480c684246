//! Contact in steady rolling: pressures and friction that belong together.

use std::ops::Range;

use super::effort::Effort;
use super::error::Error;
use super::friction;
use super::memory::{History, Increment};
use super::passing::distance_of_work;
use super::second_order::{self, to_mean_passages, to_own_passages};
use super::setup::Simulation;
use crate::compliance::{Compliance, SlipMap};
use crate::frame::{Flow, VectorField};
use crate::friction::{Friction, Grip, Limits};
use crate::motion::{Drive, Drives};
use crate::numerics::vector;
use crate::problem::{ContactProblem, ContactState, Tangential};
use crate::solve::tangential::{self, Admissible, PrescribedForce, TurningPair};

/// Change of the grip below which friction and what it depends on agree, turns between them, and the change next to the last
/// one from which on a turn goes only half as far as the one before; the second is that of a rough solve.
const SETTLED: f64 = 1e-7;
const ROUGHLY: f64 = 1e-3;
const TURNS: usize = 50;
const SLOW: f64 = 0.7;

/// Turns between pressures and friction of unlike bodies by which they agree, or go round in a circle: pairs at the rim open and
/// close, and make and break ties. Pairs that touched in one of them count as touching from then on, as far as ties go.
const AROUND: Range<usize> = 8..16;

/// What a step of friction is found from, whatever its grip.
struct Rubbed<'a> {
    drives: &'a Drives,
    flow: Flow<'a>,
    law: &'a dyn Friction,
    map: &'a dyn SlipMap,
    rigid: [&'a [f64]; 2],
    prescribed: &'a [PrescribedForce],
    turning: Option<&'a [TurningPair]>,
    /// Pressures (Pa) that say where particles come under friction, the present ones if not given.
    entries: Option<&'a [f64]>,
}

impl History {
    /// Finds pressures and friction that belong together.
    pub(super) fn solve_rolling(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        (gap, addition): (&[f64], &[f64]),
        compliance: &dyn Compliance,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let problem = &simulation.problem;
        let (mut count, mut largest) = (0, vec![0.0; self.state.pressure.len()]);
        let mut solve = |state: &mut Self, gap: &[f64]| {
            let before = state.state.pressure.clone();
            state.solve_normal(simulation, increment, gap, addition, compliance, effort)?;
            if AROUND.contains(&count) {
                vector::update(&mut largest, [&state.state.pressure], |most, [one]| most.max(one));
            }
            let entries = (count >= AROUND.end).then_some(&largest[..]);
            count += 1;
            state.rub_turning(simulation, increment, before, entries, effort)
        };
        let couples = problem.friction.is_some() && problem.compliance.couples();
        if !couples {
            return solve(self, gap);
        }
        friction::alternate(simulation, increment, self.opened_by_friction(problem), |opened| {
            let lifted = vector::map([gap, opened], |[gap, opened]| gap + opened);
            solve(self, &lifted)?;
            Ok((self.opened_by_friction(problem), self.state.approach))
        })
    }

    /// Gap (m) that the tangential tractions open between unlike bodies.
    pub(super) fn opened_by_friction(&self, problem: &ContactProblem) -> Vec<f64> {
        let pairs = problem.frame.len();
        let Some(tangential) = &self.state.tangential else { return vec![0.0; pairs] };
        let [t1, t2] = tangential.traction.clone();
        let displacement = problem.compliance.apply(&VectorField { t1, t2, n: vec![0.0; pairs] });
        displacement.n.iter().map(|n| -n).collect()
    }

    /// Finds the friction under the present pressures, from that under earlier ones (Pa), and which pairs slip and turn
    /// meanwhile: first nearly, then until they are those that the solution was found with.
    fn rub_turning(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        mut before_pressure: Vec<f64>,
        entries: Option<&[f64]>,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let problem = &simulation.problem;
        let Some(drives) = problem.motion.driven(increment.progress) else { return Ok(()) };
        let flow = problem.frame.flow(problem.motion.direction)?;
        if problem.friction.is_none() || !second_order::turns(&drives, flow) {
            let plain = (friction::solve as friction::Solve, Some(&[][..]), entries);
            return self.rub(simulation, increment, &before_pressure, plain, effort);
        }
        let nearly = (friction::estimate as friction::Solve, None, None);
        self.rub(simulation, increment, &before_pressure, nearly, effort)?;
        let mut turning = self.turning(problem, flow);
        before_pressure.clone_from(&self.state.pressure);
        for turn in 0..TURNS {
            let found = (friction::solve as friction::Solve, Some(&turning[..]), entries);
            self.rub(simulation, increment, &before_pressure, found, effort)?;
            let mut next = self.turning(problem, flow);
            if turn >= AROUND.start {
                // Pairs that slip and stick in turn count as slipping.
                next.extend(&turning);
                next.sort_unstable_by_key(|one| one.pair);
                next.dedup();
            }
            if next == turning {
                return Ok(());
            }
            turning = next;
            before_pressure.clone_from(&self.state.pressure);
        }
        Err(not_consistent(simulation, increment))
    }

    /// Finds the friction under the present pressures, from that under earlier ones (Pa).
    fn rub(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        before_pressure: &[f64],
        (solve, turning, entries): (friction::Solve, Option<&[TurningPair]>, Option<&[f64]>),
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let problem = &simulation.problem;
        let Some(drives) = &problem.motion.driven(increment.progress) else { return Ok(()) };
        let (frame, direction) = (&problem.frame, problem.motion.direction);
        let flow = frame.flow(direction)?;
        let mut rigid = self.rigid_slip(problem, drives, flow);
        let Some(law) = &problem.friction else {
            self.state.tangential = Some(Tangential {
                traction: [vec![0.0; frame.len()], vec![0.0; frame.len()]],
                slip: rigid,
                creepage: drives.both().map(Drive::slip),
                shift: [0.0; 2],
                grip: Grip::default(),
            });
            return Ok(());
        };
        let units = [direction.forward(), direction.lateral()];
        let prescribed = |(direction, drive): ([f64; 2], Drive)| match drive {
            Drive::Slip(_) => None,
            Drive::Force(force) => Some(PrescribedForce { direction, force }),
        };
        let prescribed: Vec<PrescribedForce> =
            units.into_iter().zip(drives.both()).filter_map(prescribed).collect();
        rigid.iter_mut().for_each(|slip| to_mean_passages(flow, slip));
        let step = Rubbed {
            drives,
            flow,
            law: &**law,
            map: &*problem.compliance.rolling(flow),
            rigid: [&rigid[0], &rigid[1]],
            prescribed: &prescribed,
            turning,
            entries,
        };
        let grip = |state: &ContactState| {
            problem.grip_of_rolling(&**law, state, (drives, flow), [&rigid[0], &rigid[1]])
        };
        let settled = if turning.is_none() { ROUGHLY } else { SETTLED };
        let (mut now, mut share, mut apart) = (grip(&self.state), 1.0, f64::INFINITY);
        let mut before = before_pressure.to_vec();
        for _ in 0..TURNS {
            self.rub_with(simulation, increment, (&step, solve), (now.clone(), &before), effort)?;
            let next = grip(&self.state);
            let changed = next.apart(&now);
            if changed <= settled {
                return Ok(());
            }
            if changed > SLOW * apart {
                share *= 0.5;
            }
            apart = changed;
            now = now.towards(&next, share);
            before.clone_from(&self.state.pressure);
        }
        Err(not_consistent(simulation, increment))
    }

    /// Finds the friction under the present pressures with a grip, from that under earlier ones (Pa).
    fn rub_with(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        (rubbed, solve): (&Rubbed<'_>, friction::Solve),
        (grip, before_pressure): (Grip, &[f64]),
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let frame = &simulation.problem.frame;
        let Rubbed { drives, flow, law, map, rigid, prescribed, turning, entries } = *rubbed;
        let advance = flow.advance();
        let pressure = &self.state.pressure;
        let limits = Limits::new(law, &grip);
        let limit = limits.all(pressure);
        let allowed = entries.map(|entered| limits.all(entered));
        let entered = (entries.unwrap_or(pressure), allowed.as_ref().unwrap_or(&limit).as_slice());
        let ties = second_order::entries(flow, entered, &limit);
        let turning = turning.unwrap_or_default();
        let admissible = |ties| Admissible { map: law.map(), ties, turning };
        let (elements, measure) = (frame.elements(), frame.measure());
        let step = tangential::Step { map, elements, measure, limit: &limit, rigid, prescribed };
        let before = self.state.tangential.take();
        let before_limit = before
            .as_ref()
            .map(|before| Limits::new(law, &before.grip).all(before_pressure))
            .unwrap_or_default();
        let rigid_slip: Vec<f64> = before
            .iter()
            .flat_map(|before| {
                let forces = drives.both().into_iter().zip(before.creepage);
                forces.filter(|(drive, _)| matches!(drive, Drive::Force(_)))
            })
            .map(|(_, creepage)| creepage * advance)
            .collect();
        let start = before.as_ref().map(|before| tangential::Start {
            traction: [&before.traction[0], &before.traction[1]],
            limit: &before_limit,
            rigid_slip: &rigid_slip,
        });
        // Spin turns tractions behind the edge, and between unlike bodies ties would change pressures that change ties.
        let plain = second_order::turns(drives, flow) || simulation.problem.compliance.couples();
        let outcome = if plain || ties.is_empty() {
            solve(simulation, increment, admissible(&ties), (&step, start), effort)?
        } else {
            let even = solve(simulation, increment, admissible(&ties), (&step, start), effort)?;
            let traction = [&even.traction[0][..], &even.traction[1]];
            let ties = second_order::continued(&ties, flow, law.map(), (&limit, traction));
            let rigid_slip = &even.rigid_slip;
            let start = Some(tangential::Start { traction, limit: &limit, rigid_slip });
            solve(simulation, increment, admissible(&ties), (&step, start), effort)?
        };
        let mut rigid_slip = outcome.rigid_slip.iter().map(|slip| slip / advance);
        let creepage = drives.both().map(|drive| match drive {
            Drive::Slip(creepage) => creepage,
            Drive::Force(_) => rigid_slip.next().unwrap_or_default(),
        });
        let (traction, mut slip) = (outcome.traction, outcome.slip);
        slip.iter_mut().for_each(|slip| to_own_passages(flow, slip));
        self.state.tangential =
            Some(Tangential { traction, slip, creepage, shift: [0.0; 2], grip });
        Ok(())
    }

    /// Slip (m) before any traction: of the rigid bodies, of their worn radii where those count, and of
    /// the strains that pressures make in unlike bodies.
    fn rigid_slip(
        &self,
        problem: &ContactProblem,
        drives: &Drives,
        flow: Flow<'_>,
    ) -> [Vec<f64>; 2] {
        let mut slip = drives.rigid_slip(flow);
        let axis = flow.direction().axis;
        let forward = flow.direction().forward();
        if drives.worn_radius {
            let curvature =
                |body: usize| problem.bodies[body].curvatures().map_or(0.0, |both| both[axis]);
            let [one, two] = [curvature(0), curvature(1)];
            let [worn_1, worn_2] = [self.state.worn(0), self.state.worn(1)];
            let all = || vec![flow.advance(); problem.frame.len()];
            let advances = flow.advances().unwrap_or_else(all);
            let fields = [&advances[..], &worn_1, &worn_2];
            vector::update(&mut slip[axis], fields, |slip, [advance, first, second]| {
                slip + advance * forward[axis] * (two * second - one * first)
            });
        }
        if problem.compliance.couples() {
            let n = self.state.pressure.clone();
            let zeros = || vec![0.0; n.len()];
            let elastic_displacement =
                problem.compliance.apply(&VectorField { t1: zeros(), t2: zeros(), n: n.clone() });
            let gained = flow.gained([&elastic_displacement.t1, &elastic_displacement.t2]);
            for (slip, gained) in slip.iter_mut().zip(&gained) {
                vector::update(slip, [gained], |slip, [gained]| slip + gained);
            }
        }
        slip
    }

    /// Work of the creepages over the coefficient of friction (N): what is worn a revolution is this
    /// times k, whatever the contact, if the friction is Coulomb's; where it depends on the direction of the
    /// slip, over its mean. Without friction, the load times the creepage.
    pub(super) fn creep_work(
        &self,
        problem: &ContactProblem,
        drives: &Drives,
        flow: Flow<'_>,
    ) -> f64 {
        let Some(tangential) = &self.state.tangential else { return 0.0 };
        let Some(friction) = &problem.friction else {
            return self.state.load * tangential.creepage[0].hypot(tangential.creepage[1]);
        };
        const REFERENCE: f64 = 1e8;
        let coefficient = friction.limit(REFERENCE) / REFERENCE;
        if coefficient == 0.0 {
            return self.state.load * tangential.creepage[0].hypot(tangential.creepage[1]);
        }
        let distance = distance_of_work(&self.state, &**friction, problem, flow);
        tangential.creep_power(problem, drives) / coefficient * distance
    }
}

fn not_consistent(simulation: &Simulation, increment: Increment) -> Error {
    Error::NotConsistent {
        measure: simulation.problem.motion.progress,
        progress: increment.progress,
        passes: TURNS,
    }
}
