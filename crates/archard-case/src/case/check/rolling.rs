//! What is doubtful about a rolling case, in words.

use super::Parts;
use super::words::{length, size_list_up, three};
use crate::case::key::Key;
use crate::case::problem::Problem;
use archard::body::Body;
use archard::estimate::Contact;
use archard::motion::{Control, Drive, Drives, Sequence};

/// All that is wrong or doubtful about rolling.
pub(super) fn problems(parts: &Parts<'_>, contact: Option<&Contact>) -> Vec<Problem> {
    let Some(drives) = &parts.motion_of_bodies().driven(parts.schedule.extent) else {
        return vec![];
    };
    let mut problems = wear(parts, drives);
    problems.extend(friction(parts, drives));
    problems.extend(narrow(parts, contact));
    problems.extend(worn_radius(parts, drives));
    problems.extend(over_the_rim(parts));
    problems
}

/// A key of the motion.
fn key(parts: &Parts<'_>, name: &str) -> Key {
    motion(parts).child(name)
}

fn motion(parts: &Parts<'_>) -> Key {
    Key::of(["motion", parts.case.motion.choice.name])
}

/// Wear that cannot come about, or rolling on and on without any.
fn wear(parts: &Parts<'_>, drives: &Drives) -> Vec<Problem> {
    let raised = parts.motion.sequence == Sequence::Raised;
    let goes_on = parts.schedule.extent > 0.0 && !raised;
    let worn: Vec<_> = parts.case.bodies.iter().filter(|body| body.wears()).collect();
    let mut problems = vec![];
    if is_still(parts, drives) {
        let end = if goes_on { ", and nothing will wear" } else { "" };
        let message = format!(
            "no creepage, force or spin is given: nothing slips between bodies of one elasticity{end}"
        );
        problems.push(Problem::warning(motion(parts), message).at_name());
    }
    if goes_on && worn.is_empty() {
        let message =
            "neither body has a `wear` table: nothing will wear, and every step is the same";
        problems.push(
            Problem::warning(key(parts, "revolutions"), message)
                .help("`revolutions = 0` is enough for the contact alone"),
        );
    }
    let reason = match (raised, goes_on) {
        (true, _) => "raising the creepage wears nothing",
        (_, false) => "nothing wears without `revolutions`",
        _ => return problems,
    };
    problems.extend(worn.into_iter().map(|body| {
        let message = format!("{reason}: this body will not wear");
        Problem::warning(Key::of(["body", &body.name, "wear"]), message)
    }));
    problems
}

/// Whether nothing drives bodies that roll on each other as one.
fn is_still(parts: &Parts<'_>, drives: &Drives) -> bool {
    parts.alike() && drives.both().into_iter().all(Drive::is_still) && drives.spin == 0.0
}

/// Friction that is missing, or bears less than it has to.
fn friction(parts: &Parts<'_>, drives: &Drives) -> Option<Problem> {
    let force = |drive: Drive| if let Drive::Force(force) = drive { force } else { 0.0 };
    let [along, across] = drives.both().map(force);
    let asked = along.hypot(across);
    let name = if along == 0.0 { "lateral_force" } else { "force" };
    if parts.friction.is_none() && asked > 0.0 {
        let message = "nothing bears a force along the surfaces without a `friction` table";
        return Some(Problem::error(key(parts, name), message));
    }
    if parts.friction.is_none() {
        let message = "without a `friction` table the bodies slide freely: no traction, and all of the creepage slips";
        return Some(Problem::warning(motion(parts), message).at_name());
    }
    let Control::Load(load) = parts.schedule.control else { return None };
    let given = drives.both().map(|one| matches!(one, Drive::Force(_)));
    let direction = parts.motion.direction;
    let [forward, lateral] = [direction.forward(), direction.lateral()];
    let force = [0, 1].map(|axis| along * forward[axis] + across * lateral[axis]);
    let bears = parts.subject().largest_force(force, given)? * load;
    (asked > 0.0 && asked >= bears).then(|| {
        let both =
            if along != 0.0 && across != 0.0 { " together with `lateral_force`" } else { "" };
        let message = format!(
            "{} N{both} is no less than friction bears under this load: {} N",
            three(asked),
            three(bears)
        );
        Problem::error(key(parts, name), message)
    })
}

/// A zone without a free element behind the contact: particles are rubbed until they have left the last
/// pair under pressure.
fn narrow(parts: &Parts<'_>, contact: Option<&Contact>) -> Option<Problem> {
    let axis = parts.motion.direction.axis;
    let half_width = contact?.semi_axes[axis];
    let frame = parts.case.frame;
    let needed = 2.0 * (half_width + frame.spacing()[axis]);
    let size = frame.rectangle().about_origin()[axis];
    let cut = half_width.is_finite() && 2.0 * half_width <= size;
    (cut && needed > size && !parts.grows()).then(|| {
        let message = format!(
            "leaves less than an element free before and behind the contact, which is {} long: slip where particles leave it would be lost",
            length(2.0 * half_width)
        );
        let mut size = frame.size;
        size[axis] = needed;
        Problem::warning(parts.frame_key("size"), message)
            .help(format!("take about `size = {}`", size_list_up(size)))
    })
}

/// A creepage that is to follow worn radii of bodies that have none.
fn worn_radius(parts: &Parts<'_>, drives: &Drives) -> Option<Problem> {
    let axis = parts.motion.direction.axis;
    let without = |body: &&Body| {
        body.wear.is_some() && body.curvatures().is_none_or(|both| both[axis] == 0.0)
    };
    let body = parts.bodies.iter().filter(|_| drives.worn_radius).find(without)?;
    let name = &body.name;
    let lack = match body.curvatures() {
        Some(_) => format!("the body `{name}` has no radius along the direction of rolling"),
        None => {
            format!("the radius of the body `{name}` along the direction of rolling is not known")
        }
    };
    let message = format!("{lack}: its wear will not change the creepage");
    Some(Problem::warning(key(parts, "radius"), message))
}

/// Discs that roll across their rim.
fn over_the_rim(parts: &Parts<'_>) -> Option<Problem> {
    let axis = parts.motion.direction.axis;
    let bodies = parts.case.bodies.iter().zip(&parts.bodies);
    let mut discs = bodies.filter(|(case, _)| case.profile.choice.name == "disc");
    let (body, _) = discs.find(|(_, body)| {
        body.profile.curvatures().is_some_and(|both| both[1 - axis].abs() > both[axis].abs())
    })?;
    let message =
        format!("discs roll along x: this way the body `{}` rolls across its rim", body.name);
    (axis == 1).then(|| Problem::warning(key(parts, "direction"), message))
}
