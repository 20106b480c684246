//! What a wear law owes, tried at many points.
//!
//! A depth is finite, not negative, zero without pressure or slip, and does not fall as the pressure grows; its slope is
//! finite. Per increment, two halves of a slip wear what the whole does. The pressures go from 1 Pa to 10 GPa, the slips
//! from a nanometre to 100 m, all else over what tests of wear have.

use super::rubbing::NUMBERS;
use super::{Columns, Input, Per, Rubbing, WearLaw};
use crate::numerics::{SAME, WRITTEN};
use crate::parameters::Invalid;

/// Slips (m), and those that are halved.
const SLIPS: [f64; 7] = [0.0, 1e-9, 1e-6, 1e-3, 0.1, 10.0, 100.0];
const HALVED: [f64; 4] = [1e-6, 1e-3, 0.1, 10.0];

/// Coefficients of friction, speeds (m/s), temperatures (K), distances slid and depths worn before (m), distances rolled
/// (m).
const COEFFICIENTS: [f64; 2] = [0.05, 0.8];
const SPEEDS: [f64; 3] = [1e-3, 0.1, 10.0];
const TEMPERATURES: [f64; 4] = [290.0, 400.0, 700.0, 1100.0];
const DISTANCES: [f64; 3] = [0.0, 0.1, 1e3];
const DEPTHS: [f64; 3] = [0.0, 1e-6, 1e-4];
const ROLLED: [f64; 2] = [1e-3, 1.0];
/// Shares by which directions of slip cross each other.
const CROSSING: [f64; 3] = [0.0, 0.1, 0.5];

/// Zero and 1, 2, 5 of each decade from 1 Pa to 10 GPa.
fn pressures() -> Vec<f64> {
    let decades = (0..10).flat_map(|tens| [1.0, 2.0, 5.0].map(|first| first * 10f64.powi(tens)));
    [0.0].into_iter().chain(decades).chain([1e10]).collect()
}

/// Tries a law at many points: its depth has to be finite, not negative, zero without pressure or slip, must not fall as
/// the pressure grows and, [per increment](Per::Increment), two halves of a slip have to wear what the whole does.
///
/// # Errors
/// If it is not so, with the point.
pub fn try_out(law: &dyn WearLaw) -> Result<(), Invalid> {
    let all = surroundings(law.inputs());
    for surroundings in &all {
        for slip in SLIPS {
            grows_with_pressure(law, surroundings, slip)?;
        }
    }
    if law.per() == Per::Increment { adds_up(law, &all) } else { Ok(()) }
}

/// All that a law asks for besides pressure and slip, in all combinations; the work is that of slip.
fn surroundings(inputs: &[Input]) -> Vec<Rubbing> {
    let mut all = vec![Rubbing::default()];
    let mut vary = |input, values: &[f64], set: fn(Rubbing, f64) -> Rubbing| {
        if inputs.contains(&input) {
            let each = |&one: &Rubbing| values.iter().map(move |&value| set(one, value));
            all = all.iter().flat_map(each).collect();
        }
    };
    vary(Input::Friction, &COEFFICIENTS, |one, friction| one.with_friction(0.0, friction));
    vary(Input::Speed, &SPEEDS, Rubbing::at_speed);
    vary(Input::Temperature, &TEMPERATURES, Rubbing::at_temperature);
    vary(Input::Distance, &DISTANCES, |one, distance| one.after(distance, one.depth));
    vary(Input::Depth, &DEPTHS, |one, depth| one.after(one.distance, depth));
    vary(Input::Rolled, &ROLLED, Rubbing::rolling);
    vary(Input::CrossShear, &CROSSING, |one, share| Rubbing {
        directions: [1.0 - share, share, 0.0],
        ..one
    });
    all
}

/// What points go through under all pressures that slide so far.
fn points(surroundings: &Rubbing, slip: f64) -> Vec<Rubbing> {
    let point = |pressure| Rubbing {
        pressure,
        slip,
        work: surroundings.friction * pressure * slip,
        slip_vector: [slip, 0.0],
        traction: [surroundings.friction * pressure, 0.0],
        directions: surroundings.directions.map(|part| part * pressure * slip),
        ..*surroundings
    };
    pressures().into_iter().map(point).collect()
}

/// Depths (m) and slopes (m/Pa) at points.
fn worn(law: &dyn WearLaw, points: &[Rubbing]) -> (Vec<f64>, Vec<f64>) {
    let (mut depths, mut slopes) = (vec![0.0; points.len()], vec![0.0; points.len()]);
    let columns = Columns::of(points.iter().copied(), law.inputs());
    law.depths(&columns, &mut depths, &mut slopes);
    (depths, slopes)
}

fn grows_with_pressure(
    law: &dyn WearLaw,
    surroundings: &Rubbing,
    slip: f64,
) -> Result<(), Invalid> {
    let points = points(surroundings, slip);
    let (depths, slopes) = worn(law, &points);
    let mut least = 0.0;
    for (at, ((point, &depth), &slope)) in points.iter().zip(&depths).zip(&slopes).enumerate() {
        let place = || place(law, point);
        if !depth.is_finite() {
            return refuse(format!("is no finite number, {depth} at {}", place()));
        }
        if depth < 0.0 {
            return refuse(format!("is negative: {} m at {}", digits(depth), place()));
        }
        if depth > 0.0 && (point.pressure == 0.0 || slip == 0.0) {
            let lacking = if slip == 0.0 { "slip" } else { "pressure" };
            return refuse(format!(
                "grows from nothing: {} m without {lacking}, at {}",
                digits(depth),
                place()
            ));
        }
        if !slope.is_finite() {
            let message = format!("rises infinitely steep with the pressure, at {}", place());
            let help = "write `p*max(p, p1)^(n - 1)` for `p^n`: it is a straight line below p1";
            return Err(refused(message).help(help));
        }
        if depth < least * (1.0 - SAME) || slope * point.pressure < -SAME * depth {
            let before = &points[at.saturating_sub(1)];
            let less = if depth < least {
                format!(", less than {} m at p = {} Pa", digits(least), digits(before.pressure))
            } else {
                format!(", with a slope of {} m/Pa", digits(slope))
            };
            let depth = digits(depth);
            return refuse(format!("falls as the pressure grows: {depth} m at {}{less}", place()));
        }
        least = depth;
    }
    Ok(())
}

/// Two halves of a slip wear what the whole does: the second after the first, or both as if at the start, as laws do that
/// take what was before a step for the whole of it.
fn adds_up(law: &dyn WearLaw, all: &[Rubbing]) -> Result<(), Invalid> {
    let (mut in_turn, mut at_start) = (Ok(()), Ok(()));
    for (surroundings, slip) in all.iter().flat_map(|one| HALVED.map(|slip| (one, slip))) {
        let whole = points(surroundings, slip);
        let (depths, _) = worn(law, &whole);
        let half = Rubbing { rolled: 0.5 * surroundings.rolled, ..*surroundings };
        let first = points(&half, 0.5 * slip);
        let (first_depths, _) = worn(law, &first);
        let second = first
            .iter()
            .zip(&first_depths)
            .map(|(point, depth)| point.after(point.distance + point.slip, point.depth + depth));
        let (second_depths, _) = worn(law, &second.collect::<Vec<_>>());
        for (at, point) in whole.iter().enumerate() {
            for (kept, next) in
                [(&mut in_turn, second_depths[at]), (&mut at_start, first_depths[at])]
            {
                let halves = first_depths[at] + next;
                if (halves - depths[at]).abs() > WRITTEN * depths[at].max(halves) && kept.is_ok() {
                    *kept = Err((*point, depths[at], halves));
                }
            }
        }
    }
    match (in_turn, at_start) {
        (Err((point, depth, halves)), Err(_)) => {
            let place = place(law, &point);
            let message = format!(
                "is not in proportion to the slip: {} m at {place}, and {} m in two halves of it",
                digits(depth),
                digits(halves)
            );
            Err(refused(message).help("say `per = \"cycle\"` if the formula takes a cycle at once"))
        }
        _ => Ok(()),
    }
}

/// What a law depends on, with its values at a point: "p = 1e8 Pa, s = 1e-3 m".
fn place(law: &dyn WearLaw, point: &Rubbing) -> String {
    let friction = law.inputs().contains(&Input::Friction).then_some(("mu", point.friction, ""));
    let numbers = NUMBERS.iter().filter(|number| law.inputs().contains(&number.input));
    let asked = numbers.map(|number| (number.name, (number.of)(point), number.unit));
    let always = [("p", point.pressure, "Pa"), ("s", point.slip, "m")];
    let part = |(name, value, unit): (&str, f64, &str)| {
        format!("{name} = {} {unit}", digits(value)).trim_end().to_owned()
    };
    always.into_iter().chain(friction).chain(asked).map(part).collect::<Vec<_>>().join(", ")
}

fn refused(message: String) -> Invalid {
    Invalid::new("depth", message)
}

fn refuse(message: String) -> Result<(), Invalid> {
    Err(refused(message))
}

/// Six digits of a number, or as many as it has.
fn digits(value: f64) -> String {
    let rounded = format!("{value:.5e}").parse().unwrap_or(value);
    let plain = rounded == 0.0 || (1e-3..1e4).contains(&f64::abs(rounded));
    if plain { rounded.to_string() } else { format!("{rounded:e}") }
}

#[cfg(test)]
mod tests {
    use super::super::{Archard, Rubbing, RunningIn, WearLaw};
    use super::try_out;

    /// All laws that go by what the trial has keep to it; one that does not is told where.
    #[test]
    fn laws_of_any_kind_are_tried() {
        #[derive(Debug)]
        struct Sinking;
        impl WearLaw for Sinking {
            fn depth(&self, rubbing: Rubbing) -> f64 {
                1e-13 * (rubbing.pressure - 1e6) * rubbing.slip
            }
        }
        try_out(&Archard::new(1e-13).unwrap()).unwrap();
        try_out(&RunningIn::new([1e-12, 1e-13], 10.0).unwrap()).unwrap();
        let refused = try_out(&Sinking).unwrap_err();
        assert_eq!(refused.message, "is negative: -1e-16 m at p = 0 Pa, s = 1e-9 m");
    }
}
