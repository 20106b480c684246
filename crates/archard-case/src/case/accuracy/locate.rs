//! The contact of bodies that no closed form knows, measured ones above all: they are pressed on each other on few elements,
//! in a window that grows where the contact meets its edge and closes in on it where it is small.

use crate::case::check::Parts;
use crate::case::definition::{Case, FrameCase};
use archard::body::Body;
use archard::frame::{Rectangle, extent};
use archard::motion::Control;
use archard::numerics::SAME;
use archard::solve::{self, ConjugateGradient, Status, Step};

/// Elements of the window along an axis, and those of a line of contact. A choice of cost, as the others are: the frame that
/// follows from a window grows with the contact, and its error is estimated on coarser ones.
const WINDOW: usize = 64;
const OF_A_LINE: usize = 512;
/// Share of the window that the contact fills at least.
const FILLED: f64 = 0.25;
/// Size of the next window relative to the contact in this one.
const AROUND: f64 = 1.6;
/// Windows, at most.
const WINDOWS: usize = 40;
/// Size of the first window where surfaces have no end, relative to the root of load over modulus and to the approach.
const BY_LOAD: f64 = 10.0;
const BY_APPROACH: f64 = 100.0;

/// Where both surfaces are known: the least and the largest place along x and y (m).
pub(super) type Known = [[f64; 2]; 2];

/// Why a contact is not found.
pub(super) enum Lost {
    /// It meets the end of a surface along that axis.
    AtTheEnd(usize),
    /// It fills every window, or nothing touches.
    Nowhere,
}

/// The part of a rectangle in which the surfaces are known; one that lies in the middle but for rounding lies there.
pub(super) fn within(rectangle: Rectangle, known: Known) -> Rectangle {
    let corner = rectangle.corner();
    let ends = [0, 1].map(|axis| {
        let [low, high] = known[axis];
        [corner[axis].max(low), (corner[axis] + rectangle.size[axis]).min(high)]
    });
    let centre = |[low, high]: [f64; 2]| {
        let centre = 0.5 * (low + high);
        if centre.abs() > SAME * (high - low) { centre } else { 0.0 }
    };
    Rectangle { centre: ends.map(centre), size: ends.map(|[low, high]| high - low) }
}

/// The smallest box around the unworn contact that is centred where its load acts; of a line of contact, with its length
/// along y.
pub(super) fn locate(case: &Case, parts: &Parts<'_>) -> Result<Rectangle, Lost> {
    let known = Body::known(&parts.bodies);
    let axes = if case.frame.line { 1 } else { 2 };
    let mut window = first(case, parts, known);
    for _ in 0..WINDOWS {
        let Contact { around, meets, element } = press(case, window).ok_or(Lost::Nowhere)?;
        let corner = window.corner();
        let ends = [0, 1].map(|axis| [corner[axis], corner[axis] + window.size[axis]]);
        let mut next = ends;
        let mut filled = true;
        for axis in 0..axes {
            for side in 0..2 {
                if !meets[axis][side] {
                    continue;
                }
                let sign = [-1.0, 1.0][side];
                let moved = ends[axis][side] + sign * window.size[axis];
                next[axis][side] = moved.clamp(known[axis][0], known[axis][1]);
                if next[axis][side] == ends[axis][side] {
                    return Err(Lost::AtTheEnd(axis));
                }
            }
            filled &= around.size[axis] >= FILLED * window.size[axis];
        }
        if next == ends && filled {
            return Ok(around);
        }
        if next == ends {
            for axis in 0..axes {
                let size = AROUND * (around.size[axis] + 2.0 * element[axis]);
                let half = 0.5 * size.min(window.size[axis]);
                let middle = around.centre[axis];
                next[axis] =
                    [(middle - half).max(ends[axis][0]), (middle + half).min(ends[axis][1])];
            }
        }
        let centre = next.map(|[low, high]| 0.5 * (low + high));
        window = within(Rectangle { centre, size: next.map(|[low, high]| high - low) }, known);
    }
    Err(Lost::Nowhere)
}

/// The first window: where the surfaces are known, or a guess where they have no end.
fn first(case: &Case, parts: &Parts<'_>, known: Known) -> Rectangle {
    let guess = match parts.schedule.control {
        Control::Load(load) if case.frame.line => {
            BY_LOAD * load / case.frame.size[1] / parts.contact_modulus()
        }
        Control::Load(load) => BY_LOAD * (load / parts.contact_modulus()).sqrt(),
        Control::Approach(approach) => BY_APPROACH * approach,
    };
    let about = |axis: usize| {
        let [low, high] = known[axis];
        let size = if (high - low).is_finite() { high - low } else { guess };
        let middle = match (low.is_finite(), high.is_finite()) {
            (true, true) => 0.5 * (low + high),
            (true, false) => low + 0.5 * size,
            (false, true) => high - 0.5 * size,
            (false, false) => 0.0,
        };
        (middle, size)
    };
    let [(x, width), (y, height)] = [about(0), about(1)];
    if case.frame.line {
        return Rectangle { centre: [x, 0.0], size: [width, case.frame.size[1]] };
    }
    Rectangle { centre: [x, y], size: [width, height] }
}

/// The contact in a window.
struct Contact {
    /// The box around its pairs.
    around: Rectangle,
    /// Which sides of the window it meets, the lower ones first.
    meets: [[bool; 2]; 2],
    /// Size of an element (m).
    element: [f64; 2],
}

/// Presses the bodies together in a window; `None` where that does not work.
fn press(case: &Case, window: Rectangle) -> Option<Contact> {
    let mut case = case.clone();
    let elements = if case.frame.line { [OF_A_LINE, case.frame.elements[1]] } else { [WINDOW; 2] };
    let Rectangle { centre, size } = window;
    case.frame = FrameCase { centre, size, elements, ..case.frame };
    let simulation = case.build().ok()?;
    let problem = &simulation.problem;
    let step = Step {
        compliance: &*problem.compliance,
        gap: problem.frame.gap(),
        addition: &vec![0.0; problem.frame.len()],
        elements,
        measure: problem.frame.measure(),
        control: simulation.schedule.control,
        hardness: problem.hardness(),
    };
    let outcome = solve::press(&ConjugateGradient::default(), &step, None);
    let element = case.frame.spacing();
    match outcome.status {
        Status::Converged => {}
        Status::FrameFull => {
            return Some(Contact { around: window, meets: [[true; 2]; 2], element });
        }
        Status::OutOfIterations => return None,
    }
    // Elements may be too large to see an approach: the bodies touch where they are closest.
    let gap = problem.frame.gap();
    let least = gap.iter().copied().fold(f64::INFINITY, f64::min);
    let closest = || gap.iter().map(|gap| f64::from(u8::from(*gap <= least))).collect();
    let touches = outcome.pressure.iter().any(|pressure| *pressure > 0.0);
    let bears: Vec<f64> = if touches { outcome.pressure } else { closest() };
    let [columns, rows] = extent(elements, |pair| bears[pair] > 0.0)?;
    let corner = window.corner();
    let ends = [(0, columns), (1, rows)].map(|(axis, range)| {
        let place = |index: usize| corner[axis] + index as f64 * element[axis];
        let meets = [range.start == 0, range.end == elements[axis]];
        ([place(range.start), place(range.end)], meets)
    });
    let all: f64 = bears.iter().sum();
    let centre = [0, 1].map(|axis| {
        let moment = |(pair, bears): (usize, &f64)| bears * problem.frame.place(pair)[axis];
        bears.iter().enumerate().map(moment).sum::<f64>() / all
    });
    let size = [0, 1].map(|axis| {
        let [low, high] = ends[axis].0;
        2.0 * (centre[axis] - low).max(high - centre[axis])
    });
    let around = Rectangle { centre, size };
    Some(Contact { around, meets: ends.map(|(_, meets)| meets), element })
}
