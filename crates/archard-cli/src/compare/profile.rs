//! A measured profile next to the worn one of a run.

use anyhow::{Context, Result, ensure};
use archard::simulation::history::{WORN_SECTION, WORN_VOLUME, of_body};
use archard_case::measured::surface::Surface;
use archard_case::verdict::Verdict;
use archard_surface::scar::{Estimate, Scar, Shape, depth_and_width};

use super::{Comparison, percent};
use crate::plot::LINE;
use crate::plot::figure::{COLOURS, Curves, PALE, Pen};
use crate::plot::results::Results;
use crate::plot::scale::{Unit, phrase};
use crate::plot::tables::{Axis, Profile, largest, size};
use crate::report::quantity;

/// Share of the width of the scar on either side of it within which readings are compared.
const BESIDE: f64 = 0.25;

/// Readings: place and height (m).
pub(super) type Reading = (f64, f64);

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
    let scar = match levelled {
        true => None,
        false => {
            let steps = results.profiles.iter().filter(|own| own.axis == axis);
            let steps: Vec<Vec<[f64; 2]>> =
                steps.map(|own| points(own, name)).collect::<Result<_>>()?;
            let shape = Shape::of(&steps).with_context(|| {
                format!("the run has no section of `{name}` that a profile can be held against")
            })?;
            let heights: Vec<[f64; 2]> = readings.iter().map(|(x, z)| [*x, *z]).collect();
            let found = Scar::find(&heights, &nominal, &shape);
            let found = found.with_context(|| {
                format!(
                    "`{source}` cannot be laid on the run (--levelled: it lies as the run has it)"
                )
            })?;
            Some((found, shape))
        }
    };
    let depth = |(x, z): &Reading| match &scar {
        Some((scar, _)) => scar.depth_at([*x, *z], &nominal).into(),
        None => (*x, nominal(*x) - z),
    };
    let depths: Vec<Reading> = readings.iter().map(depth).collect();
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
    let line = |name: &str, value: String| [name.to_owned(), value];
    let count = match levelled {
        true => format!("{}, {} of them at the scar", readings.len(), inside.len()),
        false => readings.len().to_string(),
    };
    let mut lines = vec![line("readings", count)];
    let computed = largest(section.worn);
    let measured = match &scar {
        Some((scar, shape)) => {
            lines.extend(laid(scar, axis));
            lines.push(difference(rms, deepest.max(computed)));
            lines.extend(by_shape((scar, shape)));
            scar.section.value
        }
        None => {
            let ends = [inside[0].0, inside[inside.len() - 1].0];
            let along = along_all(&section).into_iter();
            let along: Vec<Reading> =
                along.filter(|(x, _)| (ends[0]..=ends[1]).contains(x)).collect();
            let (measured, worn) = (area(&inside), area(&along));
            lines.push(difference(rms, deepest.max(computed)));
            lines.push(compared("deepest", (quantity(deepest, "m"), deepest), (computed, "m")));
            lines.push(compared(
                "worn section",
                (quantity(measured, "m2"), measured),
                (worn, "m2"),
            ));
            measured
        }
    };
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
        let measured = measured * volume / all;
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
    match &scar {
        None if beyond > 0 => {
            remarks.push(format!("readings outside the scar, not compared: {beyond}"));
        }
        None => {}
        Some((scar, _)) => {
            remarks.push(format!("spikes, left out: {}", scar.spikes));
            if scar.debris > 0.0 {
                let share = 100.0 * scar.debris;
                remarks.push(format!(
                    "debris next to the scar, left out: {share:.0} % of the profile"
                ));
            }
            if scar.unseen > 0.0 {
                let share = 100.0 * scar.unseen / scar.section.value;
                remarks.push(format!(
                    "part of the section beyond the profile, as computed: {share:.1} %"
                ));
            }
        }
    }
    if !levelled && curved(&nominal, &section) {
        remarks.push("on a curved body a shift and a tilt are nearly the same: their sum counts, not each of them".to_owned());
    }
    let panels =
        vec![panel(results, (name, body, axis), &depths, (&along_all(&section), zone, profile))];
    let title = format!("{name} along {} compared with `{source}`", axis.name());
    let mut comparison = Comparison { title, lines, remarks, verdict: Verdict::default(), panels };
    if let Some((scar, _)) = &scar {
        let error = |own: &Estimate, what: &str| (own.normal() / own.value, what.to_owned());
        let depth = scar.depth.iter().map(|own| error(own, "measured depth"));
        comparison.state(depth.chain([error(&scar.section, "measured section")]));
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

/// What a profile of a run has worn off a body (m) at its places (m).
fn points(profile: &Profile, body: &str) -> Result<Vec<[f64; 2]>> {
    let places = profile.table.column("coordinate_m")?;
    let worn = profile.table.column(&format!("wear_{body}_m"))?;
    Ok(places.iter().zip(worn).map(|(place, worn)| [*place, *worn]).collect())
}

/// How a profile lies on the run.
fn laid(scar: &Scar, axis: Axis) -> Vec<[String; 2]> {
    let place = &scar.place;
    vec![
        ["tilt taken off".to_owned(), format!("{:.4} µm/mm", 1e3 * scar.tilt)],
        ["offset taken off".to_owned(), quantity(scar.height, "m")],
        ["shift".to_owned(), format!("{} along {}", with(place, "m"), axis.name())],
        [
            "scatter beside the scar".to_owned(),
            format!(
                "{}, correlated over {}",
                quantity(scar.texture.hypot(scar.noise), "m"),
                quantity(scar.length, "m")
            ),
        ],
    ]
}

/// Depth, width and section that were measured, next to the computed ones.
fn by_shape((scar, shape): (&Scar, &Shape)) -> Vec<[String; 2]> {
    let mut lines = vec![];
    let mut own = |name: &str, measured: &Estimate, computed: (f64, &str)| {
        lines.push(compared(name, (with(measured, computed.1), measured.value), computed));
    };
    if let (Some(depth), Some([computed, width])) = (&scar.depth, depth_and_width(shape)) {
        own("deepest", depth, (computed, "m"));
        if let Some(measured) = &scar.width {
            own("width at a twentieth of that", measured, (width, "m"));
        }
    }
    own("worn section", &scar.section, (shape.section(1.0), "m2"));
    lines
}

/// A value with its standard uncertainty.
fn with(own: &Estimate, unit: &str) -> String {
    format!("{} \u{b1} {}", quantity(own.value, unit), quantity(own.normal(), unit))
}

/// A measured value, as it is shown, next to the computed one.
fn compared(
    name: &str,
    (shown, measured): (String, f64),
    (computed, unit): (f64, &str),
) -> [String; 2] {
    let computed_shown = quantity(computed, unit);
    let ratio = percent(measured, computed);
    [name.to_owned(), format!("measured {shown}, computed {computed_shown}: {ratio}")]
}

fn difference(rms: f64, deepest: f64) -> [String; 2] {
    let share = 100.0 * rms / deepest;
    ["difference, RMS".to_owned(), format!("{}, {share:.1} % of the deepest", quantity(rms, "m"))]
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
