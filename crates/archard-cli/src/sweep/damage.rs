//! What a study says of the damage of bodies.

use serde_json::Value;

/// What is read of the block of a body: its key, and what the column begins with.
const KNOWN: [(&str, &str); 4] = [
    ("largest", "damage"),
    ("largest_error", "error_of_damage"),
    ("left", "damage_left"),
    ("cycles_to_failure", "cycles_to_failure"),
];

/// The columns of the damage of each body in a summary, cycles infinite where no life was over; none where damage is not known.
pub fn of(summary: &Value) -> Vec<(String, String)> {
    let bodies = summary["stress"].as_object().into_iter().flatten();
    let all = bodies.flat_map(|(body, block)| {
        KNOWN.iter().filter_map(move |(key, name)| {
            let value = block["damage"].as_object()?[*key].as_f64().unwrap_or(f64::INFINITY);
            Some((format!("{name}_{body}"), format!("{value:?}")))
        })
    });
    all.collect()
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::of;

    #[test]
    fn what_is_not_known_has_no_column() {
        let damage = json!({ "largest": 0.5, "largest_error": 0.01, "left": 0.25, "cycles_to_failure": null });
        let summary =
            json!({ "stress": { "flat": { "damage": damage }, "ball": { "yield": null } } });
        let found = of(&summary);
        let found: Vec<(&str, &str)> =
            found.iter().map(|(name, value)| (name.as_str(), value.as_str())).collect();
        let known = [
            ("damage_flat", "0.5"),
            ("error_of_damage_flat", "0.01"),
            ("damage_left_flat", "0.25"),
            ("cycles_to_failure_flat", "inf"),
        ];
        assert_eq!(found, known);
        assert!(of(&json!({ "stress": null })).is_empty());
    }
}
