//! Similarity: the equations have no scale of their own.

use archard::body::Material;
use archard::motion::{Control, Stepping};
use archard::problem::ContactState;
use proptest::prelude::*;

use crate::common::{Ball, states};

/// The end of a short run with lengths, moduli and wear coefficients scaled.
///
/// Pressures grow with the modulus, so loads with the modulus times the area, and the distance for
/// equal relative wear with the length over the wear coefficient times the pressure.
fn scaled(length: f64, modulus: f64, coefficient: f64, by_error: bool) -> ContactState {
    let base = Ball::pin_on_disc(16);
    let ball = Ball {
        radii: [0.05 * length, 0.08 * length],
        materials: [
            Some(Material { young: 210e9 * modulus, poisson: 0.3 }),
            Some(Material { young: 70e9 * modulus, poisson: 0.2 }),
        ],
        size: [0.8e-3 * length, 0.9e-3 * length],
        wear: [1e-13 * coefficient, 2e-13 * coefficient],
        control: Control::Load(10.2 * modulus * length * length),
        solver_tolerance: 1e-12,
        ..base
    };
    let distance = 20e-3 * length / (modulus * coefficient);
    let stepping =
        if by_error { Stepping::Tolerance(1e-2) } else { Stepping::Implicit(distance / 4.0) };
    states(&ball.sliding(distance, stepping, &[])).unwrap().pop().unwrap().0
}

fn assert_similar(scaled: &[f64], base: &[f64], factor: f64) -> Result<(), TestCaseError> {
    let scale = base.iter().copied().fold(0.0, f64::max);
    for (scaled, base) in scaled.iter().zip(base) {
        prop_assert!(
            (scaled / factor - base).abs() < 1e-9 * scale,
            "{} and {base}",
            scaled / factor
        );
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn lengths_moduli_and_coefficients_scale(
        length in 1e-3..1e3f64,
        modulus in 1e-3..1e3f64,
        coefficient in 1e-3..1e3f64,
        by_error: bool,
    ) {
        let base = scaled(1.0, 1.0, 1.0, by_error);
        let other = scaled(length, modulus, coefficient, by_error);
        assert_similar(&other.pressure, &base.pressure, modulus)?;
        assert_similar(&other.worn(0), &base.worn(0), length)?;
        assert_similar(&other.worn(1), &base.worn(1), length)?;
        assert_similar(&[other.approach], &[base.approach], length)?;
    }

    /// Hertz: at equal load, twice the radius and twice the modulus are the similarity of the contact
    /// radius a = (3 F R / 4 E*)^(1/3), on a frame that grows with it.
    #[test]
    fn load_radius_and_modulus_alone(load in 0.1..10f64, radius in 0.1..10f64, modulus in 0.1..10f64) {
        let contact = |load: f64, radius: f64, modulus: f64| {
            let growth = (load * radius / modulus).cbrt();
            Ball {
                radii: [0.05 * radius; 2],
                materials: [Some(Material { young: 210e9 * modulus, poisson: 0.3 }), None],
                size: [0.4e-3 * growth; 2],
                control: Control::Load(10.2 * load),
                solver_tolerance: 1e-12,
                ..Ball::pin_on_disc(16)
            }
            .contact()
        };
        let (base, other) = (contact(1.0, 1.0, 1.0), contact(load, radius, modulus));
        assert_similar(&other.pressure, &base.pressure, (load * modulus * modulus / (radius * radius)).cbrt())?;
        assert_similar(&[other.approach], &[base.approach], (load * load / (radius * modulus * modulus)).cbrt())?;
    }
}
