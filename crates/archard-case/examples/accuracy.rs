//! The tables of the book's page on accuracy: `cargo run --release --example accuracy`.

#[path = "../tests/framed/mod.rs"]
mod framed;

use archard::closed_form::Hertz;
use archard::problem::ContactState;
use archard::simulation::{Effort, Observer, Report};
use archard_case::{Case, CaseFile};

/// Independent solution of the pin on disc, axisymmetric, elastic half-spaces, converged to five
/// digits: distance (mm), depth (um), pressure at the centre (MPa).
const REFERENCE: [(f64, f64, f64); 8] = [
    (5.0, 0.126398, 164.12),
    (20.0, 0.361069, 87.22),
    (50.0, 0.619758, 51.433),
    (100.0, 0.899539, 35.620),
    (200.0, 1.289908, 24.958),
    (300.0, 1.587844, 20.326),
    (400.0, 1.838470, 17.572),
    (500.0, 2.059002, 15.707),
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    hertz()?;
    pin_on_disc()?;
    tolerances()
}

/// Every state that is due for output.
#[derive(Default)]
struct Outputs(Vec<(ContactState, Effort)>);

impl Observer for Outputs {
    fn observe(
        &mut self,
        report: &Report<'_>,
    ) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
        if report.output {
            self.0.push((report.state.clone(), report.effort));
        }
        Ok(())
    }
}

fn case(name: &str, options: &[String]) -> Result<Case, Box<dyn std::error::Error>> {
    let path = framed::folder(name);
    let file = options.iter().fold(CaseFile::read(&path)?, CaseFile::set);
    let wrong = |problems: Vec<archard_case::Problem>| {
        problems.iter().map(|problem| problem.title()).collect::<Vec<_>>().join("\n")
    };
    Ok(file.resolve().map_err(wrong)?.case)
}

fn run(
    name: &str,
    options: &[String],
) -> Result<Vec<(ContactState, Effort)>, Box<dyn std::error::Error>> {
    let mut outputs = Outputs::default();
    case(name, options)?.build()?.run(&mut [&mut outputs])?;
    Ok(outputs.0)
}

fn peak(field: &[f64]) -> f64 {
    field.iter().copied().fold(0.0, f64::max)
}

fn hertz() -> Result<(), Box<dyn std::error::Error>> {
    println!(
        "Hertz, a sphere on a frame 2.4 contact radii wide: error of the peak pressure and of the approach\n"
    );
    println!("| elements | peak pressure | approach |\n|---|---|---|");
    let exact = Hertz::from_load([20.0; 2], 210e9 / (2.0 * 0.91), 10.2).ok_or("a sphere")?;
    for n in [30, 60, 120, 240, 480] {
        let outputs = run("hertz", &[format!("frame.elements=[{n},{n}]")])?;
        let state = &outputs.last().ok_or("an output")?.0;
        let error = |value: f64, exact: f64| 100.0 * (value / exact - 1.0);
        println!(
            "| {n} x {n} | {:+.4} % | {:+.4} % |",
            error(peak(&state.pressure), exact.peak_pressure),
            error(state.approach, exact.approach)
        );
    }
    Ok(())
}

fn sliding(n: usize, steps: &str) -> [String; 4] {
    let at: Vec<String> = REFERENCE.iter().map(|row| format!("\"{} mm\"", row.0)).collect();
    [
        "motion.sliding.step=".to_owned(),
        format!("motion.sliding.{steps}"),
        format!("frame.elements=[{n},{n}]"),
        format!("output={{ at = [{}] }}", at.join(", ")),
    ]
}

fn pin_on_disc() -> Result<(), Box<dyn std::error::Error>> {
    println!(
        "\nPin on disc: error of the depth, and of the pressure at the centre, against an axisymmetric solution\n"
    );
    println!(
        "| distance mm | depth um | 30 x 30, 5 mm | 120 x 120, tolerance 1e-3 |\n|---|---|---|---|"
    );
    let runs = [
        run("pin_on_disc", &sliding(30, "step=5 mm"))?,
        run("pin_on_disc", &sliding(120, "tolerance=1e-3"))?,
    ];
    let frames = [30, 120].map(|n| case("pin_on_disc", &[format!("frame.elements=[{n},{n}]")]));
    let [coarse, fine] = frames;
    let frames = [coarse?.build()?.problem.frame, fine?.build()?.problem.frame];
    for (i, (distance, depth, centre)) in REFERENCE.into_iter().enumerate() {
        let errors = [0, 1].map(|which| {
            let (state, effort) = &runs[which][i + 1];
            let wear = 100.0 * (1e6 * peak(&state.total_worn()) / depth - 1.0);
            let pressure = frames[which].at_centre(&state.pressure) - effort.centre_lag;
            format!("{wear:+.2} %, {:+.1} %", 100.0 * (1e-6 * pressure / centre - 1.0))
        });
        println!("| {distance} | {depth:.4} | {} | {} |", errors[0], errors[1]);
    }
    Ok(())
}

fn tolerances() -> Result<(), Box<dyn std::error::Error>> {
    println!(
        "\nSteps chosen by error, 60 x 60: largest true and estimated error of the depth from 5 mm on\n"
    );
    println!("| tolerance | contact solves | true error | estimate |\n|---|---|---|---|");
    let converged = run("pin_on_disc", &sliding(60, "tolerance=2e-6"))?;
    for tolerance in ["1e-2", "3e-3", "1e-3", "3e-4", "1e-4"] {
        let outputs = run("pin_on_disc", &sliding(60, &format!("tolerance={tolerance}")))?;
        let (mut error, mut estimate) = (0.0f64, 0.0f64);
        for ((state, effort), (exact, _)) in outputs.iter().zip(&converged).skip(1) {
            error = error.max((peak(&state.total_worn()) / peak(&exact.total_worn()) - 1.0).abs());
            estimate = estimate.max(effort.time_error.unwrap_or(0.0));
        }
        let solves = outputs.last().ok_or("an output")?.1.solves;
        println!("| {tolerance} | {solves} | {error:.1e} | {estimate:.1e} |");
    }
    Ok(())
}
