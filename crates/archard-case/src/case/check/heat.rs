//! What is wrong or doubtful about the heat of friction, in words.

use super::words::three;
use super::{Forecast, Parts};
use crate::case::key::Key;
use crate::case::problem::Problem;
use crate::verdict;
use archard::closed_form::flash_temperature::FAST;
use archard::friction::{Circumstance, Friction};
use archard::problem::{Heating, NoTemperature};
use archard::wear::Input;

/// All that is wrong or doubtful about it.
pub(super) fn problems(parts: &Parts<'_>, forecast: &Forecast) -> Vec<Problem> {
    let mut problems = match Heating::of(&parts.bodies, &parts.motion) {
        Ok(heating) => idle(parts, heating),
        Err(reason) => useless(parts, reason),
    };
    problems.extend(slow(parts, forecast));
    problems.extend(coated(parts));
    problems
}

/// Bodies with layers, whose heat flows as if there were none.
fn coated(parts: &Parts<'_>) -> impl Iterator<Item = Problem> {
    let warmed = |&body: &usize| {
        let body = &parts.bodies[body];
        body.thermal.is_some() && !body.layers.is_empty()
    };
    (0..2).filter(warmed).map(|body| {
        let message = "flash temperatures are those of a body without its layers";
        Problem::warning(thermal(parts, body), message).at_name()
    })
}

/// The key of what a body says of heat.
fn thermal(parts: &Parts<'_>, body: usize) -> Key {
    Key::of(["body", &parts.bodies[body].name, "thermal"])
}

/// Whether a law depends on the temperature: then its own errors say what is missing.
fn asked(parts: &Parts<'_>) -> bool {
    let mut laws = parts.bodies.iter().filter_map(|body| body.wear.as_ref());
    let grips = |law: &dyn Friction| law.inputs().contains(&Circumstance::Temperature);
    laws.any(|law| law.inputs().contains(&Input::Temperature))
        || parts.friction.as_deref().is_some_and(grips)
}

/// Data that the motion does not need, besides those that it does.
fn idle(parts: &Parts<'_>, heating: Heating) -> Vec<Problem> {
    if parts.friction.is_none() {
        let warmed = (0..2).find(|&body| heating.warms(body)).unwrap_or_default();
        let message = "has no effect without a `friction` table: nothing makes heat";
        let problem = Problem::warning(thermal(parts, warmed), message).at_name();
        return if asked(parts) { vec![] } else { vec![problem] };
    }
    let stays = |&body: &usize| parts.bodies[body].thermal.is_some() && !heating.warms(body);
    let idle = (0..2).filter(stays).map(|body| {
        let message = "has no effect on the body that stays in contact: the flash temperature is that of the one that passes";
        Problem::warning(thermal(parts, body), message).at_name()
    });
    idle.collect()
}

/// Data from which no temperature follows.
fn useless(parts: &Parts<'_>, reason: NoTemperature) -> Vec<Problem> {
    let given = (0..2).find(|&body| parts.bodies[body].thermal.is_some()).unwrap_or_default();
    let problem = match reason {
        NoTemperature::NoBody => return vec![],
        NoTemperature::NoShare { body } => {
            let rolls = parts.motion.passing().is_none_or(|passing| passing.bodies == [true; 2]);
            let help = if rolls {
                "give the other body a `thermal` table, too, or the `share` of the heat that flows into this one"
            } else {
                "give the `share`: with 1, all of it, the flash temperature is the highest there can be"
            };
            let message = "is missing: which share of the heat of friction flows into this body";
            return vec![Problem::missing(thermal(parts, body).child("share"), message).help(help)];
        }
        NoTemperature::TwoShares { body } => {
            let message = "follows from the `thermal` tables of both bodies: leave it out, or the table of the other body";
            return vec![Problem::error(thermal(parts, body).child("share"), message).at_name()];
        }
        NoTemperature::NoSpeed => {
            let message = "has no effect without the speed of the motion";
            let name = parts.case.motion.choice.name;
            Problem::warning(thermal(parts, given), message)
                .help(format!("give `motion.{name}.speed`"))
        }
        NoTemperature::Stays { body } => {
            let name = &parts.bodies[body].name;
            let message = format!(
                "has no effect: the body that passes the contact is `{name}`, and it has none"
            );
            Problem::warning(thermal(parts, given), message)
        }
        _ => Problem::warning(thermal(parts, given), "has no effect in this motion")
            .help(format!("{}", NoTemperature::NoStream)),
    };
    if asked(parts) { vec![] } else { vec![problem.at_name()] }
}

/// A contact that is passed too slowly for the flash temperature of fast surfaces.
fn slow(parts: &Parts<'_>, forecast: &Forecast) -> Option<Problem> {
    let peclet = forecast.estimate.warmth?.peclet;
    if peclet >= FAST || parts.friction.is_none() {
        return None;
    }
    let key = Key::of(["motion", parts.case.motion.choice.name, "speed"]);
    let [number, least] = [peclet, FAST].map(three);
    let message = format!(
        "the Peclet number of the contact is {number}: the flash temperature of fast surfaces holds from {least} on"
    );
    Some(if asked(parts) {
        Problem::error(key, message).help("laws that go by the temperature need a faster motion")
    } else {
        Problem::warning(key, message).judged(verdict::heat(peclet).subject)
    })
}
