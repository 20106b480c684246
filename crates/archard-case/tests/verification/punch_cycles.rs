//! A rigid punch pressed into a block again and again, the second case of the paper's section 6.1: every
//! cycle, and with jumps over most of them.

use std::sync::LazyLock;

use approx::assert_relative_eq;
use archard::simulation::{Effort, Simulation};

use crate::common::{case, depth, states};

/// The published case on so many elements along a side, with so many increments and cycles and what else its
/// motion says.
fn press([elements, increments, cycles]: [usize; 3], rest: &str, options: &[&str]) -> Simulation {
    let case_file = include_str!("../../../../cases/punch_fretting/case.toml");
    let elements = format!("frame.elements=[{elements}, {elements}]");
    let motion = format!(
        r#"motion={{indentation={{approach="0.07 mm", release="free", increments={increments}, cycles={cycles}{rest}}}}}"#
    );
    case(case_file, &[&[&*elements, &motion], options].concat())
}

/// Worn depth (m) and volume (m^3) at the outputs, and what the run took.
struct Run {
    worn: Vec<[f64; 2]>,
    effort: Effort,
}

fn run(simulation: &Simulation) -> Run {
    let frame = &simulation.problem.frame;
    let states = states(simulation).expect("it converges");
    let outputs = states.iter().filter(|(state, _, due)| *due && state.progress > 0.0);
    Run {
        worn: outputs.map(|(state, ..)| [depth(state), frame.integrate(&state.worn(1))]).collect(),
        effort: states.last().expect("a state").1,
    }
}

/// Every cycle of 20 increments computed, on 20 x 20 elements.
static EVERY_CYCLE: LazyLock<Run> = LazyLock::new(|| run(&press([20, 20, 500], "", &[])));

/// The largest relative difference of depths and of volumes at ten outputs.
fn off(run: &Run, every_cycle: &Run) -> [f64; 2] {
    assert_eq!((run.worn.len(), every_cycle.worn.len()), (10, 10));
    [0, 1].map(|of| {
        let pairs = run.worn.iter().zip(&every_cycle.worn);
        pairs.map(|(one, other)| (one[of] / other[of] - 1.0).abs()).fold(0.0, f64::max)
    })
}

/// Few applications of the compliance an increment, that of the step's end among them: 10 were measured, 25
/// are the aim and 40 the bound.
#[test]
#[ignore = "long: in .ci/long"]
fn ten_thousand_increments_take_few_applications() {
    let Effort { steps, applications, true_cycles, .. } = EVERY_CYCLE.effort;
    assert_eq!((steps, true_cycles), (10_000, 500));
    assert!(applications <= 25 * steps, "{applications} applications");
}

/// Jumps chosen by error on 30 x 30 elements, 100 of the 500 cycles: depth and volume meet those of every cycle at
/// every output. All cycles on the 40 x 40 elements of the case are in its `expected.toml`.
#[test]
#[ignore = "long: in .ci/long"]
fn jumps_meet_the_run_of_every_cycle() {
    let run = |rest: &str| run(&press([30, 20, 100], rest, &["output={every=10.0}"]));
    let jumps = run(", tolerance=0.01");
    let [depth, volume] = off(&jumps, &run(""));
    assert!(depth < 0.01 && volume < 0.01, "{depth:e} and {volume:e}");
    assert!(jumps.effort.true_cycles <= 40, "{} cycles", jumps.effort.true_cycles);
}

/// Over five tolerances the errors of depth and volume stay below the one asked for, and the larger of them ends
/// a tenth of what it was. From one tolerance to the next it may rise: eight pairs at the edge of the stick zone,
/// of the 230 that wear, stick or slip by the third digit of the depths.
#[test]
#[ignore = "long: in .ci/long"]
fn tolerances_are_honest() {
    let tolerances = [1e-1, 3e-2, 1e-2, 3e-3, 1e-3];
    let errors = tolerances.map(|tolerance| {
        let jumps = press([20, 20, 500], &format!(", tolerance={tolerance}"), &[]);
        let [depth, volume] = off(&run(&jumps), &EVERY_CYCLE);
        depth.max(volume)
    });
    assert!(errors.iter().zip(tolerances).all(|(error, asked)| *error < asked), "{errors:?}");
    assert!(errors[4] < 0.1 * errors[0] && errors[3] < 0.2 * errors[1], "{errors:?}");
}

/// The paper's iteration on the same increments to the same tolerance, 1e-6, takes many more applications.
#[test]
fn uzawa_takes_many_more_applications() {
    let applications = |options: &[&str]| {
        run(&press([20, 20, 1], "", &[&["output="], options].concat())).effort.applications as f64
    };
    let newton = applications(&[]);
    let uzawa = applications(&[
        "solver={uzawa={tolerance=1e-6}}",
        "friction_solver={uzawa={tolerance=1e-6}}",
    ]);
    assert!(uzawa > 15.0 * newton, "{uzawa} for {newton}");
}

/// 20 increments wear what 40 wear: they count only slip after pairs touched, at the mean of the pressures.
/// Measured: 1.2 % of the depth, which is that of a few pairs, and 0.7 % of the volume.
#[test]
#[ignore = "long: in .ci/long"]
fn increments_of_half_the_size_wear_the_same() {
    let [twenty, forty] =
        [20, 40].map(|increments| run(&press([40, increments, 20], "", &["output={every=10.0}"])));
    for (twenty, forty) in twenty.worn.iter().zip(&forty.worn) {
        assert_relative_eq!(twenty[0], forty[0], max_relative = 0.015);
        assert_relative_eq!(twenty[1], forty[1], max_relative = 0.01);
    }
}
