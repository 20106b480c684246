//! What to expect of a run, and what it costs.

use std::f64::consts::FRAC_PI_4;
use std::fmt;

use super::Parts;
use super::contact::{Contact, Worn};
use super::creep::Creep;
use super::cycles::Cycles;
use super::finite::Finiteness;
use super::foreseen;
use super::partial_slip::{Fretting, stick_ratio};
use super::words::{length, pressure, three};
use crate::compliance::bem;
use crate::kinematics::{Shift, Stepping};
use crate::solve::joint::factors_memory;
use crate::verdict::Verdict;

// Measured as the peak resident memory of whole runs, `/usr/bin/time -f %M archard run` with two threads, per pair
// and beyond that of the program, with N elements squared:
// - `pin_on_disc`, steps of 20 mm: 209 bytes (N = 256), 205 (512), 213 (1024) and 198 (2048); with a tolerance 372,
//   382 and 382 (256, 512, 1024);
// - `hertz`: 474, 477, 475 and 481 (256, 512, 768, 1024), but 388 (2048); in 3, 10 and 40 increments 516 (256), 687
//   (256) and 1337 (128);
// - `fretting_sphere`, one cycle of 8 and of 20 increments: 1330 and 2119 (256), of 20 increments 2130 (128);
// - `twin_disc` without revolutions 374 and 422 (256, 512), in a frame of 2 mm by 6.4 mm 278 (256); with wear in
//   steps of 50 revolutions 488 and 532 (256, 512), with a tolerance 789 (256);
// - unlike bodies: `spence` in 8, 16 and 40 increments 2200, 3207 and 5932 (128), `free_rolling_unlike` 1463 (256).

/// Memory a run takes for each pair (bytes): padded spectra, the fields of solver and state, and an output.
pub(crate) const BYTES_A_PAIR: f64 = 210.0;
/// Memory for each pair beyond that (bytes) where two histories are kept to choose steps by error.
const BYTES_A_PAIR_OF_HISTORIES: f64 = 170.0;
/// The same of histories that keep tractions and slip as well.
const BYTES_A_PAIR_OF_ROLLING_HISTORIES: f64 = 275.0;
/// Memory for each pair in contact that rolls with friction (bytes): the vectors of Krylov iterations.
const BYTES_A_PAIR_OF_FRICTION: f64 = 1150.0;
/// Memory for each pair of bodies that wear as they roll (bytes).
const BYTES_A_PAIR_OF_PLANES: f64 = 110.0;
/// Memory for each pair of unlike bodies that roll (bytes): kernels and fields of three components.
const BYTES_A_PAIR_OF_COUPLING: f64 = 400.0;
/// The same of bodies that go through increments, where the other fields are among the states.
const BYTES_A_PAIR_OF_CROSSED_KERNELS: f64 = 180.0;
/// Memory for each pair of bodies that go through increments (bytes): the states before the first, before and after
/// the present one, at the peak of the cycle, and on their way to the observers.
const BYTES_A_PAIR_OF_STATES: f64 = 155.0;
/// What these states leave behind (bytes a pair) as they are made and dropped, where a field is a block that the
/// allocator keeps: glibc gives blocks of 32 MiB and more back to the system (mallopt(3), `M_MMAP_THRESHOLD`).
const BYTES_A_PAIR_OF_HOLES: f64 = 85.0;
/// The size (bytes) of these blocks.
const GIVEN_BACK: f64 = 32.0 * 1048576.0;
/// Memory for each pair and increment of a cycle (bytes): a solution to start the next cycle from.
const BYTES_A_PAIR_OF_AN_INCREMENT: f64 = 24.0;
/// Memory for each pair and increment beyond that (bytes) where friction or wear keep tractions, slip and depths.
const BYTES_A_PAIR_OF_RUBBING: f64 = 42.0;
/// Memory for each pair and increment of unlike bodies beyond that (bytes): tractions and displacements.
const BYTES_A_PAIR_OF_BOTH: f64 = 48.0;
/// Memory of the program before any pair (bytes).
const BYTES_OF_THE_PROGRAM: f64 = 12e6;

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
    /// What of it the solver of the pressures takes for matrices (bytes).
    pub of_solver: f64,
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
            of_solver: of_solver(parts, contact.as_ref()),
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

/// Memory (bytes) of a run.
pub(super) fn memory(parts: &Parts<'_>, contact: Option<&Contact>) -> f64 {
    let by_error = matches!(parts.motion.stepping, Stepping::Tolerance(_))
        && parts.motion.kinematics.shift().is_none();
    let histories = if by_error { BYTES_A_PAIR_OF_HISTORIES } else { 0.0 };
    let pairs = parts.pairs() as f64;
    let meshed = bem::memory(parts.meshes.each_ref().map(|made| Some(made.as_ref()?.size)));
    let friction = match parts.motion.kinematics.rolling() {
        Some(rolling) if parts.friction.is_some() => {
            let goes_on = !rolling.swept && parts.motion.extent > 0.0;
            let wears = goes_on && parts.wear.iter().any(Option::is_some);
            let wear = if wears { BYTES_A_PAIR_OF_PLANES } else { 0.0 };
            // The histories keep tractions and slip as well.
            let both = if by_error { BYTES_A_PAIR_OF_ROLLING_HISTORIES - histories } else { 0.0 };
            let unlike = if parts.dundurs_beta() == 0.0 { 0.0 } else { 1.0 };
            let iterations = share_in_contact(parts, contact) * BYTES_A_PAIR_OF_FRICTION;
            iterations + unlike * BYTES_A_PAIR_OF_COUPLING + wear + both
        }
        _ => match parts.motion.kinematics.shift() {
            Some(shift) => cycle_memory(parts, shift, contact),
            None => 0.0,
        },
    };
    let solver = of_solver(parts, contact) + of_friction(parts, contact);
    BYTES_OF_THE_PROGRAM + meshed + solver + (BYTES_A_PAIR + histories + friction) * pairs
}

/// Memory (bytes) that the solver of friction takes for matrices of meshed bodies, and that of the factors they
/// keep for each increment of a cycle.
fn of_friction(parts: &Parts<'_>, contact: Option<&Contact>) -> f64 {
    match parts.motion.kinematics.shift() {
        Some(shift) if parts.case.is_meshed() && parts.friction.is_some() => {
            let pairs = parts.pairs() as f64;
            let in_contact = share_in_contact(parts, contact) * pairs;
            let solver = parts.case.friction_solver.build();
            let own = solver.map_or(0.0, |solver| solver.memory(pairs));
            own + shift.cycle.len() as f64 * factors_memory(in_contact)
        }
        _ => 0.0,
    }
}

/// Memory (bytes) that the solver of the pressures takes for matrices.
fn of_solver(parts: &Parts<'_>, contact: Option<&Contact>) -> f64 {
    let pairs = parts.pairs() as f64;
    let in_contact = share_in_contact(parts, contact) * pairs;
    parts.case.solver.build().map_or(0.0, |solver| solver.memory(pairs, in_contact))
}

/// Memory for each pair (bytes) of bodies that are pressed and shifted: the solutions of a cycle, which the
/// same increments of the next start from, and the iterations of friction.
fn cycle_memory(parts: &Parts<'_>, shift: &Shift, contact: Option<&Contact>) -> f64 {
    let unlike = if parts.dundurs_beta() == 0.0 { 0.0 } else { 1.0 };
    let friction = if parts.friction.is_some() { 1.0 } else { 0.0 };
    let rubs = parts.friction.is_some() || parts.wear.iter().any(Option::is_some);
    let rubbing = if rubs { BYTES_A_PAIR_OF_RUBBING } else { 0.0 };
    let state = BYTES_A_PAIR_OF_AN_INCREMENT + rubbing;
    let solution = state + friction * unlike * BYTES_A_PAIR_OF_BOTH;
    let kept = match parts.motion.stepping {
        Stepping::Implicit(_) | Stepping::Explicit(_) => solution,
        Stepping::Jumps(_) => solution + state,
        // A jump that is taken back needs the solutions before it.
        Stepping::Tolerance(_) => 2.0 * solution + state,
    };
    let field = parts.pairs() as f64 * size_of::<f64>() as f64;
    let holes = if field < GIVEN_BACK { BYTES_A_PAIR_OF_HOLES } else { 0.0 };
    let iterations = share_in_contact(parts, contact) * BYTES_A_PAIR_OF_FRICTION;
    BYTES_A_PAIR_OF_STATES
        + holes
        + kept * shift.cycle.len() as f64
        + friction * iterations
        + unlike * BYTES_A_PAIR_OF_CROSSED_KERNELS
}

/// Share of the frame that the contact fills; a half where it is not known.
fn share_in_contact(parts: &Parts<'_>, contact: Option<&Contact>) -> f64 {
    let Some(contact) = contact else { return 0.5 };
    let across =
        |axis: usize| (2.0 * contact.semi_axes[axis] / parts.case.frame.size[axis]).min(1.0);
    FRAC_PI_4 * across(0) * across(1)
}

impl Solves {
    /// One for the contact before a motion that starts under load, and one a step.
    fn of(parts: &Parts<'_>) -> Self {
        if let (Some(shift), Some(cycles)) = (parts.motion.kinematics.shift(), Cycles::of(parts)) {
            return cycles.solves(parts, shift);
        }
        let first = u64::from(!parts.motion.ramped);
        let rolling = parts.motion.kinematics.rolling();
        let wears = rolling.is_some_and(|rolling| !rolling.swept)
            && parts.motion.extent > 0.0
            && parts.wear.iter().any(Option::is_some);
        let coupled = rolling.is_some() && parts.friction.is_some() && parts.dundurs_beta() != 0.0;
        match parts.motion.stepping {
            Stepping::Implicit(step) | Stepping::Explicit(step) => {
                let solves = first + (parts.motion.extent / step - 1e-9).ceil() as u64;
                if wears || coupled { Self::AtLeast(solves) } else { Self::Exactly(solves) }
            }
            Stepping::Jumps(_) => Self::AtLeast(first),
            Stepping::Tolerance(tolerance) => {
                let outputs = parts.case.output.places(parts.motion.extent).len();
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
