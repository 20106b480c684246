//! The results of a wheel and a rail that wear over a route.

use archard_rail::file::{Format, write};
use archard_rail::setup::Side;
use archard_rail::wear::{
    ASKED, COLUMNS, CONICITY, Economy, Plan, ReprofilingCut, RouteResult, SideCourse, WornProfile,
    WornSide, error_of,
};
use serde_json::{Value, json};

use super::Error;
use super::manifest::Manifest;
use super::rail_service::{RailEconomy, RailLife, RailPlan};
use super::table::{Table, number};
use crate::verdict::{self, Line};

/// The file of worn depths over the profiles.
const WEAR: &str = "wear.csv";
/// The file of how dimensions change over the route.
const DIMENSIONS: &str = "dimensions.csv";
/// Names of the bodies in rows and files, in the order of [`RailWear::wears`].
const BODIES: [&str; 2] = ["wheel", "rail"];

/// What was worn off over a route.
#[derive(Debug, Clone)]
pub struct RailWear {
    /// The profiles, and how they became so.
    pub travelled: RouteResult,
    /// Distance (m), and the number of axles.
    pub extent: [f64; 2],
    /// Which of wheel and rail wear.
    pub wears: [bool; 2],
    /// Equivalent conicity of new and of worn profiles, and the error of the second; `None` where a wheelset does not steer
    /// itself back.
    pub conicity: [Option<f64>; 3],
    /// Which of wheel and rail may crack.
    pub cracks: [bool; 2],
    /// When the wheels are turned again; none where nobody asks for it.
    pub plans: Vec<RailPlan>,
    /// How wheels run farthest that are turned to thinner flanges; none where nobody asks for it.
    pub economies: Vec<RailEconomy>,
    /// When the wheels reach their limits, those first that are reached first; none without limits.
    pub lives: Vec<RailLife>,
    /// The formats in which the profiles of the wheel and of the rail were read.
    pub formats: [Format; 2],
}

/// A profile that wears: its body, its side, and the name of its file.
type Wears = (usize, usize, String);

/// The profiles that wear.
fn profiles(wears: [bool; 2], sides: &[Side], formats: [Format; 2]) -> Vec<Wears> {
    let bodies = (0..2).filter(|&body| wears[body]);
    let of_body = |body: usize| {
        sides.iter().enumerate().map(move |(at, side)| {
            let extension = extension(formats[body]);
            (body, at, format!("worn_{}_{}.{extension}", BODIES[body], side.name()))
        })
    };
    bodies.flat_map(of_body).collect()
}

impl RailWear {
    /// The profiles that wear.
    fn profiles(&self) -> Vec<Wears> {
        let sides: Vec<Side> = self.travelled.worn.iter().map(|worn| worn.side).collect();
        profiles(self.wears, &sides, self.formats)
    }

    /// What is told after each step of a side, by the names of columns (SI), each with its error.
    pub fn rows(&self) -> Vec<(Side, Vec<(String, f64)>)> {
        let course = self.travelled.course();
        // What nobody asked for has no column.
        let known = |at: usize| {
            !ASKED.contains(&COLUMNS[at])
                || course.iter().any(|(told, _)| !told.values[at].is_nan())
        };
        let known: Vec<bool> = (0..COLUMNS.len()).map(known).collect();
        let row = |(told, errors): (SideCourse, Vec<f64>)| {
            let [distance, axles] = self.extent.map(|all| all * told.progress);
            let mut row = vec![("distance_m".to_owned(), distance), ("axles".to_owned(), axles)];
            let all = COLUMNS.iter().zip(&told.values).zip(&errors).zip(&known);
            for ((name, value), error) in all.filter(|(_, known)| **known).map(|(one, _)| one) {
                row.push(((*name).to_owned(), *value));
                row.push((format!("error_of_{name}"), *error));
            }
            (told.side, row)
        };
        course.iter().cloned().map(row).collect()
    }

    /// The largest error of a worn area, relative to it.
    pub fn relative_error(&self) -> f64 {
        let relative = |(body, side, _): (usize, usize, String)| {
            let area = |worn: &[WornSide]| profile(&worn[side], body).area();
            self.travelled.error(area) / area(&self.travelled.worn)
        };
        self.profiles().into_iter().map(relative).fold(0.0, f64::max)
    }
}

impl RailWear {
    /// The largest stated error, relative, of how far wheels run in all, of what turning costs, and of damage by cracks.
    pub(super) fn worst_of_service(&self) -> Option<Line> {
        let of_plan = |RailPlan { plan, .. }: &RailPlan| {
            let of = |plan: &Plan| {
                [(plan.depth, "radius that turning costs"), (plan.life, "distance run in all")]
            };
            plan.as_ref().map(of).into_iter().flatten()
        };
        let sides = self.travelled.worn.len();
        let course = self.travelled.course();
        let ends = course[course.len() - sides..].iter().flat_map(|(told, errors)| {
            let cracks = COLUMNS.iter().zip(told.values.iter().zip(errors));
            let cracks = cracks.filter(|(name, _)| **name != CONICITY && ASKED.contains(name));
            cracks.map(|(_, (value, error))| ([*value, *error], "damage by cracks"))
        });
        let all = self.plans.iter().flat_map(of_plan).chain(ends);
        let relative = all
            .filter(|([value, _], _)| *value > 0.0)
            .map(|([value, error], what)| (error / value, what));
        let worst = relative.max_by(|one, other| one.0.total_cmp(&other.0));
        worst.map(|(error, what)| verdict::measured(error, what))
    }
}

/// The wheel, or the rail.
fn profile(worn: &WornSide, body: usize) -> &WornProfile {
    [&worn.wheel, &worn.rail][body]
}

/// The ending of files of that format.
fn extension(format: Format) -> &'static str {
    use archard_rail::Part::{Rail, Wheel};
    match format {
        Format::Simpack(Wheel) => "prw",
        Format::Simpack(Rail) => "prr",
        Format::MiniProf { part: Wheel, .. } => "whl",
        Format::MiniProf { part: Rail, .. } => "ban",
        Format::Columns { comma: true, .. } => "csv",
        Format::Columns { comma: false, .. } => "txt",
    }
}

/// The names of the files, for bodies, which of them wear, sides, and the formats of their profiles.
pub(super) fn rail_wear_files(
    wears: [bool; 2],
    sides: &[Side],
    formats: [Format; 2],
) -> Vec<String> {
    let profiles = profiles(wears, sides, formats).into_iter().map(|(_, _, name)| name);
    profiles.chain([WEAR, DIMENSIONS].map(str::to_owned)).collect()
}

/// A profile that wore: its body and side, and over its points by the names of columns (SI) the new profile, the depth along its
/// normal with its error, and the worn profile.
#[derive(Debug, Clone)]
pub struct ProfileWear {
    /// `wheel` or `rail`.
    pub body: &'static str,
    /// The side of the track.
    pub side: Side,
    /// The columns.
    pub columns: Vec<(&'static str, Vec<f64>)>,
}

impl RailWear {
    /// The profiles that wore.
    pub fn profile_wear(&self) -> Vec<ProfileWear> {
        let of_profile = |(body, side, _): Wears| {
            let travelled = &self.travelled;
            let [fine, coarse, hasty] = [&travelled.worn, &travelled.coarse, &travelled.hasty]
                .map(|worn| profile(&worn[side], body).depths());
            let error = |at: usize| error_of([fine[at], coarse[at], hasty[at]]);
            let errors = (0..fine.len()).map(error).collect();
            let one = profile(&travelled.worn[side], body);
            let damage = || {
                let of = |worn: &[WornSide]| profile(&worn[side], body).damage().to_vec();
                let [fine, coarse, hasty] =
                    [&travelled.worn, &travelled.coarse, &travelled.hasty].map(|worn| of(worn));
                let error = |at: usize| error_of([fine[at], coarse[at], hasty[at]]);
                let errors = (0..fine.len()).map(error).collect();
                [("crack_damage", fine), ("error_of_crack_damage", errors)]
            };
            let unknown = || vec![f64::NAN; one.unworn().points.len()];
            let none = || [("crack_damage", unknown()), ("error_of_crack_damage", unknown())];
            // Rows of both bodies have the same columns.
            let damage = match self.cracks {
                [false, false] => None,
                cracks if cracks[body] => Some(damage()),
                _ => Some(none()),
            };
            let [new, worn] = [one.unworn().points, one.profile().points];
            let axis =
                |points: &[[f64; 2]], axis: usize| points.iter().map(|point| point[axis]).collect();
            ProfileWear {
                body: BODIES[body],
                side: travelled.worn[side].side,
                columns: [
                    ("y_m", axis(&new, 0)),
                    ("z_m", axis(&new, 1)),
                    ("depth_m", fine),
                    ("error_of_depth_m", errors),
                    ("y_worn_m", axis(&worn, 0)),
                    ("z_worn_m", axis(&worn, 1)),
                ]
                .into_iter()
                .chain(damage.into_iter().flatten())
                .collect(),
            }
        };
        self.profiles().into_iter().map(of_profile).collect()
    }
}

/// Writes the worn profiles in the formats that they were read in, `wear.csv` with a row a point of a profile, and
/// `dimensions.csv` with a row a step and a side.
pub(super) fn write_rail_wear(manifest: &mut Manifest, wear: &RailWear) -> Result<(), Error> {
    for (body, side, name) in wear.profiles() {
        let worn = profile(&wear.travelled.worn[side], body).profile();
        manifest.write(&name, write(&worn, wear.formats[body]).as_bytes())?;
    }
    let mut table = Table::create(manifest.claim(WEAR)?)?;
    for ProfileWear { body, side, columns } in wear.profile_wear() {
        let points = columns.first().map_or(0, |(_, values)| values.len());
        for at in 0..points {
            let first = [("body", body.to_owned()), ("side", side.name().to_owned())].into_iter();
            let cells = columns.iter().map(|(name, values)| (*name, number(values[at])));
            table.row(&first.chain(cells).collect::<Vec<_>>())?;
        }
    }
    table.flush()?;
    table.sync()?;
    let mut table = Table::create(manifest.claim(DIMENSIONS)?)?;
    for (side, row) in wear.rows() {
        let first = [("side", side.name().to_owned())].into_iter();
        let cells = row.iter().map(|(name, value)| (name.as_str(), number(*value)));
        table.row(&first.chain(cells).collect::<Vec<_>>())?;
    }
    table.flush()?;
    table.sync()
}

/// The ends of the route.
pub(super) fn rail_wear_json(wear: &RailWear) -> Value {
    let course = wear.travelled.course();
    let side = |at: usize| {
        let sides = wear.travelled.worn.len();
        let ([first, _], [last, errors]) = {
            let ((first, none), (last, errors)) = (&course[at], &course[course.len() - sides + at]);
            ([&first.values, none], [&last.values, errors])
        };
        let mut told = json!({ "side": wear.travelled.worn[at].side.name() });
        let told_here = |at: usize, name: &str| {
            name != CONICITY && !(ASKED.contains(&name) && last[at].is_nan())
        };
        let columns = COLUMNS.iter().enumerate().filter(|(at, name)| told_here(*at, name));
        for (index, name) in columns {
            told[format!("new_{name}")] = json!(first[index]);
            told[*name] = json!(last[index]);
            told[format!("error_of_{name}")] = json!(errors[index]);
        }
        told
    };
    let [new, worn, error] = wear.conicity;
    let life = |life: &RailLife| {
        let [distance, error] = match life.at {
            Some(at) => at.map(|share| Some(share * wear.extent[0])),
            None => [None; 2],
        };
        json!({
            "side": life.side.name(),
            "column": life.limit.column,
            "limit": life.limit.value,
            "distance_m": distance,
            "error_of_distance_m": error.filter(|error| error.is_finite()),
        })
    };
    let plan = |RailPlan { side, when, plan }: &RailPlan| {
        let distance = |of: fn(&Plan) -> f64| plan.as_ref().map(|plan| of(plan) * wear.extent[0]);
        json!({
            "side": side.name(),
            "when": when,
            "interval_m": distance(|plan| plan.interval[0]),
            "error_of_interval_m": distance(|plan| plan.interval[1]),
            "turning_depth_m": plan.map(|plan| plan.depth[0]),
            "error_of_turning_depth_m": plan.map(|plan| plan.depth[1]),
            "turnings": plan.map(|plan| plan.turnings),
            "distance_m": distance(|plan| plan.life[0]),
            "error_of_distance_m": distance(|plan| plan.life[1]),
        })
    };
    let economy = |RailEconomy { side, economy }: &RailEconomy| {
        let distance = |share: f64| share * wear.extent[0];
        let of = |economy: &Economy| {
            let turned = |own: &ReprofilingCut| {
                json!({
                    "interval_m": distance(own.interval),
                    "depth_m": own.depth,
                    "flange_thickness_m": own.thickness,
                })
            };
            json!({
                "side": side.name(),
                "distance_m": distance(economy.life[0]),
                "error_of_distance_m": distance(economy.life[1]),
                "full_flange_distance_m": distance(economy.full[0]),
                "error_of_full_flange_distance_m": distance(economy.full[1]),
                "turnings": economy.turnings.iter().map(turned).collect::<Vec<_>>(),
            })
        };
        economy.as_ref().map(of)
    };
    json!({
        "thinner_flanges": wear.economies.iter().map(economy).collect::<Vec<_>>(),
        "reprofiling": wear.plans.iter().map(plan).collect::<Vec<_>>(),
        "life": wear.lives.iter().map(life).collect::<Vec<_>>(),
        "distance_m": wear.extent[0],
        "axles": wear.extent[1],
        "steps": wear.travelled.steps,
        "sides": (0..wear.travelled.worn.len()).map(side).collect::<Vec<_>>(),
        "new_equivalent_conicity": new,
        "equivalent_conicity": worn,
        "error_of_equivalent_conicity": error,
    })
}
