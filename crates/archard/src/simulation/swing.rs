//! Surfaces that swing past each other, as in fretting with gross slip.
//!
//! Bodies that slide to and fro by lengths comparable with the contact do not keep the same points opposite each other. The
//! rounder body keeps its place in the frame, and the worn surface of the other is moved over it. A step of N cycles goes
//! through the positions of a half cycle, in whole elements: at each of them the contact wears both surfaces by what N cycles
//! slide there, implicitly, and the depths are laid down where the points of each surface are. It goes there with most of the
//! cycles and back with the rest; the next step begins at the other end.
//!
//! Positions of fine elements lie several elements apart. Where many of them fall on the length of the contact, wear is laid
//! down at the position itself: spread over the elements between, it would leave teeth that no position sees. Where few do, it
//! is spread: the ends of the contact would stay as stairs.
//!
//! A pair slides by the amplitude less what the bodies give way elastically there before it slips: its tangential displacement
//! under the tractions mu p of the contact in the middle. Pressures are those without friction, exact for bodies of one elasticity.

use super::error::Error;
use super::position::{Position, Positions, Way, mean};
use crate::body::Body;
use crate::frame::Rectangle;
use crate::friction::Limits;
use crate::motion::Motion;
use crate::problem::{ContactProblem, ContactState, Grid};

/// Positions on either side of the middle, at most: beyond, they lie several elements apart.
const MOST: usize = 8;

/// Share of the cycles of a step that go back again: surfaces that were worn from one end to the other fit at the last
/// positions better than at the first.
const BACK: f64 = 0.1;

/// Positions to a contact's length, at least, where a stroke is many contacts long.
const CLOSE: usize = 6;

/// Positions to a contact's length from which wear is laid down where it was worn.
const DENSE: usize = 12;

/// How surfaces swing past each other.
pub(super) struct Swing<'a> {
    problem: &'a ContactProblem,
    /// The way to either side (m).
    amplitude: f64,
    /// The body that keeps its place, and the one that is moved over it.
    bodies: [usize; 2],
    /// The elements of the one that is moved.
    grid: Grid,
}

/// A place at which the contact is solved on the way from one end to the other.
#[derive(Debug, Clone, PartialEq)]
struct Place {
    /// How far (elements) the surface is moved.
    offset: isize,
    /// Distance (m) that a half cycle slides there: a hat over the way.
    length: f64,
    /// Where (elements from the offset) the moved surface is meanwhile, and for which share of that distance.
    ways: Vec<(isize, f64)>,
}

/// Places on elements of that length (m), so many elements apart; the reach is half the sum of their lengths. What is
/// worn there is spread over the elements between them, or laid down at the position.
fn places(reach: f64, element: f64, stride: usize, spread: bool) -> Vec<Place> {
    let side = stride as f64 * element;
    let most = (reach / side).ceil() as isize;
    // The integral of a hat of base two, from its middle on, as far as a place.
    let half = |to: f64| {
        let to = to.clamp(-1.0, 1.0);
        to - 0.5 * to * to.abs()
    };
    let place = |number: isize| {
        let middle = number as f64 * side;
        // Within the reach.
        let integral = |from: f64, to: f64| {
            let [from, to] = [from, to].map(|place| (place.clamp(-reach, reach) - middle) / side);
            side * (half(to) - half(from))
        };
        let length = integral(-reach, reach);
        let reach = stride as isize;
        let share = |way: isize| {
            let here = middle + way as f64 * element;
            (way, integral(here - 0.5 * element, here + 0.5 * element) / length)
        };
        let ways = if spread {
            (-reach..=reach).map(share).filter(|(_, share)| *share > 0.0).collect()
        } else {
            vec![(0, 1.0)]
        };
        Place { offset: number * reach, length, ways }
    };
    (-most..=most).map(place).filter(|one| one.length > 0.0).collect()
}

/// Positions of a step on elements of a length (m), with a contact of that length (m); `None` where surfaces do not swing.
pub(super) fn count(motion: &Motion, element: f64, contact: Option<f64>) -> Option<u64> {
    let amplitude = motion.amplitude()?;
    let length = contact.map_or(1, |contact| (contact / element) as usize);
    let side = stride(motion, element, length) as f64 * element;
    let positions = 2 * (amplitude / side).ceil() as u64 + 1;
    Some(if motion.track().is_some() { positions } else { 2 * positions })
}

/// Elements from one position to the next, of a contact of so many elements.
fn stride(motion: &Motion, element: f64, contact: usize) -> usize {
    let amplitude = motion.amplitude().unwrap_or_default();
    match motion.track() {
        Some(_) => (contact / CLOSE).max(1),
        None => (amplitude / element / MOST as f64).ceil().max(1.0) as usize,
    }
}

/// The body that keeps its place, and the one that is moved over it: that of the track, or the less curved.
fn order(bodies: &[Body; 2], motion: &Motion) -> [usize; 2] {
    let curvature = |body: usize| {
        let curvatures = bodies[body].curvatures();
        curvatures.map_or(0.0, |curvatures| curvatures[motion.direction.axis].abs())
    };
    match motion.track() {
        Some(track) => [1 - track.body, track.body],
        None if curvature(1) > curvature(0) => [1, 0],
        None => [0, 1],
    }
}

/// The offsets (m) by which bodies are moved under the contact: of two that swing past each other, one keeps its place.
pub fn offsets(bodies: &[Body; 2], motion: &Motion) -> [Rectangle; 2] {
    let stays = motion.amplitude().map(|_| order(bodies, motion)[0]);
    [0, 1].map(|body| if stays == Some(body) { [0.0; 2].into() } else { motion.reach(body) })
}

impl<'a> Swing<'a> {
    /// Of a problem; `None` where surfaces do not swing.
    pub fn of(problem: &'a ContactProblem) -> Option<Self> {
        let motion = &problem.motion;
        let axis = motion.direction.axis;
        let amplitude = motion.amplitude()?;
        let bodies = order(&problem.bodies, motion);
        // As far as the amplitude in positions of any stride.
        let (frame, element) = (problem.frame.elements(), problem.frame.spacing()[axis]);
        let longest = stride(motion, element, frame[axis]);
        let margin = (amplitude / element).ceil() as usize + longest;
        Some(Self { problem, amplitude, bodies, grid: Grid::swinging(frame, axis, margin) })
    }

    fn axis(&self) -> usize {
        self.problem.motion.direction.axis
    }

    /// Share of a step that goes back: on a stroke that is many contacts long, none.
    fn back(&self) -> f64 {
        if self.problem.motion.track().is_some() { 0.0 } else { BACK }
    }

    /// Elements along the motion from end to end of a contact under pressures (Pa).
    fn contact_length(&self, pressure: &[f64]) -> usize {
        let (frame, axis) = (&self.problem.frame, self.axis());
        let along = |pair: usize| [pair % frame.elements()[0], pair / frame.elements()[0]][axis];
        let pressed = || (0..pressure.len()).filter(|&pair| pressure[pair] > 0.0).map(along);
        pressed().max().zip(pressed().min()).map_or(1, |(most, least)| most - least)
    }

    /// What resists slip along the motion (Pa), one value a pair.
    fn resistance(&self, state: &ContactState) -> Vec<f64> {
        let Some(friction) = &self.problem.friction else { return vec![0.0; state.pressure.len()] };
        let resistance = friction.map().resistance(self.problem.motion.heading([0.0; 2]));
        let grip = self.problem.grip(state, |_| 0.0).unwrap_or_else(|last| last);
        let limits = Limits::new(&**friction, &grip).all(&state.pressure);
        limits.iter().map(|limit| resistance * limit).collect()
    }

    /// The limit of friction over the load.
    fn coefficient(&self, state: &ContactState) -> f64 {
        let frame = &self.problem.frame;
        let load = frame.integrate(&state.pressure);
        if load > 0.0 { frame.integrate(&self.resistance(state)) / load } else { 0.0 }
    }

    /// What the bodies give way elastically (m) at each pair before all of them slip.
    fn elastic(&self, state: &ContactState) -> Vec<f64> {
        let zeros = vec![0.0; state.pressure.len()];
        if self.problem.friction.is_none() {
            return zeros;
        }
        let frame = &self.problem.frame;
        let traction = self.resistance(state);
        let tractions = if self.axis() == 0 { [&traction, &zeros] } else { [&zeros, &traction] };
        let mut slip = [zeros.clone(), zeros.clone()];
        let [x, y] = &mut slip;
        self.problem.compliance.shifting(frame).apply(tractions.map(|one| &one[..]), [x, y]);
        let [x, y] = slip;
        if self.axis() == 0 { x } else { y }
    }
}

impl Positions for Swing<'_> {
    fn grids(&self) -> [Option<Grid>; 2] {
        [0, 1].map(|body| (body == self.bodies[1]).then_some(self.grid))
    }

    /// From one end to the other and, with a share of the cycles, back.
    fn way(&self, state: &ContactState, forward: bool, advance: f64) -> Result<Way, Error> {
        let amplitude = self.amplitude;
        let elastic = self.elastic(state);
        let pressed = elastic.iter().zip(&state.pressure).filter(|(_, p)| **p > 0.0);
        let most = pressed.map(|(elastic, _)| *elastic).fold(0.0, f64::max);
        if most >= amplitude {
            return Err(Error::NoGrossSlip { amplitude, elastic: most });
        }
        let reach = amplitude - mean(&elastic, &state.pressure);
        // Of the mean way, those of the pairs.
        let shares: Vec<f64> =
            elastic.iter().map(|elastic| (amplitude - elastic).max(0.0) / reach).collect();
        let (axis, moves) = (self.axis(), self.bodies[1]);
        let element = self.problem.frame.spacing()[axis];
        let contact = self.contact_length(&state.pressure);
        let stride = stride(&self.problem.motion, element, contact);
        let mut places = places(reach, element, stride, stride > 1 && contact < DENSE * stride);
        if !forward {
            places.reverse();
        }
        // Each half cycle goes through all places.
        let passes = self.problem.motion.slip(advance) / (2.0 * amplitude);
        let back = self.back();
        let along = |elements: isize| if axis == 0 { [elements, 0] } else { [0, elements] };
        let position = |(place, part): (&Place, f64)| {
            let distance = part * passes * place.length;
            let mut offsets = [[0; 2]; 2];
            offsets[moves] = along(place.offset);
            let slips = shares.iter().map(|share| share * distance).collect();
            let ways: Vec<_> =
                place.ways.iter().map(|(way, share)| (along(*way), *share)).collect();
            Position { slips, ways: [ways.clone(), ways], ..Position::at(offsets, distance) }
        };
        let there = places.iter().map(|one| (one, 1.0 - back));
        let and_back = places.iter().rev().map(|one| (one, back));
        let both = there.chain(and_back).filter(|(_, part)| *part > 0.0);
        Ok(Way { positions: both.map(position).collect(), reach })
    }

    fn opening(&self, pair: usize, position: &Position) -> f64 {
        let (frame, moves) = (&self.problem.frame, self.bodies[1]);
        let profile = &self.problem.bodies[moves].profile;
        let axis = self.axis();
        let shift = position.offsets[moves][axis] as f64 * frame.spacing()[axis];
        let place = frame.place(pair);
        let mut moved = place;
        moved[axis] -= shift;
        profile.recess(moved[0], moved[1]) - profile.recess(place[0], place[1])
    }

    fn bodies(&self) -> [usize; 2] {
        self.bodies
    }

    fn reaches_an_end(&self, pressure: &[f64]) -> bool {
        let (elements, axis) = (self.problem.frame.elements(), self.axis());
        let end = |pair: usize| {
            let along = [pair % elements[0], pair / elements[0]][axis];
            along == 0 || along + 1 == elements[axis]
        };
        (0..pressure.len()).any(|pair| pressure[pair] > 0.0 && end(pair))
    }

    fn dissipated(&self, state: &ContactState, way: &Way) -> f64 {
        self.coefficient(state) * state.load * 4.0 * way.reach
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::position::gap;
    use super::{Position, Swing, places};
    use crate::body::profile::Cylinder;
    use crate::body::{Body, Material};
    use crate::frame::Direction;
    use crate::motion::{
        Control, Lever, Motion, Passage, Progress, Schedule, Sequence, Slip, Stepping,
    };
    use crate::simulation::Simulation;
    use crate::simulation::memory::History;

    /// Cylinders of 6 and 30 mm on a line of 1 mm in 100 elements.
    fn cylinders() -> Simulation {
        let steel = Material::new(210e9, 0.3).unwrap();
        let body = |name: &str, radius: f64| {
            Body::new(name, Cylinder::along_y(radius).unwrap()).material(steel)
        };
        let motion = Motion {
            progress: Progress::CYCLES,
            direction: Direction::X,
            surfaces: [Passage::Swings(50e-6, None); 2],
            slip: Slip::Given(4.0 * 50e-6, Lever::Even),
            sequence: Sequence::Steady,
            speed: None,
        };
        let schedule = Schedule::steady(Control::Load(1e3), 10.0, Stepping::Implicit(1.0));
        let bodies = [body("small", 6e-3), body("large", 30e-3)];
        let builder = Simulation::builder(bodies, (motion, schedule));
        builder.line([1e-3, 1.0], 100).build().unwrap()
    }

    /// What is worn off the moved body and what is round of it move the same way.
    #[test]
    fn shape_and_wear_move_together() {
        let simulation = cylinders();
        let swing = Swing::of(&simulation.problem).unwrap();
        assert_eq!(swing.bodies, [0, 1]);
        let mut state = History::new(&simulation.problem).state;
        let place = swing.grid.at(40, [0; 2]);
        state.surfaces[1].depth[place] = 1e-6;
        let position = Position::at([[0; 2], [10, 0]], 0.0);
        let gaps = gap(&swing, (&simulation.problem, &state), &position).unwrap();
        state.surfaces[1].depth[place] = 0.0;
        let smooth = gap(&swing, (&simulation.problem, &state), &position).unwrap();
        let opened: Vec<usize> = (0..100).filter(|&pair| gaps[pair] != smooth[pair]).collect();
        assert_eq!(opened, [50]);
        assert_eq!(swing.grid.at(50, [10, 0]), place);
        // Two parabolas of curvatures c and c', one moved by d, are nearest at d c' / (c + c').
        let nearest = (0..100).min_by(|&one, &two| smooth[one].total_cmp(&smooth[two])).unwrap();
        let place = simulation.problem.frame.place(nearest)[0];
        assert_relative_eq!(place, 0.1e-3 * 6.0 / 36.0, epsilon = 0.6e-5);
    }

    /// The lengths of all positions are those of a half cycle, even to both sides.
    #[test]
    fn positions_share_the_way() {
        for (reach, stride) in [(2e-6, 1), (9e-6, 1), (24.6e-6, 2), (300e-6, 4)] {
            let places = places(reach, 1e-5, stride, false);
            let sum = |power: i32| -> f64 {
                places.iter().map(|one| one.length * (one.offset as f64 * 1e-5).powi(power)).sum()
            };
            assert_relative_eq!(sum(0), 2.0 * reach, max_relative = 1e-12);
            assert!(sum(1).abs() < 1e-12 * reach * reach);
            assert!(places.iter().all(|one| one.ways == [(0, 1.0)]));
        }
    }

    /// Spread, each element within the reach has as much of the way as every other.
    #[test]
    fn positions_spread_the_way_evenly() {
        let (reach, element) = (305e-6, 1e-5);
        for stride in [2, 4, 7] {
            let mut ways = vec![0.0; 81];
            for place in places(reach, element, stride, true) {
                for (way, share) in place.ways {
                    ways[(40 + place.offset + way) as usize] += share * place.length;
                }
            }
            assert_relative_eq!(ways.iter().sum::<f64>(), 2.0 * reach, max_relative = 1e-12);
            for within in &ways[40 - 30..=40 + 30] {
                assert_relative_eq!(*within, element, max_relative = 1e-9);
            }
        }
    }
}
