//! Two gears in mesh, through to their result folder.

use archard_case::ResolvedGear;
use archard_case::output::{GearResults, write_gear};

use crate::failure::Failure;
use crate::interrupt::Watch;
use crate::line_contact::{self, Lines};
use crate::number::four;

/// Wears the flanks, and writes what came out into the folder that is held.
pub fn run(
    ResolvedGear { case, warnings, .. }: &ResolvedGear,
    watch: &Watch,
    told: [bool; 2],
) -> Result<(), Failure> {
    let write = |claim: &mut _, results: &_, totals: &_| {
        write_gear(claim, &case.to_string(), results, totals)
    };
    line_contact::run(warnings, watch, told, || case.solve(), write, lines)
}

fn lines(results: &GearResults) -> Lines {
    let GearResults { names, mesh, worn, wanted, limits, .. } = results;
    let mut lines = vec![
        ("contact ratio", four(mesh.pair.contact_ratio())),
        ("peak pressure", format!("{} MPa", four(1e-6 * results.peak_pressure()))),
        ("meshes", four(worn.last().passages)),
    ];
    for (gear, name) in names.iter().enumerate().filter(|(gear, _)| mesh.laws[*gear].is_some()) {
        let (at, deepest) = worn.deepest(gear);
        let diameter = mesh.pair.diameters(worn.stations[at].place)[gear];
        let place = format!("at a diameter of {:.3} mm", 1e3 * diameter);
        lines.push(line_contact::depth(deepest, name, &place));
        lines.push(line_contact::volume(worn.volumes[gear], "a flank"));
    }
    let life = worn.life.map(|(limit, error)| (limit.body, [limit.depth, error]));
    let passages = [worn.last().passages, *wanted];
    lines.extend(line_contact::life(names, (life, !limits.is_empty()), passages, "meshes"));
    lines
}
