use approx::assert_relative_eq;

use super::{Convolution, Difference, Parity, even_smooth};

/// The sum a convolution stands for, term by term.
fn direct(size: [usize; 2], kernel: &[f64], parity: [Parity; 2], field: &[f64]) -> Vec<f64> {
    let [nx, ny] = size;
    let value = |i: usize, j: usize| {
        let mut sum = 0.0;
        for (source, strength) in field.iter().enumerate() {
            let (p, q) = (source % nx, source / nx);
            let sign_x = if p > i { parity[0].sign() } else { 1.0 };
            let sign_y = if q > j { parity[1].sign() } else { 1.0 };
            sum += sign_x * sign_y * kernel[i.abs_diff(p) + nx * j.abs_diff(q)] * strength;
        }
        sum
    };
    (0..nx * ny).map(|pair| value(pair % nx, pair / nx)).collect()
}

/// Values without pattern between -1 and 1.
fn scattered(count: usize, seed: f64) -> Vec<f64> {
    (0..count).map(|i| (12.9898 * (i as f64 + seed)).sin() * 43758.5453 % 1.0).collect()
}

#[test]
fn every_parity_equals_the_sum() {
    for size in [[7, 5], [9, 20], [16, 3]] {
        let [nx, ny] = size;
        let convolution = Convolution::padded(size);
        for parity in [
            [Parity::Even; 2],
            [Parity::Odd; 2],
            [Parity::Odd, Parity::Even],
            [Parity::Even, Parity::Odd],
        ] {
            let kernel = |seed: f64, parity: [Parity; 2]| {
                let mut kernel = scattered(nx * ny, seed);
                for (pair, value) in kernel.iter_mut().enumerate() {
                    let offset = [pair % nx, pair / nx];
                    if (0..2).any(|axis| offset[axis] == 0 && parity[axis] == Parity::Odd) {
                        *value = 0.0;
                    }
                }
                kernel
            };
            let opposite = parity.map(|own| match own {
                Parity::Even => Parity::Odd,
                Parity::Odd => Parity::Even,
            });
            let (kernel, other) = (kernel(0.3, parity), kernel(3.1, opposite));
            let field = scattered(nx * ny, 7.7);
            let expected = direct(size, &kernel, parity, &field);
            let alone = convolution.spectrum(&kernel, nx, parity);
            let [_, paired] = convolution.spectrum_pair([&other, &kernel], nx, [opposite, parity]);
            for spectrum in [alone, paired] {
                let mut result = vec![0.0; nx * ny];
                convolution.apply_matrix([[(&spectrum, 1.0)]], [&field], [&mut result]);
                for (a, b) in result.iter().zip(&expected) {
                    assert_relative_eq!(a, b, epsilon = 1e-12);
                }
                if !spectrum.is_imaginary() {
                    let mut result = vec![0.0; nx * ny];
                    convolution.apply(&spectrum, &field, &mut result);
                    for (a, b) in result.iter().zip(&expected) {
                        assert_relative_eq!(a, b, epsilon = 1e-12);
                    }
                }
            }
        }
    }
}

/// Two fields under a symmetric matrix of kernels, and the difference of the results along both axes
/// in both senses, against sums over the elements.
#[test]
fn pairs_and_differences_equal_the_sum() {
    for size in [[7, 5], [8, 15]] {
        let [nx, ny] = size;
        let convolution = Convolution::padded(size);
        // One more offset than the field has, for the neighbours of its outermost elements.
        let kernel = |seed: f64| scattered((nx + 1) * (ny + 1), seed);
        let mut kernels = [kernel(0.1), kernel(0.2), kernel(0.3)];
        for (place, value) in kernels[1].iter_mut().enumerate() {
            let offset = [place % (nx + 1), place / (nx + 1)];
            if offset[0] % nx == 0 || offset[1] % ny == 0 {
                *value = 0.0;
            }
        }
        let parities = [[Parity::Even; 2], [Parity::Odd; 2], [Parity::Even; 2]];
        let spectra =
            [0, 1, 2].map(|index| convolution.spectrum(&kernels[index], nx + 1, parities[index]));
        let fields = [scattered(nx * ny, 5.1), scattered(nx * ny, 6.3)];
        // The result at an element, which may lie one outside the field.
        let at = |component: usize, x: isize, y: isize| -> f64 {
            let mut sum = 0.0;
            for (other, (one, two)) in fields[0].iter().zip(&fields[1]).enumerate() {
                let offset = [x - (other % nx) as isize, y - (other / nx) as isize];
                let place = offset[0].unsigned_abs() + (nx + 1) * offset[1].unsigned_abs();
                let sign = (offset[0].signum() * offset[1].signum()) as f64;
                let [xx, xy, yy] = [0, 1, 2].map(|index| kernels[index][place]);
                sum += if component == 0 {
                    xx * one + sign * xy * two
                } else {
                    sign * xy * one + yy * two
                };
            }
            sum
        };
        let kernels = spectra.each_ref();
        let inputs = [&fields[0][..], &fields[1][..]];
        let (mut one, mut two) = (vec![0.0; nx * ny], vec![0.0; nx * ny]);
        for (axis, reversed) in [(0, false), (0, true), (1, false), (1, true)] {
            let difference = Difference::new(&convolution, axis, reversed);
            convolution.apply_differenced(kernels, &difference, inputs, [&mut one, &mut two]);
            let shift = if reversed { 1 } else { -1 };
            for pair in 0..nx * ny {
                let [x, y] = [(pair % nx) as isize, (pair / nx) as isize];
                let upstream = if axis == 0 { [x + shift, y] } else { [x, y + shift] };
                for (component, found) in [one[pair], two[pair]].into_iter().enumerate() {
                    let expected = at(component, x, y) - at(component, upstream[0], upstream[1]);
                    assert_relative_eq!(found, expected, epsilon = 1e-11);
                }
            }
        }
        convolution.apply_pair(kernels, inputs, [&mut one, &mut two]);
        for pair in 0..nx * ny {
            let [x, y] = [(pair % nx) as isize, (pair / nx) as isize];
            assert_relative_eq!(one[pair], at(0, x, y), epsilon = 1e-11);
            assert_relative_eq!(two[pair], at(1, x, y), epsilon = 1e-11);
        }
    }
}

#[test]
fn periods_have_small_factors() {
    assert_eq!([60, 82, 1024, 14].map(even_smooth), [60, 90, 1024, 16]);
}

/// Waves are multiplied, and shifted by a quarter where the spectrum is odd along one axis.
#[test]
fn a_transfer_multiplies_waves() {
    let size @ [nx, ny] = [12, 10];
    let convolution = Convolution::periodic(size);
    let value = |[x, y]: [usize; 2]| 1.0 + x as f64 + 10.0 * y as f64;
    let even = convolution.transfer([Parity::Even; 2], value);
    let odd = convolution.transfer([Parity::Odd, Parity::Even], value);
    for waves in [[0, 0], [1, 0], [2, 3], [5, 4], [6, 5]] {
        let wave = |phase: f64| -> Vec<f64> {
            let turns = |i: usize| {
                (waves[0] * (i % nx)) as f64 / nx as f64 + (waves[1] * (i / nx)) as f64 / ny as f64
            };
            (0..nx * ny).map(|i| (std::f64::consts::TAU * turns(i) + phase).cos()).collect()
        };
        let vanishes = waves[0] == 0 || 2 * waves[0] == nx;
        let quarter = wave(std::f64::consts::FRAC_PI_2);
        let shifted = if vanishes { vec![0.0; nx * ny] } else { quarter };
        for (spectrum, expected) in [(&even, wave(0.0)), (&odd, shifted)] {
            let mut result = vec![0.0; nx * ny];
            convolution.apply_matrix([[(spectrum, 1.0)]], [&wave(0.0)], [&mut result]);
            for (found, expected) in result.iter().zip(expected) {
                assert_relative_eq!(*found, value(waves) * expected, epsilon = 1e-11);
            }
        }
    }
}
