//! How patches with a plane each press the bodies apart at the others.
//!
//! A force F on a half-space sinks its surface at the distance d by (1 - nu^2) F/(pi E d) (Boussinesq). Both bodies
//! together open the gap of another patch by F/(pi E* d), E* the contact modulus. The force stands for the pressures of its
//! patch, which leaves out a part of (size/d)^2; the planes are taken for one.

use std::f64::consts::PI;

use archard::body::contact_modulus;

use super::pressed::Site;
use super::{Bodies, ContactError};

/// Change of the forces relative to their sum at which they agree.
const SETTLED: f64 = 1e-7;
/// Rounds in which they do: a contact of radius a yields 2 E* a, so that each leaves 2a/(pi d) of what was left, less than a
/// third of it.
const MOST: usize = 60;

/// By how much (m) the bodies are pressed apart at each of the patches.
pub(super) fn by_the_others(sites: &[Site], bodies: &Bodies) -> Result<Vec<f64>, ContactError> {
    let mut apart = vec![0.0; sites.len()];
    if sites.len() < 2 {
        return Ok(apart);
    }
    let modulus = contact_modulus([Some(&bodies.wheel), Some(&bodies.rail)]);
    let mut before = vec![0.0; sites.len()];
    for _ in 0..MOST {
        let pressed = sites.iter().zip(&apart).map(|(site, apart)| site.force(bodies, *apart));
        let forces = pressed.collect::<Result<Vec<f64>, _>>()?;
        let opened = |at: usize| {
            let others = (0..sites.len()).filter(|&other| other != at);
            let by = |other: usize| {
                let reference = |at: usize| sites[at].patch.reference;
                forces[other] / (PI * modulus * (reference(at) - reference(other)).length())
            };
            others.map(by).sum::<f64>()
        };
        apart = (0..sites.len()).map(opened).collect();
        let changes = forces.iter().zip(&before).map(|(now, before)| (now - before).abs());
        if changes.sum::<f64>() <= SETTLED * forces.iter().sum::<f64>() {
            return Ok(apart);
        }
        before = forces;
    }
    Err(ContactError::Unsettled)
}
