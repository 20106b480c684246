//! The results of a wheel on a rail: a row for each patch of contact.

use serde_json::{Value, json};

use super::folder::CHECKPOINT;
use super::rail_errors::stated;
use super::rail_wear::{RailWear, rail_wear_files, rail_wear_json, write_rail_wear};
use super::summary::json_of;
use super::table::{Table, number};
use super::{CASE, Claim, Error, Field, Image, SUMMARY, Totals};
use crate::verdict::{self, Verdict};
use archard_rail::contact::{Patch, PatchMap, Quantities};
use archard_rail::file::Format;
use archard_rail::setup::Side;

/// The file of the patches.
pub(super) const CONTACTS: &str = "contacts.csv";
/// The file of the points that stand for a history.
const ROUTE: &str = "gathered.csv";
/// The folder of their maps.
const PATCHES: &str = "patches";

/// A point of a route, and whether its profiles are the worn ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AtPoint {
    /// The point, numbered from 1.
    pub point: usize,
    /// Whether wheel and rail are worn by the whole route.
    pub worn: bool,
}

/// The contact of one wheel with its rail.
#[derive(Debug, Clone)]
pub struct RailContact {
    /// Where on a route; `None` without one.
    pub at: Option<AtPoint>,
    /// The side of the track.
    pub side: Side,
    /// Vertical force (N) prescribed.
    pub load: f64,
    /// Lateral over vertical force at which the flange may climb the rail, by Nadal; `None` without a flange.
    pub nadal: Option<f64>,
    /// The lateral force (N) on the rail, to the field side, that another program has found.
    pub told: Option<f64>,
    /// Its patches, from the field side to the flange, as this side sees them.
    pub patches: Vec<Patch>,
}

/// What came out of a case.
#[derive(Debug, Clone)]
pub struct RailResults {
    /// The contacts at each point, of new profiles and then of worn ones.
    pub contacts: Vec<RailContact>,
    /// Where the flange of the wheel is steepest; `None` without one.
    pub flank: Option<Flank>,
    /// Indentation hardness (Pa) of the softer of wheel and rail, where it is known.
    pub hardness: Option<f64>,
    /// What was worn off over the route; `None` where nothing wears.
    pub wear: Option<RailWear>,
    /// What its route was gathered from; `None` without a history.
    pub history: Option<RailHistory>,
}

/// The points of a route that stand for the steps of a history.
#[derive(Debug, Clone)]
pub struct RailHistory {
    /// Number of steps.
    pub steps: usize,
    /// What the points lose, relative to all work of friction: its amount and its place on the wheel.
    pub loss: f64,
    /// The largest lateral over vertical force that it gives for a wheel, relative to Nadal's limit; `None` without lateral forces.
    pub climb: Option<f64>,
    /// The points by the titles of their columns, which a route is read from.
    pub rows: Vec<(String, Vec<f64>)>,
}

/// The steepest place of a flange.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flank {
    /// y (m) on the profile of the wheel.
    pub y: f64,
    /// Its inclination (rad).
    pub angle: f64,
}

impl Flank {
    /// The least lateral over vertical force of a wheel that touches at this place alone: where friction of that coefficient bears all it
    /// can against the flange (M. J. Nadal, *Annales des Mines* 10 (1896) 232). `None` where friction alone holds it.
    pub fn nadal(self, friction: f64) -> Option<f64> {
        let slope = self.angle.tan();
        let limit = (slope - friction) / (1.0 + friction * slope);
        (limit > 0.0).then_some(limit)
    }

    /// Whether a patch lies between this place and the tip of the flange, where the flange is less steep again by more than the
    /// inclination differs within the patch and its stated error.
    fn ends_before(&self, patch: &Patch) -> bool {
        let (values, errors) = (&patch.values, &patch.errors);
        let falls = self.angle - values.contact_angle.abs();
        values.y_wheel < self.y && falls > patch.angle_spread + errors.contact_angle
    }
}

impl RailContact {
    /// What says which contact it is, by the names of columns.
    fn labels(&self) -> Vec<(&'static str, String)> {
        let at = self.at.iter().flat_map(|at| {
            let profiles = if at.worn { "worn" } else { "new" };
            [("profiles", profiles.to_owned()), ("point", at.point.to_string())]
        });
        at.chain([("side", self.side.name().to_owned())]).collect()
    }

    /// The file of the map of a patch.
    fn map_name(&self, patch: usize) -> String {
        let at = self.at.map_or_else(String::new, |at| {
            let profiles = if at.worn { "worn" } else { "new" };
            format!("{profiles}_{:03}_", at.point)
        });
        format!("{PATCHES}/{at}{}_{}.vti", self.side.name(), patch + 1)
    }

    /// How far the vertical force of all patches is off the one prescribed, relative to it.
    pub fn off(&self) -> f64 {
        (self.forces()[1] / self.load - 1.0).abs()
    }

    /// Lateral force against the flange (Y) and vertical force (Q) of all patches (N).
    pub fn forces(&self) -> [f64; 2] {
        let of_patch = |patch: &Patch| {
            let [_, across, down] = patch.force();
            [across, down]
        };
        let sum = |sum: [f64; 2], own: [f64; 2]| [sum[0] + own[0], sum[1] + own[1]];
        self.patches.iter().map(of_patch).fold([0.0; 2], sum)
    }
}

/// Writes `case.toml`, `contacts.csv`, a map of each patch and `summary.json` into a folder, and of what wears `wear.csv`,
/// `dimensions.csv` and the worn profiles; what earlier runs wrote there is removed. Returns what can be believed, warnings included.
///
/// # Errors
/// If a file cannot be removed or written.
pub fn write_rail(
    claim: &mut Claim,
    case_toml: &str,
    results: &RailResults,
    totals: &Totals,
) -> Result<Verdict, Error> {
    claim.admit()?;
    let manifest = &mut claim.manifest;
    // A route that is kept there stays until all is written.
    if !claim.on_a_route {
        manifest.begin([CASE, CONTACTS])?;
    }
    manifest.write(CASE, case_toml.as_bytes())?;
    let mut table = Table::create(manifest.claim(CONTACTS)?)?;
    for contact in &results.contacts {
        for (index, patch) in contact.patches.iter().enumerate() {
            let row = contact_row(patch);
            let first = [("patch", (index + 1).to_string())].into_iter().chain(contact.labels());
            let values = row.iter().map(|(column, value)| (column.as_str(), number(*value)));
            table.row(&first.chain(values).collect::<Vec<_>>())?;
        }
    }
    table.flush()?;
    table.sync()?;
    for contact in &results.contacts {
        for (index, patch) in contact.patches.iter().enumerate() {
            image(patch).write(&manifest.claim(&contact.map_name(index))?)?;
        }
    }
    if let Some(wear) = &results.wear {
        write_rail_wear(manifest, wear)?;
    }
    if let Some(history) = &results.history {
        let mut table = Table::create(manifest.claim(ROUTE)?)?;
        let points = history.rows.first().map_or(0, |(_, values)| values.len());
        for point in 0..points {
            let cells =
                history.rows.iter().map(|(name, values)| (name.as_str(), number(values[point])));
            table.row(&cells.collect::<Vec<_>>())?;
        }
        table.flush()?;
        table.sync()?;
    }
    let verdict = rail_verdict(results).warned_of(&totals.warnings);
    let verdict = verdict.ended(totals.failure.as_deref());
    let summary = format!("{:#}\n", summary(results, &verdict, totals));
    manifest.write(SUMMARY, summary.as_bytes())?;
    manifest.remove(CHECKPOINT)?;
    manifest.settle()?;
    Ok(verdict)
}

/// The files of a wheel on a rail but for the case, by their names in the folder: of those of wheel and rail that wear, on these
/// sides, in these formats, over a route that is gathered from a history or not.
pub fn rail_files(
    wears: [bool; 2],
    sides: &[Side],
    formats: [Format; 2],
    gathered: bool,
) -> Vec<String> {
    let mut names = vec![CONTACTS.to_owned()];
    names.extend(gathered.then(|| ROUTE.to_owned()));
    if wears != [false; 2] {
        names.extend(rail_wear_files(wears, sides, formats));
    }
    names
}

/// The map of a patch for ParaView, over x and s from its reference point.
fn image(patch: &Patch) -> Image {
    let PatchMap { origin, spacing, elements, pressure, traction, slip, rise } = patch.map.clone();
    let ([traction_x, traction_s], [slip_x, slip_s]) = (traction, slip);
    let mut fields = vec![
        Field::new("pressure_Pa", pressure),
        Field::new("traction_x_Pa", traction_x),
        Field::new("traction_s_Pa", traction_s),
        Field::new("slip_x", slip_x),
        Field::new("slip_s", slip_s),
    ];
    if !rise.is_empty() {
        fields.push(Field::new("temperature_rise_K", rise));
    }
    Image { origin, spacing, elements, fields }
}

impl RailResults {
    /// What can be believed of the contacts, whatever the user was warned of before.
    pub fn verdict(&self) -> Verdict {
        rail_verdict(self)
    }
}

fn rail_verdict(results: &RailResults) -> Verdict {
    let RailResults { contacts, flank, hardness, wear, history } = results;
    let on_the_way = wear.as_ref().map_or(0.0, |wear| wear.travelled.off);
    let off = contacts.iter().map(RailContact::off).fold(on_the_way, f64::max);
    let spread = patches(contacts).map(|(_, patch)| patch.angle_spread).fold(0.0, f64::max);
    let mut lines = vec![verdict::load(off), verdict::conformity(spread.to_degrees())];
    let peaks = patches(contacts).map(|(_, patch)| patch.values.peak_pressure);
    let peak = peaks.fold(0.0, f64::max);
    let (hardness, steel) = match hardness {
        Some(hardness) => (*hardness, "the softer of wheel and rail"),
        None => (verdict::RAIL_STEEL, "rail steel of 440 HBW"),
    };
    lines.push(verdict::hardness(peak / hardness, steel));
    let shaken = patches(contacts).map(|(_, patch)| {
        let Quantities { peak_pressure, normal_force, force_x, force_s, .. } = patch.values;
        verdict::shaken(peak_pressure / hardness, force_x.hypot(force_s) / normal_force)
    });
    lines.extend(shaken.max_by(f64::total_cmp).map(|over| verdict::shakedown(over, steel)));
    let creeps = patches(contacts)
        .map(|(_, patch)| patch.values.creepage.hypot(patch.values.lateral_creepage));
    lines.extend(creeps.max_by(f64::total_cmp).map(verdict::creepage));
    lines.extend(stated(contacts));
    let slowest = patches(contacts).filter_map(|(_, patch)| Some(patch.warmth?.peclet));
    lines.extend(slowest.min_by(f64::total_cmp).map(verdict::heat));
    let beyond = |patch: &Patch| flank.is_some_and(|flank| flank.ends_before(patch));
    lines.push(verdict::climbs(patches(contacts).filter(|(_, patch)| beyond(patch)).count()));
    let climbs = contacts.iter().flat_map(|contact| {
        let [lateral, vertical] = contact.forces();
        let both = [Some(lateral), contact.told].into_iter().flatten();
        both.filter_map(move |lateral| Some(lateral / vertical / contact.nadal?))
    });
    let climbs = climbs.chain(history.iter().filter_map(|history| history.climb));
    lines.extend(climbs.max_by(f64::total_cmp).map(verdict::nadal));
    lines.extend(farthest(contacts).map(|(contact, off)| {
        let point = contact.at.map_or(1, |at| at.point);
        verdict::lateral(off, &format!("the {} wheel at point {point}", contact.side.name()))
    }));
    lines.extend(wear.as_ref().map(|wear| verdict::worn(wear.relative_error())));
    let first = wear.iter().filter_map(|wear| wear.lives.first()?.at).next();
    let life = |[at, error]: [f64; 2]| {
        verdict::measured(if at > 0.0 { error / at } else { 0.0 }, "distance to the first limit")
    };
    lines.extend(first.map(life));
    lines.extend(wear.as_ref().and_then(RailWear::worst_of_service));
    lines.extend(history.as_ref().map(|history| verdict::gathered(history.loss)));
    Verdict { lines }
}

/// The contact of new profiles whose lateral force differs most from the one that another program has found, and by how much, relative to
/// its vertical force.
pub fn farthest(contacts: &[RailContact]) -> Option<(&RailContact, f64)> {
    let new = contacts.iter().filter(|contact| !contact.at.is_some_and(|at| at.worn));
    let off = new.filter_map(|contact| {
        let [lateral, vertical] = contact.forces();
        Some((contact, (lateral - contact.told?).abs() / vertical))
    });
    off.max_by(|one, other| one.1.total_cmp(&other.1))
}

/// The patches of all sides.
pub(super) fn patches(contacts: &[RailContact]) -> impl Iterator<Item = (&RailContact, &Patch)> {
    contacts.iter().flat_map(|contact| contact.patches.iter().map(move |patch| (contact, patch)))
}

/// What is known of a patch by the names of columns, in SI: its quantities, how far the normal of the rail turns within it, and the errors.
pub fn contact_row(patch: &Patch) -> Vec<(String, f64)> {
    let names = Quantities::COLUMNS.iter();
    let values = names.clone().zip(patch.values.values());
    let values = values.map(|(name, value)| ((*name).to_owned(), value));
    let errors = names.zip(patch.errors.values());
    let errors = errors.map(|(name, error)| (format!("error_of_{name}"), error));
    let warmth = patch.warmth.iter().flat_map(|warmth| {
        let [rise, error] = warmth.rise;
        [("temperature_rise_K", rise), ("error_of_temperature_rise_K", error)]
            .map(|(name, value)| (name.to_owned(), value))
    });
    let spread = [("angle_spread_rad".to_owned(), patch.angle_spread)];
    values.chain(spread).chain(errors).chain(warmth).collect()
}

fn summary(results: &RailResults, verdict: &Verdict, totals: &Totals) -> Value {
    let of_patch = |(contact, patch): (&RailContact, &Patch)| {
        let row = contact_row(patch).into_iter();
        let mut values: Value = row.map(|(name, value)| (name, json!(value))).collect();
        for (name, label) in contact.labels() {
            values[name] =
                label.parse::<usize>().map_or_else(|_| json!(label), |number| json!(number));
        }
        values
    };
    let all: Vec<Value> = patches(&results.contacts).map(of_patch).collect();
    let told = results.contacts.iter().filter(|contact| contact.told.is_some());
    let lateral = told.map(|contact| {
        let [lateral, vertical] = contact.forces();
        let mut values = json!({
            "lateral_force_N": lateral,
            "vertical_force_N": vertical,
            "told_lateral_force_N": contact.told,
            "nadal_limit": contact.nadal,
        });
        for (name, label) in contact.labels() {
            values[name] = json!(label);
        }
        values
    });
    let lateral: Vec<Value> = lateral.collect();
    json!({
        "program": "archard",
        "version": env!("CARGO_PKG_VERSION"),
        "complete": totals.failure.is_none(),
        "failure": totals.failure,
        "patches": all,
        "lateral_forces": lateral,
        "history": results.history.as_ref().map(|history| json!({
            "steps": history.steps,
            "points": history.rows.first().map_or(0, |(_, values)| values.len()),
            "loss": history.loss,
        })),
        "wear": results.wear.as_ref().map(rail_wear_json),
        "verdict": json_of(verdict),
        "seconds": totals.seconds,
        "threads": totals.threads,
        "warnings": totals.warnings.iter().map(|warning| &warning.text).collect::<Vec<_>>(),
        "command": totals.command,
    })
}
