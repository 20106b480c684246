//! What to expect of a run, and what it costs.

use std::fmt;

use super::Parts;
use super::contact::{Contact, Worn};
use super::creep::Creep;
use super::cycles::Cycles;
use super::finite::Finiteness;
use super::footprint::memory;
use super::foreseen;
use super::partial_slip::{Fretting, stick_ratio};
use super::words::{length, pressure, three};
use crate::motion::Stepping;
use crate::verdict::Verdict;

/// What to expect of a run.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Forecast {
    /// The contact before any wear; `None` where there is no closed form.
    pub contact: Option<Contact>,
    /// Elements across that contact along x and y.
    pub cells_across: Option<[f64; 2]>,
    /// The scar at the end; `None` without wear or where there is no closed form.
    pub worn: Option<Worn>,
    /// What closed forms expect of rolling; `None` where nothing rolls or where there are none.
    pub creep: Option<Creep>,
    /// What closed forms expect of a sphere shifted to and fro; `None` where there are none.
    pub fretting: Option<Fretting>,
    /// Share of the contact radius that sticks under a sphere pressed on a body of other elasticity;
    /// `None` where there is no closed form.
    pub stick_ratio: Option<f64>,
    /// Cycles; `None` where the bodies are not pressed and shifted step by step.
    pub cycles: Option<Cycles>,
    /// Contact solves.
    pub solves: Solves,
    /// Number of pairs.
    pub pairs: usize,
    /// Meshed bodies that are computed by boundary elements, with their numbers of unknowns.
    pub unknowns: Vec<(String, usize)>,
    /// What meshed bodies may differ by from half-spaces; empty where no closed form tells.
    pub finiteness: Vec<Finiteness>,
    /// Memory (bytes), an estimate.
    pub memory: f64,
    /// What of the verdict on a run can be foreseen.
    pub verdict: Verdict,
}

/// A number of contact solves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Solves {
    /// Known.
    Exactly(u64),
    /// Known but for steps that take several: pressures, friction and wear are made to agree.
    AtLeast(u64),
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
        let forecast = Self {
            contact,
            cells_across: contact.map(|contact| {
                let cells = |axis: usize| 2.0 * contact.semi_axes[axis] / spacing[axis];
                [cells(0).min(nx as f64), cells(1).min(ny as f64)]
            }),
            worn: contact.and_then(|contact| Worn::of(parts, &contact)),
            creep: contact.and_then(|contact| Creep::of(parts, &contact)),
            fretting: contact.and_then(|contact| Fretting::of(parts, &contact)),
            stick_ratio: contact.and_then(|contact| stick_ratio(parts, &contact)),
            cycles: Cycles::of(parts),
            solves: Solves::of(parts),
            pairs: parts.pairs(),
            unknowns: unknowns(parts),
            finiteness: Finiteness::of(parts, contact.as_ref()),
            memory: memory(parts, contact.as_ref()),
            verdict: Verdict::default(),
        };
        Self { verdict: foreseen::verdict(parts, &forecast), ..forecast }
    }

    /// Half of the extent (m) of the contact at the end along x and y: the scar and the elastic
    /// contact, added in squares.
    pub fn reach(&self) -> Option<[f64; 2]> {
        let contact = self.contact?;
        let track = self.creep.and_then(|creep| creep.track).map(|track| track.semi_axes);
        let scar = self.worn.map(|worn| worn.semi_axes).or(track).unwrap_or([0.0; 2]);
        Some([0, 1].map(|axis| contact.semi_axes[axis].hypot(scar[axis])))
    }
}

/// Unknowns of the bodies that are computed by boundary elements.
fn unknowns(parts: &Parts<'_>) -> Vec<(String, usize)> {
    let bodies = parts.case.bodies.iter().zip(&parts.meshes);
    let sized = bodies.filter_map(|(body, made)| Some((&body.name, made.as_ref()?.size.unknowns)));
    sized.filter(|(_, count)| *count > 0).map(|(name, count)| (name.clone(), count)).collect()
}

impl Solves {
    /// One for the contact before a motion that starts under load, and one a step.
    fn of(parts: &Parts<'_>) -> Self {
        if let (Some(shift), Some(cycles)) = (parts.motion.shift(), Cycles::of(parts)) {
            return cycles.solves(parts, shift);
        }
        let first = u64::from(!parts.schedule.ramped);
        let rolling = parts.motion.rolling();
        let wears = rolling.is_some_and(|rolling| !rolling.swept)
            && parts.schedule.extent > 0.0
            && parts.wear.iter().any(Option::is_some);
        let coupled = rolling.is_some() && parts.friction.is_some() && parts.dundurs_beta() != 0.0;
        match parts.schedule.stepping {
            Stepping::Implicit(step) | Stepping::Explicit(step) => {
                let solves = first + (parts.schedule.extent / step - 1e-9).ceil() as u64;
                if wears || coupled { Self::AtLeast(solves) } else { Self::Exactly(solves) }
            }
            Stepping::Jumps(_) => Self::AtLeast(first),
            Stepping::Tolerance(tolerance) => {
                let outputs = parts.case.output.places(parts.schedule.extent).len();
                Self::About(match rolling {
                    Some(_) => Self::by_error_in_rolling(tolerance, outputs),
                    None => Self::by_error(tolerance, outputs),
                })
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

    /// The same in rolling, where rates of wear change less.
    ///
    /// The column `solves` of `twin_disc` ended at 49, 54, 75, 100 and 163 for tolerances of 1e-2, 3e-3,
    /// 1e-3, 3e-4 and 1e-4 (ten outputs: 53, 59, 74, 106 and 169; 61 x 121 elements as well: 52, 59, 72,
    /// 106 and 166), which the sum meets within a tenth. Three times the creepage changed it by up to a
    /// fifth, a tenth or ten times the revolutions by up to a third.
    fn by_error_in_rolling(tolerance: f64, outputs: usize) -> u64 {
        let steps_by_error = (36.0 + 1.2 / tolerance.sqrt()).ceil() as u64;
        steps_by_error.max(1 + 3 * outputs as u64)
    }
}

impl fmt::Display for Solves {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Solves::Exactly(solves) => write!(f, "{solves}"),
            Solves::AtLeast(solves) => write!(f, "at least {solves}"),
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
        if let Some(creep) = &self.creep {
            creep.fmt(f)?;
        }
        if let Some(fretting) = &self.fretting {
            fretting.fmt(f)?;
        }
        if let Some(ratio) = self.stick_ratio {
            writeln!(f, "stick zone        {} of the contact radius (Spence)", three(ratio))?;
        }
        self.write_wear(f)?;
        if let Some(cycles) = self.cycles.filter(|cycles| cycles.total > 1) {
            cycles.fmt(f)?;
        }
        writeln!(f, "contact solves    {}", self.solves)?;
        self.write_size(f)?;
        writeln!(f, "memory            about {:.0} MB", (self.memory * 1e-6).max(1.0))
    }
}

impl Forecast {
    fn write_size(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for Finiteness { body, distance, approach, .. } in &self.finiteness {
            let (distance, share) = (length(*distance), three(100.0 * approach));
            writeln!(
                f,
                "half-space        {share} % of the approach where `{body}` ends, {distance} away"
            )?;
        }
        for (body, unknowns) in &self.unknowns {
            writeln!(f, "unknowns          {unknowns} of `{body}`")?;
        }
        let meshed = !(self.unknowns.is_empty() && self.finiteness.is_empty());
        let pairs = if meshed { "pairs   " } else { "elements" };
        writeln!(f, "{pairs}          {}", self.pairs)
    }

    fn write_wear(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let track = self.creep.and_then(|creep| creep.track);
        let fretting = self.fretting.and_then(|fretting| fretting.wear);
        match (&self.worn, track, fretting) {
            (Some(worn), ..) => write!(f, "{worn}"),
            (None, Some(track), _) => write!(f, "{track}"),
            (None, None, Some(wear)) => write!(f, "{wear}"),
            (None, None, None) => writeln!(f, "wear              no closed form, or nothing wears"),
        }
    }
}

impl fmt::Display for Cycles {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.computed {
            Solves::Exactly(cycles) if cycles == self.total => {
                writeln!(f, "cycles            {cycles}")
            }
            Solves::Exactly(cycles) | Solves::AtLeast(cycles) => {
                writeln!(f, "cycles            {cycles} computed of {}", self.total)
            }
            Solves::About(cycles) => {
                writeln!(f, "cycles            about {cycles} computed of {}", self.total)
            }
        }
    }
}

impl fmt::Display for Worn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "worn volume       {} mm^3 at the end (k F s)", three(self.volume * 1e9))?;
        writeln!(f, "wear depth        {} at the end (rigid bodies, eq. 55)", length(self.depth))?;
        writeln!(f, "scar              {} at the end", axes(self.semi_axes))
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
