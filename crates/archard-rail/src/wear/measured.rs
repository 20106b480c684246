//! A measured profile held against one that wears.
//!
//! At each point of the unworn profile a ray along its normal meets the measured one. The distance inwards is the depth there, and
//! how far a profile that is laid on it wrongly is off.

use super::WornProfile;
use crate::curve::Curve;

/// Distance (m) between places of the measured profile, straight between them: on an arc of 10 mm that is off by a tenth of a
/// micrometre.
const APART: f64 = 0.1e-3;
/// How far (m) along a normal a profile is looked for: farther than wheels wear between two turnings.
const REACH: f64 = 10e-3;

/// A point of an unworn profile, what was computed there, and where a measured profile lies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProfilePoint {
    /// y and z (m) of the unworn profile.
    pub at: [f64; 2],
    /// Unit vector out of the material.
    pub normal: [f64; 2],
    /// Computed depth (m) along the normal.
    pub depth: f64,
    /// How far (m) inwards the measured profile lies along the normal; `None` where it does not reach.
    pub measured: Option<f64>,
}

impl WornProfile {
    /// Each point against a measured profile (m).
    pub fn against(&self, measured: &Curve) -> Vec<ProfilePoint> {
        let places = measured.samples(APART);
        let way: Vec<[f64; 2]> = places.into_iter().map(|along| measured.point(along)).collect();
        let of = |((at, normal), depth): (([f64; 2], [f64; 2]), f64)| ProfilePoint {
            at,
            normal,
            depth,
            measured: inwards(&way, at, normal),
        };
        self.stations().zip(self.depths()).map(of).collect()
    }
}

/// How far (m) inwards along a normal a way lies: where it crosses it next to the point.
fn inwards(way: &[[f64; 2]], [y, z]: [f64; 2], [ny, nz]: [f64; 2]) -> Option<f64> {
    // Along the profile and inwards, from the point.
    let turned = |&[a, b]: &[f64; 2]| [(a - y) * nz - (b - z) * ny, -(a - y) * ny - (b - z) * nz];
    let crosses = |pair: &[[f64; 2]]| {
        let [[s, d], [t, e]] = [turned(&pair[0]), turned(&pair[1])];
        let passes = (s <= 0.0) != (t <= 0.0);
        passes.then(|| d + s / (s - t) * (e - d)).filter(|inwards| inwards.abs() < REACH)
    };
    way.windows(2).filter_map(crosses).min_by(|one, other| one.abs().total_cmp(&other.abs()))
}

#[cfg(test)]
mod tests {
    use super::super::WornProfile;
    use crate::curve::{Curve, Smoothing};
    use crate::standard::wheel_s1002;

    /// The profile that a computed one becomes lies as deep as it was worn; an unworn one that is moved lies off by the part of its way
    /// along the normal.
    #[test]
    fn a_profile_lies_where_it_was_worn_to() {
        let curve = wheel_s1002(0.2e-3).unwrap().curve(Smoothing::NONE).unwrap();
        let new = WornProfile::wheel(&curve, 0.46, 0.0).unwrap();
        let thin = new.as_depths(&vec![1.0; new.len()]);
        let depth = |y: f64| if y > -30e-3 && y < 20e-3 { 0.4e-3 } else { 0.0 };
        let gone = new.unworn().points.into_iter().zip(&thin);
        let worn = new.worn_to(gone.map(|([y, _], thin)| depth(y) / thin).collect()).unwrap();
        let measured = Curve::new(&worn.profile().points, Smoothing::NONE).unwrap();
        let inner = |held: &&super::ProfilePoint| (-25e-3..15e-3).contains(&held.at[0]);
        let held = worn.against(&measured);
        assert!(held.iter().filter(inner).count() > 100);
        for held in held.iter().filter(inner) {
            assert!((held.measured.unwrap() - held.depth).abs() < 1e-7, "{held:?}");
        }
        let by = [20e-6, 30e-6];
        for held in new.against(&curve.moved(0.0, by)).iter().filter(inner) {
            let off = -held.normal[0] * by[0] - held.normal[1] * by[1];
            assert!((held.measured.unwrap() - off).abs() < 2e-7, "{held:?} {off}");
        }
    }
}
