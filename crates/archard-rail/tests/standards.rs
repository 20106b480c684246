//! The profiles of the standards against those of the Manchester benchmark, if `ARCHARD_WHEEL_RAIL` names their folder.

mod common;

use archard_rail::curve::{Curve, Smoothing};
use archard_rail::file::Format;
use archard_rail::setup::Track;
use archard_rail::standard::{rail_60e1, wheel_s1002_depth};
use archard_rail::{Part, Profile};

/// The file has eight digits: 1e-8 m is asked for.
#[test]
fn the_wheel_is_the_benchmarks() {
    let Some(folder) = common::folder() else { return };
    let document = common::document(&folder, "MBench_S1002_v3.prw", Format::Simpack(Part::Wheel));
    assert_eq!(document.findings, []);
    let off = |point: &[f64; 2]| wheel_s1002_depth(point[0]).map(|z| (z - point[1]).abs());
    let worst = document.profile.points.iter().filter_map(off).fold(0.0, f64::max);
    eprintln!("S1002: {} points, worst {:.1e} m", document.profile.points.len(), worst);
    assert!(worst < 1e-8, "{worst}");
}

/// The least distance (m) from a point to the curve.
fn distance(curve: &Curve, [y, z]: [f64; 2]) -> f64 {
    let steps = (curve.length() / 1e-5) as usize;
    let all = (0..=steps).map(|at| curve.point(at as f64 * 1e-5));
    all.map(|point| (point[0] - y).hypot(point[1] - z)).fold(f64::MAX, f64::min)
}

/// Distances of the benchmark's points down to the gauge height from the drawing, the tops put together. The file's place
/// along y is its own, so the drawing is moved there to where the largest distance is least: 0.04 mm is asked for. The
/// file's arcs end 10.49 and 25.99 mm next to the middle, the drawing's 10.23 and 26.03.
#[test]
fn the_rail_is_the_benchmarks() {
    let Some(folder) = common::folder() else { return };
    let document = common::document(&folder, "MBench_UIC60_v3.prr", Format::Simpack(Part::Rail));
    for finding in &document.findings {
        eprintln!("{finding}");
    }
    let track = Track::standard();
    let upright = Track { cant: 0.0, ..track };
    let place = |track: Track, profile: &Profile| {
        let curve = profile.curve(Smoothing::NONE).unwrap();
        track.place(&curve).unwrap().curve(&curve)
    };
    let drawn = place(track, &rail_60e1(1e-4).unwrap());
    let file = place(upright, &document.profile);
    let nodes = file.nodes().iter().map(|&along| file.point(along));
    let compared: Vec<[f64; 2]> = nodes.filter(|point| point[1] < 14e-3).collect();
    let worst = |aside: f64| {
        let distances = compared.iter().map(|[y, z]| distance(&drawn, [y + aside, *z]));
        distances.fold(0.0, f64::max)
    };
    let least = (-4..=4).map(|step| worst(f64::from(step) * 1e-6)).fold(f64::MAX, f64::min);
    eprintln!(
        "60E1: {} points down to 14 mm, worst {:.4} mm, {:.4} mm with the gauge faces put together",
        compared.len(),
        least * 1e3,
        worst(0.0) * 1e3
    );
    assert!(least < 4e-5, "{least}");
}

/// A filter 1/(1 + (a q)^4) moves a curve whose curvature jumps by J by at most 0.1612 J a^2: J a^2/2 times the largest
/// exp(-u) sin(u). With a = 5 mm/2 pi that is 0.0066 mm between the arcs of 80 and 13 mm, where the file's points are 0.2 mm
/// apart, and 0.0079 mm between that of 13 mm and the straight side, where they are 1.5 mm apart and the curve through them
/// waves. A twentieth of the larger one is left for both.
#[test]
fn smoothing_keeps_the_benchmarks_rail() {
    let Some(folder) = common::folder() else { return };
    let profile =
        common::document(&folder, "MBench_UIC60_v3.prr", Format::Simpack(Part::Rail)).profile;
    let [plain, smooth] =
        [Smoothing::NONE, Smoothing::wavelength(5e-3)].map(|by| profile.curve(by).unwrap());
    let nodes = plain.nodes().iter();
    let off = nodes.map(|&along| {
        let (from, to) = (plain.point(along), smooth.point(along));
        (from[0] - to[0]).hypot(from[1] - to[1])
    });
    let worst = off.fold(0.0, f64::max);
    eprintln!("smoothed by 5 mm: moved by up to {:.4} mm", worst * 1e3);
    assert!(worst < 1.05 * 7.9e-6, "{worst}");
}
