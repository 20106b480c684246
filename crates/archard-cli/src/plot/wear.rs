//! Depth and volume of wear, in rolling its depth and section, over the progress of the motion, with
//! the closed form next to them; in fretting, where it ends.

use anyhow::Result;
use archard::closed_form::pin_on_disc;
use archard::closed_form::twin_discs::TwinDiscs;
use archard::simulation::history::{
    BODY_DEPTH, LOAD, WEAR_DEPTH, WORN_SECTION, WORN_VOLUME, of_body,
};

use super::CELLS;
use super::NEAR;
use super::course::band;
use super::figure::{COLOURS, Curves, LegendPosition, Panel, Pen};
use super::results::{Results, WornSphere};
use super::scale::{Unit, phrase};
use super::tables::largest;

/// Deepest wear, in all and of each body that wears.
pub(crate) fn depth(results: &Results) -> Result<Panel> {
    let total = results.history.column(WEAR_DEPTH)?;
    let unit = Unit::depth(largest(total));
    let end = results.worn_out().map(|[depth, _]| depth);
    let closed = closed_form(
        results,
        |sphere, work| pin_on_disc::depth(sphere.radius, sphere.coefficient * work),
        "incremental model",
        TwinDiscs::incremental_depth,
    );
    let name = "Wear depth";
    panel(results, &Quantity { name, unit, total, column: BODY_DEPTH, closed, end })
}

/// Worn volume, in rolling worn section, in all and of each body that wears.
pub(crate) fn worn_off(results: &Results) -> Result<Panel> {
    let rolls = results.rolls();
    let column = if rolls { WORN_SECTION } else { WORN_VOLUME };
    let mut total = vec![0.0; results.progress().1.len()];
    for body in &results.bodies {
        let worn = results.history.column(&of_body(column, body))?;
        total.iter_mut().zip(worn).for_each(|(sum, worn)| *sum += worn);
    }
    let (name, unit) = match rolls {
        true => ("Worn section", Unit::section(largest(&total))),
        false => ("Worn volume", Unit::volume(largest(&total))),
    };
    let closed = closed_form(
        results,
        |sphere, work| sphere.coefficient * work,
        "if all slips",
        |discs, work| discs.coefficient * discs.creepage * work,
    );
    let end = results.worn_out().map(|[_, volume]| volume);
    panel(results, &Quantity { name, unit, total: &total, column, closed, end })
}

/// Name of a closed form, and its value at an integral of the load over the progress.
type ClosedForm<'a> = (&'static str, Box<dyn Fn(f64) -> f64 + 'a>);

/// The closed form of a run: of a sphere, or of discs under its own name.
fn closed_form<'a>(
    results: &Results,
    sphere: impl Fn(&WornSphere, f64) -> f64 + 'a,
    of_discs: &'static str,
    discs: impl Fn(&TwinDiscs, f64) -> f64 + 'a,
) -> Option<ClosedForm<'a>> {
    if let Some(known) = results.worn_sphere() {
        let value = move |work: f64| sphere(&known, work);
        return Some(("sphere worn flat, no elasticity", Box::new(value)));
    }
    let known = results.worn_discs()?;
    Some((of_discs, Box::new(move |work: f64| discs(&known, work))))
}

/// A measure of wear.
struct Quantity<'a> {
    name: &'a str,
    unit: Unit,
    /// Its value for both bodies together.
    total: &'a [f64],
    /// The column of each body.
    column: &'a str,
    /// What a closed form says of it.
    closed: Option<ClosedForm<'a>>,
    /// The value at which a closed form has it end.
    end: Option<f64>,
}

/// Curves of a quantity, and its closed form.
fn panel(results: &Results, quantity: &Quantity<'_>) -> Result<Panel> {
    let (name, progress) = results.progress();
    let (along, unit) = (results.progress_unit(), &quantity.unit);
    let points = |values: &[f64]| -> Vec<(f64, f64)> {
        let pairs = progress.iter().zip(values);
        pairs.map(|(s, value)| (s * along.factor, value * unit.factor)).collect()
    };
    let mut curves = Curves::new();
    if let Some((name, closed)) = &quantity.closed {
        let load_distance = load_distance(progress, results.history.column(LOAD)?);
        let curve = load_distance
            .into_iter()
            .map(|(s, integral)| (s * along.factor, closed(integral) * unit.factor));
        curves.add(curve, Pen::closed_form(), Some(name));
    }
    let near = |end: &f64| largest(quantity.total) > NEAR * end;
    if let Some(end) = quantity.end.filter(near) {
        let ends = [0.0, largest(progress)].map(|s| (s * along.factor, end * unit.factor));
        curves.add(ends, Pen::closed_form(), Some("closed-form end"));
    }
    let mut worn = Vec::new();
    for (index, body) in results.bodies.iter().enumerate() {
        let column = of_body(quantity.column, body);
        let values = results.history.column(&column)?;
        if largest(values) > 0.0 {
            band(results, &mut curves, (&column, values), (unit, COLOURS[1 + index % 2]));
            worn.push((index, body, points(values)));
        }
    }
    let both = worn.len() > 1;
    if both {
        curves.add(points(quantity.total), Pen::line(COLOURS[0]), Some("both bodies"));
    }
    for (index, body, points) in worn {
        let colour = COLOURS[1 + index % 2];
        let pen = if both && index == 0 { Pen::broad(colour) } else { Pen::line(colour) };
        curves.add(points, pen, Some(body));
    }
    let labels = [quantity.name, &along.label(&phrase(name)), &unit.label(quantity.name)];
    let end = largest(progress) * along.factor;
    Ok(curves.panel(labels, |view| {
        view.below_x(end).above_y(0.0).legend(match results.rubs() {
            // Fretting wears fast at first.
            true => LegendPosition::InsideBottomRight,
            false => LegendPosition::InsideTopLeft,
        })
    }))
}

/// Places, dense at the start, where bodies wear fast, and the integral of the load up to them.
fn load_distance(distance: &[f64], load: &[f64]) -> Vec<(f64, f64)> {
    let mut integral = vec![0.0];
    for step in 1..distance.len() {
        let slid = distance[step] - distance[step - 1];
        integral.push(integral[step - 1] + load[step] * slid);
    }
    let end = distance.last().copied().unwrap_or_default();
    (0..=CELLS)
        .map(|point| {
            let s = end * (point as f64 / CELLS as f64).powi(2);
            let next =
                distance.partition_point(|&known| known < s).clamp(1, distance.len().max(2) - 1);
            match (distance.get(next), integral.get(next)) {
                (Some(&upper), Some(&value)) if upper > distance[next - 1] => {
                    let share = (s - distance[next - 1]) / (upper - distance[next - 1]);
                    (s, integral[next - 1] + share * (value - integral[next - 1]))
                }
                _ => (s, integral[next - 1]),
            }
        })
        .collect()
}
