//! What closed forms expect of a contact that rolls: when all of it slips, its force, its wear.

use std::fmt;

use super::Parts;
use super::contact::{Contact, coefficient};
use super::words::{length, three};
use crate::closed_form::kalker::Coefficients;
use crate::closed_form::{carter, free_rolling, strip, twin_discs, vermeulen_johnson};
use crate::motion::{Control, Drive, Rolling};

/// Dundurs' constant below which bodies count as alike.
pub(super) const ALIKE: f64 = 0.01;

/// What closed forms expect of rolling at the creepages and the spin given, in full.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Creep {
    /// Whether the bodies touch along a line across the direction of rolling.
    pub line: bool,
    /// Creepage at which all slips, mu a/R along the direction of rolling.
    pub saturation: Option<f64>,
    /// Share of the contact that sticks: by strip theory, or by Carter's where the bodies touch along a
    /// line; without lateral creepage and spin.
    pub stick_share: Option<f64>,
    /// Force on body 1 along the direction of rolling and across (N) if all sticks, after Kalker; of
    /// bodies alike.
    pub linear_force: Option<[f64; 2]>,
    /// The same force (N) with slip, without spin: after Vermeulen and Johnson, or Carter's where the
    /// bodies touch along a line.
    pub force: Option<[f64; 2]>,
    /// Creepage of unlike cylinders that roll without force, under little friction.
    pub free_creepage: Option<f64>,
    /// The worn track at the end.
    pub track: Option<Track>,
}

/// What models of slipping twin discs expect at the end of the motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Track {
    /// Total wear depth (m) by the incremental model.
    pub depth: f64,
    /// Total wear depth (m) by the uniform line load alone.
    pub line_load_depth: f64,
    /// Half of its extent across the direction of rolling (m), by axis; none along it.
    pub semi_axes: [f64; 2],
}

/// A rolling contact after Hertz.
struct Rolled<'a> {
    parts: &'a Parts<'a>,
    contact: &'a Contact,
    rolling: Rolling,
    /// Semi-axes and combined curvatures (m, 1/m) along the direction of rolling and across.
    semi_axes: [f64; 2],
    curvatures: [f64; 2],
    /// Creepages along and across, where both are given.
    creepages: Option<[f64; 2]>,
    /// Coefficient of friction.
    friction: f64,
    /// Dundurs' constant.
    beta: f64,
}

impl Creep {
    /// What to expect of the parts; `None` unless they roll.
    pub(super) fn of(parts: &Parts<'_>, contact: &Contact) -> Option<Self> {
        let rolled = Rolled::of(parts, contact)?;
        Some(Self {
            line: rolled.is_line(),
            saturation: rolled.saturation(),
            stick_share: rolled.stick_share(),
            linear_force: rolled.linear_force(),
            force: rolled.force(),
            free_creepage: rolled.free_creepage(),
            track: rolled.track(),
        })
    }
}

impl<'a> Rolled<'a> {
    fn of(parts: &'a Parts<'a>, contact: &'a Contact) -> Option<Self> {
        let rolling = parts.motion.rolling()?.at(parts.schedule.extent);
        let axis = rolling.direction.axis;
        let by_direction = |both: [f64; 2]| [both[axis], both[1 - axis]];
        let creepages = match [rolling.longitudinal, rolling.lateral] {
            [Drive::Creepage(along), Drive::Creepage(across)] => Some([along, across]),
            _ => None,
        };
        Some(Self {
            parts,
            contact,
            rolling,
            semi_axes: by_direction(contact.semi_axes),
            curvatures: by_direction(parts.curvatures()?),
            creepages,
            friction: parts.friction_coefficient(contact.peak_pressure),
            beta: parts.dundurs_beta(),
        })
    }

    /// Whether the bodies touch along a line across the direction of rolling.
    fn is_line(&self) -> bool {
        self.semi_axes[1].is_infinite()
    }

    fn saturation(&self) -> Option<f64> {
        let ([half_width, _], [curvature, _]) = (self.semi_axes, self.curvatures);
        (self.friction > 0.0 && half_width.is_finite() && curvature > 0.0)
            .then(|| carter::saturation_creepage(self.friction, half_width, 1.0 / curvature))
    }

    /// The longitudinal creepage relative to saturation, where nothing else makes slip.
    fn relative_creepage(&self) -> Option<f64> {
        let [along, across] = self.creepages?;
        let alone = across == 0.0 && self.rolling.spin == 0.0 && self.beta.abs() < ALIKE;
        self.saturation().filter(|_| alone).map(|saturation| along / saturation)
    }

    fn stick_share(&self) -> Option<f64> {
        let creepage = self.relative_creepage()?;
        let line = 1.0 - creepage.abs().min(1.0);
        Some(if self.is_line() { line } else { strip::stick_share(creepage) })
    }

    fn linear_force(&self) -> Option<[f64; 2]> {
        let [a, b] = self.semi_axes;
        let [along, across] = self.creepages.filter(|_| self.beta.abs() < ALIKE)?;
        let (moduli, poissons) = self.parts.elasticity();
        let [softness, contraction] = [[1.0; 2], poissons]
            .map(|factors| 0.5 * (factors[0] / moduli[0] + factors[1] / moduli[1]));
        let coefficients = Coefficients::at(a / b, contraction / softness)?;
        // Kalker's creepages are those of body 1 over body 2 seen from the contact.
        let creepages = [-along, -across];
        Some(coefficients.resultant(1.0 / softness, [a, b], creepages, -self.rolling.spin).force)
    }

    fn force(&self) -> Option<[f64; 2]> {
        let limit = self.friction * self.contact.load;
        if self.is_line() {
            return Some([limit * carter::relative_force(self.relative_creepage()?), 0.0]);
        }
        let linear = self.linear_force()?;
        (limit > 0.0 && self.rolling.spin == 0.0).then(|| vermeulen_johnson::force(linear, limit))
    }

    fn free_creepage(&self) -> Option<f64> {
        let ([half_width, _], [curvature, _]) = (self.semi_axes, self.curvatures);
        (self.beta.abs() > 1e-9 && half_width.is_finite() && curvature > 0.0)
            .then(|| free_rolling::creepage(self.beta, half_width, 1.0 / curvature))
    }

    /// The models take the contact as slipping all over by the creepage.
    fn track(&self) -> Option<Track> {
        let (Control::Load(load), [_, half_width]) = (self.parts.schedule.control, self.semi_axes)
        else {
            return None;
        };
        let [along, across] = self.creepages?;
        let (creepage, crown) = (along.hypot(across), 1.0 / self.curvatures[1]);
        let coefficient = coefficient(self.parts, self.contact.peak_pressure);
        let revolutions = self.parts.schedule.extent;
        let wears = coefficient * creepage * revolutions > 0.0 && !self.rolling.swept;
        if !wears || self.is_line() || self.rolling.spin != 0.0 {
            return None;
        }
        let depth = twin_discs::depth_of_incremental_model(
            coefficient,
            creepage,
            load,
            crown,
            half_width,
            revolutions,
        );
        let mut semi_axes = [0.0; 2];
        semi_axes[1 - self.rolling.direction.axis] = (2.0 * crown * depth).sqrt();
        let line_load_depth =
            twin_discs::depth_of_line_load(coefficient, creepage, load, crown, revolutions);
        Some(Track { depth, line_load_depth, semi_axes })
    }
}

impl fmt::Display for Creep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(saturation) = self.saturation {
            writeln!(f, "saturation        creepage {} (all slips, mu a/R)", three(saturation))?;
        }
        if let Some(share) = self.stick_share {
            let law = if self.line { "Carter" } else { "strip theory" };
            writeln!(f, "stick share       {} ({law})", three(share))?;
        }
        if let Some(force) = self.linear_force {
            writeln!(f, "linear force      {} (Kalker)", forces(force))?;
        }
        if let Some(force) = self.force {
            let law = if self.line { "Carter" } else { "Vermeulen-Johnson" };
            writeln!(f, "creep force       {} ({law})", forces(force))?;
        }
        if let Some(creepage) = self.free_creepage {
            writeln!(f, "free rolling      creepage {} (cylinders, mu to 0)", three(creepage))?;
        }
        Ok(())
    }
}

impl fmt::Display for Track {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [depth, line_load] = [self.depth, self.line_load_depth].map(length);
        writeln!(f, "wear depth        {depth} at the end (incremental model)")?;
        writeln!(f, "                  {line_load} at the end (uniform line load)")?;
        let width = 2.0 * self.semi_axes[0].max(self.semi_axes[1]);
        writeln!(f, "worn track        {} wide at the end", length(width))
    }
}

/// Forces (N) along the direction of rolling and across, in words.
fn forces([along, across]: [f64; 2]) -> String {
    match across {
        0.0 => format!("{} N along", three(along)),
        _ => format!("{} N along, {} N across", three(along), three(across)),
    }
}
