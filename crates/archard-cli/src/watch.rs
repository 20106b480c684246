//! `archard watch`: the page of a run while it goes on, written anew as the run advances.
//!
//! The page reloads by itself until the run is over: a `meta` element asks the browser to, which needs no script and no server.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::sleep;
use std::time::{Duration, Instant, SystemTime};

use anyhow::Result;

use crate::arguments::Report;
use crate::failure::{Failure, INTERRUPTED};
use crate::report;
use crate::say::{say, tell};

/// The least time between two looks at a folder.
const LEAST: Duration = Duration::from_secs(2);
/// The time between two pages over that it takes to make one: the run has the processor for the most part.
const REST: u32 = 5;
/// How soon a request to stop is seen.
const BLINK: Duration = Duration::from_millis(100);

/// A folder that is watched.
struct Watched {
    dir: PathBuf,
    /// Length and time of the history that the page was made of.
    seen: Option<(u64, SystemTime)>,
    /// The time to the next look.
    pause: Duration,
}

impl Watched {
    fn new(dir: &Path) -> Self {
        Self { dir: dir.to_owned(), seen: None, pause: LEAST }
    }

    /// Whether the run is over: its summary is written at its end, however it ended.
    fn is_over(&self) -> bool {
        self.dir.join("summary.json").is_file()
    }

    /// Writes the page where the history has changed, or for the last time; returns its file where it was written.
    ///
    /// # Errors
    /// If the folder has no results, or the page cannot be written. While the run goes on both may pass.
    fn look(&mut self, last: bool) -> Result<Option<PathBuf>> {
        let history = fs::metadata(self.dir.join("history.csv"));
        let now = history.ok().and_then(|known| Some((known.len(), known.modified().ok()?)));
        if now == self.seen && !last {
            return Ok(None);
        }
        let began = Instant::now();
        let reload = (!last).then_some(self.pause);
        let page =
            report::write(&Report { dirs: vec![self.dir.clone()], ..Report::default() }, reload)?;
        self.seen = now;
        self.pause = LEAST.max(REST * began.elapsed());
        Ok(Some(page))
    }
}

/// Keeps the page of a run up to date until the run is over or the user ends the watch.
///
/// # Errors
/// If there is nothing to show at the end, or the page cannot be written.
pub fn watch(dir: &Path) -> Result<(), Failure> {
    let asked = Arc::new(AtomicBool::new(false));
    let flag = asked.clone();
    // Without it the signals end the program at once, and the last page goes on reloading.
    let _ = ctrlc::set_handler(move || {
        if flag.swap(true, Ordering::Relaxed) {
            std::process::exit(INTERRUPTED.into());
        }
    });
    let mut watched = Watched::new(dir);
    let mut told = false;
    tell(&format!("watching {}; Ctrl-C ends it", dir.display()));
    loop {
        let last = asked.load(Ordering::Relaxed) || watched.is_over();
        match watched.look(last) {
            Ok(Some(page)) if !told => {
                say(&page.display().to_string())?;
                told = true;
            }
            Err(error) if last => return Err(Failure::because(&error)),
            Ok(_) | Err(_) => {}
        }
        if last {
            return Ok(());
        }
        let began = Instant::now();
        while began.elapsed() < watched.pause && !asked.load(Ordering::Relaxed) {
            sleep(BLINK);
        }
    }
}
