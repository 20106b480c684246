//! The page about a wheel on its rail: what touches where, and what a route wears off.

use std::path::Path;

use anyhow::Result;
use archard_case::files;
use serde_json::Value;

use super::figures::Figure;
use super::html::Html;
use super::page::{Header, Page, Sections, Table};
use super::words::{case, judged, quantity};
use super::{name_of, tables};
use crate::plot::figure::Panel;
use crate::plot::rail::Rail;

/// What is told of a side that wears: its key in the summary, words and unit.
const TOLD: [(&str, &str, &str); 12] = [
    ("wheel_worn_area_m2", "Area worn off the wheel's section", "m2"),
    ("wheel_worn_volume_m3", "Volume worn off the wheel", "m3"),
    ("wheel_depth_m", "Deepest wear of the wheel", "m"),
    ("tread_depth_m", "Wear at the datum of the tread", "m"),
    ("flange_height_m", "Flange height Sh", "m"),
    ("flange_thickness_m", "Flange thickness Sd", "m"),
    ("flange_gradient_m", "Flange gradient qR", "m"),
    ("turning_depth_m", "Loss of radius by turning the profile again", "m"),
    ("rail_worn_area_m2", "Area worn off the rail's section", "m2"),
    ("rail_depth_m", "Deepest wear of the rail", "m"),
    ("wheel_crack_damage", "Largest damage of the wheel by cracks", ""),
    ("rail_crack_damage", "Largest damage of the rail by cracks", ""),
];

/// The page of a folder.
pub(super) fn page(dir: &Path) -> Result<Page> {
    let rail = Rail::read(dir)?;
    let title = name_of(dir);
    let summary = &rail.summary;
    let mut all = Sections::default();
    let wears = !summary["wear"].is_null();
    let outcome: Html = match wears {
        true => {
            let worn = sides(summary).map(|side| worn(side).html());
            worn.chain(service(summary).map(|table| table.html())).collect()
        }
        false => patches(summary).html(),
    };
    all.add("outcome", "What came out", &outcome);
    let worn = if wears { rail.worn() } else { vec![] };
    all.add("wear", "Worn profiles", &pictures(&worn, WORN)?);
    let course = if wears { rail.course() } else { vec![] };
    all.add("course", "Over the route", &pictures(&course, COURSE)?);
    let contact = rail.contact();
    all.add("contact", "Contacts", &pictures(&contact, CONTACT)?);
    all.add("verdict", "Verdict", &tables::verdict(summary).html());
    let text = files::read_text(&dir.join("case.toml")).unwrap_or_default();
    all.add("case", "The case", &case(&text));
    let glance = worn.first().or(contact.first());
    let glance = glance.map(|panel| Figure::pictured(panel, String::new())).transpose()?;
    let header = Header {
        about: "a wheel on its rail",
        version: summary["version"].as_str().unwrap_or(env!("CARGO_PKG_VERSION")),
        title: &title,
        facts: vec![],
        verdict: judged(summary),
        mark: rail.mark.clone(),
        lead: vec![],
        tiles: tiles(summary),
        picture: glance.as_ref().map_or_else(Html::default, Figure::small),
    };
    let header = header.html(&all.there);
    Ok(Page { title, header, body: all.html, drawings: None })
}

const WORN: &str = "Depth is along the normal of the new profile; the band is its error. Wear is magnified where the title says so.";
const COURSE: &str = "Bands are the errors of grid and steps.";
const CONTACT: &str = "y points to the field side on the wheel, and to the right in the track.";

/// Panels one below the other.
fn pictures(panels: &[Panel], words: &str) -> Result<Html> {
    panels.iter().map(|panel| Ok(Figure::pictured(panel, words.to_owned())?.alone())).collect()
}

fn sides(summary: &Value) -> impl Iterator<Item = &Value> {
    summary["wear"]["sides"].as_array().into_iter().flatten()
}

/// What was worn off a side.
fn worn(side: &Value) -> Table {
    let row = |(key, words, unit): &(&str, &str, &str)| {
        let value = side[*key].as_f64()?;
        let new = side[format!("new_{key}")].as_f64().unwrap_or(0.0);
        let error = side[format!("error_of_{key}")].as_f64()?;
        // What neither has nor gets a value does not wear.
        let changes = value != 0.0 && (value != new || new != 0.0);
        changes.then(|| vec![(*words).to_owned(), quantity(value, unit), quantity(error, unit)])
    };
    Table {
        caption: format!("The {} side at the end", side["side"].as_str().unwrap_or_default()),
        heads: vec!["Quantity", "Value", "Error"],
        rows: TOLD.iter().filter_map(row).collect(),
    }
}

/// When wheels reach their limits, and when they are turned.
fn service(summary: &Value) -> Option<Table> {
    let km = |of: &Value, key: &str| of[key].as_f64().map(|value| quantity(value, "m"));
    let words = |of: &Value, key: &str| of[key].as_str().unwrap_or_default().replace('_', " ");
    let lives = summary["wear"]["life"].as_array().into_iter().flatten().map(|life| {
        let what = words(life, "column");
        let what = what.strip_suffix(" m").unwrap_or(&what).to_owned();
        vec![
            format!("{} wheel: {what} at its limit", words(life, "side")),
            km(life, "distance_m").unwrap_or_else(|| "not reached".to_owned()),
            km(life, "error_of_distance_m").unwrap_or_default(),
        ]
    });
    let plans = summary["wear"]["reprofiling"].as_array().into_iter().flatten();
    let plans = plans.flat_map(|plan| {
        let when = match plan["when"].as_str() {
            Some("limit") => "turned at its first limit",
            Some("end") => "turned at the end",
            _ => "turned where it costs least",
        };
        let row = |key: &str, what: &str| {
            let error = km(plan, &format!("error_of_{key}")).unwrap_or_default();
            let text = format!("{} wheel, {when}: {what}", words(plan, "side"));
            Some(vec![text, km(plan, key)?, error])
        };
        let often = format!("runs in all, turned {} times", plan["turnings"]);
        [
            row("interval_m", "runs between two turnings"),
            row("turning_depth_m", "loses of its radius"),
            row("distance_m", &often),
        ]
    });
    let rows: Vec<_> = lives.chain(plans.flatten()).collect();
    (!rows.is_empty()).then(|| Table {
        caption: "Service".to_owned(),
        heads: vec!["Quantity", "Value", "Error"],
        rows,
    })
}

/// The patches of a contact.
fn patches(summary: &Value) -> Table {
    let told = [
        ("contact_angle_rad", "contact angle", "rad"),
        ("normal_force_N", "normal force", "N"),
        ("force_x_N", "force along the track", "N"),
        ("force_s_N", "force across", "N"),
        ("peak_pressure_Pa", "peak pressure", "Pa"),
        ("contact_area_m2", "area", "m2"),
    ];
    let of_patch = |(index, patch): (usize, &Value)| {
        let side = patch["side"].as_str().unwrap_or_default().to_owned();
        let point =
            patch["point"].as_u64().map_or_else(String::new, |point| format!(", point {point}"));
        let rows = told.iter().filter_map(|(key, words, unit)| {
            let error = patch[format!("error_of_{key}")].as_f64();
            let error = error.map_or_else(String::new, |error| quantity(error, unit));
            let name = format!("Patch {} ({side}{point}): {words}", index + 1);
            Some(vec![name, quantity(patch[*key].as_f64()?, unit), error])
        });
        rows.collect::<Vec<_>>()
    };
    let all = summary["patches"].as_array().into_iter().flatten();
    Table {
        caption: "The patches".to_owned(),
        heads: vec!["Quantity", "Value", "Error"],
        rows: all.enumerate().flat_map(of_patch).collect(),
    }
}

/// The first numbers.
fn tiles(summary: &Value) -> Vec<[String; 3]> {
    let told = |of: &Value, key: &str, words: &str, unit: &str| {
        let error = of[format!("error_of_{key}")].as_f64();
        let error =
            error.map_or_else(String::new, |error| format!("\u{b1} {}", quantity(error, unit)));
        Some([words.to_owned(), quantity(of[key].as_f64()?, unit), error])
    };
    let first = sides(summary).next();
    match first {
        Some(side) => TOLD
            .iter()
            .filter(|(key, ..)| side[*key].as_f64().is_some_and(|one| one > 0.0))
            .filter_map(|(key, words, unit)| told(side, key, words, unit))
            .take(4)
            .collect(),
        None => {
            let patch = &summary["patches"][0];
            let keys =
                [("peak_pressure_Pa", "Peak pressure", "Pa"), ("contact_area_m2", "Area", "m2")];
            keys.iter().filter_map(|(key, words, unit)| told(patch, key, words, unit)).collect()
        }
    }
}
