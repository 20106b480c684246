//! Smooth interpolation of measured points.

use crate::numerics::SAME;

/// What two computations of one place differ by at most, relative to the largest: of an even grid, each has a spacing, its
/// product, and two sums, all of them rounded.
const ROUNDING: f64 = 8.0 * (0.5 * f64::EPSILON);

/// Cubic interpolation through four values at four rising places, between the middle two.
///
/// Hermite's cubic with the slopes of the parabolas through three neighbours: exact for parabolas
/// on any spacing, continuous with its slope from interval to interval.
fn between(place: f64, places: [f64; 4], values: [f64; 4]) -> f64 {
    let slope = |i: usize| {
        let (before, after) = (places[i] - places[i - 1], places[i + 1] - places[i]);
        let (fall, rise) =
            ((values[i] - values[i - 1]) / before, (values[i + 1] - values[i]) / after);
        (fall * after + rise * before) / (before + after)
    };
    let width = places[2] - places[1];
    let t = (place - places[1]) / width;
    let (a, b) = (slope(1) * width, slope(2) * width);
    let rise = values[2] - values[1];
    values[1] + t * (a + t * (3.0 * rise - 2.0 * a - b + t * (a + b - 2.0 * rise)))
}

/// Interpolates `value(i)`, known at the rising `places`, at `place`; not a number outside them.
///
/// At a known place, to rounding, it is the value there. At least two places are needed. The outermost intervals continue the
/// values by the straight line (two places) or the parabola (three and more) through the outermost places.
pub fn interpolate(places: &[f64], value: impl Fn(usize) -> f64, place: f64) -> f64 {
    let last = places.len() - 1;
    let margin = SAME * (places[last] - places[0]);
    if !(places[0] - margin..=places[last] + margin).contains(&place) {
        return f64::NAN;
    }
    let place = place.clamp(places[0], places[last]);
    let left = places.partition_point(|&known| known <= place).clamp(1, last) - 1;
    let rounding = ROUNDING * places[0].abs().max(places[last].abs());
    let here = [left, left + 1].into_iter().find(|&i| (places[i] - place).abs() <= rounding);
    if let Some(here) = here {
        return value(here);
    }
    let mut near = [(0.0, 0.0); 4];
    for (offset, point) in near.iter_mut().enumerate() {
        if let Some(i) = (left + offset).checked_sub(1).filter(|&i| i <= last) {
            *point = (places[i], value(i));
        }
    }
    if left == 0 {
        near[0] = beyond(near[1], near[2], (last > 1).then_some(near[3]));
    }
    if left + 1 == last {
        near[3] = beyond(near[2], near[1], (last > 1).then_some(near[0]));
    }
    between(place, near.map(|point| point.0), near.map(|point| point.1))
}

/// The point as far beyond `end` as `inner` lies within, on the parabola through the three points
/// or, where there is no third, on the straight line.
fn beyond(end: (f64, f64), inner: (f64, f64), third: Option<(f64, f64)>) -> (f64, f64) {
    let place = 2.0 * end.0 - inner.0;
    let slope = (end.1 - inner.1) / (end.0 - inner.0);
    let line = end.1 + slope * (place - end.0);
    let Some(third) = third else { return (place, line) };
    let bend = ((inner.1 - third.1) / (inner.0 - third.0) - slope) / (third.0 - end.0);
    (place, line + bend * (place - end.0) * (place - inner.0))
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::interpolate;

    #[test]
    fn parabolas_are_exact_on_uneven_spacing() {
        let places = [-1.0, -0.2, 0.1, 0.7, 2.0];
        let parabola = |x: f64| 3.0 - x + 2.0 * x * x;
        for step in 0..=60 {
            let x = -1.0 + 0.05 * f64::from(step);
            let value = interpolate(&places, |i| parabola(places[i]), x);
            assert_relative_eq!(value, parabola(x), epsilon = 1e-13);
        }
    }

    /// A grid that is computed in another way is the same, and asks for one value at each place.
    #[test]
    fn at_known_places_only_the_value_there_is_asked_for() {
        for count in [5_usize, 30, 77, 1024] {
            let (size, half) = (0.512e-3, 0.5 * (count - 1) as f64);
            let spacing = size / count as f64;
            let places: Vec<f64> = (0..count).map(|i| spacing * (i as f64 - half)).collect();
            for i in 0..count {
                let asked = std::cell::Cell::new(0);
                let value = |known: usize| {
                    asked.set(asked.get() + 1);
                    known as f64
                };
                let place = -0.5 * size + (i as f64 + 0.5) * spacing;
                assert_eq!(interpolate(&places, value, place), i as f64);
                assert_eq!(asked.get(), 1, "{i} of {count}");
            }
        }
    }

    #[test]
    fn two_points_give_the_straight_line_and_nothing_beyond() {
        assert_relative_eq!(interpolate(&[0.0, 2.0], |i| [1.0, 5.0][i], 0.5), 2.0);
        assert!(interpolate(&[0.0, 2.0], |i| [1.0, 5.0][i], 2.1).is_nan());
    }

    /// The outermost of 1024 centres, by its spacing and as three digits of a micrometre more than a file has.
    #[test]
    fn rounding_does_not_leave_the_table() {
        let end = 1.2e-3 * (0.5 - 0.5 / 1024.0);
        let places = [-end, 0.0, end];
        let square = |place: f64| interpolate(&places, |i| places[i] * places[i], place);
        for beyond in [end.next_up(), -end.next_up(), end * (1.0 + 1e-10)] {
            assert_relative_eq!(square(beyond), end * end, max_relative = 1e-8);
        }
        assert!(square(end * (1.0 + 1e-6)).is_nan());
    }
}
