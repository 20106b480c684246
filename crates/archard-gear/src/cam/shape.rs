//! The shapes of a cam and of its follower, and where they touch.

use archard::parameters::Invalid;

use super::lift::Lift;
use crate::laws::Misfit;

/// The shape of a cam.
#[derive(Debug, Clone, PartialEq)]
pub enum Profile {
    /// A circle that turns about another point than its middle; the least lift is at no angle.
    Eccentric {
        /// Radius (m).
        radius: f64,
        /// Distance (m) of the middle from the axis.
        eccentricity: f64,
    },
    /// What lifts the follower that far above a base circle.
    Lift {
        /// Radius (m) of the base circle.
        base_radius: f64,
        /// The lift.
        lift: Lift,
    },
}

impl Profile {
    /// Radius (m) of the base circle.
    pub fn base_radius(&self) -> f64 {
        match self {
            Self::Eccentric { radius, eccentricity } => radius - eccentricity,
            Self::Lift { base_radius, .. } => *base_radius,
        }
    }

    /// The lift (m) of a follower, and its first and second derivative by the angle (rad).
    pub fn lift(&self, follower: Follower, angle: f64) -> [f64; 3] {
        let (&radius, &eccentricity) = match self {
            Self::Lift { lift, .. } => return lift.at(angle),
            Self::Eccentric { radius, eccentricity } => (radius, eccentricity),
        };
        let (sin, cos) = angle.sin_cos();
        let harmonic = [eccentricity * (1.0 - cos), eccentricity * sin, eccentricity * cos];
        let Follower::Round(other) = follower else { return harmonic };
        // The connecting rod of a crank, from the middle of one circle to that of the other.
        let rod = radius + other;
        let across = eccentricity * sin;
        let length = (rod * rod - across * across).sqrt();
        let slope = -across * eccentricity * cos / length;
        let bend =
            (-eccentricity * eccentricity * (cos * cos - sin * sin) - slope * slope) / length;
        // Without the difference of two large lengths.
        let shorter = -across * across / (rod + length);
        [harmonic[0] + shorter, harmonic[1] + slope, harmonic[2] + bend]
    }

    /// The same by half of what is known, to see how far off it is.
    pub(super) fn coarser(&self) -> Self {
        match self {
            Self::Lift { base_radius, lift } => {
                let lift = lift.coarser().unwrap_or_else(|| lift.clone());
                Self::Lift { base_radius: *base_radius, lift }
            }
            Self::Eccentric { .. } => self.clone(),
        }
    }
}

/// The face of a follower that moves along a line through the axis of the cam, and does not turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Follower {
    /// Flat, at right angles to its way.
    Flat,
    /// Round, of that radius (m), its middle on the line of its way.
    Round(f64),
}

/// Where a cam touches its follower, at an angle. Speeds are those of an angular speed of one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touch {
    /// The lift (m).
    pub lift: f64,
    /// Its second derivative (m/rad^2).
    pub bend: f64,
    /// How fast (m) the cam slides on the follower.
    pub sliding: f64,
    /// Where (m) the follower is touched along its face, from the middle of it.
    pub place: f64,
    /// How fast (m) the contact moves over the cam and over the follower.
    pub speeds: [f64; 2],
    /// The relative curvature (1/m) of both.
    pub curvature: f64,
    /// The cosine of the angle between the normal of the contact and the way of the follower.
    pub cosine: f64,
}

impl Touch {
    /// Of a cam and its follower at an angle (rad).
    pub fn new(profile: &Profile, follower: Follower, angle: f64) -> Self {
        let [lift, slope, bend] = profile.lift(follower, angle);
        let base = profile.base_radius();
        match follower {
            // The distance of the face from the axis is the support function of the cam.
            Follower::Flat => {
                let reach = base + lift;
                let radius = reach + bend;
                Self {
                    lift,
                    bend,
                    sliding: reach,
                    place: slope,
                    speeds: [radius, bend],
                    curvature: radius.recip(),
                    cosine: 1.0,
                }
            }
            // The middle of the face runs on a curve at its radius from the cam.
            Follower::Round(radius) => {
                let reach = base + radius + lift;
                let way = reach.hypot(slope);
                let sliding = way - radius;
                let turning = (reach * bend - slope * slope) / (way * way);
                let speeds = [sliding + radius * turning, radius * turning];
                Self {
                    lift,
                    bend,
                    sliding,
                    place: radius * slope.atan2(reach),
                    speeds,
                    curvature: way / (radius * speeds[0]),
                    cosine: reach / way,
                }
            }
        }
    }
}

/// The first of some angles (rad) where a cam and its follower do not touch along one line.
pub(super) fn fits(
    profile: &Profile,
    follower: Follower,
    angles: impl Iterator<Item = f64>,
) -> Result<(), Misfit> {
    for angle in angles {
        let touch = Touch::new(profile, follower, angle);
        let degrees = angle.to_degrees();
        if profile.base_radius() + touch.lift <= 0.0 {
            let message = format!(
                "the cam reaches to its axis at {degrees:.2} deg: a larger one, or a lift that begins from zero"
            );
            return Err(Misfit::of(0, Invalid::new("base_radius", message)));
        }
        if touch.speeds[0] > 0.0 {
            continue;
        }
        return Err(match follower {
            Follower::Flat => {
                let message = format!(
                    "the cam is not convex at {degrees:.2} deg, where base radius + lift + second derivative of the lift is {:.4} mm: a flat \
                     follower bridges it; a larger base radius, a smoother lift, or a round follower",
                    1e3 * touch.speeds[0]
                );
                Misfit::of(0, Invalid::new("base_radius", message))
            }
            Follower::Round(radius) => {
                let message = format!(
                    "the cam is undercut at {degrees:.2} deg: no profile touches a follower of {:.4} mm there with this lift; a smaller one, \
                     or a larger base radius",
                    1e3 * radius
                );
                Misfit::of(1, Invalid::new("radius", message))
            }
        });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{Follower, Profile, Touch};

    /// An eccentric circle rolls and slides as a circle: its curvature is that of the circle, whatever the follower.
    #[test]
    fn an_eccentric_is_a_circle() {
        let (radius, eccentricity) = (20e-3, 4e-3);
        let cam = Profile::Eccentric { radius, eccentricity };
        for step in 0..50 {
            let angle = 0.13 * f64::from(step);
            let flat = Touch::new(&cam, Follower::Flat, angle);
            assert_relative_eq!(flat.curvature, 1.0 / radius, max_relative = 1e-12);
            let other = 6e-3;
            let round = Touch::new(&cam, Follower::Round(other), angle);
            let relative = 1.0 / radius + 1.0 / other;
            assert_relative_eq!(round.curvature, relative, max_relative = 1e-12);
            // A large round follower is a flat one.
            let large = Touch::new(&cam, Follower::Round(1e6), angle);
            assert_relative_eq!(large.speeds[1], flat.speeds[1], epsilon = 1e-8);
            assert_relative_eq!(large.speeds[0], flat.speeds[0], epsilon = 1e-8);
            assert_relative_eq!(large.place, flat.place, epsilon = 1e-9);
        }
    }

    /// Derivatives of the place and of the lift are those by differences, and sliding is what a rigid cam does: r cos a + s' sin a - r_f.
    #[test]
    fn speeds_are_those_of_the_places() {
        let cam = Profile::Eccentric { radius: 20e-3, eccentricity: 9e-3 };
        for follower in [Follower::Flat, Follower::Round(7e-3)] {
            for step in 0..20 {
                let angle = 0.31 * f64::from(step);
                let here = Touch::new(&cam, follower, angle);
                let [before, after] =
                    [-1e-5, 1e-5].map(|off| Touch::new(&cam, follower, angle + off));
                let speed = (after.place - before.place) / 2e-5;
                assert_relative_eq!(here.speeds[1], speed, epsilon = 1e-9);
                assert_relative_eq!(here.speeds[0] - here.speeds[1], here.sliding, epsilon = 1e-15);
                let slopes = [-1e-5, 0.0, 1e-5].map(|off| cam.lift(follower, angle + off)[1]);
                assert_relative_eq!(here.bend, (slopes[2] - slopes[0]) / 2e-5, epsilon = 1e-9);
                if let Follower::Round(radius) = follower {
                    let reach = cam.base_radius() + radius + here.lift;
                    let sine = (1.0 - here.cosine.powi(2)).sqrt();
                    let rigid = reach * here.cosine + slopes[1].abs() * sine - radius;
                    assert_relative_eq!(here.sliding, rigid, epsilon = 1e-9);
                }
            }
        }
    }
}
