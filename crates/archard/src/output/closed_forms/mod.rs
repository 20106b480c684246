//! What closed forms say of a run, with the numbers they start from.

mod shifted;

use std::cell::OnceCell;

use serde_json::{Value, json};

use super::coefficients;
use crate::body::{Body, contact_modulus};
use crate::closed_form::hertz::{Hertz, Line};
use crate::closed_form::spence::Indentation;
use crate::closed_form::{carter, pin_on_disc, strip, twin_discs};
use crate::motion::{Drive, Rolling};
use crate::problem::ContactProblem;
use crate::simulation::Report;

/// Closed forms of bodies with curvatures: Hertz at the last load; for a sphere rubbed flat, the
/// paper's eq. 55; in rolling, Carter's saturation, the stick of strips and the models of twin discs; for
/// spheres that are pressed and shifted, Cattaneo and Mindlin, Spence, and the end of fretting wear.
#[derive(Debug, Default)]
pub(super) struct ClosedForms {
    /// Spence's sphere, which takes long to find and is the same for all of a run.
    spence: OnceCell<Option<Indentation>>,
}

impl ClosedForms {
    /// What they say of a report.
    pub(super) fn of(&self, report: &Report<'_>) -> Value {
        of(report, &self.spence)
    }
}

/// The blocks of a report.
fn of(report: &Report<'_>, spence: &OnceCell<Option<Indentation>>) -> Value {
    let Report { problem, state, .. } = report;
    let [Some(one), Some(other)] = problem.bodies.each_ref().map(Body::curvatures) else {
        return Value::Null;
    };
    let curvatures = [one[0] + other[0], one[1] + other[1]];
    let modulus = contact_modulus(problem.bodies.each_ref().map(|body| body.material.as_ref()));
    let mut block = json!({ "curvatures_per_m": curvatures, "contact_modulus_Pa": modulus });
    let hertz = Hertz::from_load(curvatures, modulus, state.load);
    if let Some(hertz) = hertz {
        block["hertz"] = json!({
            "load_N": hertz.load,
            "semi_axes_m": hertz.semi_axes,
            "peak_pressure_Pa": hertz.peak_pressure,
            "approach_m": hertz.approach,
        });
    }
    let contact = Contact { problem, curvatures, modulus, hertz };
    let added = match (problem.motion.rolling(), problem.motion.shift()) {
        (Some(rolling), _) => contact.rolling(report, &rolling.at(state.progress)),
        (None, Some(shift)) => contact.shifted(report, shift, spence),
        (None, None) => vec![("pin_on_disc", contact.pin_on_disc(report))],
    };
    for (name, found) in added {
        if let Some(found) = found {
            block[name] = found;
        }
    }
    block
}

/// The unworn contact.
struct Contact<'a> {
    problem: &'a ContactProblem,
    /// Combined curvatures along x and y (1/m).
    curvatures: [f64; 2],
    /// Contact modulus (Pa).
    modulus: f64,
    /// Where it is an ellipse.
    hertz: Option<Hertz>,
}

impl Contact<'_> {
    /// The combined radius (m) of a sphere.
    fn radius(&self) -> Option<f64> {
        let [along_x, along_y] = self.curvatures;
        let spherical = along_x > 0.0 && (along_x - along_y).abs() <= 1e-9 * along_x;
        spherical.then(|| 1.0 / along_x)
    }

    /// A sphere that slides.
    fn pin_on_disc(&self, report: &Report<'_>) -> Option<Value> {
        let worn = coefficients::of_all_wear(self.problem);
        if worn <= 0.0 || self.problem.motion.slip(1.0) <= 0.0 {
            return None;
        }
        let (radius, volume) = (self.radius()?, worn * report.effort.load_distance);
        Some(json!({
            "radius_m": radius,
            "coefficient_per_Pa": worn,
            "volume_m3": volume,
            "depth_m": pin_on_disc::depth(radius, volume),
        }))
    }

    /// Blocks of bodies that roll.
    fn rolling(
        &self,
        report: &Report<'_>,
        rolling: &Rolling,
    ) -> Vec<(&'static str, Option<Value>)> {
        let saturation = self.saturation(report.state.load, rolling);
        vec![
            ("strip", saturation.as_ref().and_then(|carter| self.strip(carter, rolling))),
            ("carter", saturation.map(|carter| carter.block())),
            ("twin_discs", self.twin_discs(report, rolling)),
        ]
    }

    /// Carter's cylinders: those of the middle strip of an ellipse, or the bodies themselves.
    fn saturation(&self, load: f64, rolling: &Rolling) -> Option<Carter> {
        let friction = coefficients::of_friction(self.problem).filter(|mu| *mu > 0.0)?;
        let axis = rolling.direction.axis;
        let curvature = self.curvatures[axis];
        let half_width = match self.hertz {
            Some(hertz) => hertz.semi_axes[axis],
            None if self.curvatures[1 - axis] == 0.0 => {
                let length = self.problem.frame.size()[1 - axis];
                Line::from_load(curvature, self.modulus, load / length)?.half_width
            }
            None => return None,
        };
        Some(Carter { friction, half_width, radius: 1.0 / curvature })
    }

    /// What sticks of an ellipse under the given creepage.
    fn strip(&self, carter: &Carter, rolling: &Rolling) -> Option<Value> {
        self.hertz?;
        let creepage = straight(rolling).filter(|[_, lateral]| *lateral == 0.0)?[0];
        let relative = creepage.abs() / carter.saturation();
        Some(json!({
            "relative_creepage": relative,
            "stick_share": strip::stick_share(relative),
        }))
    }

    /// Crowned discs that wear, taken as sliding all over under the last load from the start on.
    fn twin_discs(&self, report: &Report<'_>, rolling: &Rolling) -> Option<Value> {
        let state = report.state;
        let hertz = self.hertz.filter(|_| !rolling.swept)?;
        let worn = coefficients::of_all_wear(self.problem);
        let [longitudinal, lateral] = straight(rolling)?;
        let (across, creepage) = (1 - rolling.direction.axis, longitudinal.hypot(lateral));
        if worn <= 0.0 || creepage <= 0.0 {
            return None;
        }
        let (crown, half_width) = (1.0 / self.curvatures[across], hertz.semi_axes[across]);
        let (load, revolutions) = (state.load, state.progress);
        let line = twin_discs::depth_of_line_load(worn, creepage, load, crown, revolutions);
        let incremental = twin_discs::depth_of_incremental_model(
            worn,
            creepage,
            load,
            crown,
            half_width,
            revolutions,
        );
        Some(json!({
            "coefficient_per_Pa": worn,
            "creepage": creepage,
            "load_N": load,
            "crown_m": crown,
            "half_width_m": half_width,
            "revolutions": revolutions,
            "line_load_depth_m": line,
            "incremental_depth_m": incremental,
        }))
    }
}

/// Longitudinal and lateral creepage, where they are given and there is no spin.
fn straight(rolling: &Rolling) -> Option<[f64; 2]> {
    match (rolling.longitudinal, rolling.lateral) {
        (Drive::Creepage(longitudinal), Drive::Creepage(lateral)) if rolling.spin == 0.0 => {
            Some([longitudinal, lateral])
        }
        _ => None,
    }
}

/// Cylinders that roll.
struct Carter {
    /// mu.
    friction: f64,
    /// Half width of the contact along the direction of rolling (m).
    half_width: f64,
    /// Combined radius along it (m).
    radius: f64,
}

impl Carter {
    fn saturation(&self) -> f64 {
        carter::saturation_creepage(self.friction, self.half_width, self.radius)
    }

    fn block(&self) -> Value {
        json!({
            "friction_coefficient": self.friction,
            "half_width_m": self.half_width,
            "radius_m": self.radius,
            "saturation_creepage": self.saturation(),
        })
    }
}
