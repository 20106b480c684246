//! Friction solved on the part of the frame that is in contact.

use super::{FrictionSolver, Outcome, Start, Step, Tie, tied};
use crate::compliance::SlipMap;
use crate::numerics::convolution::even_smooth;

/// Elements kept free around the contact: material is still rubbed on its way past the trailing edge.
const MARGIN: usize = 1;
/// Share of the frame's elements above which a part of it is not worth while.
const WHOLE: f64 = 0.75;

/// Solves a step on the part of the frame around its contact, where that is much smaller. Tractions and slip
/// are zero on the rest.
pub(super) fn solve(
    solver: &dyn FrictionSolver,
    step: &Step<'_>,
    ties: &[Tie],
    start: Option<Start<'_>>,
) -> Outcome {
    let part = Part::around(step).and_then(|part| {
        let map = step.map.within(part.size)?;
        Some((part, map))
    });
    let Some((part, map)) = part else { return tied::solve(solver, step, ties, start) };
    let solver = Within { part: &part, solver, ties };
    solver.solve(&*map, step, start)
}

/// A solver of a part of the frame, and what is tied on the whole.
struct Within<'a> {
    part: &'a Part,
    solver: &'a dyn FrictionSolver,
    ties: &'a [Tie],
}

impl Within<'_> {
    fn solve(&self, map: &dyn SlipMap, step: &Step<'_>, start: Option<Start<'_>>) -> Outcome {
        let part = self.part;
        let limit = part.cut(step.limit);
        let rigid = step.rigid.map(|rigid| part.cut(rigid));
        let step = Step {
            map,
            elements: part.size,
            limit: &limit,
            rigid: [&rigid[0], &rigid[1]],
            ..*step
        };
        let cut = start.map(|start| {
            let traction = start.traction.map(|traction| part.cut(traction));
            (traction, part.cut(start.limit), start.rigid_slip)
        });
        let start = cut.as_ref().map(|(traction, limit, rigid_slip)| Start {
            traction: [&traction[0], &traction[1]],
            limit,
            rigid_slip,
        });
        let place = |tie: &Tie| Tie { pair: part.place(tie.pair), to: part.place(tie.to), ..*tie };
        let ties: Vec<Tie> = self.ties.iter().map(place).collect();
        let outcome = tied::solve(self.solver, &step, &ties, start);
        let [traction, slip] = [&outcome.traction, &outcome.slip]
            .map(|both| both.each_ref().map(|field| part.put(field)));
        Outcome { traction, slip, ..outcome }
    }
}

/// A rectangle of elements.
struct Part {
    frame: [usize; 2],
    first: [usize; 2],
    size: [usize; 2],
}

impl Part {
    /// The rectangle around the contact of a step, of a size that transforms well; `None` if it is nearly
    /// the frame or there is no contact.
    fn around(step: &Step<'_>) -> Option<Self> {
        let frame = step.elements;
        let (mut low, mut high) = (frame, [0, 0]);
        for pair in (0..step.limit.len()).filter(|&pair| step.limit[pair] > 0.0) {
            for (axis, index) in [pair % frame[0], pair / frame[0]].into_iter().enumerate() {
                low[axis] = low[axis].min(index);
                high[axis] = high[axis].max(index + 1);
            }
        }
        if high[0] == 0 {
            return None;
        }
        let size = [0, 1].map(|axis| roomy(high[axis] - low[axis] + 2 * MARGIN).min(frame[axis]));
        let first = [0, 1].map(|axis| {
            let spare = size[axis] - (high[axis] - low[axis]).min(size[axis]);
            low[axis].saturating_sub(spare / 2).min(frame[axis] - size[axis])
        });
        let share = (size[0] * size[1]) as f64 / (frame[0] * frame[1]) as f64;
        (share < WHOLE).then_some(Self { frame, first, size })
    }

    /// Where an element of the frame that lies in the rectangle stands there.
    fn place(&self, pair: usize) -> usize {
        let [x, y] = [pair % self.frame[0], pair / self.frame[0]];
        x - self.first[0] + self.size[0] * (y - self.first[1])
    }

    /// The rectangle's values of a field.
    fn cut(&self, field: &[f64]) -> Vec<f64> {
        let row = |row: usize| {
            let start = self.first[0] + self.frame[0] * (self.first[1] + row);
            &field[start..start + self.size[0]]
        };
        (0..self.size[1]).flat_map(row).copied().collect()
    }

    /// The field of the frame with these values, zero beside them.
    fn put(&self, values: &[f64]) -> Vec<f64> {
        let mut field = vec![0.0; self.frame[0] * self.frame[1]];
        for (row, values) in values.chunks(self.size[0]).enumerate() {
            let start = self.first[0] + self.frame[0] * (self.first[1] + row);
            field[start..start + self.size[0]].copy_from_slice(values);
        }
        field
    }
}

/// The next number at least `n` whose double transforms well; few sizes are met while a contact grows.
fn roomy(n: usize) -> usize {
    even_smooth(2 * n) / 2
}

#[cfg(test)]
mod tests {
    use super::Part;

    #[test]
    fn a_part_is_cut_out_and_put_back() {
        let part = Part { frame: [5, 4], first: [1, 2], size: [3, 2] };
        let field: Vec<f64> = (0..20).map(f64::from).collect();
        let cut = part.cut(&field);
        assert_eq!(cut, [11.0, 12.0, 13.0, 16.0, 17.0, 18.0]);
        let put = part.put(&cut);
        assert_eq!(put.iter().sum::<f64>(), cut.iter().sum::<f64>());
        assert_eq!(part.cut(&put), cut);
        assert!(
            (0..20)
                .filter(|&pair| put[pair] > 0.0)
                .all(|pair| cut[part.place(pair)] == field[pair])
        );
    }
}
