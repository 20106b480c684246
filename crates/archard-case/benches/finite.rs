//! Cost of finite bodies: the stages from a mesh to results, against the parts that cannot be avoided.
//!
//! `cargo bench --bench finite` prints the tables of the book's page on performance. Every ratio is of times
//! taken in the same run.

#![allow(missing_docs, reason = "a program")]

use std::cell::RefCell;
use std::path::Path;
use std::time::{Duration, Instant};

use archard::body::{Finite, Material};
use archard::compliance::bem::contact::Job;
use archard::compliance::bem::{
    AssembledBody, CondensedBody, Evaluations, evaluate_alone, integrate_alone,
};
use archard::numerics::dense::{Lu, SolveError};
use archard::numerics::large::Large;
use archard_case::output::Store;
use archard_case::{Case, CaseFile};
use faer::Mat;

/// Evaluations of the kernel by itself, of each kind.
const ALONE: usize = 20_000_000;

/// Times of the stages of one body.
#[derive(Debug, Clone, Copy, Default)]
struct Stages {
    unknowns: usize,
    evaluations: Evaluations,
    assembly: Duration,
    /// Assembly and factors.
    factors: Duration,
    condensation: Duration,
}

impl Stages {
    /// The shorter time of each stage: the first run finds memory that the system has to clear or to fetch.
    fn better(self, other: Self) -> Self {
        let assembly = self.assembly.min(other.assembly);
        let lu = (self.factors - self.assembly).min(other.factors - other.assembly);
        let condensation = self.condensation.min(other.condensation);
        Self { assembly, factors: assembly + lu, condensation, ..self }
    }
}

fn main() {
    let (kernel, products) = (Rate::of(evaluate_alone), Rate::of(integrate_alone));
    println!("Punch on a cube: assembly, factors, condensation\n");
    println!(
        "| elements | unknowns | assembly s | LU s | condensation s | kernel rate | with products | (assembly + LU) / (kernels + LU) |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    let mut rows = vec![];
    for elements in [8, 12, 16, 20] {
        let case = case("punch_indentation_block", &elements_of(elements));
        let stages = stages(&case).better(stages(&case));
        let lu = lu_alone(stages.unknowns);
        let threads = rayon::current_num_threads() as f64;
        let [kernels, integrals] =
            [kernel, products].map(|rate| rate.time(stages.evaluations) / threads);
        let [rate, integrated] =
            [kernels, integrals].map(|time| 100.0 * time / stages.assembly.as_secs_f64());
        let ratio = stages.factors.as_secs_f64() / (kernels + lu.as_secs_f64());
        println!(
            "| {elements} x {elements} | {} | {:.2} | {:.2} | {:.2} | {rate:.0} % | {integrated:.0} % | {ratio:.2} |",
            stages.unknowns,
            stages.assembly.as_secs_f64(),
            (stages.factors - stages.assembly).as_secs_f64(),
            stages.condensation.as_secs_f64(),
        );
        rows.push(stages);
    }
    if let Some(Stages { evaluations, .. }) = rows.last() {
        let share = 100.0 * kernel.time(*evaluations) / products.time(*evaluations);
        println!("\nThe loop with products runs at {share:.0} % of the rate of the kernel's own.");
    }
    exponents(&rows);
    println!(
        "\nWhole runs on 20 x 20 elements, against their own assembly, factors and condensation; and from what was kept\n"
    );
    println!("| case | cold s | stages s | ratio | kept s | stages / kept |");
    println!("|---|---|---|---|---|---|");
    for name in ["punch_indentation_block", "punch_fretting_block"] {
        whole(name);
    }
}

/// The case in a folder, with options.
fn case(name: &str, options: &[String]) -> Case {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(name);
    let file = CaseFile::read(&folder).expect("a case");
    let file = options.iter().fold(file, |file, option| file.set(option));
    file.resolve().unwrap_or_else(|problems| panic!("{problems:?}")).case
}

fn elements_of(count: usize) -> [String; 1] {
    [format!("body.block.mesh.box.contact.elements=[{count}, {count}]")]
}

/// Seconds of one evaluation of each kind, on one thread: the shortest of three runs.
#[derive(Debug, Clone, Copy)]
struct Rate {
    tractions: f64,
    both: f64,
}

impl Rate {
    fn of(run: fn(Evaluations) -> f64) -> Self {
        let once = |evaluations: Evaluations| {
            let begun = Instant::now();
            assert!(run(evaluations).is_finite());
            begun.elapsed().as_secs_f64() / ALONE as f64
        };
        let time = |evaluations| (0..3).map(|_| once(evaluations)).fold(f64::INFINITY, f64::min);
        Self {
            tractions: time(Evaluations { tractions: ALONE, both: 0 }),
            both: time(Evaluations { tractions: 0, both: ALONE }),
        }
    }

    fn time(self, evaluations: Evaluations) -> f64 {
        evaluations.tractions as f64 * self.tractions + evaluations.both as f64 * self.both
    }
}

/// Factors of a matrix of that size.
fn lu_alone(size: usize) -> Duration {
    let mut matrix = Large::zeros(size, size).expect("enough memory");
    matrix.as_mut().copy_from(Mat::from_fn(size, size, |i, j| {
        f64::from(i == j) * 4.0 + ((i * 7919 + j * 104_729) % 1009) as f64 / (1009.0 * size as f64)
    }));
    let begun = Instant::now();
    Lu::new(matrix).expect("a regular matrix");
    begun.elapsed()
}

/// Builds a case and measures the stages of its body.
fn stages(case: &Case) -> Stages {
    let stages = RefCell::new(Stages::default());
    let condense = |finite: &Finite, material: &Material, job: &Job<'_>| {
        measured(finite, material, job, &mut stages.borrow_mut())
    };
    case.build_with(&condense).expect("a checked case");
    stages.into_inner()
}

fn measured(
    finite: &Finite,
    material: &Material,
    job: &Job<'_>,
    stages: &mut Stages,
) -> Result<CondensedBody, SolveError> {
    let begun = Instant::now();
    let equations = AssembledBody::new(job.surface, material, job.conditions, finite.tolerance)?;
    let (evaluations, assembly) = (equations.evaluations(), begun.elapsed());
    let solid = equations.factorise()?;
    let factors = begun.elapsed();
    let begun = Instant::now();
    let condensed = solid.condense();
    let unknowns = job.surface.unknowns();
    *stages = Stages { unknowns, evaluations, assembly, factors, condensation: begun.elapsed() };
    Ok(condensed)
}

/// How the times grow with the unknowns, from the second row to the last.
fn exponents(rows: &[Stages]) {
    let [_, first, .., last] = rows else { return };
    let exponent = |time: fn(&Stages) -> Duration| {
        let times = time(last).as_secs_f64() / time(first).as_secs_f64();
        times.ln() / (last.unknowns as f64 / first.unknowns as f64).ln()
    };
    println!(
        "\nFrom {} to {} unknowns the assembly grows with their power of {:.2}, the factors with {:.2}.",
        first.unknowns,
        last.unknowns,
        exponent(|stages| stages.assembly),
        exponent(|stages| stages.factors - stages.assembly),
    );
}

/// A run from its mesh to its results, and another from what the first kept.
fn whole(name: &str) {
    let case = case(name, &[]);
    let begun = Instant::now();
    let stages = RefCell::new(Stages::default());
    let condense = |finite: &Finite, material: &Material, job: &Job<'_>| {
        measured(finite, material, job, &mut stages.borrow_mut())
    };
    case.build_with(&condense).expect("a checked case").run(&mut []).expect("a contact");
    let cold = begun.elapsed().as_secs_f64();
    let Stages { factors, condensation, .. } = stages.into_inner();
    let parts = (factors + condensation).as_secs_f64();
    let folder = tempfile::tempdir().expect("a folder");
    let store = Store::new(folder.path());
    let keep =
        |finite: &Finite, material: &Material, job: &Job<'_>| store.condense(finite, material, job);
    case.build_with(&keep).expect("a checked case");
    let begun = Instant::now();
    case.build_with(&keep).expect("a checked case");
    let kept = begun.elapsed().as_secs_f64();
    println!(
        "| {name} | {cold:.2} | {parts:.2} | {:.2} | {kept:.3} | {:.0} |",
        cold / parts,
        parts / kept
    );
}
