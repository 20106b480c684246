//! How lives scatter from part to part: the share of parts that has reached its limit over the progress.

use serde_json::Value;

use super::figure::{COLOURS, Curves, LegendPosition, Panel, Pen};
use super::results::Results;
use super::scale::{Unit, phrase};

/// Shares that have a name.
const NAMED: [(f64, &str); 3] = [(0.01, "B1"), (0.1, "B10"), (0.5, "median")];

/// The panel, of a run that gives more of its life than the median.
pub(super) fn panel(results: &Results) -> Option<Panel> {
    let life = &results.summary["life"];
    let pair = |pair: &Value| Some((pair[1].as_f64()?, pair[0].as_f64()?));
    let shares = life["distribution"]["shares"].as_array()?;
    // A life beyond the motion is no number.
    let points: Vec<(f64, f64)> = shares.iter().filter_map(pair).collect();
    if points.len() < 2 {
        return None;
    }
    let column = life["progress"].as_str()?;
    let unit = Unit::of_column(column, points[points.len() - 1].0);
    let scaled = |(life, share): &(f64, f64)| (life * unit.factor, 100.0 * share);
    let mut curves = Curves::new();
    curves.add(points.iter().map(scaled), Pen::line(COLOURS[1]), None);
    for ((share, name), colour) in NAMED.into_iter().zip(COLOURS) {
        let own = points.iter().find(|point| (point.1 - share).abs() < 1e-9);
        let Some(own) = own else { continue };
        let words = format!("{name} {}", unit.show(own.0));
        curves.mark([scaled(own)], colour, Some(&words));
    }
    let limit = life["reached"]["column"].as_str().unwrap_or_default();
    let title = format!("Lives until the limit of {}", phrase(limit).to_lowercase());
    let along = unit.label(&phrase(column));
    let labels = [&*title, &along, "Parts at their limit (%)"];
    Some(curves.panel(labels, |view| {
        view.above_y(0.0).below_y(100.0).legend(LegendPosition::InsideBottomRight)
    }))
}
