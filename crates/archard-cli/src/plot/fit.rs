//! The picture of a fit: readings, the case at the median, and bands of the median and of the next test.

use std::path::{Path, PathBuf};

use anyhow::Result;
use archard_lab::{Coefficient, DrawnCurve, Fit};

use super::HIGH;
use super::SHOWN;
use super::draw::{Paper, Sheet, places, save};
use super::figure::{COLOURS, Curves, LegendPosition, Panel, Pen};
use super::scale::Unit;

/// Size of a panel (px).
const SIZE: [f64; 2] = [640.0, 480.0];

/// Draws a fit as `fit.svg` and `fit.png` in a folder.
pub fn draw(dir: &Path, fit: &Fit) -> Result<Vec<PathBuf>> {
    let shown =
        fit.coefficients.iter().flat_map(|own| own.curves.iter().map(move |curve| (own, curve)));
    let panels: Vec<Panel> = shown.take(SHOWN).map(|(own, curve)| panel(fit, own, curve)).collect();
    let columns = panels.len().clamp(1, 2);
    let sheet = Sheet { columns, size: SIZE, paper: &Paper::default() };
    save(&dir.join("fit"), &sheet, (panels, None))
}

/// Says whether the pictures of a fit may be written into a folder.
///
/// # Errors
/// If other files stand in their places.
pub fn admit(dir: &Path) -> Result<()> {
    places(&dir.join("fit"), &Paper::default()).map(|_| ())
}

fn panel(fit: &Fit, own: &Coefficient, shown: &DrawnCurve) -> Panel {
    let (name, factor, unit) = &fit.quantities[shown.quantity];
    let own_readings = || {
        let tests = own.tests.iter().filter(|test| test.load == shown.load);
        tests.flat_map(|test| &test.readings).filter(|reading| reading.quantity == shown.quantity)
    };
    let highest = |place: usize| shown.points.iter().map(|p| p.1[place]).fold(0.0, f64::max);
    let readings = own_readings().map(|reading| reading.value).fold(highest(3), f64::max);
    // Two tests may leave nothing to be seen of the readings.
    let within = highest(4) <= HIGH * readings;
    let most = if within { highest(4).max(readings) } else { readings };
    let unit = Unit::of_readings((unit, *factor), most);
    let factor = unit.factor;
    let end = shown.points.last().map_or(1.0, |point| point.0);
    let column = match fit.progress {
        "distance" => "distance_m",
        "time" => "time_s",
        other => other,
    };
    let along = Unit::of_column(column, end);
    let x: Vec<f64> = shown.points.iter().map(|point| point.0 * along.factor).collect();
    let at = |place: usize| -> Vec<f64> {
        shown.points.iter().map(|point| point.1[place] * factor).collect()
    };
    let mut curves = Curves::new();
    let mut band = |low: usize, high: usize, opacity: f64| {
        let between = at(low).into_iter().zip(at(high));
        let places = x.iter().zip(between).map(|(x, (low, high))| [*x, low, high]);
        curves.band(places, COLOURS[1], opacity, None);
    };
    if own.estimate.next.is_some() {
        band(0, 4, 0.16);
    }
    if own.estimate.interval.is_some() {
        band(1, 3, 0.3);
    }
    let bands = match (own.estimate.interval, own.estimate.next) {
        (Some(_), Some(_)) if within => "median, its 95 % interval, and that of the next test",
        (Some(_), Some(_)) => {
            "median, its 95 % interval, and that of the next test, which goes beyond the picture"
        }
        (Some(_), None) => "median and its 95 % interval",
        _ => "median",
    };
    curves.add(x.iter().copied().zip(at(2)), Pen::line(COLOURS[1]), Some(bands));
    let readings: Vec<(f64, f64)> = own_readings()
        .map(|reading| (reading.progress * along.factor, reading.value * factor))
        .collect();
    let legend = format!("{} readings", readings.len());
    curves.mark(readings, COLOURS[0], Some(&legend));
    let title = match shown.load {
        Some(load) => format!("{} at {load} N", own.key),
        None => own.key.clone(),
    };
    let labels = [&*title, &along.label(fit.progress), &unit.label(name)];
    curves.panel(labels, |view| {
        view.along_x([0.0, end * along.factor])
            .above_y(0.0)
            .below_y(1.25 * most * factor)
            .legend(LegendPosition::InsideTopLeft)
    })
}
