//! A case of a cam and its follower: what to compute, in SI, and what to expect.

mod forecast;
mod print;
mod shapes;

use archard::friction::Friction;
use archard_gear::Misfit;
use archard_gear::cam::{Cam, Follower, Loading};

pub use forecast::CamForecast;
pub use shapes::{CAM, CAMS, CamDrive, CamShape, FOLLOWERS};

use super::chosen::ChosenPart;
use super::key::Key;
use super::lines;
use super::problem::Problem;
use super::wheel_rail::ProfiledPart;
use crate::output::CamResults;

/// A checked case of a cam and its follower, in SI. It prints as a case file that reads back to the same bits.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq)]
pub struct CamCase {
    /// What it is about.
    pub title: Option<String>,
    /// The cam.
    pub cam: ProfiledPart<CamShape>,
    /// The follower.
    pub follower: ProfiledPart<Follower>,
    /// The friction law, where wear laws ask for friction.
    pub friction: Option<ChosenPart<Box<dyn Friction>>>,
    /// What presses them together, and for how long.
    pub motion: ChosenPart<CamDrive>,
    /// Worn depths (m) that end it, of the cam and of the follower.
    pub until: [Option<f64>; 2],
}

impl CamCase {
    /// The names of cam and follower.
    fn names(&self) -> [String; 2] {
        [self.cam.name.clone(), self.follower.name.clone()]
    }

    /// The cam on its follower, and how many turns it makes.
    ///
    /// # Errors
    /// If values of the case do not fit together.
    pub fn prepare(&self) -> Result<(Cam, Option<f64>), Problem> {
        let Self { cam, follower, .. } = self;
        let profiles = [
            (&*cam.name, cam.profile.choice.name),
            (&*follower.name, follower.profile.choice.name),
        ];
        let file = Key::of(["body", &cam.name, "profile", cam.profile.choice.name, "file"]);
        let wrong = |error: Misfit| match &*error.cause.parameter {
            // The forces are in the table of the lift.
            "load" => Problem::error(file.clone(), error.cause.message),
            _ => lines::misfit(error, profiles, "cam"),
        };
        let of = |body: usize| move |invalid| Misfit::of(body, invalid);
        let shape = cam.profile.build().map_err(of(0)).map_err(wrong)?;
        let face = follower.profile.build().map_err(of(1)).map_err(wrong)?;
        let camming = self.motion.build().map_err(|invalid| wrong(invalid.into()))?;
        let loading = match (shape.loads, camming.loading) {
            (None, Some(loading)) => loading,
            (Some(loads), None) => Loading::Table(loads),
            (None, None) => {
                let message = "what presses the follower on the cam: `preload`, with the `spring` that adds to it, or a column `load_N` in the table of the lift";
                return Err(Problem::missing(Key::of(["motion", "cam", "preload"]), message));
            }
            (Some(_), Some(_)) => {
                let message = "the column `load_N` in the table of the lift says what presses the follower on the cam: give it or this";
                let given = |name: &&str| self.motion.values.number(name).is_some();
                let key = ["preload", "spring", "mass"].into_iter().find(given);
                let key = key.unwrap_or("preload");
                return Err(Problem::error(Key::of(["motion", "cam", key]), message));
            }
        };
        let wears = [(&*cam.name, &cam.wear), (&*follower.name, &follower.wear)];
        let laws = lines::laws(wears, self.friction.as_ref())?;
        let materials = [&cam.material, &follower.material];
        let pair = Cam::new((shape.profile, face), loading, camming.width, materials, laws);
        let pair = pair.map_err(wrong)?;
        lines::hold(
            [&cam.name, &follower.name],
            pair.laws.each_ref().map(Option::is_some),
            self.until,
            camming.turns,
            [
                "cam",
                "turns",
                "how many turns the cam makes, since it or its follower wears",
                "counts for nothing: neither cam nor follower has a wear law",
            ],
        )?;
        Ok((pair, camming.turns))
    }

    /// What cam and follower go through.
    ///
    /// # Errors
    /// If values of the case do not fit together.
    pub fn solve(&self) -> Result<CamResults, Problem> {
        let (cam, turns) = self.prepare()?;
        let limits = lines::limits(self.until);
        let wanted = turns.unwrap_or(0.0);
        let worn = cam.wear(wanted, &limits);
        let hardness = [self.cam.hardness, self.follower.hardness];
        let moduli = [self.cam.material.young, self.follower.material.young];
        Ok(CamResults { names: self.names(), hardness, moduli, cam, worn, wanted, limits })
    }
}

/// The forecast of a case and what is wrong with it.
pub(super) fn check(case: &CamCase) -> (CamForecast, Vec<Problem>) {
    match case.prepare() {
        Ok((cam, _)) => (CamForecast { names: case.names(), cam: Some(cam) }, vec![]),
        Err(problem) => (CamForecast::default(), vec![problem]),
    }
}
