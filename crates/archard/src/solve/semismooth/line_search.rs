//! Steps shortened until they lower the residual.

/// Decrease of the residual, relative to it and to the length of the step, that is enough (C. T. Kelley, *Iterative Methods
/// for Linear and Nonlinear Equations*, SIAM 1995, section 8.1).
const DECREASE: f64 = 1e-4;
/// The shortest length: four halvings. A direction that fails then is not one of descent.
const SHORTEST: f64 = 1.0 / 16.0;

/// The iterate after as much of a change as lowers the residual, all of it or a half again and again, with its residual; `None`
/// where hardly any does. `moved` takes a share of the change.
pub(in crate::solve) fn shorten<S>(
    residual: f64,
    moved: impl Fn(f64) -> (S, f64),
) -> Option<(S, f64)> {
    let mut length = 1.0;
    while length >= SHORTEST {
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
        assert_eq!(shorten(1.0, line), Some((0.5, 0.5)));
        // |1 - 100 x| is 5.25 at the last.
        assert_eq!(shorten(1.0, |length| (length, (1.0 - 100.0 * length).abs())), None);
        assert_eq!(shorten(f64::NAN, line), None);
    }
}
