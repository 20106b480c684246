//! How well the linear system of a Newton step is solved: the better, the better the last steps went.
//!
//! S. C. Eisenstat and H. F. Walker, *SIAM J. Sci. Comput.* 17 (1996) 16: their choice 2, with their constants and safeguard;
//! C. T. Kelley, *Iterative Methods for Linear and Nonlinear Equations*, SIAM 1995, section 6.3, for the bound that keeps
//! the last step from being solved better than asked for. The first term is no more than the residual: near a solution steps then
//! double its digits (R. S. Dembo, S. C. Eisenstat and T. Steihaug, *SIAM J. Numer. Anal.* 19 (1982) 400).

/// The first forcing term at most, and the largest.
const FIRST: f64 = 0.5;
const LARGEST: f64 = 0.9;
/// Factor and power of choice 2.
const FACTOR: f64 = 0.9;
const POWER: i32 = 2;
/// Terms that the safeguard keeps from falling too fast.
const GUARDED: f64 = 0.1;
/// Share of the residual aimed at that a step may leave (Kelley's).
const ENOUGH: f64 = 0.5;

/// The forcing term, step by step: what part of the residual the linear system of a step may leave.
#[derive(Debug, Default)]
pub(in crate::solve) struct Forcing {
    /// The last term, and the residual it was for.
    last: Option<(f64, f64)>,
}

impl Forcing {
    /// The term of the next step, about an iterate with a residual, towards the residual aimed at.
    pub fn next(&mut self, residual: f64, aim: f64) -> f64 {
        let term = self.last.map_or(FIRST.min(residual), |(term, before)| {
            let guard = FACTOR * term.powi(POWER);
            let wanted = FACTOR * (residual / before).powi(POWER);
            if guard > GUARDED { wanted.max(guard) } else { wanted }
        });
        let term = term.max(ENOUGH * aim / residual).min(LARGEST);
        self.last = Some((term, residual));
        term
    }

    /// The term of the same step once more, where it lowered no residual: its square; `None` where the system was solved as well
    /// as the residual aimed at asks for.
    pub fn again(&mut self, residual: f64, aim: f64) -> Option<f64> {
        let least = ENOUGH * aim / residual;
        let (term, _) = self.last.filter(|(term, _)| *term > least)?;
        let term = (term * term).max(least);
        self.last = Some((term, residual));
        Some(term)
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::Forcing;

    #[test]
    fn systems_are_solved_better_as_the_residual_falls() {
        let mut forcing = Forcing::default();
        // The first; guarded, .9 x .5^2; as the residual fell, .9 x .1^2; no more than half of the aim.
        let residuals = [1.0, 0.1, 0.01, 2e-6, 1.0];
        let expected = [0.5, 0.225, 0.009, 0.25, 0.9];
        for (residual, expected) in residuals.into_iter().zip(expected) {
            assert_relative_eq!(forcing.next(residual, 1e-6), expected, max_relative = 1e-12);
        }
    }

    #[test]
    fn a_step_that_brings_nothing_is_solved_better() {
        let mut forcing = Forcing::default();
        assert_relative_eq!(forcing.next(1.0, 0.02), 0.5);
        assert_eq!(forcing.again(1.0, 0.02), Some(0.25));
        assert_eq!(forcing.again(1.0, 0.02), Some(0.0625));
        assert_eq!(forcing.again(1.0, 0.02), Some(0.01));
        assert_eq!(forcing.again(1.0, 0.02), None);
    }
}
