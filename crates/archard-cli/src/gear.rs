//! Two gears in mesh, through to their result folder.

use std::time::Instant;

use archard_case::ResolvedGear;
use archard_case::output::write_gear;

use crate::failure::Failure;
use crate::interrupt::Watch;
use crate::number::four;
use crate::say::say;
use crate::underway::solved;
use crate::verdict;

/// Wears the flanks, and writes what came out into the folder that is held.
pub fn run(
    resolved: &ResolvedGear,
    watch: &Watch,
    [quiet, verbose]: [bool; 2],
) -> Result<(), Failure> {
    let ResolvedGear { case, warnings, .. } = resolved;
    let start = Instant::now();
    let results = case.solve().map_err(|problem| Failure::wrong(problem.title()))?;
    let totals = solved(start, warnings);
    let Some(mut claim) = watch.release() else {
        return Err(Failure::wrong("the run has no folder"));
    };
    let judged = write_gear(&mut claim, &case.to_string(), &results, &totals)
        .map_err(|error| Failure::wrong(error.to_string()))?;
    if !quiet {
        let line = |name: &str, value: String| say(&format!("{name:<17} {value}"));
        let (worn, pair) = (&results.worn, &results.mesh.pair);
        line("contact ratio", four(pair.contact_ratio()))?;
        line("peak pressure", format!("{} MPa", four(1e-6 * results.peak_pressure())))?;
        line("meshes", four(worn.last().passages))?;
        for (gear, name) in results.names.iter().enumerate() {
            if results.mesh.laws[gear].is_none() {
                continue;
            }
            let (at, [depth, error]) = worn.deepest(gear);
            let diameter = pair.diameters(worn.stations[at].place)[gear];
            let [volume, missed] = worn.volumes[gear];
            line(
                "wear depth",
                format!(
                    "{} um  +- {}  of `{name}`, at a diameter of {:.3} mm",
                    four(1e6 * depth),
                    four(1e6 * error),
                    1e3 * diameter
                ),
            )?;
            line(
                "worn volume",
                format!("{} mm^3  +- {}  of a flank", four(1e9 * volume), four(1e9 * missed)),
            )?;
        }
        match worn.life {
            Some((limit, error)) => {
                let of =
                    format!("{} um of `{}`", four(1e6 * limit.depth), results.names[limit.body]);
                line(
                    "life",
                    format!("{} meshes  +- {}, to {of}", four(worn.last().passages), four(error)),
                )?;
            }
            None if !results.limits.is_empty() => {
                line("life", format!("more than {} meshes", four(results.wanted)))?;
            }
            None => {}
        }
        line("time", format!("{:.2} s", totals.seconds))?;
        line("results", claim.dir().display().to_string())?;
        line("verdict", verdict::headline(&judged).to_string())?;
        verdict::say_lines(&judged, verbose)?;
    }
    verdict::judge(&judged, claim.dir(), quiet)
}
