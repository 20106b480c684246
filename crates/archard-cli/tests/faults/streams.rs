//! Standard output and standard error that are closed or full.

use std::fs::File;
use std::process::Command;

use super::{assert_whole, command, said, summary};

const SMALL: [&str; 2] = ["frame.elements=[12, 12]", "motion.sliding.step=5 mm"];

#[test]
fn a_run_survives_a_reader_that_has_seen_enough() {
    for redirection in ["2>&1 | head -n 1", "2>&1 | true", ">&- 2>&-", "2>/dev/full"] {
        let dir = tempfile::tempdir().unwrap();
        let run = command(dir.path(), "pin_on_disc", &SMALL);
        let words = run.get_args().map(|word| format!("'{}'", word.display()));
        let line = words.collect::<Vec<_>>().join(" ");
        let program = run.get_program().display();
        let line = format!("set -o pipefail; '{program}' {line} {redirection}");
        if redirection.contains("full") && !std::path::Path::new("/dev/full").exists() {
            continue;
        }
        let ran = Command::new("bash").args(["-c", &line]).current_dir(dir.path()).output();
        let ran = ran.unwrap();
        assert_eq!(ran.status.code(), Some(0), "{redirection}: {}", said(&ran));
        assert_eq!(summary(dir.path())["complete"], true, "{redirection}");
        assert!(assert_whole(dir.path()) > 100, "{redirection}");
    }
}

/// A case that is wrong is refused with the same code, whoever listens.
#[cfg(target_os = "linux")]
#[test]
fn a_full_standard_error_does_not_change_the_exit_code() {
    let dir = tempfile::tempdir().unwrap();
    let mut run = command(dir.path(), "pin_on_disc", &["frame.elements=[0, 0]"]);
    let ran = run.stderr(File::create("/dev/full").unwrap()).output().unwrap();
    assert_eq!(ran.status.code(), Some(2));
}
