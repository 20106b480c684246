//! How long the part of a row lasts, and the lives that shares of all rows do not reach.

use archard_case::Case;
use serde_json::Value;

use super::words::Quantity;
use crate::plot::quantile;

/// What the column of a life begins with; the column of the progress follows.
const LIFE: &str = "life_";

/// Lives that are told where rows are samples: those that a tenth and a hundredth of parts do not reach.
const EARLY: [(&str, f64); 2] = [("B10", 0.1), ("B1", 0.01)];

/// The column of the life, from the summary of a row: infinite where no limit was reached. `None` without limits.
pub fn of(summary: &Value) -> Option<(String, String)> {
    let life = summary["life"].as_object()?;
    let column = format!("{LIFE}{}", life["progress"].as_str()?);
    let progress = life["progress"].as_str()?;
    let value = life["reached"][progress].as_f64().unwrap_or(f64::INFINITY);
    Some((column, format!("{value:?}")))
}

/// The number that a row with limits is told by.
pub fn quantity(case: &Case) -> Option<Quantity> {
    let (motion, _) = case.motion.build().ok().filter(|_| !case.until.is_empty())?;
    let column = format!("{LIFE}{}", motion.progress.column);
    Some(Quantity::new("life", column, (motion.progress.quantity.unit(), 1.0)))
}

/// "B10 0.214 m, B1 0.151 m": of sorted lives, as far as there are rows enough for a share.
pub fn early(quantity: &Quantity, lives: &[f64]) -> String {
    let told = EARLY.iter().filter(|(_, share)| share * lives.len() as f64 >= 1.0);
    let told = told
        .map(|(name, share)| format!(", {name} {}", quantity.with_unit(quantile(lives, *share))));
    told.collect()
}

/// Whether a number is a life.
pub fn is(quantity: &Quantity) -> bool {
    quantity.column.starts_with(LIFE)
}
