//! The plane that a surface which is worn on less than half of its area has between two scans.
//!
//! Least quantile of squares (P. J. Rousseeuw and A. M. Leroy, *Robust Regression and Outlier Detection*, Wiley 1987): of all
//! planes through the medians of three patches the one that lies within the least distance of half of the points. Up to half of
//! them may be anywhere. It only starts what is fitted by all points.

use crate::outliers::median;

/// Patches along each axis.
pub(super) const PATCHES: usize = 6;
/// Points whose distances are taken, about: their median is known to some per cent of a standard deviation.
const POINTS: usize = 500;

/// Offset and tilts of the plane of changes (m) at places (m) in a rectangle from the first to the second corner; `None` of too few.
pub(super) fn robust(
    changes: &[([f64; 2], f64)],
    corners: [[f64; 2]; 2],
) -> Option<(f64, [f64; 2])> {
    let mut patches = vec![vec![]; PATCHES * PATCHES];
    for (place, change) in changes {
        let index = [0, 1].map(|axis| {
            let along = (place[axis] - corners[0][axis]) / (corners[1][axis] - corners[0][axis]);
            ((PATCHES as f64 * along).max(0.0) as usize).min(PATCHES - 1)
        });
        patches[index[0] + PATCHES * index[1]].push((*place, *change));
    }
    let fullest = patches.iter().map(Vec::len).max()?;
    let middle = |points: &Vec<([f64; 2], f64)>| {
        let [x, y] = [0, 1]
            .map(|axis| points.iter().map(|one| one.0[axis]).sum::<f64>() / points.len() as f64);
        Some([x, y, median(&mut points.iter().map(|one| one.1).collect::<Vec<f64>>())?])
    };
    let points: Vec<[f64; 3]> =
        patches.iter().filter(|points| 2 * points.len() > fullest).filter_map(middle).collect();
    // Not a divisor of rows of points, mostly.
    let some: Vec<&([f64; 2], f64)> =
        changes.iter().step_by((changes.len() / POINTS + 1) | 1).collect();
    // For three unknowns.
    let within = ((some.len() + 4) / 2).min(some.len());
    let mut best = (f64::INFINITY, None);
    let mut sizes = vec![0.0; some.len()];
    for (one, a) in points.iter().enumerate() {
        for (two, b) in points.iter().enumerate().skip(one + 1) {
            for c in &points[two + 1..] {
                let Some((offset, tilt)) = through(a, b, c) else { continue };
                for (size, ([x, y], change)) in sizes.iter_mut().zip(&some) {
                    *size = (change - offset - tilt[0] * x - tilt[1] * y).abs();
                }
                let far = *sizes.select_nth_unstable_by(within - 1, f64::total_cmp).1;
                if far < best.0 {
                    best = (far, Some((offset, tilt)));
                }
            }
        }
    }
    best.1
}

/// The plane through three points; `None` if they lie on a line, or nearly.
fn through(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]) -> Option<(f64, [f64; 2])> {
    let [u, v] = [b, c].map(|own| [own[0] - a[0], own[1] - a[1], own[2] - a[2]]);
    let area = u[0] * v[1] - u[1] * v[0];
    let sides = u[0].hypot(u[1]) * v[0].hypot(v[1]);
    // An angle of less than 0.1 rad between the sides makes the tilt ten times as uncertain as the points.
    if area.abs() <= 0.1 * sides {
        return None;
    }
    let tilt = [(u[2] * v[1] - u[1] * v[2]) / area, (u[0] * v[2] - u[2] * v[0]) / area];
    Some((a[2] - tilt[0] * a[0] - tilt[1] * a[1], tilt))
}

#[cfg(test)]
mod tests {
    use super::robust;

    /// A plane of which 45 % lie lower, all in one part, is found as it is.
    #[test]
    fn what_is_worn_does_not_tilt_the_plane() {
        let change = |at: usize| {
            let place = [(at % 80) as f64, (at / 80) as f64];
            let scar = if place[0] < 36.0 { -50.0 - place[0] } else { 0.0 };
            (place, 2.0 + 0.1 * place[0] - 0.3 * place[1] + scar)
        };
        let changes: Vec<([f64; 2], f64)> = (0..6400).map(change).collect();
        let (offset, tilt) = robust(&changes, [[0.0; 2], [79.0; 2]]).unwrap();
        assert!((offset - 2.0).abs() < 0.5 && (tilt[0] - 0.1).abs() < 0.01, "{offset} {tilt:?}");
        assert!((tilt[1] + 0.3).abs() < 0.01, "{tilt:?}");
    }
}
