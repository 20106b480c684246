use super::{rail_60e1, wheel_s1002, wheel_s1002_depth};
use crate::profile::Part;

/// The pieces meet as well as the ten digits of the coefficients allow: at -35 mm terms of 36 m cancel, each rounded by up to
/// 5e-10 of itself.
#[test]
fn the_wheel_has_no_steps() {
    for joint in [32.15796e-3, -26e-3, -35e-3, -38.426669e-3, -39.7645e-3, -49.6629e-3, -62.7647e-3]
    {
        let [before, after] = [-1e-10, 1e-10].map(|off| wheel_s1002_depth(joint + off).unwrap());
        assert!((before - after).abs() < 2e-7, "{joint}: {}", before - after);
    }
    // The drawing: 28 mm of flange at -55 mm, the running circle at 0.
    assert!((wheel_s1002_depth(-55e-3).unwrap() - 28e-3).abs() < 1e-9);
    assert_eq!(wheel_s1002_depth(0.0), Some(0.0));
    assert_eq!([61e-3, -70.1e-3, f64::NAN].map(wheel_s1002_depth), [None; 3]);
}

/// 72 mm of width 14.3 mm below the top, which the arcs do not know: the drawing rounds to 0.1 mm.
#[test]
fn the_rail_meets_its_width() {
    let rail = rail_60e1(1e-4).unwrap();
    let near = rail.points.iter().filter(|point| point[0] > 0.0);
    let at = near.min_by(|a, b| (a[1] - 14.3e-3).abs().total_cmp(&(b[1] - 14.3e-3).abs())).unwrap();
    assert!((at[0] - (36e-3 + (at[1] - 14.3e-3) / 20.0)).abs() < 2e-6, "{at:?}");
}

#[test]
fn both_are_sound() {
    assert_eq!(rail_60e1(5e-4).unwrap().oddities(Part::Rail), []);
    assert_eq!(wheel_s1002(5e-4).unwrap().oddities(Part::Wheel), []);
    assert!(wheel_s1002(0.0).is_err() && rail_60e1(f64::NAN).is_err());
}
