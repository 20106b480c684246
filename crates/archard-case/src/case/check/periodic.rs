//! Whether surfaces can repeat themselves with the frame, if they are to.

use super::Parts;
use crate::case::key::Key;
use crate::case::problem::Problem;
use archard::frame::ContactFrame;
use archard::simulation::repeats;

/// What keeps surfaces from repeating themselves, if they are to.
pub(super) fn problem(parts: &Parts<'_>) -> Option<Problem> {
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
        (_, true) => ContactFrame::line(rectangle, elements, profiles),
        (_, false) => ContactFrame::uniform(rectangle, elements, profiles),
    };
    // A profile that does not reach over the frame is told elsewhere.
    let invalid = repeats(&parts.motion, &frame.ok()?).err()?;
    Some(Problem::error(key, invalid.message).at_name())
}
