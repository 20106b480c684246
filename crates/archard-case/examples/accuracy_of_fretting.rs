//! The fretting tables of the book's page on accuracy: `cargo run --release --example accuracy_of_fretting`.

#[path = "../tests/framed/mod.rs"]
mod framed;

use std::f64::consts::PI;

use archard::body::{Material, contact_modulus};
use archard::closed_form::cattaneo_mindlin::PartialSlip;
use archard::closed_form::fretting_wear::WornOut;
use archard::closed_form::spence::{self, Indentation};
use archard::simulation::{Observer, Report, history, row};
use archard_case::CaseFile;

type Wrong = Box<dyn std::error::Error>;

const STEEL: Material = Material { young: 210e9, poisson: 0.3 };

fn main() -> Result<(), Wrong> {
    partial_slip()?;
    growing_load()?;
    punch()?;
    punch_in_cycles()?;
    jumps()?;
    end_of_fretting()
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

impl Rows {
    /// A column of the last row.
    fn last(&self, column: &str) -> f64 {
        self.0.last().map_or(f64::NAN, |row| number(row, column))
    }

    /// The largest value of a column.
    fn largest(&self, column: &str) -> f64 {
        self.0.iter().map(|row| number(row, column)).fold(0.0, f64::max)
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

fn square(elements: usize) -> String {
    format!("frame.elements=[{elements}, {elements}]")
}

/// How far a value is off another, in percent.
fn off(value: f64, known: f64) -> f64 {
    100.0 * (value / known - 1.0)
}

fn partial_slip() -> Result<(), Wrong> {
    println!("## Cattaneo and Mindlin\n");
    println!("| elements | increments | force | stick radius | energy a cycle |");
    println!("|---|---|---|---|---|");
    let exact = PartialSlip::new(0.05, [Some(&STEEL); 2], 10.2, 0.3).ok_or("no contact")?;
    let radius = exact.stick_radius(1.53);
    for (elements, increments) in [(32, 40), (64, 40), (128, 20), (128, 40), (128, 80)] {
        let options = [square(elements), format!("motion.fretting.increments={increments}")];
        let rows = run("cattaneo_mindlin", &options)?;
        let peak = rows
            .0
            .iter()
            .find(|row| number(row, "shift_x_m") >= 5.99e-8)
            .ok_or("no row at the amplitude")?;
        let stick = (number(peak, "stick_area_m2") / PI).sqrt();
        println!(
            "| {elements} | {increments} | {:+.3} % | {:+.2} % | {:+.2} % |",
            off(number(peak, "force_x_N"), 1.53),
            off(stick, radius),
            off(rows.last("dissipated_J"), exact.dissipation(1.53)),
        );
    }
    Ok(())
}

fn growing_load() -> Result<(), Wrong> {
    println!("\n## Spence\n");
    println!("| nu | mu | c/a exact | c/a | load |");
    println!("|---|---|---|---|---|");
    for (poisson, friction) in [(0.3, 0.15249), (0.3, 0.23801), (0.3, 0.3039), (0.0, 0.29874)] {
        let material = Material { poisson, ..STEEL };
        let exact =
            Indentation::at_friction(2.0, spence::coupling([None, Some(&material)]), friction)
                .ok_or("no solution")?;
        let options = [
            format!("body.block.material.poisson={poisson:?}"),
            format!("friction.coulomb.coefficient={friction}"),
        ];
        let rows = run("spence", &options)?;
        let modulus = contact_modulus([None, Some(&material)]);
        let approach = rows.last("approach_m");
        let hertz = 4.0 / 3.0 * modulus * 0.1f64.sqrt() * approach.powf(1.5);
        let expected = hertz * exact.relative_load / exact.relative_approach.powf(1.5);
        let ratio = (rows.last("stick_area_m2") / rows.last("contact_area_m2")).sqrt();
        println!(
            "| {poisson} | {friction} | {:.3} | {ratio:.3} | {:+.3} % |",
            exact.stick_ratio,
            off(rows.last("load_N"), expected)
        );
    }
    Ok(())
}

fn punch() -> Result<(), Wrong> {
    println!("\n## The punch of section 6.1, pressed on once\n");
    println!("| elements | increments | load | pressure at the centre | depth 1e-11 m |");
    println!("|---|---|---|---|---|");
    for (elements, increments) in [(40, 10), (40, 20), (40, 40), (20, 40), (80, 40)] {
        let options = [square(elements), format!("motion.indentation.increments={increments}")];
        let rows = run("punch_indentation", &options)?;
        println!(
            "| {elements} | {increments} | {:+.3} % | {:+.2} % | {:.2} |",
            off(rows.last("load_N"), 1.8281e6),
            off(rows.last("centre_pressure_Pa"), 1.33587e8),
            1e11 * rows.last("wear_depth_m")
        );
    }
    Ok(())
}

fn punch_in_cycles() -> Result<(), Wrong> {
    println!("\n## The punch of section 6.1, 500 cycles\n");
    println!("| elements | increments | rubbing | load 1e6 N | depth um | volume 1e-7 m^3 |");
    println!("|---|---|---|---|---|---|");
    for elements in [20, 40] {
        for rubbing in ["mean", "end"] {
            for increments in [10, 20, 40, 80] {
                let options = [
                    square(elements),
                    format!("motion.indentation.increments={increments}"),
                    format!("motion.indentation.rubbing=\"{rubbing}\""),
                    "motion.indentation.tolerance=0.01".to_owned(),
                ];
                let rows = run("punch_fretting", &options)?;
                println!(
                    "| {elements} | {increments} | {rubbing} | {:.3} | {:.2} | {:.2} |",
                    1e-6 * rows.last("load_N"),
                    1e6 * rows.last("wear_depth_m"),
                    1e7 * rows.last("worn_volume_block_m3"),
                );
            }
        }
    }
    Ok(())
}

fn jumps() -> Result<(), Wrong> {
    println!("\n## Jumps over cycles of the punch, 20 x 20 elements\n");
    println!("| tolerance | depth | volume | estimate | cycles computed |");
    println!("|---|---|---|---|---|");
    let all = run("punch_fretting", &[square(20), "motion.indentation.jump=1".to_owned()])?;
    for tolerance in [0.1, 0.03, 0.01, 0.003, 0.001] {
        let jumping = format!("motion.indentation.tolerance={tolerance}");
        let rows = run("punch_fretting", &[square(20), jumping])?;
        let same = |column: &str| {
            let worst = rows.0.iter().filter(|row| number(row, "cycle") > 0.0).map(|row| {
                let cycle = number(row, "cycle");
                let other = all.0.iter().find(|row| (number(row, "cycle") - cycle).abs() < 1e-9);
                let ends = (cycle - cycle.round()).abs() < 1e-9;
                other
                    .filter(|_| ends)
                    .map_or(0.0, |other| (number(row, column) / number(other, column) - 1.0).abs())
            });
            100.0 * worst.fold(0.0, f64::max)
        };
        println!(
            "| {tolerance} | {:.3} % | {:.3} % | {:.2} % | {} |",
            same("wear_depth_m"),
            same("worn_volume_block_m3"),
            100.0 * rows.last("time_error"),
            rows.last("true_cycles"),
        );
    }
    Ok(())
}

fn end_of_fretting() -> Result<(), Wrong> {
    println!("\n## The end of fretting wear\n");
    println!(
        "| elements | c from the approach, mm | centre pressure | depth | volume | cycles computed |"
    );
    println!("|---|---|---|---|---|---|");
    let modulus = contact_modulus([Some(&STEEL); 2]);
    for elements in [32, 64, 128] {
        let rows = run("fretting_sphere", &[square(elements)])?;
        let approach = rows.last("approach_m");
        let worn = |stick: f64| WornOut::new(0.01, modulus, 50.0, stick);
        // The approach falls as the stick radius grows.
        let (mut low, mut high) = (0.05e-3, 0.147e-3);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let deep = worn(middle).is_some_and(|worn| worn.approach > approach);
            if deep { low = middle } else { high = middle }
        }
        let exact = worn(low).ok_or("no final state")?;
        let volume = rows.last("worn_volume_ball_m3") + rows.last("worn_volume_flat_m3");
        println!(
            "| {elements} | {:.5} | {:+.2} % | {:+.2} % | {:+.2} % | {} |",
            1e3 * low,
            off(rows.last("centre_pressure_Pa"), exact.pressure(0.0)),
            off(rows.largest("wear_depth_m"), exact.greatest_depth()),
            off(volume, exact.volume()),
            rows.last("true_cycles"),
        );
    }
    Ok(())
}
