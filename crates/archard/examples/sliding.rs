//! A pin wears on a disc; the volume it loses is k F s, and its depth that of Archard's law for a rigid pin.

use std::error::Error;

use archard::body::profile::{Flat, Sphere};
use archard::closed_form::pin_on_disc;
use archard::motion::{Control, Sliding, Stepping};
use archard::simulation::Run;
use archard::wear::Archard;
use archard::{Body, Material, Simulation};

fn main() -> Result<(), Box<dyn Error>> {
    let (radius, k, load, distance) = (50e-3, 1.33e-13, 10.2, 0.5);
    let steel = Material::new(210e9, 0.3)?;
    let pin = Body::new("pin", Sphere::new(radius)?).material(steel).wear(Archard::new(k)?);
    let disc = Body::new("disc", Flat).material(steel);
    let sliding = Sliding::new().over(distance, Control::Load(load), Stepping::Implicit(0.02))?;
    let builder = Simulation::builder([pin, disc], sliding);
    let mut run = Run::begin(builder.frame([1.2e-3; 2], [30; 2]).build()?)?;
    while run.step()? {}

    let (state, frame) = (run.report().state, &run.simulation().problem.frame);
    let volume = frame.integrate(&state.worn(0));
    let depth = state.worn(0).iter().copied().fold(0.0, f64::max);
    let rigid = pin_on_disc::depth(radius, k * load * distance);
    println!("worn volume {volume:.4e} m^3, depth {depth:.4e} m; of a rigid pin {rigid:.4e} m");
    assert!((volume / (k * load * distance) - 1.0).abs() < 1e-9);
    // A rigid pin wears 0.9 % deeper than an elastic one here; the elements make up the rest.
    assert!((depth / rigid - 1.0).abs() < 0.015);
    Ok(())
}
