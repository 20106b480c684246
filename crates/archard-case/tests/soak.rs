//! Random cases: every run ends with a finite history whose rows carry what was prescribed, or with an error.
//!
//! A hundred in every test, thousands in `just soak`. What fails is named by its seed, with the case:
//! `ARCHARD_SEED=17 cargo test --test soak` runs that one.

#[path = "soak/cases.rs"]
mod cases;
#[path = "common/random.rs"]
mod random;

use std::collections::BTreeMap;
use std::error::Error as StdError;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::{Duration, Instant};

use archard::motion::Control;
use archard::simulation::{Observer, Report, Simulation, row};
use archard_case::{CaseFile, Severity};

use cases::random_case;
use random::{runs, within};

/// Relative error of the load carried, over the bound on the residual: that counts the approach, which grows with the
/// load to the power 2/3.
const CARRIED: f64 = 1.5 * (1.0 + 1e-3);
/// What a case of at most 40 x 40 elements may take, on a machine that is busy with other things.
const LONG: Duration = Duration::from_secs(300);

/// Holds every row against what was prescribed.
#[derive(Default)]
struct Watch {
    /// Bound on the residual of the solver that finds the load.
    tolerance: f64,
    rows: usize,
    ended: bool,
    wrong: Option<String>,
}

impl Observer for Watch {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        self.rows += 1;
        self.ended = report.state.progress >= report.extent * (1.0 - 1e-9);
        if self.wrong.is_none() {
            self.wrong =
                wrong(report, self.tolerance).map(|what| format!("row {}: {what}", self.rows));
        }
        Ok(())
    }
}

/// What is wrong with a row.
fn wrong(report: &Report<'_>, tolerance: f64) -> Option<String> {
    let state = report.state;
    let off = match report.prescribed {
        Control::Load(load) => ("load", state.load, load),
        Control::Approach(approach) => ("approach", state.approach, approach),
    };
    if (off.1 - off.2).abs() > CARRIED * tolerance * off.2.abs() || !off.1.is_finite() {
        return Some(format!("{} {:e} where {:e} was prescribed", off.0, off.1, off.2));
    }
    let infinite = row(report).into_iter().find(|(column, value)| {
        !value.is_finite() && column != "time_error" // None is NaN there.
    });
    if let Some((column, value)) = infinite {
        return Some(format!("{column} is {value}"));
    }
    let gap = state.gap_of(report.problem);
    let [one, other] = [state.worn(0), state.worn(1)];
    let fields = [&state.pressure[..], &gap, &one, &other];
    if fields.iter().any(|field| field.iter().any(|value| !value.is_finite())) {
        return Some("a field is not finite".to_owned());
    }
    let negative = |field: &[f64]| field.iter().any(|&value| value < 0.0);
    let fields = [("pressure", &state.pressure[..]), ("wear", fields[2]), ("wear", fields[3])];
    fields.iter().find(|(_, field)| negative(field)).map(|(name, _)| format!("negative {name}"))
}

/// Bound on the residual with which the load is found: of unlike bodies that are shifted, pressures and friction are found
/// by one solver, that of friction.
fn tolerance(simulation: &Simulation) -> f64 {
    let problem = &simulation.problem;
    let shifted = problem.friction.is_some() && problem.motion.increments().is_some();
    if shifted && problem.compliance.couples() {
        return simulation.friction_solver.settings().tolerance;
    }
    simulation.solver.settings().tolerance
}

/// How a random case ended: a word to count, or what is wrong.
fn ends(text: &str, folder: &Path) -> Result<String, String> {
    let resolved = match CaseFile::from_text("case", text, folder).resolve() {
        Ok(resolved) => resolved,
        Err(problems) => {
            let error = problems.iter().find(|problem| problem.severity == Severity::Error);
            let message = error.map(|problem| problem.title()).unwrap_or_default();
            return Ok(format!("refused: {}", without_numbers(&message)));
        }
    };
    let simulation = resolved.case.build().map_err(|error| format!("not built: {error}"))?;
    let mut watch = Watch { tolerance: tolerance(&simulation), ..Watch::default() };
    let run = simulation.run(&mut [&mut watch]);
    if let Some(wrong) = watch.wrong {
        return Err(wrong);
    }
    match run {
        Ok(_) if watch.ended => Ok("whole".to_owned()),
        Ok(_) => Err(format!("ended after {} rows before the end", watch.rows)),
        Err(error) => Ok(format!("error: {}", without_numbers(&error.to_string()))),
    }
}

/// A message with every word that has a digit left out, to count equal ones together.
fn without_numbers(message: &str) -> String {
    let numeric = |word: &&str| !word.contains(|letter: char| letter.is_ascii_digit());
    message.split_whitespace().filter(numeric).collect::<Vec<_>>().join(" ")
}

/// Runs the cases of these seeds and counts how they end.
fn soak(seeds: std::ops::Range<u64>) {
    let folder = tempfile::tempdir().unwrap();
    let (mut ways, mut failures) = (BTreeMap::<String, Vec<u64>>::new(), vec![]);
    let single = seeds.clone().count() == 1;
    for seed in seeds.clone() {
        let text = random_case(seed, folder.path());
        if single {
            eprintln!("{text}");
        }
        let start = Instant::now();
        let ended = within(LONG, &format!("seed {seed}:\n{text}"), || {
            catch_unwind(AssertUnwindSafe(|| ends(&text, folder.path())))
        });
        if start.elapsed() > Duration::from_secs(5) {
            eprintln!("seed {seed} took {:.1?}", start.elapsed());
        }
        match ended.unwrap_or_else(|_| Err("panics".to_owned())) {
            Ok(way) => ways.entry(way).or_default().push(seed),
            Err(what) => {
                eprintln!("seed {seed} {what}\n{text}");
                failures.push(format!("seed {seed}: {what}"));
            }
        }
    }
    for (way, seeds) in &ways {
        eprintln!("{:5} {way}: {:?}", seeds.len(), &seeds[..seeds.len().min(12)]);
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    let whole = ways.get("whole").map_or(0, Vec::len);
    let all = seeds.count();
    // Measured: 87 % of the first 2,000; most of the others are frames of two elements, which are refused.
    assert!(single || 10 * whole > 7 * all, "only {whole} of {all} cases ran to their end");
}

#[test]
fn random_cases_carry_what_is_prescribed_or_say_why_not() {
    soak(runs("ARCHARD_RUNS", 100));
}

#[test]
#[ignore = "takes minutes; `just soak` runs it"]
fn thousands_of_random_cases_carry_what_is_prescribed_or_say_why_not() {
    soak(runs("ARCHARD_SOAK_RUNS", 2000));
}
