//! How a contact changes with its load.

use super::contact::Contact;
use super::error::Error;
use crate::motion::Control;
use crate::numerics::vector::in_pool;
use crate::solve::{self, Status, Step};

/// Derivatives of a contact by its load; of a line of contact by that per length (N/m).
#[derive(Debug, Clone, PartialEq)]
pub struct ByLoad {
    /// Of the pressure (Pa/N), one value a pair.
    pub pressure: Vec<f64>,
    /// Of the approach (m/N): one over the stiffness of the contact.
    pub approach: f64,
}

impl Contact {
    /// Derivatives by the load, exact for the elements: pressures vanish at the edge, so that a little more load leaves the pairs in
    /// contact as they are and presses all of them equally far, as a flat punch of their shape would. `None` where pairs yield or lose
    /// pressure as the load grows, where friction moves the pressures, and on conforming surfaces.
    ///
    /// # Errors
    /// If the solve does not converge.
    pub fn by_load(&self) -> Result<Option<ByLoad>, Error> {
        let (problem, state) = (self.problem(), self.state());
        let hardness = problem.hardness();
        let coupled = state.tangential.is_some() && problem.compliance.couples();
        let wrapped = problem.frame.wrap().is_some();
        if coupled || wrapped || state.pressure.iter().any(|pressure| *pressure >= hardness) {
            return Ok(None);
        }
        let measure = problem.frame.measure();
        // The force over the stiffness is the approach of bodies that are flat, and less than that of all others, which stiffen.
        let open = |pair: usize| 2.0 * state.approach.abs() * measure.closing.at(pair);
        let pairs = 0..state.pressure.len();
        let gap: Vec<f64> =
            pairs.map(|pair| if state.pressure[pair] > 0.0 { 0.0 } else { open(pair) }).collect();
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
        let pressure = found.pressure.iter().map(|pressure| pressure / state.load).collect();
        Ok(Some(ByLoad { pressure, approach: found.approach / state.load }))
    }
}
