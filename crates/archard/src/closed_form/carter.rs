//! Carter's rolling cylinders: creep and traction of a line contact.
//!
//! F. W. Carter, *Proc. R. Soc. A* 112 (1926) 151; Johnson, *Contact Mechanics*, section 8.3.

/// Creepage at which the whole contact slips, mu a / R: half width a (m) and combined radius R (m).
pub fn saturation_creepage(friction: f64, half_width: f64, radius: f64) -> f64 {
    friction * half_width / radius
}

/// Tangential force relative to its limit, Q / (mu P) = 1 - (1 - x)^2, at a creepage relative to
/// saturation x; its sign is that of the creepage.
pub fn relative_force(relative_creepage: f64) -> f64 {
    let stick = 1.0 - relative_creepage.abs().min(1.0);
    relative_creepage.signum() * (1.0 - stick * stick)
}

/// Tangential traction relative to friction times the peak pressure, at a place relative to the half
/// width, positive towards the leading edge, where the stick zone lies.
pub fn relative_traction(relative_creepage: f64, place: f64) -> f64 {
    let slip_share = relative_creepage.abs().min(1.0);
    let (centre, half) = (slip_share, 1.0 - slip_share);
    let full = (1.0 - place * place).max(0.0).sqrt();
    let offset = place - centre;
    let stick = (half * half - offset * offset).max(0.0).sqrt();
    relative_creepage.signum() * (full - stick)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{relative_force, relative_traction, saturation_creepage};

    /// Reference values: x = 0.25, 0.5, 0.75 give Q / (mu P) = 0.4375, 0.75, 0.9375.
    #[test]
    fn forces_at_three_creepages() {
        for (creepage, force) in [(0.25, 0.4375), (0.5, 0.75), (0.75, 0.9375), (2.0, 1.0)] {
            assert_relative_eq!(relative_force(creepage), force);
            assert_relative_eq!(relative_force(-creepage), -force);
        }
    }

    /// The traction sums to the force: over the half width, a semicircle of limit pi/2.
    #[test]
    fn tractions_sum_to_the_force() {
        for creepage in [0.2, 0.6, -0.9] {
            let count = 200_000;
            let place = |i: i32| -1.0 + (2.0 * f64::from(i) + 1.0) / f64::from(count);
            let sum: f64 = (0..count).map(|i| relative_traction(creepage, place(i))).sum();
            let mean = 2.0 * sum / f64::from(count);
            let force = relative_force(creepage) * std::f64::consts::FRAC_PI_2;
            assert_relative_eq!(mean, force, max_relative = 1e-6);
        }
    }

    /// Reference value of the twin discs: everything slips beyond 0.802 %.
    #[test]
    fn the_twin_discs_slip_at_their_saturation() {
        let creepage = saturation_creepage(0.6, 0.2165120e-3, 16.199846e-3);
        assert_relative_eq!(creepage, 0.802e-2, max_relative = 1e-3);
    }
}
