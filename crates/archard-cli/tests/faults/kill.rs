//! Runs that are killed at any moment.

use std::time::Duration;

use super::{Run, assert_no_parts, assert_whole, command};

/// A case and settings that make it write a lot in little time.
struct Busy {
    case: &'static str,
    settings: &'static [&'static str],
    /// Time in which it writes (ms).
    time: u64,
}

const BUSY: [Busy; 5] = [
    Busy {
        case: "pin_on_disc",
        settings: &["frame.elements=[16, 16]", "motion.sliding.step=1 mm", "output.every=2 mm"],
        time: 600,
    },
    Busy {
        case: "twin_disc",
        settings: &["frame.elements=[16, 16]", "output.every=100"],
        time: 1500,
    },
    Busy {
        case: "cattaneo_mindlin",
        settings: &["frame.elements=[16, 16]", "motion.fretting.cycles=20", "output.every=1"],
        time: 1500,
    },
    Busy {
        case: "punch_indentation_block",
        settings: &[
            "body.block.mesh.box.contact.elements=[4, 4]",
            "motion.indentation.increments=100",
        ],
        time: 1500,
    },
    Busy { case: "patch_test", settings: &[], time: 400 },
];

/// Numbers that look like chance and are the same in every test: Marsaglia's xorshift of 64 bits.
struct Chance(u64);

impl Chance {
    fn below(&mut self, bound: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 % bound
    }
}

/// Kills every case so many times, then runs the first to its end over what is left.
fn kill(times: u64, seed: u64) {
    let mut chance = Chance(seed);
    let mut rows = 0;
    for busy in &BUSY {
        let dir = tempfile::tempdir().unwrap();
        for _ in 0..times {
            let run = Run::start(&mut command(dir.path(), busy.case, busy.settings));
            std::thread::sleep(Duration::from_millis(chance.below(busy.time)));
            run.signal("KILL");
            run.end();
            if dir.path().join("out").exists() {
                rows += assert_whole(dir.path());
            }
        }
    }
    assert!(rows > 0, "every run was killed before its first row");
}

#[test]
fn killed_runs_leave_whole_files() {
    kill(2, 0x9e3779b97f4a7c15);
}

/// A hundred: `cargo test --test faults -- --ignored`.
#[test]
#[ignore = "takes some minutes"]
fn killed_a_hundred_times() {
    kill(20, 0x2545f4914f6cdd1d);
}

#[test]
fn the_next_run_clears_up_after_a_killed_one() {
    let dir = tempfile::tempdir().unwrap();
    let small = ["frame.elements=[12, 12]", "motion.sliding.step=50 mm"];
    let fields = dir.path().join("out/fields");
    std::fs::create_dir_all(&fields).unwrap();
    for part in ["out/summary.json.999999.0.part", "out/fields/0001.vti.999999.1.part"] {
        std::fs::write(dir.path().join(part), "half").unwrap();
    }
    let ran = command(dir.path(), "pin_on_disc", &small).output().unwrap();
    assert!(ran.status.success(), "{}", super::said(&ran));
    assert_no_parts(dir.path());
    assert!(assert_whole(dir.path()) > 5);
}
