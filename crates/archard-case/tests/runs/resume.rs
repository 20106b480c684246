//! Runs that are kept at some state and go on from there, to the same bits.

use std::error::Error;

use archard::problem::ContactState;
use archard::simulation::{Observer, Report, ResumeError, Run, Simulation, row};
use archard_case::CaseFile;

/// Cases with settings, one of each way through the engine.
const CASES: [(&str, &[&str]); 17] = [
    ("pin_on_disc", &["frame.elements=[12, 12]", "motion.sliding.step=90 mm"]),
    (
        "pin_on_disc",
        &["frame.elements=[12, 12]", "motion.sliding.step=", "motion.sliding.tolerance=0.03"],
    ),
    (
        "pin_on_disc",
        &[
            "frame.elements=[12, 12]",
            "motion.sliding.step=25 mm",
            "motion.sliding.scheme=explicit",
            "motion.sliding.load=1 N",
        ],
    ),
    ("twin_disc", &["frame.elements=[12, 16]", "motion.rolling.tolerance=0.1"]),
    (
        "twin_disc",
        &[
            "frame.elements=[12, 16]",
            "frame.size=[\"0.8 mm\", \"4 mm\"]",
            "body.disc2.material.young=70 GPa",
            "motion.rolling.tolerance=",
            "motion.rolling.step=3000",
        ],
    ),
    ("kalker_creepage", &["frame.elements=[14, 14]"]),
    // Every cycle, of like bodies; fixed jumps; jumps by error.
    ("cattaneo_mindlin", &["frame.elements=[14, 14]", "motion.fretting.cycles=2"]),
    (
        "fretting_sphere",
        &[
            "frame.elements=[12, 12]",
            "motion.fretting.tolerance=",
            "motion.fretting.jump=4",
            "motion.fretting.cycles=10",
        ],
    ),
    (
        "fretting_sphere",
        &["frame.elements=[12, 12]", "motion.fretting.tolerance=0.1", "motion.fretting.cycles=60"],
    ),
    (
        "cattaneo_mindlin",
        &[
            "frame.elements=[12, 12]",
            "body.flat.material.poisson=0.1",
            "motion.fretting.increments=8",
        ],
    ),
    ("spence", &["frame.elements=[12, 12]", "motion.indentation.increments=6"]),
    // Meshed, with kept factors, cycles that come again.
    (
        "punch_fretting_block",
        &["body.block.mesh.box.contact.elements=[6, 6]", "motion.indentation.cycles=5"],
    ),
    ("pin_on_disc_track", &["frame.elements=[13, 13]", "motion.sliding.tolerance=0.1"]),
    // Surfaces that swing forward in one step and back in the next.
    (
        "mccoll_fretting",
        &[
            "frame.elements=50",
            "motion.fretting.cycles=300",
            "motion.fretting.tolerance=0.1",
            "output={}",
        ],
    ),
    // A stroke from end to end.
    (
        "reciprocating_ball",
        &[
            "frame.elements=[21, 21]",
            "motion.sliding.stroke=1 mm",
            "motion.sliding.ends=true",
            "motion.sliding.distance=10 m",
            "motion.sliding.tolerance=0.06",
        ],
    ),
    // Frames that become wider.
    (
        "pin_on_disc",
        &[
            "frame.size=[\"0.6 mm\", \"0.6 mm\"]",
            "frame.elements=[16, 16]",
            "frame.doubles=[\"20 mm\", \"200 mm\"]",
            "motion.sliding.step=",
            "motion.sliding.tolerance=0.03",
        ],
    ),
    // A law that depends on the temperature of the contact.
    (
        "warm_twin_disc",
        &["accuracy=", "frame.size=0.8 mm", "frame.elements=40", "motion.rolling.step=30"],
    ),
];

fn build((case, settings): (&str, &[&str])) -> Simulation {
    let folder = crate::framed::folder(case);
    let file = CaseFile::read(&folder).unwrap();
    let file = settings.iter().fold(file, |file, setting| file.set(*setting));
    let resolved = file.resolve().unwrap_or_else(|problems| {
        let lines: Vec<String> = problems.iter().map(|one| file.describe(one)).collect();
        panic!("{case}: {}", lines.join("\n"))
    });
    resolved.case.build().unwrap()
}

/// What a run shows: every number of its rows as bits, and the last fields.
#[derive(Default)]
struct Shown {
    rows: Vec<Vec<(String, u64)>>,
    last: Option<ContactState>,
    kept: Vec<Vec<u8>>,
    again: usize,
}

impl Observer for Shown {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn Error + Send + Sync>> {
        if report.again {
            self.again += 1;
            return Ok(());
        }
        let row = row(report).into_iter().map(|(column, value)| (column, value.to_bits()));
        self.rows.push(row.collect());
        self.last = Some(report.state.clone());
        self.kept.extend(report.checkpoint());
        Ok(())
    }
}

/// From every state of short runs, and from some of longer ones.
#[test]
#[ignore = "long: in .ci/long"]
fn kept_runs_go_on_to_the_same_bits() {
    for case in CASES {
        let mut whole = Shown::default();
        let effort = build(case).run(&mut [&mut whole]).unwrap();
        let states = whole.rows.len();
        assert!(states > 2 && whole.kept.len() == states, "{case:?}: {states} states");
        for at in (0..states).step_by(states.div_ceil(7)) {
            let mut rest = Shown::default();
            let ended = build(case).resume(&whole.kept[at], &mut [&mut rest]).unwrap();
            assert!(rest.rows == whole.rows[at + 1..], "{case:?} from state {at} of {states}");
            assert!(at + 1 == states || rest.last == whole.last, "{case:?} from {at}");
            assert_eq!((ended, rest.again), (effort, 1), "{case:?} from {at}");
        }
    }
}

/// A run that is stepped shows what one that is carried through shows.
#[test]
fn runs_can_be_stepped() {
    let case = CASES[8];
    let mut whole = Shown::default();
    build(case).run(&mut [&mut whole]).unwrap();
    let (mut run, mut stepped) = (Run::begin(build(case)).unwrap(), Shown::default());
    stepped.observe(&run.report()).unwrap();
    while run.step().unwrap() {
        stepped.observe(&run.report()).unwrap();
        if stepped.rows.len() == 30 {
            run = Run::resume(build(case), &run.checkpoint()).unwrap();
        }
    }
    assert!(stepped.rows.len() > 40 && stepped.rows == whole.rows);
}

/// A run goes on with its own case only.
#[test]
fn other_cases_do_not_go_on() {
    let (case, settings) = ("fretting_sphere", CASES[8].1);
    let kept = Run::begin(build((case, settings))).unwrap().checkpoint();
    for other in [
        "motion.fretting.load=51 N",
        "motion.fretting.tolerance=0.2",
        "motion.fretting.cycles=61",
        "frame.size=[\"0.61 mm\", \"0.6 mm\"]",
        "frame.elements=[12, 13]",
        "friction.coulomb.coefficient=0.61",
        "body.ball.material.young=211 GPa",
        "body.ball.profile.sphere.radius=10.1 mm",
        "solver.conjugate_gradient.tolerance=1e-7",
        "output.every=7",
    ] {
        let settings = [settings, &[other]].concat();
        let refused = Run::resume(build((case, &settings)), &kept).err();
        assert_eq!(refused, Some(ResumeError::OtherCase), "{other}");
    }
    let swings = CASES[13];
    let kept = Run::begin(build(swings)).unwrap().checkpoint();
    for other in ["body.flat.depth=7 mm", "motion.fretting.amplitude=[\"24 um\", \"0 um\"]"] {
        let settings = [swings.1, &[other]].concat();
        let refused = Run::resume(build((swings.0, &settings)), &kept).err();
        assert_eq!(refused, Some(ResumeError::OtherCase), "{other}");
    }
    let wider = CASES[15];
    let kept = Run::begin(build(wider)).unwrap().checkpoint();
    for other in ["frame.doubles=[\"20 mm\", \"210 mm\"]", "frame.doubles=[\"20 mm\"]"] {
        let settings = [wider.1, &[other]].concat();
        let refused = Run::resume(build((wider.0, &settings)), &kept).err();
        assert_eq!(refused, Some(ResumeError::OtherCase), "{other}");
    }
    let meshed = CASES[11];
    let kept = Run::begin(build(meshed)).unwrap().checkpoint();
    let stiffer = [meshed.1, &["body.block.material.young=211 GPa"]].concat();
    let refused = Run::resume(build((meshed.0, &stiffer)), &kept).err();
    assert_eq!(refused, Some(ResumeError::OtherCase));
}

/// Cut off anywhere or changed anywhere, what was kept is refused.
#[test]
fn damaged_runs_do_not_go_on() {
    let case = CASES[0];
    let kept = Run::begin(build(case)).unwrap().checkpoint();
    let refused = |bytes: &[u8]| Run::resume(build(case), bytes).err();
    assert_eq!(refused(&kept), None);
    for at in (0..kept.len()).step_by(kept.len() / 40) {
        assert_eq!(refused(&kept[..at]), Some(ResumeError::Unreadable), "cut at {at}");
        let mut changed = kept.clone();
        changed[at] ^= 4;
        assert_eq!(refused(&changed), Some(ResumeError::Unreadable), "changed at {at}");
    }
}
