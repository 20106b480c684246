//! What rubbing does to bodies that are shifted against each other.
//!
//! Of the slip of a pair that closes or opens within an increment only the part under pressure counts; when
//! it closed follows from the gap before and the overlap that its pressure has pressed away since. Rubbing
//! takes the mean of the pressures before and after, friction the mean of the tractions, so that what is
//! dissipated in a closed cycle equals the work done on the bodies.

use crate::problem::{ContactProblem, ContactState};
use crate::simulation::memory::{History, Rubbed};
use crate::wear::{Per, Rubbing};

impl History {
    /// Takes up what was rubbed since a state, and wears both bodies by it.
    pub(in crate::simulation) fn take_up(
        &mut self,
        before: &ContactState,
        problem: &ContactProblem,
    ) {
        let stroke = |pair| Some((pair, stroke(pair, [before, &self.state], problem)?));
        let strokes: Vec<_> = (0..before.pressure.len()).filter_map(stroke).collect();
        for &(pair, rubbing) in &strokes {
            let work = rubbing.pressure * rubbing.slip;
            self.rubbed.slip[pair] += rubbing.slip;
            self.rubbed.work[pair] += work;
            let area = problem.frame.area(pair);
            self.rubbed.dissipated += rubbing.work * area;
            self.load_distance += work * area;
        }
        self.wear_by(&strokes, Per::Increment, problem);
        for surface in self.state.surfaces.iter_mut().filter(|one| !one.slid.is_empty()) {
            strokes.iter().for_each(|&(pair, rubbing)| surface.slid[pair] += rubbing.slip);
        }
        if problem.wearing([true; 2], Per::Cycle) != [false; 2] {
            let whole = &mut self.rubbed.whole;
            whole.resize(before.pressure.len(), None);
            for (pair, rubbing) in strokes {
                let before = whole[pair].take();
                whole[pair] = Some(before.map_or(rubbing, |before| before.then(rubbing)));
            }
        }
    }

    /// Begins a new cycle.
    pub(in crate::simulation) fn begin_cycle(&mut self) {
        self.rubbed = Rubbed::none(self.displacement.len());
    }

    /// Ends it, with the wear of laws that take a whole cycle.
    pub(in crate::simulation) fn end_cycle(&mut self, problem: &ContactProblem) {
        let rubbed = std::mem::take(&mut self.rubbed.whole);
        let rubbed: Vec<(usize, Rubbing)> =
            rubbed.into_iter().enumerate().filter_map(|(pair, one)| Some((pair, one?))).collect();
        self.wear_by(&rubbed, Per::Cycle, problem);
        self.dissipated += self.rubbed.dissipated;
    }

    /// Wears both bodies, at pairs that were rubbed, by the laws that take that at once.
    fn wear_by(&mut self, rubbed: &[(usize, Rubbing)], per: Per, problem: &ContactProblem) {
        let points = || rubbed.iter().map(|(_, rubbing)| *rubbing);
        for index in 0..2 {
            let one = [0, 1].map(|body| body == index);
            let state = &self.state;
            let wear = problem.wear(points(), problem.wearing(one, per), |body, point| {
                let (pair, rubbing) = rubbed[point];
                let [slid, depth] = state.surfaces[body].before(pair);
                // What a cycle slid was added while it went on.
                [if per == Per::Cycle { slid - rubbing.slip } else { slid }, depth]
            });
            let worn = &mut self.state.surfaces[index].depth;
            for (point, &(pair, rubbing)) in rubbed.iter().enumerate() {
                let depth = wear.depths[index][point];
                self.rubbed.depths[index][pair] += depth;
                self.rubbed.slopes[index][pair] += wear.slopes[point] * rubbing.pressure;
                worn[pair] += depth;
            }
        }
    }
}

/// What one pair went through between two states; `None` where nothing rubs.
fn stroke(pair: usize, states: [&ContactState; 2], problem: &ContactProblem) -> Option<Rubbing> {
    let [before, after] = states;
    let tangential = after.tangential.as_ref()?;
    let pressures = states.map(|state| state.pressure[pair]);
    let own = problem.compliance.normal_self_term();
    let gaps = states.map(|state| state.gap.values[pair]);
    let (share, pressure) = if problem.motion.increments().is_some_and(|shift| shift.end_pressure) {
        (f64::from(pressures[1] > 0.0), pressures[1])
    } else {
        (under_pressure(pressures, gaps, own), 0.5 * (pressures[0] + pressures[1]))
    };
    if share == 0.0 || tangential.sticks(problem, &after.pressure, pair) {
        return None;
    }
    let slip = [0, 1].map(|axis| share * tangential.slip[axis][pair]);
    let earlier = before.tangential.as_ref();
    let traction = |axis: usize| {
        let earlier = earlier.map_or(0.0, |earlier| earlier.traction[axis][pair]);
        0.5 * (earlier + tangential.traction[axis][pair])
    };
    let work = traction(0) * slip[0] + traction(1) * slip[1];
    let friction = problem
        .friction
        .as_ref()
        .map_or(0.0, |friction| friction.slope(pressure) * friction.map().resistance(slip));
    let friction = tangential.grip.at(pair) * friction;
    let rubbing = Rubbing::new(pressure, slip[0].hypot(slip[1])).with_friction(work, friction);
    Some(rubbing.with_vectors(slip, [0, 1].map(traction)))
}

/// Share of an increment during which a pair is under pressure, from its pressures (Pa) and gaps (m) before
/// and after; `own` is its compliance to its own pressure (m/Pa). The overlap that a pressure stands for
/// and the gap that was there before are gone through at one rate.
fn under_pressure([before, after]: [f64; 2], gaps: [f64; 2], own: f64) -> f64 {
    match (before > 0.0, after > 0.0) {
        (true, true) => 1.0,
        (false, false) => 0.0,
        (false, true) => own * after / (own * after + gaps[0].max(0.0)),
        (true, false) => own * before / (own * before + gaps[1].max(0.0)),
    }
}

#[cfg(test)]
mod tests {
    use super::under_pressure;

    /// A pair that was 2 apart and is pressed 1 into the other body closed after two thirds of the way.
    #[test]
    fn a_pair_counts_from_when_it_touched() {
        assert_eq!(under_pressure([0.0, 0.5], [2.0, 0.0], 2.0), 1.0 / 3.0);
        assert_eq!(under_pressure([0.5, 0.0], [0.0, 2.0], 2.0), 1.0 / 3.0);
        assert_eq!(under_pressure([0.5, 0.1], [0.0, 0.0], 2.0), 1.0);
        assert_eq!(under_pressure([0.0, 0.0], [1.0, 2.0], 2.0), 0.0);
        assert_eq!(under_pressure([0.0, 0.5], [0.0, 0.0], 2.0), 1.0);
    }
}
