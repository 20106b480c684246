//! How a contact changes with its load and with the shape of the bodies.

use super::contact::Contact;
use super::error::Error;
use crate::motion::Control;
use crate::numerics::vector::in_pool;
use crate::solve::{self, Status, Step};

/// Derivative of a contact by its load (N), of a line of contact by that per length (N/m), or by a parameter of the shape (in its unit).
#[derive(Debug, Clone, PartialEq)]
pub struct Derivative {
    /// Of the pressure (Pa over the unit), one value a pair.
    pub pressure: Vec<f64>,
    /// Of the approach (m over the unit), counted from the first touch of the bodies as they are; by the load it is one over the
    /// stiffness of the contact.
    pub approach: f64,
}

impl Contact {
    /// The derivative by the load, exact for the elements: pressures vanish at the edge, so that a little more load leaves the pairs in
    /// contact as they are and presses all of them equally far, as a flat punch of their shape would. `None` where pairs yield or lose
    /// pressure as the load grows, where friction moves the pressures, and on conforming surfaces.
    ///
    /// # Errors
    /// If the solve does not converge.
    pub fn by_load(&self) -> Result<Option<Derivative>, Error> {
        let flat = self.on_the_pairs(&vec![0.0; self.pressure().len()])?;
        Ok(flat.map(|(pressure, approach)| {
            let pressure = pressure.iter().map(|pressure| pressure / self.load()).collect();
            Derivative { pressure, approach: approach / self.load() }
        }))
    }

    /// The derivative by a parameter of the shape at the same load: `gap` is the derivative of the gap by it (m over its unit, positive
    /// where bodies part), one value a pair, such as -(x^2 + y^2) / (2 R^2) by the radius of a ball. The depth that both bodies lose
    /// over a distance, k p by Archard, gives the derivative by that distance. Known as [by the load](Self::by_load), and exact to the
    /// root of the solver's tolerance: a difference of solves on the same pairs, which are linear.
    ///
    /// # Errors
    /// If the solve does not converge.
    ///
    /// # Panics
    /// If there is not one finite value a pair.
    pub fn by_shape(&self, gap: &[f64]) -> Result<Option<Derivative>, Error> {
        let state = self.state();
        assert_eq!(gap.len(), state.pressure.len(), "one value a pair");
        assert!(gap.iter().all(|value| value.is_finite()), "finite values");
        let Some((flat, depth)) = self.on_the_pairs(&vec![0.0; gap.len()])? else {
            return Ok(None);
        };
        let touching = |pair: &usize| state.pressure[*pair] > 0.0;
        let most = (0..gap.len()).filter(touching).map(|pair| gap[pair].abs()).fold(0.0, f64::max);
        if most == 0.0 {
            return Ok(Some(Derivative { pressure: vec![0.0; gap.len()], approach: 0.0 }));
        }
        // A change so small that the load presses all pairs on in spite of it, and so large that half of the digits of a solve are left.
        let tolerance = self.simulation.solver.settings().tolerance;
        let mut part: f64 = 1.0;
        while part.powi(2) > tolerance {
            let change = part * depth / most;
            let changed: Vec<f64> = gap.iter().map(|own| change * own).collect();
            if let Some((pressure, approach)) = self.on_the_pairs(&changed)? {
                let pairs = pressure.iter().zip(&flat);
                let pressure = pairs.map(|(pressure, flat)| (pressure - flat) / change).collect();
                return Ok(Some(Derivative { pressure, approach: (approach - depth) / change }));
            }
            part *= 0.5;
        }
        Ok(None)
    }

    /// Pressures (Pa) and approach (m) under the load where the pairs in contact stay as they are over that gap (m), which all others
    /// have far wider; `None` where some of them would part, and where they are not known.
    fn on_the_pairs(&self, gap: &[f64]) -> Result<Option<(Vec<f64>, f64)>, Error> {
        let (problem, state) = (self.problem(), self.state());
        let hardness = problem.hardness();
        let coupled = state.tangential.is_some() && problem.compliance.couples();
        let wrapped = problem.frame.wrap().is_some();
        if coupled || wrapped || state.pressure.iter().any(|pressure| *pressure >= hardness) {
            return Ok(None);
        }
        let measure = problem.frame.measure();
        let touches = |pair: usize| state.pressure[pair] > 0.0;
        let pairs = 0..gap.len();
        let widest =
            pairs.clone().filter(|pair| touches(*pair)).map(|pair| gap[pair]).fold(0.0, f64::max);
        // The force over the stiffness is the approach of bodies that are flat, and less than that of all others, which stiffen.
        let open = |pair: usize| 2.0 * (state.approach.abs() * measure.closing.at(pair) + widest);
        let gap: Vec<f64> =
            pairs.map(|pair| if touches(pair) { gap[pair] } else { open(pair) }).collect();
        let step = Step {
            compliance: &*problem.compliance,
            gap: &gap,
            addition: &vec![0.0; gap.len()],
            elements: problem.frame.elements(),
            measure,
            control: Control::Load(state.load),
            hardness: f64::INFINITY,
        };
        let solver = &*self.simulation.solver;
        let found = in_pool(|| solve::press(solver, &step, None));
        let same = |(now, then): (&f64, &f64)| (*now > 0.0) == (*then > 0.0);
        match found.status {
            Status::Converged if found.pressure.iter().zip(&state.pressure).all(same) => {}
            Status::OutOfIterations => {
                return Err(Error::NotConverged {
                    measure: problem.motion.progress,
                    progress: state.progress,
                    iterations: found.iterations,
                    residual: found.residual,
                    tolerance: solver.settings().tolerance,
                });
            }
            _ => return Ok(None),
        }
        Ok(Some((found.pressure, found.approach)))
    }
}
