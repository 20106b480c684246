//! Whether surfaces that fret stay opposite each other or swing past each other: chosen where the case does not say.

use std::fmt;

use super::Parts;
use super::words::three;
use crate::case::definition::{Case, MOST};
use crate::case::key::Key;
use crate::case::problem::Problem;
use archard::parameters::Value;

/// Share of the half width of a contact beyond which an amplitude is not small: surfaces that stay then wear some percent
/// too deep.
pub(super) const FAR: f64 = 0.3;
/// Share of an amplitude that the bodies may follow elastically where all of the contact is to slip: an estimate from the
/// approach.
const FOLLOWED: f64 = 0.5;
/// Values that surfaces which swing do not take.
const OTHERS: [&str; 5] =
    ["force_amplitude", "phase", "load_amplitude", "load_phase", "increments"];

/// How the surfaces of bodies that fret meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surfaces {
    /// Whether they swing past each other; otherwise they stay.
    pub swing: bool,
    /// The amplitude over the half width of the unworn contact along it.
    pub ratio: f64,
}

impl Surfaces {
    /// Of a motion with one amplitude; `None` of others, and where nothing gives the width of the contact.
    pub(super) fn of(parts: &Parts<'_>) -> Option<Self> {
        if parts.case.motion.choice.name != "fretting" {
            return None;
        }
        let (axis, amplitude) = along(parts.case)?;
        let half_width = parts.subject().contact(parts.schedule.control)?.semi_axes[axis];
        Some(Self { swing: parts.motion.amplitude().is_some(), ratio: amplitude / half_width })
    }
}

impl fmt::Display for Surfaces {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let how = if self.swing { "swing past" } else { "stay opposite" };
        let ratio = three(self.ratio);
        write!(f, "{how} each other: the amplitude is {ratio} of the half width of the contact")
    }
}

/// A surface that swings or roams so far that its elements are more than a machine holds.
pub(super) fn too_long(parts: &Parts<'_>) -> Option<Problem> {
    let (frame, motion) = (&parts.case.frame, parts.case.motion.choice.name);
    let name = match (parts.motion.table(), parts.motion.amplitude()) {
        (Some(_), _) => "file",
        (_, Some(_)) if motion == "fretting" => "amplitude",
        (_, Some(_)) => "stroke",
        _ => return None,
    };
    let elements = |body: usize| {
        let reach = parts.motion.reach(body).size;
        let along = |axis: usize| reach[axis] / frame.spacing()[axis] + frame.elements[axis] as f64;
        along(0) * along(1)
    };
    let elements = elements(0).max(elements(1));
    (elements > (MOST * MOST) as f64).then(|| {
        let message = format!("the surface that moves under the contact would take {elements:.1e} elements of the frame's size: {:.1e} are the most", (MOST * MOST) as f64);
        Problem::error(Key::of(["motion", motion, name]), message)
    })
}

/// The axis and the size (m) of an amplitude along one axis.
fn along(case: &Case) -> Option<(usize, f64)> {
    match case.motion.values.pair("amplitude")? {
        [x, 0.0] if x != 0.0 => Some((0, x.abs())),
        [0.0, y] if y != 0.0 => Some((1, y.abs())),
        _ => None,
    }
}

/// Lets surfaces swing that wear, slip all over and move far against the contact, where the case does not say how they meet.
pub(in crate::case) fn settle(mut case: Case) -> Case {
    let values = &case.motion.values;
    let open = case.motion.choice.name == "fretting"
        && values.get("surfaces").is_none()
        && OTHERS.iter().all(|name| values.get(name).is_none())
        && !case.is_meshed();
    if open && Parts::of(&case).is_ok_and(|parts| swings(&parts)) {
        case.motion.values.insert("surfaces", Value::Word("swing".to_owned()));
    }
    case
}

fn swings(parts: &Parts<'_>) -> bool {
    let Some((axis, amplitude)) = along(parts.case) else { return false };
    let subject = parts.subject();
    let (Some(contact), true) = (subject.contact(parts.schedule.control), parts.wears()) else {
        return false;
    };
    let along = if axis == 0 { [1.0, 0.0] } else { [0.0, 1.0] };
    let friction = match &parts.friction {
        None => Some(0.0),
        Some(_) => subject.largest_force(along, [false; 2]),
    };
    let (Some(friction), Some(approach)) = (friction, contact.approach) else { return false };
    let crosses = axis == 1 && parts.case.frame.line;
    !crosses
        && amplitude > FAR * contact.semi_axes[axis]
        && friction * approach < FOLLOWED * amplitude
}
