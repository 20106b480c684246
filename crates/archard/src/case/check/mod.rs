//! What can be known of a case before it is run: closed forms, cost, and what is doubtful.

mod contact;
mod forecast;
mod geometry;
mod judge;
mod words;

pub use contact::{Contact, Worn};
pub(super) use forecast::BYTES_A_PAIR;
pub use forecast::{Forecast, Solves};

use super::definition::Case;
use super::problem::Problem;
use crate::body::{Profile, contact_modulus};
use crate::kinematics::Motion;
use crate::parameters::Invalid;
use crate::wear::WearLaw;

/// The parts of a case, built.
struct Parts<'a> {
    case: &'a Case,
    profiles: [Box<dyn Profile>; 2],
    wear: [Option<Box<dyn WearLaw>>; 2],
    motion: Motion,
}

impl<'a> Parts<'a> {
    fn of(case: &'a Case) -> Result<Self, Invalid> {
        let [first, second] = &case.bodies;
        let wear = |body: &super::BodyCase| body.wear.as_ref().map(|wear| wear.build()).transpose();
        Ok(Self {
            case,
            profiles: [first.profile.build()?, second.profile.build()?],
            wear: [wear(first)?, wear(second)?],
            motion: case.motion.build()?,
        })
    }

    /// Contact modulus E* (Pa).
    fn contact_modulus(&self) -> f64 {
        contact_modulus(self.case.bodies.each_ref().map(|body| body.material.as_ref()))
    }

    /// Curvatures of both bodies together along x and y (1/m), where both have them.
    fn curvatures(&self) -> Option<[f64; 2]> {
        let [first, second] = [self.profiles[0].curvatures()?, self.profiles[1].curvatures()?];
        Some([first[0] + second[0], first[1] + second[1]])
    }

    /// Distance slid in the whole motion (m).
    fn slip(&self) -> f64 {
        self.motion.kinematics.slip(self.motion.extent)
    }
}

/// The forecast of a case and what is wrong or doubtful with it.
pub(super) fn check(case: &Case) -> (Forecast, Vec<Problem>) {
    match Parts::of(case) {
        Ok(parts) => {
            let forecast = Forecast::of(&parts);
            let problems = geometry::problems(&parts);
            let problems =
                if problems.is_empty() { judge::problems(&parts, &forecast) } else { problems };
            (forecast, problems)
        }
        // A case that was read has been built once already.
        Err(invalid) => {
            let problem = Problem::error(super::Key::default(), invalid.message);
            (Forecast::default(), vec![problem])
        }
    }
}
