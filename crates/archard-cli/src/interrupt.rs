//! SIGINT (Ctrl-C), SIGTERM and SIGHUP: a run ends with what was computed so far in its files.
//!
//! A request to stop takes effect where a step ends. A solve, or the assembly of a mesh, may be long: if no step ends
//! within a period of grace, another thread takes the results, writes their summary and ends the program. That needs
//! nothing of the solvers, because all other files are whole after every step. A second request ends the program at once.
//! Before the results begin there is nothing to save, so the first one does.

use std::error::Error as StdError;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use archard::simulation::{Observer, Report};
use archard_case::output::{Claim, Error, Life};

use crate::failure::{Failure, INTERRUPTED};
use crate::underway::Underway;

/// Time a step has to end in.
const GRACE: Duration = Duration::from_secs(2);
/// What comes within this time after a request is the same one: a terminal that closes sends several.
const SAME: Duration = Duration::from_millis(250);

/// The user has had enough.
#[derive(Debug, thiserror::Error)]
#[error("interrupted")]
pub struct Interruption;

/// Watches for requests to stop, and holds what they have to save.
#[derive(Clone)]
pub struct Watch(Arc<Shared>);

struct Shared {
    asked: AtomicBool,
    held: Mutex<Held>,
}

/// Requests to stop several runs at once, which each looks at where a step ends.
#[derive(Clone, Default)]
pub struct Requests(Arc<AtomicBool>);

impl Requests {
    /// Takes over what the signals do, as [`Watch::set`]; a second request ends the program at once, and so does the first
    /// where the work has not ended within the period of grace. All files are whole after every step.
    pub fn set() -> Self {
        let requests = Self::default();
        if !hangups_are_ignored() {
            let (asked, mut first) = (requests.0.clone(), None::<Instant>);
            let _ = ctrlc::set_handler(move || {
                let same = first.get_or_insert_with(Instant::now).elapsed() <= SAME;
                match asked.swap(true, Ordering::Relaxed) {
                    true if !same => std::process::exit(INTERRUPTED.into()),
                    true => {}
                    false => drop(std::thread::spawn(leave)),
                }
            });
        }
        requests
    }

    /// Whether there was one.
    pub fn any(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// Ends the program after the period of grace.
fn leave() {
    std::thread::sleep(GRACE);
    let failure = Failure::Interrupted(format!(
        "{Interruption}\nthe same command goes on with what is not done"
    ));
    failure.report();
    std::process::exit(failure.code().into());
}

/// How far a run is.
enum Held {
    /// It has no folder yet.
    Nothing,
    /// It has a folder that is still as it was.
    Claim(Box<Claim>),
    /// It writes results.
    Results(Box<Underway>),
    /// It ends by itself.
    Ended,
}

impl Watch {
    /// Takes over what the signals do. Where hangups are ignored (`nohup`) or it is refused, they do what they
    /// always do.
    pub fn set() -> Self {
        let shared = Arc::new(Shared { asked: false.into(), held: Mutex::new(Held::Nothing) });
        let watch = Self(shared);
        if !hangups_are_ignored() {
            let (watching, mut first) = (watch.clone(), None);
            let _ = ctrlc::set_handler(move || watching.asked_at(&mut first));
        }
        watch
    }

    /// Holds a folder until the results begin.
    pub fn hold(&self, claim: Claim) {
        *self.lock() = Held::Claim(Box::new(claim));
    }

    /// Does something with the folder that is held.
    pub fn within(&self, keep: impl FnOnce(&mut Claim) -> Result<(), Error>) -> Result<(), Error> {
        match &mut *self.lock() {
            Held::Claim(claim) => keep(claim),
            _ => Ok(()),
        }
    }

    /// Gives the folder back, for results that are written all at once.
    pub fn release(&self) -> Option<Claim> {
        match std::mem::replace(&mut *self.lock(), Held::Ended) {
            Held::Claim(claim) => Some(*claim),
            _ => None,
        }
    }

    /// Begins the results in the folder that is held.
    pub fn begin(&self, begin: impl FnOnce(Claim) -> Result<Underway, Error>) -> Result<(), Error> {
        let mut held = self.lock();
        if let Held::Claim(claim) = std::mem::replace(&mut *held, Held::Ended) {
            *held = Held::Results(Box::new(begin(*claim)?));
        }
        Ok(())
    }

    /// How long the part of the run lasts, so far.
    pub fn life(&self) -> Life {
        match &*self.lock() {
            Held::Results(results) => results.folder.life().clone(),
            _ => Life::default(),
        }
    }

    /// Gives the results back, to be finished.
    pub fn end(&self) -> Option<Underway> {
        match std::mem::replace(&mut *self.lock(), Held::Ended) {
            Held::Results(results) => Some(*results),
            _ => None,
        }
    }

    fn lock(&self) -> MutexGuard<'_, Held> {
        self.0.held.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Takes a request, on the thread of signals.
    fn asked_at(&self, first: &mut Option<Instant>) {
        match first {
            None => {
                *first = Some(Instant::now());
                self.0.asked.store(true, Ordering::Relaxed);
                let watch = self.clone();
                std::thread::spawn(move || watch.leave());
            }
            Some(first) if first.elapsed() > SAME => std::process::exit(INTERRUPTED.into()),
            Some(_) => {}
        }
    }

    /// Ends the program unless the run has come to an end by itself.
    fn leave(&self) {
        if matches!(*self.lock(), Held::Results(_)) {
            std::thread::sleep(GRACE);
        }
        // Held for good: nobody else ends the run from here on.
        let mut held = self.lock();
        let failure = match std::mem::replace(&mut *held, Held::Ended) {
            Held::Ended => return,
            Held::Nothing => before_results(),
            Held::Claim(claim) => {
                let (dir, kept) = (claim.dir().to_owned(), claim.is_on_a_route());
                claim.give_up();
                match kept {
                    true => on_a_route(&dir),
                    false => before_results(),
                }
            }
            Held::Results(results) => {
                let dir = results.dir().to_owned();
                match results.finish(Some(Interruption.to_string())) {
                    Ok(_) => with_results(&dir),
                    Err(error) => Failure::Interrupted(format!("{Interruption}, and {error}")),
                }
            }
        };
        failure.report();
        std::process::exit(failure.code().into());
    }
}

impl Observer for Watch {
    /// Hands the report to the results, and ends the run where that was asked for.
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        let asked = self.0.asked.load(Ordering::Relaxed);
        if let Held::Results(results) = &mut *self.lock() {
            results.folder.observe(report)?;
            if asked {
                results.folder.keep_now(report)?;
            }
        }
        if asked { Err(Interruption.into()) } else { Ok(()) }
    }

    fn ends(&self) -> bool {
        matches!(&*self.lock(), Held::Results(results) if results.folder.ends())
    }
}

/// An interruption that left results, and how to go on.
pub fn with_results(dir: &Path) -> Failure {
    let kept = dir.join("checkpoint").is_file();
    let dir = dir.display();
    if !kept {
        return Failure::Interrupted(format!(
            "{Interruption} before the first step had ended\nthe same command starts again"
        ));
    }
    Failure::Interrupted(format!(
        "{Interruption}\nwhat was computed so far is in {dir}; go on with `archard run --resume {dir}`, or draw it with \
         `archard plot {dir}`"
    ))
}

/// An interruption of a route that was kept on its way.
fn on_a_route(dir: &Path) -> Failure {
    let dir = dir.display();
    Failure::Interrupted(format!(
        "{Interruption}\nthe route is kept in {dir}; go on with `archard run --resume {dir}`"
    ))
}

/// An interruption before there were any.
fn before_results() -> Failure {
    Failure::Interrupted(format!(
        "{Interruption} before there were results\nnothing was written or replaced; the same command starts again"
    ))
}

/// Whether this process was started to live on when its terminal closes, as `nohup` does.
fn hangups_are_ignored() -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask & 1 != 0)
}
