//! The largest stresses in half-spaces, in a table.

use serde_json::Value;

use super::page::{Table, capital};
use super::words::quantity;
use crate::plot::results::Results;

/// What is looked for, by the keys of the summary.
const MEASURES: [(&str, &str); 4] = [
    ("von_mises", "equivalent stress (von Mises)"),
    ("shear", "shear on any plane"),
    ("tension", "tension"),
    ("orthogonal_shear", "shear parallel to the surface"),
];

/// What is looked for at an interface of layers.
const INTERFACES: [(&str, &str); 7] = [
    ("/above/along_surface_most", "largest stress along the surface above"),
    ("/above/along_surface_least", "least stress along the surface above"),
    ("/below/along_surface_most", "largest stress along the surface below"),
    ("/below/along_surface_least", "least stress along the surface below"),
    ("/zz_most", "largest stress across the layers"),
    ("/zz_least", "least stress across the layers"),
    ("/orthogonal_shear", "shear parallel to the surface"),
];

/// A row a largest stress; without rows where none was asked for.
pub(super) fn table(results: &Results) -> Table {
    let bodies = results.summary["stress"].as_object();
    let rows = bodies.into_iter().flatten().flat_map(|(body, block)| {
        let places = [("inside", "below the surface"), ("surface", "on the surface")];
        let all = places.into_iter().flat_map(move |(key, place)| {
            MEASURES
                .iter()
                .filter_map(move |(name, what)| row(&block[key][name], body, (what, place)))
        });
        let crossing = block["interfaces"].as_array().into_iter().flatten();
        let crossing = crossing.flat_map(move |own| {
            INTERFACES.iter().filter_map(move |(path, what)| {
                row(own.pointer(path)?, body, (what, "at the interface"))
            })
        });
        let on_top = INTERFACES[..2].iter().filter_map(move |(path, what)| {
            let own = block["surface"].pointer(path.trim_start_matches("/above"))?;
            row(own, body, (what.trim_end_matches(" above"), "on the surface"))
        });
        let worn = tired(block, body).into_iter().chain(damaged(&block["damage"], body));
        all.chain(on_top).chain(crossing).chain(used(&block["yield"], body)).chain(worn)
    });
    Table {
        caption: "The largest stresses at the end, tension positive, with what the size of elements leaves open".to_owned(),
        heads: vec!["Stress", "Value", "Error"],
        rows: rows.collect(),
    }
}

fn row(one: &Value, body: &str, (what, place): (&str, &str)) -> Option<Vec<String>> {
    let number = |key: &str| one[key].as_f64();
    let depth = number("depth_m").filter(|depth| *depth > 0.0);
    let deep = depth.map_or(String::new(), |depth| format!(", {} deep", quantity(depth, "m")));
    Some(vec![
        format!("{}, {place} of {body}{deep}", capital(what)),
        quantity(number("value_Pa")?, "Pa"),
        quantity(number("error_Pa")?, "Pa"),
    ])
}

/// A row a criterion of fatigue.
fn tired(block: &Value, body: &str) -> Vec<Vec<String>> {
    let criteria = block["fatigue"].as_object().into_iter().flatten();
    let row = |(name, own): (&String, &Value)| {
        let unit = own["unit"].as_str()?;
        let shown = |key: &str| Some(quantity(own[key].as_f64()?, unit));
        let what = format!("Fatigue of {body} by {}", name.replace('_', " "));
        Some(vec![what, shown("value")?, shown("error")?])
    };
    criteria.filter_map(row).collect()
}

/// The damage over the run, and the cycles to its being one.
fn damaged(block: &Value, body: &str) -> Vec<Vec<String>> {
    let rows = [
        ("largest", format!("Largest damage of {body}, of one at the end of a life")),
        ("left", format!("The same of what is not worn off {body}")),
        ("cycles_to_failure", format!("Cycles to the end of a life of {body}")),
    ];
    let row = |(key, what): (&str, String)| {
        let shown = |key: &str| Some(quantity(block[key].as_f64()?, ""));
        Some(vec![what, shown(key)?, shown(&format!("{key}_error"))?])
    };
    rows.into_iter().filter_map(row).collect()
}

/// How much of the strength is used.
fn used(block: &Value, body: &str) -> Option<Vec<String>> {
    let number = |key: &str| block[key].as_f64();
    let state = block["state"].as_str()?;
    Some(vec![
        format!("Of the yield stress of {body} ({state})"),
        format!("{:.3}", number("utilisation")?),
        format!("{:.1e}", number("utilisation_error")?),
    ])
}
