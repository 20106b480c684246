//! Johnson's map: up to what peak pressure a contact that rolls or slides with friction stays elastic, and up to what it shakes down.
//!
//! K. L. Johnson, *Contact Mechanics* (1985), sections 7.2 and 9.2. Pressures are over the yield stress in shear k, friction is the ratio
//! of tangential traction and pressure in all of the contact. First yield is von Mises' at a Poisson's ratio of 0.3, from the whole field:
//! Hankel integrals of a ball, McEwen's stresses of a line. A line shakes down after Melan by the shear along the surface (K. L. Johnson &
//! J. A. Jefferis, 1963). Of a ball only limits are known here (A. R. S. Ponter, A. D. Hearle & K. L. Johnson, *J. Mech. Phys. Solids* 33
//! (1985) 339): 4.7 without friction, and one over the friction, where the surface flows, above a friction of 0.25 to 0.3. Between them it
//! is an estimate.

/// Friction, and peak pressure of first yield of a ball and of a line, and of the shakedown of a line.
const LIMITS: [[f64; 4]; 8] = [
    [0.0, 2.7934, 3.1067, 4.0],
    [0.1, 2.7737, 3.0631, 3.5642],
    [0.2, 2.7162, 2.9357, 3.2024],
    [0.25, 2.6746, 2.8429, 3.0444],
    [0.3, 2.6253, 2.5982, 2.8996],
    [0.35, 2.3752, 2.3417, 2.7665],
    [0.4, 2.1522, 2.1230, 2.5],
    [0.5, 1.8105, 1.7770, 2.0],
];

/// Shakedown of a ball without friction.
const BALL: f64 = 4.7;
/// Between which friction the surface takes over.
const TAKES_OVER: [f64; 2] = [0.25, 0.3];

/// The friction up to which the map reaches.
pub const REACH: f64 = LIMITS[LIMITS.len() - 1][0];

/// Limits of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Peak pressure over the yield stress in shear at which it yields first.
    pub first_yield: f64,
    /// The same up to which it shakes down, from and to: equal where that is no estimate.
    pub shakedown: [f64; 2],
}

impl Limits {
    /// Of a line of contact or of a ball with that much friction; `None` beyond the [reach](REACH) of the map.
    pub fn of(line: bool, friction: f64) -> Option<Self> {
        let above = LIMITS.iter().position(|[own, ..]| *own >= friction)?;
        let [low, high] = [LIMITS[above.saturating_sub(1)], LIMITS[above]];
        let share = if high[0] > low[0] { (friction - low[0]) / (high[0] - low[0]) } else { 0.0 };
        let between = |column: usize| (1.0 - share) * low[column] + share * high[column];
        if line {
            return Some(Self { first_yield: between(2), shakedown: [between(3); 2] });
        }
        let estimate = |from: f64| {
            if friction >= from {
                1.0 / friction
            } else {
                BALL + (1.0 / from - BALL) * friction / from
            }
        };
        let [one, other] = TAKES_OVER.map(estimate);
        Some(Self { first_yield: between(1), shakedown: [one.min(other), one.max(other)] })
    }
}

#[cfg(test)]
mod tests {
    use super::{LIMITS, Limits};
    use crate::closed_form::first_yield::FirstYield;
    use crate::closed_form::sliding_line;
    use crate::stress::{orthogonal_shear, von_mises};

    #[test]
    fn limits_of_a_line_are_those_of_mcewens_field() {
        let root = 3f64.sqrt();
        for [friction, ball, yields, shakes] in LIMITS {
            // Dense at the surface, where the largest stress lies with much friction.
            let places = (-600..=600).map(|step| f64::from(step) * 0.0025);
            let depths: Vec<f64> =
                (0..=400).map(|step| (f64::from(step) / 400.0).powi(2)).collect();
            let all = places.flat_map(|x| depths.iter().map(move |z| [x, *z]));
            let most = all.fold([0.0f64; 2], |most, place| {
                let stress = sliding_line::stress(place, friction, 0.3);
                let own = [von_mises(&stress), orthogonal_shear(&stress)];
                [0, 1].map(|index| most[index].max(own[index]))
            });
            assert!((yields * most[0] / root - 1.0).abs() < 2e-3, "{friction}: {most:?}");
            assert!((shakes * most[1] - 1.0).abs() < 2e-3, "{friction}: {most:?}");
            let found = Limits::of(true, friction).unwrap();
            assert!((found.first_yield - yields).abs() < 1e-12 && ball > 0.0);
            assert_eq!(found.shakedown, [shakes; 2]);
        }
        assert!((LIMITS[0][1] / root - FirstYield::under_circle(0.3).pressure).abs() < 1e-4);
        assert!(Limits::of(true, 0.51).is_none());
    }

    #[test]
    fn a_ball_shakes_down_above_first_yield_by_an_estimate() {
        for step in 0..=50 {
            let own = Limits::of(false, 0.01 * f64::from(step)).unwrap();
            let [low, high] = own.shakedown;
            assert!(own.first_yield < low && low <= high && high < 1.25 * low, "{own:?}");
        }
        assert_eq!(Limits::of(false, 0.0).unwrap().shakedown, [4.7; 2]);
    }
}
