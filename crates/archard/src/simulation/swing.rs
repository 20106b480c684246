//! Surfaces that swing past each other, as in fretting with gross slip.
//!
//! Bodies that slide to and fro by lengths comparable with the contact do not keep the same points opposite each other. The
//! rounder body keeps its place in the frame, and the worn surface of the other is moved over it. A step of N cycles goes
//! through the positions of a half cycle, in whole elements: at each of them the contact wears both surfaces by what N cycles
//! slide there, implicitly, and the depths are laid down where the points of each surface are. It goes there with most of the
//! cycles and back with the rest; the next step begins at the other end.
//!
//! A pair slides by the amplitude less what the bodies give way elastically there before it slips: its tangential displacement
//! under the tractions mu p of the contact in the middle. Pressures are those without friction, exact for bodies of one elasticity.

use super::collector::{Collector, Slides};
use super::evolution::{Evolution, Increment};
use super::{Effort, Error, Simulation};
use crate::numerics::vector::Values;
use crate::problem::ContactProblem;

/// Positions on either side of the middle, at most: beyond, they lie several elements apart.
const MOST: usize = 8;

/// Share of the cycles of a step that go back again: surfaces that were worn from one end to the other fit at the last
/// positions better than at the first.
const BACK: f64 = 0.1;

/// The frame, and the body that is moved over it.
struct Course<'a> {
    problem: &'a ContactProblem,
    axis: usize,
    /// The body that keeps its place, and the one that is moved.
    bodies: [usize; 2],
}

impl Evolution {
    /// A step of `increment.advance` cycles of that amplitude (m).
    pub(super) fn swing(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        amplitude: f64,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let problem = &simulation.problem;
        let course = Course::of(problem);
        let elastic = course.elastic(&self.state.pressure);
        let pressed = elastic.iter().zip(&self.state.pressure).filter(|(_, p)| **p > 0.0);
        let most = pressed.map(|(elastic, _)| *elastic).fold(0.0, f64::max);
        if most >= amplitude {
            return Err(Error::NoGrossSlip { amplitude, elastic: most });
        }
        let reach = amplitude - mean(&elastic, &self.state.pressure);
        // Of the mean way, those of the pairs.
        let shares: Vec<f64> =
            elastic.iter().map(|elastic| (amplitude - elastic).max(0.0) / reach).collect();
        let mut positions = positions(reach, problem.frame.spacing()[course.axis]);
        self.forward = !self.forward;
        if !self.forward {
            positions.reverse();
        }
        let there = positions.iter().map(|one| (one, 1.0 - BACK));
        let back = positions.iter().rev().map(|one| (one, BACK));
        let collector = Collector::of_pairs(problem);
        // Each half cycle goes through all positions.
        let passes = 2.0 * increment.advance;
        for (&(offset, length), part) in there.chain(back) {
            let out = || {
                let measure = problem.motion.progress();
                Error::SwungOut { measure, progress: increment.progress }
            };
            let gap = course.gap(&self.state.worn, offset).ok_or_else(out)?;
            let distance = part * passes * length;
            let slip: Vec<f64> = shares.iter().map(|share| share * distance).collect();
            let there = |body: usize, pair: usize| {
                course.opposite(pair, if body == course.bodies[0] { 0 } else { offset })
            };
            let slides = Slides { distance: Values::Each(&slip), point: &there };
            let rubbed = (increment, slides);
            let made = self.contact_and_wear(simulation, rubbed, &collector, &gap, effort)?;
            self.load_distance += self.prescribed_load(increment) * distance;
            let Some(wear) = made.pairs else { continue };
            for (body, offset) in course.bodies.into_iter().zip([0, offset]) {
                let state = &mut self.state;
                let mut lies = course.lay_down(&wear.depths[body], &mut state.worn[body], offset);
                if !state.slid[body].is_empty() {
                    lies &= course.lay_down(&wear.slip, &mut state.slid[body], offset);
                }
                if !lies {
                    return Err(out());
                }
            }
        }
        // What is shown is the contact in the middle.
        self.press(simulation, increment, effort)?;
        effort.dissipated[0] =
            course.coefficient(&self.state.pressure) * self.state.load * 4.0 * reach;
        Ok(())
    }
}

/// The mean of a field, weighted by the pressures (Pa).
fn mean(field: &[f64], pressure: &[f64]) -> f64 {
    let load: f64 = pressure.iter().sum();
    let sum: f64 = field.iter().zip(pressure).map(|(value, pressure)| value * pressure).sum();
    if load > 0.0 { sum / load } else { 0.0 }
}

/// Positions in elements of that length (m), and the distance (m) that a half cycle slides at each, of which the reach is
/// half the sum: hats over the way.
fn positions(reach: f64, element: f64) -> Vec<(isize, f64)> {
    let stride = stride(reach, element);
    let side = stride * element;
    let most = (reach / side).ceil() as isize;
    // The integral of a hat of base two, from its middle on, as far as a place.
    let half = |to: f64| {
        let to = to.clamp(-1.0, 1.0);
        to - 0.5 * to * to.abs()
    };
    let length = |position: isize| {
        let middle = position as f64;
        side * (half(reach / side - middle) - half(-reach / side - middle))
    };
    (-most..=most).map(|position| (position * stride as isize, length(position))).collect()
}

/// Elements from one position to the next.
fn stride(reach: f64, element: f64) -> f64 {
    (reach / element / MOST as f64).ceil().max(1.0)
}

/// Contact solves of a step over an amplitude (m) on elements of that length (m).
pub(crate) fn solves_of_a_step(amplitude: f64, element: f64) -> u64 {
    2 * positions(amplitude, element).len() as u64 + 1
}

impl<'a> Course<'a> {
    fn of(problem: &'a ContactProblem) -> Self {
        let axis = problem.motion.sliding().map_or(0, |sliding| sliding.direction.axis);
        let curvature = |body: usize| {
            problem.bodies[body].curvatures().map_or(0.0, |curvatures| curvatures[axis].abs())
        };
        let bodies = if curvature(1) > curvature(0) { [1, 0] } else { [0, 1] };
        Self { problem, axis, bodies }
    }

    /// Where the element of the moved body is that lies opposite a pair at an offset.
    fn opposite(&self, pair: usize, offset: isize) -> Option<usize> {
        let elements = self.problem.frame.elements();
        let stride = [1, elements[0]][self.axis];
        let index = pair / stride % elements[self.axis];
        let moved = index as isize - offset;
        let inside = moved >= 0 && moved < elements[self.axis] as isize;
        inside.then(|| (pair as isize - offset * stride as isize) as usize)
    }

    /// Gap (m) of the worn, undeformed surfaces at zero approach; `None` where the moved one does not reach over the frame.
    fn gap(&self, worn: &[Vec<f64>; 2], offset: isize) -> Option<Vec<f64>> {
        let frame = &self.problem.frame;
        let [stays, moves] = self.bodies;
        let profile = &self.problem.bodies[moves].profile;
        let shift = offset as f64 * frame.spacing()[self.axis];
        let at = |pair: usize| {
            let place = frame.place(pair);
            let mut moved = place;
            moved[self.axis] -= shift;
            let rises = profile.recess(moved[0], moved[1]) - profile.recess(place[0], place[1]);
            let depth = self.opposite(pair, offset).map_or(0.0, |pair| worn[moves][pair]);
            let gap = frame.gap()[pair] + rises + worn[stays][pair] + depth;
            gap.is_finite().then_some(gap)
        };
        (0..frame.len()).map(at).collect()
    }

    /// Adds depths (m), one value a pair, to a surface at an offset; whether all of them lie on it.
    fn lay_down(&self, depths: &[f64], worn: &mut [f64], offset: isize) -> bool {
        let mut inside = true;
        for (pair, depth) in depths.iter().enumerate() {
            match self.opposite(pair, offset) {
                Some(place) => worn[place] += depth,
                None => inside &= *depth == 0.0,
            }
        }
        inside
    }

    /// The limit of friction over the load.
    fn coefficient(&self, pressure: &[f64]) -> f64 {
        let Some(friction) = &self.problem.friction else { return 0.0 };
        let frame = &self.problem.frame;
        let direction = self.problem.motion.slides();
        let limit: f64 =
            (0..frame.len()).map(|pair| frame.area(pair) * friction.limit(pressure[pair])).sum();
        let load = frame.integrate(pressure);
        if load > 0.0 { friction.map().resistance(direction) * limit / load } else { 0.0 }
    }

    /// What the bodies give way elastically (m) at each pair before all of them slip.
    fn elastic(&self, pressure: &[f64]) -> Vec<f64> {
        let zeros = vec![0.0; pressure.len()];
        let Some(friction) = &self.problem.friction else { return zeros };
        let frame = &self.problem.frame;
        let resistance = friction.map().resistance(self.problem.motion.slides());
        let traction: Vec<f64> =
            pressure.iter().map(|&pressure| resistance * friction.limit(pressure)).collect();
        let tractions = if self.axis == 0 { [&traction, &zeros] } else { [&zeros, &traction] };
        let mut slip = [zeros.clone(), zeros.clone()];
        let [x, y] = &mut slip;
        self.problem.compliance.shifting(frame).apply(tractions.map(|one| &one[..]), [x, y]);
        let [x, y] = slip;
        if self.axis == 0 { x } else { y }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{Course, positions};
    use crate::body::profile::Cylinder;
    use crate::body::{Body, Material};
    use crate::motion::{Control, Motion, Schedule, Sliding, Stepping};
    use crate::simulation::Simulation;

    /// Cylinders of 6 and 30 mm on a line of 1 mm in 100 elements.
    fn cylinders() -> Simulation {
        let steel = Material::new(210e9, 0.3).unwrap();
        let body = |name: &str, radius: f64| {
            Body::new(name, Cylinder::along_y(radius).unwrap()).material(steel)
        };
        let sliding = Sliding { swing: Some(50e-6), ..Sliding::default() };
        let schedule = Schedule::steady(Control::Load(1e3), 10.0, Stepping::Implicit(1.0));
        let bodies = [body("small", 6e-3), body("large", 30e-3)];
        let builder = Simulation::builder(bodies, (Motion::Sliding(sliding), schedule));
        builder.line(1e-3, 100, 1.0).build().unwrap()
    }

    /// What is worn off the moved body and what is round of it move the same way.
    #[test]
    fn shape_and_wear_move_together() {
        let simulation = cylinders();
        let course = Course::of(&simulation.problem);
        assert_eq!(course.bodies, [0, 1]);
        let mut worn = [vec![0.0; 100], vec![0.0; 100]];
        worn[1][40] = 1e-6;
        let gaps = course.gap(&worn, 10).unwrap();
        worn[1][40] = 0.0;
        let smooth = course.gap(&worn, 10).unwrap();
        let opened: Vec<usize> = (0..100).filter(|&pair| gaps[pair] != smooth[pair]).collect();
        assert_eq!(opened, [50]);
        assert_eq!(course.opposite(50, 10), Some(40));
        // Two parabolas of curvatures c and c', one moved by d, are nearest at d c' / (c + c').
        let nearest = (0..100).min_by(|&one, &two| smooth[one].total_cmp(&smooth[two])).unwrap();
        let place = simulation.problem.frame.place(nearest)[0];
        assert_relative_eq!(place, 0.1e-3 * 6.0 / 36.0, epsilon = 0.6e-5);
    }

    /// The lengths of all positions are those of a half cycle, even to both sides.
    #[test]
    fn positions_share_the_way() {
        for reach in [2e-6, 9e-6, 24.6e-6, 300e-6] {
            let positions = positions(reach, 1e-5);
            let sum = |power: i32| -> f64 {
                positions
                    .iter()
                    .map(|&(offset, length)| length * (offset as f64 * 1e-5).powi(power))
                    .sum()
            };
            assert_relative_eq!(sum(0), 2.0 * reach, max_relative = 1e-12);
            assert!(sum(1).abs() < 1e-12 * reach * reach);
        }
    }
}
