//! The results of two gears in mesh.

use archard_gear::{Limit, Mesh, Station, WornFlanks};
use serde_json::{Value, json};

use super::lines::{self, COURSE, Rows, borne};
use super::{Claim, Error, Totals};
use crate::verdict::{self, Verdict};

/// The file of the flanks at the end, a row a station.
const FLANKS: &str = "flanks.csv";
/// What came out of two gears in mesh.
#[derive(Debug, Clone)]
pub struct GearResults {
    /// The names of the gears.
    pub names: [String; 2],
    /// Their indentation hardness (Pa), where it is known.
    pub hardness: [Option<f64>; 2],
    /// Their Young's moduli (Pa).
    pub moduli: [f64; 2],
    /// The gears under load.
    pub mesh: Mesh,
    /// Their flanks.
    pub worn: WornFlanks,
    /// Meshes of a flank of the first gear that were asked for.
    pub wanted: f64,
    /// The depths that end them.
    pub limits: Vec<Limit>,
}

impl GearResults {
    /// Peak pressure (Pa) of all stations, of new flanks and of worn ones.
    pub fn peak_pressure(&self) -> f64 {
        let stations = self.mesh.stations();
        let all = stations.iter().chain(&self.worn.stations);
        all.map(|station| station.peak_pressure).fold(0.0, f64::max)
    }

    /// The flanks at the end (SI) station by station, by the names of columns.
    pub fn flanks(&self) -> Rows {
        let Self { names, mesh, worn, .. } = self;
        let row = |(index, (station, new)): (usize, (&Station, Station))| {
            let diameters = mesh.pair.diameters(station.place);
            let of = |gear: usize| {
                let name = &names[gear];
                [
                    (format!("diameter_{name}_m"), diameters[gear]),
                    (format!("slid_{name}_m"), station.slide(gear)),
                    (format!("wear_depth_{name}_m"), worn.last().depths[gear][index]),
                    (format!("error_of_wear_depth_{name}_m"), worn.errors[gear][index]),
                ]
            };
            let mut row = vec![
                ("path_m".to_owned(), station.place),
                ("new_load_share".to_owned(), new.load / mesh.load),
                ("load_share".to_owned(), station.load / mesh.load),
                ("new_peak_pressure_Pa".to_owned(), new.peak_pressure),
                ("peak_pressure_Pa".to_owned(), station.peak_pressure),
                ("half_width_m".to_owned(), station.half_width),
            ];
            row.extend(of(0).into_iter().chain(of(1)));
            row
        };
        worn.stations.iter().zip(mesh.stations()).enumerate().map(row).collect()
    }

    /// The deepest wear (m) of both gears step by step, by the names of columns.
    pub fn course(&self) -> Rows {
        lines::course("meshes", &self.names, &self.worn.course)
    }

    /// The largest error of the deepest depths, relative to them.
    pub fn relative_error(&self) -> f64 {
        let relative = |gear: usize| {
            let (_, [depth, error]) = self.worn.deepest(gear);
            if depth > 0.0 { error / depth } else { 0.0 }
        };
        relative(0).max(relative(1))
    }

    /// Whether a gear is deepest within a half-width of the contact from where it ends at a tip: what of its width lies beyond bears nothing,
    /// and the edge of the tip bears more.
    pub fn deepest_at_a_tip(&self, gear: usize) -> bool {
        let (at, [depth, _]) = self.worn.deepest(gear);
        let station = self.worn.stations[at];
        let pair = &self.mesh.pair;
        // The way over a flank for that along the path.
        let over = station.radii[gear] / pair.gears[gear].base_radius();
        let off = (station.place - pair.start).min(pair.end - station.place);
        depth > 0.0 && off * over < station.half_width
    }
}

/// The files of two gears but for the case, by their names in the folder.
pub fn gear_files() -> Vec<String> {
    vec![FLANKS.to_owned(), COURSE.to_owned()]
}

/// Writes the results of two gears, and judges them.
///
/// # Errors
/// If a file cannot be removed or written.
pub fn write_gear(
    claim: &mut Claim,
    case_toml: &str,
    results: &GearResults,
    totals: &Totals,
) -> Result<Verdict, Error> {
    let files = [(FLANKS, results.flanks()), (COURSE, results.course())];
    let verdict = judged(results);
    lines::write(claim, case_toml, &files, verdict, totals, || summary(results))
}

/// What can be believed.
fn judged(results: &GearResults) -> Verdict {
    let GearResults { names, hardness, moduli, worn, mesh, .. } = results;
    let peak = results.peak_pressure();
    let mut lines = vec![];
    for gear in 0..2 {
        let share = |station: &Station| station.half_width / station.radii[gear];
        let share = mesh.stations().iter().chain(&worn.stations).map(share).fold(0.0, f64::max);
        lines.extend(borne(&names[gear], (hardness[gear], moduli[gear]), peak, share));
    }
    let at_tips: Vec<&str> =
        (0..2).filter(|gear| results.deepest_at_a_tip(*gear)).map(|gear| &*names[gear]).collect();
    if !at_tips.is_empty() {
        lines.push(verdict::tip(&at_tips.join("` and `")));
    }
    lines.push(verdict::shared(mesh.unshared()));
    lines.push(verdict::flanks(mesh.displaced(worn) / mesh.pair.pitch));
    lines.push(verdict::measured(results.relative_error(), "deepest wear of the flanks"));
    lines.extend(worn.life.map(|(_, error)| {
        verdict::measured(error / worn.last().passages, "meshes to the first limit")
    }));
    Verdict { lines }
}

fn summary(results: &GearResults) -> Value {
    let GearResults { names, mesh, worn, wanted, limits, .. } = results;
    let gear = |which: usize| {
        let (at, [depth, error]) = worn.deepest(which);
        let place = worn.stations[at].place;
        let [volume, missed] = worn.volumes[which];
        json!({
            "name": names[which],
            "wear_depth_m": depth,
            "error_of_wear_depth_m": error,
            "at_path_m": place,
            "at_diameter_m": mesh.pair.diameters(place)[which],
            "worn_volume_of_a_flank_m3": volume,
            "error_of_worn_volume_of_a_flank_m3": missed,
        })
    };
    let life = lines::life(("gear", "meshes"), names, worn.life, worn.last());
    json!({
        "contact_ratio": mesh.pair.contact_ratio(),
        "load_N_per_m": mesh.load,
        "peak_pressure_Pa": results.peak_pressure(),
        "meshes": worn.last().passages,
        "meshes_asked_for": wanted,
        "gears": [gear(0), gear(1)],
        "limits": limits.len(),
        "life": life,
    })
}
