//! A wear law of one's own: no wear below a threshold of pressure, Archard's beyond it.
//!
//! `cargo run --release --example custom_wear_law` slides a ball on a flat with it and prints the
//! depth beside that of plain Archard wear.

use std::path::Path;

use archard::case::{CaseFile, Problem};
use archard::simulation::{Observer, Report};
use archard::wear::{Rubbing, WearLaw};

/// depth = k (p - p_c) s where the pressure p exceeds the threshold p_c.
#[derive(Debug)]
struct Threshold {
    /// k (1/Pa).
    coefficient: f64,
    /// p_c (Pa).
    threshold: f64,
}

impl WearLaw for Threshold {
    fn depth(&self, Rubbing { pressure, slip, .. }: Rubbing) -> f64 {
        self.coefficient * (pressure - self.threshold).max(0.0) * slip
    }

    fn slope(&self, Rubbing { pressure, slip, .. }: Rubbing) -> f64 {
        if pressure > self.threshold { self.coefficient * slip } else { 0.0 }
    }
}

/// Keeps the deepest wear of every output.
#[derive(Default)]
struct Depths(Vec<(f64, f64)>);

impl Observer for Depths {
    fn observe(
        &mut self,
        report: &Report<'_>,
    ) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
        if report.output {
            let deepest = report.state.total_worn().into_iter().fold(0.0, f64::max);
            self.0.push((report.state.progress, deepest));
        }
        Ok(())
    }
}

const CASE: &str = r#"
[body.ball]
material = { young = "210 GPa", poisson = 0.3 }
profile.sphere = { radius = "50 mm" }
wear.archard = { coefficient = "1.33e-13 1/Pa" }
[body.flat]
material = { young = "210 GPa", poisson = 0.3 }
profile.flat = {}
[frame]
size = ["1.2 mm", "1.2 mm"]
elements = [40, 40]
[motion.sliding]
load = "10.2 N"
distance = "200 mm"
tolerance = 3e-3
"#;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let case = CaseFile::from_text("ball on flat", CASE, Path::new(".")).resolve();
    let case = case
        .map_err(|problems| problems.iter().map(Problem::title).collect::<Vec<_>>().join("\n"))?
        .case;
    let (mut plain, mut own) = (Depths::default(), Depths::default());
    let mut simulation = case.build()?;
    simulation.run(&mut [&mut plain])?;
    simulation.problem.bodies[0].wear =
        Some(Box::new(Threshold { coefficient: 1.33e-13, threshold: 30e6 }));
    simulation.run(&mut [&mut own])?;
    println!("distance (mm)  Archard (um)  with a threshold of 30 MPa (um)");
    for ((distance, archard), (_, threshold)) in plain.0.iter().zip(&own.0) {
        println!("{:13.0} {:13.4} {:20.4}", 1e3 * distance, 1e6 * archard, 1e6 * threshold);
    }
    Ok(())
}
