//! Friction solved on the part of the frame that is in contact.

use super::{FrictionSolver, Outcome, Start, Step};
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
    start: Option<Start<'_>>,
) -> Outcome {
    let Some(part) = Part::around(step) else { return solver.solve(step, start) };
    let Some(map) = step.map.within(part.size) else { return solver.solve(step, start) };
    solve_on(&part, &*map, solver, step, start)
}

fn solve_on(
    part: &Part,
    map: &dyn SlipMap,
    solver: &dyn FrictionSolver,
    step: &Step<'_>,
    start: Option<Start<'_>>,
) -> Outcome {
    let limit = part.cut(step.limit);
    let rigid = step.rigid.map(|rigid| part.cut(rigid));
    let step =
        Step { map, elements: part.size, limit: &limit, rigid: [&rigid[0], &rigid[1]], ..*step };
    let cut = start.map(|start| {
        (start.traction.map(|traction| part.cut(traction)), part.cut(start.limit), start.rigid_slip)
    });
    let start = cut.as_ref().map(|(traction, limit, rigid_slip)| Start {
        traction: [&traction[0], &traction[1]],
        limit,
        rigid_slip,
    });
    let outcome = solver.solve(&step, start);
    let [traction, slip] =
        [&outcome.traction, &outcome.slip].map(|both| both.each_ref().map(|field| part.put(field)));
    Outcome { traction, slip, ..outcome }
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
    }
}
