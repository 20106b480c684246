//! Laws that remember what points went through, and laws of the flange.

use std::f64::consts::TAU;
use std::sync::Arc;

use approx::assert_relative_eq;
use archard::Material;
use archard::body::contact_modulus;
use archard::closed_form::Hertz;
use archard::wear::{Archard, Input, Rubbing, RunningIn, WearLaw};
use archard_rail::contact::FlangeWear;

use super::{RADIUS, cylinder, journey, point, s1002_on_60e1, travelled};

/// Archard's law with a coefficient that falls with the depth worn before: k0 exp(-w / d).
#[derive(Debug)]
struct Hardens(f64, f64);

impl WearLaw for Hardens {
    fn inputs(&self) -> &[Input] {
        &[Input::Depth]
    }

    fn depth(&self, Rubbing { pressure, slip, depth, .. }: Rubbing) -> f64 {
        self.0 * (-depth / self.1).exp() * pressure * slip
    }
}

/// Points of a profile that run in over the distance S that they slid wear k1 S + (k0 - k1) s0 (1 - exp(-S / s0)) in place of k S, and
/// those that harden as they wear d ln(1 + w / d) in place of w. So little is worn off that pressures stay. Where all slips by a tenth
/// of the way, the middle of the contact slides a tenth of its length, twice Hertz's semi-axis, in each turn of the wheel.
#[test]
fn laws_remember_how_far_points_slid_and_wore() {
    let mut spinning = point(0.0, 0.0, 1.0);
    spinning.velocity.pitch *= 1.1;
    spinning.rolls = true;
    let (k, distance) = (1e-17, 1e5);
    let wheel_worn_by = |law: Arc<dyn WearLaw>| {
        let mut journey = journey(cylinder(), [true, false], vec![spinning.clone()], distance);
        journey.bodies.wear[0] = Some(law);
        (journey.tolerance, journey.smoothing) = (1e-3, 0.0);
        journey.resolution.elements = 32;
        travelled(&journey).worn.remove(0).wheel
    };
    let plain = wheel_worn_by(Arc::new(Archard::new(k).unwrap()));
    let slid = plain.slid();
    let most = slid.iter().copied().fold(0.0, f64::max);
    let steel = Material::new(210e9, 0.28).unwrap();
    let modulus = contact_modulus([Some(&steel), Some(&steel)]);
    let hertz = Hertz::from_load([1.0 / RADIUS, 1.0 / 0.3], modulus, 60e3).unwrap();
    let along = hertz.semi_axes[0];
    assert_relative_eq!(most, 0.1 * 2.0 * along * distance / (TAU * RADIUS), max_relative = 0.01);
    let (s0, d) = (0.3 * most, 0.5 * plain.depths().into_iter().fold(0.0, f64::max));
    let run_in = wheel_worn_by(Arc::new(RunningIn::new([5.0 * k, k], s0).unwrap()));
    let hardened = wheel_worn_by(Arc::new(Hardens(k, d)));
    let mut held = 0;
    for (at, depth) in plain.depths().into_iter().enumerate() {
        // Points that a line covers in part slide as far as that part.
        if slid[at] < 0.65 * most {
            continue;
        }
        let grown = 1.0 + 4.0 * s0 / slid[at] * -(-slid[at] / s0).exp_m1();
        assert_relative_eq!(run_in.depths()[at], grown * depth, max_relative = 0.01);
        assert_relative_eq!(hardened.depths()[at], d * (depth / d).ln_1p(), max_relative = 0.01);
        held += 1;
    }
    assert!(held > 10, "{held}");
}

/// A flange with a coefficient of its own wears by it from there on, and the tread by that of the wheel.
#[test]
fn a_flange_wears_by_its_own_law() {
    let worn_by = |flange: Option<f64>| {
        let points = vec![point(3e-3, 7e-3, 1.0)];
        let mut journey = journey(s1002_on_60e1(), [true; 2], points, 1e3);
        (journey.tolerance, journey.smoothing) = (0.01, 0.0);
        journey.bodies.wear = [1e-17, 1e-17].map(|k| {
            let law: Arc<dyn WearLaw> = Arc::new(Archard::new(k).unwrap());
            Some(law)
        });
        journey.bodies.flange_wear = flange.map(|from| FlangeWear {
            from,
            wear: [Some(Arc::new(Archard::new(3e-17).unwrap())), None],
        });
        travelled(&journey).worn.remove(0)
    };
    let plain = worn_by(None);
    let (points, depths) = (plain.wheel.unworn().points, plain.wheel.depths());
    let sum: f64 = depths.iter().sum();
    let middle =
        points.iter().zip(&depths).map(|(point, depth)| point[0] * depth).sum::<f64>() / sum;
    let zoned = worn_by(Some(middle));
    for (zoned, plain) in zoned.rail.depths().into_iter().zip(plain.rail.depths()) {
        assert!((zoned - plain).abs() < 1e-3 * plain + 1e-12, "{zoned} {plain}");
    }
    let mut seen = [0; 2];
    for ((point, depth), zoned) in points.iter().zip(&depths).zip(zoned.wheel.depths()) {
        // Lines lie on one side as a whole.
        if *depth <= 0.0 || (point[0] - middle).abs() < 1e-3 {
            continue;
        }
        let on_the_flange = point[0] < middle;
        seen[usize::from(on_the_flange)] += 1;
        assert_relative_eq!(
            zoned / depth,
            if on_the_flange { 3.0 } else { 1.0 },
            max_relative = 2e-3
        );
    }
    assert!(seen.iter().all(|seen| *seen > 3), "{seen:?}");
}
