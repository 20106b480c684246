//! What lies beyond the frame, and may touch.
//!
//! The frame is a part of an endless grid. Pressures open the gaps beyond it, so that only places touch there whose gap is less
//! than the approach: their gaps are known from the profiles, and what the pressures open them by at least from the
//! compliance, and layers have no bound of it. Where that does not keep them open, or the contact comes to the rim of the frame,
//! the frame has to grow.

use std::ops::Range;

use rayon::prelude::*;

use super::setup::Simulation;
use crate::body::Body;
use crate::frame::extent;
use crate::problem::{ContactProblem, ContactState, Surface};
use crate::solve::Cells;

/// Places along an axis on which shapes given by formulas are looked at far from the frame, relative to its size.
const ACROSS: [f64; 5] = [-0.5, -0.25, 0.0, 0.25, 0.5];

/// Elements along the side of a block that is asked for as one: it costs a bound in the place of its 64 gaps, and is divided
/// into elements where that does not keep it open. How large it is changes no result.
const BLOCK: usize = 8;

/// Open elements around the contact: its edge is told by two of them.
const OPEN: isize = 2;

/// Part of the frame that it grows by at least at a side: a contact that grows to n times its width then meets a number of
/// frames like log n, and each takes kernels and a step anew. How many there are changes no result.
const ROOM: usize = 8;

/// How many elements more a frame needs at the lower and the upper side along x, and along y.
pub(super) type More = [[usize; 2]; 2];

/// The places beyond a frame: as far as it is wide on each side, and farther away where readings are.
#[derive(Debug)]
pub(super) struct Surroundings {
    /// How many elements more there can be. Where the surfaces do not change along an axis, a long contact is cut off as the
    /// frame says.
    room: More,
    /// How deep (m) the profiles lie below their planes where they touch first.
    touch: f64,
    /// Blocks of elements and the least gap (m) of undeformed bodies in each, the smallest first.
    blocks: Vec<(f64, Block)>,
}

/// The first and the last element of a block along x and y, counted from the first one of the frame.
#[derive(Debug, Clone, Copy)]
struct Block {
    low: [isize; 2],
    high: [isize; 2],
}

impl Block {
    fn of(place: [isize; 2]) -> Self {
        Self { low: place, high: place }
    }

    fn and(self, other: Self) -> Self {
        Self {
            low: [0, 1].map(|axis| self.low[axis].min(other.low[axis])),
            high: [0, 1].map(|axis| self.high[axis].max(other.high[axis])),
        }
    }

    fn places(self) -> impl Iterator<Item = [isize; 2]> {
        let Self { low, high } = self;
        (low[1]..=high[1]).flat_map(move |y| (low[0]..=high[0]).map(move |x| [x, y]))
    }
}

impl Surroundings {
    /// Those of a problem. There are none beyond frames that are not uniform, or that end or repeat themselves with the
    /// surfaces.
    pub fn of(problem: &ContactProblem) -> Self {
        let frame = &problem.frame;
        if !frame.is_uniform() || frame.measure().closed {
            return Self { room: [[0; 2]; 2], touch: 0.0, blocks: vec![] };
        }
        let grows = [0, 1].map(|axis| !(problem.is_even(axis) || frame.is_line() && axis == 1));
        let room = [0, 1].map(|axis| if grows[axis] { room(problem, axis) } else { [0; 2] });
        let touch = frame.touch(problem.bodies.each_ref().map(|body| &*body.profile));
        let elements = frame.elements();
        // Along an axis, from as far below the frame as it is wide to as far above.
        let near = [0, 1].map(|axis| {
            let [below, above] = room[axis].map(|room| room.min(elements[axis]) as isize);
            -below..elements[axis] as isize + above
        });
        let [x, y] = [0, 1].map(|axis| cut(&near[axis], elements[axis] as isize));
        let all = y.iter().flat_map(|y| x.iter().map(move |x| [x, y]));
        let ring = all.filter(|sides| sides.iter().any(|(_, within)| !within));
        let ring = ring.map(|[(x, _), (y, _)]| Block { low: [x[0], y[0]], high: [x[1], y[1]] });
        let is_far = |place: &[isize; 2]| (0..2).any(|axis| !near[axis].contains(&place[axis]));
        let far = readings(problem, grows).filter(is_far).map(Block::of);
        let of_block = |block: Block| {
            let gaps = block.places().map(|place| gap(problem, place) - touch);
            (gaps.filter(|gap| gap.is_finite()).fold(f64::INFINITY, f64::min), block)
        };
        let blocks: Vec<Block> = ring.chain(far).collect();
        let mut blocks: Vec<_> = blocks.into_par_iter().map(of_block).collect();
        blocks.sort_by(|one, other| one.0.total_cmp(&other.0));
        Self { room, touch, blocks }
    }

    /// Whether a frame can grow.
    pub fn grow(&self) -> bool {
        self.room != [[0; 2]; 2]
    }

    /// The least gap (m) beyond.
    pub fn least(&self) -> f64 {
        self.blocks.first().map_or(f64::INFINITY, |(least, _)| *least)
    }

    /// How much more a frame needs that holds a contact; `None` where it holds what touches, and open elements around it, or
    /// cannot grow there.
    pub fn missed(&self, problem: &ContactProblem, state: &ContactState) -> Option<More> {
        let elements = problem.frame.elements();
        let [columns, rows] = extent(elements, |pair| state.pressure[pair] > 0.0)?;
        let pressed = Block {
            low: [columns.start as isize, rows.start as isize],
            high: [columns.end as isize - 1, rows.end as isize - 1],
        };
        // What is smooth brings surfaces together or apart beyond the frame as on its rim.
        let approach = state.approach - problem.compliance.at_the_rim(&state.pressure);
        let close = self.blocks.partition_point(|(least, _)| *least < approach);
        let cells = Cells::of(elements, &state.pressure);
        let touches = |&(least, block): &(f64, Block)| {
            let open = |apart: f64, Block { low, high }: Block| {
                cells.leave_open(apart, &*problem.compliance, [low, high])
            };
            if open(least - approach, block) {
                return None;
            }
            let touches = |place: &[isize; 2]| {
                let gap = gap(problem, *place) - self.touch + worn_beyond(state, *place);
                gap.is_finite() && !open(gap - approach, Block::of(*place))
            };
            block.places().filter(touches).map(Block::of).reduce(Block::and)
        };
        let touching = self.blocks[..close].par_iter().filter_map(touches);
        let reach = touching.reduce(|| pressed, Block::and);
        let more = [0, 1].map(|axis| {
            let below = OPEN.saturating_sub(reach.low[axis]);
            let above = reach.high[axis].saturating_add(1 + OPEN) - elements[axis] as isize;
            [below, above].map(|more| usize::try_from(more).unwrap_or(0))
        });
        self.roomy(problem, more)
    }

    /// Half as much more at each side as a frame is wide: where all of it touches.
    pub fn twice(&self, problem: &ContactProblem) -> Option<More> {
        self.roomy(problem, problem.frame.elements().map(|count| [count.div_ceil(2); 2]))
    }

    /// So much more, and some room, as far as there is any.
    fn roomy(&self, problem: &ContactProblem, more: More) -> Option<More> {
        let elements = problem.frame.elements();
        let more = [0, 1].map(|axis| {
            let some = elements[axis].div_ceil(ROOM);
            [0, 1].map(|side| match more[axis][side] {
                0 => 0,
                more => more.max(some).min(self.room[axis][side]),
            })
        });
        (more != [[0; 2]; 2]).then_some(more)
    }
}

/// How many elements more lie along an axis where both surfaces are known.
fn room(problem: &ContactProblem, axis: usize) -> [usize; 2] {
    let (frame, bodies) = (&problem.frame, &problem.bodies);
    let spacing = frame.spacing()[axis];
    let first = frame.rectangle().corner()[axis] + 0.5 * spacing;
    let last = first + frame.size()[axis] - spacing;
    let [low, high] = bodies
        .iter()
        .map(|body| body.profile.extent()[axis])
        .fold([f64::NEG_INFINITY, f64::INFINITY], |[low, high], [least, most]| {
            [low.max(least), high.min(most)]
        });
    // Readings at the middle of elements are among them.
    [first - low, high - last].map(|left| (left / spacing + ROUNDING) as usize)
}

/// Places agree to this part of an element: far above what rounding makes of a place among thousands of elements.
const ROUNDING: f64 = 1e-6;

/// A range along an axis in blocks, none of them in part within the first `count` elements, and whether it lies there.
fn cut(near: &Range<isize>, count: isize) -> Vec<([isize; 2], bool)> {
    let blocks = |from: isize, to: isize, within: bool| {
        let last = move |first: isize| (first + BLOCK as isize).min(to) - 1;
        (from..to).step_by(BLOCK).map(move |first| ([first, last(first)], within))
    };
    let (below, above) = (blocks(near.start, 0, false), blocks(count, near.end, false));
    below.chain(blocks(0, count, true)).chain(above).collect()
}

/// How deep (m) both surfaces lie at an element, counted from the first one of the frame; how far they have to approach to touch there,
/// where the approach does not close all of a gap.
fn gap(problem: &ContactProblem, place: [isize; 2]) -> f64 {
    let (corner, spacing) = (problem.frame.rectangle().corner(), problem.frame.spacing());
    let [x, y] = [0, 1].map(|axis| corner[axis] + (place[axis] as f64 + 0.5) * spacing[axis]);
    if let Some(wrap) = problem.frame.wrap() {
        let closing = wrap.closing([x, y]);
        return if closing > 0.0 { wrap.gap([x, y]) / closing } else { f64::INFINITY };
    }
    problem.bodies.iter().map(|body| body.profile.recess(x, y)).sum()
}

/// The elements in which readings of measured surfaces lie, counted from the first one of the frame. Shapes given by formulas
/// are looked at in a few places next to them.
fn readings(problem: &ContactProblem, grows: [bool; 2]) -> impl Iterator<Item = [isize; 2]> {
    let frame = &problem.frame;
    let (rectangle, spacing) = (frame.rectangle(), frame.spacing());
    let bodies: [&Body; 2] = problem.bodies.each_ref();
    let [x, y] = [0, 1].map(|axis| {
        let places = bodies.map(|body| body.profile.places()[axis]).concat();
        let measured = !places.is_empty() && grows[axis];
        let across = ACROSS.map(|at| rectangle.centre[axis] + at * rectangle.size[axis]);
        let places = if measured { places } else { across.to_vec() };
        let element =
            |place: &f64| ((place - rectangle.corner()[axis]) / spacing[axis]).floor() as isize;
        (measured, places.iter().map(element).collect::<Vec<_>>())
    });
    let (any, x, y) = (x.0 || y.0, x.1, y.1);
    let all = y.into_iter().flat_map(move |y| x.clone().into_iter().map(move |x| [x, y]));
    all.filter(move |_| any)
}

/// The depth (m) worn off both bodies at an element beyond the frame, counted from its first: of surfaces that pass.
fn worn_beyond(state: &ContactState, place: [isize; 2]) -> f64 {
    let of = |surface: &Surface| {
        let along = surface.grid.passes()?;
        let across = usize::try_from(place[1 - along]).ok()?;
        surface.depth.get(across).copied()
    };
    state.surfaces.iter().filter_map(of).sum()
}

impl Simulation {
    /// What lies beyond its frame.
    pub(super) fn surroundings(&self) -> &Surroundings {
        self.surroundings.get_or_init(|| Surroundings::of(&self.problem))
    }
}

#[cfg(test)]
mod tests {
    use super::{Block, More, OPEN, gap};
    use crate::body::profile::{Cylinder, Sphere};
    use crate::body::{Body, Material};
    use crate::frame::Rectangle;
    use crate::motion::{Control, Sliding, Stepping};
    use crate::problem::ContactState;
    use crate::simulation::Simulation;

    /// A ball on a cylinder, in a frame of 11 x 14 elements off the middle.
    fn simulation() -> Simulation {
        let steel = Material { young: 210e9, poisson: 0.3 };
        let ball = Body::new("ball", Sphere::new(50e-3).unwrap()).material(steel);
        let roller = Body::new("roller", Cylinder::along_y(30e-3).unwrap()).material(steel);
        let sliding = Sliding::new();
        let planned = sliding.over(1.0, Control::Load(1.0), Stepping::Implicit(1.0)).unwrap();
        let rectangle = Rectangle { centre: [0.3e-3, -0.1e-3], size: [1.1e-3, 1.4e-3] };
        Simulation::builder([ball, roller], planned).frame(rectangle, [11, 14]).build().unwrap()
    }

    /// Pressures (Pa) on an ellipse at a side of the frame, and an approach (m).
    fn state(simulation: &Simulation, pressure: f64, approach: f64) -> ContactState {
        let frame = &simulation.problem.frame;
        let on = |pair: usize| {
            let [x, y] = frame.place(pair);
            pressure * (1.0 - (x / 0.3e-3).powi(2) - (y / 0.4e-3).powi(2)).max(0.0).sqrt()
        };
        let pressure = (0..frame.len()).map(on).collect();
        ContactState { pressure, approach, ..ContactState::untouched(frame) }
    }

    /// The same by the sum over all pressures at each element, one by one.
    fn one_by_one(simulation: &Simulation, state: &ContactState) -> Option<More> {
        let (problem, surroundings) = (&simulation.problem, simulation.surroundings());
        let elements = problem.frame.elements();
        let [nx, ny] = elements.map(|count| count as isize);
        let touches = |&[x, y]: &[isize; 2]| {
            let beyond = x < 0 || y < 0 || x >= nx || y >= ny;
            let of = |(pair, pressure): (usize, &f64)| {
                let own = [pair % elements[0], pair / elements[0]].map(|one| one as isize);
                let away = [own[0].abs_diff(x), own[1].abs_diff(y)];
                pressure * problem.compliance.least_displacement(away)
            };
            let opened: f64 = state.pressure.iter().enumerate().map(of).sum();
            let gap = gap(problem, [x, y]) - surroundings.touch;
            let pressed = || state.pressure[(x + nx * y) as usize] > 0.0;
            if beyond { gap + opened < state.approach } else { pressed() }
        };
        let places = (-ny..2 * ny).flat_map(|y| (-nx..2 * nx).map(move |x| [x, y]));
        let reach = places.filter(touches).map(Block::of).reduce(Block::and)?;
        let more = [(0, nx), (1, ny)].map(|(axis, count)| {
            let sides = [OPEN - reach.low[axis], reach.high[axis] + 1 + OPEN - count];
            sides.map(|side| side.max(0) as usize)
        });
        surroundings.roomy(problem, more)
    }

    /// Blocks, and cells of pressures, find the elements beyond the frame that each element by itself finds.
    #[test]
    fn blocks_find_what_each_element_does() {
        let simulation = simulation();
        let mut found = vec![];
        for pressure in [0.0, 1e6, 1e8, 1e9] {
            for approach in [0.2e-6, 2e-6, 8e-6, 25e-6, 60e-6] {
                let state = state(&simulation, pressure, approach);
                let missed = simulation.surroundings().missed(&simulation.problem, &state);
                if pressure > 0.0 {
                    assert_eq!(missed, one_by_one(&simulation, &state), "{pressure} {approach}");
                    found.push(missed);
                } else {
                    assert_eq!(missed, None);
                }
            }
        }
        found.sort_unstable();
        found.dedup();
        assert!(found.len() > 4, "{found:?}");
    }
}
