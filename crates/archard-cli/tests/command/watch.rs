//! A page that follows a run.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use tempfile::TempDir;

use super::{archard, case};

/// What asks the browser to read a page again.
const RELOADS: &str = "http-equiv=\"refresh\"";

/// What a page says of a run that is not over.
const GOES_ON: &str = "the run has not ended";

/// A folder as a run leaves it half-way: without its summary.
fn half_way(dir: &TempDir) -> Vec<u8> {
    let case = case("pin_on_disc");
    let small = ["--set", "frame.elements=[12, 12]", "--set", "motion.sliding.step=50 mm"];
    let arguments = [&["run", case.to_str().unwrap(), "-o", "out", "-q"][..], &small].concat();
    archard(dir, &arguments).success();
    let summary = dir.path().join("out/summary.json");
    let text = fs::read(&summary).unwrap();
    fs::remove_file(summary).unwrap();
    // Half-way there are no sums yet.
    fs::remove_file(dir.path().join("out/manifest.txt")).unwrap();
    text
}

fn watch(dir: &Path) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_archard"));
    command.current_dir(dir).args(["watch", "out"]).stdout(Stdio::null()).stderr(Stdio::null());
    command.spawn().unwrap()
}

/// The page, once it is as it should be.
fn page(dir: &Path, is_so: impl Fn(&str) -> bool) -> String {
    let began = Instant::now();
    loop {
        let page = fs::read_to_string(dir.join("out/report.html")).unwrap_or_default();
        if !page.is_empty() && is_so(&page) {
            return page;
        }
        assert!(began.elapsed() < Duration::from_secs(120), "no such page");
        std::thread::sleep(Duration::from_millis(50));
    }
}

/// A page without its pictures, whose parts are numbered through all that a process draws.
fn words(page: &str) -> String {
    let parts = page.split("base64,");
    parts.map(|part| part.split_once('"').map_or(part, |(_, rest)| rest)).collect()
}

#[test]
#[ignore = "long: in .ci/long"]
fn the_page_reloads_until_the_run_is_over() {
    let dir = TempDir::new().unwrap();
    let summary = half_way(&dir);
    let mut watch = watch(dir.path());
    let first = page(dir.path(), |_| true);
    assert!(first.contains(RELOADS) && first.contains(GOES_ON));
    // The run goes on by a row.
    let history = dir.path().join("out/history.csv");
    let rows = fs::read_to_string(&history).unwrap();
    let last = rows.lines().last().unwrap();
    fs::write(&history, format!("{rows}{last}\n")).unwrap();
    page(dir.path(), |page| page.contains(RELOADS) && page != first);
    fs::write(&history, rows).unwrap();
    // Whole at once, as a run writes it.
    fs::write(dir.path().join("summary"), summary).unwrap();
    fs::rename(dir.path().join("summary"), dir.path().join("out/summary.json")).unwrap();
    assert!(watch.wait().unwrap().success());
    let done = page(dir.path(), |_| true);
    assert!(!done.contains(RELOADS) && !done.contains(GOES_ON));
    archard(&dir, &["report", "out", "-o", "own.html"]).success();
    let own = fs::read_to_string(dir.path().join("own.html")).unwrap();
    assert!(words(&own) == words(&done), "the pages differ");
}

#[cfg(unix)]
#[test]
fn whoever_ends_the_watch_keeps_a_page_that_stays() {
    let dir = TempDir::new().unwrap();
    half_way(&dir);
    let mut watch = watch(dir.path());
    page(dir.path(), |page| page.contains(RELOADS));
    let stopped = Command::new("kill").args(["-INT", &watch.id().to_string()]).status().unwrap();
    assert!(stopped.success() && watch.wait().unwrap().success());
    assert!(!page(dir.path(), |_| true).contains(RELOADS));
}

#[test]
fn a_folder_without_a_run_is_an_error_at_the_end() {
    let dir = TempDir::new().unwrap();
    fs::create_dir(dir.path().join("out")).unwrap();
    fs::write(dir.path().join("out/summary.json"), "{}").unwrap();
    archard(&dir, &["watch", "out"]).code(2);
}
