//! A wheel on its rail, through to its result folder.

use std::time::Instant;

use archard_case::ResolvedWheelRail;
use archard_case::output::{RailContact, Totals, contacts_verdict, write_contacts};

use crate::failure::Failure;
use crate::interrupt::Watch;
use crate::number::four;
use crate::say::say;
use crate::underway::command;
use crate::verdict;

/// Finds the contacts and writes them into the folder that is held.
pub fn run(
    resolved: &ResolvedWheelRail,
    watch: &Watch,
    [quiet, verbose]: [bool; 2],
) -> Result<(), Failure> {
    let ResolvedWheelRail { case, warnings, .. } = resolved;
    let wrong = |error: &dyn std::error::Error| Failure::wrong(error.to_string());
    let start = Instant::now();
    let contacts = case.solve().map_err(|error| wrong(&error))?;
    let totals = Totals {
        seconds: start.elapsed().as_secs_f64(),
        threads: rayon::current_num_threads(),
        warnings: warnings.iter().map(|warning| warning.title()).collect(),
        failure: None,
        command: Some(command()),
    };
    let Some(mut claim) = watch.release() else {
        return Err(Failure::wrong("the run has no folder"));
    };
    write_contacts(&mut claim, &case.to_string(), &contacts, &totals)
        .map_err(|error| wrong(&error))?;
    let judged = contacts_verdict(&contacts);
    if !quiet {
        contacts.iter().try_for_each(summarize)?;
        say(&format!("time              {:.2} s", totals.seconds))?;
        say(&format!("results           {}", claim.dir().display()))?;
        say(&format!("verdict           {}", verdict::headline(&judged)))?;
        verdict::say_lines(&judged, verbose)?;
    }
    verdict::judge(&judged, claim.dir())
}

/// Says what came out on a side.
fn summarize(contact: &RailContact) -> Result<(), Failure> {
    for (index, patch) in contact.patches.iter().enumerate() {
        let (one, error) = (&patch.values, &patch.errors);
        let line = |name: &str, value: f64, off: f64, factor: f64, unit: &str| {
            let (value, off) = (four(factor * value), four(factor * off));
            say(&format!("  {name:<16}{value} {unit}  +- {off}"))
        };
        say(&format!("{} wheel, patch {}", contact.name(), index + 1))?;
        line("y on the rail", one.y_rail, error.y_rail, 1e3, "mm")?;
        line("y on the wheel", one.y_wheel, error.y_wheel, 1e3, "mm")?;
        line("contact angle", one.contact_angle, error.contact_angle, 1.0, "rad")?;
        line("normal force", one.normal_force, error.normal_force, 1e-3, "kN")?;
        line("force along x", one.force_x, error.force_x, 1e-3, "kN")?;
        line("force across", one.force_s, error.force_s, 1e-3, "kN")?;
        line("peak pressure", one.peak_pressure, error.peak_pressure, 1e-6, "MPa")?;
        line("contact area", one.contact_area, error.contact_area, 1e6, "mm^2")?;
    }
    Ok(())
}
