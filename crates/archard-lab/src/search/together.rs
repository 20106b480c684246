//! Several coefficients from all readings together.
//!
//! Runs stand on a lattice of the logarithms of the coefficients, and what lies between them follows from cubics. Where the worn
//! state follows from k s alone, the lattice is one of the ratios to one coefficient.

use super::super::error::Error;
use super::super::joint::{Joint, NEAR, NotTold, Tangent, Tests};
use super::super::outcome::{Coefficient, DrawnCurve};
use super::super::{Common, Reading, Test};
use super::model::cubic;
use super::rounds::{BEYOND, ROUNDS};
use super::{FITTED, Run, Search, Variant, of_load, within};
use archard_case::Case;

/// Factor between the coefficients of neighbouring runs. A cubic through four of them is .023 (ln 1.5)^4, 6e-4, times the fourth
/// derivative off.
const APART: f64 = 1.5;
/// Largest change of the logarithms from one round of runs to the next.
const FARTHEST: f64 = 2.0;
/// How much farther than the readings runs go at first, where coefficients are still sought.
const MARGIN: f64 = 1.5;

/// Runs around coefficients, and where between them these are.
struct Lattice {
    runs: Vec<Run>,
    /// Places along each axis, from 0 to 1, and the coefficient that each is of.
    along: Vec<(f64, usize)>,
    /// The coefficient that all others are relative to, and k s of readings relative to that of the runs.
    base: Option<usize>,
    times: f64,
}

impl Lattice {
    fn at(&self, quantity: usize, progress: f64) -> Tangent {
        let there: Vec<_> =
            self.runs.iter().map(|run| run.at(quantity, progress * self.times)).collect();
        let t: Vec<f64> = self.along.iter().map(|own| own.0).collect();
        let logs: Vec<f64> = there.iter().map(|own| own.log).collect();
        let (log, by_axes) = tensor(&logs, &t);
        let mut slopes = vec![0.0; self.along.len() + usize::from(self.base.is_some())];
        for ((_, place), slope) in self.along.iter().zip(by_axes) {
            slopes[*place] = slope / APART.ln();
        }
        if let Some(base) = self.base {
            // All coefficients at once are progress.
            let all: Vec<f64> = there.iter().map(|own| own.slope).collect();
            slopes[base] = tensor(&all, &t).0 - slopes.iter().sum::<f64>();
        }
        Tangent { log, slopes }
    }
}

/// A product of cubics through values at -1, 0, 1 and 2 along each axis, the first one slowest, and its slopes.
fn tensor(values: &[f64], t: &[f64]) -> (f64, Vec<f64>) {
    let Some((first, rest)) = t.split_first() else { return (values[0], vec![]) };
    let quarter = values.len() / 4;
    let parts: [(f64, Vec<f64>); 4] =
        std::array::from_fn(|i| tensor(&values[i * quarter..(i + 1) * quarter], rest));
    let [value, slope] = cubic(parts.each_ref().map(|part| part.0), *first);
    let others =
        (0..rest.len()).map(|axis| cubic(parts.each_ref().map(|part| part.1[axis]), *first)[0]);
    (value, [slope].into_iter().chain(others).collect())
}

impl Search<'_> {
    /// The coefficients, and how their errors correlate.
    pub(super) fn together(
        &mut self,
        case: &Case,
        uncertain: &[(String, f64)],
        remarks: &mut Vec<String>,
    ) -> Result<(Vec<Coefficient>, Vec<Vec<f64>>), Error> {
        let targets = self.targets;
        let tests = &targets[0].tests;
        let joint = self.settled(tests)?;
        let mut judged = vec![];
        for load in self.loads() {
            judged.extend(self.lattice(&joint.logs, load)?.runs);
        }
        self.judged = Some(judged);
        let commons = self.in_common(case, (&joint, tests), uncertain, remarks)?;
        let estimates = joint.estimates(tests, &commons);
        let mut coefficients = vec![];
        for (place, (target, estimate)) in targets.iter().zip(estimates).enumerate() {
            let mut curves = vec![];
            for load in self.loads() {
                let [low, high] = estimate.interval.unwrap_or([estimate.median; 2]);
                let [next_low, next_high] = estimate.next.unwrap_or([low, high]);
                let ks = [next_low, low, estimate.median, high, next_high];
                match self.shown(&joint, place, load, ks) {
                    Ok(shown) => curves.extend(shown),
                    Err(stopped @ Error::Stopped { .. }) => return Err(stopped),
                    // The ends of intervals may be more than the case can be run with.
                    Err(why) => remarks.push(format!("no curves of {}: {why}", target.key)),
                }
            }
            coefficients.push(Coefficient {
                key: target.key.clone(),
                unit: target.unit.clone(),
                before: target.value,
                tests: tests.clone(),
                estimate,
                assumed: self.assumed_keys.contains(&target.key),
                curves,
            });
        }
        Ok((coefficients, joint.correlation))
    }

    /// The coefficient that others are relative to: that of a layer, which is worn first and says when.
    fn base(&self) -> Option<usize> {
        let layer = |key: &str| key.contains(".layers");
        let first = self.targets.iter().position(|target| layer(&target.key));
        self.by_k_s.then(|| first.unwrap_or(0))
    }

    /// Rounds of runs, until they go as far as the readings.
    fn settled(&mut self, tests: &[Test]) -> Result<Joint, Error> {
        let all = Tests { tests, quantities: self.runner.quantities.len() };
        let mut guess: Vec<f64> = self.reference.iter().map(|k| k.ln()).collect();
        // As one coefficient first, so that runs reach the readings: nothing is told of what no run has reached.
        for _ in 0..if self.by_k_s { ROUNDS } else { 0 } {
            let start = guess.clone();
            let mut model = |test: usize, by: &[f64]| {
                let at: Vec<f64> = start.iter().map(|log| log + by[0]).collect();
                let sum = |own: Tangent| Tangent { slopes: vec![own.slopes.iter().sum()], ..own };
                Ok::<_, Error>(self.tangents(&tests[test], &at)?.into_iter().map(sum).collect())
            };
            let by = all.pooled(&[0.0], NEAR, &mut model).map_err(|why| self.not_told(why))?[0];
            // Beyond a run its end goes on as a straight line, which leads no farther than this.
            let by = by.clamp(-FARTHEST, FARTHEST);
            guess.iter_mut().for_each(|log| *log += by);
            if !self.goes_on(tests, &vec![guess.clone(); tests.len()], MARGIN) {
                break;
            }
            self.known.clear();
        }
        let settled = FITTED[usize::from(!self.by_k_s)];
        for _ in 0..ROUNDS {
            let mut model = |test: usize, at: &[f64]| self.tangents(&tests[test], at);
            let found = all.joint(&guess, settled, &mut model);
            let found = found.map_err(|why| self.not_told(why))?;
            let goes_on = self.by_k_s && self.goes_on(tests, &found.of_tests, 1.001);
            if !goes_on && self.is_centred(&found.logs) {
                return Ok(found);
            }
            guess.clone_from(&found.logs);
            // Where a fit began makes no difference to the runs that it ends with.
            self.reference = guess.iter().map(|log| log.exp()).collect();
            self.scale.clear();
            if self.by_k_s {
                self.goes_on(tests, &found.of_tests, 1.001);
            }
            self.known.clear();
        }
        Err(Error::Mismatch(
            "the coefficients did not settle: fit one at a time, with --assume for the other"
                .to_owned(),
        ))
    }

    /// Whether the runs stand around these logarithms: less than a quarter of their distance off.
    fn is_centred(&self, logs: &[f64]) -> bool {
        let off = |(log, k): (&f64, &f64)| (log - k.ln()).abs() <= 0.25 * APART.ln();
        logs.iter().zip(&self.reference).all(off)
    }

    /// Makes the next runs go as far as the readings at these logarithms; whether those that are known do not.
    fn goes_on(&mut self, tests: &[Test], logs: &[Vec<f64>], margin: f64) -> bool {
        let base = self.base().unwrap_or(0);
        let end = self.end();
        let from = self.reference[base].ln();
        let mut places: Vec<(u64, Vec<f64>)> = vec![];
        for load in self.loads() {
            let own = tests.iter().zip(logs).filter(|(test, _)| test.load == load);
            let far = |(test, logs): (&Test, &Vec<f64>)| -> Vec<f64> {
                let times = (logs[base] - from).exp() / end;
                test.readings.iter().map(|own| own.progress * times).collect()
            };
            places.push((of_load(load), own.flat_map(far).collect()));
        }
        let mut changed = false;
        for (load, places) in places {
            let needed = places.iter().copied().fold(0.0, f64::max);
            let share = needed / self.scale.get(&load).copied().unwrap_or(1.0);
            if (0.5..=BEYOND).contains(&share) {
                continue;
            }
            changed = true;
            let scale = margin * needed;
            self.scale.insert(load, scale);
            self.shares.insert(load, places.iter().map(|place| place / scale).collect());
        }
        changed
    }

    /// What runs say of the readings of a test at logarithms of the coefficients.
    fn tangents(&mut self, test: &Test, logs: &[f64]) -> Result<Vec<Tangent>, Error> {
        let lattice = self.lattice(logs, test.load)?;
        within((self.table, self.progress), lattice.runs[0].end, test)?;
        let at = |own: &Reading| lattice.at(own.quantity, own.progress);
        Ok(test.readings.iter().map(at).collect())
    }

    fn lattice(&mut self, logs: &[f64], load: Option<f64>) -> Result<Lattice, Error> {
        let base = self.base();
        let off: Vec<f64> = logs.iter().zip(&self.reference).map(|(log, k)| log - k.ln()).collect();
        let of_base = base.map_or(0.0, |base| off[base]);
        let scale = match base {
            Some(_) => self.scale.get(&of_load(load)).copied().unwrap_or(1.0),
            None => 1.0,
        };
        let axes: Vec<usize> = (0..logs.len()).filter(|&place| Some(place) != base).collect();
        let places: Vec<f64> =
            axes.iter().map(|&place| (off[place] - of_base) / APART.ln()).collect();
        let mut runs = vec![];
        for node in 0..4_usize.pow(axes.len() as u32) {
            let mut factors = vec![scale; logs.len()];
            for (axis, (&place, along)) in axes.iter().zip(&places).enumerate() {
                let digit = node / 4_usize.pow((axes.len() - 1 - axis) as u32) % 4;
                factors[place] *= APART.powf(along.floor() + digit as f64 - 1.0);
            }
            runs.push(self.run_at(&factors, scale, load)?);
        }
        let along = places.iter().map(|along| along - along.floor()).zip(axes).collect();
        Ok(Lattice { runs, along, base, times: of_base.exp() / scale })
    }

    /// The run at logarithms of the coefficients by itself, and k s of readings relative to it.
    fn exactly(&mut self, logs: &[f64], load: Option<f64>) -> Result<(Run, f64), Error> {
        let mut factors: Vec<f64> =
            logs.iter().zip(&self.reference).map(|(log, k)| (log - k.ln()).exp()).collect();
        let times = match self.base() {
            Some(base) => factors[base] / self.scale.get(&of_load(load)).copied().unwrap_or(1.0),
            None => 1.0,
        };
        factors.iter_mut().for_each(|factor| *factor /= times);
        Ok((self.run_at(&factors, 1.0 / times, load)?, times))
    }

    /// Standard uncertainties of each coefficient that all tests have in common.
    fn in_common(
        &mut self,
        case: &Case,
        (joint, tests): (&Joint, &[Test]),
        uncertain: &[(String, f64)],
        remarks: &mut Vec<String>,
    ) -> Result<Vec<Vec<Common>>, Error> {
        let variants = self.variants(case, uncertain)?;
        let computed = variants.len() - uncertain.len();
        let known = std::mem::take(&mut self.known);
        self.name = "check";
        let plain = self.predicted(joint, tests)?;
        let between = |other: Vec<Vec<f64>>| -> Vec<Vec<f64>> {
            let less = |(one, other): (&Vec<f64>, Vec<f64>)| {
                one.iter().zip(other).map(|(a, b)| b - a).collect()
            };
            plain.iter().zip(other).map(less).collect()
        };
        let mut commons = vec![vec![]; self.targets.len()];
        for (index, (name, variant)) in variants.into_iter().enumerate() {
            (self.variant, self.known) = (variant, std::collections::HashMap::new());
            match self.predicted(joint, tests) {
                Ok(other) => {
                    let changes = joint.response(&between(other));
                    for (common, change) in commons.iter_mut().zip(changes) {
                        common.push((name.clone(), change.abs()));
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

    /// The logarithms of all readings by a run of each load at the medians.
    fn predicted(&mut self, joint: &Joint, tests: &[Test]) -> Result<Vec<Vec<f64>>, Error> {
        let far = 1.0 + self.variant.far.unwrap_or(0.0);
        let mut all = vec![];
        for test in tests {
            let (run, times) = self.exactly(&joint.logs, test.load)?;
            let at = |own: &Reading| run.at(own.quantity, own.progress * times * far).log;
            all.push(test.readings.iter().map(at).collect());
        }
        Ok(all)
    }

    /// What the case shows at some values of a coefficient, the others at their medians.
    fn shown(
        &mut self,
        joint: &Joint,
        place: usize,
        load: Option<f64>,
        ks: [f64; 5],
    ) -> Result<Vec<DrawnCurve>, Error> {
        let mut lattices = vec![];
        for k in ks {
            let mut logs = joint.logs.clone();
            logs[place] = k.ln();
            lattices.push(self.lattice(&logs, load)?);
        }
        Ok(self.curves_of(place, load, &|model, quantity, at| lattices[model].at(quantity, at).log))
    }

    /// Why tests do not tell the coefficients, by their keys.
    fn not_told(&self, why: NotTold<Error>) -> Error {
        let key = |place: usize| format!("`{}`", self.targets[place].key);
        let test = |place: usize| self.targets[0].tests[place].name.clone();
        let assume = "add readings that do, or fit one of them with --assume KEY for the other";
        Error::Mismatch(match why {
            NotTold::Model(error) => return error,
            NotTold::Flat(places) => match &places[..] {
                [one] => format!(
                    "the readings do not determine {}: they are nearly the same whatever it is, as those of a coating that is never \
                     worn through are for what is below; {assume}",
                    key(*one)
                ),
                all => format!(
                    "the readings determine a combination of {} and not each by itself: they are nearly the same where one is larger \
                     and the other smaller; {assume}",
                    all.iter().map(|place| key(*place)).collect::<Vec<_>>().join(" and ")
                ),
            },
            NotTold::Alone { test: place, coefficient } => format!(
                "test `{}` alone determines {}, so that nothing says how it scatters between tests: give another test that does, or fit \
                 that test alone",
                test(place),
                key(coefficient)
            ),
            NotTold::Unsettled => {
                format!("no coefficients fit the readings best: {}", assume)
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::tensor;

    #[test]
    fn products_of_cubics_are_exact() {
        let curve = |x: f64, y: f64| (1.0 + x - 0.2 * x * x * x) * (2.0 - y + 0.3 * y * y);
        let places = [-1.0, 0.0, 1.0, 2.0];
        let values: Vec<f64> = places.iter().flat_map(|x| places.map(|y| curve(*x, y))).collect();
        let (value, slopes) = tensor(&values, &[0.4, 0.7]);
        assert!((value - curve(0.4, 0.7)).abs() < 1e-13);
        let step = 1e-6;
        let along = [[step, 0.0], [0.0, step]];
        for (slope, [dx, dy]) in slopes.iter().zip(along) {
            let tried = (curve(0.4 + dx, 0.7 + dy) - curve(0.4 - dx, 0.7 - dy)) / (2.0 * step);
            assert!((slope - tried).abs() < 1e-8, "{slope} {tried}");
        }
    }
}
