//! The direction of rolling.

/// A direction along an axis of the frame. A contact that rolls that way leaves material behind: what
/// enters at its leading edge, the foremost, flows against the direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Direction {
    /// 0 along x, 1 along y.
    pub axis: usize,
    /// Towards smaller coordinates instead of larger.
    pub reversed: bool,
}

impl Direction {
    /// Along x.
    pub const X: Self = Self { axis: 0, reversed: false };
    /// Along y.
    pub const Y: Self = Self { axis: 1, reversed: false };

    /// The opposite direction.
    pub fn back(self) -> Self {
        Self { reversed: !self.reversed, ..self }
    }

    fn sense(self) -> f64 {
        if self.reversed { -1.0 } else { 1.0 }
    }

    /// Unit vector of the direction.
    pub fn forward(self) -> [f64; 2] {
        let mut unit = [0.0; 2];
        unit[self.axis] = self.sense();
        unit
    }

    /// Unit vector across it, a quarter turn from `forward` about n as t2 is from t1.
    pub fn lateral(self) -> [f64; 2] {
        let [x, y] = self.forward();
        [-y, x]
    }

    /// The pair ahead on a grid of that many elements, from which the material comes; `None` on the
    /// foremost.
    pub fn ahead(self, pair: usize, elements: [usize; 2]) -> Option<usize> {
        let index = [pair % elements[0], pair / elements[0]][self.axis];
        let stride = [1, elements[0]][self.axis];
        if self.reversed {
            (index > 0).then(|| pair - stride)
        } else {
            (index + 1 < elements[self.axis]).then_some(pair + stride)
        }
    }

    /// What material passing from the pair ahead gains of a field, one value a pair; on the foremost
    /// pairs, what it gains on the way to the next.
    pub fn gained(self, field: &[f64], elements: [usize; 2]) -> Vec<f64> {
        let back = self.back();
        let gain = |pair: usize| match self.ahead(pair, elements) {
            Some(ahead) => field[pair] - field[ahead],
            None => back.ahead(pair, elements).map_or(0.0, |next| field[next] - field[pair]),
        };
        (0..field.len()).map(gain).collect()
    }

    /// The lines of rolling: in each, the pairs a particle passes, in the order it passes them.
    pub fn lines(
        self,
        elements: [usize; 2],
    ) -> impl Iterator<Item = impl Iterator<Item = usize> + Clone> {
        let (along, across) = (elements[self.axis], elements[1 - self.axis]);
        let strides = [1, elements[0]];
        let (stride, reversed) = (strides[self.axis], self.reversed);
        (0..across).map(move |line| {
            let first = line * strides[1 - self.axis];
            (0..along).map(move |step| {
                let index = if reversed { step } else { along - 1 - step };
                first + stride * index
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Direction;

    #[test]
    fn particles_pass_every_pair_once_from_the_leading_edge_on() {
        let elements = [4, 3];
        for (axis, reversed) in [(0, false), (0, true), (1, false), (1, true)] {
            let direction = Direction { axis, reversed };
            let mut passed = [0; 12];
            for line in direction.lines(elements) {
                let mut last = None;
                for pair in line {
                    passed[pair] += 1;
                    assert_eq!(direction.ahead(pair, elements), last);
                    last = Some(pair);
                }
            }
            assert_eq!(passed, [1; 12]);
        }
    }

    #[test]
    fn across_is_a_quarter_turn_on() {
        let rolling = |axis, reversed| Direction { axis, reversed }.lateral();
        assert_eq!(rolling(0, false), [0.0, 1.0]);
        assert_eq!(rolling(1, false), [-1.0, 0.0]);
    }
}
