use approx::assert_relative_eq;
use fastrand::Rng;

use super::{Form, NoForm, Nominal};
use crate::map::HeightMap;

const PIXEL: f64 = 10e-6;
const POINTS: usize = 64;

/// A normal number, after Box and Muller.
fn normal(random: &mut Rng) -> f64 {
    (-2.0 * (1.0 - random.f64()).ln()).sqrt() * (std::f64::consts::TAU * random.f64()).cos()
}

/// A map of heights over places (m) from its middle.
fn map(mut height: impl FnMut(f64, f64) -> f64) -> HeightMap {
    let place = |index: usize| PIXEL * (index as f64 - 0.5 * (POINTS - 1) as f64);
    let heights = (0..POINTS * POINTS).map(|at| height(place(at % POINTS), place(at / POINTS)));
    HeightMap::new([POINTS; 2], [PIXEL; 2], heights.collect()).unwrap()
}

fn ball(radius: f64, [x0, y0]: [f64; 2]) -> impl Fn(f64, f64) -> f64 {
    move |x, y| (radius * radius - (x - x0).powi(2) - (y - y0).powi(2)).sqrt() - radius
}

/// Exact shapes come out to rounding, whether convex, concave or off the middle, and nothing is left of them.
#[test]
fn exact_shapes_are_found() {
    let cap = ball(1e-3, [2e-4, -1e-4]);
    let convex = Nominal::of(&map(&cap), Form::Sphere, None).unwrap();
    assert_relative_eq!(convex.curvature, 1e3, max_relative = 1e-9);
    assert!(convex.rest < 1e-16 && convex.deviation < 1e-5, "{convex:?}");
    let concave = Nominal::of(&map(|x, y| 1e-3 - cap(x, y)), Form::Sphere, None).unwrap();
    assert_relative_eq!(concave.curvature, -1e3, max_relative = 1e-9);
    // A cylinder at 30 degrees to x, its axis tilted by 1/10.
    let (sin, cos) = 30f64.to_radians().sin_cos();
    let (radius, slope) = (5e-3, 0.1);
    let tilted = |x: f64, y: f64| {
        let (u, v) = (x * cos + y * sin, y * cos - x * sin);
        slope * u - (radius - (radius * radius - v * v).sqrt()) * (1.0 + slope * slope).sqrt()
    };
    let cylinder = Nominal::of(&map(tilted), Form::Cylinder, None).unwrap();
    assert_relative_eq!(cylinder.radius()[0], radius, max_relative = 1e-9);
    assert_relative_eq!(cylinder.direction().unwrap(), 30f64.to_radians(), max_relative = 1e-9);
    assert!(map(tilted).without(&cylinder).heights().iter().all(|one| one.abs() < 1e-15));
    let roller = |x: f64, _: f64| ball(2e-3, [1e-4, 0.0])(x, 0.0);
    for form in [Form::CylinderY, Form::Cylinder] {
        let along_y = Nominal::of(&map(roller), form, None).unwrap();
        assert_relative_eq!(along_y.curvature, 500.0, max_relative = 1e-9);
    }
    // Along x the same roller has no curvature across.
    let across = Nominal::of(&map(roller), Form::CylinderX, None).unwrap();
    assert!(across.curvature.abs() < 1e-6 && across.rest > 1e-6, "{across:?}");
}

/// A hemisphere but for its rim, from a start that lies beyond the sphere.
#[test]
fn steep_shapes_and_planes_are_found() {
    let radius = 0.5 * POINTS as f64 * PIXEL;
    let steep = map(|x, y| ball(radius, [0.0; 2])(x, y));
    assert_relative_eq!(
        Nominal::of(&steep, Form::Sphere, None).unwrap().radius()[0],
        radius,
        max_relative = 1e-6
    );
    let plane = Nominal::of(&map(|x, y| 0.1 * x - 0.2 * y), Form::Sphere, None).unwrap();
    assert!(plane.curvature.abs() < 1e-9, "{plane:?}");
}

#[test]
fn a_given_radius_is_kept() {
    let cap = map(ball(1e-3, [1e-4, 0.0]));
    let exact = Nominal::of(&cap, Form::Sphere, Some(1e-3)).unwrap();
    assert!(exact.rest < 1e-15 && exact.deviation == 0.0, "{exact:?}");
    let other = Nominal::of(&cap, Form::Sphere, Some(2e-3)).unwrap();
    assert_relative_eq!(other.radius()[0], 2e-3, max_relative = 1e-14);
    assert!(other.rest > 1e-6);
    let refused = Nominal::of(&cap, Form::Sphere, Some(1e-4));
    assert_eq!(refused, Err(NoForm::Small { radius: 1e-4 }));
}

/// The radius lies within two of its standard deviations in 95 of 100 maps, with noise of independent points and with noise that goes
/// together over 3 x 3 points, whose deviation is three times as large.
#[test]
fn radii_are_as_uncertain_as_they_say() {
    let (radius, noise) = (5e-3, 0.2e-6);
    let mut deviations = [0.0; 2];
    for (together, deviation) in [1, 3].into_iter().zip(&mut deviations) {
        let (mut within, mut curvatures) = (0, vec![]);
        for seed in 0..100 {
            let mut random = Rng::with_seed(seed);
            let wide = POINTS + together;
            let white: Vec<f64> = (0..wide * wide).map(|_| normal(&mut random)).collect();
            // A running mean of squares, of the standard deviation of the white noise.
            let at = |at: usize| {
                let (x, y) = (at % POINTS, at / POINTS);
                let near = (0..together * together)
                    .map(|k| (x + k % together) + wide * (y + k / together));
                near.map(|place| white[place]).sum::<f64>() / together as f64
            };
            let cap = map(ball(radius, [5e-5, 0.0]));
            let noisy = cap.heights().iter().enumerate().map(|(place, z)| z + noise * at(place));
            let noisy = HeightMap::new(cap.elements(), cap.pixel(), noisy.collect()).unwrap();
            let found = Nominal::of(&noisy, Form::Sphere, None).unwrap();
            let [value, uncertainty] = found.radius();
            within += usize::from((value - radius).abs() < 2.0 * uncertainty);
            curvatures.push(found.curvature);
            *deviation += found.deviation / 100.0;
        }
        // Of 100 the binomial distribution of 95 % leaves 88 to 100 with 99.8 %.
        assert!(within >= 88, "{within} of 100 at {together}");
        // The scatter of 100 values is known to 7 %.
        let mean = curvatures.iter().sum::<f64>() / 100.0;
        let scatter = curvatures.iter().map(|one| (one - mean).powi(2)).sum::<f64>() / 99.0;
        assert_relative_eq!(*deviation, scatter.sqrt(), max_relative = 0.2);
    }
    // Three times, but for what goes together across the edges of blocks of 8 points: the share 1 - l/8 of a lag of l points counts.
    let across = (1.0 + 2.0 * (2.0 / 3.0 * 7.0 / 8.0 + 1.0 / 3.0 * 6.0 / 8.0)) / 3.0;
    assert_relative_eq!(deviations[1] / deviations[0], 3.0 * across, max_relative = 0.04);
}
