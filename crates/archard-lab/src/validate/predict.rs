//! The prediction of each test by the others, or by coefficients that others found.

use std::path::Path;

use super::{Comparison, Set, Validation};
use crate::computed::{Setting, Shapes};
use crate::effects::factor;
use crate::estimate::MANY;
use crate::kept;
use crate::measurement::Measurement;
use crate::quantity::Kind;
use crate::runs::{Changes, Run, Runner};
use crate::search::{Request, TRIED, load_key, settled, within};
use crate::{Error, Files, RunFollower, fit};
use archard_case::files::{self, Contents};
use archard_case::measured::Table;
use archard_case::output::Store;
use archard_case::{Case, CaseFile};
use archard_surface::scar::{Scar, Shape, depth_and_width};

/// A set about to be predicted.
pub(super) struct Prediction<'a> {
    set: &'a Set,
    dir: &'a Path,
    store: Option<&'a Store>,
    following: &'a mut dyn RunFollower,
    file: CaseFile,
    case: Case,
    table: Table,
    /// What is doubtful about the runs.
    doubts: Vec<String>,
}

/// Coefficients for a test: what is put into the case, half of the 95 % interval of their logarithm, and what they are in words.
struct Coefficient {
    settings: Vec<Setting>,
    half: f64,
    words: String,
}

impl<'a> Prediction<'a> {
    pub fn of(
        set: &'a Set,
        (dir, store): (&'a Path, Option<&'a Store>),
        following: &'a mut dyn RunFollower,
    ) -> Result<Self, Error> {
        let path = set.dir.join(&set.case);
        let unread =
            |name: &Path, why: String| Error::Mismatch(format!("{}: {why}", name.display()));
        let file = CaseFile::read(&path).map_err(|error| unread(&path, error.to_string()))?;
        let resolved = file.resolve().map_err(|problems| {
            let why: Vec<String> = problems.iter().map(|problem| file.describe(problem)).collect();
            Error::Mismatch(why.join("\n"))
        })?;
        let (file, case) = settled(&file, resolved, store, &mut *following)?;
        let path = set.dir.join(&set.tests);
        let bytes = files::read(&path, Contents::Text)
            .map_err(|error| unread(&path, format!("cannot read it: {error}")))?;
        let table = Table::read(&path.display().to_string(), &bytes)?;
        Ok(Self { set, dir, store, following, file, case, table, doubts: vec![] })
    }

    /// All tests with their predictions.
    pub fn validated(mut self) -> Result<Validation, Error> {
        let mut names: Vec<String> = vec![];
        for name in self.table.texts("test").unwrap_or_default() {
            if !names.iter().any(|known| known == name) {
                names.push(name.to_owned());
            }
        }
        if names.is_empty() {
            let why = "a column `test` is needed, which names each test";
            return Err(Error::Mismatch(format!("{}: {why}", self.table.source())));
        }
        let (mut all, mut coefficients) = (vec![], vec![]);
        let rejected = |why, coefficients| {
            let set = self.set.clone();
            Ok(Validation { set, outcome: Err(why), coefficients, doubts: vec![] })
        };
        if self.set.coefficient.is_none() {
            let whole = self.fitted(&self.table.clone())?;
            if let Some(why) = whole.rejected() {
                return rejected(why, coefficients);
            }
            if names.len() < 3 {
                let why = format!(
                    "{} tests: each is predicted by the others, and their scatter takes two at least; or give `coefficient` in `set.toml`",
                    names.len()
                );
                return rejected(why, coefficients);
            }
        }
        for name in &names {
            let coefficient = match self.coefficient(name)? {
                Ok(coefficient) => coefficient,
                Err(why) => return rejected(format!("without `{name}`: {why}"), coefficients),
            };
            all.extend(self.compared(name, &coefficient)?);
            coefficients.push([name.clone(), coefficient.words]);
        }
        let set = self.set.clone();
        Ok(Validation { set, outcome: Ok(all), coefficients, doubts: self.doubts })
    }

    /// The table with the rows of a test, or without them.
    fn part(&self, name: &str, with: bool) -> Table {
        let tests = self.table.texts("test").unwrap_or_default();
        self.table.only(|row| (tests[row] == name) == with)
    }

    /// A fit to some of the tests.
    fn fitted(&mut self, table: &Table) -> Result<crate::Fit, Error> {
        fit(
            &self.file,
            table,
            Request {
                parameters: &[],
                uncertain: &[],
                assumed: &self.set.assume,
                files: Files { folder: &self.set.dir, columns: &[] },
                dir: self.dir,
                store: self.store,
                following: &mut *self.following,
            },
        )
    }

    /// The coefficient for a test, or why none exists.
    fn coefficient(&mut self, name: &str) -> Result<Result<Coefficient, String>, Error> {
        if let Some(given) = &self.set.coefficient {
            let half = factor(MANY) * given.uncertainty;
            let words = format!("that of the case: {}", given.source);
            return Ok(Ok(Coefficient { settings: vec![], half, words }));
        }
        let found = self.fitted(&self.part(name, false))?;
        if let Some(why) = found.rejected() {
            return Ok(Err(why));
        }
        let mut coefficient = Coefficient { settings: vec![], half: 0.0, words: String::new() };
        for own in &found.coefficients {
            let Some([low, high]) = own.estimate.next else {
                return Ok(Err("the scatter of tests is not known from one of them".to_owned()));
            };
            let median = own.estimate.median;
            let (times, unit) = own.shown();
            coefficient.settings.push((own.key.clone(), median, own.unit.clone()));
            coefficient.half = coefficient.half.max(0.5 * (high / low).ln());
            let range = format!("{:.3e} .. {:.3e}", times * low, times * high);
            coefficient.words +=
                &format!("`{}` {:.3e} {unit} ({range}); ", own.key, times * median);
        }
        coefficient.words = coefficient.words.trim_end_matches("; ").to_owned();
        Ok(Ok(coefficient))
    }

    /// What was measured of a test next to its prediction.
    fn compared(
        &mut self,
        name: &str,
        coefficient: &Coefficient,
    ) -> Result<Vec<Comparison>, Error> {
        let own = self.part(name, true);
        let files = Files { folder: &self.set.dir, columns: &[] };
        let case = self.case.clone();
        let measured = Measurement::of(&own, &case, (&[], files), Some(&mut self.shapes(false)))?;
        let load = load_key(&case, &measured)?;
        let (mut all, mut profiles) = (vec![], vec![]);
        for test in measured.targets.iter().flat_map(|target| &target.tests) {
            let own_load =
                load.iter().zip(test.load).map(|(key, load)| (key.clone(), load, "N".to_owned()));
            let settings: Vec<Setting> =
                coefficient.settings.iter().cloned().chain(own_load).collect();
            let [fine, coarse, more] = self.runs(&measured, &settings)?;
            within((&own, measured.progress.0), fine.end, test)?;
            for reading in &test.readings {
                let quantity = &measured.quantities[reading.quantity];
                let at = |run: &Run| run.at(reading.quantity, reading.progress).log;
                let slope = (at(&more) - at(&fine)) / TRIED.ln();
                let halves = [
                    factor(MANY) * reading.uncertainty.unwrap_or(0.0),
                    slope * coefficient.half,
                    (at(&fine) - at(&coarse)).abs(),
                ];
                let profile = measured.surfaces.iter().find_map(|own| own.profile_in(reading.line));
                let of_profile = matches!(quantity.kind, Kind::Section | Kind::Middle(_));
                if let Some(profile) = profile.filter(|_| of_profile) {
                    let share = (reading.progress / fine.end).min(1.0);
                    profiles.push((profile, settings.clone(), share, halves[1]));
                }
                all.push(Comparison {
                    test: name.to_owned(),
                    quantity: quantity.name.clone(),
                    unit: quantity.kind.shown(),
                    measured: reading.value,
                    predicted: at(&fine).exp(),
                    at_own_section: None,
                    halves,
                });
            }
        }
        let mut shown: [Vec<Shape>; 2] = [vec![], vec![]];
        for (halved, shapes) in [false, true].into_iter().zip(&mut shown) {
            let mut runs = self.shapes(halved);
            for ((of, _), settings, share, _) in &profiles {
                shapes.push(runs.at(*of, (settings, *share))?);
            }
        }
        let [fine, coarse] = &shown;
        for (((_, scar), _, _, half), (fine, coarse)) in
            profiles.iter().zip(fine.iter().zip(coarse))
        {
            all.extend(depth_and_width_of(name, (scar, *half), (fine, coarse)));
        }
        Ok(all)
    }

    /// Runs with some settings: as they are, on half the elements, and with all wear a little larger.
    fn runs(&mut self, measured: &Measurement, settings: &[Setting]) -> Result<[Run; 3], Error> {
        // What is not set is what the case has.
        let mut larger = self.shapes(false).scaled(TRIED);
        for (key, value, _) in &mut larger {
            if let Some(own) = settings.iter().find(|own| own.0 == *key) {
                *value = TRIED * own.1;
            }
        }
        let kept = settings.iter().filter(|own| larger.iter().all(|other| other.0 != own.0));
        let larger: Vec<Setting> = kept.cloned().chain(larger.clone()).collect();
        let mut runner = Runner {
            file: &self.file,
            quantities: &measured.quantities,
            columns: measured.progress.1,
            dir: self.dir,
            store: self.store,
            following: &mut *self.following,
            count: 0,
            kept: vec![],
        };
        let mut run = |settings: &[Setting], coarse_elements: bool, name: &str| {
            let settings = settings.to_vec();
            runner.run(&Changes { settings, coarse_elements, ..Changes::default() }, name)
        };
        let all = [
            run(settings, false, "prediction")?,
            run(settings, true, "coarse")?,
            run(&larger, false, "larger")?,
        ];
        kept::clear(self.dir, &runner.kept);
        for doubt in &all[0].doubts {
            if !self.doubts.contains(doubt) {
                self.doubts.push(doubt.clone());
            }
        }
        Ok(all)
    }

    fn shapes(&mut self, halved: bool) -> Shapes<'_, 'a> {
        Shapes::of((&self.file, self.case.clone()), (self.store, &mut *self.following), halved)
    }
}

/// Depth and width of the scar on a profile next to those of a run, by half of the 95 % interval of the logarithm of its section.
fn depth_and_width_of(
    test: &str,
    (scar, half): (&Scar, f64),
    (fine, coarse): (&Shape, &Shape),
) -> Vec<Comparison> {
    let Some((values, coarse)) = depth_and_width(fine).zip(depth_and_width(coarse)) else {
        return vec![];
    };
    let grown = scar.section.value / fine.section(1.0);
    let own = [
        ("depth", (1e6, "um"), scar.depth, fine.exponent()),
        ("width", (1e3, "mm"), scar.width, 1.0 - fine.exponent()),
    ];
    let compared = own.into_iter().enumerate().map(|(at, (quantity, unit, data, exponent))| {
        data.map(|data| Comparison {
            test: test.to_owned(),
            quantity: quantity.to_owned(),
            unit,
            measured: data.value,
            predicted: values[at],
            at_own_section: Some(values[at] * grown.powf(exponent)),
            halves: [
                data.expanded / data.value,
                exponent * half,
                (values[at] / coarse[at]).ln().abs(),
            ],
        })
    });
    compared.flatten().collect()
}
