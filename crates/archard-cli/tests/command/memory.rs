//! Limits of memory: a run fits, or is refused in a sentence; it is never ended by the system.

use std::process::{Command, Output};

use tempfile::TempDir;

use super::{case, text};

/// What the command does with an address space of that size (kB).
fn limited(dir: &TempDir, kilobytes: u64, arguments: &[&str]) -> Output {
    let limit = format!("ulimit -v {kilobytes}; exec \"$@\"");
    Command::new("sh")
        .args(["-c", &limit, "sh", env!("CARGO_BIN_EXE_archard")])
        .args(arguments)
        .current_dir(dir.path())
        .output()
        .unwrap()
}

/// A frame of 80 MB or so, at limits from far below what it takes to far above.
#[cfg(target_os = "linux")]
#[test]
fn a_run_fits_into_the_address_space_or_is_refused() {
    let dir = TempDir::new().unwrap();
    let case = case("hertz");
    let elements = "frame.elements=[384, 384]";
    let arguments = ["run", case.to_str().unwrap(), "--set", elements, "--threads", "2", "-q"];
    let codes = [120_000, 200_000, 300_000, 450_000, 1_000_000].map(|kilobytes| {
        let output = limited(&dir, kilobytes, &arguments);
        let said = text(&output.stderr);
        match output.status.code() {
            Some(0) => 0,
            Some(2) => {
                assert!(said.contains("of memory") && said.contains("are free"), "{said}");
                assert!(said.contains("`frame.elements`"), "{said}");
                2
            }
            other => panic!("{kilobytes} kB: {other:?}, {said}"),
        }
    });
    assert_eq!((codes[0], codes[4]), (2, 0), "{codes:?}");
}
