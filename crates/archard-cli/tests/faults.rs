//! What a run leaves behind when something goes wrong: killed, interrupted, out of room, without its folder, without a
//! reader, or next to another run. Whatever happens, files are whole or not there, and the program says what was lost.
#![cfg(unix)]

#[path = "faults/folder.rs"]
mod folder;
#[path = "../../archard-case/tests/framed/mod.rs"]
mod framed;
#[path = "faults/kill.rs"]
mod kill;
#[path = "faults/signals.rs"]
mod signals;
#[path = "faults/streams.rs"]
mod streams;

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

use archard_case::output::{Collection, Image};
use framed::folder as case;
use serde_json::Value;

/// Longest wait for anything (s): machines may be busy.
const PATIENCE: u64 = 120;

/// A pin on a disc in 250,000 steps, each of a few milliseconds.
const MANY_STEPS: [&str; 2] = ["frame.elements=[16, 16]", "motion.sliding.step=0.002 mm"];
/// A pin on a disc whose first contact takes minutes, by the slow reference.
const LONG_STEP: [&str; 2] =
    ["frame.elements=[181, 181]", "solver.uzawa={tolerance=1e-15, max_iterations=1000000000}"];

/// The program with the default answers to signals, whatever they are where the tests run: a shell's background job, or
/// one under nohup, ignores some.
fn program() -> Command {
    let env = || {
        let mut env = Command::new("env");
        env.arg("--default-signal=HUP,INT,TERM");
        env
    };
    let program = assert_cmd::cargo::cargo_bin("archard");
    if env().arg("true").stderr(Stdio::null()).status().is_ok_and(|status| status.success()) {
        let mut command = env();
        command.arg(program);
        return command;
    }
    Command::new(program)
}

/// The run of a case in a folder, its results in `out`, with settings laid over it.
fn command(dir: &Path, name: &str, settings: &[&str]) -> Command {
    let mut command = program();
    command.current_dir(dir).env("ARCHARD_CACHE", dir.join("kept"));
    command.arg("run").arg(case(name)).args(["-o", "out", "--threads", "1"]);
    command.args(settings.iter().flat_map(|setting| ["--set", setting]));
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

/// A run that is under way; one that a failed test leaves behind is killed.
struct Run(Option<Child>);

impl Run {
    fn start(command: &mut Command) -> Self {
        Self(Some(command.spawn().unwrap()))
    }

    fn id(&self) -> u32 {
        self.0.as_ref().map_or(0, Child::id)
    }

    /// Sends it a signal.
    fn signal(&self, name: &str) {
        let kill = Command::new("kill").arg(format!("-{name}")).arg(self.id().to_string()).status();
        assert!(kill.unwrap().success());
    }

    /// Waits for its end.
    fn end(mut self) -> Output {
        self.0.take().expect("it ends once").wait_with_output().unwrap()
    }
}

impl Drop for Run {
    fn drop(&mut self) {
        if let Some(child) = &mut self.0 {
            let _ = child.kill();
            let _ = child.wait();
        }
    }
}

/// What a command that ended wrote on standard error.
fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Waits until something is so.
fn wait_until(what: &str, mut so: impl FnMut() -> bool) {
    let begun = Instant::now();
    while !so() {
        assert!(begun.elapsed() < Duration::from_secs(PATIENCE), "waited too long: {what}");
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// Number of lines of the history in a folder.
fn lines(dir: &Path) -> usize {
    fs::read_to_string(dir.join("out/history.csv")).map_or(0, |text| text.lines().count())
}

/// The summary in a folder.
fn summary(dir: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(dir.join("out/summary.json")).unwrap()).unwrap()
}

/// Checks that every file of a result folder is whole: rows of as many numbers as the header has columns, XML that ends
/// and can be read back, JSON. Returns the number of rows of the history.
fn assert_whole(dir: &Path) -> usize {
    let out = dir.join("out");
    let mut rows = 0;
    for name in ["history.csv", "profiles.csv", "worn_profiles.csv", "fretting_loop.csv"] {
        let Ok(text) = fs::read_to_string(out.join(name)) else { continue };
        assert!(text.is_empty() || text.ends_with('\n'), "{name} ends in {:?}", last(&text));
        let mut lines = text.lines();
        let columns = lines.next().map_or(0, |header| header.split(',').count());
        for (row, line) in lines.enumerate() {
            let cells: Vec<&str> = line.split(',').collect();
            assert_eq!(cells.len(), columns, "{name}, row {row}: {line}");
            let number =
                |cell: &str| cell.is_empty() || cell.parse::<f64>().is_ok_and(f64::is_finite);
            assert!(cells.iter().all(|cell| number(cell) || ["x", "y"].contains(cell)), "{line}");
            rows += usize::from(name == "history.csv");
        }
    }
    for name in ["summary.json", "case.toml"] {
        let Ok(text) = fs::read_to_string(out.join(name)) else { continue };
        let end = match name {
            "summary.json" => {
                serde_json::from_str::<Value>(&text).is_ok_and(|value| value.is_object())
            }
            _ => archard_case::CaseFile::read(&out).is_ok_and(|file| file.task().is_ok()),
        };
        assert!(end, "{name} is not whole:\n{text}");
    }
    let collection = out.join("fields.pvd");
    if collection.is_file() {
        for (_, listed) in Collection::read(&collection).unwrap().outputs {
            assert!(out.join(&listed).is_file(), "{listed} is listed and not there");
        }
    }
    for entry in fs::read_dir(out.join("fields")).into_iter().flatten().flatten() {
        let path = entry.path();
        match path.extension().and_then(|extension| extension.to_str()) {
            Some("vti" | "vtu") => drop(Image::of_output(&path).unwrap()),
            _ => assert!(path.extension().is_some_and(|end| end == "part"), "{}", path.display()),
        }
    }
    rows
}

/// The last letters of a text.
fn last(text: &str) -> &str {
    &text[text.len().saturating_sub(60)..]
}

/// No files that were begun and not finished.
fn assert_no_parts(dir: &Path) {
    for folder in ["out", "out/fields"] {
        for entry in fs::read_dir(dir.join(folder)).unwrap().flatten() {
            let name = entry.file_name().into_string().unwrap();
            assert!(!name.ends_with(".part"), "{folder}/{name} was left");
        }
    }
}
