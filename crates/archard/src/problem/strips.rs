//! What strips of a line of contact neglect: that they press on one another.
//!
//! A strip of the length h under a load F' per length that differs from the mean by dF' displaces one at a distance d along the line by
//! that of a line load on a half-space (K. L. Johnson, *Contact Mechanics*, section 3.6), and itself by less than in plane strain, which
//! counts from the depth D of the bodies. With S = (1 - nu^2)/(pi E), a sum over the bodies,
//!
//! ```text
//! from others   S dF' ln((d + h/2)/(d - h/2))        from itself   S dF' {2 ln(h/D) + 1/(1 - nu)}
//! ```
//!
//! The load follows by what a strip of the half-width a yields to: S {2 ln(2 D/a) - 1/(1 - nu)}, the slope of Hertz's approach. All have the
//! mean half-width.

use super::ContactProblem;
use crate::body::{Body, Material};

impl ContactProblem {
    /// By how much the load per length of a strip would differ, over the mean of all strips, if they pressed on one another under these
    /// pressures (Pa): the largest of all strips, to first order. `None` on frames without strips.
    pub fn strips_neglect(&self, pressure: &[f64]) -> Option<f64> {
        let frame = &self.frame;
        let ([along, strips], [width, length]) = (frame.elements(), frame.spacing());
        if !frame.is_line() || strips == 1 {
            return None;
        }
        let rows = pressure.chunks(along);
        let loads: Vec<f64> = rows.map(|row| width * row.iter().sum::<f64>()).collect();
        let mean = loads.iter().sum::<f64>() / strips as f64;
        let depths = Body::depths(self.bodies.each_ref(), frame.size()[0]);
        let sum = |part: &dyn Fn(&Material, f64) -> f64| -> f64 {
            let bodies = self.bodies.iter().zip(depths);
            let own = |(body, depth): (&Body, f64)| {
                let material = body.material.as_ref()?;
                Some(material.plane_strain_compliance() * part(material, depth))
            };
            bodies.filter_map(own).sum()
        };
        let all = sum(&|_, _| 1.0);
        let itself =
            sum(&|material, depth| 2.0 * (length / depth).ln() + (1.0 - material.poisson).recip());
        let pressed = pressure.iter().filter(|one| **one > 0.0).count();
        let half_width = 0.5 * width * pressed as f64 / strips as f64;
        let yields = sum(&|material, depth| {
            2.0 * (2.0 * depth / half_width).ln() - (1.0 - material.poisson).recip()
        });
        let neglected = |strip: usize| {
            let from = |other: usize| {
                let apart = strip.abs_diff(other) as f64;
                let of_one = match other == strip {
                    true => itself,
                    false => all * ((apart + 0.5) / (apart - 0.5)).ln(),
                };
                (loads[other] - mean) * of_one
            };
            ((0..strips).map(from).sum::<f64>() / (yields * mean)).abs()
        };
        (mean > 0.0).then(|| (0..strips).map(neglected).fold(0.0, f64::max))
    }
}
