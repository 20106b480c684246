//! Pressures that alternate from element to element, or stand out in one: signs of an unresolved solution.
//!
//! Along five pairs in a row that are under pressure, an alternation is the smallest of four differences that change
//! sign each time, halved; a spike is what the middle exceeds its neighbours by, beyond what these exceed the next.

use archard::body::Body;
use archard::problem::{ContactProblem, ContactState};

/// Alternation of the undeformed gap, relative to the indentation of one pair by the largest pressure, beyond which
/// the surfaces themselves are rough.
const ROUGH: f64 = 0.01;

/// The largest of both along x and y relative to the largest pressure; `None` where pairs form no rows of five, on a mesh too
/// (for which see [`ContactProblem::alone`]), and where
/// the surfaces are rough. Rows across a tip, and across the end of a layer, are left out: the pressure is singular at the tip,
/// and jumps with the wear law at the end of the layer.
pub(super) fn of(problem: &ContactProblem, state: &ContactState) -> Option<f64> {
    let (frame, pressure) = (&problem.frame, &state.pressure);
    let worn_off = worn_off(problem, state);
    let peak = pressure.iter().copied().fold(0.0, f64::max);
    if !frame.is_grid() || peak <= 0.0 {
        return None;
    }
    let own = problem.compliance.normal_self_term() * peak;
    let sharp = |body: &Body| {
        let power = body.profile.sharpest();
        power > 0.0 && power < 2.0
    };
    let tip = problem.bodies.iter().any(sharp);
    let at_tip =
        |pair: usize, axis: usize| tip && frame.place(pair)[axis].abs() < frame.spacing()[axis];
    let mut most = None;
    let [nx, ny] = frame.elements();
    for (pair, _) in pressure.iter().enumerate().filter(|(_, pressure)| **pressure > 0.0) {
        let rows = [(pair % nx + 4 < nx, 1, 0), (pair / nx + 4 < ny, nx, 1)];
        for (_, stride, axis) in rows.into_iter().filter(|(inside, ..)| *inside) {
            let five = [0, 1, 2, 3, 4].map(|step| pair + step * stride);
            let across_layers = five.iter().any(|pair| worn_off[*pair] != worn_off[five[2]]);
            if at_tip(five[2], axis) || across_layers {
                continue;
            }
            let p = five.map(|pair| pressure[pair]);
            if p.iter().any(|pressure| *pressure <= 0.0) {
                continue;
            }
            if alternation(five.map(|pair| frame.gap()[pair])) > ROUGH * own {
                return None;
            }
            let found = alternation(p).max(spike(p)) / peak;
            most = Some(found.max(most.unwrap_or(0.0)));
        }
    }
    most
}

/// How many layers of both bodies are worn off at each pair.
fn worn_off(problem: &ContactProblem, state: &ContactState) -> Vec<usize> {
    let mut all = vec![0; state.pressure.len()];
    for (index, body) in
        problem.bodies.iter().enumerate().filter(|(_, body)| !body.layers.is_empty())
    {
        let worn = state.worn(index);
        let mut bottom = 0.0;
        for layer in &body.layers {
            bottom += layer.thickness;
            all.iter_mut().zip(&*worn).for_each(|(off, worn)| *off += usize::from(*worn > bottom));
        }
    }
    all
}

fn alternation([a, b, c, d, e]: [f64; 5]) -> f64 {
    let steps = [b - a, c - b, d - c, e - d];
    if steps.windows(2).any(|two| two[0] * two[1] >= 0.0) {
        return 0.0;
    }
    0.5 * steps.iter().fold(f64::INFINITY, |least, step| least.min(step.abs()))
}

fn spike([a, b, c, d, e]: [f64; 5]) -> f64 {
    let (near, far) = (b.max(d), a.max(e));
    (c - near - (near - far).abs()).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::{alternation, spike};

    #[test]
    fn smooth_rows_have_neither() {
        let hertz = [-0.8_f64, -0.4, 0.0, 0.4, 0.8].map(|x| (1.0 - x * x).sqrt());
        assert_eq!((alternation(hertz), spike(hertz)), (0.0, 0.0));
        assert_eq!(alternation([1.0, 1.2, 1.0, 1.2, 1.0]), 0.5 * (1.2 - 1.0));
        assert_eq!(spike([1.0, 1.0, 1.5, 1.0, 1.0]), 0.5);
    }
}
