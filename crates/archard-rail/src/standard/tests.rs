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

/// The last arc ends 36 mm next to the middle, 14.3 mm below the top: the drawing's digits.
#[test]
fn the_rail_ends_where_it_is_drawn() {
    let rail = rail_60e1(1e-4).unwrap();
    let end = |point: &&[f64; 2]| (point[0] - 36e-3).hypot(point[1] - 14.3e-3) < 1e-12;
    assert_eq!(rail.points.iter().filter(end).count(), 1);
}

#[test]
fn both_are_sound() {
    assert_eq!(rail_60e1(5e-4).unwrap().oddities(Part::Rail), []);
    assert_eq!(wheel_s1002(5e-4).unwrap().oddities(Part::Wheel), []);
    assert!(wheel_s1002(0.0).is_err() && rail_60e1(f64::NAN).is_err());
}
