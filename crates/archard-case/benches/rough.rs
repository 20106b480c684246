//! Rough surfaces on a flat: applications of the compliance from a first guess and from coarser elements, CPU seconds of the
//! process and its peak memory, one thread.
//!
//! `cargo bench --bench rough` prints the table of the book's page on performance, `-- "512 8 free"` one row of it. Peak
//! memory is that of one row where it is asked for alone.

#![allow(missing_docs, reason = "a program")]

#[path = "../tests/surfaces/mod.rs"]
mod surfaces;

use std::fs::read_to_string;

use archard::solve::{ConjugateGradient, Solver, Status, press};

use surfaces::OnAFlat;

/// Elements along a side, mean pressure over E* and rms slope, and about what touches under it (%).
const SURFACES: [(usize, f64, usize); 6] = [
    (256, 0.04, 8),
    (512, 0.0135, 3),
    (512, 0.04, 8),
    (512, 0.1, 19),
    (1024, 0.0375, 7),
    (1024, 0.1, 19),
];
fn main() {
    let asked = std::env::args().skip(1).find(|argument| !argument.starts_with("--"));
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let pool = pool.unwrap_or_else(|error| panic!("{error}"));
    println!(
        "| n | contact, % | | applications from coarser elements | from a first guess | ratio | CPU s | MB |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for (n, pressure, percent) in SURFACES {
        for surroundings in ["free", "periodic"] {
            let name = format!("{n} {percent} {surroundings}");
            if asked.as_ref().is_none_or(|asked| *asked == name) {
                pool.install(|| row(n, pressure, surroundings));
            }
        }
    }
}

/// Presses a surface on a flat by a mean pressure over E* and rms slope.
fn row(n: usize, pressure: f64, surroundings: &str) {
    let surface = OnAFlat::new(n, surroundings == "periodic");
    let step = surface.pressed(pressure);
    // Kernels are made when first needed, and count.
    let before = cpu_seconds();
    let solver = ConjugateGradient::default();
    let outcome = press(&solver, &step, None);
    let (seconds, memory) = (cpu_seconds() - before, peak_memory());
    let guessed = solver.solve(&step, None);
    assert_eq!([outcome.status, guessed.status], [Status::Converged; 2]);
    let touching = outcome.pressure.iter().filter(|&&pressure| pressure > 0.0).count();
    println!(
        "| {n} | {:.1} | {surroundings} | {} | {} | {:.2} | {seconds:.2} | {memory:.0} |",
        100.0 * touching as f64 / step.gap.len() as f64,
        outcome.applications,
        guessed.applications,
        outcome.applications as f64 / guessed.applications as f64,
    );
}

/// CPU time (s) of this process in its own code, in hundredths, where Linux gives it.
fn cpu_seconds() -> f64 {
    let stat = read_to_string("/proc/self/stat").unwrap_or_default();
    let after_name = stat.rsplit(") ").next();
    let ticks = after_name.and_then(|rest| rest.split(' ').nth(11)?.parse::<f64>().ok());
    ticks.unwrap_or(f64::NAN) / 100.0
}

/// The most memory (MB) this process took so far, where Linux gives it.
fn peak_memory() -> f64 {
    let status = read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = line.and_then(|line| line.trim().trim_end_matches(" kB").parse::<f64>().ok());
    kilobytes.unwrap_or(f64::NAN) / 1024.0
}
