//! How the error of a run behaves in the size of its elements, by its bodies, its motion and its laws.

use crate::body::Body;
use crate::estimate::{Course, Estimator, Subject};
use crate::motion::{Control, Drive, Shift};
use crate::simulation::history::{APPROACH, CREEPAGE, FORCE, LOAD};
use crate::simulation::{Regularity, Simulation};

/// What says how fast the quantities of a run converge.
pub(super) fn regularity(own: &Simulation) -> Regularity {
    let problem = &own.problem;
    Regularity {
        sharpest: Body::sharpest(&problem.bodies),
        centre: centre(&problem.bodies),
        may_stick: problem.motion.driven(0.0).is_some() && !slips(own),
        given: given(own),
        areas: areas(own),
        line: problem.frame.is_line(),
        period: problem.motion.increments().map(Shift::period),
    }
}

/// Whether surfaces that do not yield are smooth at the middle of the frame: given by formulas, and without a tip.
fn centre(bodies: &[Body; 2]) -> bool {
    let measured = |body: &Body| body.profile.places().iter().any(|places| !places.is_empty());
    let regular = |body: &Body| body.hardness.is_none() && !measured(body);
    !has_tip(bodies) && bodies.iter().all(regular)
}

/// The columns of what is prescribed.
fn given(own: &Simulation) -> Vec<&'static str> {
    let normal = match own.schedule.control {
        Control::Load(_) => LOAD,
        Control::Approach(_) => APPROACH,
    };
    let motion = &own.problem.motion;
    let mut drives = motion.driven(0.0).map_or(vec![], |drives| drives.both().to_vec());
    if motion.direction.axis == 1 {
        drives.reverse();
    }
    let drives = drives.into_iter().enumerate();
    let driven = drives.map(|(axis, drive)| match drive {
        Drive::Force(_) => FORCE[axis],
        Drive::Slip(_) => CREEPAGE[axis],
    });
    [normal].into_iter().chain(driven).collect()
}

/// Whether cylinders slip all over by Carter's theory; worn, they slip no less.
fn slips(own: &Simulation) -> bool {
    let course = Course { control: own.schedule.control, progress: 0.0, load_distance: None };
    let rolled = Estimator::default().of(&Subject::from(&own.problem), &course).rolled;
    rolled.is_some_and(|rolled| rolled.line && rolled.stick_share == Some(0.0))
}

/// From where on elements have which area (m^2).
fn areas(own: &Simulation) -> Vec<[f64; 2]> {
    let places = own.frames().filter_map(|one| Some(one.wider.as_ref()?.from));
    let areas = own.frames().map(|one| one.problem.frame.element_area());
    [0.0].into_iter().chain(places).zip(areas).map(<[f64; 2]>::from).collect()
}

/// The order of the error of bodies by which elements are chosen and refined.
pub fn order(bodies: &[Body; 2]) -> f64 {
    if Body::sharpest(bodies) == 0.0 { 1.0 } else { 2.0 }
}

/// Whether a body is sharp, but not along an edge: most happens at the middle of the contact, where elements must not miss it.
pub fn has_tip(bodies: &[Body; 2]) -> bool {
    let sharpest = Body::sharpest(bodies);
    sharpest > 0.0 && sharpest < 2.0
}
