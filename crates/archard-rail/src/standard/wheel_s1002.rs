//! The wheel profile S1002 (EN 13715, UIC 510-2).
//!
//! A cone outside, two polynomials and an arc from the tread to the flange, a face of 70 degrees, and three arcs round
//! the flange of 28 mm. y = 0 is the running circle, 70 mm from the back of the flange.

use crate::profile::Profile;
use archard::parameters::Invalid;

/// Coefficients of rising powers of y (mm) from -26 to 32.15796 mm.
const TREAD: [f64; 9] = [
    0.0,
    -3.358537058e-2,
    1.565681624e-3,
    -2.810427944e-5,
    5.844240864e-8,
    -1.562379023e-8,
    5.309217349e-15,
    -5.957839843e-12,
    2.646656573e-13,
];
/// Coefficients of rising powers of y (mm) from -35 to -26 mm.
const ROOT: [f64; 8] = [
    -4.320221063e3,
    -1.038384026e3,
    -1.065501873e2,
    -6.051367875,
    -2.054332446e-1,
    -4.169739389e-3,
    -4.687195829e-5,
    -2.252755540e-7,
];
/// The face of the flange (mm): depth at y = 0, and slope.
const FACE: [f64; 2] = [-93.576667419, -2.747477419];
/// The arcs round the flange (mm): centre and radius, from the face to the back.
///
/// The first one touches the face and the second arc: its centre lies 20 mm from the face and 20 - 12 mm from the other centre,
/// at z = 8.834924. The value 8.834985, also in use, misses both by up to 5e-5 mm.
const FLANGE: [Arc; 3] = [
    Arc { centre: [-58.558326, 8.834924], radius: 20.0 },
    Arc { centre: [-55.0, 16.0], radius: 12.0 },
    Arc { centre: [-49.5, 9.519259], radius: 20.5 },
];
/// Ends (mm) of the profile: the outer face of the wheel, and the back of the flange.
const ENDS: [f64; 2] = [60.0, -70.0];
/// The arc between the polynomials and the face (mm).
const THROAT: Arc = Arc { centre: [-26.210665, 16.446], radius: 13.0 };

struct Arc {
    centre: [f64; 2],
    radius: f64,
}

impl Arc {
    /// Half the height (mm) of the circle at y (mm).
    fn rise(&self, y: f64) -> f64 {
        (self.radius.powi(2) - (y - self.centre[0]).powi(2)).max(0.0).sqrt()
    }
}

/// y (mm) at which the face ends and the arcs of the flange begin, each touching the one before.
fn joints() -> [f64; 3] {
    let [first, tip, back] = &FLANGE;
    let face = first.centre[0] - first.radius * FACE[1] / FACE[1].hypot(1.0);
    let touching = |large: &Arc, small: &Arc| {
        let [y, z] = [0, 1].map(|axis| small.centre[axis] - large.centre[axis]);
        large.centre[0] + large.radius * y / y.hypot(z)
    };
    [face, touching(first, tip), touching(back, tip)]
}

fn polynomial(coefficients: &[f64], y: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * y + coefficient)
}

/// z (mm) of the profile at y (mm).
fn depth(y: f64) -> f64 {
    let [face, first, tip] = joints();
    let arc = |arc: &Arc| arc.centre[1] + arc.rise(y);
    match y {
        y if y > 32.15796 => 1.36432364 - y / 15.0,
        y if y > -26.0 => polynomial(&TREAD, y),
        y if y > -35.0 => polynomial(&ROOT, y),
        y if y > -38.426669 => THROAT.centre[1] - THROAT.rise(y),
        y if y > face => FACE[0] + FACE[1] * y,
        y if y > first => arc(&FLANGE[0]),
        y if y > tip => arc(&FLANGE[1]),
        _ => arc(&FLANGE[2]),
    }
}

/// z (m, downwards) of the wheel profile S1002 at y (m, to the field side); `None` beyond 60 mm to the field side or
/// behind the flange at -70 mm.
pub fn wheel_s1002_depth(y: f64) -> Option<f64> {
    let y = y * 1e3;
    (ENDS[1]..=ENDS[0]).contains(&y).then(|| depth(y) * 1e-3)
}

/// The wheel profile S1002 with points no farther apart along y than the step (m).
///
/// # Errors
/// If the step does not lie between 0.01 and 1 mm.
pub fn wheel_s1002(step: f64) -> Result<Profile, Invalid> {
    let step = super::checked(step)? * 1e3;
    let [.., tip] = joints();
    let back = &FLANGE[2];
    // Near the back the profile is upright, and equal steps of the angle keep the points together.
    let angle = |y: f64| ((y - back.centre[0]) / back.radius).clamp(-1.0, 1.0).asin();
    let turned = super::between(angle(tip), angle(ENDS[1]), step / back.radius).map(|angle| {
        [back.radius * angle.sin() + back.centre[0], back.centre[1] + back.radius * angle.cos()]
    });
    let points = super::between(ENDS[0], tip, step).map(|y| [y, depth(y)]).chain(turned.skip(1));
    Profile::new(points.map(|[y, z]| [y * 1e-3, z * 1e-3]).collect())
}

#[cfg(test)]
mod tests {
    use super::{FACE, FLANGE, THROAT};

    /// Neighbours touch as exactly as six decimals of the centres say.
    #[test]
    fn arcs_touch() {
        let to_face = |arc: &super::Arc| {
            let across = FACE[0] + FACE[1] * arc.centre[0] - arc.centre[1];
            across.abs() / FACE[1].hypot(1.0) - arc.radius
        };
        let [first, tip, back] = &FLANGE;
        let inside = |large: &super::Arc, small: &super::Arc| {
            let [y, z] = [0, 1].map(|axis| small.centre[axis] - large.centre[axis]);
            y.hypot(z) - (large.radius - small.radius)
        };
        for off in [to_face(&THROAT), to_face(first), inside(first, tip), inside(back, tip)] {
            assert!(off.abs() < 1e-6, "{off}");
        }
    }
}
