//! What varied in a row and what came out of it, in words; and over all rows the median and the interval.

use archard::simulation::history::{
    BODY_DEPTH, FORCE, PEAK_PRESSURE, STICK_AREA, WEAR_DEPTH, of_body,
};
use archard_case::Case;

use super::design::{Design, Row};
use super::table::{RowState, Status};
use super::{life, values};
use crate::number::four;
use crate::plot::quantile;

/// Shares of the rows below the ends of an interval: 90 % of samples, all of what is gone over.
const SAMPLED: [f64; 2] = [0.05, 0.95];
const ALL: [f64; 2] = [0.0, 1.0];

/// A number that rows are told by: its name, its column, and the unit that it is shown in with the factor from SI.
pub struct Quantity {
    name: String,
    pub column: String,
    unit: &'static str,
    factor: f64,
}

impl Quantity {
    pub fn new(
        name: impl Into<String>,
        column: impl Into<String>,
        (unit, factor): (&'static str, f64),
    ) -> Self {
        Self { name: name.into(), column: column.into(), unit, factor }
    }

    /// The same with the unit.
    pub fn with_unit(&self, value: f64) -> String {
        let unit = if value.is_finite() { self.unit } else { "" };
        format!("{} {unit}", self.show(value)).trim_end().to_owned()
    }

    /// Four digits of a value (SI); of a life that no limit ended, what can be said.
    pub fn show(&self, value: f64) -> String {
        if value.is_finite() { four(value * self.factor) } else { "beyond the motion".to_owned() }
    }
}

/// The numbers that tell a row of a case: depths of each body, where any wears, the peak pressure, and what friction passes
/// on where nothing wears.
fn quantities(case: &Case, known: &RowState) -> Vec<Quantity> {
    let present = |quantity: &Quantity| known.number(&quantity.column).is_some();
    let pressure = Quantity::new("peak pressure", PEAK_PRESSURE, ("MPa", 1e-6));
    if known.number(WEAR_DEPTH).is_none_or(|depth| depth == 0.0) {
        let friction = ["force x", "force y"].into_iter().zip(FORCE);
        let friction = friction.map(|(name, column)| Quantity::new(name, column, ("N", 1.0)));
        let stick = Quantity::new("stick area", STICK_AREA, ("mm^2", 1e6));
        return [pressure].into_iter().chain(friction).chain([stick]).filter(present).collect();
    }
    let depth = |name: &String| {
        let column = of_body(BODY_DEPTH, name);
        Quantity::new(format!("wear depth ({name})"), column, ("um", 1e6))
    };
    let worn =
        |quantity: &Quantity| known.number(&quantity.column).is_some_and(|depth| depth > 0.0);
    let names = case.bodies.iter().map(|body| &body.name);
    let depths: Vec<Quantity> = names.map(depth).filter(worn).collect();
    depths.into_iter().chain(life::quantity(case)).chain([pressure]).collect()
}

/// "row 3, load 10 N: wear depth (pin) 1.459 um, peak pressure 25.13 MPa (good)".
pub fn row(design: &Design, index: usize, known: &RowState) -> String {
    let row = &design.rows[index];
    let quantities = quantities(&row.resolved.case, known);
    let came: Vec<String> = quantities
        .iter()
        .filter_map(|known_by| {
            let value = known_by.with_unit(known.number(&known_by.column)?);
            Some(format!("{} {value}", known_by.name))
        })
        .collect();
    let end = if came.is_empty() {
        String::new()
    } else {
        format!(": {} ({})", came.join(", "), known.verdict)
    };
    format!("row {}, {}{end}", index + 1, varied(design, row, design.keys.len()))
}

/// "load 10 N, radius 25 mm": the first keys with their values, samples to four digits.
fn varied(design: &Design, row: &Row, keys: usize) -> String {
    let value = |(place, given): (usize, &String)| match values::number(given) {
        Ok((value, unit)) if place >= design.over => {
            format!("{} {unit}", four(value)).trim_end().to_owned()
        }
        _ => given.clone(),
    };
    let values = row.given.iter().enumerate().map(value);
    let names = short(&design.keys);
    let all: Vec<String> = names
        .into_iter()
        .zip(values)
        .take(keys)
        .map(|(name, value)| format!("{name} {value}"))
        .collect();
    all.join(", ")
}

/// The ends of keys that tell them apart: `load` of `motion.sliding.load`.
fn short(keys: &[String]) -> Vec<&str> {
    keys.iter().map(|key| end_of(key, keys)).collect()
}

fn end_of<'a>(key: &'a str, keys: &[String]) -> &'a str {
    let mut ends = key.rmatch_indices('.').map(|(place, _)| &key[place + 1..]);
    let alone = |end: &&str| {
        let same = |other: &&String| other.as_str() == *end || other.ends_with(&format!(".{end}"));
        keys.iter().filter(same).count() == 1
    };
    ends.find(alone).unwrap_or(key)
}

/// The median and the interval of each number over the rows that are done, a line each; over samples at each combination of
/// what is gone over.
pub fn medians(design: &Design, known: &[RowState]) -> Vec<String> {
    let sampled = design.layout.is_some();
    let over = if sampled { design.over } else { 0 };
    let all: Vec<usize> = (0..design.rows.len()).collect();
    let alike = |one: &usize, other: &usize| {
        design.rows[*one].cells[..over] == design.rows[*other].cells[..over]
    };
    all.chunk_by(alike).flat_map(|rows| medians_of(design, known, (rows, over))).collect()
}

fn medians_of(design: &Design, known: &[RowState], (rows, over): (&[usize], usize)) -> Vec<String> {
    let done: Vec<usize> =
        rows.iter().copied().filter(|&row| known[row].status() == Status::Done).collect();
    let Some(&first) = done.first().filter(|_| done.len() > 1) else { return vec![] };
    let line = |quantity: &Quantity| {
        let values = done.iter().filter_map(|&row| known[row].number(&quantity.column));
        let mut values: Vec<f64> = values.collect();
        values.sort_by(f64::total_cmp);
        let at = |share: f64| quantile(&values, share);
        let (what, [low, high]) = match design.layout {
            Some(_) => (format!("90 % of {} rows", values.len()), SAMPLED.map(at)),
            None => (format!("{} rows", values.len()), ALL.map(at)),
        };
        let (name, median) = (&quantity.name, quantity.with_unit(at(0.5)));
        let (low, high) = (quantity.show(low), quantity.with_unit(high));
        let early = match design.layout {
            Some(_) if life::is(quantity) => life::early(quantity, &values),
            _ => String::new(),
        };
        format!("{name:<18}median {median}, {what} from {low} to {high}{early}")
    };
    let at = Some(varied(design, &design.rows[first], over)).filter(|at| !at.is_empty());
    let case = &design.rows[first].resolved.case;
    at.map(|at| format!("at {at}"))
        .into_iter()
        .chain(quantities(case, &known[first]).iter().map(line))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::short;

    #[test]
    fn keys_are_as_short_as_they_can_be() {
        let keys = [
            "motion.sliding.load",
            "friction.coulomb.coefficient",
            "body.pin.wear.archard.coefficient",
            "accuracy",
        ];
        let keys = keys.map(str::to_owned);
        assert_eq!(
            short(&keys),
            ["load", "coulomb.coefficient", "archard.coefficient", "accuracy"]
        );
        let one = ["body.pin.young".to_owned(), "body.disc.young".to_owned()];
        assert_eq!(short(&one), ["pin.young", "disc.young"]);
    }
}
