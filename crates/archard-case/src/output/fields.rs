//! The fields of a state as a user sees them.

use archard::problem::{ContactProblem, ContactState, Tangential};
use archard::simulation::history::FLASH_TEMPERATURE;

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
    pub(super) fn new(name: impl Into<String>, values: Vec<f64>) -> Self {
        Self { name: name.into(), values }
    }
}

/// Pressure, gap, wear of each body and of both, and the worn height of each body; where slip is told from
/// stick also the tangential traction on body 1, the slip and where the contact sticks; the rise of the temperature by
/// friction where it is known.
///
/// Heights are measured from the plane of contact along the outward normal of body 1, without
/// elastic deformation. Body 1 lies below that plane and body 2 above it, so wear lowers the height
/// of body 1 and raises that of body 2, and the height of body 2 less that of body 1 is the gap of
/// the worn, undeformed surfaces.
///
/// Slip is that of body 2 over body 1 in the last increment, or in rolling on the passage of particles to each pair
/// ([`Flow`](archard::frame::Flow)); it is zero where nothing touches. `stick` is 1 where the contact
/// sticks and 0 where it slips or is open.
pub fn fields(problem: &ContactProblem, state: &ContactState) -> Vec<Field> {
    let mut fields = vec![
        Field::new("pressure_Pa", state.pressure.clone()),
        Field::new("gap_m", state.gap_of(problem).into_owned()),
    ];
    for (index, body) in problem.bodies.iter().enumerate() {
        fields.push(Field::new(format!("wear_{}_m", body.name), state.worn(index).into_owned()));
    }
    fields.push(Field::new("wear_m", state.total_worn()));
    for (index, body) in problem.bodies.iter().enumerate().filter(|one| one.1.hardness.is_some()) {
        let imprint = state.surfaces[index].imprint.clone();
        fields.push(Field::new(format!("imprint_{}_m", body.name), imprint));
    }
    for (index, body) in problem.bodies.iter().enumerate() {
        fields.push(Field::new(format!("height_{}_m", body.name), heights(problem, state, index)));
    }
    if let Some(flash) = problem.flash(state) {
        fields.push(Field::new(FLASH_TEMPERATURE, flash.rise));
    }
    if let Some(tangential) = &state.tangential {
        fields.extend(friction(problem, state, tangential));
    }
    fields
}

/// Tangential traction on body 1, slip and stick.
fn friction(problem: &ContactProblem, state: &ContactState, tangential: &Tangential) -> [Field; 5] {
    let Tangential { traction: [traction_x, traction_y], slip: [slip_x, slip_y], .. } = tangential;
    let rubs = rubbing(problem, state);
    let rubbed = |slip: &[f64]| -> Vec<f64> {
        slip.iter().zip(&rubs).map(|(slip, rubs)| if *rubs { *slip } else { 0.0 }).collect()
    };
    let sticks = |pair: usize| f64::from(tangential.sticks(problem, &state.pressure, pair));
    [
        Field::new("traction_x_Pa", traction_x.clone()),
        Field::new("traction_y_Pa", traction_y.clone()),
        Field::new("slip_x_m", rubbed(slip_x)),
        Field::new("slip_y_m", rubbed(slip_y)),
        Field::new("stick", (0..rubs.len()).map(sticks).collect()),
    ]
}

/// Whether particles on their way to a pair are under pressure at either end of it.
fn rubbing(problem: &ContactProblem, state: &ContactState) -> Vec<bool> {
    let motion = &problem.motion;
    match motion.driven(0.0).and_then(|_| problem.frame.flow(motion.direction).ok()) {
        Some(flow) => flow.on_the_way(&state.pressure).iter().map(|mean| *mean > 0.0).collect(),
        None => state.pressure.iter().map(|pressure| *pressure > 0.0).collect(),
    }
}

/// Worn height (m) of a body, one value a pair.
fn heights(problem: &ContactProblem, state: &ContactState, body: usize) -> Vec<f64> {
    let mut heights = problem.heights(state, body);
    if body == 1 {
        // The zero turns -0, which would be shown, into 0.
        heights.iter_mut().for_each(|height| *height = 0.0 - *height);
    }
    heights
}

/// Height (m) of a body at a place (m) where that depth (m) is worn off.
pub(super) fn height(problem: &ContactProblem, body: usize, [x, y]: [f64; 2], worn: f64) -> f64 {
    let side = if body == 0 { -1.0 } else { 1.0 };
    // The zero turns -0, which would be shown, into 0.
    side * (problem.bodies[body].profile.recess(x, y) + worn) + 0.0
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::fields;
    use crate::output::fixture::{CREEPAGE, FRICTION, Run};
    use archard::frame::Direction;

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

    #[test]
    fn without_friction_there_are_no_tractions() {
        let run = Run::pin_on_disc([6, 5]);
        let names = fields(&run.problem, &run.state(0.3)).into_iter().map(|field| field.name);
        let known = "pressure_Pa gap_m wear_pin_m wear_disc_m wear_m height_pin_m height_disc_m";
        assert_eq!(names.collect::<Vec<_>>().join(" "), known);
    }

    /// A particle slips from the last element before the contact, one ahead of it, to the last in it
    /// and out of it: one element more than touch, on the trailing side.
    #[test]
    fn slip_ends_one_element_behind_the_contact() {
        for reversed in [false, true] {
            let run = Run::twin_discs([13, 9], Direction { axis: 0, reversed });
            let state = run.state(100.0);
            let fields = fields(&run.problem, &state);
            let named =
                |name: &str| &fields.iter().find(|field| field.name == name).unwrap().values;
            let middle = 13 * 4..13 * 5;
            let of_plane = |name: &str| named(name)[middle.clone()].to_vec();
            let (pressure, slip) = (of_plane("pressure_Pa"), of_plane("slip_x_m"));
            let touching: Vec<usize> = (0..13).filter(|&x| pressure[x] > 0.0).collect();
            let slipping: Vec<usize> = (0..13).filter(|&x| slip[x] != 0.0).collect();
            let (first, last) = (touching[0], touching[touching.len() - 1]);
            let expected = if reversed { first..=last + 1 } else { first - 1..=last };
            assert_eq!(slipping, expected.collect::<Vec<_>>());
            let advance = run.problem.frame.spacing()[0];
            assert_relative_eq!(slip[first].abs(), CREEPAGE * advance, max_relative = 1e-14);
        }
    }

    /// The area of the elements marked is the one in the history, and they bear less than mu p.
    #[test]
    fn stick_is_where_the_limit_is_not_reached() {
        let run = Run::twin_discs([13, 9], Direction { axis: 0, reversed: false });
        let state = run.state(100.0);
        let fields = fields(&run.problem, &state);
        let named = |name: &str| &fields.iter().find(|field| field.name == name).unwrap().values;
        let (stick, traction) = (named("stick"), named("traction_x_Pa"));
        for pair in 0..stick.len() {
            let below = traction[pair].abs() < 0.9 * FRICTION * state.pressure[pair];
            assert_eq!(stick[pair], f64::from(below), "{pair}");
        }
        let area = stick.iter().sum::<f64>() * run.problem.frame.element_area();
        let known = state.tangential.as_ref().unwrap().stick_area(&run.problem, &state.pressure);
        assert!(area > 0.0);
        assert_relative_eq!(area, known, max_relative = 1e-14);
    }
}
