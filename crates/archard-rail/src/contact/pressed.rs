//! One patch in its tangent plane: pressures and friction of half-spaces at a height of the wheel.

use archard::body::profile::Flat;
use archard::compliance::HalfSpace;
use archard::frame::Direction;
use archard::motion::{Control, Drive, Rolling, Stepping};
use archard::simulation::{Run, Simulation};
use archard::{Body, ContactFrame};

use super::lattice::Lattice;
use super::{Bodies, ContactError};
use crate::creepage::Creepage;
use crate::search::{Patch, Search};
use crate::setup::Velocity;

/// A patch under pressure. Forces and the moment are those on the rail, in the frame of the contact.
#[derive(Debug, Clone)]
pub(super) struct Pressed {
    pub patch: Patch,
    pub creepage: Creepage,
    pub approach: f64,
    pub normal: f64,
    pub tangential: [f64; 2],
    pub moment: f64,
    pub peak: f64,
    pub area: f64,
    pub power: f64,
    /// How much the inclination of the rail (rad) differs within the contact.
    pub angle_spread: f64,
}

impl Pressed {
    /// What it takes of the vertical load (N).
    pub fn vertical(&self) -> f64 {
        self.normal * self.patch.angle.cos() + self.tangential[1] * self.patch.angle.sin()
    }

    /// Presses the bodies of a patch together on so many elements along x and along s.
    pub fn new(
        search: &Search<'_>,
        patch: Patch,
        (velocity, bodies): (&Velocity, &Bodies),
        elements: usize,
    ) -> Result<Self, ContactError> {
        let lattice = Lattice::over(search, &patch, elements);
        let short = ContactError::Short { y: patch.reference.y };
        if !lattice.is_whole() {
            return Err(short);
        }
        let approach = lattice.approach();
        let creepage = Creepage::new(search, &patch, velocity, approach);
        if approach <= 0.0 {
            // It lies between the middles of the elements.
            return Ok(Self::light(patch, creepage));
        }
        let rolling = Rolling::along(Direction::X)
            .longitudinal(Drive::Creepage(creepage.longitudinal))
            .lateral(Drive::Creepage(creepage.lateral))
            .spin(creepage.spin)
            .at_speed(creepage.speed);
        let run = Run::begin(simulation(&lattice, rolling, approach, bodies)?)?;
        let (problem, state) = (&run.simulation().problem, run.report().state);
        let frame = &problem.frame;
        let tangential = state.tangential.as_ref();
        let row = |pair: usize| pair / lattice.elements[0];
        let pressed = (0..frame.len()).filter(|&pair| state.pressure[pair] > 0.0).map(row);
        let ends = [0, lattice.elements[1] - 1];
        if pressed.clone().any(|row| [0, 1].iter().any(|&end| patch.cut[end] && row == ends[end])) {
            return Err(short);
        }
        let angles = pressed.filter_map(|row| {
            search.inclination(patch.reference.y + lattice.across(row) * patch.angle.cos())
        });
        let [least, most] = angles
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], angle| [a.min(angle), b.max(angle)]);
        Ok(Self {
            approach,
            normal: state.load,
            // Of friction the run knows what acts on the wheel.
            tangential: tangential.map_or([0.0; 2], |of| of.force(frame).map(|force| -force)),
            moment: tangential.map_or(0.0, |of| -of.moment(frame)),
            peak: state.pressure.iter().copied().fold(0.0, f64::max),
            area: state.contact_area(problem),
            power: tangential.map_or(0.0, |of| of.creep_power(problem, &rolling) * creepage.speed),
            angle_spread: (most - least).max(0.0),
            patch,
            creepage,
        })
    }

    /// A patch that bears nothing.
    fn light(patch: Patch, creepage: Creepage) -> Self {
        Self {
            patch,
            creepage,
            approach: 0.0,
            normal: 0.0,
            tangential: [0.0; 2],
            moment: 0.0,
            peak: 0.0,
            area: 0.0,
            power: 0.0,
            angle_spread: 0.0,
        }
    }
}

fn simulation(
    lattice: &Lattice,
    rolling: Rolling,
    approach: f64,
    bodies: &Bodies,
) -> Result<Simulation, ContactError> {
    let frame = ContactFrame::uniform(lattice.rectangle, lattice.elements, [lattice, &Flat])
        .map_err(archard::simulation::Refused::from)?
        .closed();
    let compliance = HalfSpace::new([Some(&bodies.wheel), Some(&bodies.rail)], &frame);
    let wheel = Body::new("wheel", lattice.clone()).material(bodies.wheel);
    let rail = Body::new("rail", Flat).material(bodies.rail);
    let steady = rolling
        .over(0.0, Control::Approach(approach), Stepping::Implicit(1.0))
        .map_err(archard::simulation::Refused::from)?;
    let mut builder = Simulation::builder([wheel, rail], steady).contact(frame, compliance);
    builder.friction = Some(bodies.friction.clone());
    Ok(builder.build()?)
}
