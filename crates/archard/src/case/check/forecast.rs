//! What to expect of a run, and what it costs.

use std::fmt;

use super::Parts;
use super::contact::{Contact, Worn};
use super::words::{length, pressure, three};
use crate::kinematics::Stepping;

// Peak resident memory of whole runs by `/usr/bin/time -v archard run`, the larger of one and two
// threads, with 256, 512 and 768 elements squared: `hertz` 22, 69 and 148 MB; `pin_on_disc` in steps of
// 20 mm 32, 102 and 236 MB, and with a tolerance 40 MB and 147 MB (256 and 512).

/// Memory a run takes for each pair (bytes): padded spectra and the fields of solver and state.
pub(crate) const BYTES_A_PAIR: f64 = 310.0;
/// Memory for each pair beyond that (bytes) where two histories are kept to choose steps by error.
const BYTES_A_PAIR_OF_HISTORIES: f64 = 230.0;
/// Memory of the program before any pair (bytes).
const BYTES_OF_THE_PROGRAM: f64 = 5e6;

/// What to expect of a run.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Forecast {
    /// The contact before any wear; `None` where there is no closed form.
    pub contact: Option<Contact>,
    /// Elements across that contact along x and y.
    pub cells_across: Option<[f64; 2]>,
    /// The scar at the end; `None` without wear or where there is no closed form.
    pub worn: Option<Worn>,
    /// Contact solves.
    pub solves: Solves,
    /// Number of pairs.
    pub pairs: usize,
    /// Memory (bytes), an estimate.
    pub memory: f64,
}

/// A number of contact solves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Solves {
    /// Known.
    Exactly(u64),
    /// Estimated, where steps are chosen by their error.
    About(u64),
}

impl Default for Solves {
    fn default() -> Self {
        Self::Exactly(0)
    }
}

impl Forecast {
    pub(super) fn of(parts: &Parts<'_>) -> Self {
        let contact = Contact::of(parts);
        let spacing = parts.case.frame.spacing();
        let [nx, ny] = parts.case.frame.elements;
        Self {
            contact,
            cells_across: contact.map(|contact| {
                let cells = |axis: usize| 2.0 * contact.semi_axes[axis] / spacing[axis];
                [cells(0).min(nx as f64), cells(1).min(ny as f64)]
            }),
            worn: contact.and_then(|contact| Worn::of(parts, &contact)),
            solves: Solves::of(parts),
            pairs: nx * ny,
            memory: memory(parts.motion.stepping, nx * ny),
        }
    }

    /// Half of the extent (m) of the contact at the end along x and y: the scar and the elastic
    /// contact, added in squares.
    pub fn reach(&self) -> Option<[f64; 2]> {
        let contact = self.contact?;
        let scar = self.worn.map_or([0.0; 2], |worn| worn.semi_axes);
        Some([0, 1].map(|axis| contact.semi_axes[axis].hypot(scar[axis])))
    }
}

/// Memory (bytes) of a run with that many pairs.
fn memory(stepping: Stepping, pairs: usize) -> f64 {
    let histories = match stepping {
        Stepping::Tolerance(_) => BYTES_A_PAIR_OF_HISTORIES,
        Stepping::Implicit(_) | Stepping::Explicit(_) => 0.0,
    };
    BYTES_OF_THE_PROGRAM + (BYTES_A_PAIR + histories) * pairs as f64
}

impl Solves {
    /// One for the contact before a motion that starts under load, and one a step.
    fn of(parts: &Parts<'_>) -> Self {
        let first = u64::from(!parts.motion.ramped);
        match parts.motion.stepping {
            Stepping::Implicit(step) | Stepping::Explicit(step) => {
                Self::Exactly(first + (parts.motion.extent / step - 1e-9).ceil() as u64)
            }
            Stepping::Tolerance(tolerance) => {
                let outputs = parts.case.output.places(parts.motion.extent).len();
                Self::About(Self::by_error(tolerance, outputs))
            }
        }
    }

    /// Solves with steps chosen by error: three a step, one step between two outputs at least.
    ///
    /// The column `solves` of `pin_on_disc` with its ten outputs ended at 64, 88, 130, 235 and 406 for
    /// tolerances of 1e-2, 3e-3, 1e-3, 3e-4 and 1e-4 (60 x 60 elements: 64, 88, 136, 229 and 376),
    /// which the sum meets within a tenth. A tenth or ten times the distance changed it by up to two
    /// fifths.
    fn by_error(tolerance: f64, outputs: usize) -> u64 {
        let steps_by_error = (28.0 + 3.6 / tolerance.sqrt()).ceil() as u64;
        steps_by_error.max(1 + 3 * outputs as u64)
    }
}

impl fmt::Display for Solves {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Solves::Exactly(solves) => write!(f, "{solves}"),
            Solves::About(solves) => {
                write!(f, "about {solves} (the steps are chosen by their error)")
            }
        }
    }
}

impl fmt::Display for Forecast {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.contact {
            Some(contact) => write_contact(f, contact, self.cells_across)?,
            None => {
                writeln!(f, "contact           no closed form for these profiles and this motion")?
            }
        }
        match &self.worn {
            Some(worn) => {
                writeln!(
                    f,
                    "worn volume       {} mm^3 at the end (k F s)",
                    three(worn.volume * 1e9)
                )?;
                writeln!(
                    f,
                    "wear depth        {} at the end (rigid bodies, eq. 55)",
                    length(worn.depth)
                )?;
                writeln!(f, "scar              {} at the end", axes(worn.semi_axes))?;
            }
            None => writeln!(f, "wear              no closed form, or nothing wears")?,
        }
        writeln!(f, "contact solves    {}", self.solves)?;
        writeln!(f, "elements          {}", self.pairs)?;
        writeln!(f, "memory            about {:.0} MB", (self.memory * 1e-6).max(1.0))
    }
}

fn write_contact(
    f: &mut fmt::Formatter<'_>,
    contact: &Contact,
    cells: Option<[f64; 2]>,
) -> fmt::Result {
    writeln!(f, "Hertz contact     {}", axes(contact.semi_axes))?;
    writeln!(f, "peak pressure     {}", pressure(contact.peak_pressure))?;
    if let Some(approach) = contact.approach {
        writeln!(f, "approach          {}", length(approach))?;
    }
    writeln!(f, "load              {} N", three(contact.load))?;
    match cells {
        Some([x, y]) => writeln!(f, "elements across   {} along x, {} along y", three(x), three(y)),
        None => Ok(()),
    }
}

/// Semi-axes (m) in words.
fn axes([x, y]: [f64; 2]) -> String {
    match (x.is_finite(), y.is_finite()) {
        (true, true) if (x - y).abs() < 1e-9 * x => format!("radius {}", length(x)),
        (true, true) => format!("semi-axes {} along x, {} along y", length(x), length(y)),
        (true, false) => format!("half width {} along x, a line along y", length(x)),
        (false, _) => format!("half width {} along y, a line along x", length(y)),
    }
}

#[cfg(test)]
mod tests {
    use super::Solves;

    /// Three solves for a step between each two outputs and one at the start.
    #[test]
    fn outputs_ask_for_solves() {
        assert_eq!(Solves::by_error(1e-2, 100), 301);
    }
}
