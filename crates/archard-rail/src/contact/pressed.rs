//! One patch in its tangent plane: pressures and friction of half-spaces at a height of the wheel.

use archard::body::profile::Flat;
use archard::compliance::HalfSpace;
use archard::frame::Direction;
use archard::motion::{Control, Drive, Drives, Rolling};
use archard::simulation::{Builder, Refused, WornLine};
use archard::{Body, Contact, ContactFrame};

use super::lattice::Lattice;
use super::{Bodies, ContactError, Wear};
use crate::creepage::Creepage;
use crate::search::{Patch, Search};
use crate::setup::Velocity;

/// A patch of overlap with its grid.
#[derive(Debug)]
pub(super) struct Site {
    pub patch: Patch,
    lattice: Lattice,
}

/// A patch under pressure. Forces and the moment are those on the rail, in the frame of the contact.
#[derive(Debug, Clone)]
pub(crate) struct Pressed {
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
    /// What one passage wears off the wheel and the rail, over s.
    pub worn: Vec<WornLine>,
    /// What is known of each element.
    pub map: PatchMap,
}

/// What is known of the elements of a patch, one value each, those along x first: x from the lowest, then s from the lowest.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PatchMap {
    /// The lowest corner (m) along x and s, from the reference point.
    pub origin: [f64; 2],
    /// Size (m) of an element.
    pub spacing: [f64; 2],
    /// Number of elements.
    pub elements: [usize; 2],
    /// Pressure (Pa).
    pub pressure: Vec<f64>,
    /// Traction (Pa) on the rail along x and s.
    pub traction: [Vec<f64>; 2],
    /// Slip of the wheel over the rail along x and s, relative to the rolling speed; zero where nothing touches.
    pub slip: [Vec<f64>; 2],
}

impl Pressed {
    /// What it takes of the vertical load (N).
    pub fn vertical(&self) -> f64 {
        self.normal * self.patch.angle.cos() + self.tangential[1] * self.patch.angle.sin()
    }
}

impl Site {
    /// The patch on so many elements, as [`Lattice::over`] counts them.
    pub fn new(search: &Search<'_>, patch: Patch, elements: usize) -> Result<Self, ContactError> {
        let lattice = Lattice::over(search, &patch, elements)?;
        Ok(Self { patch, lattice })
    }

    /// Normal force (N) without friction, of bodies that others have pressed apart there by so much (m).
    pub fn force(&self, bodies: &Bodies, apart: f64) -> Result<f64, ContactError> {
        let approach = self.lattice.approach() - apart;
        if approach <= 0.0 {
            return Ok(0.0);
        }
        let free = Rolling::along(Direction::X);
        Ok(self.contact(free, approach, (bodies, &[None, None]))?.solve()?.load())
    }

    /// Presses the bodies together and rolls them, where others have pressed them apart by so much (m).
    pub fn press(
        self,
        search: &Search<'_>,
        (velocity, bodies): (&Velocity, &Bodies),
        apart: f64,
    ) -> Result<Pressed, ContactError> {
        let approach = self.lattice.approach();
        let creepage = Creepage::new(search, &self.patch, velocity, approach);
        if approach <= apart {
            return Ok(self.light(creepage));
        }
        let rolling = Rolling::along(Direction::X)
            .longitudinal(Drive::Slip(creepage.longitudinal))
            .lateral(Drive::Slip(creepage.lateral))
            .spin(creepage.spin)
            .at_speed(creepage.speed);
        let mut builder = self.contact(rolling, approach - apart, (bodies, &bodies.wear))?;
        builder.friction = Some(bodies.friction.clone());
        let contact = builder.solve()?;
        let wears = bodies.wear.iter().any(Option::is_some);
        let worn = if wears { contact.passage()? } else { vec![] };
        let (problem, state) = (contact.problem(), contact.state());
        let drives = problem.motion.driven(0.0).unwrap_or(Drives::FREE);
        let (frame, tangential) = (&problem.frame, state.tangential.as_ref());
        let rows = (0..frame.len()).filter(|&pair| state.pressure[pair] > 0.0);
        let angle_spread = self.spread(search, rows.map(|pair| pair / self.lattice.elements[0]))?;
        let spacing = frame.spacing();
        let touching = |field: &[f64], factor: f64| {
            let value = |(value, pressure): (&f64, &f64)| {
                if *pressure > 0.0 { factor * value } else { 0.0 }
            };
            field.iter().zip(&state.pressure).map(value).collect::<Vec<f64>>()
        };
        let none = || [vec![0.0; frame.len()], vec![0.0; frame.len()]];
        let map = PatchMap {
            origin: frame.rectangle().corner(),
            spacing,
            elements: frame.elements(),
            pressure: state.pressure.clone(),
            // Known is what acts on the wheel, and how far the rail slips over it from element to element.
            traction: tangential
                .map_or_else(none, |of| of.traction.each_ref().map(|one| touching(one, -1.0))),
            slip: tangential.map_or_else(none, |of| {
                of.slip.each_ref().map(|one| touching(one, -1.0 / spacing[0]))
            }),
        };
        Ok(Pressed {
            map,
            approach,
            normal: contact.load(),
            tangential: contact.force().map(|force| -force),
            moment: tangential.map_or(0.0, |of| -of.moment(frame)),
            peak: contact.peak_pressure(),
            area: contact.area(),
            power: tangential.map_or(0.0, |of| of.creep_power(problem, &drives) * creepage.speed),
            angle_spread,
            worn,
            patch: self.patch,
            creepage,
        })
    }

    /// How much the inclination of the rail (rad) differs over the rows in contact, which may not reach the end of a profile.
    fn spread(
        &self,
        search: &Search<'_>,
        rows: impl Iterator<Item = usize>,
    ) -> Result<f64, ContactError> {
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        let ends = [0, self.lattice.elements[1] - 1];
        for row in rows {
            if (0..2).any(|end| self.patch.cut[end] && row == ends[end]) {
                return Err(ContactError::Short { y: self.patch.reference.y });
            }
            let aside = self.lattice.across(row) * self.patch.angle.cos();
            if let Some(angle) = search.inclination(self.patch.reference.y + aside) {
                (least, most) = (least.min(angle), most.max(angle));
            }
        }
        Ok((most - least).max(0.0))
    }

    /// The patch where it bears nothing.
    fn light(self, creepage: Creepage) -> Pressed {
        Pressed {
            patch: self.patch,
            creepage,
            approach: 0.0,
            normal: 0.0,
            tangential: [0.0; 2],
            moment: 0.0,
            peak: 0.0,
            area: 0.0,
            power: 0.0,
            angle_spread: 0.0,
            worn: vec![],
            map: PatchMap::default(),
        }
    }

    fn contact(
        &self,
        rolling: Rolling,
        approach: f64,
        (bodies, wear): (&Bodies, &Wear),
    ) -> Result<Builder, ContactError> {
        let Lattice { rectangle, elements, .. } = self.lattice;
        let frame = ContactFrame::uniform(rectangle, elements, [&self.lattice, &Flat]);
        let frame = frame.map_err(Refused::from)?.closed();
        let compliance = HalfSpace::new([Some(&bodies.wheel), Some(&bodies.rail)], &frame);
        let mut wheel = Body::new("wheel", self.lattice.clone()).material(bodies.wheel);
        let mut rail = Body::new("rail", Flat).material(bodies.rail);
        [wheel.wear, rail.wear] = wear.clone();
        let rolls = Contact::rolling([wheel, rail], rolling, Control::Approach(approach));
        Ok(rolls.map_err(Refused::from)?.contact(frame, compliance))
    }
}
