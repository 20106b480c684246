//! Where bodies of a known hardness yield first under Hertz's pressure, without friction.

use std::fmt;

use super::Parts;
use super::words::{length, pressure};
use archard::closed_form::first_yield::FirstYield;
use archard::numerics::SAME;
use archard::stress::TABOR;

/// The first yield of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct Yielding {
    /// The body's name.
    pub body: String,
    /// The peak pressure (Pa) at which it yields first.
    pub peak_pressure: f64,
    /// How deep that is (m).
    pub depth: f64,
}

impl Yielding {
    /// Of the bodies under a circular contact or a line of contact, as far as hardness is known; layers have stresses of their own.
    pub(super) fn of(parts: &Parts<'_>) -> Vec<Self> {
        let contact = parts.subject().contact(parts.schedule.control);
        let Some([x, y]) = contact.map(|contact| contact.semi_axes) else { return vec![] };
        let [least, most] = [x.min(y), x.max(y)];
        let under = match () {
            () if most.is_infinite() => FirstYield::under_line,
            () if most - least <= SAME * most => FirstYield::under_circle,
            () => return vec![],
        };
        let of = |body: &archard::body::Body| {
            let (material, hardness) = (body.material?, body.indentation_hardness?);
            let first = under(material.poisson);
            let (peak_pressure, depth) = (first.pressure * hardness / TABOR, first.depth * least);
            let bare = body.layers.is_empty();
            bare.then(|| Self { body: body.name.clone(), peak_pressure, depth })
        };
        parts.bodies.iter().filter_map(of).collect()
    }
}

impl fmt::Display for Yielding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { body, peak_pressure, depth } = self;
        let (peak, depth) = (pressure(*peak_pressure), length(*depth));
        writeln!(f, "first yield       `{body}` from a peak pressure of {peak} on, {depth} deep")
    }
}
