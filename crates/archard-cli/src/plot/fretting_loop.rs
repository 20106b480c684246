//! The force on body 1 over the displacement of body 2, in the first cycle and in the last.

use anyhow::Result;
use archard::closed_form::cattaneo_mindlin::{Branch, PartialSlip};
use archard::simulation::history::{FORCE, SHIFT};

use super::CELLS;
use super::NEGLIGIBLE;
use super::figure::{Curves, LegendPosition, OTHERS, PALE, Panel, Pen};
use super::results::Results;
use super::scale::Unit;
use super::tables::{Axis, Table, size};
use archard::numerics::WRITTEN;

/// The loops along each axis along which the bodies are shifted; none where they are not.
pub(crate) fn panels(results: &Results) -> Result<Vec<Panel>> {
    let (Some(first), Some(last)) = (results.loops.first(), results.loops.last()) else {
        return Ok(Vec::new());
    };
    let shown = if results.loops.len() > 1 { vec![first, last] } else { vec![first] };
    let sizes = [Axis::X, Axis::Y].map(|axis| reach(&shown, SHIFT, axis));
    let most = sizes[0].max(sizes[1]);
    let worth = |axis: &Axis| most > 0.0 && sizes[axis.index()] >= NEGLIGIBLE * most;
    let axes = [Axis::X, Axis::Y].into_iter().filter(worth);
    axes.map(|axis| panel(results, &shown, axis)).collect()
}

/// The largest shift (m) or force (N) along an axis.
fn reach(loops: &[&Table], columns: [&str; 2], axis: Axis) -> f64 {
    let values = loops.iter().filter_map(|table| table.column(columns[axis.index()]).ok());
    values.map(size).fold(0.0, f64::max)
}

fn panel(results: &Results, loops: &[&Table], axis: Axis) -> Result<Panel> {
    let along = Unit::depth(reach(loops, SHIFT, axis));
    let force = Unit::force(reach(loops, FORCE, axis));
    let shown = |(x, f): (f64, f64)| (x * along.factor, f * force.factor);
    let mut curves = Curves::new();
    if let Some((contact, amplitude, _)) = results.partial_slip().filter(|known| known.2 == axis) {
        let name = if results.wears() { "Mindlin, unworn" } else { "Mindlin" };
        let points = closed_form(&contact, amplitude).into_iter().map(shown);
        // Loops are narrow: the usual band would fill them.
        curves.add(points, Pen::broad(PALE[0]), Some(name));
    }
    for (index, table) in loops.iter().enumerate() {
        let cycle = table.first().1.last().copied().unwrap_or_default();
        let points = points(table, axis)?.into_iter().map(shown);
        curves.add(points, Pen::line(OTHERS[index]), Some(&format!("cycle {cycle:.0}")));
    }
    let body = results.bodies.first().map_or("body 1", |body| body);
    let title = format!("Fretting loop along {}", axis.name());
    let force = force.label(&format!("Force on {body}"));
    let labels = [&*title, &along.label("Displacement"), &force];
    Ok(curves.panel(labels, |view| view.legend(LegendPosition::InsideTopLeft)))
}

/// Shift (m) and force (N) from increment to increment. A loop whose beginning was jumped over begins where
/// it ends.
fn points(table: &Table, axis: Axis) -> Result<Vec<(f64, f64)>> {
    let shifts = table.column(SHIFT[axis.index()])?;
    let forces = table.column(FORCE[axis.index()])?;
    let points: Vec<_> = shifts.iter().copied().zip(forces.iter().copied()).collect();
    let first = table.first().1.first().copied().unwrap_or_default();
    let lead = ((first - first.round()).abs() > WRITTEN).then(|| points.last().copied()).flatten();
    Ok(lead.into_iter().chain(points).collect())
}

/// From rest to one extreme, to the other and back (m, N).
fn closed_form(contact: &PartialSlip, amplitude: f64) -> Vec<(f64, f64)> {
    let oscillation = contact.oscillation(contact.force(amplitude));
    // What all slides at the extremes is not part of the loop in partial slip.
    let slid = (amplitude - contact.sliding_shift).max(0.0);
    let place = |point: usize| amplitude * (2.0 * point as f64 / CELLS as f64 - 1.0);
    let loading = (CELLS / 2..=CELLS).map(|point| (place(point), contact.force(place(point))));
    let way = |branch: Branch, sign: f64| {
        (0..=CELLS).rev().map(move |point| {
            let shift = sign * place(point);
            (shift, oscillation.force(branch, shift - sign * slid))
        })
    };
    loading.chain(way(Branch::Unloading, 1.0)).chain(way(Branch::Reloading, -1.0)).collect()
}

#[cfg(test)]
mod tests {
    use archard::closed_form::cattaneo_mindlin::PartialSlip;

    use super::{CELLS, closed_form};

    /// The area of the loop is what it dissipates: in partial slip Johnson's energy, beyond it the limit
    /// times what all slides in addition. Chords cut off a little of the area.
    #[test]
    fn loops_enclose_what_they_dissipate() {
        let contact = PartialSlip {
            contact_radius: 1e-4,
            peak_pressure: 1e9,
            friction: 0.3,
            sliding_force: 3.0,
            sliding_shift: 1e-7,
        };
        for amplitude in [0.5e-7, 1.5e-7_f64] {
            let curve = closed_form(&contact, amplitude);
            let cycle = &curve[curve.len() - 2 * (CELLS + 1)..];
            let area: f64 = cycle
                .windows(2)
                .map(|ends| 0.5 * (ends[1].0 - ends[0].0) * (ends[1].1 + ends[0].1))
                .sum();
            let slid = 4.0 * 3.0 * (amplitude - 1e-7).max(0.0);
            let expected = contact.dissipation(contact.force(amplitude)) + slid;
            assert!((area.abs() / expected - 1.0).abs() < 2e-3, "{area} {expected}");
        }
    }
}
