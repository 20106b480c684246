//! The results of a wheel on a rail: a row for each patch of contact.

use serde_json::{Value, json};

use super::rail_wear::{rail_wear_files, rail_wear_json, write_rail_wear};
use super::summary::json_of;
use super::table::{Table, number};
use super::{CASE, Claim, Error, SUMMARY, Totals, file};
use crate::case::{Prepared, RailResults};
use crate::verdict::{self, Verdict};
use archard_rail::contact::{Patch, Quantities};
use archard_rail::setup::Side;

/// The file of the patches.
pub(super) const CONTACTS: &str = "contacts.csv";

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
    /// Its patches, from the field side to the flange, as this side sees them.
    pub patches: Vec<Patch>,
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

    /// How far the vertical force of all patches is off the one prescribed, relative to it.
    pub fn off(&self) -> f64 {
        let vertical = |patch: &Patch| {
            let (sin, cos) = patch.values.contact_angle.sin_cos();
            patch.values.normal_force * cos + patch.values.force_s * sin
        };
        (self.patches.iter().map(vertical).sum::<f64>() / self.load - 1.0).abs()
    }
}

/// Writes `case.toml`, `contacts.csv` and `summary.json` into a folder, and what wears: see [`write_rail_wear`]; what earlier runs
/// wrote there is removed.
///
/// # Errors
/// If a file cannot be removed or written.
pub fn write_rail(
    claim: &mut Claim,
    case_toml: &str,
    results: &RailResults,
    totals: &Totals,
) -> Result<(), Error> {
    claim.admit()?;
    let manifest = &mut claim.manifest;
    manifest.begin([CASE, CONTACTS])?;
    file::write_whole(&manifest.claim(CASE)?, case_toml.as_bytes())?;
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
    if let Some(wear) = &results.wear {
        write_rail_wear(manifest, wear)?;
    }
    let summary = format!("{:#}\n", summary(results, totals));
    file::write_whole(&manifest.claim(SUMMARY)?, summary.as_bytes())
}

/// The files of a wheel on a rail but for the case, by their names in the folder.
pub fn rail_files(prepared: &Prepared) -> Vec<String> {
    let wears = prepared.wears();
    let mut names = vec![CONTACTS.to_owned()];
    if wears != [false; 2] {
        names.extend(rail_wear_files(wears, &prepared.running.sides, prepared.formats));
    }
    names
}

/// What can be believed of the contacts.
pub fn rail_verdict(results: &RailResults) -> Verdict {
    let RailResults { contacts, wear } = results;
    let off = contacts.iter().map(RailContact::off).fold(0.0, f64::max);
    let spread = patches(contacts).map(|(_, patch)| patch.angle_spread).fold(0.0, f64::max);
    let mut lines = vec![verdict::load(off), verdict::bent(spread.to_degrees())];
    lines.extend(wear.as_ref().map(|wear| verdict::worn(wear.relative_error())));
    Verdict { lines }
}

/// The patches of all sides.
fn patches(contacts: &[RailContact]) -> impl Iterator<Item = (&RailContact, &Patch)> {
    contacts.iter().flat_map(|contact| contact.patches.iter().map(move |patch| (contact, patch)))
}

/// What is known of a patch by the names of columns, in SI: its quantities, how far the rail bends within it, and the errors.
pub fn contact_row(patch: &Patch) -> Vec<(String, f64)> {
    let names = Quantities::COLUMNS.iter();
    let values = names.clone().zip(patch.values.values());
    let values = values.map(|(name, value)| ((*name).to_owned(), value));
    let errors = names.zip(patch.errors.values());
    let errors = errors.map(|(name, error)| (format!("error_of_{name}"), error));
    values.chain([("angle_spread_rad".to_owned(), patch.angle_spread)]).chain(errors).collect()
}

fn summary(results: &RailResults, totals: &Totals) -> Value {
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
    json!({
        "program": "archard",
        "version": env!("CARGO_PKG_VERSION"),
        "complete": totals.failure.is_none(),
        "failure": totals.failure,
        "patches": all,
        "wear": results.wear.as_ref().map(rail_wear_json),
        "verdict": json_of(&rail_verdict(results)),
        "seconds": totals.seconds,
        "threads": totals.threads,
        "warnings": totals.warnings,
        "command": totals.command,
    })
}
