//! A case of two gears in mesh: what to compute, in SI, and what to expect.

mod forecast;
mod meshing;
mod print;

use std::sync::Arc;

use archard::friction::Friction;
use archard::parameters::{Bound, Choice, Parameter, Quantity};
use archard::wear::WearLaw;
use archard_gear::{Gear, Limit, Mesh, Misfit, Pair, Sharing};

pub use forecast::GearForecast;
pub use meshing::{MESH, Meshing};

use super::chosen::Chosen;
use super::key::Key;
use super::problem::Problem;
use super::wheel_rail::Rolled;
use crate::output::GearResults;

/// The profiles of gears.
pub const GEARS: &[Choice<Gear>] = &[Choice {
    name: "involute",
    meaning: "a spur gear with involute flanks (ISO 21771)",
    parameters: &[
        Parameter::required("module", Quantity::Length, "module"),
        Parameter::required("teeth", Quantity::Count, "number of teeth"),
        Parameter::optional(
            "shift",
            Quantity::Number,
            "profile shift over the module; 0 if not given",
        )
        .bound(Bound::Any),
        Parameter::required("tip_diameter", Quantity::Length, "diameter of the tips"),
        Parameter::optional(
            "pressure_angle",
            Quantity::Angle,
            "pressure angle of the reference profile; 20 degrees if not given",
        ),
    ],
    build: |values| {
        let gear = Gear {
            module: values.require("module")?,
            teeth: values.require("teeth")?,
            shift: values.number("shift").unwrap_or(0.0),
            tip_diameter: values.require("tip_diameter")?,
            pressure_angle: values.number("pressure_angle").unwrap_or(20f64.to_radians()),
        };
        gear.checked()?;
        Ok(gear)
    },
}];

/// A checked case of two gears, in SI. It prints as a case file that reads back to the same bits.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq)]
pub struct GearCase {
    /// What it is about.
    pub title: Option<String>,
    /// Both gears; the first drives.
    pub gears: [Rolled<Gear>; 2],
    /// The friction law, where wear laws ask for friction.
    pub friction: Option<Chosen<Box<dyn Friction>>>,
    /// How they mesh.
    pub motion: Chosen<Meshing>,
    /// Worn depths (m) that end it, of the first gear and of the second.
    pub until: [Option<f64>; 2],
}

impl GearCase {
    /// The gears under their load, and how they mesh.
    ///
    /// # Errors
    /// If values of the case do not fit together.
    pub fn prepare(&self) -> Result<(Mesh, Meshing), Problem> {
        let motion = Key::of(["motion", "mesh"]);
        let wrong = |error: Misfit| {
            let key = match error.body {
                Some(gear) if error.cause.parameter == "wear" => {
                    return Problem::error(
                        Key::of(["body", &self.gears[gear].name, "wear"]),
                        error.cause.message,
                    );
                }
                Some(gear) => Key::of(["body", &self.gears[gear].name, "profile", "involute"]),
                None if error.cause.parameter == "friction" => {
                    return Problem::error(Key::of(["friction"]), error.cause.message);
                }
                None => motion.clone(),
            };
            Problem::error(key.child(&error.cause.parameter), error.cause.message)
        };
        let meshing = self.motion.build().map_err(|invalid| wrong(invalid.into()))?;
        let gear = |which: usize| {
            self.gears[which].profile.build().map_err(|invalid| wrong(Misfit::of(which, invalid)))
        };
        let pair = Pair::new([gear(0)?, gear(1)?], meshing.centre_distance).map_err(wrong)?;
        if let Sharing::Table(rows) = &meshing.sharing {
            let [first, last] = [rows[0][0], rows[rows.len() - 1][0]];
            // `check` prints places to a tenth of a micrometre.
            let within = 0.5e-7;
            if first > pair.start + within || last < pair.end - within {
                let message = format!(
                    "the shares are those of {:.4} to {:.4} mm of the path, teeth touch from {:.4} to {:.4} mm",
                    1e3 * first,
                    1e3 * last,
                    1e3 * pair.start,
                    1e3 * pair.end
                );
                return Err(Problem::error(motion.child("share"), message));
            }
        }
        let law = |which: usize| -> Result<Option<Arc<dyn WearLaw>>, Problem> {
            let Rolled { name, wear, .. } = &self.gears[which];
            let Some(law) = wear else { return Ok(None) };
            let key = Key::of(["body", name, "wear", law.choice.name]);
            let built = law.build().map_err(|invalid| {
                Problem::error(key.child(&invalid.parameter), invalid.message)
            })?;
            Ok(Some(Arc::from(built)))
        };
        let laws = [law(0)?, law(1)?];
        let friction = self.friction.as_ref().map(|law| -> Result<Arc<dyn Friction>, Problem> {
            let key = Key::of(["friction", law.choice.name]);
            let built = law.build().map_err(|invalid| {
                Problem::error(key.child(&invalid.parameter), invalid.message)
            })?;
            Ok(Arc::from(built))
        });
        let friction = friction.transpose()?;
        let materials = [&self.gears[0].material, &self.gears[1].material];
        let load = [meshing.torque, meshing.width];
        let mesh = Mesh::new(pair, load, materials, meshing.sharing.clone(), (friction, laws))
            .map_err(wrong)?;
        self.hold(&mesh, &meshing)?;
        Ok((mesh, meshing))
    }

    /// Refuses meshes that wear nothing, and wear of no meshes.
    fn hold(&self, mesh: &Mesh, meshing: &Meshing) -> Result<(), Problem> {
        let wears = mesh.laws.iter().any(Option::is_some);
        if wears && meshing.meshes.is_none() {
            let message = "how many meshes a flank goes through, since it wears: `meshes`, or `turns` of the first gear";
            return Err(Problem::missing(Key::of(["motion", "mesh", "meshes"]), message));
        }
        if !wears && meshing.meshes.is_some() {
            let message = "counts for nothing: neither gear has a wear law";
            return Err(Problem::error(Key::of(["motion", "mesh", "meshes"]), message));
        }
        for (which, limit) in self.until.iter().enumerate() {
            if limit.is_some() && mesh.laws[which].is_none() {
                let name = &self.gears[which].name;
                let message = format!("`{name}` has no wear law: it reaches no limit");
                return Err(Problem::error(Key::of(["until"]), message));
            }
        }
        Ok(())
    }

    /// What the flanks go through.
    ///
    /// # Errors
    /// If values of the case do not fit together.
    pub fn solve(&self) -> Result<GearResults, Problem> {
        let (mesh, meshing) = self.prepare()?;
        let limit = |gear: usize| Some(Limit { body: gear, depth: self.until[gear]? });
        let limits: Vec<Limit> = (0..2).filter_map(limit).collect();
        let meshes = meshing.meshes.unwrap_or(0.0);
        let worn = mesh.wear(meshes, meshing.of_gear_two(&mesh.pair), &limits);
        let names = self.gears.each_ref().map(|gear| gear.name.clone());
        let hardness = self.gears.each_ref().map(|gear| gear.hardness);
        let moduli = self.gears.each_ref().map(|gear| gear.material.young);
        Ok(GearResults { names, hardness, moduli, mesh, worn, wanted: meshes, limits })
    }
}

/// The forecast of a case and what is wrong with it.
pub(super) fn check(case: &GearCase) -> (GearForecast, Vec<Problem>) {
    match case.prepare() {
        Ok((mesh, _)) => {
            let names = case.gears.each_ref().map(|gear| gear.name.clone());
            (GearForecast { names, mesh: Some(mesh) }, vec![])
        }
        Err(problem) => (GearForecast::default(), vec![problem]),
    }
}
