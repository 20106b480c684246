//! Depth and volume of wear over the progress of the motion, with the closed form beside them.

use anyhow::Result;
use archard::closed_form::pin_on_disc;
use kuva::plot::LegendPosition;

use super::figure::{COLOURS, Curves, Panel, Pen};
use super::results::{Results, largest};
use super::scale::{Unit, phrase};

/// Points of the curve of the closed form.
const POINTS: usize = 200;

/// Deepest wear, in all and of each body that wears.
pub(super) fn depth(results: &Results) -> Result<Panel> {
    let total = results.history.column("wear_depth_m")?;
    let unit = Unit::depth(largest(total));
    let column = |body: &str| format!("wear_depth_{body}_m");
    let closed = |radius: f64, volume: f64| pin_on_disc::depth(radius, volume);
    panel(results, &Quantity { name: "Wear depth", unit, total, column: &column, closed: &closed })
}

/// Worn volume, in all and of each body that wears.
pub(super) fn volume(results: &Results) -> Result<Panel> {
    let column = |body: &str| format!("worn_volume_{body}_m3");
    let mut total = vec![0.0; results.progress().1.len()];
    for body in &results.bodies {
        let volumes = results.history.column(&column(body))?;
        total.iter_mut().zip(volumes).for_each(|(sum, volume)| *sum += volume);
    }
    let (unit, closed) = (Unit::volume(largest(&total)), |_: f64, volume: f64| volume);
    let name = "Worn volume";
    panel(results, &Quantity { name, unit, total: &total, column: &column, closed: &closed })
}

/// A measure of wear.
struct Quantity<'a> {
    name: &'a str,
    unit: Unit,
    /// Its value for both bodies together.
    total: &'a [f64],
    /// The column of a body.
    column: &'a dyn Fn(&str) -> String,
    /// Its value for a sphere of that radius (m) that has lost that volume (m^3).
    closed: &'a dyn Fn(f64, f64) -> f64,
}

/// Curves of a quantity, and its closed form for a worn sphere.
fn panel(results: &Results, quantity: &Quantity<'_>) -> Result<Panel> {
    let (name, progress) = results.progress();
    let (along, unit) = (Unit::of_column(name), &quantity.unit);
    let points = |values: &[f64]| -> Vec<(f64, f64)> {
        let pairs = progress.iter().zip(values);
        pairs.map(|(s, value)| (s * along.factor, value * unit.factor)).collect()
    };
    let mut curves = Curves::new();
    if let Some(sphere) = results.worn_sphere() {
        let load_distance = load_distance(progress, results.history.column("load_N")?);
        let curve = load_distance.into_iter().map(|(s, integral)| {
            let value = (quantity.closed)(sphere.radius, sphere.coefficient * integral);
            (s * along.factor, value * unit.factor)
        });
        curves.add(curve, Pen::closed_form(), Some("sphere worn flat, no elasticity"));
    }
    let mut worn = Vec::new();
    for body in &results.bodies {
        let values = results.history.column(&(quantity.column)(body))?;
        if largest(values) > 0.0 {
            worn.push((body, points(values)));
        }
    }
    let both = worn.len() > 1;
    if both {
        curves.add(points(quantity.total), Pen::line(COLOURS[0]), Some("both bodies"));
    }
    for (index, (body, points)) in worn.into_iter().enumerate() {
        let pen = match index {
            0 if both => Pen::broad(COLOURS[1]),
            0 => Pen::line(COLOURS[1]),
            _ => Pen::line(COLOURS[2]),
        };
        curves.add(points, pen, Some(body));
    }
    let labels = [quantity.name, &along.label(&phrase(name)), &unit.label(quantity.name)];
    let end = largest(progress) * along.factor;
    Ok(curves.panel(labels, |layout| {
        layout
            .with_x_axis_max(end)
            .with_y_axis_min(0.0)
            .with_legend_position(LegendPosition::InsideTopLeft)
    }))
}

/// Distances (m), dense where a sphere wears fast, and the integral of the load (N m) up to them.
fn load_distance(distance: &[f64], load: &[f64]) -> Vec<(f64, f64)> {
    let mut integral = vec![0.0];
    for step in 1..distance.len() {
        let slid = distance[step] - distance[step - 1];
        integral.push(integral[step - 1] + load[step] * slid);
    }
    let end = distance.last().copied().unwrap_or_default();
    (0..=POINTS)
        .map(|point| {
            let s = end * (point as f64 / POINTS as f64).powi(2);
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
