//! What a run came to, in tables: its numbers, its verdict, and closed forms next to both.

use archard::closed_form::Hertz;
use archard::motion::Control;
use archard::numerics::SAME;
use archard::simulation::history::{
    APPROACH, BODY_DEPTH, CENTRE_PRESSURE, COLUMNS, CONTACT_AREA, CREEPAGE, CYCLE, Column, ERROR,
    FLASH_TEMPERATURE, FORCE, LOAD, MASS_LOSS, MEAN_FLASH_TEMPERATURE, PEAK_PRESSURE, SCAR, SHIFT,
    TRACK_WIDTH, WEAR_DEPTH, WEAR_RATE, WORN_SECTION, WORN_VOLUME, body_of, is_error, of_body,
};
use serde_json::Value;

use super::page::{Table, capital};
use super::words::{plain, quantity};
use crate::number::{count, percent};
use crate::plot::results::Results;
use crate::plot::scale::phrase;
use crate::plot::tables::size;

/// Columns that say how a run was computed, not what came of it.
const WORK: [&str; 8] = [
    "iterations",
    "residual",
    "solves",
    "rejected",
    "true_cycles",
    "time_error",
    "space_error",
    ERROR,
];

/// The last row of the history, each number with the error that is stated for it.
pub(super) fn results(results: &Results) -> Table {
    let history = &results.history;
    let last = |column: &str| history.column(column).ok().and_then(|values| values.last().copied());
    let still = |name: &str| {
        let whose = results.bodies.iter().position(|body| {
            let belongs = |column: &Column| body_of(column.name, name) == Some(body.as_str());
            COLUMNS.iter().any(belongs)
        });
        whose.is_some_and(|body| !results.has_worn(body))
    };
    let worn = (0..results.bodies.len()).filter(|&body| results.has_worn(body)).count();
    let mut rows = Vec::new();
    for name in history.names() {
        let errors = is_error(name);
        let Some(value) = last(name).filter(|value| value.is_finite() && !errors) else { continue };
        // What does not wear has nothing to say, and of one body the depth is that of both.
        let twice = name == WEAR_DEPTH && worn < 2;
        if WORK.contains(&name) || still(name) || twice {
            continue;
        }
        let (label, unit) = match label(&results.bodies, name) {
            (label, unit) if name == WEAR_DEPTH => (format!("{label} of both"), unit),
            named => named,
        };
        let value = but_rounding(results, name, (value, unit));
        let whole = unit.is_empty() && value == value.round();
        let shown = if whole { count(value) } else { quantity(value, unit) };
        rows.push(vec![label, shown, error(results, name, value, unit)]);
    }
    let (column, values) = results.progress();
    let end = values.last().copied().unwrap_or_default();
    let end = quantity(
        end,
        COLUMNS_OF_PROGRESS.iter().find(|(known, _)| *known == column).map_or("", |(_, unit)| unit),
    );
    let mut heads = vec!["Quantity", "Value", "Error"];
    if !states_errors(results) {
        heads.pop();
        rows.iter_mut().for_each(|row: &mut Vec<String>| row.truncate(2));
    }
    Table { caption: format!("Numbers at {} {end}", phrase(column).to_lowercase()), heads, rows }
}

/// Whether a run states errors at all.
fn states_errors(results: &Results) -> bool {
    results.history.names().any(is_error)
}

/// Units of forces and moments.
const FORCES: [&str; 2] = ["N", "Nm"];

/// What is nothing but rounding in a column: a force (N) or moment (N m) under the load, a component next to the other.
fn rounding(results: &Results, name: &str, unit: &str) -> f64 {
    let column = |name: &str| results.history.column(name).unwrap_or_default();
    if FORCES.contains(&unit) {
        return SAME * column(LOAD).last().copied().unwrap_or_default();
    }
    let pair = [SHIFT, CREEPAGE].into_iter().find(|pair| pair.contains(&name));
    SAME * pair.into_iter().flatten().map(|name| size(column(name))).fold(0.0, f64::max)
}

/// A value of a column, zero where it is nothing but rounding.
fn but_rounding(results: &Results, name: &str, (value, unit): (f64, &str)) -> f64 {
    if value.abs() < rounding(results, name, unit) { 0.0 } else { value }
}

/// What a case may prescribe, besides how far the motion goes.
const PRESCRIBED: [&str; 8] =
    [LOAD, APPROACH, SHIFT[0], SHIFT[1], FORCE[0], FORCE[1], CREEPAGE[0], CREEPAGE[1]];

/// The error of a number, or why it has none.
fn error(results: &Results, name: &str, value: f64, unit: &str) -> String {
    let prescribed = PRESCRIBED.contains(&name);
    let (progress, _) = results.progress();
    if [progress, "turns", "time_s", CYCLE].contains(&name) {
        return "prescribed".to_owned();
    }
    if name == APPROACH && is_pressed_by_approach(results) {
        return "prescribed".to_owned();
    }
    match stated(results, name) {
        // What symmetry makes nothing.
        Some(error) if value == 0.0 && error <= rounding(results, name, unit) => "exact".to_owned(),
        Some(error) if error <= SAME * value.abs() && prescribed => "prescribed".to_owned(),
        Some(error) if error <= SAME * value.abs() => "exact".to_owned(),
        Some(error) if value != 0.0 => format!("± {}", percent(error / value.abs())),
        Some(error) => format!("± {}", quantity(error, unit)),
        None => reason(name).to_owned(),
    }
}

/// Whether the case gives the approach, and the load is what came of it.
fn is_pressed_by_approach(results: &Results) -> bool {
    let planned = results.case.as_ref().and_then(|case| case.motion.build().ok());
    planned.is_some_and(|(_, schedule)| matches!(schedule.control, Control::Approach(_)))
}

/// The error that is stated of a column, or of the worn volume that it is a multiple of.
fn stated(results: &Results, name: &str) -> Option<f64> {
    let of = |column: &str| results.error(column).and_then(|errors| errors.last().copied());
    let last = |column: &str| results.history.column(column).ok()?.last().copied();
    let of_volume = || {
        let multiple = |body: &String| {
            [MASS_LOSS, WEAR_RATE].into_iter().any(|own| of_body(own, body) == name)
        };
        let volume = of_body(WORN_VOLUME, results.bodies.iter().find(|body| multiple(body))?);
        let relative = of(&volume)? / last(&volume).filter(|volume| *volume > 0.0)?;
        Some(relative * last(name)?.abs())
    };
    of(name).or_else(of_volume)
}

/// Why no error is stated of a column.
fn reason(name: &str) -> &'static str {
    match name {
        _ if SCAR.contains(&name) || name == TRACK_WIDTH => {
            "not estimated: about one element at each end"
        }
        FLASH_TEMPERATURE | MEAN_FLASH_TEMPERATURE => "not estimated: follows the pressures",
        _ => "not estimated: does not count for the accuracy",
    }
}

/// The columns of the progress that have units.
const COLUMNS_OF_PROGRESS: [(&str, &str); 2] = [("distance_m", "m"), ("time_s", "s")];

/// What a column is called, with its body where it belongs to one, and its unit.
pub(super) fn label(bodies: &[String], name: &str) -> (String, &'static str) {
    let called = |name: &str, unit: &str| {
        let bare = name.strip_suffix(unit).map_or(name, |bare| bare.trim_end_matches('_'));
        phrase(if unit.is_empty() { name } else { bare })
    };
    if let Some(column) = COLUMNS.iter().find(|column| column.name == name) {
        return (called(name, column.unit), column.unit);
    }
    for body in bodies {
        let belongs = |column: &&Column| body_of(column.name, name) == Some(body.as_str());
        if let Some(column) = COLUMNS.iter().find(belongs) {
            let bare = column.name.replacen("_BODY", "", 1);
            return (format!("{} of {body}", called(&bare, column.unit)), column.unit);
        }
    }
    let unit = COLUMNS_OF_PROGRESS.iter().find(|(known, _)| *known == name);
    let unit = unit.map_or("", |(_, unit)| unit);
    (called(name, unit), unit)
}

/// What is read first: name, value and error of a few numbers at the end.
pub(super) fn first(results: &Results) -> Vec<[String; 3]> {
    let last = |column: &str| {
        let values = results.history.column(column).ok()?;
        values.last().copied().filter(|value| *value != 0.0)
    };
    let mut names: Vec<String> = Vec::new();
    for body in &results.bodies {
        names.extend([BODY_DEPTH, WORN_VOLUME, WORN_SECTION].map(|column| of_body(column, body)));
    }
    if names.iter().all(|name| last(name).is_none()) {
        names.extend([LOAD, APPROACH, CONTACT_AREA, FORCE[0]].map(str::to_owned));
    }
    names.extend([SCAR[0], SCAR[1], TRACK_WIDTH].map(str::to_owned));
    names.extend([PEAK_PRESSURE, FLASH_TEMPERATURE].map(str::to_owned));
    let errors = states_errors(results);
    let shown = |name: String| {
        let (label, unit) = label(&results.bodies, &name);
        let value = but_rounding(results, &name, (last(&name)?, unit));
        if value == 0.0 {
            return None;
        }
        let error = if errors { error(results, &name, value, unit) } else { String::new() };
        let error = if error.starts_with("not") { String::new() } else { error };
        Some([label, quantity(value, unit), error])
    };
    names.into_iter().filter_map(shown).collect()
}

/// The verdict, line by line.
pub(super) fn verdict(summary: &Value) -> Table {
    let lines = summary["verdict"]["lines"].as_array().map_or(&[][..], Vec::as_slice);
    let row = |line: &Value| {
        let text = |key: &str| line[key].as_str().map(str::to_owned);
        // Summaries of earlier versions have no words of their own.
        let value = || line["value"].as_f64().map_or_else(|| "no number".to_owned(), plain);
        let words = text("words");
        let words =
            words.unwrap_or_else(|| format!("{} {}", value(), text("text").unwrap_or_default()));
        let [subject, word] = ["subject", "word"].map(|key| text(key).unwrap_or_default());
        vec![capital(&subject), word, words]
    };
    Table {
        caption: "What was judged".to_owned(),
        heads: vec!["Check", "Verdict", "Finding"],
        rows: lines.iter().map(row).collect(),
    }
}

/// A closed form next to what was computed.
struct Pair<'a> {
    what: String,
    theory: &'static str,
    unit: &'a str,
    expected: f64,
    computed: f64,
}

impl Pair<'_> {
    fn row(self) -> Vec<String> {
        let Self { what, theory, unit, expected, computed } = self;
        let difference = 100.0 * (computed / expected - 1.0);
        let difference = match difference {
            none if !none.is_finite() => "\u{2013}".to_owned(),
            small if small.abs() < 0.005 => "within 0.01 %".to_owned(),
            other => format!("{other:+.2} %").replace('-', "\u{2212}"),
        };
        let computed = match difference.as_str() {
            "\u{2013}" => quantity(computed, unit),
            _ => format!("{} ({difference})", quantity(computed, unit)),
        };
        vec![format!("{what} ({theory})"), quantity(expected, unit), computed]
    }
}

/// Every closed form that is known of the run next to what came of it.
pub(super) fn closed_forms(results: &Results) -> Table {
    let mut pairs = Vec::new();
    contact(results, &mut pairs);
    shifted(results, &mut pairs);
    rolled(results, &mut pairs);
    worn(results, &mut pairs);
    let row = |pair: Pair<'_>| pair.row();
    let known = |pair: &Pair<'_>| pair.expected.is_finite() && pair.expected != 0.0;
    Table {
        caption: "What theory says and what was computed; areas count whole elements".to_owned(),
        heads: vec!["Quantity", "Theory", "Computed (difference)"],
        rows: pairs.into_iter().filter(known).map(row).collect(),
    }
}

/// Hertz's contact next to the unworn one.
fn contact(results: &Results, pairs: &mut Vec<Pair<'_>>) {
    if results.closed_form["hertz"].is_null() {
        return;
    }
    let history = &results.history;
    let row = if results.wears() { 0 } else { history.rows() - 1 };
    let at = |column: &str| history.column(column).ok().and_then(|values| values.get(row).copied());
    let Some(hertz) = at(LOAD).and_then(|load| results.hertz(load)) else { return };
    let Hertz { semi_axes: [a, b], peak_pressure, approach, load } = hertz;
    let when = if results.wears() { " of the unworn bodies" } else { "" };
    let mut add = |what: &str, column: &str, unit, expected: f64| {
        if let Some(computed) = at(column).filter(|_| load > 0.0) {
            let what = format!("{what}{when}");
            pairs.push(Pair { what, theory: "Hertz, no friction", unit, expected, computed });
        }
    };
    add("Pressure at the centre", CENTRE_PRESSURE, "Pa", peak_pressure);
    let known = results.closed_form["hertz"]["approach_m"].as_f64();
    if known.is_some() {
        let line = !b.is_finite();
        add("Approach", APPROACH, "m", if line { known.unwrap_or_default() } else { approach });
    }
    if b.is_finite() {
        add("Contact area", CONTACT_AREA, "m2", std::f64::consts::PI * a * b);
    }
}

/// Bodies that are pressed and shifted with friction.
fn shifted(results: &Results, pairs: &mut Vec<Pair<'_>>) {
    let last = |column: &str| {
        results.history.column(column).ok().and_then(|values| values.last().copied())
    };
    let block = &results.closed_form["spence"];
    for (what, key, column, unit) in
        [("Load", "load_N", LOAD, "N"), ("Approach", "approach_m", APPROACH, "m")]
    {
        if let Some((expected, computed)) = block[key].as_f64().zip(last(column)) {
            let (what, theory) = (format!("{what} of the bonded edge"), "Spence, with friction");
            let what = what.replace(" of the bonded edge", "");
            pairs.push(Pair { what, theory, unit, expected, computed });
        }
    }
    let block = &results.closed_form["cattaneo_mindlin"];
    if block.is_null() || results.wears() {
        return;
    }
    let axis = if block["axis"] == "y" { 1 } else { 0 };
    let force = results.loops.last().and_then(|table| table.column(FORCE[axis]).ok().map(size));
    let theory = "Cattaneo and Mindlin";
    if let Some((expected, computed)) = block["force_amplitude_N"].as_f64().zip(force) {
        pairs.push(Pair {
            what: "Amplitude of the force".into(),
            theory,
            unit: "N",
            expected,
            computed,
        });
    }
    let dissipated = last("dissipated_J");
    if let Some((expected, computed)) = block["dissipated_per_cycle_J"].as_f64().zip(dissipated) {
        pairs.push(Pair {
            what: "Dissipated in a cycle".into(),
            theory,
            unit: "J",
            expected,
            computed,
        });
    }
}

/// Bodies that roll.
fn rolled(results: &Results, pairs: &mut Vec<Pair<'_>>) {
    let last = |column: &str| {
        results.history.column(column).ok().and_then(|values| values.last().copied())
    };
    let block = &results.closed_form["flash_temperature"];
    for (what, key, column) in [
        ("Largest flash temperature", "largest_K", FLASH_TEMPERATURE),
        ("Mean flash temperature", "mean_K", MEAN_FLASH_TEMPERATURE),
    ] {
        if let Some((expected, computed)) = block[key].as_f64().zip(last(column)) {
            let theory = "uniform band of heat, unworn";
            pairs.push(Pair { what: what.into(), theory, unit: "K", expected, computed });
        }
    }
    if !results.rolls() {
        return;
    }
    let row = if results.wears() { 0 } else { results.history.rows() - 1 };
    let at = |column: &str| {
        results.history.column(column).ok().and_then(|values| values.get(row).copied())
    };
    let when = if results.wears() { " of the unworn bodies" } else { "" };
    let end = at(results.progress().0).unwrap_or_default();
    let estimates =
        results.case.as_ref().map_or(vec![], |case| case.estimates(std::iter::once(end)));
    let Some(rolled) = estimates.first().and_then(|estimate| estimate.rolled) else { return };
    let (Some([along, across]), Some((x, y))) = (rolled.force, at(FORCE[0]).zip(at(FORCE[1])))
    else {
        return;
    };
    let theory = if rolled.line { "Carter" } else { "Vermeulen and Johnson" };
    let what = format!("Creep force{when}");
    pairs.push(Pair {
        what,
        theory,
        unit: "N",
        expected: along.hypot(across),
        computed: x.hypot(y),
    });
}

/// Bodies that wear.
fn worn(results: &Results, pairs: &mut Vec<Pair<'_>>) {
    let last = |column: &str| {
        results.history.column(column).ok().and_then(|values| values.last().copied())
    };
    // What the coefficient multiplies: load and distance, the work of the creepages, the energy of cycles.
    let of_volumes = if results.summary["dissipated_J"].is_null() { "k F s" } else { "k E / mu" };
    for body in &results.bodies {
        let block = &results.summary["wear"][&**body];
        for (column, key, what, work, unit) in [
            (WORN_VOLUME, "expected_volume_m3", "Worn volume", of_volumes, "m3"),
            (WORN_SECTION, "expected_section_m2", "Worn section", "k W / mu", "m2"),
        ] {
            if let Some((expected, computed)) =
                block[key].as_f64().zip(last(&of_body(column, body)))
            {
                pairs.push(Pair {
                    what: format!("{what} of {body}"),
                    theory: work,
                    unit,
                    expected,
                    computed,
                });
            }
        }
        let standard = &block["standard"];
        if let Some((expected, computed)) =
            standard["volume_m3"].as_f64().zip(last(&of_body(WORN_VOLUME, body)))
        {
            let name = ["ASTM G99", "ASTM G133", "ASTM G77"]
                .into_iter()
                .find(|name| standard["name"] == *name);
            let theory = name.unwrap_or("standard");
            let what = format!(
                "Worn volume of {body} from its {}",
                standard["measured"].as_str().unwrap_or("scar")
            );
            pairs.push(Pair { what, theory, unit: "m3", expected, computed });
        }
    }
    let known = |block: &str, key: &str| results.closed_form[block][key].as_f64();
    let mut add = |what: &str, theory, expected: Option<f64>, computed: Option<f64>| {
        if let Some((expected, computed)) = expected.zip(computed) {
            pairs.push(Pair { what: what.to_owned(), theory, unit: "m", expected, computed });
        }
    };
    let depth = last(WEAR_DEPTH);
    add("Wear depth", "sphere worn flat, no elasticity", known("pin_on_disc", "depth_m"), depth);
    add(
        "Wear depth",
        "discs, incremental model",
        known("twin_discs", "incremental_depth_m"),
        depth,
    );
    add("Wear depth", "discs, uniform line load", known("twin_discs", "line_load_depth_m"), depth);
    add(
        "Wear depth at last",
        "end of fretting wear, stick zone kept",
        known("fretting_wear", "wear_depth_m"),
        depth,
    );
    let passes = |body: &&String| last(&of_body(WORN_SECTION, body)).is_some();
    let (passing, staying) =
        (results.bodies.iter().find(passes), results.bodies.iter().find(|body| !passes(body)));
    let of = |body: Option<&String>| last(&of_body(BODY_DEPTH, body?));
    add(
        "Depth of the scar",
        "rigid bodies on a track",
        known("worn_track", "scar_depth_m"),
        of(staying),
    );
    add(
        "Depth of the groove",
        "rigid bodies on a track",
        known("worn_track", "groove_depth_m"),
        of(passing),
    );
    add(
        "Length of the scar",
        "rigid bodies on a track",
        known("worn_track", "contact_length_m"),
        last(SCAR[0]),
    );
    add(
        "Width of the scar",
        "rigid bodies on a track",
        known("worn_track", "contact_width_m"),
        last(SCAR[1]),
    );
}
