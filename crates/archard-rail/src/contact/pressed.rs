//! One patch in its tangent plane: pressures and friction of half-spaces at a height of the wheel.

use std::sync::Arc;

use glam::DVec3;

use archard::body::profile::Flat;
use archard::compliance::HalfSpace;
use archard::frame::Direction;
use archard::motion::{Control, Drive, Drives, Rolling};
use archard::simulation::{Builder, Refusals};
use archard::{Body, Contact, ContactFrame};

use super::lattice::Lattice;
use super::{Bodies, ContactError, Operation, Wear};
use crate::creepage::Creepage;
use crate::search::{Patch, Search};

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
    /// The largest rise (K) of the temperature, and the Peclet number; `None` where nothing is known of heat, or nothing rubs.
    pub flash: Option<[f64; 2]>,
    /// How much the inclination of the rail (rad) differs within the contact.
    pub angle_spread: f64,
    /// What it was read off, where bodies wear: lines across s wear at each passage.
    pub contact: Option<Arc<Contact>>,
    /// What is known of each element.
    pub map: PatchMap,
}

impl Pressed {
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
            flash: None,
            angle_spread: 0.0,
            contact: None,
            map: PatchMap::default(),
        }
    }

    /// A patch that the wheel at that height (m) misses: it bears nothing, at the place that touches first.
    pub fn missed(search: &Search<'_>, patch: &Patch, height: f64, operation: &Operation) -> Self {
        let patch = search.first_of(patch, height);
        let creepage = Creepage::new(search, &patch, &operation.velocity, 0.0);
        Self::light(patch, creepage.prescribed(operation.creepages[0]))
    }
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
    /// Rise (K) of the temperature of both surfaces above that of the bodies; empty where it is not known.
    pub rise: Vec<f64>,
}

impl PatchMap {
    /// The least and the largest s (m) that touch; `None` where nothing does.
    pub(crate) fn width(&self) -> Option<[f64; 2]> {
        let touches = |row: &usize| {
            let along = self.elements[0];
            self.pressure[row * along..(row + 1) * along].iter().any(|&pressure| pressure > 0.0)
        };
        let rows = || (0..self.elements[1]).filter(touches);
        let edge = |row: usize| self.origin[1] + row as f64 * self.spacing[1];
        Some([edge(rows().next()?), edge(rows().next_back()? + 1)])
    }
}

/// Half of the second derivative of the parabola nearest to places: weights, and abscissas and ordinates from anywhere; 0 of fewer than
/// three.
fn parabola(places: &[(f64, f64, f64)]) -> f64 {
    let mean = |of: &dyn Fn(f64, f64) -> f64| {
        let sum = places.iter().map(|&(weight, x, y)| weight * of(x, y)).sum::<f64>();
        sum / places.iter().map(|(weight, ..)| weight).sum::<f64>()
    };
    let middle = mean(&|x, _| x);
    let width = mean(&|x, _| (x - middle).powi(2));
    // The square less the nearest line of it, which is at right angles to all lines.
    let skew = mean(&|x, _| (x - middle).powi(3)) / width;
    let square = |x: f64| (x - middle).powi(2) - width - skew * (x - middle);
    let found = mean(&|x, y| square(x) * y) / mean(&|x, _| square(x).powi(2));
    if found.is_finite() { found } else { 0.0 }
}

impl Pressed {
    /// What it takes of the vertical load (N).
    pub fn vertical(&self) -> f64 {
        let [x, s] = self.tangential;
        (self.patch.frame() * DVec3::new(x, s, self.normal)).z
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
        (operation, bodies, curved): (&Operation, &Bodies, bool),
        apart: f64,
    ) -> Result<Pressed, ContactError> {
        let approach = self.lattice.approach();
        let creepage = Creepage::new(search, &self.patch, &operation.velocity, approach)
            .prescribed(operation.creepages[0]);
        if approach <= apart {
            return Ok(Pressed::light(self.patch, creepage));
        }
        let rolling = Rolling::along(Direction::X)
            .longitudinal(Drive::Slip(creepage.longitudinal))
            .lateral(Drive::Slip(creepage.lateral))
            .spin(creepage.spin)
            .bow(if curved { self.bow(search) } else { 0.0 })
            .at_speed(creepage.speed);
        let mut builder = self.contact(rolling, approach - apart, (bodies, &bodies.wear))?;
        let y = search.in_wheel(self.patch.reference, self.patch.height).y;
        builder.friction = Some(bodies.friction_at(y).clone());
        let contact = builder.solve()?;
        let wears = bodies.wear.iter().any(Option::is_some);
        let contact = Arc::new(contact);
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
        let flash = problem.flash(state);
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
            rise: flash.as_ref().map_or_else(Vec::new, |flash| flash.rise.clone()),
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
            flash: flash.and_then(|flash| {
                Some([flash.rise.into_iter().fold(0.0, f64::max), flash.peclet?])
            }),
            angle_spread,
            contact: wears.then(|| contact.clone()),
            patch: self.patch,
            creepage,
        })
    }

    /// What the creepage gains with the square of s (1/m^2), as the surface between wheel and rail leaves the tangent plane: a point that
    /// lies lower by dz rolls on a radius larger by dz, and so creeps dz over the radius more, on a roller dz over its radius, too. The
    /// curvature is that of the parabola nearest to the surface, weighted by the overlap.
    fn bow(&self, search: &Search<'_>) -> f64 {
        let cos = self.patch.angle.cos();
        let reference = self.patch.reference;
        let [columns, rows] = self.lattice.elements;
        let place = |row: usize| {
            let overlap = self.lattice.overlap(columns / 2 + columns * row);
            let place = search.on_rail(reference.y + self.lattice.across(row) * cos)?;
            let [s, below] = self.patch.in_the_plane(place);
            // Halfway between both.
            (overlap > 0.0).then_some((overlap, s, below + 0.5 * overlap))
        };
        let places: Vec<(f64, f64, f64)> = (0..rows).filter_map(place).collect();
        let setup = search.setup();
        let rail = setup.roller().curvature(self.patch.on_profile);
        parabola(&places) * cos * (setup.wheelset().nominal_radius.recip() + rail)
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

    fn contact(
        &self,
        rolling: Rolling,
        approach: f64,
        (bodies, wear): (&Bodies, &Wear),
    ) -> Result<Builder, ContactError> {
        let Lattice { rectangle, elements, .. } = self.lattice;
        let frame = ContactFrame::uniform(rectangle, elements, [&self.lattice, &Flat]);
        let frame = frame.map_err(Refusals::from)?.closed();
        let compliance = HalfSpace::new([Some(&bodies.wheel), Some(&bodies.rail)], &frame);
        let mut wheel = Body::new("wheel", self.lattice.clone()).material(bodies.wheel);
        let mut rail = Body::new("rail", Flat).material(bodies.rail);
        [wheel.wear, rail.wear] = wear.clone();
        [wheel.thermal, rail.thermal] = bodies.thermal;
        let rolls = Contact::rolling([wheel, rail], rolling, Control::Approach(approach));
        Ok(rolls.map_err(Refusals::from)?.contact(frame, compliance))
    }
}
