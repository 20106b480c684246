//! How well the linear system of a step is solved: roughly while the pairs still change what they do.

/// Residuals of the linear system relative to its right-hand side.
#[derive(Debug, Clone, Copy)]
pub(in crate::solve) struct Tolerance {
    /// While more than a share `settled` of the pairs changes.
    pub loose: f64,
    /// After that.
    pub tight: f64,
    pub settled: f64,
    /// Share of the pairs, one pair at least, that may change where the residual of the problem bounds that of the system
    /// too.
    pub last: f64,
    /// Share of the residual aimed at that is enough.
    pub enough: f64,
}

impl Tolerance {
    /// Where so many of these pairs changed, about an iterate with a residual, towards the residual aimed at.
    pub fn of(&self, changed: usize, pairs: usize, residual: f64, aim: f64) -> f64 {
        let within = |share: f64| changed as f64 <= (share * pairs as f64).max(1.0);
        let wanted = if within(self.last) {
            self.tight.min(residual)
        } else if within(self.settled) {
            self.tight
        } else {
            self.loose
        };
        wanted.max(self.enough * aim / residual).min(self.loose)
    }
}

#[cfg(test)]
mod tests {
    use super::Tolerance;

    #[test]
    fn systems_are_solved_better_as_the_pairs_settle() {
        let tolerance =
            Tolerance { loose: 0.5, tight: 0.05, settled: 0.1, last: 0.02, enough: 0.3 };
        let of = |changed: usize, residual: f64| tolerance.of(changed, 100, residual, 1e-6);
        assert_eq!([of(11, 1e-3), of(10, 1e-3), of(2, 1e-3), of(2, 1.0)], [0.5, 0.05, 1e-3, 0.05]);
        // Near the aim a part of what is left is enough, and never less than loose.
        assert_eq!([of(2, 2e-6), of(2, 1e-7)], [0.3 * 1e-6 / 2e-6, 0.5]);
    }
}
