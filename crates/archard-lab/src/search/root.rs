//! The root of a function whose every value costs runs: bracketed, then narrowed.
//!
//! The Illinois method (Dowell & Jarratt, BIT 11 (1971) 168): the secant through both ends of the bracket, where an end that
//! stays counts by half its value. A step that has not halved the bracket in three goes to its middle, so that rounding and
//! roughness of the function end it too.

/// Largest step before there is a bracket.
const STRIDE: f64 = 2.0;
/// Steps in which a bracket has to become half as wide.
const PATIENCE: usize = 3;

/// A search for the zero of a function whose slope is expected to be -1.
#[derive(Debug, Clone, Default)]
pub(super) struct Root {
    /// Places with their values: the ends of the bracket, or all there are; the last one last.
    ends: Vec<[f64; 2]>,
    /// Width of the bracket when it last was half as wide, and steps since.
    width: Option<(f64, usize)>,
}

impl Root {
    /// The next place to be tried after this one with its value; `None` where the root is within a tolerance of this one.
    pub fn next(&mut self, place: f64, value: f64, tolerance: f64) -> Option<f64> {
        if value == 0.0 {
            return None;
        }
        let own = [place, value];
        let Some(last) = self.ends.last().copied() else {
            self.ends = vec![own];
            // The slope is not known yet: far enough to see one.
            return Some(place + value.abs().clamp(tolerance, STRIDE).copysign(value));
        };
        let next = self.after(last, own);
        let near = |other: f64| (other - place).abs() <= tolerance;
        let bracketed = matches!(self.ends[..], [other, _] if near(other[0]));
        (!bracketed && !near(next)).then_some(next)
    }

    /// Takes a place with its value in; where the root is then.
    fn after(&mut self, last: [f64; 2], own: [f64; 2]) -> f64 {
        let [place, value] = own;
        let opposite = self.ends.iter().copied().find(|end| end[1] * value < 0.0);
        let Some(opposite) = opposite else {
            self.ends = vec![own];
            return place + outwards(last, own);
        };
        // The end that stays twice loses half its weight.
        let stays = if last[1] * value > 0.0 { 0.5 } else { 1.0 };
        let opposite = [opposite[0], stays * opposite[1]];
        self.ends = vec![opposite, own];
        self.within(opposite, own, (opposite[0] - place).abs())
    }

    /// The secant's place in the bracket, or its middle.
    fn within(&mut self, one: [f64; 2], other: [f64; 2], width: f64) -> f64 {
        let (before, steps) = self.width.unwrap_or((width, 0));
        self.width = Some(match width <= 0.5 * before {
            true => (width, 0),
            false => (before, steps + 1),
        });
        if self.width.is_some_and(|(_, steps)| steps >= PATIENCE) {
            self.width = Some((width, 0));
            return 0.5 * (one[0] + other[0]);
        }
        other[0] - other[1] * (other[0] - one[0]) / (other[1] - one[1])
    }
}

/// A step beyond the last of two places on one side of the root: that of the secant where it leads on, and no shorter than that
/// of a slope of -1.
fn outwards(last: [f64; 2], own: [f64; 2]) -> f64 {
    let plain = own[1].clamp(-STRIDE, STRIDE);
    let secant = -own[1] * (own[0] - last[0]) / (own[1] - last[1]);
    match secant.is_finite() && secant * plain > 0.0 {
        // A little farther, so that the root lies between.
        true => (1.1 * secant).clamp(-STRIDE, STRIDE),
        false => plain,
    }
}

#[cfg(test)]
mod tests {
    use super::Root;

    /// Where a search ends, how far off, and in how many steps.
    fn search(from: f64, tolerance: f64, value: impl Fn(f64) -> f64) -> (f64, usize) {
        let (mut root, mut place) = (Root::default(), from);
        for step in 1..=40 {
            match root.next(place, value(place), tolerance) {
                None => return (place, step),
                Some(next) => place = next,
            }
        }
        panic!("no end: {place}");
    }

    #[test]
    fn roots_are_found_in_few_steps() {
        // What a coefficient does that the other one does not touch: at once.
        assert_eq!(search(0.0, 1e-3, |x| 1.5 - x), (1.5, 2));
        // Slopes between flat and steep, and one that bends.
        for slope in [-0.2, -0.6, -1.6, -3.0] {
            let (place, steps) = search(0.0, 1e-3, |x| slope * (x - 0.7));
            assert!((place - 0.7).abs() < 1e-2 && steps <= 6, "{slope}: {place} {steps}");
        }
        let (place, steps) = search(0.0, 1e-3, |x| 2.0 - (1.0 + x).abs().powf(1.5));
        assert!(
            (place - (2f64.powf(2.0 / 3.0) - 1.0)).abs() < 2e-3 && steps <= 8,
            "{place} {steps}"
        );
    }

    /// A function that is rough, or jumps over zero, ends at the jump.
    #[test]
    fn rough_functions_end() {
        let rough = |x: f64| 0.7 - x + 4e-3 * (1e4 * x).sin();
        let (place, steps) = search(-1.0, 1e-3, rough);
        assert!((place - 0.7).abs() < 6e-3 && steps <= 20, "{place} {steps}");
        // What is nearly flat is sought by its slope: a value below the tolerance is no root.
        let (place, steps) = search(0.0, 1e-2, |x| 0.05 * (0.8 - x));
        assert!((place - 0.8).abs() < 1e-2 && steps <= 4, "{place} {steps}");
        let (place, steps) = search(0.0, 1e-3, |x| if x < 0.3 { 0.5 } else { -0.5 });
        assert!((place - 0.3).abs() < 1e-3 && steps <= 20, "{place} {steps}");
    }
}
