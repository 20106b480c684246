//! A ball is pressed on a flat: approach and peak pressure of Hertz's theory.

use std::error::Error;

use archard::body::contact_modulus;
use archard::body::profile::{Flat, Sphere};
use archard::closed_form::Hertz;
use archard::motion::Control;
use archard::{Body, Contact, Material};

fn main() -> Result<(), Box<dyn Error>> {
    let (radius, load) = (50e-3, 10.2);
    let steel = Material::new(210e9, 0.3)?;
    let ball = Body::new("ball", Sphere::new(radius)?).material(steel);
    let flat = Body::new("flat", Flat).material(steel);
    let pressed = Contact::between([ball, flat], Control::Load(load))?;
    let contact = pressed.frame([0.358e-3; 2], [60; 2]).solve()?;

    let hertz = Hertz::from_load([1.0 / radius; 2], contact_modulus([Some(&steel); 2]), load);
    let hertz = hertz.ok_or("no contact of Hertz")?;
    let (approach, frame) = (contact.approach(), &contact.problem().frame);
    let peak = frame.at_centre(contact.pressure());
    println!("approach {:.4e} m, Hertz {:.4e} m", approach, hertz.approach);
    println!("peak pressure {peak:.4e} Pa, Hertz {:.4e} Pa", hertz.peak_pressure);
    // 25 elements across the radius of contact.
    assert!((approach / hertz.approach - 1.0).abs() < 5e-4);
    assert!((peak / hertz.peak_pressure - 1.0).abs() < 5e-4);
    Ok(())
}
