//! Wear coefficients by pressure and distance, and by the work of friction, next to each other.

use std::fmt;

use super::Parts;
use super::words::three;

/// The wear of a body whose depth is k p s under Coulomb's law, p s mu being the work of friction.
#[derive(Debug, Clone, PartialEq)]
pub struct Equivalent {
    /// The body's name.
    pub body: String,
    /// Archard's coefficient k (1/Pa).
    pub coefficient: f64,
    /// The volume worn off per work of friction, alpha = k / mu (1/Pa).
    pub of_work: f64,
}

impl Equivalent {
    /// Of both bodies, as far as they wear so and friction is Coulomb's.
    pub(super) fn of(parts: &Parts<'_>) -> Vec<Self> {
        let subject = parts.subject();
        let Some(friction) = subject.friction_coefficient().filter(|&mu| mu > 0.0) else {
            return vec![];
        };
        let of = |(index, body): (usize, &archard::body::Body)| {
            let coefficient = subject.wear_coefficient(index)?;
            Some(Self { body: body.name.clone(), coefficient, of_work: coefficient / friction })
        };
        parts.bodies.iter().enumerate().filter_map(of).collect()
    }
}

impl fmt::Display for Equivalent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [coefficient, of_work] = [self.coefficient, self.of_work].map(|k| three(1e9 * k));
        writeln!(
            f,
            "wear coefficient  k = {coefficient} mm^3/(N m), alpha = k / mu = {of_work} mm^3/J of `{}`",
            self.body
        )
    }
}
