//! Whether bodies can touch along a line in plane strain, and move so.

use super::Parts;
use crate::case::key::Key;
use crate::case::problem::Problem;
use archard::motion::Lever;
use archard::simulation::line_of_contact;
use archard::simulation::refusal::of_strips;

/// What is wrong with a line of contact; or with what says that there is one.
pub(super) fn problems(parts: &Parts<'_>) -> Vec<Problem> {
    let body_key =
        |body: usize, name: &str| Key::of(["body", &parts.case.bodies[body].name]).child(name);
    let frame = parts.case.frame;
    if !frame.line {
        let deep = (0..2).filter(|&body| !frame.periodic && parts.bodies[body].depth.is_some());
        return deep.map(|body| not_a_line(body_key(body, "depth"))).collect();
    }
    let rectangle = parts.case.frame.rectangle();
    let wrong = (0..2).filter_map(|body| {
        let invalid = line_of_contact(&parts.bodies[body], &rectangle).err()?;
        Some(Problem::error(body_key(body, &invalid.parameter), invalid.message))
    });
    wrong.chain(across(parts)).collect()
}

fn not_a_line(key: Key) -> Problem {
    let message = "only the bodies of a line of contact have a depth";
    Problem::error(key, message).help("`frame.plane_strain = true` makes the frame one")
}

/// Rolling or swinging along the line, or strips along it that the motion has no need of, or needs.
fn across(parts: &Parts<'_>) -> Option<Problem> {
    let along_the_line = parts.motion.direction.axis == 1;
    if parts.motion.amplitude().is_some() && along_the_line {
        let message = "the line of contact lies along y: surfaces swing along x";
        let key = Key::of(["motion", parts.case.motion.choice.name, "amplitude"]);
        return Some(Problem::error(key, message));
    }
    if parts.motion.table().is_some() && parts.motion.crosses()[1] {
        let message = "the line of contact lies along y: offsets change along x";
        return Some(Problem::error(Key::of(["motion", "table", "file"]), message));
    }
    if parts.motion.lever_arm() == Some(Lever::Radius) {
        let message = "bodies turn about a point, and a line of contact has none";
        let key = Key::of(["motion", parts.case.motion.choice.name]);
        return Some(Problem::error(key, message).at_name());
    }
    let drives = parts.motion.driven(parts.schedule.extent);
    if drives.is_some() && along_the_line {
        let message = "the line of contact lies along y: bodies roll along x";
        let key = Key::of(["motion", parts.case.motion.choice.name, "direction"]);
        return Some(Problem::error(key, message));
    }
    let strips = parts.case.frame.elements[1];
    parts.refused(of_strips(&parts.motion_of_bodies(), Some(strips))?)
}
