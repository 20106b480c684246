//! How well a shift is known: by slopes that both scans have.
//!
//! Noise has slopes, too, and along a lay no others. A fit takes them for those of the surface, and its own uncertainty is too small there. Slopes
//! of noise differ between the scans: the mean product of the slopes of both is that of the surface alone. A shift moves the sum that a fit
//! brings to zero by this product, and not by the square of the slopes of one scan; its uncertainty is larger by their ratio.

use super::Placement;
use super::rounds::{Round, Scans};
use super::sample::{SMOOTH, Spline};

/// Standard deviations by which a product is more than chance.
const CLEAR: f64 = 2.0;

/// What is known of a shift.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Known {
    /// Standard uncertainties (m) along x and y.
    pub(super) by: [f64; 2],
    /// The direction (rad) along which it is not known to a point.
    pub(super) open: Option<f64>,
}

/// Of the variances of a fit (m^2): along x, y, and of both together, xy.
pub(super) fn known(scans: &Scans, round: &Round, [xx, xy, yy]: [f64; 3]) -> Known {
    let Products { own, both, count } = products(scans, &round.placement, &round.excluded);
    // The direction with the least in common.
    let direction = 0.5 * (2.0 * both[1]).atan2(both[0] - both[2]) + 0.5 * std::f64::consts::PI;
    let (sine, cosine) = direction.sin_cos();
    let along =
        |[xx, xy, yy]: [f64; 3], (x, y): (f64, f64)| xx * x * x + 2.0 * xy * x * y + yy * y * y;
    let ways = [(cosine, sine), (-sine, cosine)];
    // A product of independent slopes, of as many as count by themselves under the Gaussian.
    let chance = (4.0 * std::f64::consts::PI * SMOOTH * SMOOTH / count.max(1.0)).sqrt();
    let factor = |way, deviations: f64, least: f64| {
        let share = along(both, way) / along(own, way).max(f64::MIN_POSITIVE);
        1.0 / (share - deviations * chance).min(1.0).max(least)
    };
    let variances = ways.map(|way| along([xx, xy, yy], way) * factor(way, 0.0, chance).powi(2));
    let [low, high] = variances;
    let by = [
        (low * cosine * cosine + high * sine * sine).sqrt(),
        (low * sine * sine + high * cosine * cosine).sqrt(),
    ];
    let worst = along([xx, xy, yy], ways[0]).sqrt() * factor(ways[0], CLEAR, f64::MIN_POSITIVE);
    let turned = (direction + 0.5 * std::f64::consts::PI).rem_euclid(std::f64::consts::PI)
        - 0.5 * std::f64::consts::PI;
    Known { by, open: (worst > scans.pixel).then_some(turned) }
}

/// Mean products of slopes about their means, of the earlier scan and of both: xx, xy, yy; and of how many points.
struct Products {
    own: [f64; 3],
    both: [f64; 3],
    count: f64,
}

fn products(scans: &Scans, placement: &Placement, excluded: &[bool]) -> Products {
    let later = Spline::of(&scans.after);
    let nx = scans.after.elements()[0];
    let turn = Placement { turn: placement.turn, ..Placement::default() };
    let pair = |at: usize| {
        let place = [scans.after.place(0, at % nx), scans.after.place(1, at / nx)];
        let (_, before) = scans.spline.at(placement.on_the_earlier(place))?;
        let (_, after) = later.at(place)?;
        Some([before, turn.on_the_earlier(after)])
    };
    let pairs: Vec<[[f64; 2]; 2]> =
        (0..excluded.len()).filter(|&at| !excluded[at]).filter_map(pair).collect();
    let count = pairs.len() as f64;
    let mean = [0, 1].map(|scan| {
        [0, 1].map(|axis| pairs.iter().map(|pair| pair[scan][axis]).sum::<f64>() / count.max(1.0))
    });
    let product = |one: usize, [i, j]: [usize; 2]| -> f64 {
        let off =
            |pair: &[[f64; 2]; 2], scan: usize, axis: usize| pair[scan][axis] - mean[scan][axis];
        let own = |pair| {
            0.5 * (off(pair, 0, i) * off(pair, one, j) + off(pair, 0, j) * off(pair, one, i))
        };
        pairs.iter().map(own).sum::<f64>() / count.max(1.0)
    };
    let all = |one: usize| [[0, 0], [0, 1], [1, 1]].map(|axes| product(one, axes));
    Products { own: all(0), both: all(1), count }
}
