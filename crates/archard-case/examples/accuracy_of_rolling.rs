//! The rolling tables of the book's page on accuracy: `cargo run --release --example accuracy_of_rolling`.

#[path = "../tests/framed/mod.rs"]
mod framed;

use archard::simulation::{Observer, Report, history, row};
use archard_case::CaseFile;

/// Independent solution of the twin discs at 0.5 % creepage: revolutions, total depth (um), force relative
/// to mu F, peak pressure (MPa).
const REFERENCE: [(f64, f64, f64, f64); 7] = [
    (1.0, 0.00231, 0.895, 800.0),
    (100.0, 0.2288, 0.905, 787.0),
    (1000.0, 2.06, 0.953, 684.0),
    (5000.0, 7.59, 0.999, 502.0),
    (10_000.0, 12.38, 1.0, 440.0),
    (20_000.0, 19.87, 1.0, 391.0),
    (30_000.0, 26.13, 1.0, 364.0),
];

type Wrong = Box<dyn std::error::Error>;

fn main() -> Result<(), Wrong> {
    strips()?;
    a_revolution()?;
    twin_discs()
}

/// Keeps the rows of a run.
#[derive(Default)]
struct Rows(Vec<Vec<(String, f64)>>);

impl Observer for Rows {
    fn observe(
        &mut self,
        report: &Report<'_>,
    ) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
        self.0.push(row(report));
        Ok(())
    }
}

/// The number in a column of a row.
fn number(row: &[(String, f64)], column: &str) -> f64 {
    history::number(row, column).unwrap_or(f64::NAN)
}

/// The rows of a case of the gallery with options.
fn run(name: &str, options: &[String]) -> Result<Rows, Wrong> {
    let path = framed::folder(name);
    let file = options.iter().fold(CaseFile::read(&path)?, CaseFile::set);
    let wrong = |problems: Vec<archard_case::Problem>| {
        problems.iter().map(|problem| problem.title()).collect::<Vec<_>>().join("\n")
    };
    let mut rows = Rows::default();
    file.resolve().map_err(wrong)?.case.build()?.run(&mut [&mut rows])?;
    Ok(rows)
}

fn strips() -> Result<(), Wrong> {
    println!("## Carter's cylinders at half of saturation\n");
    println!("| elements over 2.2 half widths | force / (mu F) | off |");
    println!("|---|---|---|");
    for elements in [20, 40, 80, 160] {
        let rows = run("carter", &[format!("frame.elements=[{elements}, 1]")])?;
        let row = &rows.0[0];
        let force = number(row, "force_x_N") / (0.3 * number(row, "load_N"));
        println!("| {elements} | {force:.4} | {:+.2} % |", 100.0 * (force / 0.75 - 1.0));
    }
    Ok(())
}

fn a_revolution() -> Result<(), Wrong> {
    println!("\n## Wear of a revolution of twin discs\n");
    println!("| elements across the contact | 0.5 % creepage | 1.5 % creepage |");
    println!("|---|---|---|");
    for across in [12, 24, 48, 96] {
        let [dx, dy] = [2.0 * 0.2165120, 2.0 * 0.8265901].map(|width| width / f64::from(across));
        let elements = across + 3;
        let mut off = vec![];
        for (creepage, limit) in [(0.005, 1.1495e3), (0.015, 4.078e3)] {
            let size = [dx, dy].map(|spacing| spacing * f64::from(elements));
            let options = [
                format!("frame.size=[\"{} mm\", \"{} mm\"]", size[0], size[1]),
                format!("frame.elements=[{elements}, {elements}]"),
                format!("motion.rolling.creepage={creepage}"),
                "motion.rolling.tolerance=".to_owned(),
                "motion.rolling.step=1e-3".to_owned(),
                "motion.rolling.revolutions=1e-3".to_owned(),
                "output.at=[1e-3]".to_owned(),
            ];
            let rows = run("twin_disc", &options)?;
            let depth = rows.0.last().map_or(f64::NAN, |row| number(row, "wear_depth_m")) / 1e-3;
            off.push(100.0 * (depth / 2e-12 / limit - 1.0));
        }
        println!("| {across} | {:+.2} % | {:+.2} % |", off[0], off[1]);
    }
    Ok(())
}

fn twin_discs() -> Result<(), Wrong> {
    println!("\n## Twin discs, 30,000 revolutions\n");
    println!("| revolutions | depth um | tolerance 0.003 | step 100 | step 10 |");
    println!("|---|---|---|---|---|");
    let runs = ["tolerance=0.003", "step=100", "step=10"].map(|steps| {
        let options = ["motion.rolling.tolerance=".to_owned(), format!("motion.rolling.{steps}")];
        run("twin_disc", &options)
    });
    let [adaptive, hundred, ten] = runs;
    let runs = [adaptive?, hundred?, ten?];
    for (revolutions, depth, _, peak) in REFERENCE {
        let cells = runs.each_ref().map(|rows| {
            let near = |row: &&Vec<(String, f64)>| {
                (number(row, "revolutions") - revolutions).abs() <= 1e-9 * revolutions
            };
            rows.0.iter().find(near).map_or("-".to_owned(), |row| {
                let off = |column: &str, unit: f64, known: f64| {
                    100.0 * (number(row, column) / unit / known - 1.0)
                };
                format!(
                    "{:+.2} %, {:+.1} %",
                    off("wear_depth_m", 1e-6, depth),
                    off("centre_pressure_Pa", 1e6, peak)
                )
            })
        });
        println!("| {revolutions} | {depth} | {} | {} | {} |", cells[0], cells[1], cells[2]);
    }
    let solves =
        runs.each_ref().map(|rows| rows.0.last().map_or(f64::NAN, |row| number(row, "solves")));
    println!("| solves | | {} | {} | {} |", solves[0], solves[1], solves[2]);
    Ok(())
}
