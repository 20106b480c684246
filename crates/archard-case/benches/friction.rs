//! The solvers of friction against each other: a cycle of fretting in 20 increments, by applications of
//! the compliance and by time, one thread.
//!
//! `cargo bench --bench friction` prints the table of the book's page on performance.

#![allow(missing_docs, reason = "a program")]

use std::path::Path;
use std::time::Instant;

use archard::simulation::Effort;
use archard_case::CaseFile;

/// Names of the solvers of pressures and of friction, and the most elements along a side for which anyone
/// would wait.
const SOLVERS: [(&str, &str, usize); 2] =
    [("conjugate_gradient", "newton", 240), ("uzawa", "uzawa", 64)];

fn main() {
    println!("| bodies | n | friction solver | solves | applications a solve | ms a solve |");
    println!("|---|---|---|---|---|---|");
    for (bodies, ball) in [("alike", ELASTIC), ("unlike", "rigid = true")] {
        for n in [32, 64, 128, 240] {
            for (normal, friction, most) in SOLVERS {
                if n <= most {
                    run(bodies, ball, n, [normal, friction]);
                }
            }
        }
    }
}

const ELASTIC: &str = "material = { young = \"210 GPa\", poisson = 0.3 }";

/// A cycle of a ball on a flat, to nearly gross slip.
fn run(bodies: &str, ball: &str, n: usize, [normal, friction]: [&str; 2]) {
    let text = format!(
        "body.ball = {{ {ball}, profile.sphere.radius = \"50 mm\" }}
         body.flat = {{ {ELASTIC}, profile.flat = {{}} }}
         frame = {{ size = [\"0.36 mm\", \"0.36 mm\"], elements = [{n}, {n}] }}
         friction.coulomb.coefficient = 0.3
         solver.{normal} = {{ tolerance = 1e-6, max_iterations = 1000000 }}
         friction_solver.{friction}.tolerance = 1e-6
         motion.fretting = {{ load = \"10.2 N\", amplitude = [\"0.08 um\", \"0 um\"], increments = 20 }}"
    );
    let case = CaseFile::from_text("friction", text, Path::new(".")).resolve();
    let case = case.unwrap_or_else(|problems| panic!("{problems:?}")).case;
    let pool =
        rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap_or_else(|e| panic!("{e}"));
    let (seconds, effort) = pool.install(|| {
        let simulation = case.build().unwrap_or_else(|error| panic!("{error}"));
        let start = Instant::now();
        let effort: Effort = simulation.run(&mut []).unwrap_or_else(|error| panic!("{error}"));
        (start.elapsed().as_secs_f64(), effort)
    });
    println!(
        "| {bodies} | {n} | {friction} | {} | {:.1} | {:.2} |",
        effort.solves,
        effort.applications as f64 / effort.solves as f64,
        1e3 * seconds / effort.solves as f64
    );
}
