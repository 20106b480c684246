//! Worn volumes as test standards have them, from the lengths of a scar or a track that a microscope or a profile shows.
//!
//! - ASTM G99 (pin on disk) and G133 (reciprocating): a ball has lost the cap above the flat that is its scar,
//!   V = (pi h/6) (3 d^2/4 + h^2) with h = R - sqrt(R^2 - d^2/4).
//! - ASTM G99: the track of a disc has the section of the ball, V = 2 pi R_track [r^2 asin(d/2r) - (d/4) sqrt(4 r^2 - d^2)].
//! - ASTM G77 (block on ring): the scar of a block has the section of the ring,
//!   V = (D^2 t/8) [2 asin(b/D) - sin(2 asin(b/D))].
//! - ASTM G133: a flat has lost its section times the stroke, which needs no shape.
//!
//! Each of the first three takes one body to wear and the other to keep its shape, both of them rigid. The sections of
//! track and block are one and the same segment of a circle.

use std::f64::consts::TAU;

/// Angle (rad) below which the segment of a circle is summed as a series; the first term left out is 2e-15 of the sum.
const SMALL: f64 = 0.05;

/// Volume (m^3) of a ball of that radius (m) under a flat scar of that diameter (m); `None` where the ball is narrower.
pub fn ball_scar(radius: f64, diameter: f64) -> Option<f64> {
    let half = 0.5 * diameter;
    let height = half * half / (radius + root(radius, half)?);
    Some(std::f64::consts::PI * height / 6.0 * (3.0 * half * half + height * height))
}

/// Section (m^2) of the segment that a chord of that width (m) cuts off a circle of that radius (m); `None` where the
/// circle is narrower.
pub fn segment(radius: f64, width: f64) -> Option<f64> {
    let half = 0.5 * width;
    let rest = root(radius, half)?;
    let angle = (half / radius).asin();
    // r^2 (a - sin a cos a), whose first terms cancel.
    if angle < SMALL {
        let square = angle * angle;
        let series = 1.0 - square * (0.2 - square * (2.0 / 105.0 - square / 945.0));
        return Some(2.0 / 3.0 * radius * radius * angle * square * series);
    }
    Some(radius * radius * angle - half * rest)
}

/// Volume (m^3) of a track of that width (m) that a ball of that radius (m) leaves on a disc, around at a track radius
/// (m); `None` where the ball is narrower.
pub fn disc_track(track_radius: f64, radius: f64, width: f64) -> Option<f64> {
    Some(TAU * track_radius * segment(radius, width)?)
}

/// Volume (m^3) of a block of that length (m) under a scar of that width (m), left by a ring of that diameter (m);
/// `None` where the ring is narrower.
pub fn block_scar(diameter: f64, width: f64, length: f64) -> Option<f64> {
    Some(length * segment(0.5 * diameter, width)?)
}

/// Distance (m) from the centre of a circle to a chord of that half width (m).
fn root(radius: f64, half: f64) -> Option<f64> {
    let inside = half >= 0.0 && half <= radius;
    inside.then(|| ((radius - half) * (radius + half)).sqrt())
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use approx::assert_relative_eq;

    use super::{ball_scar, block_scar, disc_track, segment};
    use crate::closed_form::pin_on_disc;

    /// The cap by its height, which the geometric model of the pin on disc has too.
    #[test]
    fn a_scar_cuts_a_cap_off_the_ball() {
        let radius: f64 = 3e-3;
        for height in [1e-3, 0.3, 0.9] {
            let height = height * radius;
            let diameter = 2.0 * (height * (2.0 * radius - height)).sqrt();
            let cap = pin_on_disc::volume(radius, height);
            assert_relative_eq!(ball_scar(radius, diameter).unwrap(), cap, max_relative = 1e-12);
        }
        let half_a_ball = 2.0 / 3.0 * PI * radius.powi(3);
        assert_relative_eq!(
            ball_scar(radius, 2.0 * radius).unwrap(),
            half_a_ball,
            max_relative = 1e-14
        );
        assert_eq!(ball_scar(radius, 2.1 * radius), None);
    }

    /// Of small scars pi d^4/(64 R), of small segments b^3/(12 r), each with its next term.
    #[test]
    fn small_scars_follow_powers_of_their_width() {
        let radius: f64 = 5e-3;
        for share in [1e-5, 1e-3, 1e-2] {
            let width = share * radius;
            let cap = PI * width.powi(4) / (64.0 * radius) * (1.0 + share * share / 12.0);
            assert_relative_eq!(
                ball_scar(radius, width).unwrap(),
                cap,
                max_relative = share.powi(4) + 1e-14
            );
            let slice = width.powi(3) / (12.0 * radius) * (1.0 + 3.0 / 40.0 * share * share);
            assert_relative_eq!(
                segment(radius, width).unwrap(),
                slice,
                max_relative = share.powi(4) + 1e-14
            );
        }
    }

    /// G99 and G77 as they are printed, and half a circle.
    #[test]
    fn track_and_block_have_the_section_of_a_circle() {
        let radius: f64 = 17.5e-3;
        for width in [0.5e-3, 1.7e-3, 1.8e-3, 10e-3, 30e-3] {
            let half = 0.5 * width / radius;
            let g99 = radius * radius * half.asin()
                - 0.25 * width * (4.0 * radius * radius - width * width).sqrt();
            let diameter = 2.0 * radius;
            let angle = 2.0 * (width / diameter).asin();
            let g77 = diameter * diameter * 6e-3 / 8.0 * (angle - angle.sin());
            let track = disc_track(0.01, radius, width).unwrap();
            // What cancels in the printed forms leaves a part of 1e-16 of the larger term.
            let lost = 1e-15 / half.powi(2);
            assert_relative_eq!(track, 0.02 * PI * g99, max_relative = lost);
            assert_relative_eq!(
                block_scar(diameter, width, 6e-3).unwrap(),
                g77,
                max_relative = lost
            );
        }
        let half_a_circle = 0.5 * PI * radius * radius;
        assert_relative_eq!(
            segment(radius, 2.0 * radius).unwrap(),
            half_a_circle,
            max_relative = 1e-14
        );
        assert_eq!(segment(radius, 2.1 * radius), None);
    }

    /// Where the series takes over, both have the same value.
    #[test]
    fn the_series_goes_on_where_the_formula_ends() {
        let at = |angle: f64| {
            segment(1.0, 2.0 * angle.sin()).unwrap() / (angle - angle.sin() * angle.cos())
        };
        assert_relative_eq!(at(0.049_999_9), 1.0, max_relative = 1e-12);
        assert_relative_eq!(at(0.050_000_1), 1.0, max_relative = 1e-12);
    }
}
