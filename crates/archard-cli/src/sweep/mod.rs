//! `archard sweep`: a study, a case over many values.
//!
//! The design comes first, checked row by row and written to `design.csv`. Then rows run, each in a result folder of its
//! own: what is done is done, whoever did it, so that a study goes on where it was killed, and tasks share it by their
//! numbers. Last, `sweep.csv` is made of the folders.

mod course;
mod damage;
mod design;
mod drawn;
mod life;
pub mod points;
mod regime;
mod row;
mod shared;
mod table;
mod values;
mod words;

use std::fs;
use std::io::ErrorKind;
use std::num::NonZero;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use archard_case::files::{self, Inputs};
use archard_case::output::{Error, Manifest, Store};
use rayon::ThreadPoolBuilder;

use crate::arguments::Sweep;
use crate::diagnose;
use crate::failure::Failure;
use crate::interrupt::Requests;
use crate::say::{say, tell};
use design::Design;
use row::Outcome;
use shared::SharedRun;
use table::{RowState, Status};

/// Runs a study, or goes on with it.
pub fn sweep(arguments: &Sweep) -> Result<(), Failure> {
    let requests = Requests::set();
    let arguments = &drawn::with(arguments)?;
    let design = design::design(arguments)?;
    let study = &arguments.output;
    let case = diagnose::read(&arguments.case())?.inputs();
    let inputs = case.paths().map(Path::to_owned).chain(arguments.from.clone());
    begin(study, &design, Inputs::of(inputs))?;
    let other = design.rows.iter().enumerate().find_map(|(index, row)| {
        let dir = row::folder(study, index);
        row::holds_another(&dir, &row.resolved).then_some(dir)
    });
    if let Some(dir) = other {
        let message = format!("`{}` holds another case; {ELSEWHERE}", dir.display());
        return Err(Failure::wrong(message));
    }
    let all: Vec<usize> = (0..design.rows.len()).collect();
    let groups = shared::group(&design.rows, &all, arguments.separate);
    let told: usize = groups.iter().map(|group| group.rows.len() - 1).sum();
    if told > 0 && !arguments.quiet {
        let rows = design.rows.len();
        tell(&format!(
            "Only k s counts: {told} of {rows} rows are states of the runs of others, which have a larger wear \
             coefficient and are alike in all else (--separate runs each by itself)."
        ));
    }
    let mine =
        |(index, _): &(usize, &SharedRun)| arguments.task.is_none_or(|task| task.holds(*index));
    let groups = groups.iter().enumerate().filter(mine).map(|(_, group)| group);
    let own: Vec<usize> = groups.flat_map(|group| group.rows.clone()).collect();
    let groups = shared::group(&design.rows, &own, arguments.separate);
    run_all(arguments, &design, &groups, &requests)?;
    let known =
        table::collect(study, &design).map_err(|error| Failure::wrong(error.to_string()))?;
    if !requests.any() && !arguments.quiet {
        words::medians(&design, &known).iter().try_for_each(|line| say(line))?;
    }
    let standing: Vec<Status> = known.iter().map(RowState::status).collect();
    let own = own.iter().map(|&row| standing[row]).collect();
    conclude(arguments, [own, standing], &requests)
}

/// What to do about a folder of another study.
const ELSEWHERE: &str = "choose another folder with -o, or remove this one";

/// Makes the folder, or sees that it is of the same study.
fn begin(study: &Path, design: &Design, inputs: Inputs) -> Result<(), Failure> {
    let wrong = |error: Error| Failure::wrong(error.to_string());
    Manifest::spare_below(study, &inputs).map_err(wrong)?;
    // One of several tasks at a time.
    let _claim = table::wait_for(study).map_err(wrong)?;
    let mut manifest = Manifest::read(study).map_err(wrong)?.sparing(inputs);
    let (path, text) = (study.join(DESIGN), design.csv());
    match files::read_text(&path) {
        Ok(known) if known != text => {
            let differ = known.lines().zip(text.lines()).position(|(one, other)| one != other);
            let line = differ.unwrap_or(known.lines().count().min(text.lines().count())) + 1;
            return Err(Failure::wrong(format!(
                "`{}` is of another study, from line {line} on; {ELSEWHERE}",
                path.display()
            )));
        }
        // Earlier versions left no list; that the design is the same shows whose it is.
        Ok(_) => manifest.adopt(FILES.map(str::to_owned)),
        Err(error) if error.kind() != ErrorKind::NotFound => {
            let message = format!("cannot read `{}`: {error}; {ELSEWHERE}", path.display());
            return Err(Failure::wrong(message));
        }
        Err(_) => {
            FILES.iter().try_for_each(|name| manifest.admit(name).map(|_| ())).map_err(wrong)?;
            let begun = fs::create_dir_all(study.join("rows")).map_err(|error| error.to_string());
            let mut write = |name: &str, text: &str| {
                manifest.write(name, text.as_bytes()).map_err(|error| error.to_string())
            };
            // The design last: where it is, all of it is.
            begun
                .and_then(|()| write(STUDY, &design.json()))
                .and_then(|_| write(DESIGN, &text))
                .map_err(|error| Failure::wrong(format!("cannot begin a study: {error}")))?;
        }
    }
    manifest.claim(table::SWEEP).map_err(wrong)?;
    Ok(())
}

/// The files of the design.
const DESIGN: &str = "design.csv";
const STUDY: &str = "study.json";
/// All files of a study besides those of its rows.
const FILES: [&str; 3] = [DESIGN, STUDY, table::SWEEP];

/// Runs groups of rows, some at once.
fn run_all(
    arguments: &Sweep,
    design: &Design,
    groups: &[SharedRun],
    requests: &Requests,
) -> Result<(), Failure> {
    let processors = std::thread::available_parallelism().map_or(1, NonZero::get);
    let threads = arguments.threads.get();
    let jobs = arguments.jobs.map_or((processors / threads).max(1), NonZero::get);
    let store = arguments.cache.clone().map(Store::new).or_else(Store::of_user);
    let all: usize = groups.iter().map(|group| group.rows.len()).sum();
    let (next, told) = (AtomicUsize::new(0), Mutex::new(0));
    let work = || {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build();
        let pool = pool.map_err(|error| format!("cannot start {threads} threads: {error}"))?;
        while let Some(group) = groups.get(next.fetch_add(1, Ordering::Relaxed)) {
            if requests.any() {
                break;
            }
            let with = (requests, store.as_ref());
            let study = &arguments.output;
            let came = pool.install(|| match group.rows[..] {
                [index] => {
                    let dir = row::folder(study, index);
                    vec![(index, row::run(&design.rows[index].resolved, &dir, with))]
                }
                _ => shared::run((group, &design.rows, study), with),
            });
            if let (Ok(mut told), false) = (told.lock(), arguments.quiet) {
                for (index, outcome) in &came {
                    *told += 1;
                    tell(&format!(
                        "{told} of {all} rows: {}",
                        line(design, study, *index, outcome)
                    ));
                }
            }
        }
        Ok::<(), String>(())
    };
    let worked: Vec<_> = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..jobs.min(groups.len())).map(|_| scope.spawn(work)).collect();
        workers.into_iter().map(|worker| worker.join()).collect()
    });
    for worker in worked {
        worker.unwrap_or_else(|panic| std::panic::resume_unwind(panic)).map_err(Failure::wrong)?;
    }
    Ok(())
}

/// What varied in a row and what came of it, in words.
fn line(design: &Design, study: &Path, index: usize, outcome: &Outcome) -> String {
    let known = table::of(&row::folder(study, index), &design.rows[index].resolved);
    let row = words::row(design, index, &known);
    match outcome {
        Outcome::Done => row,
        Outcome::Failed(why) => {
            format!("{row}, which failed: {}", why.lines().next().unwrap_or_default())
        }
        Outcome::Interrupted => format!("{row}, which was interrupted"),
        Outcome::Elsewhere => format!("{row}, which another process runs"),
    }
}

/// Says what came of the study; fails where one of its own rows did, or did not run. All rows are told next to them.
fn conclude(
    arguments: &Sweep,
    [own, all]: [Vec<Status>; 2],
    requests: &Requests,
) -> Result<(), Failure> {
    let study = arguments.output.display();
    let count = |rows: &[Status], one| rows.iter().filter(|status| **status == one).count();
    let [done, wrong, failed, open] =
        [Status::Done, Status::Wrong, Status::Failed, Status::Open].map(|one| count(&all, one));
    if requests.any() {
        return Err(Failure::Interrupted(format!(
            "interrupted, rows done: {done}\nthe same command goes on with the others"
        )));
    }
    if !arguments.quiet {
        say(&format!(
            "rows              {done} done, {wrong} wrong, {failed} failed, {open} open"
        ))?;
        say(&format!("results           {study}/sweep.csv"))?;
        if open == 0 && done > 1 {
            say(&format!("pictures          archard plot {study}"))?;
        }
    }
    let (fell, elsewhere) =
        (count(&own, Status::Wrong) + count(&own, Status::Failed), count(&own, Status::Open));
    if fell > 0 {
        return Err(Failure::NotConverged(format!(
            "rows that failed or are wrong: {fell}; `status`, `verdict` and `error` in {study}/sweep.csv say why"
        )));
    }
    if elsewhere > 0 {
        return Err(Failure::wrong(format!(
            "rows that another process runs: {elsewhere}; call again when it has ended"
        )));
    }
    Ok(())
}
