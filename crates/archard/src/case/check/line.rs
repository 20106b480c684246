//! Whether bodies can touch along a line in plane strain, and move so.

use super::Parts;
use crate::case::key::Key;
use crate::case::problem::Problem;
use crate::frame::ContactFrame;
use crate::simulation::{line_of_contact, repeats};

/// What is wrong with a line of contact; or with what says that there is one.
pub(super) fn problems(parts: &Parts<'_>) -> Vec<Problem> {
    let body_key =
        |body: usize, name: &str| Key::of(["body", &parts.case.bodies[body].name]).child(name);
    if !parts.case.frame.line && !parts.case.frame.periodic {
        let deep = (0..2).filter(|&body| parts.bodies[body].depth.is_some());
        return deep.map(|body| not_a_line(body_key(body, "depth"))).collect();
    }
    let rectangle = parts.case.frame.rectangle();
    if !parts.case.frame.line {
        return apart(parts).into_iter().collect();
    }
    let wrong = (0..2).filter_map(|body| {
        let invalid = line_of_contact(&parts.bodies[body], &rectangle).err()?;
        Some(Problem::error(body_key(body, &invalid.parameter), invalid.message))
    });
    wrong.chain(across(parts)).chain(apart(parts)).collect()
}

/// What keeps surfaces from repeating themselves, if they are to.
fn apart(parts: &Parts<'_>) -> Option<Problem> {
    let case = &parts.case.frame;
    let profiles = parts.bodies.each_ref().map(|body| &*body.profile);
    let (rectangle, elements) = (case.rectangle(), case.elements);
    let key = Key::of(["frame", "periodic"]);
    if parts.case.is_meshed() {
        let message = "meshed bodies do not repeat themselves";
        return case.periodic.then(|| Problem::error(key, message).at_name());
    }
    let frame = match (case.periodic, case.line) {
        (false, _) => return None,
        (_, true) => ContactFrame::line(rectangle, elements[0], profiles),
        (_, false) => ContactFrame::uniform(rectangle, elements, profiles),
    };
    // A profile that does not reach over the frame is told elsewhere.
    let invalid = repeats(&parts.motion, &frame.ok()?).err()?;
    Some(Problem::error(key, invalid.message).at_name())
}

fn not_a_line(key: Key) -> Problem {
    let message = "only the bodies of a line of contact have a depth";
    Problem::error(key, message).help("`frame.plane_strain = true` makes the frame one")
}

/// Rolling or swinging along the line, or spin, which slips differently all along it.
fn across(parts: &Parts<'_>) -> Option<Problem> {
    let sliding = parts.motion.sliding().filter(|sliding| sliding.swing.is_some());
    if sliding.is_some_and(|sliding| sliding.direction.axis == 1) {
        let message = "the line of contact lies along y: surfaces swing along x";
        let key = Key::of(["motion", parts.case.motion.choice.name, "amplitude"]);
        return Some(Problem::error(key, message));
    }
    let rolling = parts.motion.rolling()?;
    let (name, message) = if rolling.direction.axis == 1 {
        ("direction", "the line of contact lies along y: bodies roll along x")
    } else if rolling.spin != 0.0 {
        ("spin", "the slip of bodies that spin is not the same all along a line of contact")
    } else {
        return None;
    };
    Some(Problem::error(Key::of(["motion", parts.case.motion.choice.name, name]), message))
}
