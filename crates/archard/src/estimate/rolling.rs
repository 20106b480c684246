//! Bodies that roll: when all of the contact slips, its force, its wear.

use super::{ALIKE, Contact, Course, Subject};
use crate::body::Material;
use crate::closed_form::kalker::Coefficients;
use crate::closed_form::twin_discs::TwinDiscs;
use crate::closed_form::{carter, free_rolling, strip, vermeulen_johnson};
use crate::motion::{Control, Drive, Drives, Sequence};

/// What closed forms expect of rolling at the creepages and the spin given.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingEstimate {
    /// Whether the bodies touch along a line across the direction of rolling.
    pub line: bool,
    /// When all slips.
    pub saturation: Option<Saturation>,
    /// Longitudinal creepage over the one at which all slips, without lateral creepage and spin; of bodies of one kind.
    pub relative_creepage: Option<f64>,
    /// Share of the contact that sticks at that creepage: by strip theory, or by Carter's where the bodies touch along a
    /// line.
    pub stick_share: Option<f64>,
    /// Force on body 1 along the direction of rolling and across (N) if all sticks, after Kalker; of
    /// bodies of one kind.
    pub linear_force: Option<[f64; 2]>,
    /// The same force (N) with slip, without spin: after Vermeulen and Johnson, or Carter's where the
    /// bodies touch along a line.
    pub force: Option<[f64; 2]>,
    /// Creepage of unlike cylinders that roll without force, under little friction.
    pub free_creepage: Option<f64>,
    /// The worn track.
    pub track: Option<Track>,
}

/// Carter's cylinders: the bodies themselves, or those of the middle strip of an ellipse.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Saturation {
    /// mu.
    pub friction: f64,
    /// Half width of the contact along the direction of rolling (m).
    pub half_width: f64,
    /// Combined radius along it (m).
    pub radius: f64,
    /// Creepage at which all slips, mu a / R.
    pub creepage: f64,
}

/// What models of twin discs that slip all over expect.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Track {
    /// The discs.
    pub discs: TwinDiscs,
    /// Normal force (N).
    pub load: f64,
    /// Revolutions so far.
    pub revolutions: f64,
    /// Total wear depth (m) by the incremental model.
    pub depth: f64,
    /// Total wear depth (m) by the uniform line load alone.
    pub line_load_depth: f64,
    /// Half of its extent across the direction of rolling (m), by axis; none along it.
    pub semi_axes: [f64; 2],
}

/// A rolling contact after Hertz.
struct Contacted<'a> {
    subject: &'a Subject<'a>,
    drives: Drives,
    /// Normal force (N).
    load: f64,
    /// Semi-axes and combined curvatures (m, 1/m) along the direction of rolling and across.
    semi_axes: [f64; 2],
    curvatures: [f64; 2],
    /// Creepages along and across, where both are given.
    creepages: Option<[f64; 2]>,
    /// Coefficient of friction; zero without.
    friction: f64,
    /// Dundurs' constant.
    beta: f64,
}

impl RollingEstimate {
    /// What to expect of a contact; `None` unless it rolls.
    pub(super) fn of(subject: &Subject<'_>, course: &Course, contact: Contact) -> Option<Self> {
        let drives = subject.motion.driven(course.progress)?;
        let axis = subject.motion.direction.axis;
        let by_direction = |both: [f64; 2]| [both[axis], both[1 - axis]];
        let creepages = match drives.both() {
            [Drive::Slip(along), Drive::Slip(across)] => Some([along, across]),
            _ => None,
        };
        let contacted = Contacted {
            subject,
            drives,
            load: contact.load,
            semi_axes: by_direction(contact.semi_axes),
            curvatures: by_direction(subject.curvatures()?),
            creepages,
            friction: subject.friction_coefficient().unwrap_or(0.0),
            beta: subject.dundurs_beta(),
        };
        Some(contacted.estimate(course))
    }
}

impl Contacted<'_> {
    fn estimate(&self, course: &Course) -> RollingEstimate {
        let (line, saturation) = (self.is_line(), self.saturation());
        let relative_creepage = self.relative_creepage(saturation);
        let stick_share = relative_creepage.map(|creepage| match line {
            true => 1.0 - creepage.abs().min(1.0),
            false => strip::stick_share(creepage),
        });
        let linear_force = self.linear_force();
        let limit = self.friction * self.load;
        let force = match line {
            true => relative_creepage.map(|one| [limit * carter::relative_force(one), 0.0]),
            false => linear_force
                .filter(|_| limit > 0.0 && self.drives.is_even())
                .map(|linear| vermeulen_johnson::force(linear, limit)),
        };
        let (free_creepage, track) = (self.free_creepage(), self.track(course));
        RollingEstimate {
            line,
            saturation,
            relative_creepage,
            stick_share,
            linear_force,
            force,
            free_creepage,
            track,
        }
    }

    /// Whether the bodies roll as those of one elasticity: beta a / R is little against the creepages given.
    ///
    /// That much unlike surfaces are stretched under the pressures of Hertz, which works as another creepage: in
    /// `carter` 0.58 times as much took off the force where most sticks, and 0.28 times between spheres.
    fn alike(&self) -> bool {
        let half_width = self.semi_axes[0];
        let given = self.creepages.map_or(0.0, |[along, across]| along.hypot(across))
            + half_width * self.drives.spin.abs();
        self.beta.abs() * half_width * self.curvatures[0] <= ALIKE * given
    }

    /// Whether the bodies touch along a line across the direction of rolling.
    fn is_line(&self) -> bool {
        self.semi_axes[1].is_infinite()
    }

    fn saturation(&self) -> Option<Saturation> {
        let ([half_width, _], [curvature, _], friction) =
            (self.semi_axes, self.curvatures, self.friction);
        (friction > 0.0 && half_width.is_finite() && curvature > 0.0).then(|| {
            let radius = 1.0 / curvature;
            let creepage = carter::saturation_creepage(friction, half_width, radius);
            Saturation { friction, half_width, radius, creepage }
        })
    }

    /// The longitudinal creepage relative to saturation, where nothing else makes slip.
    fn relative_creepage(&self, saturation: Option<Saturation>) -> Option<f64> {
        let [along, across] = self.creepages?;
        let alone = across == 0.0 && self.drives.is_even() && self.alike();
        saturation.filter(|_| alone).map(|saturation| along / saturation.creepage)
    }

    fn linear_force(&self) -> Option<[f64; 2]> {
        let [a, b] = self.semi_axes;
        let [along, across] = self.creepages.filter(|_| self.alike())?;
        // Means of 1/G and of nu/G, to which a rigid body adds nothing.
        let mean = |factor: fn(&Material) -> f64| {
            let materials = self.subject.materials().into_iter().flatten();
            0.5 * materials.map(|one| factor(one) / one.shear_modulus()).sum::<f64>()
        };
        let (softness, contraction) = (mean(|_| 1.0), mean(|one| one.poisson));
        let coefficients = Coefficients::at(a / b, contraction / softness)?;
        // Kalker's creepages are those of body 1 over body 2 seen from the contact.
        let creepages = [-along, -across];
        Some(coefficients.resultant(1.0 / softness, [a, b], creepages, -self.drives.spin).force)
    }

    /// Bentall's and Johnson's cylinders. Spheres creep 0.58 times as much: their surfaces are stretched across as well.
    fn free_creepage(&self) -> Option<f64> {
        let ([half_width, _], [curvature, _]) = (self.semi_axes, self.curvatures);
        (self.is_line() && self.beta.abs() > 1e-9)
            .then(|| free_rolling::creepage(self.beta, half_width, 1.0 / curvature))
    }

    /// The models take the contact as slipping all over by the creepage, under the same load all the time: at a given
    /// approach the load falls as the bodies wear.
    fn track(&self, course: &Course) -> Option<Track> {
        let Control::Load(load) = course.control else { return None };
        let (creepage, revolutions) = (self.creepages.map(|[x, y]| x.hypot(y))?, course.progress);
        let coefficient = self.subject.total_wear_coefficient()?;
        let wears =
            creepage * revolutions > 0.0 && self.subject.motion.sequence == Sequence::Steady;
        if !wears || !self.drives.is_even() || self.is_line() {
            return None;
        }
        let (crown, half_width) = (1.0 / self.curvatures[1], self.semi_axes[1]);
        let discs = TwinDiscs { coefficient, creepage, crown, half_width };
        let depth = discs.incremental_depth(load * revolutions);
        let line_load_depth = discs.line_load_depth(load * revolutions);
        let mut semi_axes = [0.0; 2];
        semi_axes[1 - self.subject.motion.direction.axis] = discs.track(depth);
        Some(Track { discs, load, revolutions, depth, line_load_depth, semi_axes })
    }
}
