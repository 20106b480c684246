//! Preparing and spectra against other packages: SurfaceTopography 1.27.1, surfalize 0.19.2, SciPy 1.17.1 and NumPy, on the same surface with an
//! amplitude that falls with the wave number to the power 1.8.

use std::f64::consts::TAU;

use approx::assert_relative_eq;

use crate::{Form, HeightMap, Level, Nominal, Spectrum, Texture, Window};

const POINTS: [usize; 2] = [48, 40];
const PIXEL: [f64; 2] = [1e-6, 1.5e-6];

/// Sixty waves that fit the map, each with the square of its number as its phase.
fn rough(x: usize, y: usize) -> f64 {
    let wave = |n: i32| {
        let (p, q) = (f64::from(n % 9), f64::from((7 * n) % 13 - 6));
        let phase = TAU * (p * x as f64 / POINTS[0] as f64 + q * y as f64 / POINTS[1] as f64);
        1e-7 * p.hypot(q).powf(-1.8) * (phase + f64::from(n * n)).cos()
    };
    let counts = |n: &i32| n % 9 != 0 || (7 * n) % 13 != 6;
    (1..=60).filter(counts).map(wave).sum()
}

/// The rough surface with a shape over places (m) from the middle of the map added.
fn map(shape: impl Fn(f64, f64) -> f64) -> HeightMap {
    let place =
        |axis: usize, index: usize| PIXEL[axis] * (index as f64 - 0.5 * (POINTS[axis] - 1) as f64);
    let height = |at: usize| {
        let (x, y) = (at % POINTS[0], at / POINTS[0]);
        rough(x, y) + shape(place(0, x), place(1, y))
    };
    HeightMap::new(POINTS, PIXEL, (0..POINTS[0] * POINTS[1]).map(height).collect()).unwrap()
}

/// SurfaceTopography: `power_spectrum_from_area` in rings as wide as the lowest frequency, `power_spectrum_from_profile`,
/// `rms_height_from_area`, without a window.
#[test]
fn spectra_are_those_of_surface_topography() {
    let map = map(|_, _| 0.0);
    assert_relative_eq!(Texture::of(&map).rms, 1.1153622915062165e-07, max_relative = 1e-12);
    let spectrum = Spectrum::of(&map, Window::None).unwrap();
    let radial = spectrum.radial();
    let lowest = 1.0 / (POINTS[1] as f64 * PIXEL[1]);
    for (ring, frequency, density) in [
        (0, 1.125, 5.463831007834203e-24),
        (1, 2.0697587807907873, 8.544091300563273e-25),
        (3, 4.020386433115677, 3.241674018396816e-26),
        (6, 7.106955635899176, 3.888096245439791e-27),
        (9, 10.064153792927373, 8.406272150286887e-28),
    ] {
        assert_relative_eq!(radial[ring].frequency, frequency * lowest, max_relative = 1e-12);
        assert_relative_eq!(radial[ring].density, density, max_relative = 1e-9);
    }
    let along = spectrum.along(0);
    for (order, density) in [
        (1, 7.869930648199657e-20),
        (2, 1.7109241952595963e-20),
        (4, 2.676748844263626e-21),
        (8, 2.9127760753584397e-22),
    ] {
        assert_relative_eq!(along[order - 1].frequency, order as f64 / 48e-6, max_relative = 1e-12);
        assert_relative_eq!(along[order - 1].density, density, max_relative = 1e-9);
    }
}

/// SurfaceTopography: `detrend` by "height" and by "curvature"; surfalize: `level`, then Sa, Ssk and Sku. The plane by `numpy.linalg.lstsq`.
#[test]
fn levelled_maps_are_those_of_surface_topography_and_surfalize() {
    let tilted = map(|x, y| 0.01 * x - 0.02 * y + 300.0 * x * x - 200.0 * x * y + 100.0 * y * y);
    let plane = Texture::of(&tilted.levelled(Level::Plane).unwrap());
    assert_relative_eq!(plane.rms, 1.3316186663891177e-07, max_relative = 1e-10);
    assert_relative_eq!(plane.mean_deviation, 1.0450562279157496e-07, max_relative = 1e-10);
    assert_relative_eq!(plane.skewness, 0.8797679000231016, max_relative = 1e-9);
    assert_relative_eq!(plane.kurtosis, 3.7671456910607324, max_relative = 1e-9);
    let [x, y] = crate::Polynomial::of(&tilted, Level::Plane).tilt();
    assert_relative_eq!(x, 9.32776710e-03, max_relative = 1e-8);
    assert_relative_eq!(y, -2.31324974e-02, max_relative = 1e-8);
    let bow = Texture::of(&tilted.levelled(Level::Quadratic).unwrap());
    assert_relative_eq!(bow.rms, 7.978801480817913e-08, max_relative = 1e-10);
}

/// SciPy: `optimize.least_squares` on centre and radius of a sphere, and on axis, direction and radius of a tilted cylinder.
#[test]
fn shapes_are_those_of_scipy() {
    let radius = 2e-4f64;
    let ball =
        map(|x, y| (radius * radius - (x - 1e-5).powi(2) - (y + 5e-6).powi(2)).sqrt() - radius);
    let found = Nominal::of(&ball, Form::Sphere, None).unwrap();
    assert_relative_eq!(found.radius()[0], 0.00021248545096435863, max_relative = 1e-7);
    assert_relative_eq!(found.rest, 8.458251467442788e-08, max_relative = 1e-9);
    let (radius, slope) = (3e-4f64, 0.03f64);
    let (sin, cos) = 0.5f64.sin_cos();
    let rod = map(|x, y| {
        let (u, v) = (x * cos + y * sin, y * cos - x * sin - 5e-6);
        slope * u + (1.0 + slope * slope).sqrt() * ((radius * radius - v * v).sqrt() - radius)
    });
    let found = Nominal::of(&rod, Form::Cylinder, None).unwrap();
    assert_relative_eq!(found.radius()[0], 0.00032433144791116825, max_relative = 1e-6);
    assert_relative_eq!(found.direction().unwrap(), 0.5695365011926131, max_relative = 1e-6);
    assert_relative_eq!(found.rest, 8.128876587865727e-08, max_relative = 1e-9);
}

/// SciPy: `ndimage.gaussian_filter` of heights and of ones where they were measured, the one over the other.
#[test]
fn smooth_maps_are_those_of_scipy() {
    let whole = map(|_, _| 0.0);
    let height = |at: usize| {
        let (x, y) = (at % POINTS[0], at / POINTS[0]);
        let hole = (10..15).contains(&x) && (20..30).contains(&y);
        if hole { f64::NAN } else { whole.at(x, y) }
    };
    let holed = HeightMap::new(POINTS, PIXEL, (0..48 * 40).map(height).collect()).unwrap();
    let smooth = holed.smoothed(8e-6).unwrap();
    for (x, y, height) in [
        (0, 0, 1.785316077024719e-07),
        (12, 19, -1.6158105679840606e-08),
        (9, 25, -1.445192239061492e-07),
        (47, 39, 9.26679927820017e-08),
        (30, 20, 1.7083019461848084e-08),
    ] {
        assert_relative_eq!(smooth.at(x, y), height, max_relative = 1e-9);
    }
}
