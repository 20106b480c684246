//! The largest stresses and the damage below a contact, in words.

use serde_json::Value;

use crate::lines::Lines;
use crate::number::{count, four, length, percent};

/// Adds those of each body, from the block `stress` of a summary.
pub fn add(block: &Value, lines: &mut Lines) {
    for (body, own) in block.as_object().into_iter().flatten() {
        let all = ["inside", "surface"].map(|place| &own[place]["von_mises"]);
        let known = all.iter().filter_map(|own| Some((own["value_Pa"].as_f64()?, *own)));
        if let Some((value, largest)) = known.max_by(|one, other| one.0.total_cmp(&other.0)) {
            let place = match largest["depth_m"].as_f64() {
                Some(depth) if depth > 0.0 => format!("{} deep", length(depth)),
                _ => "on the surface".to_owned(),
            };
            let known = if all[1].is_null() { "; not known on the surface" } else { "" };
            let stress = format!("{} MPa, {place}{known}", four(value * 1e-6));
            lines.add(format!("von Mises ({body})"), stress, error(&largest["error_Pa"], value));
        }
        let damage = &own["damage"];
        if let Some(value) = damage["largest"].as_f64() {
            let name = format!("damage ({body})");
            lines.add(name, four(value), error(&damage["largest_error"], value));
        }
        if let Some(value) = damage["cycles_to_failure"].as_f64() {
            let off = error(&damage["cycles_to_failure_error"], value);
            lines.add(format!("failure ({body})"), format!("after {} cycles", count(value)), off);
        }
    }
}

/// What a value is off by.
fn error(stated: &Value, value: f64) -> String {
    let Some(error) = stated.as_f64() else { return "error not known".to_owned() };
    if error > 0.0 { format!("+- {}", percent(error / value)) } else { String::new() }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::add;
    use crate::lines::Lines;

    /// The larger of what is inside and on the surface, and whether both are known; a life where it is.
    #[test]
    fn what_is_known_has_its_line() {
        let stress = |value: f64, depth: f64| json!({ "value_Pa": value, "error_Pa": 2e6, "depth_m": depth });
        let damage = json!({
            "largest": 0.5, "largest_error": 0.05,
            "cycles_to_failure": 2300.0, "cycles_to_failure_error": null,
        });
        let block = json!({
            "ball": null,
            "disc": {
                "inside": { "von_mises": stress(1e8, 60e-6) },
                "surface": { "von_mises": null },
                "damage": null,
            },
            "flat": {
                "inside": { "von_mises": stress(1e8, 60e-6) },
                "surface": { "von_mises": stress(2e8, 0.0) },
                "damage": damage,
            },
        });
        let mut lines = Lines::default();
        add(&block, &mut lines);
        let found = format!("{lines:?}");
        for own in [
            r#"["von Mises (disc)", "100.0 MPa, 60.00 um deep; not known on the surface", "+- 2.0 %"]"#,
            r#"["von Mises (flat)", "200.0 MPa, on the surface", "+- 1.0 %"]"#,
            r#"["damage (flat)", "0.5000", "+- 10 %"]"#,
            r#"["failure (flat)", "after 2300 cycles", "error not known"]"#,
        ] {
            assert!(found.contains(own), "{found}");
        }
        assert!(!found.contains("ball"), "{found}");
    }
}
