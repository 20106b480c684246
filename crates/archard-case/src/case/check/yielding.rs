//! Where bodies of a known hardness yield first under Hertz's pressure, without friction.

use std::fmt;

use super::Parts;
use super::words::{length, pressure};
use archard::closed_form::first_yield::FirstYield;
use archard::numerics::SAME;
use archard::stress::TABOR;

/// The first yield of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct YieldLimit {
    /// The body's name.
    pub body: String,
    /// The peak pressure (Pa) at which it yields first.
    pub peak_pressure: f64,
    /// How deep that is (m) under that pressure, zero on the surface.
    pub depth: f64,
}

impl YieldLimit {
    /// Of half-spaces under a circular contact or a line of contact, as far as hardness is known; layers have stresses of their own.
    pub(super) fn of(parts: &Parts<'_>) -> Vec<Self> {
        let Some(contact) = parts.subject().contact(parts.schedule.control) else { return vec![] };
        let [x, y] = contact.semi_axes;
        let [least, most] = [x.min(y), x.max(y)];
        let under = match () {
            () if most.is_infinite() => FirstYield::under_line,
            () if most - least <= SAME * most => FirstYield::under_circle,
            () => return vec![],
        };
        let of = |body: &archard::body::Body| {
            let (material, hardness) = (body.material?, body.known_hardness()?);
            let first = under(material.poisson);
            let peak_pressure = first.pressure * hardness / TABOR;
            // Circles and lines of contact grow in proportion to their peak pressure.
            let depth = first.depth * least * peak_pressure / contact.peak_pressure;
            let bare = body.layers.is_empty() && body.finite.is_none();
            bare.then(|| Self { body: body.name.clone(), peak_pressure, depth })
        };
        parts.bodies.iter().filter_map(of).collect()
    }
}

impl fmt::Display for YieldLimit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { body, peak_pressure, depth } = self;
        let peak = pressure(*peak_pressure);
        let place = match *depth {
            0.0 => "on the surface".to_owned(),
            depth => format!("{} deep", length(depth)),
        };
        writeln!(
            f,
            "first yield       `{body}` from a peak pressure of {peak} on, {place}, without friction"
        )
    }
}
