//! A rough surface that is made, not measured: self-affine, periodic, given by a few numbers and a seed.

use std::f64::consts::TAU;

use realfft::num_complex::Complex64;
use rustfft::FftPlanner;

use super::{Profile, Table};
use crate::numerics::SAME;
use crate::parameters::{Bound, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Profile>> = Choice {
    name: "self_affine",
    meaning: "a rough surface of waves of random phase, their amplitudes a power of their length",
    parameters: &[RMS_SLOPE, HURST, SHORT, LONG, PERIOD, ASPECT, SEED],
    build: |values| {
        let long = values.require("long")?;
        Ok(Box::new(SelfAffine::new(Roughness {
            rms_slope: values.require("rms_slope")?,
            hurst: values.require("hurst")?,
            short: values.require("short")?,
            long,
            period: values.number("period").unwrap_or(long),
            aspect: values.number("aspect").unwrap_or(1.0),
            // A count is below 1e9.
            seed: values.number("seed").unwrap_or_default() as u64,
        })?))
    },
};

const RMS_SLOPE: Parameter = Parameter::required(
    "rms_slope",
    Quantity::Number,
    "root mean square of the slope, of both axes together",
);
const HURST: Parameter = Parameter::required(
    "hurst",
    Quantity::Number,
    "Hurst's exponent H: amplitudes are as the wavelength to the power 1 + H",
)
.bound(Bound::UpTo(0.0, 1.0));
const SHORT: Parameter =
    Parameter::required("short", Quantity::Length, "wavelength below which there are no waves");
const LONG: Parameter =
    Parameter::required("long", Quantity::Length, "wavelength above which amplitudes grow no more");
const PERIOD: Parameter = Parameter::optional(
    "period",
    Quantity::Length,
    "length after which the surface repeats itself; `long` if not given",
);
const ASPECT: Parameter = Parameter::optional(
    "aspect",
    Quantity::Number,
    "by how much all lengths along x are longer: 1 (if not given) is isotropic, more than 1 a lay along x",
);
const SEED: Parameter = Parameter::optional(
    "seed",
    Quantity::Count,
    "number of the surface, of all with the same roughness; 0 if not given",
)
.bound(Bound::NonNegative);

/// Points to the shortest wave: the slope between neighbours is that of the wave to 3 % there, and better for all longer.
const POINTS: f64 = 8.0;

/// Most points along an axis: two to each of the 4096 elements that a frame has at most. They take half a gigabyte.
const MOST: f64 = 8192.0;

/// What a self-affine surface is like.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roughness {
    /// Root mean square of the slope.
    pub rms_slope: f64,
    /// Hurst's exponent.
    pub hurst: f64,
    /// Shortest wavelength (m), along y.
    pub short: f64,
    /// Wavelength (m) above which the spectrum is flat, along y.
    pub long: f64,
    /// Length (m) after which the surface repeats itself, along y.
    pub period: f64,
    /// By how much all lengths along x are longer.
    pub aspect: f64,
    /// Which one of such surfaces.
    pub seed: u64,
}

/// z = sum of a(q) cos(q.x + phase) over the wave vectors q of a periodic cell, a as max(q, 2 pi/long)^-(1 + H) up to
/// 2 pi/short, and none beyond; after Persson et al., *J. Phys.: Condens. Matter* 17 (2005) R1, appendix D. Phases are
/// those of Steele, Lea and Flood's generator, whose numbers are the same on every machine.
#[derive(Debug, Clone, PartialEq)]
pub struct SelfAffine {
    /// Two more points beyond each side of the cell, for the cubics between points.
    surface: Table,
    period: [f64; 2],
    places: [Vec<f64>; 2],
}

impl SelfAffine {
    /// A surface of that roughness, known at even points of a cell in the middle, eight and more to the shortest wave.
    ///
    /// # Errors
    /// If a number is out of its range, `short`, `long` and `period` do not rise, or there are too many points.
    pub fn new(given: Roughness) -> Result<Self, Invalid> {
        RMS_SLOPE.admit(given.rms_slope)?;
        HURST.admit(given.hurst)?;
        SHORT.admit(given.short)?;
        LONG.admit(given.long)?;
        PERIOD.admit(given.period)?;
        ASPECT.admit(given.aspect)?;
        let rising = |name, one: f64, other: f64, than| {
            let message = || format!("{other:e} m must not be shorter than `{than}`, {one:e} m");
            if one <= other { Ok(()) } else { Err(Invalid::new(name, message())) }
        };
        rising("long", given.short, given.long, "short")?;
        rising("period", given.long, given.period, "long")?;
        let exact = 0.5 * POINTS * given.period / given.short;
        // Of points that fit to rounding nothing more is found.
        let count = 2.0 * (exact * (1.0 - SAME)).ceil();
        if count > MOST {
            let message = format!(
                "{} points along each axis resolve it, {POINTS} to a wave: at most {MOST}; a longer `short` or a shorter `period` takes fewer",
                count
            );
            return Err(Invalid::new("short", message));
        }
        let count = count as usize;
        let period = [given.aspect * given.period, given.period];
        let places = period.map(|period| {
            let step = period / count as f64;
            (0..count).map(|i| step * (i as f64 - 0.5 * (count - 1) as f64)).collect::<Vec<f64>>()
        });
        let wider = |axis: usize| -> Vec<f64> {
            let step = period[axis] / count as f64;
            let first = places[axis].first().copied().unwrap_or_default();
            (0..count + 2 * BEYOND).map(|i| first + step * (i as f64 - BEYOND as f64)).collect()
        };
        let surface = Table::on_grid([wider(0), wider(1)], heights(given, count))?;
        Ok(Self { surface, period, places })
    }
}

/// Points beyond each side: as many as a cubic reaches.
const BEYOND: usize = 2;

/// Heights (m) at so many points along both axes of one cell and some beyond, those along x first.
fn heights(given: Roughness, count: usize) -> Vec<f64> {
    let [shortest, longest] = [given.short, given.long].map(|length| given.period / length);
    // Waves of the cell: half of the plane of wave vectors, since the others are the same waves.
    let reach = shortest as i64;
    let rows = reach as usize + 1;
    let half = (0..=reach).flat_map(|y| (-reach..=reach).map(move |x| [x, y]));
    let ahead = half.filter(|&[x, y]| y > 0 || x > 0);
    let mut squares = 0.0;
    let mut spectrum = vec![Complex64::default(); count * rows];
    for [x, y] in ahead {
        let waves = (x as f64).hypot(y as f64);
        // A wave that fits to rounding is there.
        if waves > shortest * (1.0 + SAME) {
            continue;
        }
        let amplitude = waves.max(longest).powf(-1.0 - given.hurst);
        let along = TAU / given.period;
        let [slope_x, slope_y] = [along * x as f64 / given.aspect, along * y as f64];
        squares += 0.5 * amplitude * amplitude * (slope_x * slope_x + slope_y * slope_y);
        let phase = TAU * share(random(given.seed, number([x, y])));
        let column = x.rem_euclid(count as i64) as usize;
        spectrum[column + count * y as usize] = Complex64::from_polar(amplitude, phase);
    }
    let scale = given.rms_slope / squares.sqrt();
    let transform = FftPlanner::new().plan_fft_inverse(count);
    spectrum.chunks_exact_mut(count).for_each(|row| transform.process(row));
    let wide = count + 2 * BEYOND;
    let wrapped = |i: usize| (i + count - BEYOND) % count;
    let mut heights = vec![0.0; wide * wide];
    let mut column = vec![Complex64::default(); count];
    for x in 0..count {
        column.fill(Complex64::default());
        (0..rows).for_each(|y| column[y] = spectrum[x + count * y]);
        transform.process(&mut column);
        for along in (0..wide).filter(|&along| wrapped(along) == x) {
            (0..wide).for_each(|y| heights[along + wide * y] = scale * column[wrapped(y)].re);
        }
    }
    heights
}

/// The number of a wave, the same whatever other waves there are.
fn number([x, y]: [i64; 2]) -> u64 {
    // Waves to a cell are far below 2^31.
    (y as u64) << 32 | u64::from(x as i32 as u32)
}

/// The number of that index in the sequence of a seed: Steele, Lea and Flood's SplitMix64 (OOPSLA 2014).
fn random(seed: u64, index: u64) -> u64 {
    let mut mixed = seed.wrapping_add(index.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    mixed = (mixed ^ mixed >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    mixed ^ mixed >> 31
}

/// A number from 0 to 1, of the first 53 bits.
fn share(bits: u64) -> f64 {
    (bits >> 11) as f64 / (1_u64 << 53) as f64
}

impl Profile for SelfAffine {
    fn recess(&self, x: f64, y: f64) -> f64 {
        let [x, y] = [(x, self.period[0]), (y, self.period[1])]
            .map(|(at, period)| at - period * (at / period).round());
        self.surface.recess(x, y)
    }

    fn places(&self) -> [&[f64]; 2] {
        self.places.each_ref().map(|places| &places[..])
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{Roughness, SelfAffine, random};
    use crate::body::Profile;

    const GIVEN: Roughness = Roughness {
        rms_slope: 0.1,
        hurst: 0.8,
        short: 10e-6,
        long: 160e-6,
        period: 320e-6,
        aspect: 1.0,
        seed: 1,
    };

    /// Mean squares of height and of the slopes along x and y: central differences of sixth order.
    fn squares(surface: &SelfAffine) -> [f64; 3] {
        let [x, y] = surface.places();
        let steps = [x[1] - x[0], y[1] - y[0]];
        let points = || y.iter().flat_map(|&y| x.iter().map(move |&x| [x, y]));
        let count = (x.len() * y.len()) as f64;
        let mean = points().map(|[x, y]| surface.recess(x, y)).sum::<f64>() / count;
        let height = points().map(|[x, y]| (surface.recess(x, y) - mean).powi(2)).sum::<f64>();
        let slope = |axis: usize| {
            let at = |[x, y]: [f64; 2], steps_on: f64| {
                let on = steps_on * steps[axis];
                if axis == 0 { surface.recess(x + on, y) } else { surface.recess(x, y + on) }
            };
            let terms = [(1.0, 0.75), (2.0, -0.15), (3.0, 1.0 / 60.0)];
            points()
                .map(|place| {
                    let sum = terms.map(|(on, by)| by * (at(place, on) - at(place, -on)));
                    (sum.into_iter().sum::<f64>() / steps[axis]).powi(2)
                })
                .sum::<f64>()
        };
        [height, slope(0), slope(1)].map(|sum| sum / count)
    }

    /// Numbers of the authors' generator from the seed 1234567.
    #[test]
    fn phases_are_those_of_the_generator() {
        let expected = [6457827717110365317, 3203168211198807973, 9817491932198370423];
        assert_eq!([1, 2, 3].map(|index| random(1234567, index)), expected);
    }

    /// The slope is the one asked for. The height follows: sums of a^2 and of a^2 q^2 over the waves of a cell whose spectrum has no
    /// flat part, with a^2 as q^-3.6.
    #[test]
    fn slope_and_height_are_those_of_the_spectrum() {
        let given = Roughness { long: 320e-6, ..GIVEN };
        let [height, slope_x, slope_y] = squares(&SelfAffine::new(given).unwrap());
        assert_relative_eq!((slope_x + slope_y).sqrt(), 0.1, max_relative = 1e-3);
        let whole = |power: f64| {
            let waves: Vec<f64> = (-32_i32..=32)
                .flat_map(|x| (-32_i32..=32).map(move |y| f64::from(x * x + y * y).sqrt()))
                .filter(|&waves| waves > 0.0 && waves <= 32.0)
                .collect();
            waves.iter().map(|waves| waves.powf(power)).sum::<f64>()
        };
        let along = std::f64::consts::TAU / 320e-6;
        let expected = 0.1 * 0.1 * whole(-3.6) / (along * along * whole(-1.6));
        assert_relative_eq!(height, expected, max_relative = 1e-3);
    }

    #[test]
    fn it_repeats_itself_and_has_no_preferred_axis() {
        let surface = SelfAffine::new(GIVEN).unwrap();
        for place in [[1.3e-6, -40e-6], [159e-6, 159.9e-6], [-160e-6, 0.0]] {
            let here = surface.recess(place[0], place[1]);
            let there = surface.recess(place[0] + 320e-6, place[1] - 640e-6);
            assert_relative_eq!(here, there, epsilon = 1e-15);
        }
        let [_, slope_x, slope_y] = squares(&surface);
        assert_relative_eq!(slope_x, slope_y, max_relative = 0.1);
    }

    /// A lay along x: the same surface, drawn out.
    #[test]
    fn a_lay_is_a_surface_drawn_out() {
        let [one, long] =
            [1.0, 5.0].map(|aspect| SelfAffine::new(Roughness { aspect, ..GIVEN }).unwrap());
        let [[height, ..], [other, slope_x, slope_y]] = [&one, &long].map(squares);
        let stretched = long.recess(5.0 * 12e-6, 7e-6) / one.recess(12e-6, 7e-6);
        assert_relative_eq!(stretched, (other / height).sqrt(), max_relative = 1e-9);
        assert_relative_eq!((slope_x + slope_y).sqrt(), 0.1, max_relative = 1e-3);
        assert!((4.0..6.0).contains(&(slope_y / slope_x).sqrt()));
    }

    /// Waves keep their phases when shorter ones are added.
    #[test]
    fn shorter_waves_add_to_a_surface() {
        let given = Roughness { hurst: 1.0, short: 40e-6, ..GIVEN };
        let coarse = SelfAffine::new(given).unwrap();
        let fine = SelfAffine::new(Roughness { short: 20e-6, ..given }).unwrap();
        let other = SelfAffine::new(Roughness { seed: 2, ..given }).unwrap();
        let alike = |other: &SelfAffine| {
            let places = coarse.places();
            let points = || places[1].iter().flat_map(|&y| places[0].iter().map(move |&x| [x, y]));
            let both = |[x, y]: [f64; 2]| [coarse.recess(x, y), other.recess(x, y)];
            let count = points().count() as f64;
            let mean = points()
                .map(both)
                .fold([0.0; 2], |sum, both| [0, 1].map(|i| sum[i] + both[i] / count));
            let less = |both: [f64; 2]| [0, 1].map(|i| both[i] - mean[i]);
            let products = points()
                .map(both)
                .map(less)
                .fold([0.0; 3], |sum, [a, b]| [sum[0] + a * a, sum[1] + b * b, sum[2] + a * b]);
            products[2] / (products[0] * products[1]).sqrt()
        };
        assert!(alike(&fine) > 0.95 && alike(&other).abs() < 0.5);
    }

    /// The quotient of 30 um and 1 um is rounded upwards: eight points to each wave are not one more.
    #[test]
    fn as_many_points_as_fit_are_made() {
        for (period, short, points) in
            [(30e-6, 1e-6, 240), (32e-6, 1e-6, 256), (32e-6, 0.99e-6, 260)]
        {
            let given = Roughness { period, short, long: period, ..GIVEN };
            assert_eq!(SelfAffine::new(given).unwrap().places()[0].len(), points);
        }
    }

    #[test]
    fn lengths_have_to_rise() {
        let wrong = |given| SelfAffine::new(given).unwrap_err().to_string();
        assert!(wrong(Roughness { short: 200e-6, ..GIVEN }).contains("long"));
        assert!(wrong(Roughness { period: 100e-6, ..GIVEN }).contains("period"));
        assert!(wrong(Roughness { short: 0.1e-6, ..GIVEN }).contains("8192"));
    }
}
