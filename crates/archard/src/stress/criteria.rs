//! Criteria of fatigue: what a path of stresses, a cycle that closes, does at a point.
//!
//! B. Crossland (*Proc. Int. Conf. on Fatigue of Metals*, 1956) and K. Dang Van (*ASTM STP* 1191, 1993) need no planes: the
//! amplitude is that of the deviator about the centre of the smallest ball around it (I. V. Papadopoulos, *Fatigue Fract. Engng
//! Mater. Struct.* 17 (1994) 1377). W. N. Findley (*J. Engng Ind.* 81 (1959) 301), A. Fatemi & D. F. Socie (*Fatigue Fract. Engng
//! Mater. Struct.* 11 (1988) 149), and K. N. Smith, P. Watson & T. H. Topper (*J. Materials* 5 (1970) 767) look for the
//! [plane](super::planes) that is worst off.

use super::ball::smallest_ball;
use super::planes::{OnPlane, Plane, worst};
use super::{Components, shear};

/// What an elastic material makes of the stress on a plane.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elastic {
    /// Young's modulus (Pa).
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
}

/// The mean of the normal stresses (Pa).
fn hydrostatic(stress: &Components) -> f64 {
    stress[..3].iter().sum::<f64>() / 3.0
}

/// The deviator as five numbers whose length is the root of its second invariant (Pa).
fn deviator(stress: &Components) -> [f64; 5] {
    let mean = hydrostatic(stress);
    let [xx, yy, zz, xy, xz, yz] = *stress;
    [0.5 * 3f64.sqrt() * (xx - mean), 0.5 * (yy - zz), xy, xz, yz]
}

/// Crossland: the radius (Pa) of the smallest ball around the deviator, the root of its second invariant, and the largest
/// hydrostatic stress (Pa); fatigue by the first plus a factor times the second.
pub fn crossland(path: &[Components]) -> [f64; 2] {
    let deviators: Vec<_> = path.iter().map(deviator).collect();
    let largest = path.iter().map(hydrostatic).fold(f64::NEG_INFINITY, f64::max);
    [smallest_ball(&deviators).1, largest]
}

/// Dang Van: the largest of the shear (Pa) about the centre of the smallest ball plus a factor times the hydrostatic stress at the
/// same moment.
pub fn dang_van(path: &[Components], factor: f64) -> f64 {
    let deviators: Vec<_> = path.iter().map(deviator).collect();
    let ([first, second, xy, xz, yz], _) = smallest_ball(&deviators);
    let x = 2.0 / 3f64.sqrt() * first;
    let centre = [x, second - 0.5 * x, -second - 0.5 * x, xy, xz, yz];
    let at = |stress: &Components| {
        let about: Components = std::array::from_fn(|i| stress[i] - centre[i]);
        shear(&about) + factor * hydrostatic(stress)
    };
    path.iter().map(at).fold(f64::NEG_INFINITY, f64::max)
}

/// Findley: the largest over planes of the amplitude of shear plus a factor times the largest normal stress (Pa), which counts with
/// its sign; and the plane.
pub fn findley(path: &[Components], factor: f64) -> (f64, Plane) {
    worst(|plane| {
        let on = OnPlane::of(path, plane);
        on.shear_amplitude() + factor * on.largest_normal()
    })
}

/// Fatemi and Socie: the largest over planes of the amplitude of shear strain times one plus a factor times the largest normal stress
/// over the yield stress (Pa); pressure counts as no normal stress.
pub fn fatemi_socie(
    path: &[Components],
    elastic: Elastic,
    (factor, strength): (f64, f64),
) -> (f64, Plane) {
    let modulus = elastic.young / (2.0 * (1.0 + elastic.poisson));
    worst(|plane| {
        let on = OnPlane::of(path, plane);
        let opened = on.largest_normal().max(0.0) / strength;
        on.shear_amplitude() / modulus * (1.0 + factor * opened)
    })
}

/// Smith, Watson and Topper: the largest over planes of the largest normal stress times the amplitude of the normal strain (Pa);
/// pressure counts as no normal stress.
pub fn smith_watson_topper(path: &[Components], elastic: Elastic) -> (f64, Plane) {
    let strains: Vec<Components> = path
        .iter()
        .map(|stress| {
            let all = 3.0 * elastic.poisson * hydrostatic(stress);
            std::array::from_fn(|i| {
                let mean = if i < 3 { all } else { 0.0 };
                ((1.0 + elastic.poisson) * stress[i] - mean) / elastic.young
            })
        })
        .collect();
    worst(|plane| {
        let opened = OnPlane::of(path, plane).largest_normal().max(0.0);
        opened * OnPlane::of(&strains, plane).normal_amplitude()
    })
}
