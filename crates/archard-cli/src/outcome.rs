//! What came out of a run, in words.

use std::path::Path;

use archard::body::Body;
use archard::case::Forecast;
use archard::motion::{Rolling, Shift};
use archard::output::Totals;
use archard::simulation::history::{
    self, CREEPAGE, ERRORS, FORCE, FRICTIONAL_POWER, MASS_LOSS, STICK_AREA, WEAR_DEPTH,
    WORN_SECTION, WORN_VOLUME, of_body,
};
use archard::simulation::{Effort, Simulation};

use crate::failure::Failure;
use crate::number::{count, energy, four, mass};
use crate::progress::Follower;
use crate::say::say;
use crate::standards;

/// Says what came out and where it is.
pub fn say_all(
    (simulation, forecast): (&Simulation, &Forecast),
    follower: &Follower,
    totals: &Totals,
    effort: Effort,
    dir: &Path,
) -> Result<(), Failure> {
    let number = |column: &str, factor: f64| four(follower.number(column).unwrap_or(0.0) * factor);
    for (what, column, factor, unit) in [
        ("peak pressure", history::PEAK_PRESSURE, 1e-6, "MPa"),
        ("approach", history::APPROACH, 1e6, "um"),
        ("contact area", history::CONTACT_AREA, 1e6, "mm^2"),
    ] {
        let error = error(follower, &[column]);
        say(&format!("{what:<18}{} {unit}{error}", number(column, factor)))?;
    }
    if let Some(rolling) = simulation.problem.motion.rolling() {
        rolled(simulation, rolling, follower)?;
    }
    if let Some(shift) = simulation.problem.motion.shift() {
        shifted(simulation, shift, follower, effort)?;
    }
    if let Some(largest) = follower.number(history::FLASH_TEMPERATURE) {
        let mean = number(history::MEAN_FLASH_TEMPERATURE, 1.0);
        say(&format!("flash temperature {} K at most, {mean} K in the mean", four(largest)))?;
    }
    if simulation.problem.wears() {
        let (depth, of_depth) = (number(WEAR_DEPTH, 1e6), error(follower, &[WEAR_DEPTH]));
        say(&format!("wear depth        {depth} um{of_depth}"))?;
        for Body { name, .. } in &simulation.problem.bodies {
            let column = of_body(WORN_VOLUME, name);
            if let Some(volume) = follower.number(&column) {
                let (volume, error) = (four(volume * 1e9), error(follower, &[&column]));
                say(&format!("worn volume       {volume} mm^3{error} off `{name}`"))?;
            }
            if let Some(loss) = follower.number(&of_body(MASS_LOSS, name)) {
                say(&format!("mass loss         {} of `{name}`", mass(loss)))?;
            }
            let column = of_body(WORN_SECTION, name);
            if let Some(section) = follower.number(&column) {
                let (section, error) = (four(section * 1e6), error(follower, &[&column]));
                say(&format!("worn section      {section} mm^2{error} off `{name}`"))?;
            }
        }
        for equivalent in &forecast.equivalents {
            say(equivalent.to_string().trim_end())?;
        }
        standards::say_all(&simulation.problem, &follower.last)?;
    }
    let Effort { steps, solves, .. } = effort;
    say(&format!("time              {:.2} s, {steps} steps, {solves} solves", totals.seconds))?;
    say(&format!("results           {}", dir.display()))
}

/// Says how the bodies creep at last and, where there is friction, what they pass on.
fn rolled(simulation: &Simulation, rolling: &Rolling, follower: &Follower) -> Result<(), Failure> {
    let number = |column: &str| follower.number(column).unwrap_or(0.0);
    let creepage = along_and_across(CREEPAGE.map(number), "");
    say(&format!("creepage          {creepage}{}", error(follower, &CREEPAGE)))?;
    if simulation.problem.friction.is_none() {
        return Ok(());
    }
    // Where nothing is passed on, what is left of a force is rounding, and so is its error.
    const NONE: f64 = 1e-9;
    let nothing = NONE * number(history::LOAD);
    let [x, y] = FORCE.map(number).map(|force| if force.abs() > nothing { force } else { 0.0 });
    let units = [rolling.direction.forward(), rolling.direction.lateral()];
    let force = along_and_across(units.map(|unit| x * unit[0] + y * unit[1]), " N");
    let error = if [x, y] == [0.0; 2] { String::new() } else { error(follower, &FORCE) };
    say(&format!("creep force       {force}{error}, on `{}`", simulation.problem.bodies[0].name))?;
    let intensity = number(FRICTIONAL_POWER) / number(history::CONTACT_AREA);
    say(&format!("T gamma / A       {} N/mm^2, over the contact", four(intensity * 1e-6)))?;
    stuck(follower)
}

/// Says how large an area sticks at last.
fn stuck(follower: &Follower) -> Result<(), Failure> {
    let area = four(follower.number(STICK_AREA).unwrap_or(0.0) * 1e6);
    say(&format!("stick area        {area} mm^2{}", error(follower, &[STICK_AREA])))
}

/// Says what sticks at last, what friction dissipated, and how many cycles were computed where not all were.
fn shifted(
    simulation: &Simulation,
    shift: &Shift,
    follower: &Follower,
    effort: Effort,
) -> Result<(), Failure> {
    if simulation.problem.friction.is_some() {
        stuck(follower)?;
        let [last, all] = effort.dissipated.map(energy);
        let last =
            if last == all { String::new() } else { format!(", {last} of it in the last cycle") };
        say(&format!("dissipated        {all}{last}"))?;
    }
    let cycles = simulation.schedule.extent / shift.period();
    if effort.true_cycles as f64 >= cycles - 0.5 {
        return Ok(());
    }
    say(&format!("cycles            {}, {} of them computed", count(cycles), effort.true_cycles))
}

/// What is stated of a quantity with these components, relative to it; nothing where no accuracy is asked for.
fn error(follower: &Follower, columns: &[&str]) -> String {
    let size = |components: Vec<f64>| components.into_iter().fold(0.0, f64::hypot);
    let stated = |column: &&str| {
        let of = ERRORS.iter().filter_map(|of| follower.number(&format!("{of}{column}")));
        of.sum::<f64>()
    };
    let value = size(columns.iter().filter_map(|column| follower.number(column)).collect());
    let percent = 100.0 * size(columns.iter().map(stated).collect()) / value;
    if !percent.is_normal() {
        return String::new();
    }
    let decimals = (1.0 - percent.log10().floor()).clamp(0.0, 4.0) as usize;
    format!(" +- {percent:.decimals$} %")
}

/// Two components by the direction of rolling; one that is nothing but rounding beside the other is
/// left out.
fn along_and_across([along, across]: [f64; 2], unit: &str) -> String {
    const ROUNDING: f64 = 1e-6;
    if across.abs() <= ROUNDING * along.abs() {
        format!("{}{unit} along", four(along))
    } else if along.abs() <= ROUNDING * across.abs() {
        format!("{}{unit} across", four(across))
    } else {
        format!("{}{unit} along, {}{unit} across", four(along), four(across))
    }
}
