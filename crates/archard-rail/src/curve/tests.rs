use std::f64::consts::TAU;

use super::{Curve, Smoothing};

fn wave(length: f64, count: usize) -> Vec<[f64; 2]> {
    let mut random = fastrand::Rng::with_seed(3);
    let places = (0..count).map(|at| (at as f64 + 0.8 * random.f64()) * 1e-4);
    places.map(|y| [y, 1e-6 * (TAU * y / length).sin()]).collect()
}

/// Half the height stays at the wavelength, 16/17 at twice it, whatever the spacing of the points: the formula of the
/// continuous spline; the rest is the uneven spacing of 1/50 to 1/100 wavelength.
#[test]
fn the_filter_halves_waves_of_its_length() {
    for (length, share) in [(5e-3, 0.5), (10e-3, 16.0 / 17.0)] {
        let curve = Curve::new(&wave(length, 1000), Smoothing::wavelength(5e-3)).unwrap();
        let crest = curve.samples(1e-4).into_iter().map(|along| curve.point(along));
        let middle = crest.filter(|point| (0.03..0.07).contains(&point[0]));
        let height = middle.fold(0.0, |most: f64, point| most.max(point[1]));
        assert!((height / 1e-6 - share).abs() < 0.005, "{length}: {height}");
    }
}

#[test]
fn a_circle_has_its_radius() {
    let points: Vec<[f64; 2]> = (-200..=200)
        .map(|at| f64::from(at) * 2e-3)
        .map(|angle| [0.3 * angle.sin(), 0.3 - 0.3 * angle.cos()])
        .collect();
    let curve = Curve::new(&points, Smoothing::NONE).unwrap();
    let place = curve.place(curve.length() / 2.0 + 1e-4);
    // Spacing over radius 2e-3, squared over 24: 2e-7; the curvature keeps a part of (spacing/radius)^2/12.
    assert!((place.curvature * 0.3 - 1.0).abs() < 1e-6, "{place:?}");
    assert!((place.point[0].hypot(place.point[1] - 0.3) - 0.3).abs() < 1e-12);
    assert!(place.normal()[1] < 0.0, "out of the rail is up");
}

#[test]
fn a_lone_corner_stays() {
    let mut points: Vec<[f64; 2]> = (0..=20).map(|at| [f64::from(at) * 1e-3, 0.0]).collect();
    points.extend((1..=20).map(|at| [20e-3, f64::from(at) * 1e-3]));
    let curve = Curve::new(&points, Smoothing::wavelength(3e-3)).unwrap();
    let [before, after] = [-1e-6, 1e-6].map(|off| curve.place(20e-3 + off).tangent);
    assert!((before[0] - 1.0).abs() < 1e-9 && (after[1] - 1.0).abs() < 1e-9);
}
