//! What can be known of a case before it is run: closed forms, cost, and what is doubtful.

mod contact;
mod creep;
mod cycles;
mod forecast;
mod geometry;
mod judge;
mod partial_slip;
mod rolling;
mod shift;
mod words;

pub use contact::{Contact, Worn};
pub use creep::{Creep, Track};
pub use cycles::Cycles;
pub(super) use forecast::BYTES_A_PAIR;
pub use forecast::{Forecast, Solves};
pub use partial_slip::{Fretting, FrettingWear};

use super::definition::Case;
use super::problem::Problem;
use crate::body::{Profile, contact_modulus};
use crate::closed_form::free_rolling;
use crate::friction::Friction;
use crate::kinematics::Motion;
use crate::parameters::Invalid;
use crate::wear::WearLaw;

/// The parts of a case, built.
struct Parts<'a> {
    case: &'a Case,
    profiles: [Box<dyn Profile>; 2],
    wear: [Option<Box<dyn WearLaw>>; 2],
    friction: Option<Box<dyn Friction>>,
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
            friction: case.friction.as_ref().map(|friction| friction.build()).transpose()?,
            motion: case.motion.build()?,
        })
    }

    /// Contact modulus E* (Pa).
    fn contact_modulus(&self) -> f64 {
        contact_modulus(self.case.bodies.each_ref().map(|body| body.material.as_ref()))
    }

    /// Shear moduli (Pa), infinite for a rigid body, and Poisson ratios.
    fn elasticity(&self) -> ([f64; 2], [f64; 2]) {
        let materials = self.case.bodies.each_ref().map(|body| body.material);
        (
            materials.map(|material| material.map_or(f64::INFINITY, |one| one.shear_modulus())),
            materials.map(|material| material.map_or(0.0, |one| one.poisson)),
        )
    }

    /// Dundurs' constant beta; zero for bodies of one material.
    fn dundurs_beta(&self) -> f64 {
        let (moduli, poissons) = self.elasticity();
        free_rolling::dundurs_beta(moduli, poissons)
    }

    /// Curvatures of both bodies together along x and y (1/m), where both have them.
    fn curvatures(&self) -> Option<[f64; 2]> {
        if !self.plane() {
            return None;
        }
        let [first, second] = [self.profiles[0].curvatures()?, self.profiles[1].curvatures()?];
        Some([first[0] + second[0], first[1] + second[1]])
    }

    /// Whether the meshes, if there are any, are plane where the bodies touch.
    fn plane(&self) -> bool {
        let mut meshes = self.case.bodies.iter().filter_map(|body| body.finite.as_ref());
        meshes.all(|finite| finite.mesh.choice.name == "box")
    }

    /// Largest tangential traction over the pressure (Pa); zero without friction.
    fn friction_coefficient(&self, pressure: f64) -> f64 {
        self.friction.as_ref().map_or(0.0, |friction| friction.limit(pressure) / pressure)
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
