//! Wear of a body that stays in contact with a track that passes under it: pin on disc, block on ring, reciprocating.
//!
//! Geometry alone, without elasticity. Where the bodies touch, what the pin has lost at (x, y) and the groove across the
//! track at y make up for the approach: w(x, y) + g(y) = d - (kx x^2 + ky y^2)/2. The pin wears by k1 p, and a point of the
//! track by k2 times the mean of p over its way around, k2 p c/L with c the length of the contact at y and L that of the
//! track. Both together are d', the same everywhere, so that
//!
//! - p(y) = d' / (k1 + k2 c/L), with load = integral of p c over y;
//! - g' = d' (k2 c/L) / (k1 + k2 c/L), with c = 2 sqrt(2 (d - g - ky y^2/2) / kx).
//!
//! Without wear of the track it is the geometric model of the pin on disc ([`pin_on_disc`](super::pin_on_disc)); without
//! wear of the pin the groove has its section. What stands here was derived for this program.

use crate::numerics::SAME;

/// Strips across half of the track, and how much the approach grows in a step.
const STRIPS: usize = 120;
const GROWTH: f64 = 1.03;

/// Both bodies at some moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WornTrack {
    /// Greatest depth worn off the body that stays (m).
    pub scar_depth: f64,
    /// Greatest depth of the groove (m).
    pub groove_depth: f64,
    /// Extent of the contact along the track and across it (m).
    pub extent: [f64; 2],
}

/// At some moment, from new bodies on.
///
/// `curvatures` are those of both bodies together along the track and across it (1/m), both greater than zero;
/// `coefficients` the k of the body that stays and of the one that passes (1/Pa), one of them greater than zero; `length`
/// that of the track (m); `load_distance` the load times the distance slid (N m).
pub fn worn(
    [along, across]: [f64; 2],
    [stays, passes]: [f64; 2],
    length: f64,
    load_distance: f64,
) -> WornTrack {
    // Neither body alone can be as deep as the sum of both by themselves.
    let cap = (stays * load_distance * (along * across).sqrt() / std::f64::consts::PI).sqrt();
    let section = passes * load_distance / length;
    let groove = (0.75 * section * (0.5 * across).sqrt()).powf(2.0 / 3.0);
    let deepest = cap + groove;
    let strip = (2.0 * deepest / across).sqrt() / STRIPS as f64;
    let place = |index: usize| (index as f64 + 0.5) * strip;
    let mut worn = vec![0.0; STRIPS];
    let (mut approach, mut done) = (0.0f64, 0.0);
    let mut wide = 0.0;
    let mut step = SAME * deepest;
    while done < load_distance {
        // In the middle of the step, with the groove of its beginning and a half of what it adds.
        let middle = approach + 0.5 * step;
        let share = |worn: f64, index: usize| {
            let left = middle - 0.5 * across * place(index).powi(2);
            if left <= 0.0 {
                return None;
            }
            let open = (left - worn).max(0.0);
            let wide = 2.0 * (2.0 * open / along).sqrt();
            let track = passes * wide / length;
            let share = if stays == 0.0 { 1.0 } else { track / (stays + track) };
            // Load over d', by width: c / (k1 + k2 c/L).
            let bears = if stays == 0.0 { length / passes } else { wide / (stays + track) };
            Some((share, bears, wide))
        };
        let ahead: Vec<Option<(f64, f64, f64)>> = (0..STRIPS)
            .map(|index| {
                let (first, ..) = share(worn[index], index)?;
                share(worn[index] + 0.5 * step * first, index)
            })
            .collect();
        let bears: f64 = ahead.iter().flatten().map(|(_, bears, _)| bears).sum();
        let adds = step * 2.0 * strip * bears;
        let part = if adds > 0.0 { ((load_distance - done) / adds).min(1.0) } else { 1.0 };
        for (worn, ahead) in worn.iter_mut().zip(&ahead) {
            *worn += ahead.map_or(0.0, |(share, ..)| part * step * share);
        }
        approach += part * step;
        done = if part < 1.0 { load_distance } else { done + adds };
        wide = ahead[0].map_or(0.0, |(.., wide)| wide);
        step = (GROWTH - 1.0) * approach;
    }
    WornTrack {
        scar_depth: approach - worn[0],
        groove_depth: worn[0],
        extent: [wide, 2.0 * (2.0 * approach / across).sqrt()],
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::worn;
    use crate::closed_form::pin_on_disc;

    #[test]
    fn a_hard_track_leaves_the_cap_of_the_pin() {
        let worn = worn([100.0; 2], [1e-13, 0.0], 0.1, 50.0);
        let depth = pin_on_disc::depth(0.01, 1e-13 * 50.0);
        assert_relative_eq!(worn.scar_depth / depth, 1.0, max_relative = 1e-3);
        assert_eq!(worn.groove_depth, 0.0);
        assert_relative_eq!(worn.extent[1], 2.0 * (2.0 * 0.01 * depth).sqrt(), max_relative = 1e-3);
    }

    /// The section of the groove is the segment of a circle, 2/3 of its depth times its width.
    #[test]
    fn a_hard_ball_leaves_its_groove() {
        let worn = worn([100.0; 2], [0.0, 1e-13], 0.1, 50.0);
        let section: f64 = 1e-13 * 50.0 / 0.1;
        let width = (12.0 * 0.01 * section).cbrt();
        assert_relative_eq!(worn.groove_depth, width * width / (8.0 * 0.01), max_relative = 2e-3);
        assert_relative_eq!(worn.extent[1], width, max_relative = 2e-3);
        assert!(worn.scar_depth.abs() < 1e-3 * worn.groove_depth);
    }
}
