//! A wear law of one's own: no wear below a threshold of pressure, Archard's beyond it.
//!
//! `cargo run --release --example custom_wear_law` slides a ball on a flat with it and prints the
//! depth next to that of plain Archard wear. It ends in an error unless a threshold of zero wears as Archard's law does, and one
//! above Hertz's largest pressure not at all.

use std::error::Error;

use archard::body::profile::{Flat, Sphere};
use archard::motion::{Control, Sliding, Stepping};
use archard::simulation::{Observer, Report};
use archard::wear::{Archard, Rubbing, WearLaw};
use archard::{Body, Material, Simulation};

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
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn Error + Send + Sync>> {
        if report.output {
            let deepest = report.state.total_worn().into_iter().fold(0.0, f64::max);
            self.0.push((report.state.progress, deepest));
        }
        Ok(())
    }
}

/// A ball on a flat that wears by a law.
fn ball_on_flat(law: impl WearLaw + 'static) -> Result<Depths, Box<dyn Error>> {
    let steel = Material::new(210e9, 0.3)?;
    let ball = Body::new("ball", Sphere::new(50e-3)?).material(steel).wear(law);
    let flat = Body::new("flat", Flat).material(steel);
    let sliding = Sliding::new().over(0.2, Control::Load(10.2), Stepping::Tolerance(3e-3))?;
    let builder = Simulation::builder([ball, flat], sliding).frame([1.2e-3; 2], [40; 2]);
    let outputs = (1..=10).map(|i| 0.02 * f64::from(i));
    let mut depths = Depths::default();
    builder.outputs(outputs).build()?.run(&mut [&mut depths])?;
    Ok(depths)
}

fn main() -> Result<(), Box<dyn Error>> {
    let plain = ball_on_flat(Archard::new(1.33e-13)?)?;
    let own = ball_on_flat(Threshold { coefficient: 1.33e-13, threshold: 30e6 })?;
    println!("distance (mm)  Archard (um)  with a threshold of 30 MPa (um)");
    for ((distance, archard), (_, threshold)) in plain.0.iter().zip(&own.0) {
        println!("{:13.0} {:13.4} {:20.4}", 1e3 * distance, 1e6 * archard, 1e6 * threshold);
    }
    let none = ball_on_flat(Threshold { coefficient: 1.33e-13, threshold: 0.0 })?;
    let same = |own: f64, archard: f64| (own - archard).abs() <= 1e-9 * archard;
    assert!(none.0.iter().zip(&plain.0).all(|(own, archard)| same(own.1, archard.1)));
    // Hertz: 219 MPa in the middle of 10.2 N on a ball of 50 mm, steel on steel.
    let high = ball_on_flat(Threshold { coefficient: 1.33e-13, threshold: 220e6 })?;
    assert!(high.0.iter().all(|(_, depth)| *depth == 0.0));
    Ok(())
}
