//! The results of a cam and its follower.

use archard_gear::Limit;
use archard_gear::cam::{Cam, Station, WornCam};
use serde_json::{Value, json};

use super::lines::{self, COURSE, Rows, borne};
use super::{Claim, Error, Totals};
use crate::verdict::{self, Verdict};

/// The file of the cam at the end, a row an angle.
const CAM: &str = "cam.csv";
/// The file of the follower at the end, a row a place.
const FOLLOWER: &str = "follower.csv";

/// What came out of a cam and its follower.
#[derive(Debug, Clone)]
pub struct CamResults {
    /// The names of cam and follower.
    pub names: [String; 2],
    /// Their indentation hardness (Pa), where it is known.
    pub hardness: [Option<f64>; 2],
    /// Their Young's moduli (Pa).
    pub moduli: [f64; 2],
    /// The cam on its follower.
    pub cam: Cam,
    /// How they have worn.
    pub worn: WornCam,
    /// Turns that were asked for.
    pub wanted: f64,
    /// The depths that end them.
    pub limits: Vec<Limit>,
}

impl CamResults {
    /// Peak pressure (Pa) of a turn.
    pub fn peak_pressure(&self) -> f64 {
        self.cam.stations().iter().map(|station| station.peak_pressure).fold(0.0, f64::max)
    }

    /// Depth (m) of a body and its error, node by node.
    fn depths(&self, body: usize) -> impl Iterator<Item = [(String, f64); 2]> {
        let name = &self.names[body];
        let both = self.worn.last().depths[body].iter().zip(&self.worn.errors[body]);
        both.map(move |(depth, error)| {
            [
                (format!("wear_depth_{name}_m"), *depth),
                (format!("error_of_wear_depth_{name}_m"), *error),
            ]
        })
    }

    /// The cam at the end, angle by angle, by the names of columns (SI but for the angle).
    pub fn around(&self) -> Rows {
        let row = |(angle, depths): (&f64, [(String, f64); 2])| {
            let station = self.cam.station(*angle);
            let known = [
                ("angle_deg", angle.to_degrees()),
                ("lift_m", station.touch.lift),
                ("place_m", station.touch.place),
                ("load_N_per_m", station.load),
                ("peak_pressure_Pa", station.peak_pressure),
                ("half_width_m", station.half_width),
            ];
            let known = known.map(|(name, value)| (name.to_owned(), value));
            known.into_iter().chain(depths).collect()
        };
        self.worn.nodes[0].iter().zip(self.depths(0)).map(row).collect()
    }

    /// The follower at the end, place by place, by the names of columns (SI).
    pub fn face(&self) -> Rows {
        let row = |(place, depths): (&f64, [(String, f64); 2])| {
            [("place_m".to_owned(), *place)].into_iter().chain(depths).collect()
        };
        self.worn.nodes[1].iter().zip(self.depths(1)).map(row).collect()
    }

    /// The deepest wear (m) of both step by step, by the names of columns.
    pub fn course(&self) -> Rows {
        lines::course("turns", &self.names, &self.worn.course)
    }
}

/// The files of a cam and its follower but for the case, by their names in the folder.
pub fn cam_files() -> Vec<String> {
    [CAM, FOLLOWER, COURSE].map(str::to_owned).to_vec()
}

/// Writes the results of a cam and its follower, and judges them.
///
/// # Errors
/// If a file cannot be removed or written.
pub fn write_cam(
    claim: &mut Claim,
    case_toml: &str,
    results: &CamResults,
    totals: &Totals,
) -> Result<Verdict, Error> {
    let files = [(CAM, results.around()), (FOLLOWER, results.face()), (COURSE, results.course())];
    let verdict = judged(results);
    lines::write(claim, case_toml, &files, verdict, totals, || summary(results))
}

/// What can be believed.
fn judged(results: &CamResults) -> Verdict {
    let CamResults { names, hardness, moduli, cam, worn, .. } = results;
    let (peak, stations) = (results.peak_pressure(), cam.stations());
    let mut lines = vec![];
    for body in 0..2 {
        let share = |station: &Station| station.half_width / cam.radii(station)[body].abs();
        let share = stations.iter().map(share).fold(0.0, f64::max);
        lines.extend(borne(&names[body], (hardness[body], moduli[body]), peak, share));
    }
    let widest = stations.iter().map(|station| station.half_width).fold(0.0, f64::max);
    lines.push(verdict::length(cam.width / (2.0 * widest)));
    for (body, name) in names.iter().enumerate() {
        let (_, [depth, error]) = worn.deepest(body);
        if depth > 0.0 {
            lines.push(verdict::reshaped(worn.changed[body], name));
            lines.push(verdict::measured(error / depth, &format!("deepest wear of `{name}`")));
        }
    }
    lines.extend(worn.life.map(|(_, error)| {
        verdict::measured(error / worn.last().passages, "turns to the first limit")
    }));
    Verdict { lines }
}

fn summary(results: &CamResults) -> Value {
    let CamResults { names, worn, wanted, limits, .. } = results;
    let body = |which: usize| {
        let (at, [depth, error]) = worn.deepest(which);
        let [volume, missed] = worn.volumes[which];
        let node = worn.nodes[which][at];
        let (place, value) =
            if which == 0 { ("at_angle_deg", node.to_degrees()) } else { ("at_place_m", node) };
        json!({
            "name": names[which],
            "wear_depth_m": depth,
            "error_of_wear_depth_m": error,
            place: value,
            "worn_volume_m3": volume,
            "error_of_worn_volume_m3": missed,
            "changed_by_wear": worn.changed[which],
        })
    };
    json!({
        "peak_pressure_Pa": results.peak_pressure(),
        "turns": worn.last().passages,
        "turns_asked_for": wanted,
        "bodies": [body(0), body(1)],
        "limits": limits.len(),
        "life": lines::life(("body", "turns"), names, worn.life, worn.last()),
    })
}
