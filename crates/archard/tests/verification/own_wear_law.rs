//! Wear laws that are not linear in the pressure.

use archard::kinematics::Stepping;
use archard::wear::{Rubbing, WearLaw};

use crate::common::{Ball, peak, states};

/// k p (p / p_0)^(1/2) s.
#[derive(Debug)]
struct Power;

impl WearLaw for Power {
    fn depth(&self, Rubbing { pressure, slip }: Rubbing) -> f64 {
        1.33e-13 * pressure * (pressure / 100e6).sqrt() * slip
    }
}

/// k (p - p_c) s beyond a threshold.
#[derive(Debug)]
struct Threshold;

impl WearLaw for Threshold {
    fn depth(&self, Rubbing { pressure, slip }: Rubbing) -> f64 {
        1.33e-13 * (pressure - 30e6).max(0.0) * slip
    }
}

/// Every implicit step wears what the law says of the pressure at its end, and that pressure is a
/// contact of the worn surfaces: p >= 0, g >= 0, p g = 0 with the compliance applied anew.
#[test]
fn implicit_steps_obey_the_law_and_the_contact() {
    let laws: [fn() -> Box<dyn WearLaw>; 2] = [|| Box::new(Power), || Box::new(Threshold)];
    for law in laws {
        let step = 10e-3;
        let mut simulation = Ball::pin_on_disc(24).sliding(0.1, Stepping::Implicit(step), &[]);
        simulation.problem.bodies[0].wear = Some(law());
        let states = states(&simulation).unwrap();
        assert_eq!(states.len(), 11);
        for pair in states.windows(2) {
            let (before, after) = (&pair[0].0, &pair[1].0);
            let deepest = peak(&after.worn[0]);
            let mut displacement = vec![0.0; after.pressure.len()];
            simulation.problem.compliance.apply_normal(&after.pressure, &mut displacement);
            for (i, &pressure) in after.pressure.iter().enumerate() {
                let worn = after.worn[0][i] - before.worn[0][i];
                let expected = law().depth(Rubbing { pressure, slip: step });
                assert!((worn - expected).abs() < 1e-12 * deepest);
                let gap = simulation.problem.frame.gap()[i] + after.worn[0][i] + displacement[i]
                    - after.approach;
                assert!(pressure >= 0.0 && gap > -1e-6 * deepest, "{gap:e}");
                assert!(
                    pressure == 0.0 || gap.abs() < 1e-6 * deepest,
                    "{gap:e} under {pressure:e}"
                );
            }
        }
    }
}
