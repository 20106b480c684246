//! The page about two scans: what is worn between them, and the uncertainty of that.

use std::path::Path;

use anyhow::{Context, Result};
use archard_case::files::{self, Contents};
use serde_json::Value;

use super::figures::Figure;
use super::html::Html;
use super::page::{Header, Page, Sections, Table, list};
use super::words::{judged, quantity, range};
use super::{name_of, tables};

/// What was found.
pub(crate) const SCANS: &str = "difference.json";
const PICTURES: [(&str, &str); 1] = [("plots/difference.png", "image/png")];
/// What has an uncertainty: its key, its name and its unit.
const VALUES: [(&str, &str, &str); 4] = [
    ("worn_volume_m3", "Worn volume", "m3"),
    ("piled_volume_m3", "Piled up", "m3"),
    ("net_volume_m3", "Worn less piled up", "m3"),
    ("depth_m", "Greatest depth", "m"),
];
/// Where its uncertainty comes from.
const SOURCES: [(&str, &str); 6] = [
    ("by_noise", "Noise of the points that changed"),
    ("by_level", "Level: offset and tilt"),
    ("by_shift_and_turn", "Shift and turn"),
    ("by_edge", "Edge of the regions, and walls between points"),
    ("by_missing_points", "Points without a height"),
    ("standard_uncertainty", "All together"),
];

/// Whether a folder is that of two scans.
pub(super) fn is_one(dir: &Path) -> bool {
    dir.join(SCANS).is_file()
}

/// The page of two scans.
pub(super) fn page(dir: &Path) -> Result<Page> {
    let path = dir.join(SCANS);
    let context = || format!("cannot read `{}`", path.display());
    let text = files::read(&path, Contents::Text).with_context(context)?;
    let found: Value = serde_json::from_slice(&text).with_context(context)?;
    let title = name_of(dir);
    let picture = picture(dir);
    let mut all = Sections::default();
    all.add("outcome", "What is worn", &outcome(&found).html());
    let alone = picture.as_ref().map_or_else(Html::default, Figure::alone);
    all.add("picture", "Map and section", &alone);
    let budgets: Html = VALUES.iter().map(|value| budget(&found, value).html()).collect();
    all.add("budget", "Uncertainty", &budgets);
    all.add("placement", "How the scans lie", &placed(&found).html());
    let remarks = found["remarks"].as_array().into_iter().flatten();
    let remarks: Vec<String> = remarks.filter_map(|one| one.as_str().map(str::to_owned)).collect();
    all.add("remarks", "Remarks", &list(&remarks));
    all.add("verdict", "Verdict", &tables::verdict(&found).html());
    let header = Header {
        about: "two scans",
        version: found["version"].as_str().unwrap_or(env!("CARGO_PKG_VERSION")),
        title: &title,
        facts: vec![],
        verdict: judged(&found),
        mark: None,
        lead: lead(&found).into_iter().collect(),
        tiles: VALUES.iter().filter_map(|value| tile(&found, value)).collect(),
        picture: picture.as_ref().map_or_else(Html::default, Figure::small),
    };
    let header = header.html(&all.there);
    Ok(Page { title, header, body: all.html, drawings: None })
}

/// The picture of the folder.
fn picture(dir: &Path) -> Option<Figure> {
    let title = "What is worn, and the section across it";
    let words = "Depths of worn regions on the later scan, and the section through the deepest point across the scar.";
    Figure::in_folder(dir, &PICTURES, [title, words])
}

/// The outcome in a sentence.
fn lead(found: &Value) -> Option<String> {
    let names = [found["before"].as_str()?, found["after"].as_str()?];
    let worn = &found["worn_volume_m3"];
    let value = quantity(worn["value"].as_f64()?, "m3");
    let within = within(worn, "m3")?;
    Some(format!(
        "From {} to {} {value} were worn off; with 95 % probability it is {within}.",
        names[0], names[1]
    ))
}

fn within(value: &Value, unit: &str) -> Option<String> {
    let ends = &value["interval_95"];
    Some(range(ends[0].as_f64()?, ends[1].as_f64()?, unit))
}

fn tile(found: &Value, (key, name, unit): &(&str, &str, &str)) -> Option<[String; 3]> {
    let value = &found[*key];
    let own = quantity(value["value"].as_f64()?, unit);
    Some([(*name).to_owned(), own, format!("95 %: {}", within(value, unit)?)])
}

fn outcome(found: &Value) -> Table {
    let row = |(key, name, unit): &(&str, &str, &str)| {
        let value = &found[*key];
        let own = quantity(value["value"].as_f64()?, unit);
        Some(vec![(*name).to_owned(), own, within(value, unit)?])
    };
    let plain = |name: &str, value: &Value, unit: &str| {
        Some(vec![name.to_owned(), quantity(value.as_f64()?, unit), String::new()])
    };
    let scar = &found["scar"];
    let sizes = [
        plain("Length of the scar", &scar["length_m"], "m"),
        plain("Width of the scar", &scar["width_m"], "m"),
        plain("Worn area", &found["worn_area_m2"], "m2"),
    ];
    let rows = VALUES.iter().filter_map(row).chain(sizes.into_iter().flatten()).collect();
    let heads = vec!["Quantity", "Value", "95 % interval"];
    Table { caption: "What is worn".to_owned(), heads, rows }
}

fn budget(found: &Value, (key, name, unit): &(&str, &str, &str)) -> Table {
    let row = |(source, words): &(&str, &str)| {
        let value = found[*key][*source].as_f64()?;
        Some(vec![(*words).to_owned(), quantity(value, unit)])
    };
    let rows = SOURCES.iter().filter_map(row).collect();
    let caption = format!("{name}: standard uncertainties");
    Table { caption, heads: vec!["Source", "Standard uncertainty"], rows }
}

fn placed(found: &Value) -> Table {
    let (own, by) = (&found["placement"], &found["placement_standard_uncertainty"]);
    let row = |name: &str, at: &dyn Fn(&Value) -> Option<f64>, unit: &str| {
        Some(vec![name.to_owned(), quantity(at(own)?, unit), quantity(at(by)?, unit)])
    };
    let rows = [
        row("Shift along x", &|own| own["shift_m"][0].as_f64(), "m"),
        row("Shift along y", &|own| own["shift_m"][1].as_f64(), "m"),
        row("Turn (rad)", &|own| own["turn_rad"].as_f64(), ""),
        row("Tilt along x", &|own| own["tilt"][0].as_f64(), ""),
        row("Tilt along y", &|own| own["tilt"][1].as_f64(), ""),
        Some(vec![
            "Scatter of the unworn surface".to_owned(),
            quantity(found["scatter_m"].as_f64().unwrap_or(f64::NAN), "m"),
            String::new(),
        ]),
    ];
    let heads = vec!["Quantity", "Value", "Standard uncertainty"];
    let caption = "The later scan on the earlier one".to_owned();
    Table { caption, heads, rows: rows.into_iter().flatten().collect() }
}
