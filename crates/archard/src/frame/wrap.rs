//! A uniform frame that is drawn on the round surface of bodies that fit into each other.
//!
//! With theta the angle from the pole, c the clearance and d the approach, the gap between a ball and its socket, or between a shaft
//! and its bush, is c (1 - cos theta) - d cos theta up to terms of the order of c/R: on Lambert's map of a sphere a paraboloid. The
//! approach closes each gap by cos theta, and a pressure bears as much of the load.

use std::f64::consts::PI;

use crate::body::Profile;
use crate::body::profile::Round;

/// What the frame is drawn on: the surface of the inner body, which the outer one meets where they touch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wrap {
    /// What the surface is a part of.
    pub round: Round,
    /// Its radius (m).
    pub radius: f64,
    /// How much larger the radius of the hollow is (m).
    pub clearance: f64,
    /// The body that is hollow: 0 or 1.
    pub hollow: usize,
    /// Angle (rad) from the pole to the nearest place of its rim.
    pub rim: f64,
}

impl Wrap {
    /// That of two profiles, one of them made to fit into the other; `None` of others.
    pub fn of(profiles: [&dyn Profile; 2]) -> Option<Self> {
        let [one, two] = profiles.map(Profile::fitted);
        let (one, two) = (one?, two?);
        let hollow = usize::from(two.hollow);
        let [inner, outer] = if hollow == 1 { [one, two] } else { [two, one] };
        let clearance = outer.radius - inner.radius;
        let fits = outer.hollow && !inner.hollow && clearance > 0.0 && one.round == two.round;
        let (radius, rim) = (inner.radius, outer.rim);
        fits.then_some(Self { round: one.round, radius, clearance, hollow, rim })
    }

    /// The cosine of the angle from the pole at a place (m): how much of the approach closes the gap there. Not a number beyond the
    /// surface.
    pub fn closing(&self, place: [f64; 2]) -> f64 {
        self.round.cosine(self.radius, place)
    }

    /// What the coordinates of the frame are, in words.
    pub fn coordinates(&self) -> String {
        let radius = (1e9 * self.radius).round() * 1e-6;
        match self.round {
            Round::Sphere => format!(
                "x and y lie on Lambert's map of the sphere of {radius} mm, which keeps areas: r = 2 R sin(theta/2) from the pole; depths and pressures are normal to the sphere"
            ),
            Round::Cylinder => format!(
                "x is the arc R theta on the cylinder of {radius} mm; depths and pressures are normal to it"
            ),
        }
    }

    /// The angle (rad) from the pole to the edge of a contact about it, by its area (m^2) on the surface; of a line of contact by its
    /// area over its length.
    pub fn edge(&self, area: f64) -> f64 {
        match self.round {
            Round::Sphere => 2.0 * (0.5 * (area / PI).sqrt() / self.radius).min(1.0).asin(),
            Round::Cylinder => 0.5 * area / self.radius,
        }
    }

    /// The gap (m) at a place (m) where the bodies touch at the pole.
    pub(crate) fn gap(&self, place: [f64; 2]) -> f64 {
        self.clearance * (1.0 - self.closing(place))
    }

    /// Unit vectors along both axes of the frame and away from the centre at a place (m), in axes whose third goes from the
    /// centre to the pole.
    pub fn outwards(&self, place: [f64; 2]) -> [[f64; 3]; 3] {
        Self { hollow: 1, ..*self }.basis(place)
    }

    /// The place (m) on a sphere in a direction from its centre, as [`Wrap::outwards`] has it; that straight down lies at no place of
    /// its own and is taken to lie along x.
    pub fn place(&self, [x, y, z]: [f64; 3]) -> [f64; 2] {
        let (across, far) = (x.hypot(y), self.radius * (2.0 * (1.0 - z)).max(0.0).sqrt());
        if across > 0.0 { [far * x / across, far * y / across] } else { [far, 0.0] }
    }

    /// Unit vectors along both axes of the frame and out of body 1 at a place (m).
    pub(super) fn basis(&self, [x, y]: [f64; 2]) -> [[f64; 3]; 3] {
        let cosine = self.closing([x, y]);
        let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
        let far = x.hypot(y);
        let [ex, ey] = match self.round {
            Round::Cylinder => [x.signum(), 0.0],
            Round::Sphere if far > 0.0 => [x / far, y / far],
            Round::Sphere => [1.0, 0.0],
        };
        // A socket below turns its rim upwards, a ball below its sides downwards.
        let out = if self.hollow == 0 { -sine } else { sine };
        let radial = [cosine * ex, cosine * ey, -out];
        let around = [-ey, ex, 0.0];
        let along = |a: f64, b: f64| [0, 1, 2].map(|axis| a * radial[axis] + b * around[axis]);
        [along(ex, -ey), along(ey, ex), [out * ex, out * ey, cosine]]
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::Wrap;
    use crate::body::profile::Round;

    /// Places are those of their directions.
    #[test]
    fn directions_lead_back() {
        let wrap = Wrap { round: Round::Sphere, radius: 2.0, clearance: 0.1, hollow: 0, rim: 1.0 };
        for place in [[0.0, 0.0], [0.3, -0.7], [-1.9, 1.1], [0.0, 3.5]] {
            let found = wrap.place(wrap.outwards(place)[2]);
            assert_abs_diff_eq!(found[0], place[0], epsilon = 1e-12);
            assert_abs_diff_eq!(found[1], place[1], epsilon = 1e-12);
        }
    }

    /// The unit vectors are a right-handed basis, and at 60 degrees the normal leans by that angle.
    #[test]
    fn bases_are_right_handed() {
        for (round, place) in [
            (Round::Sphere, [0.6, 0.8]),
            (Round::Sphere, [-1.0, 0.0]),
            (Round::Sphere, [0.0, 0.0]),
            (Round::Cylinder, [std::f64::consts::FRAC_PI_3, 0.3]),
            (Round::Cylinder, [-std::f64::consts::FRAC_PI_3, 0.3]),
        ] {
            for hollow in [0, 1] {
                let wrap = Wrap { round, radius: 1.0, clearance: 0.1, hollow, rim: 1.0 };
                let [a, b, c] = wrap.basis(place);
                let cross = [
                    a[1] * b[2] - a[2] * b[1],
                    a[2] * b[0] - a[0] * b[2],
                    a[0] * b[1] - a[1] * b[0],
                ];
                for axis in 0..3 {
                    assert_abs_diff_eq!(cross[axis], c[axis], epsilon = 1e-14);
                }
                if place != [0.0; 2] {
                    assert_abs_diff_eq!(c[2], 0.5, epsilon = 1e-14);
                }
            }
        }
    }
}
