//! Steps shortened until they lower the residual.

/// Decrease of the residual, relative to it and to the length of the step, that is enough.
const DECREASE: f64 = 1e-4;

/// The iterate after as much of a change as lowers the residual, all of it or a half again and again down to a shortest
/// length, with its residual; `None` where hardly any does. `moved` takes a share of the change.
pub(in crate::solve) fn shorten<S>(
    residual: f64,
    shortest: f64,
    moved: impl Fn(f64) -> (S, f64),
) -> Option<(S, f64)> {
    let mut length = 1.0;
    while length >= shortest {
        let (next, lower) = moved(length);
        if lower < (1.0 - DECREASE * length) * residual {
            return Some((next, lower));
        }
        length *= 0.5;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::shorten;

    #[test]
    fn a_step_is_halved_until_the_residual_falls() {
        // |1 - 3 x| is 2, then 0.5.
        let line = |length: f64| (length, (1.0 - 3.0 * length).abs());
        assert_eq!(shorten(1.0, 0.1, line), Some((0.5, 0.5)));
        assert_eq!(shorten(1.0, 0.6, line), None);
        assert_eq!(shorten(f64::NAN, 0.1, line), None);
    }
}
