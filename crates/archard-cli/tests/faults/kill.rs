//! Runs that are killed at any moment.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::time::Duration;

use super::{Run, assert_no_parts, assert_whole, command, program, said, wait_until};

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
#[ignore = "long: in .ci/long"]
fn killed_runs_leave_whole_files() {
    kill(2, 0x9e3779b97f4a7c15);
}

/// A hundred: `cargo test --test faults -- --ignored`.
#[test]
#[ignore = "takes some minutes"]
fn killed_a_hundred_times() {
    kill(20, 0x2545f4914f6cdd1d);
}

/// Runs that are kept often, one of each way through the engine.
const KEPT: [Busy; 5] = [
    Busy {
        case: "pin_on_disc",
        settings: &[
            "frame.elements=[24, 24]",
            "motion.sliding.step=",
            "motion.sliding.tolerance=2e-4",
            "output.every=20 mm",
        ],
        time: 900,
    },
    Busy {
        case: "twin_disc",
        settings: &["frame.elements=[16, 16]", "output.at=", "output.every=1000"],
        time: 1200,
    },
    Busy {
        case: "fretting_sphere",
        settings: &["frame.elements=[20, 20]", "motion.fretting.cycles=2000", "output.every=100"],
        time: 2000,
    },
    Busy {
        case: "cattaneo_mindlin",
        settings: &[
            "frame.elements=[16, 16]",
            "motion.fretting=",
            "motion.path={ file = \"path.csv\", increments = 10, cycles = 4 }",
            "output.every=1 s",
        ],
        time: 1500,
    },
    Busy {
        case: "punch_fretting_block",
        settings: &[
            "body.block.mesh.box.contact.elements=[8, 8]",
            "motion.indentation.cycles=60",
            "output.every=5",
        ],
        time: 2000,
    },
];

const PATH: &str = "time_s,load_N,shift_x_um\n0,0,0\n1,15,0\n2,15,0.3\n3,15,-0.3\n4,0,0\n";

/// The files of a result folder but the lock, the summary without the time it took, which its sum in the list knows too.
fn files(dir: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    let folders = [dir.join("out"), dir.join("out/fields")];
    for path in folders.iter().flat_map(|folder| fs::read_dir(folder).unwrap()) {
        let path = path.unwrap().path();
        if path.is_file() && !path.ends_with(".archard.lock") {
            found.insert(path.strip_prefix(dir).unwrap().to_owned(), fs::read(&path).unwrap());
        }
    }
    let mut summary = super::summary(dir);
    // How long it took, and how it was called.
    for own in ["seconds", "command"] {
        summary.as_object_mut().unwrap().remove(own);
    }
    found.insert("out/summary.json".into(), summary.to_string().into_bytes());
    if let Some(list) = found.get_mut(Path::new("out/manifest.txt")) {
        let text = String::from_utf8_lossy(list);
        let own = |line: &&str| line.starts_with("sum ") && line.ends_with(" summary.json");
        let lines = text.lines().filter(|line| !own(line));
        *list = lines.collect::<Vec<_>>().join("\n").into_bytes();
    }
    found
}

/// Kills every case at a random moment, goes on with it, kills it again, and so on: it ends in the same files.
fn kill_and_resume(times: u64, seed: u64) {
    let mut chance = Chance(seed);
    let mut resumed = 0;
    for busy in &KEPT {
        let dir = tempfile::tempdir().unwrap();
        fs::write(dir.path().join("path.csv"), PATH).unwrap();
        let table = dir.path().join("path.csv").display().to_string();
        let settings: Vec<_> =
            busy.settings.iter().map(|setting| setting.replace("path.csv", &table)).collect();
        let settings: Vec<&str> = settings.iter().map(String::as_str).collect();
        let start = || command(dir.path(), busy.case, &settings);
        let whole = start().output().unwrap();
        assert!(whole.status.success(), "{}: {}", busy.case, super::said(&whole));
        let expected = files(dir.path());
        assert!(!expected.contains_key(Path::new("out/checkpoint")));
        let mut killed = 0;
        let mut going = false;
        while killed < times {
            let run = Run::start(&mut if going { resume(dir.path()) } else { start() });
            std::thread::sleep(Duration::from_millis(chance.below(busy.time)));
            run.signal("KILL");
            run.end();
            killed += 1;
            // Killed before it was kept, or after its end, it begins anew.
            going = dir.path().join("out/checkpoint").exists();
            resumed += u64::from(going);
        }
        let mut last = if going { resume(dir.path()) } else { start() };
        let ended = last.output().unwrap();
        assert!(ended.status.success(), "{}: {}", busy.case, super::said(&ended));
        let found = files(dir.path());
        let names = |files: &BTreeMap<PathBuf, Vec<u8>>| files.keys().cloned().collect::<Vec<_>>();
        assert_eq!(names(&found), names(&expected), "{}", busy.case);
        for (name, content) in &expected {
            assert!(&found[name] == content, "{}: {} differs", busy.case, name.display());
        }
    }
    assert!(resumed > 0, "nothing was kept");
}

/// The command that goes on with the run in `out`.
fn resume(dir: &Path) -> std::process::Command {
    let mut command = super::program();
    command.current_dir(dir).env("ARCHARD_CACHE", dir.join("kept"));
    command.args(["run", "--resume", "out", "--threads", "1"]);
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

#[test]
#[ignore = "long: in .ci/long"]
fn killed_runs_go_on_to_the_same_files() {
    kill_and_resume(3, 0x9e3779b97f4a7c15);
}

/// A hundred: `cargo test --test faults -- --ignored`.
#[test]
#[ignore = "takes some minutes"]
fn killed_and_resumed_a_hundred_times() {
    kill_and_resume(20, 0x2545f4914f6cdd1d);
}

/// What does not go on says why, and leaves the folder as it was.
#[test]
fn what_cannot_go_on_is_refused_in_words() {
    let dir = tempfile::tempdir().unwrap();
    let refused = |words: &str| {
        let ended = resume(dir.path()).output().unwrap();
        let said = super::said(&ended);
        assert!(ended.status.code() == Some(2) && said.contains(words), "{words}: {said}");
    };
    refused("cannot read");
    let small = ["frame.elements=[12, 12]", "motion.sliding.step=50 mm"];
    assert!(command(dir.path(), "pin_on_disc", &small).status().unwrap().success());
    refused("the run came to its end");
    let mut long = command(dir.path(), "pin_on_disc", &super::MANY_STEPS);
    let run = Run::start(long.arg("--force"));
    let out = dir.path().join("out");
    super::wait_until("a checkpoint", || out.join("checkpoint").exists());
    run.signal("KILL");
    run.end();
    let kept = fs::read(out.join("checkpoint")).unwrap();
    let history = fs::read(out.join("history.csv")).unwrap();
    let put = |bytes: &[u8]| fs::write(out.join("checkpoint"), bytes).unwrap();
    for cut in [0, 5, 40, kept.len() / 2, kept.len() - 1] {
        put(&kept[..cut]);
        refused("start the run anew");
    }
    let mut changed = kept.clone();
    changed[kept.len() / 3] ^= 1;
    put(&changed);
    refused("damaged");
    put(&[b"archard 9.9.9", &kept[13..]].concat());
    refused("another version");
    put(&kept);
    let case = fs::read_to_string(out.join("case.toml")).unwrap();
    fs::write(out.join("case.toml"), case.replace("10.2 N", "10.3 N")).unwrap();
    assert!(fs::read_to_string(out.join("case.toml")).unwrap() != case);
    refused("another case");
    fs::write(out.join("case.toml"), case).unwrap();
    fs::write(out.join("history.csv"), &history[..9]).unwrap();
    refused("shorter than it was");
    assert!(out.join("checkpoint").exists());
}

#[test]
fn the_next_run_clears_up_after_a_killed_one() {
    let dir = tempfile::tempdir().unwrap();
    let small = ["frame.elements=[12, 12]", "motion.sliding.step=50 mm"];
    let run = || command(dir.path(), "pin_on_disc", &small).output().unwrap();
    assert!(run().status.success());
    for part in ["out/summary.json.999999.0.part", "out/fields/0001.vti.999999.1.part"] {
        std::fs::write(dir.path().join(part), "half").unwrap();
    }
    let ran = run();
    assert!(ran.status.success(), "{}", super::said(&ran));
    assert_no_parts(dir.path());
    assert!(assert_whole(dir.path()) > 5);
}

/// A route that is killed ten times and gone on with leaves the files of one that was let be, to the byte.
#[test]
#[ignore = "long: in .ci/long"]
fn a_route_that_is_killed_goes_on() {
    let settings = [
        "frame.elements=16",
        "motion.wheel_rail.distance=5000 km",
        "body.wheel.cracks.t_gamma={}",
        "reprofiling.last_radius=430 mm",
    ];
    let [whole, killed] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    let ended = Run::start(&mut command(whole.path(), "wheel_wear", &settings)).end();
    assert!(whole.path().join("out/summary.json").exists(), "{}", said(&ended));
    let checkpoint = killed.path().join("out/checkpoint");
    let mut last = vec![];
    for time in 0..10 {
        let mut resume = program();
        let mut first = command(killed.path(), "wheel_wear", &settings);
        let run = Run::start(match time {
            0 => &mut first,
            _ => resume.current_dir(killed.path()).args(["run", "-q", "--resume", "out"]),
        });
        wait_until("another step", || fs::read(&checkpoint).is_ok_and(|kept| kept != last));
        run.signal("KILL");
        run.end();
        last = fs::read(&checkpoint).unwrap();
    }
    // Of another case there is no route to go on with.
    let case = killed.path().join("out/case.toml");
    let own = fs::read_to_string(&case).unwrap();
    fs::write(
        &case,
        own.replace("friction.coulomb.coefficient = 0.3", "friction.coulomb.coefficient = 0.2"),
    )
    .unwrap();
    let mut resume = program();
    resume.current_dir(killed.path()).args(["run", "-q", "--resume", "out"]);
    resume.stderr(Stdio::piped());
    let ended = Run::start(&mut resume).end();
    assert!(said(&ended).contains("have changed"), "{}", said(&ended));
    fs::write(&case, own).unwrap();
    let ended = Run::start(&mut resume).end();
    for name in ["contacts.csv", "wear.csv", "dimensions.csv", "worn_wheel_right.prw", "case.toml"]
    {
        let [one, other] = [&whole, &killed].map(|dir| fs::read(dir.path().join("out").join(name)));
        assert!(one.unwrap() == other.unwrap(), "{name} differs: {}", said(&ended));
    }
    assert!(!checkpoint.exists());
    // What came to its end has nothing to go on with.
    let mut again = program();
    again.current_dir(killed.path()).args(["run", "-q", "--resume", "out"]);
    again.stderr(Stdio::piped());
    let ended = Run::start(&mut again).end();
    assert!(said(&ended).contains("came to its end"), "{}", said(&ended));
}
