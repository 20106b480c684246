use approx::assert_relative_eq;

use super::{DegenerateCloud, Derivative};

/// Angles of the direction to the x axis, among them both symmetries of a square grid.
const ANGLES: [f64; 6] = [0.0, 0.3, std::f64::consts::FRAC_PI_4, 1.2, 2.5, -1.9];

/// Numbers spread evenly over -1..1 without pattern: a linear congruential generator (Knuth's MMIX).
fn noise() -> impl FnMut() -> f64 {
    let mut state = 1_u64;
    move || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// A grid, x running fastest, with every point shaken along both axes by up to a share of the spacing.
fn grid(elements: [usize; 2], spacing: [f64; 2], shaken: f64) -> Vec<[f64; 2]> {
    let mut noise = noise();
    let points = 0..elements[0] * elements[1];
    let index = points.map(|point| [point % elements[0], point / elements[0]]);
    index
        .map(|index| [0, 1].map(|axis| spacing[axis] * (index[axis] as f64 + shaken * noise())))
        .collect()
}

fn unit(angle: f64) -> [f64; 2] {
    [angle.cos(), angle.sin()]
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn applied(derivative: &Derivative, values: &[f64]) -> Vec<f64> {
    let mut out = vec![f64::NAN; values.len()];
    derivative.apply(values, &mut out);
    out
}

#[test]
fn a_turned_grid_has_the_upwind_difference() {
    let n = [17, 11];
    for spacing in [[1e-4, 1e-4], [1e-3, 1e-4], [1e-4, 1e-3]] {
        for angle in ANGLES {
            let [x, y] = unit(angle);
            let turn = |p: &[f64; 2]| [x * p[0] - y * p[1] + 0.01, y * p[0] + x * p[1] - 0.02];
            let places: Vec<_> = grid(n, spacing, 0.0).iter().map(turn).collect();
            let derivative = Derivative::along(&places, [3.0 * x, 3.0 * y]).unwrap();
            let mut noise = noise();
            let values: Vec<f64> = places.iter().map(|_| noise()).collect();
            for (point, slope) in applied(&derivative, &values).into_iter().enumerate() {
                // Where particles enter, the difference to the next point.
                let last = if point % n[0] == 0 { point + 1 } else { point };
                let difference = (values[last] - values[last - 1]) / spacing[0];
                // Places of 0.02 m are rounded by 1e-14 of the spacing.
                assert_relative_eq!(slope, difference, epsilon = 1e-12 / spacing[0]);
            }
            let entering: Vec<usize> = (0..n[1]).map(|row| row * n[0]).collect();
            assert_eq!(derivative.extrapolated(), entering);
        }
    }
}

#[test]
fn particles_come_from_the_point_before_or_from_between_others() {
    let places = grid([9, 7], [1.0; 2], 0.0);
    let values: Vec<f64> = places.iter().map(|[x, y]| (x * x + 3.0 * y).sin()).collect();
    let upstream = |places: &[[f64; 2]], values: &[f64], angle| {
        let mut out = vec![f64::NAN; values.len()];
        Derivative::along(places, unit(angle)).unwrap().upstream(values, &mut out);
        out
    };
    for (point, found) in upstream(&places, &values, 0.0).into_iter().enumerate() {
        let before = if point % 9 == 0 { point + 1 } else { point - 1 };
        assert_relative_eq!(found, values[before], epsilon = 1e-14);
    }
    let places = grid([9, 7], [1.0; 2], 0.2);
    for angle in ANGLES {
        for mean in upstream(&places, &vec![1.0; places.len()], angle) {
            assert_relative_eq!(mean, 1.0, epsilon = 1e-9);
        }
    }
}

#[test]
fn linear_fields_are_exact_up_to_the_border() {
    for shaken in [0.0, 0.2, 0.5] {
        let places = grid([20, 15], [1.0, 0.7], shaken);
        let values: Vec<f64> = places.iter().map(|[x, y]| 5.0 + 2.0 * x - 3.0 * y).collect();
        for angle in ANGLES {
            let [x, y] = unit(angle);
            let derivative = Derivative::along(&places, [x, y]).unwrap();
            for slope in applied(&derivative, &values) {
                assert_relative_eq!(slope, 2.0 * x - 3.0 * y, epsilon = 1e-11);
            }
        }
    }
}

/// Root mean square error for a smooth field on a shaken grid of n by n points over the unit square.
fn error(n: usize, angle: f64) -> f64 {
    let places = grid([n, n], [1.0 / n as f64; 2], 0.2);
    let derivative = Derivative::along(&places, unit(angle)).unwrap();
    let values: Vec<f64> = places.iter().map(|[x, y]| (3.0 * x).sin() * (2.0 * y).cos()).collect();
    let [along_x, along_y] = unit(angle);
    let exact = places.iter().map(|[x, y]| {
        along_x * 3.0 * (3.0 * x).cos() * (2.0 * y).cos()
            - along_y * 2.0 * (3.0 * x).sin() * (2.0 * y).sin()
    });
    let slopes = applied(&derivative, &values);
    let sum: f64 = slopes.iter().zip(exact).map(|(slope, exact)| (slope - exact).powi(2)).sum();
    (sum / places.len() as f64).sqrt()
}

#[test]
fn the_error_on_shaken_grids_is_of_first_order() {
    for angle in ANGLES {
        let order = (error(20, angle) / error(80, angle)).log(4.0);
        assert!((0.9..1.2).contains(&order), "order {order} at {angle} rad");
    }
}

#[test]
fn a_checkerboard_has_a_slope_whatever_the_direction() {
    let n = 12;
    let values: Vec<f64> =
        (0..n * n).map(|point| if (point % n + point / n) % 2 == 0 { 1.0 } else { -1.0 }).collect();
    for angle in ANGLES {
        let derivative = Derivative::along(&grid([n, n], [1.0; 2], 0.0), unit(angle)).unwrap();
        let [x, y] = unit(angle);
        for (point, slope) in applied(&derivative, &values).into_iter().enumerate() {
            // The sum of the upwind differences, each of them 2.
            if !derivative.extrapolated().contains(&point) {
                assert_relative_eq!(slope.abs(), 2.0 * (x.abs() + y.abs()), epsilon = 1e-12);
            }
        }
    }
}

#[test]
fn what_is_convected_leaves_without_growing() {
    for shaken in [0.0, 0.2] {
        for angle in ANGLES {
            let n = 20;
            let places = grid([n, n], [1.0; 2], shaken);
            let derivative = Derivative::along(&places, unit(angle)).unwrap();
            let mut noise = noise();
            let mut values: Vec<f64> = places.iter().map(|_| noise()).collect();
            // Explicit Euler keeps the maximum principle while no step passes a stencil.
            let rate = derivative.rows.iter().map(|row| row.iter().map(|term| term.1.abs()).sum());
            let step = 1.0 / rate.fold(0.0, f64::max);
            for _ in 0..(6.0 * n as f64 / step) as usize {
                derivative.extrapolated().iter().for_each(|&point| values[point] = 0.0);
                let largest =
                    values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
                let slopes = applied(&derivative, &values);
                assert!(dot(&values, &slopes) >= 0.0);
                for (value, slope) in values.iter_mut().zip(slopes) {
                    *value -= step * slope;
                    assert!(value.abs() <= largest * (1.0 + 1e-14));
                }
            }
            derivative.extrapolated().iter().for_each(|&point| values[point] = 0.0);
            let left = values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
            assert!(left < 1e-3, "{left} left at {angle} rad");
        }
    }
}

#[test]
fn all_but_entering_points_look_upstream() {
    let n = 30;
    let places = grid([n, n], [1.0; 2], 0.2);
    for angle in ANGLES {
        let [x, y] = unit(angle);
        let derivative = Derivative::along(&places, [x, y]).unwrap();
        let along = |point: usize| x * places[point][0] + y * places[point][1];
        for (point, row) in derivative.rows.iter().enumerate() {
            if derivative.extrapolated().contains(&point) {
                let border = |index: usize| index == 0 || index == n - 1;
                assert!(border(point % n) || border(point / n), "{point} lies within");
            } else {
                for &(other, weight) in row {
                    let upwind = weight > 0.0 && along(other) < along(point);
                    assert!(upwind || weight.abs() < 1e-10, "{point} looks to {other}");
                }
            }
        }
    }
}

#[test]
fn one_line_will_do_if_it_is_passed_along() {
    let line: Vec<[f64; 2]> = (0..6).map(|i| [f64::from(i), 2.0 * f64::from(i)]).collect();
    let derivative = Derivative::along(&line, [1.0, 2.0]).unwrap();
    assert_eq!(derivative.extrapolated(), [0]);
    let values: Vec<f64> = line.iter().map(|place| 5_f64.sqrt() * place[0]).collect();
    for slope in applied(&derivative, &values) {
        assert_relative_eq!(slope, 1.0, epsilon = 1e-14);
    }
    for direction in [[1.0, 0.0], [-2.0, 1.0], [1.0, 2.001]] {
        let wrong = Derivative::along(&line, direction).unwrap_err();
        assert_eq!(wrong, DegenerateCloud::Collinear);
    }
}

#[test]
fn degenerate_clouds_are_errors() {
    let square = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
    let wrong = |places: &[[f64; 2]], direction| Derivative::along(places, direction).unwrap_err();
    assert_eq!(wrong(&[], [1.0, 0.0]), DegenerateCloud::TooFew { points: 0 });
    assert_eq!(wrong(&square[..2], [1.0, 0.0]), DegenerateCloud::TooFew { points: 2 });
    for direction in [[0.0, 0.0], [f64::INFINITY, 1.0]] {
        assert_eq!(wrong(&square, direction), DegenerateCloud::NoDirection { direction });
    }
    assert!(matches!(wrong(&square, [f64::NAN, 0.0]), DegenerateCloud::NoDirection { .. }));
    let mut places = square;
    places[2][1] = f64::NAN;
    assert_eq!(wrong(&places, [1.0, 0.0]), DegenerateCloud::NotFinite { point: 2 });
    places[2] = places[1];
    assert_eq!(wrong(&places, [1.0, 0.0]), DegenerateCloud::Coincident { points: [1, 2] });
    assert_eq!(wrong(&[[0.3, 0.1]; 4], [1.0, 0.0]), DegenerateCloud::Coincident { points: [0, 1] });
}
