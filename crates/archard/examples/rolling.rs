//! Cylinders roll at half of the creepage that makes the whole contact slip: the force is Carter's.

use std::error::Error;

use archard::body::contact_modulus;
use archard::body::profile::Cylinder;
use archard::closed_form::{carter, hertz::Line};
use archard::frame::Direction;
use archard::friction::Coulomb;
use archard::motion::{Control, Drive, Rolling};
use archard::{Body, Contact, Material};

fn main() -> Result<(), Box<dyn Error>> {
    let (radius, load, length, friction) = (40e-3, 7180.8, 40e-3, 0.3);
    let steel = Material::new(208e9, 0.3)?;
    let modulus = contact_modulus([Some(&steel); 2]);
    let hertz = Line::from_load(2.0 / radius, modulus, load / length).ok_or("no line contact")?;
    let creepage = 0.5 * carter::saturation_creepage(friction, hertz.half_width, 0.5 * radius);

    let driver = Body::new("driver", Cylinder::along_y(radius)?).material(steel);
    let driven = Body::new("driven", Cylinder::along_y(radius)?).material(steel);
    let rolling = Rolling::along(Direction::X).longitudinal(Drive::Slip(creepage));
    let rolls = Contact::rolling([driver, driven], rolling, Control::Load(load))?;
    // One row of elements, so long that the strain is plane.
    let frame = rolls.friction(Coulomb::new(friction)?).frame([0.44e-3, length], [80, 1]);
    let force = frame.solve()?.force()[0] / (friction * load);
    let expected = carter::relative_force(0.5);
    println!("force {force:.4} of its limit, Carter {expected:.4}");
    // 36 elements across the half width of contact.
    assert!((force / expected - 1.0).abs() < 3e-3);
    Ok(())
}
