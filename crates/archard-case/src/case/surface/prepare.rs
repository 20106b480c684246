//! What a case does to a measured surface before it is used, in this order: `outliers`, `level` or `form`, `smooth`, `rough`, `spacing`,
//! `holes`.

use archard::parameters::{Invalid, Parameter, Quantity, Values};
use archard_surface::{Form, HeightMap, Level, Nominal, Polynomial, Spectrum, Texture, Window};

use crate::verdict::four;

/// The keys.
pub(super) const OUTLIERS: Parameter = Parameter::optional(
    "outliers",
    Quantity::Word(&["keep", "remove"]),
    "points that stand out from their neighbours: kept (if not given), or taken as not measured (outside the range of their neighbours, Chauvenet's threshold)",
);
pub(super) const LEVEL: Parameter = Parameter::optional(
    "level",
    Quantity::Word(&["none", "plane", "quadratic", "cubic", "quartic", "quintic"]),
    "the polynomial that is taken off: none (if not given), or of first to fifth degree",
);
pub(super) const FORM: Parameter = Parameter::optional(
    "form",
    Quantity::Word(&["none", "sphere", "cylinder", "cylinder_x", "cylinder_y"]),
    "the nominal shape that is taken off with its tilt: none (if not given), a sphere, a cylinder in any direction, or along an axis",
);
pub(super) const RADIUS: Parameter = Parameter::optional(
    "radius",
    Quantity::Length,
    "radius of the form; the one that fits best if not given",
);
pub(super) const SMOOTH: Parameter = Parameter::optional(
    "smooth",
    Quantity::Length,
    "cutoff below which waves are taken off (S-filter, Gaussian of ISO 16610-61)",
);
pub(super) const ROUGH: Parameter = Parameter::optional(
    "rough",
    Quantity::Length,
    "cutoff above which waves are taken off (L-filter, Gaussian of ISO 16610-61)",
);
pub(super) const SPACING: Parameter = Parameter::optional(
    "spacing",
    Quantity::Length,
    "distance of coarser points, each with the mean height of the square around it",
);
pub(super) const HOLES: Parameter = Parameter::optional(
    "holes",
    Quantity::Word(&["refuse", "fill"]),
    "what becomes of points without a height: refused (if not given), or filled by the harmonic function between the others",
);

/// A measured surface as a case uses it.
#[derive(Debug, Clone, PartialEq)]
pub struct PreparedSurface {
    /// The heights that are left.
    pub map: HeightMap,
    /// What was done to those of the file, in order.
    pub steps: Vec<Preparation>,
}

/// Something that was done to a measured surface.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Preparation {
    /// The key of the case that asks for it.
    pub key: &'static str,
    /// What it took off, in words and numbers.
    pub said: String,
    /// How many points it gave a height that nobody measured.
    pub filled: usize,
}

/// A surface under way.
pub(super) struct Preparing {
    pub(super) map: HeightMap,
    /// What was done, where somebody asks.
    pub(super) steps: Option<Vec<Preparation>>,
}

impl Preparing {
    /// Does all that the values ask for.
    pub(super) fn prepare(&mut self, values: &Values) -> Result<(), Invalid> {
        agree(values)?;
        if values.word("outliers") == Some("remove") {
            self.outliers()?;
        }
        if let Some((name, level)) = named(values.word("level"), &Level::ALL) {
            self.level(name, level)?;
        }
        if let Some((name, form)) = named(values.word("form"), &Form::ALL) {
            self.form(name, form, values.number("radius"))?;
        }
        if let Some(cutoff) = values.number("smooth") {
            let map = self.map.smoothed(cutoff).map_err(|error| refused("smooth", &error))?;
            self.filtered("smooth", map, format!("waves shorter than {} um", four(1e6 * cutoff)));
        }
        if let Some(cutoff) = values.number("rough") {
            let map = self.map.roughness(cutoff).map_err(|error| refused("rough", &error))?;
            self.filtered("rough", map, format!("waves longer than {} um", four(1e6 * cutoff)));
        }
        if let Some(spacing) = values.number("spacing") {
            self.space(spacing)?;
        }
        if values.word("holes") == Some("fill") {
            let map = self.map.filled().map_err(|error| refused("holes", &error))?;
            self.done("holes", map, |before, _| format!("{} points filled", before.missing()));
        }
        Ok(())
    }

    fn outliers(&mut self) -> Result<(), Invalid> {
        let found = self.map.without_outliers().map_err(|error| refused("outliers", &error))?;
        let (map, outliers) = found;
        self.done("outliers", map, |_, _| {
            let (count, threshold) = (outliers.count, four(1e6 * outliers.threshold));
            format!(
                "{count} points off, which lie {threshold} um or more outside of the range of their neighbours"
            )
        });
        Ok(())
    }

    fn level(&mut self, name: &str, level: Level) -> Result<(), Invalid> {
        let polynomial = Polynomial::of(&self.map, level);
        let map = self.map.without_polynomial(&polynomial);
        let map = map.map_err(|error| refused("level", &error))?;
        self.done("level", map, |before, after| {
            let [x, y] = polynomial.tilt().map(|slope| four(1e3 * slope));
            let range = four(1e6 * range_between(before, after));
            format!("{name} off, {range} um from lowest to highest, tilt {x} mrad along x, {y} mrad along y")
        });
        Ok(())
    }

    fn form(&mut self, name: &str, form: Form, given: Option<f64>) -> Result<(), Invalid> {
        let key = if given.is_some() { "radius" } else { "form" };
        let nominal = Nominal::of(&self.map, form, given).map_err(|error| refused(key, &error))?;
        let map = self.map.without(&nominal);
        self.done("form", map, |_, _| {
            let name = name.split('_').next().unwrap_or(name);
            let side = if nominal.curvature < 0.0 { "concave " } else { "convex " };
            let [radius, deviation] = nominal.radius().map(|length| four(1e3 * length));
            let size = match (given, nominal.curvature.abs() > 2.0 * nominal.deviation) {
                (Some(_), _) => format!("{side}{name} of the given radius, {radius} mm, off"),
                (None, true) => format!("{side}{name} off, radius {radius} mm, standard deviation {deviation} mm"),
                (None, false) => format!(
                    "{name} off, no radius: its curvature, {} 1/m, is within two standard deviations, {} 1/m, of a plane",
                    four(nominal.curvature),
                    four(nominal.deviation)
                ),
            };
            let axis = nominal.direction().map(|angle| format!(", axis {} degrees from x", four(angle.to_degrees())));
            format!("{size}{}, rest {} um rms", axis.unwrap_or_default(), four(1e6 * nominal.rest))
        });
        Ok(())
    }

    fn filtered(&mut self, key: &'static str, map: HeightMap, which: String) {
        self.done(key, map, |before, after| {
            let taken =
                before.heights().iter().zip(after.heights()).map(|(before, after)| before - after);
            let taken = HeightMap::new(after.elements(), after.pixel(), taken.collect());
            let rms = taken.map_or(0.0, |taken| Texture::of(&taken).rms);
            format!("{which} off, {} um rms", four(1e6 * rms))
        });
    }

    fn space(&mut self, spacing: f64) -> Result<(), Invalid> {
        let map = self.map.averaged(spacing).map_err(|error| refused("spacing", &error))?;
        self.done("spacing", map, |before, _| {
            let unresolved = unresolved(before, spacing);
            format!("means of {} um; {unresolved}", four(1e6 * spacing))
        });
        Ok(())
    }

    /// Takes the map over; what is said of it sees the one before and the new one.
    pub(super) fn done(
        &mut self,
        key: &'static str,
        map: HeightMap,
        said: impl FnOnce(&HeightMap, &HeightMap) -> String,
    ) {
        if let Some(steps) = &mut self.steps {
            let filled = self.map.missing().saturating_sub(map.missing());
            let filled = if key == HOLES.name { filled } else { 0 };
            steps.push(Preparation { key, said: said(&self.map, &map), filled });
        }
        self.map = map;
    }
}

/// How much of a map points at that distance (m) leave out, in words.
fn unresolved(map: &HeightMap, spacing: f64) -> String {
    let Ok(spectrum) = Spectrum::of(map, Window::Hann) else {
        return "nothing was measured".to_owned();
    };
    let left = spectrum.unresolved(spacing);
    let [height, slope, curvature] =
        [left.height, left.slope, left.curvature].map(|share| four(100.0 * share));
    format!(
        "{height} % of the mean square height, {slope} % of that slope and {curvature} % of that curvature are of waves that they do not resolve"
    )
}

/// The highest less the lowest (m) of what was taken off.
fn range_between(before: &HeightMap, after: &HeightMap) -> f64 {
    let taken = before.heights().iter().zip(after.heights()).map(|(before, after)| before - after);
    let ends = taken
        .filter(|one| !one.is_nan())
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], one| [low.min(one), high.max(one)]);
    ends[1] - ends[0]
}

/// Refuses keys that contradict each other.
fn agree(values: &Values) -> Result<(), Invalid> {
    let given = |name: &str| values.word(name).filter(|word| *word != "none");
    if let (Some(form), Some(_)) = (given("form"), given("level")) {
        let message = format!(
            "a {} is fitted with its tilt: leave `level` out, or `form`",
            form.replace('_', " along ")
        );
        return Err(Invalid::new("level", message));
    }
    if values.number("radius").is_some() && given("form").is_none() {
        let message =
            "is that of a `form`: give `form = \"sphere\"` or a cylinder, or leave it out";
        return Err(Invalid::new("radius", message));
    }
    match (values.number("smooth"), values.number("rough")) {
        (Some(smooth), Some(rough)) if smooth >= rough => {
            let message = format!(
                "takes off all waves below {} um, and `rough` all above {} um: give a longer `rough`",
                four(1e6 * smooth),
                four(1e6 * rough)
            );
            Err(Invalid::new("smooth", message))
        }
        _ => Ok(()),
    }
}

/// What a word stands for.
fn named<T: Copy>(word: Option<&str>, all: &[(&'static str, T)]) -> Option<(&'static str, T)> {
    all.iter().find(|(name, _)| Some(*name) == word).copied()
}

fn refused(key: &'static str, error: &dyn std::error::Error) -> Invalid {
    Invalid::new(key, error.to_string())
}
