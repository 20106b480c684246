//! A ball is pressed on a flat: approach and peak pressure of Hertz's theory.

use std::error::Error;

use archard::body::contact_modulus;
use archard::body::profile::{Flat, Sphere};
use archard::closed_form::Hertz;
use archard::motion::{Control, Indentation};
use archard::simulation::Run;
use archard::{Body, Material, Simulation};

fn main() -> Result<(), Box<dyn Error>> {
    let (radius, load) = (50e-3, 10.2);
    let steel = Material::new(210e9, 0.3)?;
    let ball = Body::new("ball", Sphere::new(radius)?).material(steel);
    let flat = Body::new("flat", Flat).material(steel);
    let pressed = Indentation::new(1).under(Control::Load(load))?;
    let builder = Simulation::builder([ball, flat], pressed);
    let mut run = Run::begin(builder.frame([0.358e-3; 2], [60; 2]).build()?)?;
    while run.step()? {}

    let (state, frame) = (run.report().state, &run.simulation().problem.frame);
    let hertz = Hertz::from_load([1.0 / radius; 2], contact_modulus([Some(&steel); 2]), load);
    let hertz = hertz.ok_or("no contact of Hertz")?;
    let peak = frame.at_centre(&state.pressure);
    println!("approach {:.4e} m, Hertz {:.4e} m", state.approach, hertz.approach);
    println!("peak pressure {peak:.4e} Pa, Hertz {:.4e} Pa", hertz.peak_pressure);
    // 25 elements across the radius of contact.
    assert!((state.approach / hertz.approach - 1.0).abs() < 5e-4);
    assert!((peak / hertz.peak_pressure - 1.0).abs() < 5e-4);
    Ok(())
}
