//! What changes over the progress of a motion: pressures, approach, area, forces and temperature.

use anyhow::Result;
use archard::simulation::history::{
    APPROACH, CENTRE_PRESSURE, CONTACT_AREA, FLASH_TEMPERATURE, FORCE, MEAN_FLASH_TEMPERATURE,
    PEAK_PRESSURE, STICK_AREA,
};

use super::LINE;
use super::figure::{COLOURS, Curves, LegendPosition, OTHERS, Panel, Pen};
use super::results::Results;
use super::scale::{Unit, phrase};
use super::tables::size;
use archard::numerics::WRITTEN;

/// How dark the band of the stated error is.
pub(crate) const ERROR: f64 = 0.25;

/// A panel: its name, its columns with their legends, and its unit.
type Course = (&'static str, &'static [(&'static str, &'static str)], fn(f64) -> Unit);

const COURSES: [Course; 5] = [
    ("Pressure", &[(PEAK_PRESSURE, "highest element"), (CENTRE_PRESSURE, "centre")], |_| {
        Unit::pressure()
    }),
    ("Approach", &[(APPROACH, "approach")], Unit::depth),
    ("Area", &[(CONTACT_AREA, "contact"), (STICK_AREA, "stick")], Unit::section),
    ("Force", &[(FORCE[0], "along x"), (FORCE[1], "along y")], Unit::force),
    (
        "Flash temperature",
        &[(FLASH_TEMPERATURE, "largest"), (MEAN_FLASH_TEMPERATURE, "mean")],
        |_| Unit::kelvin(),
    ),
];

/// A panel for each quantity that changes.
pub(crate) fn panels(results: &Results) -> Result<Vec<Panel>> {
    // Forces over a sweep and of cycles have pictures of their own.
    let apart = results.sweeps() || results.rubs();
    let shown = COURSES.iter().filter(|course| !(apart && course.0 == "Force"));
    shown.filter_map(|course| panel(results, course).transpose()).collect()
}

fn panel(results: &Results, (name, columns, unit): &Course) -> Result<Option<Panel>> {
    let (column, progress) = results.progress();
    let known: Vec<(&str, &str, &[f64])> = columns
        .iter()
        .filter_map(|(column, legend)| {
            Some((*column, *legend, results.history.column(column).ok()?))
        })
        // What sticks changes within each cycle.
        .filter(|known| !(results.rubs() && known.0 == STICK_AREA))
        .collect();
    let most = known.iter().map(|known| size(known.2)).fold(0.0, f64::max);
    let known: Vec<_> = known.into_iter().filter(|known| size(known.2) > WRITTEN * most).collect();
    let changes = |values: &&[f64]| {
        let first = values.first().copied().unwrap_or_default();
        values.iter().any(|value| (value - first).abs() > LINE * size(values))
    };
    if !known.iter().any(|(_, _, values)| changes(values)) {
        return Ok(None);
    }
    let (along, unit) = (results.progress_unit(), unit(most));
    let mut curves = Curves::new();
    for (index, (column, legend, values)) in known.iter().enumerate() {
        let colour = if index == 0 { COLOURS[0] } else { OTHERS[0] };
        band(results, &mut curves, (column, values), (&unit, colour));
        let points = progress.iter().zip(*values);
        let points = points.map(|(s, value)| (s * along.factor, value * unit.factor));
        curves.add(points, Pen::line(colour), (known.len() > 1).then_some(legend));
    }
    let labels = [*name, &along.label(&phrase(column)), &unit.label(name)];
    Ok(Some(curves.panel(labels, |view| view.legend(LegendPosition::OutsideRightTop))))
}

/// Adds the error that is stated for a column, as a band around its values.
pub(crate) fn band(
    results: &Results,
    curves: &mut Curves,
    (column, values): (&str, &[f64]),
    (unit, colour): (&Unit, &str),
) {
    let Some(errors) = results.error(column) else { return };
    let along = results.progress_unit().factor;
    let places = results.progress().1.iter().zip(values.iter().zip(&errors));
    let places = places.filter(|(_, (_, error))| error.is_finite()).map(|(s, (value, error))| {
        [s * along, (value - error) * unit.factor, (value + error) * unit.factor]
    });
    curves.band(places, colour, ERROR, Some("stated error"));
}
