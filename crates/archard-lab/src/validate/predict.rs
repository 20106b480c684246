//! The prediction of each test by the others, or by coefficients that others found.

use std::path::Path;

use super::{Compared, Set, Validated};
use crate::computed::{Setting, Shapes};
use crate::effects::factor;
use crate::estimate::MANY;
use crate::kept;
use crate::measurement::Measurement;
use crate::runs::{Changes, Runner};
use crate::search::{Request, fit, load_key, settled};
use crate::surfaces::Taken;
use crate::{Error, Files, Following};
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
    following: &'a mut dyn Following,
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
        following: &'a mut dyn Following,
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
    pub fn validated(mut self) -> Result<Validated, Error> {
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
            Ok(Validated { set, outcome: Err(why), coefficients, doubts: vec![] })
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
        Ok(Validated { set, outcome: Ok(all), coefficients, doubts: self.doubts })
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

    /// The coefficient for a test, or why there is none.
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
    fn compared(&mut self, name: &str, coefficient: &Coefficient) -> Result<Vec<Compared>, Error> {
        let own = self.part(name, true);
        let files = Files { folder: &self.set.dir, columns: &[] };
        let settings = &coefficient.settings;
        let (measured, fine) = {
            let case = self.case.clone();
            let mut shapes = self.shapes(false);
            let measured = Measurement::of(&own, &case, (&[], files), Some(&mut shapes))?;
            let fine = profiles(&measured).map(|(of, _)| shapes.at(of, settings));
            let fine = fine.collect::<Result<Vec<Shape>, Error>>()?;
            (measured, fine)
        };
        let mut all = self.numbers((name, &measured), coefficient)?;
        let mut shapes = self.shapes(true);
        for ((of, scar), fine) in profiles(&measured).zip(fine) {
            let coarse = depth_and_width(&shapes.at(of, settings)?);
            let Some((values, coarse)) = depth_and_width(&fine).zip(coarse) else { continue };
            let grown = scar.section.value / fine.section(1.0);
            let own = [
                ("depth", (1e6, "um"), scar.depth, fine.exponent()),
                ("width", (1e3, "mm"), scar.width, 1.0 - fine.exponent()),
            ];
            for (at, (quantity, unit, data, exponent)) in own.into_iter().enumerate() {
                all.extend(data.map(|data| Compared {
                    test: name.to_owned(),
                    quantity: quantity.to_owned(),
                    unit,
                    measured: data.value,
                    predicted: values[at],
                    at_own_section: Some(values[at] * grown.powf(exponent)),
                    halves: [
                        data.expanded / data.value,
                        exponent * coefficient.half,
                        (values[at] / coarse[at]).ln().abs(),
                    ],
                }));
            }
        }
        Ok(all)
    }

    /// Readings that are numbers, and sections and volumes of files, next to runs.
    fn numbers(
        &mut self,
        (name, measured): (&str, &Measurement),
        coefficient: &Coefficient,
    ) -> Result<Vec<Compared>, Error> {
        let load = load_key(&self.case, measured)?;
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
        let mut all = vec![];
        let tests = measured.targets.iter().flat_map(|target| &target.tests);
        for test in tests.filter(|test| test.name == name) {
            let own_load =
                load.iter().zip(test.load).map(|(key, load)| (key.clone(), load, "N".to_owned()));
            let settings: Vec<Setting> =
                coefficient.settings.iter().cloned().chain(own_load).collect();
            let mut run = |coarse_elements: bool| {
                let changes =
                    Changes { settings: settings.clone(), coarse_elements, ..Changes::default() };
                runner.run(&changes, if coarse_elements { "coarse" } else { "prediction" })
            };
            let (fine, coarse) = (run(false)?, run(true)?);
            let known = |doubt: &&String| !self.doubts.contains(doubt);
            let doubts: Vec<String> = fine.doubts.iter().filter(known).cloned().collect();
            self.doubts.extend(doubts);
            for reading in &test.readings {
                let quantity = &measured.quantities[reading.quantity];
                let [own, other] =
                    [&fine, &coarse].map(|run| run.at(reading.quantity, reading.progress));
                all.push(Compared {
                    test: name.to_owned(),
                    quantity: quantity.name.clone(),
                    unit: quantity.kind.shown(),
                    measured: reading.value,
                    predicted: own.log.exp(),
                    at_own_section: None,
                    halves: [
                        factor(MANY) * reading.uncertainty.unwrap_or(0.0),
                        own.slope * coefficient.half,
                        (own.log - other.log).abs(),
                    ],
                });
            }
        }
        kept::clear(self.dir, &runner.kept);
        Ok(all)
    }

    fn shapes(&mut self, halved: bool) -> Shapes<'_, 'a> {
        Shapes::of((&self.file, self.case.clone()), (self.store, &mut *self.following), halved)
    }
}

/// Profiles with their body and axis.
fn profiles(measured: &Measurement) -> impl Iterator<Item = ((usize, usize), &Scar)> {
    measured.surfaces.iter().filter_map(|own| match &own.scar {
        Taken::Profile(scar, axis) => Some(((own.body(), *axis), &**scar)),
        _ => None,
    })
}
