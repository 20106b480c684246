//! The tasks of the book, run as they stand there.

use std::fs;
use std::path::Path;
use std::process::Command;

use tempfile::TempDir;

/// Commands a task may take.
const MOST: usize = 3;

#[test]
#[ignore = "long: in .ci/long"]
fn the_tasks_of_the_book_can_be_done() {
    let dir = TempDir::new().unwrap();
    let tasks = run_page("tasks.md", dir.path());
    assert!(tasks >= 10, "{tasks} tasks");
    for file in ["disc.html", "fit/fit.png", "fit/fit.json", "next/sweep.csv", "loads/sweep.csv"] {
        assert!(dir.path().join(file).is_file(), "{file}");
    }
}

/// From logs as an instrument wrote them to the life of a part.
#[test]
fn a_log_leads_to_a_life() {
    let dir = TempDir::new().unwrap();
    let logs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/te67");
    let there = dir.path().join("examples/te67");
    fs::create_dir_all(&there).unwrap();
    for file in fs::read_dir(logs).unwrap() {
        let file = file.unwrap();
        fs::copy(file.path(), there.join(file.file_name())).unwrap();
    }
    assert_eq!(run_page("log_to_life.md", dir.path()), 1);
    for file in ["logs.png", "fit/fit.png", "life/summary.json"] {
        assert!(dir.path().join(file).is_file(), "{file}");
    }
}

/// From a log and scans of three tests to a coefficient, and to the depth of the next one.
#[test]
#[ignore = "long: in .ci/long"]
fn the_first_lesson_leads_to_a_number() {
    let dir = TempDir::new().unwrap();
    assert_eq!(run_page("tutorial.md", dir.path()), 3);
    for file in ["row_A.csv", "fit/fit.json", "next/summary.json", "band/sweep.csv"] {
        assert!(dir.path().join(file).is_file(), "{file}");
    }
}

/// Runs the commands of a page of the book in a folder, and looks for what it says they print; the number of blocks of commands.
fn run_page(name: &str, dir: &Path) -> usize {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src").join(name);
    let page = fs::read_to_string(page).unwrap();
    let program = Path::new(env!("CARGO_BIN_EXE_archard")).parent().unwrap();
    let path = std::env::var("PATH").unwrap_or_default();
    let path = format!("{}:{path}", program.display());
    let (mut tasks, mut printed) = (0, String::new());
    // Every other part lies between the marks of a block.
    for (index, block) in page.split("```").enumerate() {
        if index % 2 == 0 {
            continue;
        }
        let (kind, content) = block.split_once('\n').unwrap();
        match kind.split_once(' ') {
            Some(("csv" | "toml", name)) => fs::write(dir.join(name), content).unwrap(),
            None if kind == "sh" => {
                tasks += 1;
                assert!(content.lines().count() <= MOST, "{content}");
                printed.clear();
                for line in content.lines() {
                    assert!(line.starts_with("archard "), "{line}");
                    let mut shell = Command::new("sh");
                    shell.args(["-c", line]).current_dir(dir).env("PATH", &path);
                    let done = shell.output().unwrap();
                    let said = String::from_utf8_lossy(&done.stderr);
                    assert!(done.status.success(), "{line}\n{said}");
                    printed += &String::from_utf8_lossy(&done.stdout);
                }
            }
            None if kind == "text" => {
                for line in content.lines() {
                    assert!(printed.contains(line), "`{line}` is not in\n{printed}");
                }
            }
            // `python/tests/test_book.py` runs these.
            None if kind == "python" => {}
            _ => panic!("a block of {kind}"),
        }
    }
    tasks
}
