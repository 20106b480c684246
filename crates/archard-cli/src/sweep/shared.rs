//! Rows that differ in k alone: one run that goes through the end of each.
//!
//! Where the worn state follows from k s, the row with the largest coefficient passes the state in which every other ends,
//! at the same share of its distance as of its coefficient. A step of it ends there, so that nothing is interpolated.

use std::collections::HashMap;
use std::error::Error as StdError;
use std::path::Path;
use std::time::Instant;

use archard::simulation::history::{self, WEAR_DEPTH, rescaled};
use archard::simulation::{Observer, Report};
use archard_case::Problem;
use archard_case::output::{Claim, Error, RowsOfRun, Store};
use archard_case::verdict::{Verdict, Warning};

use super::course::Course;
use super::design::Row;
use super::row::{self, Outcome, StoppableOutput};
use crate::interrupt::Requests;
use archard::numerics::SAME;

/// Rows that one run gives.
#[derive(Debug, Clone, PartialEq)]
pub struct SharedRun {
    /// The rows by number from zero on, by rising coefficient; the last one is run.
    pub rows: Vec<usize>,
    /// Their coefficients over that of the last one.
    pub shares: Vec<f64>,
}

impl SharedRun {
    /// The row that is run.
    pub fn runs(&self) -> usize {
        self.rows[self.rows.len() - 1]
    }
}

/// Some of the rows, those together that one run gives, by their first row.
pub fn group(rows: &[Row], which: &[usize], separate: bool) -> Vec<SharedRun> {
    let mut kinds: HashMap<String, Vec<(f64, usize)>> = HashMap::new();
    let mut groups = vec![];
    for &index in which {
        match rows[index].resolved.case.wears_by_k_s().filter(|_| !separate) {
            Some(known) => kinds.entry(known.kind).or_default().push((known.coefficient, index)),
            None => groups.push(alone(index)),
        }
    }
    for mut alike in kinds.into_values() {
        alike.sort_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
        groups.extend(told(rows, &alike));
    }
    groups.sort_by_key(|group| group.rows.iter().min().copied());
    groups
}

fn alone(row: usize) -> SharedRun {
    SharedRun { rows: vec![row], shares: vec![1.0] }
}

/// The rows of one kind, by rising coefficient: one group, and by themselves those that a run would not tell apart.
fn told(rows: &[Row], alike: &[(f64, usize)]) -> Vec<SharedRun> {
    let Some(&(largest, last)) = alike.last() else { return vec![] };
    let Ok((_, schedule)) = rows[last].resolved.case.motion.build() else {
        return alike.iter().map(|&(_, row)| alone(row)).collect();
    };
    let mut shared = SharedRun { rows: vec![], shares: vec![] };
    let mut groups = vec![];
    for &(coefficient, row) in alike {
        let share = coefficient / largest;
        let before = shared.shares.last().copied().unwrap_or(0.0);
        if row == last || schedule.tells(before, share) && schedule.tells(share, 1.0) {
            shared.rows.push(row);
            shared.shares.push(share);
        } else {
            groups.push(alone(row));
        }
    }
    groups.push(shared);
    groups
}

/// Runs the last of the rows and writes a result folder for each.
pub fn run(
    (shared, rows, study): (&SharedRun, &[Row], &Path),
    (requests, store): (&Requests, Option<&Store>),
) -> Vec<(usize, Outcome)> {
    let done = |index: &usize| row::is_done(&row::folder(study, *index), &rows[*index].resolved);
    if shared.rows.iter().all(done) {
        return shared.rows.iter().map(|&index| (index, Outcome::Done)).collect();
    }
    match attempt((shared, rows, study), (requests, store)) {
        Ok(outcomes) => outcomes,
        Err(error) => {
            let outcome = |index: &usize| match &error {
                Error::InUse { .. } => (*index, Outcome::Elsewhere),
                error => (*index, Outcome::Failed(error.to_string())),
            };
            shared.rows.iter().map(outcome).collect()
        }
    }
}

fn attempt(
    (shared, rows, study): (&SharedRun, &[Row], &Path),
    (requests, store): (&Requests, Option<&Store>),
) -> Result<Vec<(usize, Outcome)>, Error> {
    let begun = Instant::now();
    let resolved = &rows[shared.runs()].resolved;
    let dir = row::folder(study, shared.runs());
    let folder = Claim::take(&dir)?.begin(&resolved.case.to_string())?;
    let told = |index: &usize| {
        let warnings = &rows[*index].resolved.warnings;
        warnings.iter().map(Problem::warning_of).collect()
    };
    let warnings: Vec<Vec<Warning>> = shared.rows.iter().map(told).collect();
    let mut passing = Passing {
        warnings: &warnings,
        results: StoppableOutput { folder, requests },
        outputs: vec![],
        places: vec![],
        history: vec![],
        course: Course::default(),
        passed: vec![],
    };
    let mut outputs = vec![];
    let ran = row::build(&resolved.case, store).map_err(|error| error.to_string()).and_then(
        |mut simulation| {
            let schedule = &simulation.schedule;
            passing.outputs.clone_from(&schedule.outputs);
            outputs.clone_from(&schedule.outputs);
            passing.places = shared.shares.iter().map(|share| share * schedule.extent).collect();
            simulation.schedule = schedule.through(&shared.shares);
            simulation.run(&mut [&mut passing]).map_err(|error| error.to_string())
        },
    );
    let extent = passing.places.last().copied().unwrap_or_default();
    let mut failure = ran.err();
    if failure.is_none() && passing.passed.len() < shared.rows.len() {
        failure = Some("the run did not pass the end of every row".to_owned());
    }
    let Passing { results, history, course, passed, .. } = passing;
    let all = |position: usize| results.folder.verdict(&warnings[position]);
    let all: Vec<Verdict> = (0..shared.rows.len()).map(all).collect();
    row::finish(results.folder, resolved, begun, failure.clone())?;
    let from = format!("../{:04}", shared.runs() + 1);
    let write = |(position, &index): (usize, &usize)| {
        let dir = row::folder(study, index);
        let known = passed.get(position);
        if requests.any() && index != shared.runs() {
            return Ok((index, Outcome::Interrupted));
        }
        let outcome = match (&failure, known) {
            (_, Some(_)) | (None, _) => Outcome::Done,
            (Some(_), None) if requests.any() => return Ok((index, Outcome::Interrupted)),
            (Some(why), None) => Outcome::Failed(why.clone()),
        };
        if index == shared.runs() || row::is_done(&dir, &rows[index].resolved) {
            return Ok((index, outcome));
        }
        let (steps, verdict) =
            known.map_or((history.len(), &all[position]), |(steps, known)| (*steps, known));
        let share = shared.shares[position];
        let kept = match steps.checked_sub(1) {
            Some(last) => {
                course.kept(last, outputs.iter().map(|place| share * place * (1.0 - SAME)))
            }
            None => vec![],
        };
        let mut told: Vec<_> = kept.iter().map(|&step| rescaled(&history[step], share)).collect();
        if let (Some(last), Some(_)) = (told.last_mut(), known) {
            // What rounding made of it.
            last[0].1 = extent;
        }
        let failure = failure.as_deref().filter(|_| known.is_none());
        let case_toml = rows[index].resolved.case.to_string();
        RowsOfRun { rows: &told, verdict, from: &from, failure }.write(&dir, &case_toml)?;
        Ok((index, outcome))
    };
    shared.rows.iter().enumerate().map(write).collect()
}

/// Follows the run: its results, and how far it was where each row ends.
struct Passing<'a> {
    results: StoppableOutput<'a>,
    /// What the user was warned of, by rows.
    warnings: &'a [Vec<Warning>],
    /// Where fields are put out (the motion's unit): at the outputs of the case.
    outputs: Vec<f64>,
    /// Where the rows end, rising.
    places: Vec<f64>,
    history: Vec<Vec<(String, f64)>>,
    course: Course,
    /// For each row that has ended the steps until then, and what can be believed of them.
    passed: Vec<(usize, Verdict)>,
}

impl Observer for Passing<'_> {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        let progress = report.state.progress;
        let reached = |place: &f64| *place <= progress * (1.0 + SAME);
        let due = self.outputs.iter().take_while(|place| reached(place)).count();
        self.outputs.drain(..due);
        let output = due > 0 || progress == 0.0;
        let row = history::row(report);
        self.course.push(progress, history::number(&row, WEAR_DEPTH).unwrap_or_default());
        self.history.push(row);
        self.results.observe(&Report { output, ..*report })?;
        let ended = self.places.iter().filter(|place| reached(place)).count();
        for row in self.passed.len()..ended {
            let verdict = self.results.folder.verdict(&self.warnings[row]);
            self.passed.push((self.history.len(), verdict));
        }
        Ok(())
    }
}
