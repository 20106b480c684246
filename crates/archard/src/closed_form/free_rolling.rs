//! Free rolling of unlike cylinders when friction is small: creepage without a driving force.
//!
//! R. H. Bentall and K. L. Johnson, *Int. J. Mech. Sci.* 9 (1967) 389; Johnson, *Contact Mechanics*,
//! section 8.2. The pressure p of Hertz stretches the surface of body 1 by
//! -(1 - 2 nu1) p / (2 G1) and that of body 2 accordingly, 2 beta p / E* apart. As friction vanishes
//! its tractions stretch neither, and all slips but for two places, where the difference equals the
//! creepage. Free of force, the pressure between these places carries half the load.

/// Creepage of free rolling as friction vanishes, 0.914771 beta a / R: half width a and combined
/// radius R (m), beta that of [`super::spence::coupling`].
///
/// By this share of the speed of rolling the unstrained surface of body 1 runs faster than that of
/// body 2: positive with beta, since what is shortened in the contact has to be longer outside.
pub fn creepage(dundurs_beta: f64, half_width: f64, radius: f64) -> f64 {
    PRESSURE_AT_TURN * dundurs_beta * half_width / radius
}

/// Relative pressure cos t of Hertz at the distance sin t within which half of the load lies, with
/// t + sin t cos t = pi/4.
const PRESSURE_AT_TURN: f64 = 0.914_771_017_573_035_8;

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{PRESSURE_AT_TURN, creepage};
    use crate::body::Material;
    use crate::closed_form::spence::coupling;

    const MODULI: [f64; 2] = [23e9, 82e9];
    const POISSONS: [f64; 2] = [0.31, 0.28];

    /// Dundurs' constant of both bodies.
    fn beta() -> f64 {
        let [one, other] = [0, 1].map(|body| {
            let (shear_modulus, poisson) = (MODULI[body], POISSONS[body]);
            Material { young: 2.0 * (1.0 + poisson) * shear_modulus, poisson }
        });
        coupling([Some(&one), Some(&other)])
    }

    /// Reference value, three digits: rollers of 50 mm, half width 0.1 mm.
    #[test]
    fn unlike_rollers() {
        let found = creepage(beta(), 0.1e-3, 25e-3);
        assert_relative_eq!(found, 5.26e-4, max_relative = 1e-3);
    }

    /// Friction of the sign of the slip, creepage less the difference of strain, sums to zero over
    /// Hertz's pressure; here with p0 = E* a / (2 R) and strains of each body from its own constants.
    #[test]
    fn friction_cancels() {
        let (half_width, radius) = (0.1e-3, 25e-3);
        let [strain1, strain2] =
            [0, 1].map(|body| (1.0 - 2.0 * POISSONS[body]) / (2.0 * MODULI[body]));
        let compliance: f64 =
            [0, 1].map(|body| (1.0 - POISSONS[body]) / (2.0 * MODULI[body])).iter().sum();
        let peak = half_width / (2.0 * radius * compliance);
        let free = creepage(beta(), half_width, radius);
        let count = 200_000;
        let friction = |creepage: f64| -> f64 {
            let sum: f64 = (0..count)
                .map(|i| {
                    let place = -1.0 + (2.0 * f64::from(i) + 1.0) / f64::from(count);
                    let pressure = (1.0 - place * place).sqrt();
                    let slip = creepage - (strain1 - strain2) * peak * pressure;
                    pressure * slip.signum()
                })
                .sum();
            2.0 * sum / f64::from(count) / std::f64::consts::FRAC_PI_2
        };
        assert_relative_eq!(friction(free), 0.0, epsilon = 1e-4);
        assert!(friction(1.01 * free) > 0.01 && friction(0.99 * free) < -0.01);
    }

    #[test]
    fn half_of_the_load_lies_within_the_turns() {
        let angle = PRESSURE_AT_TURN.acos();
        let share = angle + angle.sin() * angle.cos();
        assert_relative_eq!(share, std::f64::consts::FRAC_PI_4, max_relative = 1e-14);
    }
}
