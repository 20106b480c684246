//! The disc of a twin-disc machine: it rolls along x and may be crowned across. A ring is a hollow disc, a groove a hollow crown.

use std::f64::consts::FRAC_1_SQRT_2;

use super::{Profile, circle_recess};
use crate::parameters::{Bound, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Profile>> = Choice {
    name: "disc",
    meaning: "a disc rolling along x, its rim flat or crowned along y; a ring or a groove where radii are negative",
    parameters: &[RADIUS, CROWN],
    build: |values| {
        let radius = values.require("radius")?;
        Ok(Box::new(match values.number("crown") {
            Some(crown) => Disc::crowned(radius, crown)?,
            None => Disc::new(radius)?,
        }))
    },
};

const RADIUS: Parameter =
    Parameter::required("radius", Quantity::Length, "rolling radius; negative inside a ring")
        .bound(Bound::NonZero);
const CROWN: Parameter = Parameter::optional(
    "crown",
    Quantity::Length,
    "radius of the crown, negative of a groove; none: a flat rim",
)
.bound(Bound::NonZero);

/// The surface that a circle, the crown, makes as it turns about the axis of the disc: at each place along y, where the crown
/// lies z deep, a circle of radius R - z along x.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disc {
    radius: f64,
    crown: Option<f64>,
}

impl Disc {
    /// A disc of that rolling radius (m), negative inside a ring, with a flat rim.
    ///
    /// # Errors
    /// If the radius is zero.
    pub fn new(radius: f64) -> Result<Self, Invalid> {
        Ok(Self { radius: RADIUS.admit(radius)?, crown: None })
    }

    /// A disc of that rolling radius (m), negative inside a ring, with a crown of that radius (m), negative of a groove.
    ///
    /// # Errors
    /// If a radius is zero.
    pub fn crowned(radius: f64, crown: f64) -> Result<Self, Invalid> {
        Ok(Self { crown: Some(CROWN.admit(crown)?), ..Self::new(radius)? })
    }
}

impl Profile for Disc {
    fn recess(&self, x: f64, y: f64) -> f64 {
        let deep = self.crown.map_or(0.0, |crown| circle_recess(crown, y));
        let radius = self.radius - deep;
        // Beyond the axis there is no disc.
        if radius * self.radius > 0.0 { deep + circle_recess(radius, x) } else { f64::NAN }
    }

    /// A rectangle on the disc. Where the crown makes the circles smaller, it ends where they have the radius that a rectangle
    /// on a sphere ends at, or with the crown.
    fn extent(&self) -> [[f64; 2]; 2] {
        let radius = self.radius.abs();
        let half = match self.crown {
            None => [radius, f64::INFINITY],
            Some(crown) if crown * self.radius < 0.0 => [radius, crown.abs()],
            Some(crown) => {
                let deep = (radius * (1.0 - FRAC_1_SQRT_2)).min(crown.abs());
                [radius - deep, (deep * (2.0 * crown.abs() - deep)).sqrt()]
            }
        };
        half.map(|half| [-half, half])
    }

    fn curvatures(&self) -> Option<[f64; 2]> {
        Some([1.0 / self.radius, self.crown.map_or(0.0, |crown| 1.0 / crown)])
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::Disc;
    use crate::body::profile::{Profile, Sphere};

    /// A disc whose crown has its radius is a ball, and a ring with such a groove its socket.
    #[test]
    fn a_disc_with_its_own_radius_as_crown_is_a_sphere() {
        for radius in [5e-3, -5e-3] {
            let (disc, ball) =
                (Disc::crowned(radius, radius).unwrap(), Sphere::new(radius).unwrap());
            for [x, y] in [[1e-3, 0.0], [0.0, 1e-3], [1e-3, 2e-3], [3e-3, -3.5e-3]] {
                assert_relative_eq!(disc.recess(x, y), ball.recess(x, y), max_relative = 1e-12);
            }
            assert!(disc.recess(4e-3, 4e-3).is_nan());
            let [disc, ball] = [disc.extent(), ball.extent()];
            assert_relative_eq!(disc[0][1], ball[0][1], max_relative = 1e-12);
            assert_relative_eq!(disc[1][1], ball[1][1], max_relative = 1e-12);
        }
    }

    /// The rectangle where it is known lies on the surface.
    #[test]
    fn a_disc_is_known_where_it_says_it_is() {
        for radius in [2e-3, -2e-3] {
            for crown in [1e-4, 1e-3, 5e-3, 1.0, -1e-3, -1.0] {
                let disc = Disc::crowned(radius, crown).unwrap();
                let [[_, x], [_, y]] = disc.extent().map(|ends| ends.map(|end| 0.999_999 * end));
                assert!(disc.recess(x, y).is_finite(), "{radius} {crown}");
            }
        }
    }
}
