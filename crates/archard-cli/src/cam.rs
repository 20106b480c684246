//! A cam and its follower, through to their result folder.

use archard_case::ResolvedCam;
use archard_case::output::{CamResults, write_cam};

use crate::failure::Failure;
use crate::interrupt::Watch;
use crate::line_contact::{self, Lines};
use crate::number::four;

/// Wears cam and follower, and writes what came out into the folder that is held.
pub fn run(
    ResolvedCam { case, warnings, .. }: &ResolvedCam,
    watch: &Watch,
    told: [bool; 2],
) -> Result<(), Failure> {
    let write = |claim: &mut _, results: &_, totals: &_| {
        write_cam(claim, &case.to_string(), results, totals)
    };
    line_contact::run(warnings, watch, told, || case.solve(), write, lines)
}

fn lines(results: &CamResults) -> Lines {
    let CamResults { names, cam, worn, wanted, limits, .. } = results;
    let mut lines = vec![
        ("peak pressure", format!("{} MPa", four(1e-6 * results.peak_pressure()))),
        ("turns", four(worn.last().passages)),
    ];
    for (body, name) in names.iter().enumerate().filter(|(body, _)| cam.laws[*body].is_some()) {
        let (at, deepest) = worn.deepest(body);
        let node = worn.nodes[body][at];
        let place = match body {
            0 => format!("at {:.2} deg", node.to_degrees()),
            _ => format!("{:.4} mm from its middle", 1e3 * node),
        };
        lines.push(line_contact::depth(deepest, name, &place));
        lines.push(line_contact::volume(worn.volumes[body], &format!("`{name}`")));
    }
    let life = worn.life.map(|(limit, error)| (limit.body, [limit.depth, error]));
    let passages = [worn.last().passages, *wanted];
    lines.extend(line_contact::life(names, (life, !limits.is_empty()), passages, "turns"));
    lines
}
