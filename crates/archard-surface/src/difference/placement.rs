//! How the later map lies on the earlier one, and the plane between them.

use super::sample::Spline;

/// How the later map lies on the earlier one.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Placement {
    /// Where the middle of the later map lies on the earlier one (m).
    pub shift: [f64; 2],
    /// By how much the later map has to be turned, anticlockwise (rad).
    pub turn: f64,
    /// By how much the later map lies higher in its middle (m).
    pub offset: f64,
    /// By how much it slopes more, along its x and y.
    pub tilt: [f64; 2],
    /// By how much it is bent more (1/m): factors of x^2, x y and y^2 on it. Zero where the scans have the same form.
    pub form: [f64; 3],
}

/// The numbers of a placement, or their changes.
pub(super) const PARAMETERS: usize = 9;
/// The first of them that are of the level, not of the place.
pub(super) const LEVEL: usize = 3;
/// The first of them that are of the form.
pub(super) const FORM: usize = 6;

impl Placement {
    /// The place (m) on the earlier map of a place on the later one.
    pub fn on_the_earlier(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (sine, cosine) = self.turn.sin_cos();
        [cosine * x - sine * y + self.shift[0], sine * x + cosine * y + self.shift[1]]
    }

    /// How much (m) the later map lies higher at a place on it, by its plane and its form.
    pub fn level(&self, [x, y]: [f64; 2]) -> f64 {
        let [xx, xy, yy] = self.form;
        self.offset + self.tilt[0] * x + self.tilt[1] * y + xx * x * x + xy * x * y + yy * y * y
    }

    /// The same, changed by numbers that are all lengths: turn and tilts times `reach` (m), form times its square.
    pub(super) fn changed(&self, by: [f64; PARAMETERS], reach: f64) -> Self {
        Self {
            shift: [self.shift[0] + by[0], self.shift[1] + by[1]],
            turn: self.turn + by[2] / reach,
            offset: self.offset + by[3],
            tilt: [self.tilt[0] + by[4] / reach, self.tilt[1] + by[5] / reach],
            form: [0, 1, 2].map(|own| self.form[own] + by[FORM + own] / (reach * reach)),
        }
    }

    /// How much lower (m, negative) or higher the later surface is at a place on it, and how much that falls with each of its numbers
    /// as lengths; `None` where the earlier map has no height.
    pub(super) fn change(
        &self,
        before: &Spline,
        (place, height): ([f64; 2], f64),
        reach: f64,
    ) -> Option<(f64, [f64; PARAMETERS])> {
        let (earlier, slope) = before.at(self.on_the_earlier(place))?;
        let (sine, cosine) = self.turn.sin_cos();
        let [x, y] = place;
        let turned = [-sine * x - cosine * y, cosine * x - sine * y];
        let by_turn = (slope[0] * turned[0] + slope[1] * turned[1]) / reach;
        let [u, v] = [x / reach, y / reach];
        let falls = [slope[0], slope[1], by_turn, 1.0, u, v, u * u, u * v, v * v];
        Some((height - earlier - self.level(place), falls))
    }
}

#[cfg(test)]
mod tests {
    use super::super::sample::Spline;
    use super::{PARAMETERS, Placement};
    use crate::map::HeightMap;

    /// The derivatives are those of finite differences, on a plane under a bent level: slopes are smoothed.
    #[test]
    fn changes_have_their_derivatives() {
        let blank = HeightMap::new([21, 21], [0.1; 2], vec![0.0; 441]).unwrap();
        let height = |at: usize| {
            let (x, y) = (blank.place(0, at % 21), blank.place(1, at / 21));
            0.3 * x - 0.2 * y
        };
        let before = Spline::of(&blank.of_heights((0..441).map(height).collect()));
        let (tilt, form) = ([0.1, -0.4], [0.2, 0.1, -0.3]);
        let placed = Placement { shift: [0.1, -0.05], turn: 0.2, offset: 0.3, tilt, form };
        let (place, reach) = ([0.31, -0.22], 1.7);
        let change = |placed: &Placement| placed.change(&before, (place, 1.0), reach).unwrap();
        let (_, falls) = change(&placed);
        for one in 0..PARAMETERS {
            let step = |size: f64| {
                let mut by = [0.0; PARAMETERS];
                by[one] = size;
                change(&placed.changed(by, reach)).0
            };
            let slope = (step(1e-5) - step(-1e-5)) / 2e-5;
            // The rim of the spline is 8 points away.
            assert!((slope + falls[one]).abs() < 1e-4, "{one}: {slope} {}", falls[one]);
        }
    }
}
