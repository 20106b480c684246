use std::f64::consts::{FRAC_PI_2, PI};

use approx::assert_relative_eq;
use ellip::{ellipe, ellipk};

use super::{Indentation, Stretches};
use crate::closed_form::spence::uncoupled_friction;

/// Of a rigid indenter on bodies of Poisson ratio 0.3 and 0.
const STEEL: f64 = 2.0 / 7.0;
const CORK: f64 = 0.5;

/// Reference values: coupling, stick ratio, friction and, for steel, load.
#[test]
fn spences_solution() {
    let rows = [
        (STEEL, 0.5, 0.15249, Some(1.0274)),
        (STEEL, 0.8, 0.23801, Some(1.0389)),
        (STEEL, 0.9, 0.30390, Some(1.0445)),
        (CORK, 0.5, 0.29874, None),
    ];
    for (coupling, stick_ratio, friction, load) in rows {
        let found = Indentation::at_stick_ratio(2.0, coupling, stick_ratio).unwrap();
        assert_relative_eq!(found.friction, friction, max_relative = 3e-4);
        if let Some(load) = load {
            assert_relative_eq!(found.relative_load, load, epsilon = 1e-4);
        }
    }
}

/// Errors fall with the square of the number of stretches, or nearly so.
#[test]
fn stretches_converge() {
    for (coupling, stick_ratio) in [(STEEL, 0.8), (CORK, 0.5), (CORK, 0.05), (CORK, 0.95)] {
        let friction = |count: usize| {
            let stretches = Stretches::new(count, stick_ratio).unwrap();
            Indentation::on(&stretches, 2.0, coupling).unwrap().friction
        };
        let [coarse, middle, fine] = [60, 120, 240].map(friction);
        assert!((middle - coarse).abs() > 3.0 * (fine - middle).abs());
        assert_relative_eq!(fine, middle, max_relative = 6e-4);
    }
}

/// Without coupling the closed form is exact; what coupling does is of second order.
#[test]
fn weak_coupling_meets_the_closed_form() {
    for stick_ratio in [1e-4, 0.05, 0.5, 0.95] {
        let found = Indentation::at_stick_ratio(2.0, 1e-3, stick_ratio).unwrap();
        let closed = uncoupled_friction(stick_ratio, 1e-3);
        assert_relative_eq!(found.friction, closed, max_relative = 3e-4);
        assert_relative_eq!(found.relative_load, 1.0, epsilon = 3e-4);
        assert_relative_eq!(found.relative_approach, 1.0, epsilon = 3e-4);
    }
}

/// Spence (1968): cones, spheres and blunter punches stick equally.
#[test]
fn the_profile_does_not_matter() {
    for stick_ratio in [0.3, 0.8] {
        let friction = |exponent: f64| {
            let found = Indentation::at_stick_ratio(exponent, -CORK, stick_ratio);
            found.unwrap().friction
        };
        let sphere = friction(2.0);
        for exponent in [1.0, 3.0, 6.0] {
            assert_relative_eq!(friction(exponent), sphere, max_relative = 3e-4);
        }
    }
}

#[test]
fn friction_leads_back_to_the_stick_zone() {
    for (coupling, stick_ratio) in [(STEEL, 0.01), (STEEL, 0.5), (CORK, 0.98)] {
        let state = Indentation::at_stick_ratio(2.0, coupling, stick_ratio).unwrap();
        let found = Indentation::at_friction(2.0, coupling, state.friction).unwrap();
        assert_relative_eq!(found.stick_ratio, stick_ratio, max_relative = 1e-7);
    }
}

/// Friction is used up in the annulus, to what P and Q linear between places leave, and not inside.
#[test]
fn tractions_stay_within_friction() {
    let state = Indentation::at_stick_ratio(2.0, STEEL, 0.5).unwrap();
    let used = |place: f64| {
        let limit = state.friction * state.relative_pressure(place);
        state.relative_traction(place) / limit
    };
    for place in [0.02, 0.1, 0.3, 0.49] {
        assert!((0.0..0.999).contains(&used(place)), "{} at {place}", used(place));
    }
    for place in [0.5, 0.55, 0.7, 0.9, 0.98] {
        assert_relative_eq!(used(place), 1.0, epsilon = 1e-3);
    }
    assert_eq!((state.relative_traction(0.0), state.relative_pressure(1.0)), (0.0, 0.0));
}

/// Midpoint sum of a function from 0 to 1.
fn integral(count: i32, function: impl Fn(f64) -> f64) -> f64 {
    let place = |i: i32| (f64::from(i) + 0.5) / f64::from(count);
    (0..count).map(|i| function(place(i))).sum::<f64>() / f64::from(count)
}

#[test]
fn pressures_carry_the_load() {
    for exponent in [1.0, 2.0, 5.0] {
        let state = Indentation::at_stick_ratio(exponent, CORK, 0.7).unwrap();
        let load = integral(2000, |s| {
            let (sine, cosine) = (FRAC_PI_2 * s).sin_cos();
            PI * sine * cosine * state.relative_pressure(sine)
        });
        assert_relative_eq!(load, state.relative_load, max_relative = 3e-4);
    }
}

/// The normal displacement of a half-space by its definition, from pressures over the directions
/// from the place and the distances along them and from a ring of outward traction as -beta q
/// inside it: (pi/2) (D - r^2/2), in units in which the mean pressure without friction is 4/3.
#[test]
fn the_surface_takes_the_shape_of_the_sphere() {
    let state = Indentation::at_stick_ratio(2.0, CORK, 0.6).unwrap();
    for place in [0.0, 0.4, 0.8] {
        let pressed = integral(150, |direction| {
            let (sine, cosine) = (PI * direction).sin_cos();
            let half = (1.0 - (place * sine).powi(2)).sqrt();
            let length = half - place * cosine;
            // Dense towards the edge, where pressures end steeply.
            integral(150, |s| {
                let along = length * s * (2.0 - s);
                let distance = (place + along * cosine).hypot(along * sine).min(1.0);
                2.0 * (1.0 - s) * length * state.relative_pressure(distance)
            })
        });
        let width = 1.0 - place;
        let drawn = integral(2000, |s| width * state.relative_traction(place + width * s));
        let expected = 0.75 * FRAC_PI_2 * (state.relative_approach - 0.5 * place * place);
        assert_relative_eq!(pressed - CORK * drawn, expected, max_relative = 3e-4);
    }
}

/// The radial displacement by its definition: a ring of traction at s as
/// 2 q s [K(k) - E(k)]/(pi m) with m = min(r, s) and k the ratio of r and s below 1, and a ring of
/// pressure as -beta p s/r outside it. What sticks has moved inwards as r^2.
#[test]
fn what_sticks_moved_in_as_the_square_of_the_radius() {
    let state = Indentation::at_stick_ratio(2.0, CORK, 0.6).unwrap();
    let moved = |r: f64| {
        let drawn = |s: f64| {
            let square = (r.min(s) / r.max(s)).powi(2);
            let rings = ellipk(square).unwrap() - ellipe(square).unwrap();
            state.relative_traction(s) * s * rings * 2.0 / (PI * r.min(s))
        };
        // Dense at the place, where the kernel is a logarithm.
        let inside = integral(2000, |x| 2.0 * x * r * drawn(r * (1.0 - x * x)));
        let outside = integral(2000, |x| 2.0 * x * (1.0 - r) * drawn(r + (1.0 - r) * x * x));
        let pressed = integral(2000, |x| r * x * r * state.relative_pressure(r * x));
        inside + outside - CORK * pressed / r
    };
    let multiple = moved(0.5) / 0.25;
    assert!(multiple < -0.1);
    // Both parts grow as r and nearly cancel in the middle.
    for r in [0.1, 0.2, 0.35, 0.59] {
        assert_relative_eq!(moved(r), multiple * r * r, epsilon = 2e-4 * r);
    }
    // What still slips has part of its way in before it.
    let ways = [0.7, 0.9, 0.99].map(|r| moved(r) / (multiple * r * r));
    assert!(0.999 > ways[0] && ways[0] > ways[1] && ways[1] > ways[2], "{ways:?}");
}

#[test]
fn nothing_outside_what_it_covers() {
    let state = Indentation::at_stick_ratio;
    for (exponent, coupling, stick_ratio) in
        [(0.0, STEEL, 0.5), (2.0, 0.0, 0.5), (2.0, 1.0, 0.5), (2.0, STEEL, 0.999)]
    {
        assert_eq!(state(exponent, coupling, stick_ratio), None);
    }
    assert_eq!(state(f64::NAN, STEEL, 0.5), None);
    for friction in [0.0, f64::NAN, 0.01, 5.0] {
        assert_eq!(Indentation::at_friction(2.0, STEEL, friction), None);
    }
}
