//! The results of a wheel on a rail: a row for each patch of contact.

use serde_json::{Value, json};

use super::summary::json_of;
use super::table::{Table, number};
use super::{CASE, Claim, Error, SUMMARY, Totals, file};
use crate::verdict::{self, Verdict};
use archard_rail::contact::{Patch, Quantities};
use archard_rail::setup::Side;

/// The file of the patches.
pub(super) const CONTACTS: &str = "contacts.csv";

/// The contact of one wheel with its rail.
#[derive(Debug, Clone)]
pub struct RailContact {
    /// The side of the track.
    pub side: Side,
    /// Vertical force (N) prescribed.
    pub load: f64,
    /// Its patches, from the field side to the flange, as this side sees them.
    pub patches: Vec<Patch>,
}

impl RailContact {
    /// What the side is called.
    pub fn name(&self) -> &'static str {
        if self.side == Side::Left { "left" } else { "right" }
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

/// Writes `case.toml`, `contacts.csv` and `summary.json` into a folder; what earlier runs wrote there is removed.
///
/// # Errors
/// If a file cannot be removed or written.
pub fn write_contacts(
    claim: &mut Claim,
    case_toml: &str,
    contacts: &[RailContact],
    totals: &Totals,
) -> Result<(), Error> {
    claim.admit()?;
    let manifest = &mut claim.manifest;
    manifest.begin([CASE, CONTACTS])?;
    file::write_whole(&manifest.claim(CASE)?, case_toml.as_bytes())?;
    let mut table = Table::create(manifest.claim(CONTACTS)?)?;
    for (index, (contact, patch)) in patches(contacts).enumerate() {
        let row = contact_row(patch);
        let first = [("patch", (index + 1).to_string()), ("side", contact.name().to_owned())];
        let values = row.iter().map(|(column, value)| (column.as_str(), number(*value)));
        table.row(&first.into_iter().chain(values).collect::<Vec<_>>())?;
    }
    table.flush()?;
    table.sync()?;
    let summary = format!("{:#}\n", summary(contacts, totals));
    file::write_whole(&manifest.claim(SUMMARY)?, summary.as_bytes())
}

/// What can be believed of the contacts.
pub fn contacts_verdict(contacts: &[RailContact]) -> Verdict {
    let off = contacts.iter().map(RailContact::off).fold(0.0, f64::max);
    let spread = patches(contacts).map(|(_, patch)| patch.angle_spread).fold(0.0, f64::max);
    Verdict { lines: vec![verdict::load(off), verdict::bent(spread.to_degrees())] }
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

fn summary(contacts: &[RailContact], totals: &Totals) -> Value {
    let all: Vec<Value> = patches(contacts)
        .map(|(contact, patch)| {
            let row = contact_row(patch).into_iter();
            let mut values: Value = row.map(|(name, value)| (name, json!(value))).collect();
            values["side"] = json!(contact.name());
            values
        })
        .collect();
    json!({
        "program": "archard",
        "version": env!("CARGO_PKG_VERSION"),
        "complete": totals.failure.is_none(),
        "failure": totals.failure,
        "patches": all,
        "verdict": json_of(&contacts_verdict(contacts)),
        "seconds": totals.seconds,
        "threads": totals.threads,
        "warnings": totals.warnings,
        "command": totals.command,
    })
}
