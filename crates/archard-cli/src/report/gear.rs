//! The page about two gears in mesh.

use std::path::Path;

use anyhow::Result;
use archard_case::files;

use super::figures::Figure;
use super::html::Html;
use super::page::{Header, Page, Sections, Table};
use super::words::{case, judged, quantity};
use super::{name_of, tables};
use crate::plot::gear::Gears;

/// What is told of a gear: its key in the summary, words and unit.
const TOLD: [(&str, &str, &str); 3] = [
    ("wear_depth_m", "Deepest wear", "m"),
    ("at_diameter_m", "at a diameter of", "m"),
    ("worn_volume_of_a_flank_m3", "Volume worn off a flank", "m3"),
];

const WORDS: &str = "The path of contact runs from T1, where the line of action touches the base circle of the first gear. Loads jump where a pair of teeth begins or ceases to touch.";

/// The page of a folder.
pub(super) fn page(dir: &Path) -> Result<Page> {
    let gears = Gears::read(dir)?;
    let title = name_of(dir);
    let summary = &gears.summary;
    let of_gears = || summary["gears"].as_array().into_iter().flatten();
    let mut all = Sections::default();
    let told = |gear: &serde_json::Value| {
        let row = |(key, words, unit): &(&str, &str, &str)| {
            let error = gear[format!("error_of_{key}")].as_f64();
            let error = error.map_or_else(String::new, |error| quantity(error, unit));
            Some(vec![(*words).to_owned(), quantity(gear[*key].as_f64()?, unit), error])
        };
        Table {
            caption: gear["name"].as_str().unwrap_or_default().to_owned(),
            heads: vec!["Quantity", "Value", "Error"],
            rows: TOLD.iter().filter_map(row).collect(),
        }
    };
    let outcome: Html = of_gears().map(|gear| told(gear).html()).collect();
    all.add("outcome", "What came out", &outcome);
    let panels = gears.panels();
    let figures = panels.iter().map(|panel| Ok(Figure::pictured(panel, WORDS.to_owned())?.alone()));
    all.add("flanks", "Flanks", &figures.collect::<Result<Html>>()?);
    all.add("verdict", "Verdict", &tables::verdict(summary).html());
    let text = files::read_text(&dir.join("case.toml")).unwrap_or_default();
    all.add("case", "The case", &case(&text));
    let glance = panels.first();
    let glance = glance.map(|panel| Figure::pictured(panel, String::new())).transpose()?;
    let depth = |gear: &serde_json::Value| {
        let error = quantity(gear["error_of_wear_depth_m"].as_f64()?, "m");
        let depth = quantity(gear["wear_depth_m"].as_f64()?, "m");
        Some([
            format!("Deepest wear of {}", gear["name"].as_str()?),
            depth,
            format!("\u{b1} {error}"),
        ])
    };
    let header = Header {
        about: "two gears in mesh",
        version: summary["version"].as_str().unwrap_or(env!("CARGO_PKG_VERSION")),
        title: &title,
        facts: vec![],
        verdict: judged(summary),
        mark: gears.mark.clone(),
        lead: vec![],
        tiles: of_gears().filter_map(depth).collect(),
        picture: glance.as_ref().map_or_else(Html::default, Figure::small),
    };
    let header = header.html(&all.there);
    Ok(Page { title, header, body: all.html, drawings: None })
}
