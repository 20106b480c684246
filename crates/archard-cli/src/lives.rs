//! How lives scatter from part to part: about the life of a run, as the coefficient of a fit does from test to test.
//!
//! Where a life falls with the coefficient, the life which a share of parts does not reach is that of the coefficient which the same share
//! has above it. Where k s alone counts, one run gives all of them; else each takes a run.

use std::path::PathBuf;

use archard::motion::Progress;
use archard::simulation::{Error, Simulation};
use archard_case::output::{Life, Lives};
use archard_case::{Case, CaseFile, RunnableCase};
use archard_lab::next_test;

use crate::arguments::Run;
use crate::diagnose;
use crate::failure::Failure;
use crate::fitted::{self, FittedCoefficient};
use crate::interrupt::{Interruption, Watch};
use crate::number::four;
use crate::progress::Follower;

/// Shares of parts that are told where each takes a run: B1, B10 and the half.
const TOLD: [f64; 3] = [0.01, 0.1, 0.5];

/// Coefficients of a fit, by their keys in the case of the run.
#[derive(Debug, Clone)]
pub struct FitSample {
    coefficients: Vec<FittedCoefficient>,
    source: PathBuf,
}

impl FitSample {
    /// The coefficients that are asked for, if any are.
    pub fn of(arguments: &Run) -> Result<Option<Self>, Failure> {
        let Some(source) = &arguments.from else { return Ok(None) };
        let mut coefficients = fitted::read(source).map_err(Failure::wrong)?.coefficients;
        match (&arguments.key, &mut coefficients[..]) {
            (Some(key), [own]) => own.key.clone_from(key),
            (Some(_), all) => {
                return Err(Failure::wrong(format!(
                    "--as: `{}` has {} coefficients, and one key does not say which: name the bodies as the fit does",
                    source.display(),
                    all.len()
                )));
            }
            (None, _) => {}
        }
        Ok(Some(Self { coefficients, source: source.clone() }))
    }

    /// The case with the medians, and what is not told taken from where the arguments say.
    pub fn put(&self, arguments: &Run, file: CaseFile) -> Result<CaseFile, Failure> {
        let file = self.coefficients.iter().fold(file, |file, own| put(file, own, own.median));
        let keys = self.coefficients.iter().map(|own| &*own.key);
        let given = [&arguments.set, &arguments.assume].into_iter().flatten().map(String::as_str);
        fitted::all_known(&self.source, &file, &keys.chain(given).collect::<Vec<_>>())?;
        Ok(file)
    }

    /// What other coefficients than the medians make of the life of a case, by runs if they are needed, which come before the run
    /// itself.
    pub fn foresee(
        self,
        resolved: &RunnableCase,
        arguments: &Run,
        (watch, follower): (&Watch, &mut Follower),
    ) -> Result<Option<LifeForecast>, Failure> {
        let case = &resolved.case;
        if case.until.is_empty() {
            return Ok(None);
        }
        let [own] = &self.coefficients[..] else {
            let why = "several coefficients scatter: `archard sweep CASE --from FIT --samples 200` draws them all".to_owned();
            return Ok(Some(LifeForecast { told: self, by: By::Nothing(why) }));
        };
        let own = own.clone();
        let laid = |k: f64| laid(case, arguments, &own, k);
        if let (Some(one), Some(other)) =
            (similar(laid(own.median)?), similar(laid(2.0 * own.median)?))
            && one == other
        {
            return Ok(Some(LifeForecast { told: self, by: By::Scale }));
        }
        let mut runs = vec![];
        for k in own.tried() {
            follower.begin_before(format!("life of parts with k = {} {}", four(k), own.unit));
            let mut life = Life::until(case.until.clone());
            let store = arguments.store();
            let built = laid(k)?;
            let simulation: Simulation = store
                .as_ref()
                .map_or_else(|| built.build(), |store| built.build_keeping(store))
                .map_err(|error| Failure::wrong(error.to_string()))?;
            simulation.run(&mut [&mut life, &mut *follower, &mut watch.clone()]).map_err(failed)?;
            runs.push(life.reached().map_or(f64::INFINITY, |reached| reached.progress));
        }
        Ok(Some(LifeForecast { told: self, by: By::Runs(runs) }))
    }
}

/// What gives the lives of other coefficients.
#[derive(Debug)]
enum By {
    /// The life at the median, times the median over k.
    Scale,
    /// Those at the ends of the interval, if there is one, and of parts of small shares.
    Runs(Vec<f64>),
    /// Nothing, and why.
    Nothing(String),
}

/// Coefficients, and the lives that they make.
#[derive(Debug)]
pub struct LifeForecast {
    told: FitSample,
    by: By,
}

impl LifeForecast {
    /// How lives scatter about that of the medians.
    pub fn about(self, life: &Life) -> Lives {
        let median = life.reached().map_or(f64::INFINITY, |reached| reached.progress);
        let own = &self.told.coefficients[0];
        let mut lives = Lives {
            key: own.key.clone(),
            source: self.told.source.display().to_string(),
            interval: None,
            shares: vec![[0.5, median]],
            untold: own.next.as_ref().err().cloned(),
        };
        match &self.by {
            By::Scale if median.is_infinite() => {
                let why = "with the median the limit lies beyond the motion: make that longer";
                lives.untold = Some(why.to_owned());
            }
            By::Scale => {
                let of = |k: f64| median * own.median / k;
                lives.interval = own.interval.map(|[low, high]| [of(high), of(low)]);
                let shares = curve();
                let k = own.next_of(&shares);
                if !k.is_empty() {
                    lives.shares =
                        shares.into_iter().zip(k).map(|(share, k)| [share, of(k)]).collect();
                }
            }
            By::Runs(runs) if !falls(own, runs, median) => {
                let key = &own.key;
                lives.untold = Some(format!(
                    "the life does not fall with `{key}`; `archard sweep CASE --from FIT --samples 200` draws it"
                ));
            }
            By::Runs(runs) => {
                let (ends, early) = runs.split_at(own.ends().len());
                lives.interval = <[f64; 2]>::try_from(ends).ok();
                let early = TOLD.into_iter().zip(early).map(|(share, life)| [share, *life]);
                lives.shares = early.chain([[0.5, median]]).collect();
            }
            By::Nothing(why) => lives.untold = Some(why.clone()),
        }
        lives
    }
}

/// Whether the life of the smallest coefficient that was tried is longer than that of the largest.
fn falls(own: &FittedCoefficient, runs: &[f64], median: f64) -> bool {
    let tried = own.tried().into_iter().zip(runs.iter().copied());
    let mut lives: Vec<(f64, f64)> = tried.chain([(own.median, median)]).collect();
    lives.sort_by(|one, other| one.0.total_cmp(&other.0));
    let [longest, shortest] = [lives[0].1, lives[lives.len() - 1].1];
    longest > shortest || longest.is_infinite() || lives.len() == 1
}

impl FittedCoefficient {
    /// The ends of the interval of the median, from the shorter life to the longer one.
    fn ends(&self) -> Vec<f64> {
        self.interval.map_or(vec![], |[low, high]| vec![high, low])
    }

    /// The coefficients that take a run each, where the median does not tell the others.
    fn tried(&self) -> Vec<f64> {
        self.ends().into_iter().chain(self.next_of(&TOLD[..2])).collect()
    }

    /// The coefficients that these shares of the next tests lie above; none where it is not told how they scatter.
    fn next_of(&self, shares: &[f64]) -> Vec<f64> {
        let Ok([deviation, degrees]) = self.next else { return vec![] };
        let k = |share: &f64| next_test([self.median, deviation, degrees], 1.0 - share);
        shares.iter().map(k).collect()
    }
}

/// Each hundredth of the parts up to nine tenths: the last ones last for very long.
fn curve() -> Vec<f64> {
    (1..=90).map(|share| f64::from(share) / 100.0).collect()
}

fn put(file: CaseFile, own: &FittedCoefficient, k: f64) -> CaseFile {
    let value =
        if own.unit.is_empty() { format!("{k:e}") } else { format!("\"{k:e} {}\"", own.unit) };
    file.set_by("--from", format!("{}={value}", own.key))
}

/// The case as it runs, on the same elements, with another coefficient.
fn laid(case: &Case, arguments: &Run, own: &FittedCoefficient, k: f64) -> Result<Case, Failure> {
    let folder = arguments.case.as_deref().map_or(PathBuf::new(), |path| {
        let folder = if path.is_dir() { Some(path) } else { path.parent() };
        folder.map(PathBuf::from).unwrap_or_default()
    });
    let mut again = case.clone();
    again.accuracy = None;
    let file = put(
        CaseFile::from_text("the case with another coefficient", again.to_string(), folder),
        own,
        k,
    );
    let resolved = file.resolve().map_err(|problems| {
        diagnose::show(&file, &problems);
        Failure::Shown
    })?;
    Ok(resolved.case)
}

/// What a case shares with those that one run answers together with it.
fn similar(mut case: Case) -> Option<String> {
    case.until.clear();
    case.doubles.clear();
    case.wears_by_k_s().map(|own| own.kind)
}

fn failed(error: Error) -> Failure {
    match error {
        Error::Observer(cause) if cause.is::<Interruption>() => {
            Failure::Interrupted(format!("{Interruption} before the run had begun"))
        }
        error if error.is_of_convergence() => Failure::NotConverged(error.to_string()),
        error => Failure::wrong(error.to_string()),
    }
}

/// Lines of a name and words: the interval of the median, B10 and B1, or why they are unknown.
pub fn lines(lives: &Lives, motion: Progress) -> Vec<(&'static str, String)> {
    let unit = motion.quantity.unit();
    let shown = |life: f64| match life.is_finite() {
        true => format!("{} {unit}", four(life)),
        false => "beyond the motion".to_owned(),
    };
    let interval = lives.interval.map(|[low, high]| {
        let words = format!("95 % interval {} .. {}, by that of k", shown(low), shown(high));
        ("median life", words)
    });
    let of = |name, share, words: &str| {
        let life = lives.of_share(share)?;
        Some((name, format!("{}: {words} of the parts last longer", shown(life))))
    };
    let untold = lives.untold.as_ref().map(|why| ("B10, B1", format!("unknown: {why}")));
    let early = [of("B10", 0.1, "90 %"), of("B1", 0.01, "99 %")];
    interval.into_iter().chain(early.into_iter().flatten()).chain(untold).collect()
}
