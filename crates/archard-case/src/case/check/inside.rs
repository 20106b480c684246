//! Whether the points and sections where stresses are asked for lie in their bodies.

use super::Parts;
use crate::case::key::Key;
use crate::case::problem::Problem;
use crate::output::{WORST, WantedStresses};
use archard::body::Body;
use archard::compliance::bem::Surface;
use archard::elastic::PressedHalfSpace;
use archard::motion::{Lever, Passage, Sequence};
use archard::numerics::SAME;

/// Points outside of their bodies, sections without places.
pub(super) fn problems(parts: &Parts<'_>) -> Vec<Problem> {
    let mut problems = vec![];
    let bodies = parts.case.bodies.iter().zip(&parts.case.sections);
    // Sections that largest stresses bring along.
    let asked = parts.case.bodies.iter().zip(&parts.case.stresses);
    let asked = asked.filter(|(_, wanted)| wanted.is_some());
    let mut files: Vec<String> = asked.map(|(body, _)| format!("{}_{WORST}", body.name)).collect();
    for (body, section) in
        bodies.flat_map(|(body, sections)| sections.iter().map(|one| (&body.name, one)))
    {
        let file = format!("{body}_{}", section.name);
        if files.contains(&file) {
            let key = Key::of(["output", "sections", body, &section.name]);
            let message =
                format!("another section is `sections/{file}.vtu` too: give it another name");
            problems.push(Problem::error(key, message));
        }
        files.push(file);
    }
    problems.extend((0..2).flat_map(|which| half_space(parts, which)));
    let wanted = parts.case.points.iter().zip(&parts.case.sections);
    for (body, (points, sections)) in parts.bodies.iter().zip(wanted) {
        let any = !points.is_empty() || !sections.is_empty();
        let Some(finite) = body.finite.as_ref().filter(|_| any) else { continue };
        let slides = parts.motion.slip(1.0) != 0.0 && parts.friction.is_some();
        if slides && finite.mirrored[parts.motion.direction.axis] {
            let key = Key::of(["body", &body.name, "symmetry"]);
            let message = "friction along the motion is not symmetric, and neither are the stresses that are asked for: leave this plane of symmetry out";
            problems.push(Problem::error(key, message));
        }
        let surface = Surface::new(&finite.meshed.mesh, finite.interpolation, finite.mirrored);
        for point in points {
            if surface.depth(point.place.into()).is_none() {
                let key = Key::of(["output", "points", &body.name, &point.name]);
                problems.push(Problem::error(key, "lies outside of the body"));
            }
        }
        for section in sections {
            if let Err(cause) = section.check(&surface) {
                let key = ["output", "sections", &body.name, &section.name, cause.parameter()];
                problems.push(Problem::error(Key::of(key), cause.to_string()));
            }
        }
    }
    problems
}

/// What is asked for of the stresses of a body that its layers do not suit.
fn of_layers(body: &Body, wanted: &WantedStresses) -> Option<Problem> {
    let key = Key::of(["output", "stress", &body.name]);
    let (given, count) = (wanted.layer_strengths.len(), body.layers.len());
    if given > 0 && given != count {
        let message = format!("are those of {given} layers, and the body has {count}");
        return Some(Problem::error(key.child("layer_strengths"), message));
    }
    if count == 0 {
        return None;
    }
    if wanted.fatigue.is_wanted() {
        let message = "is for a body of one material: layers have factors of their own; apply a criterion of your own to `output.points`";
        return Some(Problem::error(key.child("fatigue"), message).at_name());
    }
    if body.material.is_none() && wanted.strength.is_some() {
        let message =
            "is that of the material below the layers, which is rigid: give `layer_strengths`";
        return Some(Problem::error(key.child("yield_strength"), message).at_name());
    }
    let message = "is for a body of one material: layers have stresses of their own from manufacture; add them to what is put out";
    let even = wanted.initial != [0.0; 6];
    even.then(|| Problem::error(key.child("initial"), message).at_name())
}

/// What a half-space has no stresses for.
fn half_space(parts: &Parts<'_>, which: usize) -> Vec<Problem> {
    let case = parts.case;
    let body = &parts.bodies[which];
    let (points, sections) = (&case.points[which], &case.sections[which]);
    let stresses = &case.stresses[which];
    let wanted = [
        ("points", points.is_empty()),
        ("sections", sections.is_empty()),
        ("stress", stresses.is_none()),
    ];
    let key = |name: &str| Key::of(["output", name, &body.name]);
    let Some((name, _)) = wanted.into_iter().find(|(_, none)| !none) else { return vec![] };
    if body.finite.is_some() && !body.has_image() {
        let meshed = "is meshed: its largest stresses are not sought; take `output.points` or `output.sections`";
        let problem = stresses.as_ref().map(|_| Problem::error(key("stress"), meshed).at_name());
        return problem.into_iter().collect();
    }
    let refused = PressedHalfSpace::refuses(parts.bodies.each_ref(), which).or_else(|| {
        let table = matches!(parts.motion.sequence, Sequence::Table(_)) && parts.friction.is_some();
        if case.frame.line && case.frame.elements[1] > 1 {
            Some("touches along a line in strips, each in plane strain by itself: stresses are computed of a line without strips")
        } else if table {
            Some("slides in another direction at each station of the table: with friction, stresses in it are not computed")
        } else {
            None
        }
    });
    if let Some(why) = refused {
        return vec![Problem::error(key(name), why).at_name()];
    }
    if stresses.is_some() && case.frame.periodic && !PressedHalfSpace::halves(case.frame.elements) {
        let message = "repeats itself with the frame: its errors are found on elements of twice and four times the size, so that it needs a multiple of 8 `frame.elements` along each axis";
        return vec![Problem::error(key("stress"), message).at_name()];
    }
    if let Some(problem) = stresses.as_ref().and_then(|wanted| of_layers(body, wanted)) {
        return vec![problem];
    }
    let fatigue = stresses.as_ref().map(|wanted| wanted.fatigue).filter(|own| own.is_wanted());
    let stays = matches!(parts.motion.surfaces[which], Passage::Stays);
    let cycle = stays && parts.motion.increments().is_some_and(|shift| shift.cycle.len() > 1);
    let swings = stresses.as_ref().is_some_and(|wanted| wanted.swinging != [0.0; 6]);
    if swings && !(fatigue.is_some() && cycle && parts.friction.is_some()) {
        let message = "swings with the friction on a body that stays under a contact that goes through a cycle, and is for `fatigue` alone: here is no such friction, or no criterion of fatigue";
        return vec![Problem::error(key("stress").child("swinging"), message).at_name()];
    }
    if let Some(damage) = stresses.as_ref().and_then(|own| own.damage.as_ref()) {
        let key = key("stress").child("damage");
        if !cycle {
            let message = "is a sum over the cycles of a contact under which the body stays, as in fretting: here are none";
            return vec![Problem::error(key, message).at_name()];
        }
        if !stresses.as_ref().is_some_and(|own| own.fatigue.is_wanted_by(&damage.criterion)) {
            let message = format!(
                "takes a criterion of `fatigue`, with its factor: give `fatigue.{}` too",
                damage.criterion
            );
            return vec![Problem::error(key.child("criterion"), message)];
        }
    }
    if let Some(fatigue) = fatigue {
        let key = key("stress").child("fatigue");
        if body.has_image() {
            let message = "is for half-spaces: what the ends of a body add is known at the end of the run alone";
            return vec![Problem::error(key, message).at_name()];
        }
        let passes = matches!(parts.motion.surfaces[which], Passage::Passes(_));
        if !cycle && (!passes || parts.motion.lever_arm() == Some(Lever::Radius)) {
            let message = "is for a body whose points pass through the contact along an axis, one after the other, or stay under it while it goes through a cycle; under this motion they do neither";
            return vec![Problem::error(key, message).at_name()];
        }
        let strength = stresses.as_ref().and_then(|own| own.strength).or(body.known_hardness());
        if fatigue.fatemi_socie.is_some() && strength.is_none() {
            let message = "needs the `yield_strength`, or the hardness of the body";
            return vec![Problem::error(key.child("fatemi_socie"), message).at_name()];
        }
    }
    // Where a body ends, its surface says what lies in it.
    let endless = body.finite.is_none();
    let above = points.iter().filter(|point| endless && point.place[2] > 0.0).map(|point| {
        let message =
            "lies above the surface of the half-space: z is zero there, and negative in it";
        Problem::error(key("points").child(&point.name), message)
    });
    let ground = if body.material.is_some() { f64::INFINITY } else { body.coated() };
    let lower = points.iter().filter(|point| -point.place[2] > ground * (1.0 + SAME)).map(|point| {
        let message = format!(
            "lies below the layers, which end {:.4} mm deep, in rigid ground that has no stress",
            1e3 * ground
        );
        Problem::error(key("points").child(&point.name), message)
    });
    let lost = sections.iter().filter(|_| endless).filter_map(|section| {
        let cause = section.check_half_space().err()?;
        let key = key("sections").child(&section.name).child(cause.parameter());
        Some(Problem::error(key, cause.to_string()))
    });
    above.chain(lower).chain(lost).collect()
}
