//! The fields of a state as a user sees them.

use crate::problem::{ContactProblem, ContactState};

/// A field on the pairs of the frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// What it is, with its unit: "pressure_Pa".
    pub name: String,
    /// One value a pair, x running fastest.
    pub values: Vec<f64>,
}

impl Field {
    /// A field of that name.
    fn new(name: impl Into<String>, values: Vec<f64>) -> Self {
        Self { name: name.into(), values }
    }
}

/// Pressure, gap, wear of each body and of both, and the worn height of each body.
///
/// Heights are measured from the plane of contact along the outward normal of body 1, without
/// elastic deformation. Body 1 lies below that plane and body 2 above it, so wear lowers the height
/// of body 1 and raises that of body 2, and the height of body 2 less that of body 1 is the gap of
/// the worn, undeformed surfaces.
pub fn fields(problem: &ContactProblem, state: &ContactState) -> Vec<Field> {
    let mut fields = vec![
        Field::new("pressure_Pa", state.pressure.clone()),
        Field::new("gap_m", state.gap.clone()),
    ];
    for (body, worn) in problem.bodies.iter().zip(&state.worn) {
        fields.push(Field::new(format!("wear_{}_m", body.name), worn.clone()));
    }
    fields.push(Field::new("wear_m", state.total_worn()));
    for (index, body) in problem.bodies.iter().enumerate() {
        fields.push(Field::new(format!("height_{}_m", body.name), heights(problem, state, index)));
    }
    fields
}

/// Worn height (m) of a body, one value a pair.
fn heights(problem: &ContactProblem, state: &ContactState, body: usize) -> Vec<f64> {
    let side = if body == 0 { -1.0 } else { 1.0 };
    let profile = &problem.bodies[body].profile;
    let height = |(pair, worn): (usize, &f64)| {
        let [x, y] = problem.frame.place(pair);
        // The zero turns -0, which would be shown, into 0.
        side * (profile.recess(x, y) + worn) + 0.0
    };
    state.worn[body].iter().enumerate().map(height).collect()
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::fields;
    use crate::output::fixture::Run;

    #[test]
    fn heights_leave_the_gap_between_them() {
        let run = Run::pin_on_disc([6, 5]);
        let state = run.state(0.3);
        let fields = fields(&run.problem, &state);
        let named = |name: &str| &fields.iter().find(|field| field.name == name).unwrap().values;
        let (pin, disc, wear) = (named("height_pin_m"), named("height_disc_m"), named("wear_m"));
        let gap: Vec<f64> = disc.iter().zip(pin).map(|(above, below)| above - below).collect();
        let touch = gap[0] - wear[0] - run.problem.frame.gap()[0];
        for pair in 0..gap.len() {
            let expected = run.problem.frame.gap()[pair] + wear[pair] + touch;
            assert_relative_eq!(gap[pair], expected, epsilon = 1e-18);
        }
        let middle = 2 + 6 * 2;
        assert!(pin[middle] < 0.0 && disc[middle] > 0.0);
    }
}
