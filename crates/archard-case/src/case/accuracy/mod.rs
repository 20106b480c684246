//! One number in: from the accuracy that a case asks for, the frame, its elements and the tolerance of the steps.
//!
//! The order of the error says how many elements the first output needs. This is a first guess; [`archard::accuracy`] measures what
//! came of it, and refines it.

mod companions;
mod increments;
mod locate;
mod refined;
mod wider;

pub use refined::GridRange;

use super::check::Parts;
use super::definition::{Case, FrameCase, MOST};
use super::key::Key;
use super::problem::Problem;
use super::resolved::RunnableCase;
use super::tree::{Entry, Item, Node, Table};
use archard::accuracy::{COARSEST, FEWEST, TOLERANCE, UNWORN, admitted, has_tip, order};
use archard::body::Body;
use archard::estimate::{Estimate, Estimator};
use archard::motion::{Lever, MOTIONS, Slip};
use archard::numerics::counted;
use locate::Lost;

/// Extent of the frame relative to the contact that is foreseen.
const BESIDE: f64 = 1.15;
/// Elements at each side that stay open.
const OPEN: f64 = 4.0;
/// What of a case was chosen for its accuracy.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Chose {
    /// The size.
    pub size: bool,
    /// The place.
    pub place: bool,
    /// The elements.
    pub elements: bool,
    /// The increments of a cycle.
    pub increments: bool,
    /// The tolerance of the steps.
    pub tolerance: bool,
}

impl Chose {
    /// Whether it chose what a line of a printed case says.
    fn says(self, line: &str) -> bool {
        let key = line.split(" = ").next().unwrap_or_default();
        match key {
            "frame.centre" => self.place,
            "frame.size" => self.size,
            "frame.elements" | "frame.doubles" => self.elements,
            key if key.starts_with("motion.") => {
                self.increments && key.ends_with(".increments")
                    || self.tolerance && key.ends_with(".tolerance")
            }
            _ => false,
        }
    }
}

impl RunnableCase {
    /// Whether a printed case is this one, apart from what was chosen for its accuracy.
    pub fn is_printed(&self, toml: &str) -> bool {
        let given = |toml: &str| -> Vec<String> {
            toml.lines().filter(|line| !self.chose.says(line)).map(str::to_owned).collect()
        };
        given(toml) == given(&self.case.to_string())
    }
}

/// Puts the tolerance of the steps into the table of the motion where it takes one and says nothing of its steps; whether it did.
pub(super) fn imply(table: &mut Table) -> bool {
    let Some(accuracy) = table.get("accuracy").map(|entry| entry.node.clone()) else {
        return false;
    };
    let Some(Item::Table(motion)) = table.get_mut("motion").map(|entry| &mut entry.node.item)
    else {
        return false;
    };
    let [Entry { name, node: Node { item: Item::Table(motion), .. }, .. }] = &mut motion.0[..]
    else {
        return false;
    };
    let Some(choice) = MOTIONS.iter().find(|choice| choice.name == *name) else { return false };
    let takes = |name: &str| choice.parameters.iter().any(|parameter| parameter.name == name);
    let says = |name: &str| motion.get(name).is_some();
    // Increments are gone through once unless cycles are asked for.
    let jumps = !takes("increments") || says("cycles");
    if !takes("tolerance") || !jumps {
        return false;
    }
    if ["tolerance", "step", "jump", "scheme"].into_iter().any(says) {
        return false;
    }
    // What is wrong with the accuracy is said once.
    let value = match accuracy.item {
        Item::Number { value, .. } if admitted(value) => TOLERANCE * value,
        _ => COARSEST,
    };
    let item = Item::Number { text: value.to_string(), value, whole: false };
    let node = Node { item, at: accuracy.at.clone() };
    motion.0.push(Entry { name: "tolerance".to_owned(), at: accuracy.at, node });
    true
}

/// The case with a frame where it has none, or has no size or no elements; its tolerance may be chosen already.
pub(super) fn choose(mut case: Case, tolerance: bool) -> Result<(Case, Chose), Problem> {
    let Some(accuracy) = case.accuracy else {
        if case.frame.size[0] == 0.0 {
            let chose = Chose { size: true, ..Chose::default() };
            let Frame { frame, found, .. } = chosen(&case, COARSEST, chose)?;
            case.frame = frame;
            return Ok((case, Chose { place: found, ..chose }));
        }
        return Ok((case, Chose::default()));
    };
    let chose = Chose {
        size: case.frame.size[0] == 0.0,
        place: false,
        elements: case.frame.elements[0] == 0 && case.frame.element[0] == 0.0,
        increments: increments::choose(&mut case, |parts| across(accuracy, parts)),
        tolerance,
    };
    let given = |name: &str| case.motion.values.number(name);
    // A jump of one cycle jumps over none.
    let fixed = ["step", "jump"].into_iter().find(|name| match given(name) {
        Some(jump) => *name == "step" || jump > 1.0,
        None => false,
    });
    if let Some(name) = fixed {
        let key = Key::of(["motion", case.motion.choice.name, name]);
        let message =
            format!("the error of a fixed {name} is not known, and an `accuracy` is requested");
        return Err(Problem::error(key, message).help("leave it out, or give a `tolerance`"));
    }
    let turns = |parts: &Parts<'_>| parts.motion.lever_arm() == Some(Lever::Radius);
    if Parts::of(&case).is_ok_and(|parts| turns(&parts) && parts.wears()) {
        let message = "bodies that turn do not wear on their axis, where the pressure grows without limit as elements become smaller: no error of it can be stated";
        let help = "leave it out, and give the frame its `elements` and the motion a `tolerance`";
        return Err(Problem::error(Key::of(["accuracy"]), message).help(help));
    }
    if let Some(loose) = given(companions::TOLERANCE).filter(|one| *one > TOLERANCE * COARSEST) {
        let key = Key::of(["motion", case.motion.choice.name, companions::TOLERANCE]);
        let message =
            format!("coarser runs take 8 times {loose}, which is too much to estimate its error");
        let help = format!("give {:.3} at most, or leave it out", TOLERANCE * COARSEST);
        return Err(Problem::error(key, message).help(help));
    }
    if let Some(count) = increments::of_rubbing(&case).filter(|count| *count < FEWEST) {
        let key = Key::of(["motion", case.motion.choice.name, "increments"]);
        let message = format!("the error of {count} increments cannot be estimated from fewer");
        let help = format!("take {} at least, or leave it out", FEWEST);
        return Err(Problem::error(key, message).help(help));
    }
    if !(chose.size || chose.elements) {
        return Ok((case, chose));
    }
    let Frame { frame, doubles, found } = chosen(&case, accuracy, chose)?;
    (case.frame, case.doubles) = (frame, doubles);
    Ok((case, Chose { place: found, ..chose }))
}

/// A frame that was chosen.
struct Frame {
    frame: FrameCase,
    /// From where on it is twice as wide.
    doubles: Vec<f64>,
    /// Whether its place was looked for: it is the middle where closed forms know the contact.
    found: bool,
}

fn chosen(case: &Case, accuracy: f64, chose: Chose) -> Result<Frame, Problem> {
    let parts =
        Parts::of(case).map_err(|error| Problem::error(Key::default(), error.to_string()))?;
    if let Some(problem) = parts.unfit() {
        return Err(problem);
    }
    let foreseen = |progress: f64| parts.estimate(&Estimator::default(), progress);
    let outputs = case.output.places(parts.schedule.extent);
    let first = foreseen(outputs.first().copied().unwrap_or_default());
    let last = foreseen(parts.schedule.extent);
    let unworn = first.contact;
    let reaches = [&first, &last].map(Estimate::reach);
    let finite = |reach: &[f64; 2]| {
        let axes = if case.frame.line { 1 } else { 2 };
        reach[..axes].iter().all(|half| half.is_finite() && *half > 0.0)
    };
    let mut frame = case.frame;
    let mut found = false;
    let (first, reach) = match reaches.map(|reach| reach.filter(finite)) {
        [Some(first), Some(reach)] => (first, reach),
        _ => {
            let contact = locate::locate(case, &parts).map_err(lost)?;
            found = chose.size && frame.centre == [0.0; 2];
            if found {
                frame.centre = contact.centre;
            }
            let half = contact.size.map(|size| 0.5 * size);
            (half, half)
        }
    };
    let across = across(accuracy, &parts);
    let asked = frame.element;
    let element = [0, 1].map(|axis| {
        if asked[axis] > 0.0 {
            return asked[axis];
        }
        let unworn = unworn.map_or(f64::INFINITY, |contact| contact.semi_axes[axis]);
        2.0 * (first[axis] / across).min(unworn / UNWORN)
    });
    let axes = if frame.line { 1 } else { 2 };
    let odd = usize::from(has_tip(&parts.bodies));
    for axis in 0..axes {
        if chose.size {
            frame.size[axis] = around(BESIDE * reach[axis], element[axis]);
            let held = locate::within(frame.rectangle(), Body::known(&parts.bodies));
            (frame.centre[axis], frame.size[axis]) = (held.centre[axis], held.size[axis]);
        }
        if chose.elements {
            frame.elements[axis] = counted(frame.size[axis] / element[axis], odd);
        }
    }
    if asked[0] > 0.0 {
        frame.count();
    }
    let one = Frame { frame, doubles: vec![], found };
    let all = chose.size && chose.elements;
    let wider = all.then(|| wider::widening(&parts, &one, element, across)).flatten();
    let chosen = wider.unwrap_or(one);
    for axis in 0..axes {
        let elements = chosen.frame.elements[axis] as f64;
        if elements > MOST as f64 {
            let allows = accuracy * (elements / MOST as f64).powf(order(&parts.bodies));
            let message = format!(
                "{accuracy} would take {elements} elements along {}, and {MOST} are the most: they allow about {allows:.1e}",
                ["x", "y"][axis]
            );
            return Err(Problem::error(Key::of(["accuracy"]), message));
        }
    }
    Ok(chosen)
}

/// What to do where a contact is not found.
fn lost(why: Lost) -> Problem {
    let frame = Key::of(["frame"]);
    let help = "give `frame.size` and `frame.elements`: runs on coarser grids estimate their error";
    match why {
        Lost::AtTheEnd(axis) => {
            let message = format!(
                "the unworn contact reaches the end of a surface along {}: what would touch beyond is not known",
                ["x", "y"][axis]
            );
            Problem::missing(frame, message)
                .help("measure more of it, or place it so that it touches within")
        }
        Lost::Nowhere => {
            let message = "is not known: the contact of these bodies does not end";
            Problem::missing(frame, message).help(help)
        }
    }
}

/// The side (m) of a frame that holds so much (m) to either side of its middle, and open elements of that length (m).
fn around(half: f64, element: f64) -> f64 {
    2.0 * (half + OPEN * element)
}

/// Elements across the contact of the first output.
fn across(accuracy: f64, parts: &Parts<'_>) -> f64 {
    // Friction decides what slips.
    let partly = matches!(parts.motion.slip, Slip::Sought(_)) && parts.friction.is_some();
    let least = if partly { 24.0 } else { UNWORN };
    let asked = if order(&parts.bodies) == 2.0 { 2.4 / accuracy.sqrt() } else { 0.8 / accuracy };
    asked.max(least)
}
