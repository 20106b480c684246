//! Closed forms next to what was computed, in a table.

use archard::closed_form::Hertz;
use archard::simulation::history::{
    APPROACH, BODY_DEPTH, CENTRE_PRESSURE, CONTACT_AREA, FLASH_TEMPERATURE, FORCE, LOAD,
    MEAN_FLASH_TEMPERATURE, SCAR, WEAR_DEPTH, WORN_SECTION, WORN_VOLUME, of_body,
};

use super::page::Table;
use super::words::quantity;
use crate::plot::results::Results;
use crate::plot::tables::size;

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
