//! A case of two gears in mesh: what to compute, in SI, and what to expect.

mod forecast;
mod meshing;
mod print;

use archard::friction::Friction;
use archard::parameters::{Bound, Choice, Parameter, Quantity};
use archard_gear::{Gear, Mesh, Misfit, Pair, Sharing};

pub use forecast::GearForecast;
pub use meshing::{GearMesh, MESH};

use super::chosen::ChosenPart;
use super::key::Key;
use super::lines;
use super::problem::Problem;
use super::wheel_rail::ProfiledPart;
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
    pub gears: [ProfiledPart<Gear>; 2],
    /// The friction law, where wear laws ask for friction.
    pub friction: Option<ChosenPart<Box<dyn Friction>>>,
    /// How they mesh.
    pub motion: ChosenPart<GearMesh>,
    /// Worn depths (m) that end it, of the first gear and of the second.
    pub until: [Option<f64>; 2],
}

impl GearCase {
    /// The gears under their load, and how they mesh.
    ///
    /// # Errors
    /// If values of the case do not fit together.
    pub fn prepare(&self) -> Result<(Mesh, GearMesh), Problem> {
        let [one, two] = &self.gears;
        let names = [(&*one.name, "involute"), (&*two.name, "involute")];
        let wrong = |error: Misfit| lines::misfit(error, names, "mesh");
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
                return Err(Problem::error(Key::of(["motion", "mesh", "share"]), message));
            }
        }
        let wears = [(&*one.name, &one.wear), (&*two.name, &two.wear)];
        let laws = lines::laws(wears, self.friction.as_ref())?;
        let materials = [&self.gears[0].material, &self.gears[1].material];
        let load = [meshing.torque, meshing.width];
        let mesh =
            Mesh::new(pair, load, materials, meshing.sharing.clone(), laws).map_err(wrong)?;
        lines::hold(
            [&one.name, &two.name],
            mesh.laws.each_ref().map(Option::is_some),
            self.until,
            meshing.meshes,
            [
                "mesh",
                "meshes",
                "how many meshes a flank goes through, since it wears: `meshes`, or `turns` of the first gear",
                "counts for nothing: neither gear has a wear law",
            ],
        )?;
        Ok((mesh, meshing))
    }

    /// What the flanks go through.
    ///
    /// # Errors
    /// If values of the case do not fit together.
    pub fn solve(&self) -> Result<GearResults, Problem> {
        let (mesh, meshing) = self.prepare()?;
        let limits = lines::limits(self.until);
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
