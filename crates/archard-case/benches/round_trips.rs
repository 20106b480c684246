//! Cost of whole runs in padded real FFT round trips: one forward and one backward transform of the
//! doubled grid, timed in the same run on the same number of threads, so that the numbers hold on
//! any machine.
//!
//! `cargo bench --bench round_trips` prints the tables of the book's page on performance.

#![allow(missing_docs, reason = "a program")]

#[path = "../tests/framed/mod.rs"]
mod framed;
mod round_trip;

use std::time::Instant;

use archard::simulation::Effort;
use archard_case::{Case, CaseFile};

use round_trip::RoundTrip;

fn main() {
    // `cargo bench --bench round_trips -- rolling` does that part alone.
    let asked = std::env::args().nth(1).unwrap_or_default();
    if asked != "rolling" {
        pressed();
    }
    rolled();
}

/// Normal contact and gross sliding.
fn pressed() {
    println!("Hertz, cold, residual 1e-8, kernels included, one thread\n");
    header("solver", "iterations");
    for n in [64, 128, 256, 512, 1024] {
        hertz(n, "conjugate_gradient");
        if n <= 128 {
            hertz(n, "uzawa");
        }
    }
    println!("\nPin on disc to 500 mm, residual 1e-8, kernels included, one thread\n");
    header("steps", "solves");
    for n in [64, 128, 256] {
        for steps in ["step = \"20 mm\"", "tolerance = 1e-3"] {
            let runs = if n > 128 { 2 } else { 5 };
            let cost = cost(n, runs, 1, &pin_on_disc(n, steps, 1));
            row(n, steps, cost.effort.solves, &cost);
        }
    }
    println!("\nThe same at a tolerance of 1e-3 in wider frames, elements as large\n");
    println!("| n | frame | solves | ms | times as long |");
    println!("|---|---|---|---|---|");
    let mut first = None;
    for wide in [1, 2, 4] {
        let Cost { seconds, effort, .. } =
            cost(120, 7, 1, &pin_on_disc(120, "tolerance = 1e-3", wide));
        let times = seconds / *first.get_or_insert(seconds);
        let n = 120 * wide;
        println!(
            "| {n} | {:.1} mm | {} | {:.1} | {times:.2} |",
            1.2 * wide as f64,
            effort.solves,
            1e3 * seconds
        );
    }
    println!("\nOne thread against two, Hertz\n");
    println!("| n | one thread ms | two threads ms | ratio | ratio of a round trip |");
    println!("|---|---|---|---|---|");
    for n in [256, 512, 1024] {
        let case = hertz_case(n, "conjugate_gradient");
        let [one, two] = [1, 2].map(|threads| cost(n, 9, threads, &case));
        println!(
            "| {n} | {:.1} | {:.1} | {:.2} | {:.2} |",
            1e3 * one.seconds,
            1e3 * two.seconds,
            one.seconds / two.seconds,
            one.round_trip / two.round_trip
        );
    }
}

/// Rolling contact.
fn rolled() {
    println!("\nTwin discs at 0.5 % creepage, residual 1e-6, kernels included, one thread\n");
    header("start", "iterations");
    for n in [21, 41, 81, 120, 161, 241] {
        rolling(n);
    }
    println!("\n30,000 revolutions of twin discs at 0.5 %, 41 by 81 elements, one thread\n");
    header("steps", "solves");
    for steps in ["tolerance = 0.003", "step = 100"] {
        let case = twin_discs("6.4 mm", [41, 81], &format!("revolutions = 30000\n{steps}"));
        // A square of as many elements.
        let n = 58;
        let cost = cost(n, 2, 1, &case);
        row(n, steps, cost.effort.solves, &cost);
    }
}

fn header(what: &str, count: &str) {
    println!("| n | {what} | {count} | applications | ms | round trip ms | round trips |");
    println!("|---|---|---|---|---|---|---|");
}

fn row(n: usize, what: &str, count: usize, cost: &Cost) {
    let Cost { seconds, round_trip, effort } = cost;
    println!(
        "| {n} | {what} | {count} | {} | {:.2} | {:.3} | {:.1} |",
        effort.applications,
        1e3 * seconds,
        1e3 * round_trip,
        seconds / round_trip
    );
}

fn hertz(n: usize, solver: &str) {
    let cost = cost(n, if solver == "uzawa" { 2 } else { 7 }, 1, &hertz_case(n, solver));
    row(n, solver, cost.effort.iterations, &cost);
}

/// The first contact, and the mean of ten steps of 50 revolutions after it.
fn rolling(n: usize) {
    let runs = if n > 200 { 3 } else { 7 };
    let [cold, long] = ["revolutions = 0", "revolutions = 500\nstep = 50"]
        .map(|motion| cost(n, runs, 1, &twin_discs("2 mm", [n, n], motion)));
    row(n, "cold", cold.effort.iterations, &cold);
    let steps = long.effort.steps;
    let warm = Cost {
        seconds: (long.seconds - cold.seconds) / steps as f64,
        round_trip: long.round_trip,
        effort: Effort {
            applications: (long.effort.applications - cold.effort.applications) / steps,
            ..long.effort
        },
    };
    row(n, "a step", warm.effort.iterations, &warm);
}

/// The twin discs of the paper's section 6.3 on a frame 0.52 mm long and of that width.
fn twin_discs(width: &str, elements: [usize; 2], motion: &str) -> Case {
    resolve(&format!(
        r#"
        [body.disc1]
        material = {{ young = "208 GPa", poisson = 0.3 }}
        profile.disc = {{ radius = "32.5 mm", crown = "125 mm" }}
        wear.archard = {{ coefficient = "1.333333e-6 1/MPa" }}
        [body.disc2]
        material = {{ young = "208 GPa", poisson = 0.3 }}
        profile.disc = {{ radius = "32.3 mm" }}
        wear.archard = {{ coefficient = "0.666667e-6 1/MPa" }}
        [frame]
        size = ["0.52 mm", "{width}"]
        elements = {elements:?}
        [friction.coulomb]
        coefficient = 0.6
        [solver.conjugate_gradient]
        tolerance = 1e-6
        [motion.rolling]
        load = "300 N"
        creepage = 0.005
        {motion}
        "#
    ))
}

/// What a run took.
struct Cost {
    seconds: f64,
    round_trip: f64,
    effort: Effort,
}

/// The shortest of several runs and the shortest round trip around them.
fn cost(n: usize, runs: usize, threads: usize, case: &Case) -> Cost {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
    pool.install(|| {
        let trip = RoundTrip::new(smooth(2 * n));
        let mut cost =
            Cost { seconds: f64::INFINITY, round_trip: trip.seconds(), effort: Effort::default() };
        for _ in 0..runs {
            let start = Instant::now();
            cost.effort =
                case.build().expect("a checked case").run(&mut []).expect("a run that converges");
            cost.seconds = cost.seconds.min(start.elapsed().as_secs_f64());
            cost.round_trip = cost.round_trip.min(trip.seconds());
        }
        cost
    })
}

/// The next even number without prime factors above 5, as any program would pad to.
fn smooth(n: usize) -> usize {
    let rest = |n: usize| {
        [2, 3, 5].into_iter().fold(n, |mut n, prime| {
            while n.is_multiple_of(prime) {
                n /= prime;
            }
            n
        })
    };
    (n..).find(|&n| n.is_multiple_of(2) && rest(n) == 1).unwrap_or(n)
}

/// A sphere pressed on a flat, on a frame 2.4 contact radii wide.
fn hertz_case(n: usize, solver: &str) -> Case {
    case(
        "hertz",
        &[format!("frame.elements=[{n},{n}]"), format!("solver.{solver}={{ tolerance = 1e-8 }}")],
    )
}

/// The pin in a frame so many times as wide as it is with n elements.
fn pin_on_disc(n: usize, steps: &str, wide: usize) -> Case {
    let (steps, n) = (steps.replace(' ', ""), n * wide);
    let size = format!("\"{} mm\"", 1.2 * wide as f64);
    let options = [
        "motion.sliding.step=".to_owned(),
        format!("motion.sliding.{steps}"),
        format!("frame.elements=[{n},{n}]"),
        format!("frame.size=[{size},{size}]"),
    ];
    case("pin_on_disc", &options)
}

/// A case by its text.
fn resolve(text: &str) -> Case {
    CaseFile::from_text("case", text, ".").resolve().expect("a case without mistakes").case
}

/// A case of the gallery with options.
fn case(name: &str, options: &[String]) -> Case {
    let path = framed::folder(name);
    let file = CaseFile::read(&path).expect("a case of the gallery");
    let file = options.iter().fold(file, CaseFile::set);
    file.resolve().expect("options that fit").case
}
