//! A case in words, from its printed form: a key a line, in SI.

use super::html::{Html, fill};
use super::page::capital;
use crate::plot::scale::superscript;
use archard_case::verdict::four;
use serde_json::Value;

/// Parts of a case under a heading: what each is called, and its words.
type Group = (String, Vec<(String, String)>);

/// What a reader asks first: how the bodies move and under which load, and of what shape and material each is.
pub(super) fn facts(case: &str) -> Vec<(String, String)> {
    let groups = grouped(case);
    let motion = groups.iter().filter(|(group, _)| group == "Motion");
    let motion =
        motion.flat_map(|(_, parts)| parts).map(|(name, text)| (capital(name), text.clone()));
    let bodies = groups.iter().filter(|(group, _)| group.starts_with(BODY));
    let body = |(group, parts): &Group| {
        let of = |what: &str| parts.iter().find(|(name, _)| name == what).map(|(_, text)| &**text);
        let said: Vec<&str> = ["profile", "mesh", "material"].into_iter().filter_map(of).collect();
        (capital(group.trim_start_matches(BODY)), said.join("; "))
    };
    motion.chain(bodies.map(body)).collect()
}

/// What the group of a body begins with.
const BODY: &str = "Body ";

/// The title of a case.
pub(super) fn title_of(case: &str) -> Option<String> {
    let title = case.lines().find_map(|line| line.strip_prefix("title = "))?;
    serde_json::from_str(title).ok()
}

/// The case by its parts, in words.
fn grouped(case: &str) -> Vec<Group> {
    let mut groups: Vec<Group> = Vec::new();
    for (key, value) in case.lines().filter_map(|line| line.split_once(" = ")) {
        let parts: Vec<&str> = key.split('.').collect();
        let (group, rest) = match &*parts {
            ["body", name, rest @ ..] => (format!("{BODY}{name}"), rest),
            ["title" | "solver" | "friction_solver", ..] => continue,
            [_, "boundary_elements", ..] => continue,
            [first, rest @ ..] => (capital(first), rest),
            [] => continue,
        };
        let place = groups.iter().position(|(known, _)| *known == group);
        let place = place.unwrap_or_else(|| {
            groups.push((group, Vec::new()));
            groups.len() - 1
        });
        let value = shown(value);
        let several = matches!(rest.last(), Some(&("at" | "doubles")));
        let value = if several { value.replace(" × ", ", ") } else { value };
        put(&mut groups[place].1, rest, &value);
    }
    groups
}

/// The case as a list of what it is made of, in HTML.
pub(super) fn case(case: &str) -> Html {
    let groups = grouped(case);
    let part = |(place, (name, text)): (usize, &(String, String))| {
        let text = match name.is_empty() {
            true => fill("{}", &[text]),
            false => fill("<b>{}</b>: {}", &[name, text]),
        };
        if place == 0 { text } else { Html::constant("<br>") + text }
    };
    let group = |(group, parts): &(String, Vec<(String, String)>)| {
        let parts: Html = parts.iter().enumerate().map(part).collect();
        fill("<dt>{}</dt><dd>{}</dd>\n", &[group, &parts])
    };
    let groups: Html = groups.iter().map(group).collect();
    fill("<dl>\n{}</dl>\n", &[&groups])
}

/// Adds a value below its part: `profile.sphere.radius` is "profile: sphere, radius 50 mm".
fn put(parts: &mut Vec<(String, String)>, keys: &[&str], value: &str) {
    let (part, words) = match keys {
        [] => (String::new(), value.to_owned()),
        [part @ ("material" | "thermal" | "symmetry" | "supports"), rest @ ..] => {
            ((*part).to_owned(), phrase(rest, value))
        }
        ["boundary_elements", ..] => return,
        [part @ ("profile" | "wear" | "mesh"), choice, rest @ ..] => {
            let choice = choice.replace('_', " ");
            let known = parts.iter().any(|(known, _)| known == part);
            let words = match (known, rest.is_empty()) {
                (true, _) => phrase(rest, value),
                (false, true) => choice,
                (false, false) => format!("{choice}, {}", phrase(rest, value)),
            };
            ((*part).to_owned(), words)
        }
        [choice, rest @ ..] if !rest.is_empty() => (choice.replace('_', " "), phrase(rest, value)),
        rest => (String::new(), phrase(rest, value)),
    };
    match parts.iter_mut().find(|(known, _)| *known == part) {
        Some((_, text)) => *text += &format!(", {words}"),
        None => parts.push((part, words)),
    }
}

/// "sliding.load" and "10 N" are "sliding load 10 N"; tables without values have none.
fn phrase(keys: &[&str], value: &str) -> String {
    let word = |key: &&str| match *key {
        "young" => "Young's modulus".to_owned(),
        "poisson" => "Poisson's ratio".to_owned(),
        "doubles" => "twice as wide from".to_owned(),
        key => key.replace('_', " "),
    };
    let name = keys.iter().map(word).collect::<Vec<_>>().join(" ");
    match value {
        "{}" | "true" => name,
        value => format!("{name} {value}"),
    }
}

/// A printed value in the units of a tribologist.
fn shown(value: &str) -> String {
    if let Some(list) = value.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
        let values: Vec<String> = list.split(", ").map(shown).collect();
        return values.join(" × ");
    }
    let text = value.trim_matches('"');
    match text.split_once(' ') {
        Some((number, unit)) if value.starts_with('"') => match number.parse::<f64>() {
            Ok(number) => quantity(number, unit),
            Err(_) => text.to_owned(),
        },
        _ => match (value.contains('.'), value.parse::<f64>()) {
            (true, Ok(number)) => plain(number),
            _ => text.to_owned(),
        },
    }
}

/// A value in SI as it is usually written.
pub(crate) fn quantity(value: f64, unit: &str) -> String {
    let (factor, unit) = usual(value.abs(), unit);
    format!("{} {unit}", plain(value * factor)).trim_end().to_owned()
}

/// Two values in SI in the unit of the larger, with one power of ten: "1.4 to 2.6 µm".
pub(super) fn range(low: f64, high: f64, unit: &str) -> String {
    let largest = low.abs().max(high.abs());
    let (factor, unit) = usual(largest, unit);
    let odd = |end: f64| end != 0.0 && !(1e-3..1e6).contains(&(end.abs() * factor));
    let power = match odd(low) || odd(high) {
        true => (largest * factor).log10().floor() as i32,
        false => 0,
    };
    let [low, high] = [low, high].map(|end| plain(end * factor * 10f64.powi(-power)));
    let ends = match power {
        0 => format!("{low} to {high}"),
        power => format!("({low} to {high})·10{}", superscript(power)),
    };
    format!("{ends} {unit}").trim_end().to_owned()
}

/// The unit in which a value of that size is usually written, with its factor from SI.
fn usual(size: f64, unit: &str) -> (f64, &str) {
    match unit {
        "m" if size >= 2e3 => (1e-3, "km"),
        "m" if size >= 2.0 => (1.0, "m"),
        "m" if size >= 1e-4 || size == 0.0 => (1e3, "mm"),
        "m" if size >= 1e-7 => (1e6, "µm"),
        "m" => (1e9, "nm"),
        "m^2" | "m2" => (1e6, "mm²"),
        "m^3" | "m3" => (1e9, "mm³"),
        "Pa" if size >= 5e9 => (1e-9, "GPa"),
        "Pa" => (1e-6, "MPa"),
        "1/Pa" | "m3_per_Nm" => (1e9, "mm³/(N m)"),
        "kg" => (1e6, "mg"),
        "J" if size >= 1.0 || size == 0.0 => (1.0, "J"),
        "J" if size >= 1e-3 => (1e3, "mJ"),
        "J" if size >= 1e-6 => (1e6, "µJ"),
        "J" => (1e9, "nJ"),
        "Nm" => (1e3, "N mm"),
        "rad" => (180.0 / std::f64::consts::PI, "°"),
        other => (1.0, other),
    }
}

/// Four digits without superfluous zeros.
pub(super) fn plain(value: f64) -> String {
    let digits = four(value);
    if digits.contains('e') {
        let (digits, power) = digits.split_once('e').unwrap_or((&digits, "0"));
        let digits = digits.trim_end_matches('0').trim_end_matches('.');
        return format!("{digits}·10{}", superscript(power.parse().unwrap_or_default()));
    }
    match digits.contains('.') {
        true => digits.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => digits,
    }
}

/// The class and the word of the verdict of a summary.
pub(super) fn judged(summary: &Value) -> (&'static str, String) {
    let word = summary["verdict"]["word"].as_str().unwrap_or("not judged");
    let sign = match word {
        "good" => "good",
        "wrong" => "wrong",
        _ => "doubtful",
    };
    (sign, word.to_owned())
}

#[cfg(test)]
mod tests {
    use super::{case, facts, quantity, range, title_of};

    #[test]
    fn a_page_begins_with_what_was_tested() {
        let printed = "title = \"A \\\"pin\\\"\"\n\nbody.pin.material.young = \"2.1e11 Pa\"\n\
             body.pin.profile.sphere.radius = \"0.05 m\"\nbody.pin.wear.archard.coefficient = \"1e-13 1/Pa\"\n\
             body.disc.profile.flat = {}\nframe.elements = [30, 30]\n\
             motion.sliding.load = \"10.2 N\"\nmotion.sliding.distance = \"500 m\"\n\
             motion.sliding.tolerance = 0.0008418530567457623\n";
        let facts = facts(printed);
        let told: Vec<(&str, &str)> =
            facts.iter().map(|(name, words)| (&**name, &**words)).collect();
        let known = [
            ("Sliding", "load 10.2 N, distance 500 m, tolerance 8.419·10⁻⁴"),
            ("Pin", "sphere, radius 50 mm; Young's modulus 210 GPa"),
            ("Disc", "flat"),
        ];
        assert_eq!(told, known);
        assert_eq!(title_of(printed).as_deref(), Some("A \"pin\""));
    }

    #[test]
    fn a_case_reads_as_a_list() {
        let printed = "title = \"t\"\n\nbody.pin.material.young = \"2.1e11 Pa\"\n\
             body.pin.material.poisson = 0.3\nbody.pin.profile.sphere.radius = \"0.05 m\"\n\
             body.pin.wear.archard.coefficient = \"1.33e-13 1/Pa\"\nbody.disc.profile.flat = {}\n\
             frame.size = [\"0.0012 m\", \"0.0012 m\"]\nframe.elements = [30, 30]\n\
             frame.doubles = [\"0.05 m\", \"2.5 m\"]\n\
             motion.sliding.load = \"10.2 N\"\nmotion.sliding.distance = \"0.5 m\"\n\
             solver.conjugate_gradient = {}\n";
        let words = case(printed);
        let words = words.as_str();
        for part in [
            "<dt>Body pin</dt><dd><b>material</b>: Young&#39;s modulus 210 GPa, Poisson&#39;s ratio 0.3<br><b>profile</b>: sphere, radius 50 mm",
            "coefficient 1.33·10⁻⁴ mm³/(N m)",
            "<b>profile</b>: flat",
            "size 1.2 mm × 1.2 mm, elements 30 × 30, twice as wide from 50 mm, 2.5 m",
            "<b>sliding</b>: load 10.2 N, distance 500 mm",
        ] {
            assert!(words.contains(part), "{part} is not in\n{words}");
        }
        assert!(!words.contains("conjugate"));
    }

    #[test]
    fn values_have_usual_units() {
        assert_eq!(quantity(2.05e-6, "m"), "2.05 µm");
        assert_eq!(quantity(219.06e6, "Pa"), "219.1 MPa");
        assert_eq!(quantity(6.783e-13, "m3"), "6.783·10⁻⁴ mm³");
        assert_eq!(quantity(0.0, "m"), "0 mm");
        assert_eq!(quantity(25.0, ""), "25");
        assert_eq!(range(1.413e-6, 2.634e-6, "m"), "1.413 to 2.634 µm");
        assert_eq!(range(0.714e-13, 2.283e-13, "1/Pa"), "(0.714 to 2.283)·10⁻⁴ mm³/(N m)");
        assert_eq!(range(3.336e-13, 1.118e-12, "m3"), "(0.3336 to 1.118)·10⁻³ mm³");
        assert_eq!(range(0.0, 0.0, "m"), "0 to 0 mm");
    }
}
