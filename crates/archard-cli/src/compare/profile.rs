//! A measured profile beside the worn one of a run.

use anyhow::{Context, Result, ensure};
use archard::simulation::history::{WORN_SECTION, WORN_VOLUME, of_body};
use archard_case::measured::plane::{FEWEST, Plane};
use archard_case::measured::surface::Surface;
use archard_case::verdict::Verdict;

use super::level::{Level, Reading, least};
use super::{Comparison, percent};
use crate::plot::LINE;
use crate::plot::figure::{COLOURS, Curves, PALE, Pen};
use crate::plot::results::Results;
use crate::plot::scale::{Unit, phrase};
use crate::plot::tables::{Axis, Profile, largest, size};
use crate::report::quantity;

/// Share of the width of the scar left beside it before readings count as outside.
const BESIDE: f64 = 0.25;

/// The section of a body at the last output: heights out of the material, and what is worn off (m).
struct Section<'a> {
    places: &'a [f64],
    worn: &'a [f64],
    /// From where to where it is worn.
    scar: [f64; 2],
}

/// Compares the profile of a body along an axis with readings of its height.
pub(super) fn compare(
    results: &Results,
    (source, readings): (&str, Vec<Reading>),
    (body, axis): (usize, Axis),
    levelled: bool,
) -> Result<Comparison> {
    let name = &results.bodies[body];
    let profile = results.profiles.iter().rfind(|profile| profile.axis == axis);
    let profile =
        profile.with_context(|| format!("the run has no profile along {}", axis.name()))?;
    let section = Section::of(profile, name)?;
    let shallowest = section.worn.iter().copied().fold(f64::INFINITY, f64::min);
    ensure!(
        shallowest < (1.0 - LINE) * largest(section.worn),
        "`{name}` passes along {}, and its track is as deep all along: a profile across the track goes along {}; if this is one, say --column {1}=\"TITLE\" with the title of its places",
        axis.name(),
        axis.other().name(),
    );
    let nominal = nominal(results, body, axis)?;
    let level = match levelled {
        true => Level { plane: Plane::LEVEL, shift: 0.0 },
        false => align(&readings, &nominal, &section)?,
    };
    let flat = level.applied(&readings);
    let depths: Vec<Reading> = flat.iter().map(|(x, z)| (*x, nominal(*x) - z)).collect();
    let zone = section.zone(BESIDE);
    let inside: Vec<Reading> =
        depths.iter().copied().filter(|(x, _)| (zone[0]..=zone[1]).contains(x)).collect();
    ensure!(
        inside.len() >= 2,
        "`{}` has {} readings where the run has its scar, from {} to {}: move them with --levelled left out, or measure there",
        source,
        inside.len(),
        quantity(zone[0], "m"),
        quantity(zone[1], "m"),
    );
    let off: Vec<f64> = inside.iter().map(|(x, depth)| section.depth(*x) - depth).collect();
    let rms = (off.iter().map(|off| off * off).sum::<f64>() / off.len() as f64).sqrt();
    let deepest = inside.iter().map(|reading| reading.1).fold(f64::NEG_INFINITY, f64::max);
    let (computed, area) = (largest(section.worn), area(&inside));
    let along: Vec<Reading> =
        section.places.iter().copied().zip(section.worn.iter().copied()).collect();
    let along: Vec<Reading> = along
        .into_iter()
        .filter(|(x, _)| (inside[0].0..=inside[inside.len() - 1].0).contains(x))
        .collect();
    let worn = self::area(&along);
    let line = |name: &str, value: String| [name.to_owned(), value];
    let mut lines =
        vec![line("readings", format!("{}, {} of them at the scar", readings.len(), inside.len()))];
    if !levelled {
        lines.push(line(
            "levelled by",
            format!(
                "{} readings outside the scar, scatter {}",
                level.plane.used,
                quantity(level.plane.scatter, "m")
            ),
        ));
        lines.push(line("tilt taken off", format!("{:.4} µm/mm", 1e3 * level.plane.tilt[0])));
        lines.push(line("offset taken off", quantity(level.plane.offset, "m")));
        lines.push(line("shift", format!("{} along {}", quantity(level.shift, "m"), axis.name())));
    }
    lines.push(line(
        "difference, RMS",
        format!(
            "{}, {:.1} % of the deepest",
            quantity(rms, "m"),
            100.0 * rms / deepest.max(computed)
        ),
    ));
    lines.push(line(
        "deepest",
        format!(
            "measured {}, computed {}: {}",
            quantity(deepest, "m"),
            quantity(computed, "m"),
            percent(deepest, computed)
        ),
    ));
    lines.push(line(
        "worn section",
        format!(
            "measured {}, computed {}: {}",
            quantity(area, "m2"),
            quantity(worn, "m2"),
            percent(area, worn)
        ),
    ));
    let last = |column: &str| {
        results
            .history
            .column(&of_body(column, name))
            .ok()
            .and_then(|values| values.last().copied())
    };
    if let Some((volume, all)) =
        last(WORN_VOLUME).zip(last(WORN_SECTION)).filter(|known| known.1 > 0.0)
    {
        let measured = area * volume / all;
        lines.push(line(
            "worn volume along the track",
            format!(
                "measured {}, computed {}: {}",
                quantity(measured, "m3"),
                quantity(volume, "m3"),
                percent(measured, volume)
            ),
        ));
    }
    let mut remarks = vec![];
    let beyond = readings.len() - inside.len();
    if beyond > 0 && levelled {
        remarks.push(format!("readings outside the scar, not compared: {beyond}"));
    }
    if !levelled {
        let debris = beyond.saturating_sub(level.plane.used);
        remarks.push(format!(
            "readings outside the scar, used for the level only: {}",
            level.plane.used
        ));
        remarks.push(format!("debris next to the scar, left out: {debris}"));
    }
    if !levelled && curved(&nominal, &section) {
        remarks.push("on a curved body a shift and a tilt are nearly the same: their sum counts, not each of them".to_owned());
    }
    let panels =
        vec![panel(results, (name, body, axis), &depths, (&along_all(&section), zone, profile))];
    let title = format!("{name} along {} compared with `{source}`", axis.name());
    let mut comparison = Comparison { title, lines, remarks, verdict: Verdict::default(), panels };
    if !levelled {
        comparison.state([(level.plane.scatter / deepest.max(computed), "depth".to_owned())]);
    }
    Ok(comparison)
}

/// Places along an axis and heights of a profile.
pub(super) fn readings(surface: &Surface, axis: Axis) -> Vec<Reading> {
    surface.readings().iter().map(|own| (own[axis.index()], own[2])).collect()
}

/// The height (m) that a body had along an axis, out of its material.
fn nominal(results: &Results, body: usize, axis: Axis) -> Result<impl Fn(f64) -> f64> {
    let shape = shape(results, body)?;
    Ok(move |place: f64| match axis {
        Axis::X => shape([place, 0.0]),
        Axis::Y => shape([0.0, place]),
    })
}

/// The height (m) that a body had, out of its material.
pub(super) fn shape(results: &Results, body: usize) -> Result<impl Fn([f64; 2]) -> f64> {
    let case = results.case.as_ref().context("the case of the run cannot be read any more")?;
    let case = case.bodies.get(body).context("the case has no such body")?;
    ensure!(
        case.finite.is_none(),
        "`{}` is meshed: profiles and height maps are compared with bodies whose shape is a profile",
        case.name
    );
    let profile = case.profile.build()?;
    Ok(move |[x, y]: [f64; 2]| -profile.recess(x, y))
}

impl<'a> Section<'a> {
    fn of(profile: &'a Profile, body: &str) -> Result<Self> {
        let places = profile.table.column("coordinate_m")?;
        let worn = profile.table.column(&format!("wear_{body}_m"))?;
        let least = LINE * size(worn);
        let scar =
            places.iter().zip(worn).filter(|(_, worn)| **worn > least).map(|(place, _)| *place);
        let [low, high] = scar.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], place| {
            [low.min(place), high.max(place)]
        });
        ensure!(
            low < high,
            "`{body}` has no scar along {}: nothing is worn there",
            profile.axis.name()
        );
        Ok(Self { places, worn, scar: [low, high] })
    }

    /// The scar and a share of its width on either side.
    fn zone(&self, share: f64) -> [f64; 2] {
        let [low, high] = self.scar;
        [low - share * (high - low), high + share * (high - low)]
    }

    /// What is worn off at a place (m), between the elements; nothing beyond them.
    fn depth(&self, place: f64) -> f64 {
        let next = self.places.partition_point(|known| *known < place);
        let Some((from, to)) = next.checked_sub(1).zip((next < self.places.len()).then_some(next))
        else {
            return 0.0;
        };
        let share = (place - self.places[from]) / (self.places[to] - self.places[from]);
        self.worn[from] + share * (self.worn[to] - self.worn[from])
    }
}

/// The level and the shift at which readings are nearest to the run.
fn align(
    readings: &[Reading],
    nominal: &impl Fn(f64) -> f64,
    section: &Section<'_>,
) -> Result<Level> {
    let zone = section.zone(BESIDE);
    let fitted = |shift: f64| Level::fitted(readings, shift, nominal, zone);
    let cost = |shift: f64| {
        let flat = fitted(shift)?.applied(readings);
        let inside: Vec<f64> = flat
            .iter()
            .filter(|(x, _)| (zone[0]..=zone[1]).contains(x))
            .map(|(x, z)| (section.depth(*x) - nominal(*x) + z).powi(2))
            .collect();
        (inside.len() >= 2).then(|| inside.iter().sum::<f64>() / inside.len() as f64)
    };
    let ends = [readings[0].0, readings[readings.len() - 1].0];
    let range = [ends[0] - section.scar[0], ends[1] - section.scar[1]];
    let range = if range[0] < range[1] { range } else { [range[1], range[0]] };
    let shift = least(range, cost);
    shift.and_then(fitted).with_context(|| {
        format!(
            "fewer than {FEWEST} readings lie outside the scar, which the run has {} wide: measure wider, or say --levelled",
            quantity(section.scar[1] - section.scar[0], "m")
        )
    })
}

/// Whether the shape bends within the scar by more than a hundredth of the depth.
fn curved(nominal: &impl Fn(f64) -> f64, section: &Section<'_>) -> bool {
    let [low, high] = section.scar;
    let sag = nominal(0.5 * (low + high)) - 0.5 * (nominal(low) + nominal(high));
    sag.abs() > 0.01 * largest(section.worn)
}

fn along_all(section: &Section<'_>) -> Vec<Reading> {
    section.places.iter().copied().zip(section.worn.iter().copied()).collect()
}

/// The area under points (m^2), by the trapezoidal rule.
fn area(points: &[Reading]) -> f64 {
    points.windows(2).map(|ends| 0.5 * (ends[1].0 - ends[0].0) * (ends[0].1 + ends[1].1)).sum()
}

/// What was worn off by readings and by the run.
fn panel(
    results: &Results,
    (name, body, axis): (&str, usize, Axis),
    depths: &[Reading],
    (computed, zone, profile): (&[Reading], [f64; 2], &Profile),
) -> crate::plot::figure::Panel {
    let shown = |reading: &&Reading| {
        let margin = zone[1] - zone[0];
        (zone[0] - margin..=zone[1] + margin).contains(&reading.0)
    };
    let deepest = computed.iter().chain(depths).map(|point| point.1).fold(0.0, f64::max);
    let (across, unit) = (Unit::across(zone[0].abs().max(zone[1].abs())), Unit::depth(deepest));
    let scaled = |(x, depth): &Reading| (x * across.factor, depth * unit.factor);
    let mut curves = Curves::new();
    curves.mark(depths.iter().filter(shown).map(scaled), PALE[1 + body % 2], Some("measured"));
    curves.add(
        computed.iter().filter(shown).map(scaled),
        Pen::line(COLOURS[1 + body % 2]),
        Some("computed"),
    );
    let (column, _) = results.progress();
    let at = results.progress_unit().show(profile.progress);
    let title = format!("Worn off {name}, {} {at}", phrase(column).to_lowercase());
    let labels = [&*title, &across.label(axis.name()), &unit.label("Depth")];
    curves.panel(labels, |view| view)
}
