//! The page about two bodies that touch along a line which passes: gears, or a cam and its follower.

use std::path::Path;

use anyhow::Result;
use archard_case::files;
use serde_json::Value;

use super::figures::Figure;
use super::html::Html;
use super::page::{Header, Page, Sections, Table};
use super::words::{case, judged, quantity};
use super::{name_of, tables};
use crate::plot::cam::Cam;
use crate::plot::figure::Panel;
use crate::plot::gear::Gears;

/// What is told of a body: its key in the summary, words and unit.
type Told = &'static [(&'static str, &'static str, &'static str)];

const OF_GEARS: Told = &[
    ("wear_depth_m", "Deepest wear", "m"),
    ("at_diameter_m", "at a diameter of", "m"),
    ("worn_volume_of_a_flank_m3", "Volume worn off a flank", "m3"),
];
const OF_CAMS: Told = &[
    ("wear_depth_m", "Deepest wear", "m"),
    ("at_place_m", "from the middle of its face", "m"),
    ("worn_volume_m3", "Worn volume", "m3"),
];

/// What a page is about.
struct About {
    about: &'static str,
    /// The key of the bodies in the summary.
    bodies: &'static str,
    told: Told,
    /// The title of the pictures, and words to them.
    pictures: [&'static str; 2],
    panels: Vec<Panel>,
    summary: Value,
    mark: Option<String>,
}

/// The page of a folder of gears.
pub(super) fn of_gears(dir: &Path) -> Result<Page> {
    let gears = Gears::read(dir)?;
    let about = About {
        about: "two gears in mesh",
        bodies: "gears",
        told: OF_GEARS,
        pictures: [
            "Flanks",
            "The path of contact runs from T1, where the line of action touches the base circle of the first gear. Loads jump where a pair of teeth begins or ceases to touch.",
        ],
        panels: gears.panels(),
        summary: gears.summary,
        mark: gears.mark,
    };
    page(dir, about)
}

/// The page of a folder of a cam and its follower.
pub(super) fn of_cam(dir: &Path) -> Result<Page> {
    let cam = Cam::read(dir)?;
    let about = About {
        about: "a cam and its follower",
        bodies: "bodies",
        told: OF_CAMS,
        pictures: [
            "Surfaces",
            "Where the contact turns round on the follower, or rests, its pressure is swept along its path. Places are distances from the middle of the face.",
        ],
        panels: cam.panels(),
        summary: cam.summary,
        mark: cam.mark,
    };
    page(dir, about)
}

/// The page of a folder.
fn page(dir: &Path, about: About) -> Result<Page> {
    let title = name_of(dir);
    let About { about, bodies, told: keys, pictures: [heading, words], panels, summary, mark } =
        about;
    let of_bodies = || summary[bodies].as_array().into_iter().flatten();
    let mut all = Sections::default();
    let told = |body: &Value| {
        let row = |(key, words, unit): &(&str, &str, &str)| {
            let error = body[format!("error_of_{key}")].as_f64();
            let error = error.map_or_else(String::new, |error| quantity(error, unit));
            Some(vec![(*words).to_owned(), quantity(body[*key].as_f64()?, unit), error])
        };
        Table {
            caption: body["name"].as_str().unwrap_or_default().to_owned(),
            heads: vec!["Quantity", "Value", "Error"],
            rows: keys.iter().filter_map(row).collect(),
        }
    };
    let outcome: Html = of_bodies().map(|body| told(body).html()).collect();
    all.add("outcome", "What came out", &outcome);
    let figures = panels.iter().map(|panel| Ok(Figure::pictured(panel, words.to_owned())?.alone()));
    all.add("surfaces", heading, &figures.collect::<Result<Html>>()?);
    all.add("verdict", "Verdict", &tables::verdict(&summary).html());
    let text = files::read_text(&dir.join("case.toml")).unwrap_or_default();
    all.add("case", "The case", &case(&text));
    let glance = panels.first();
    let glance = glance.map(|panel| Figure::pictured(panel, String::new())).transpose()?;
    let depth = |body: &Value| {
        let error = quantity(body["error_of_wear_depth_m"].as_f64()?, "m");
        let depth = quantity(body["wear_depth_m"].as_f64()?, "m");
        Some([
            format!("Deepest wear of {}", body["name"].as_str()?),
            depth,
            format!("\u{b1} {error}"),
        ])
    };
    let header = Header {
        about,
        version: summary["version"].as_str().unwrap_or(env!("CARGO_PKG_VERSION")),
        title: &title,
        facts: vec![],
        verdict: judged(&summary),
        mark,
        lead: vec![],
        tiles: of_bodies().filter_map(depth).collect(),
        picture: glance.as_ref().map_or_else(Html::default, Figure::small),
    };
    let header = header.html(&all.there);
    Ok(Page { title, header, body: all.html, drawings: None })
}
