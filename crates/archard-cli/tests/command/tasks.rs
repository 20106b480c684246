//! The tasks of the book, run as they stand there.

use std::fs;
use std::path::Path;
use std::process::Command;

use tempfile::TempDir;

/// Commands a task may take.
const MOST: usize = 3;

#[test]
fn the_tasks_of_the_book_can_be_done() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src/tasks.md");
    let page = fs::read_to_string(page).unwrap();
    let dir = TempDir::new().unwrap();
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
            Some(("csv", name)) => fs::write(dir.path().join(name), content).unwrap(),
            None if kind == "sh" => {
                tasks += 1;
                assert!(content.lines().count() <= MOST, "{content}");
                printed.clear();
                for line in content.lines() {
                    assert!(line.starts_with("archard "), "{line}");
                    let mut shell = Command::new("sh");
                    shell.args(["-c", line]).current_dir(dir.path()).env("PATH", &path);
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
    assert!(tasks >= 10, "{tasks} tasks");
    for file in ["disc.html", "fit/fit.png", "fit/fit.json", "next/sweep.csv", "loads/sweep.csv"] {
        assert!(dir.path().join(file).is_file(), "{file}");
    }
}
