//! The coefficients of a case from measured tests: rounds of runs until model and readings agree.
//!
//! Where the worn state follows from k s alone, one run gives all k: a reading at s of a test with k is what the run shows at
//! s k / k_run, and the last round's steps end there. Where the other body wears as the case has it, runs at a series of k tell
//! those between them. Other laws are run anew at each k that is tried. Where both coefficients are sought, tests are held
//! against runs in which their ratio is that of their medians.

mod conclude;
mod model;
mod root;
mod rounds;
mod together;

use std::collections::HashMap;
use std::path::Path;

use conclude::changed;

use super::computed::Shapes;
use super::kept;
use super::measurement::{Measurement, Target};
use super::outcome::Fit;
use super::runs::{Changes, Run, RunFollower, Runner, built};
use super::surfaces;
use super::untold::{self, Untold};
use super::{Common, Error, Estimate, Expectation, Files, Study, Test};
use archard::accuracy::{AccuracyFailure, Event};
use archard::simulation;
use archard_case::measured::Table;
use archard_case::output::Store;
use archard_case::{Case, CaseFile, RunnableCase, Source};

/// The factor by which a coefficient is changed to find a slope by a difference: small, and far above the error of the steps.
pub(super) const TRIED: f64 = 1.1;
/// Relative change of k at which a test is fitted: of interpolated runs, and of runs anew.
const FITTED: [f64; 2] = [1e-7, 1e-3];

/// What a fit is asked for besides case and table.
pub struct Request<'a> {
    /// The keys to be fitted, several from all readings together; if none, the coefficient of each body that has readings.
    pub parameters: &'a [String],
    /// Keys of the case, or the column of how far readings are, with their standard uncertainties, relative.
    pub uncertain: &'a [(String, f64)],
    /// Keys of wear that are taken from the case though no reading gives them, and those fitted though tests do not wear by their law.
    pub assumed: &'a [String],
    /// Where profiles and height maps are that the table names.
    pub files: Files<'a>,
    /// Where runs go.
    pub dir: &'a Path,
    /// Kept compliances.
    pub store: Option<&'a Store>,
    /// Follows the runs.
    pub following: &'a mut dyn RunFollower,
}

/// The coefficients of two bodies in contact.
pub(super) fn fit(
    (file, resolved): (&CaseFile, RunnableCase),
    table: &Table,
    request: Request<'_>,
) -> Result<Fit, Error> {
    let asked = (request.parameters, request.files);
    let mut measured = Measurement::of(table, &resolved.case, asked, None)?;
    let load = load_key(&resolved.case, &measured)?;
    // Before anything runs.
    all_told(&resolved.case, (table, &measured), request.assumed)?;
    for (key, relative) in request.uncertain {
        surfaces::refuse_shape(&measured.surfaces, key)?;
        changed(&resolved.case, (measured.progress.0, load.as_deref()), (key, *relative))?;
    }
    let (file, case) = &settled(file, resolved, request.store, &mut *request.following)?;
    if measured.waits() {
        let runs = (request.store, &mut *request.following);
        let mut shapes = Shapes::of((file, case.clone()), runs, false);
        measured = Measurement::of(table, case, asked, Some(&mut shapes))?;
    }
    let linear = measured.targets.iter().all(|own| own.key.ends_with(".wear.archard.coefficient"));
    let others = others(case, &measured.targets);
    let linear = linear && case.wears_by_k_s().is_some();
    let by_k_s = linear && others.is_empty();
    let runner = Runner {
        file,
        quantities: &measured.quantities,
        columns: measured.progress.1,
        dir: request.dir,
        store: request.store,
        following: request.following,
        count: 0,
        kept: vec![],
    };
    let reference: Vec<f64> = measured.targets.iter().map(|own| own.value).collect();
    let mut search = Search {
        runner,
        table,
        progress: measured.progress.0,
        targets: &measured.targets,
        load,
        others,
        by_k_s,
        between: linear && !by_k_s && reference.len() == 1,
        guess: reference.clone(),
        reference,
        variant: Variant::default(),
        known: HashMap::new(),
        scale: HashMap::new(),
        shares: HashMap::new(),
        name: "run",
        assumed_keys: request.assumed,
        of: None,
        judged: None,
    };
    let mut remarks = measured.remarks.clone();
    remarks.extend(search.assumed());
    let (coefficients, together, unsettled) = if request.parameters.len() > 1 {
        let (coefficients, correlations) =
            search.together(case, request.uncertain, &mut remarks)?;
        (coefficients, correlations, None)
    } else {
        let (first, unsettled) = search.settle()?;
        let commons = search.commons(case, &first, request.uncertain, &mut remarks)?;
        (search.conclude(&commons)?, vec![], unsettled)
    };
    kept::clear(request.dir, &search.runner.kept);
    let surfaces = measured.surfaces.clone();
    let quantities = measured.quantities.iter().map(|own| {
        let (factor, unit) = own.kind.shown();
        (own.name.clone(), factor, unit)
    });
    Ok(Fit {
        progress: measured.progress.0,
        quantities: quantities.collect(),
        runs: search.runner.count,
        coefficients,
        together,
        surfaces,
        remarks,
        doubts: search.doubts(),
        by_k_s,
        unsettled,
    })
}

/// A case with an accuracy as one with the frame, the elements and the tolerance that it takes at the coefficients it has:
/// all runs of a fit have the same.
pub(super) fn settled(
    file: &CaseFile,
    resolved: RunnableCase,
    store: Option<&Store>,
    following: &mut dyn RunFollower,
) -> Result<(CaseFile, Case), Error> {
    if resolved.case.accuracy.is_none() {
        return Ok((file.clone(), resolved.case));
    }
    let observer = following.observer();
    let mut watch = |event: Event<'_>| match event {
        Event::Shows(report) => observer.observe(report),
        _ => Ok(()),
    };
    let settled = resolved.settle(&mut |case| Ok(built(case, store)?), &mut watch);
    let (settled, _) = settled.map_err(|error| match error {
        AccuracyFailure::Run { elements, cause } => match *cause {
            simulation::Error::Observer(cause) => Error::Stopped { cause, runs: 0 },
            cause => Error::Mismatch(
                AccuracyFailure::Run { elements, cause: Box::new(cause) }.to_string(),
            ),
        },
        other => Error::Mismatch(other.to_string()),
    })?;
    let case = Case { accuracy: None, ..settled.case };
    Ok((CaseFile::from_text(file.name(Source::File), case.to_string(), ""), case))
}

/// The key of the load, where tests have loads of their own.
pub(super) fn load_key(case: &Case, measured: &Measurement) -> Result<Option<String>, Error> {
    let own =
        measured.targets.iter().flat_map(|target| &target.tests).any(|test| test.load.is_some());
    if !own {
        return Ok(None);
    }
    let key = format!("motion.{}.load", case.motion.choice.name);
    match case.number_at(&key) {
        Some((_, unit)) if unit == "N" => Ok(Some(key)),
        _ => Err(Error::Mismatch(format!(
            "tests have loads (N), and the case has no such `{key}`: leave the column `load` out, or fit load by load"
        ))),
    }
}

/// Refuses a fit by coefficients that nobody has told: the case may have any number for a body without readings.
fn all_told(
    case: &Case,
    (table, measured): (&Table, &Measurement),
    assumed: &[String],
) -> Result<(), Error> {
    let missing = Untold::of(case, &[told(case, measured), assumed.to_vec()].concat());
    if missing.is_empty() {
        return Ok(());
    }
    Err(Error::Mismatch(format!(
        "{}: has no reading that tells {}: the fitted coefficient would go by a number which no test has told; add {} to take it \
         from the case, put another one there by --set, or give readings of both bodies",
        table.source(),
        Untold::values(&missing),
        Untold::options(&missing)
    )))
}

/// What the readings tell: the tables of wear of the fitted coefficients; where another value is fitted, all wear of the bodies that
/// were measured, which its user knows.
fn told(case: &Case, measured: &Measurement) -> Vec<String> {
    let wear =
        |target: &Target| target.key.split_once(".wear.").map(|(owner, _)| format!("{owner}.wear"));
    let tables: Vec<String> = measured.targets.iter().filter_map(wear).collect();
    let bodies =
        measured.quantities.iter().map(|own| format!("body.{}", case.bodies[own.body].name));
    if tables.is_empty() { bodies.collect() } else { tables }
}

/// Coefficients of wear that are not fitted: keys, values and units.
fn others(case: &Case, targets: &[Target]) -> Vec<(String, f64, String)> {
    let own = |(table, law): (String, &str)| {
        let key = format!("{table}.{law}.coefficient");
        let (value, unit) = case.number_at(&key)?;
        (value > 0.0 && targets.iter().all(|target| untold::dotted(&target.key) != key))
            .then_some((key, value, unit))
    };
    untold::laws(case).into_iter().filter_map(own).collect()
}

/// How the runs differ from those of the fit, to see what that does to k.
#[derive(Debug, Clone, Default)]
struct Variant {
    settings: Vec<(String, f64, String)>,
    /// Factors of loads and of how far readings are.
    load: Option<f64>,
    far: Option<f64>,
    /// Factor of the coefficient of the other body.
    other: Option<f64>,
    coarse_steps: bool,
    coarse_elements: bool,
}

struct Search<'a> {
    runner: Runner<'a>,
    table: &'a Table,
    progress: &'static str,
    targets: &'a [Target],
    load: Option<String>,
    others: Vec<(String, f64, String)>,
    by_k_s: bool,
    /// Whether runs at a series of k tell those between them.
    between: bool,
    /// The coefficients at which the scale of a run is one, and those that tests are fitted from.
    reference: Vec<f64>,
    guess: Vec<f64>,
    variant: Variant,
    /// Runs by what they were run with.
    known: HashMap<String, Run>,
    /// By load: the scale of the run that gives all k, and the places its steps end at.
    scale: HashMap<u64, f64>,
    shares: HashMap<u64, Vec<f64>>,
    name: &'static str,
    /// Keys whose law is assumed though tests do not wear by it.
    assumed_keys: &'a [String],
    /// The coefficient whose tests are held against runs.
    of: Option<usize>,
    /// The runs that are judged, where that is not all that are known.
    judged: Option<Vec<Run>>,
}

/// Refuses readings beyond a run.
pub(super) fn within(
    (table, progress): (&Table, &str),
    end: f64,
    test: &Test,
) -> Result<(), Error> {
    match test.readings.iter().find(|reading| reading.progress > end * (1.0 + 1e-9)) {
        None => Ok(()),
        Some(reading) => Err(Error::Reading {
            table: table.source().to_owned(),
            line: reading.line,
            why: format!(
                "`{progress}` is {} (SI) and the run of the case ends at {end}: let the case go as far as the readings",
                reading.progress
            ),
        }),
    }
}

/// The place of a load in maps.
fn of_load(load: Option<f64>) -> u64 {
    load.unwrap_or(0.0).to_bits()
}

impl Search<'_> {
    /// All loads of tests.
    fn loads(&self) -> Vec<Option<f64>> {
        let mut loads: Vec<Option<f64>> = vec![];
        for test in self.targets.iter().flat_map(|target| &target.tests) {
            if !loads.contains(&test.load) {
                loads.push(test.load);
            }
        }
        loads
    }

    /// How far runs go, by the column of the readings.
    fn end(&self) -> f64 {
        self.known.values().next().map_or(1.0, |run| run.end)
    }

    /// What the tests say with the runs as they are now.
    fn estimates(&mut self, commons: &[Vec<Common>]) -> Result<Vec<Estimate>, Error> {
        let targets = self.targets;
        let quantities: Vec<String> =
            self.runner.quantities.iter().map(|own| own.name.clone()).collect();
        let mut all = vec![];
        for (place, target) in targets.iter().enumerate() {
            let study = Study { quantities: quantities.clone(), tests: target.tests.clone() };
            let common = commons.get(place).map_or(&[][..], Vec::as_slice);
            let guess = self.guess[place];
            let settled = FITTED[usize::from(!self.by_k_s && !self.between)];
            self.of = Some(place);
            let mut model =
                |test: usize, log_k: f64| self.expected(place, &target.tests[test], log_k);
            let found = study.estimate((guess, settled), common, &mut model);
            all.push(found.map_err(|error| Error::untold(&error.test, error.cause))?);
        }
        Ok(all)
    }

    /// What runs say of the readings of a test at a logarithm of its coefficient.
    fn expected(
        &mut self,
        place: usize,
        test: &Test,
        log_k: f64,
    ) -> Result<Vec<Expectation>, Error> {
        let far = 1.0 + self.variant.far.unwrap_or(0.0);
        let model = self.model(place, test.load, log_k)?;
        within((self.table, self.progress), model.end(), test)?;
        let at = |reading: &super::Reading| model.at(reading.quantity, reading.progress * far);
        Ok(test.readings.iter().map(at).collect())
    }

    /// The run at a scale of the coefficients.
    fn run(&mut self, scale: f64, load: Option<f64>) -> Result<Run, Error> {
        let other = self.variant.other.unwrap_or(1.0);
        let factor = |place: usize| if self.of != Some(place) { other } else { 1.0 };
        let factors: Vec<f64> =
            (0..self.targets.len()).map(|place| factor(place) * scale).collect();
        self.run_at(&factors, scale, load)
    }

    /// The run at factors of the coefficients, and a scale of those that are not fitted.
    fn run_at(&mut self, factors: &[f64], scale: f64, load: Option<f64>) -> Result<Run, Error> {
        let mut settings = vec![];
        for ((target, reference), factor) in self.targets.iter().zip(&self.reference).zip(factors) {
            settings.push((target.key.clone(), reference * factor, target.unit.clone()));
        }
        // What only counts as k s is scaled as a whole.
        let factor = if self.by_k_s { scale } else { 1.0 };
        settings.extend(
            self.others
                .iter()
                .map(|(key, value, unit)| (key.clone(), factor * value, unit.clone())),
        );
        if let (Some(key), Some(load)) = (&self.load, load) {
            settings.push((
                key.clone(),
                load * (1.0 + self.variant.load.unwrap_or(0.0)),
                "N".to_owned(),
            ));
        }
        settings.extend(self.variant.settings.iter().cloned());
        let id = format!("{settings:?}");
        if let Some(run) = self.known.get(&id) {
            return Ok(run.clone());
        }
        let shares = match self.by_k_s {
            true => self.shares.get(&of_load(load)).cloned().unwrap_or_default(),
            false => self.places(load),
        };
        let Variant { coarse_steps, coarse_elements, .. } = self.variant;
        let run = self
            .runner
            .run(&Changes { settings, shares, coarse_steps, coarse_elements }, self.name)?;
        self.known.insert(id, run.clone());
        Ok(run)
    }

    /// The places of readings in a run, once it is known how far it goes.
    fn places(&self, load: Option<f64>) -> Vec<f64> {
        let Some(run) = self.known.values().next() else { return vec![] };
        let tests = self.targets.iter().flat_map(|target| &target.tests);
        let readings = tests.filter(|test| test.load == load).flat_map(|test| &test.readings);
        readings.map(|reading| reading.progress / run.end).collect()
    }
}
