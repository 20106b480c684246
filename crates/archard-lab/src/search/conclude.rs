//! What follows once the coefficients have settled: what is uncertain in all tests equally, and what is shown.

use std::collections::HashMap;

use super::super::outcome::{Coefficient, DrawnCurve};
use super::super::{Common, Error, Estimate};
use super::{Run, Search, TRIED, Variant};
use archard_case::Case;

/// Points of a curve that is shown.
const POINTS: usize = 60;
/// The name of the coefficient of the other body in the budget, and the elasticity above which it is remarked upon.
const BOTH: &str = "coefficient of the other body";
const COUPLED: f64 = 0.1;
/// A coefficient so many times that of the case is remarked upon.
const FAR: f64 = 100.0;

/// A standard uncertainty that is not smaller, relative, does not change a value.
const MOST: f64 = 0.5;

/// Standard uncertainty of a median, relative.
fn half_width(own: &Estimate) -> f64 {
    own.interval.map_or(0.0, |[low, high]| (high / low).ln() / 4.0)
}

impl Search<'_> {
    /// Standard uncertainties of each coefficient that all tests have in common: by the steps and elements of the runs, and by
    /// what was said to be uncertain.
    pub(super) fn commons(
        &mut self,
        case: &Case,
        found: &[Estimate],
        uncertain: &[(String, f64)],
        remarks: &mut Vec<String>,
    ) -> Result<Vec<Vec<Common>>, Error> {
        let mut commons = vec![vec![]; found.len()];
        let mut variants = self.variants(case, uncertain)?;
        let computed = variants.len() - uncertain.len();
        if found.len() == 2 {
            let other = Variant { other: Some(TRIED), ..Variant::default() };
            variants.insert(computed, (BOTH.to_owned(), other));
        }
        let known = std::mem::take(&mut self.known);
        self.name = "check";
        for (index, (name, variant)) in variants.into_iter().enumerate() {
            self.variant = variant;
            self.known = HashMap::new();
            match self.estimates(&[]) {
                Ok(other) => {
                    for (place, other) in other.iter().enumerate() {
                        let changed = (other.median / found[place].median).ln().abs();
                        let own = match name == BOTH {
                            // By how much the other coefficient may be off.
                            true => changed / TRIED.ln() * half_width(&found[1 - place]),
                            false => changed,
                        };
                        if name == BOTH && changed > COUPLED * TRIED.ln() {
                            remarks.push(format!(
                                "{}: its readings depend on the coefficient of the other body too; the ratio of both is taken \
                                 to be the same in all tests (worn volumes would not ask for it)",
                                self.targets[place].key
                            ));
                        }
                        commons[place].push((name.clone(), own));
                    }
                }
                Err(error) if index < computed && !matches!(error, Error::Stopped { .. }) => {
                    remarks.push(format!("the error by the {name} is not known: {error}"));
                }
                Err(error) => return Err(error),
            }
        }
        (self.variant, self.known, self.name) = (Variant::default(), known, "run");
        Ok(commons)
    }

    /// Runs with coarser steps and elements, and with each of what is uncertain, last.
    pub(super) fn variants(
        &self,
        case: &Case,
        uncertain: &[(String, f64)],
    ) -> Result<Vec<(String, Variant)>, Error> {
        let steps = Variant { coarse_steps: true, ..Variant::default() };
        let mut variants = vec![("steps of the run".to_owned(), steps)];
        if !case.is_meshed() {
            let elements = Variant { coarse_elements: true, ..Variant::default() };
            variants.push(("elements of the run".to_owned(), elements));
        }
        for (key, relative) in uncertain {
            let of = (self.progress, self.load.as_deref());
            variants.push((key.clone(), changed(case, of, (key, *relative))?));
        }
        Ok(variants)
    }

    /// The coefficients with all that is known, and their curves.
    pub(super) fn conclude(&mut self, commons: &[Vec<Common>]) -> Result<Vec<Coefficient>, Error> {
        let estimates = self.estimates(commons)?;
        let targets = self.targets;
        let mut coefficients = vec![];
        for (place, (target, estimate)) in targets.iter().zip(estimates).enumerate() {
            if estimate.is_flat() {
                let test = target.tests[0].name.clone();
                let why = "readings cannot tell the coefficient: it may as well be a tenth or ten times as large".to_owned();
                return Err(Error::Untold { test, why });
            }
            let mut curves = vec![];
            for load in self.loads() {
                curves.extend(self.curves(place, load, &estimate)?);
            }
            coefficients.push(Coefficient {
                key: target.key.clone(),
                unit: target.unit.clone(),
                before: target.value,
                tests: target.tests.clone(),
                estimate,
                assumed: self.assumed_keys.contains(&target.key),
                curves,
            });
        }
        Ok(coefficients)
    }

    /// What the case shows at the median and the ends of the intervals, of each quantity with readings at a load.
    fn curves(
        &mut self,
        place: usize,
        load: Option<f64>,
        own: &Estimate,
    ) -> Result<Vec<DrawnCurve>, Error> {
        let [low, high] = own.interval.unwrap_or([own.median; 2]);
        let [next_low, next_high] = own.next.unwrap_or([low, high]);
        let ks = [next_low, low, own.median, high, next_high];
        let mut models = vec![];
        for k in ks {
            models.push(self.model(place, load, k.ln())?);
        }
        Ok(self.curves_of(place, load, &|model, quantity, at| models[model].at(quantity, at).log))
    }

    /// The curves of each quantity with readings at a load, by the logarithms that each of five models says of it at a place.
    pub(super) fn curves_of(
        &self,
        place: usize,
        load: Option<f64>,
        models: &dyn Fn(usize, usize, f64) -> f64,
    ) -> Vec<DrawnCurve> {
        let tests = || self.targets[place].tests.iter().filter(|test| test.load == load);
        let readings = || tests().flat_map(|test| &test.readings);
        let far = readings().map(|reading| reading.progress).fold(0.0, f64::max);
        let near = readings().map(|reading| reading.progress).fold(far, f64::min);
        let (first, last) = ((0.5 * near).min(0.02 * far), 1.05 * far);
        let quantities = (0..self.runner.quantities.len())
            .filter(|&quantity| readings().any(|reading| reading.quantity == quantity));
        let point = |quantity: usize, index: usize| {
            let at = first * (last / first).powf(index as f64 / (POINTS - 1) as f64);
            (at, std::array::from_fn(|i| models(i, quantity, at).exp()))
        };
        let shown = |quantity: usize| {
            let points = (0..POINTS).map(|index| point(quantity, index)).collect();
            DrawnCurve { load, quantity, points }
        };
        quantities.map(shown).collect()
    }

    /// What is taken from the case though no reading gives it.
    pub(super) fn assumed(&self) -> impl Iterator<Item = String> {
        self.others.iter().map(|(key, value, unit)| {
            format!(
                "`{key}` is {value:.3e} {unit}, as in the case: no reading determines it, and the fitted coefficient may depend on \
                 it; `--uncertain {key}=PERCENT` counts what it is uncertain by"
            )
        })
    }

    /// What is doubtful about the runs.
    pub(super) fn doubts(&self) -> Vec<String> {
        let mut doubts: Vec<String> = vec![];
        let judged = self.judged.as_ref().map(|all| all.iter().collect());
        let judged: Vec<&Run> = judged.unwrap_or_else(|| self.known.values().collect());
        for run in judged {
            for doubt in &run.doubts {
                let text = format!("the run of the model is {doubt}");
                if !doubts.contains(&text) {
                    doubts.push(text);
                }
            }
        }
        for (target, reference) in self.targets.iter().zip(&self.reference) {
            let times = reference / target.value;
            if self.by_k_s && !(1.0 / FAR..FAR).contains(&times) {
                doubts.push(format!(
                    "{} is {times:.1e} times what the case has: see that the units of the readings are right",
                    target.key
                ));
            }
        }
        doubts
    }
}

/// The runs with a value off by its uncertainty, where readings say in `progress` how far they are, and tests have that load.
pub(super) fn changed(
    case: &Case,
    (progress, load): (&str, Option<&str>),
    (key, relative): (&str, f64),
) -> Result<Variant, Error> {
    if !(relative > 0.0 && relative < MOST) {
        return Err(Error::Mismatch(format!(
            "`{key}` with a standard uncertainty of {} %: it lies between 0 % and {} %",
            100.0 * relative,
            100.0 * MOST
        )));
    }
    if key == progress {
        return Ok(Variant { far: Some(relative), ..Variant::default() });
    }
    if load == Some(key) {
        return Ok(Variant { load: Some(relative), ..Variant::default() });
    }
    let extents = ["distance", "revolutions", "cycles"];
    if extents.iter().any(|name| key == format!("motion.{}.{name}", case.motion.choice.name)) {
        return Err(Error::Mismatch(format!(
            "`{key}` is how far the run goes; the uncertainty of how far readings are is that of `{}`",
            progress
        )));
    }
    let Some((value, unit)) = case.number_at(key) else {
        return Err(Error::Mismatch(format!(
            "`{key}` is no number in the case that could be uncertain"
        )));
    };
    let settings = vec![(key.to_owned(), value * (1.0 + relative), unit)];
    Ok(Variant { settings, ..Variant::default() })
}
