//! What laws of temperature need of wheel and rail.

use archard::friction::Circumstance;
use archard::wear::Input;
use archard_rail::contact::Bodies;

use super::WheelRailCase;
use crate::case::key::Key;
use crate::case::problem::Problem;

/// Refuses tables of heat that say nothing together, and laws of temperature without them.
pub(super) fn hold(case: &WheelRailCase, bodies: &Bodies) -> Result<(), Problem> {
    let asked = bodies.friction.inputs().contains(&Circumstance::Temperature)
        || bodies.asks_for(Input::Temperature);
    if !asked && bodies.thermal == [None, None] {
        return Ok(());
    }
    let names = [&case.wheel.name, &case.rail.name];
    for (thermal, name) in bodies.thermal.iter().zip(names) {
        let key = Key::of(["body", name, "thermal"]);
        let Some(thermal) = thermal else {
            let message = "how the body conducts heat: wheel and rail share that of friction";
            let example = "for example `thermal = { conductivity = \"50 W/(m K)\", diffusivity = \"13 mm^2/s\", temperature = \"20 degC\" }`";
            return Err(Problem::missing(key, message).help(example));
        };
        if thermal.share.is_some() {
            let message = "follows from the `thermal` tables of both bodies: leave it out";
            return Err(Problem::error(key.child("share"), message));
        }
        if asked && thermal.temperature.is_none() {
            let message = "how warm the body is away from the contact, since a law depends on the temperature";
            return Err(Problem::missing(key.child("temperature"), message));
        }
    }
    Ok(())
}
