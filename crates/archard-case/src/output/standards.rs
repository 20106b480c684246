//! Worn volumes as test standards compute them from a scar or a track, next to the volumes that were worn.

use serde_json::{Value, json};

use archard::body::Body;
use archard::closed_form::standards::{ball_scar, block_scar, disc_track};
use archard::motion::Track;
use archard::numerics::SAME;
use archard::problem::ContactProblem;
use archard::simulation::history::{SCAR, TRACK_WIDTH, WORN_VOLUME, number, of_body};

/// The volume of one body after a standard, which takes that body alone to wear and both to be rigid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Standard {
    /// What it is called: "ASTM G99".
    pub name: &'static str,
    /// The body: 0 for body 1, 1 for body 2.
    pub body: usize,
    /// What is measured: "scar" or "track".
    pub measured: &'static str,
    /// The diameter or width that is measured (m).
    pub width: f64,
    /// The volume that follows from it (m^3).
    pub volume: f64,
    /// The volume that was worn (m^3).
    pub worn: f64,
}

impl Standard {
    /// Those of a problem at a row of its history: of a ball on a flat that passes, and of the track of a flat that turns
    /// (G99, G133); in plane strain of a flat block on a ring (G77).
    pub fn of(problem: &ContactProblem, row: &[(String, f64)]) -> Vec<Self> {
        let Some(track) = problem.motion.track() else { return vec![] };
        let shape = |body: usize| problem.bodies[body].curvatures();
        let Some((stays, passes)) = shape(1 - track.body).zip(shape(track.body)) else {
            return vec![];
        };
        let test = Test { problem, row, track };
        let axis = problem.motion.direction.axis;
        let ball = stays[0] > 0.0 && (stays[0] - stays[1]).abs() <= SAME * stays[0];
        let ring = passes[axis] > 0.0 && passes[1 - axis] == 0.0;
        let found = match (ball, passes == [0.0; 2], stays == [0.0; 2]) {
            (true, true, _) => {
                [test.scar_of_a_ball(stays[0].recip()), test.groove(stays[0].recip())]
            }
            (_, _, true) if ring && problem.frame.is_line() => {
                let length = problem.frame.size()[1 - axis];
                [test.scar_of_a_block(2.0 / passes[axis], length), None]
            }
            _ => [None; 2],
        };
        found.into_iter().flatten().collect()
    }

    /// By how much it differs from the volume that was worn, relative to that.
    pub fn difference(&self) -> f64 {
        self.volume / self.worn - 1.0
    }

    /// The block of a summary.
    pub(super) fn json(&self) -> Value {
        json!({
            "name": self.name,
            "measured": self.measured,
            "width_m": self.width,
            "volume_m3": self.volume,
            "relative_difference": self.difference(),
        })
    }
}

/// A test on a track at a row of its history.
struct Test<'a> {
    problem: &'a ContactProblem,
    row: &'a [(String, f64)],
    track: Track,
}

impl Test<'_> {
    /// A ball that stays, of that radius (m): its scar taken for a flat, of the mean of length and width.
    fn scar_of_a_ball(&self, radius: f64) -> Option<Standard> {
        let width = 0.5 * (number(self.row, SCAR[0])? + number(self.row, SCAR[1])?);
        let name = if self.track.strokes { "ASTM G133" } else { "ASTM G99" };
        self.standard(name, 1 - self.track.body, ("scar", width), ball_scar(radius, width)?)
    }

    /// The track of a flat that turns under a ball of that radius (m). G133 has the volume of a flat under strokes as
    /// section times stroke, which is how it is integrated.
    fn groove(&self, radius: f64) -> Option<Standard> {
        let width = number(self.row, TRACK_WIDTH)?;
        let around = self.track.length / std::f64::consts::TAU;
        let volume = disc_track(around, radius, width).filter(|_| !self.track.strokes)?;
        self.standard("ASTM G99", self.track.body, ("track", width), volume)
    }

    /// A block of that length (m) that stays on a ring of that diameter (m).
    fn scar_of_a_block(&self, diameter: f64, length: f64) -> Option<Standard> {
        let width = number(self.row, SCAR[0])?;
        let volume = block_scar(diameter, width, length)?;
        self.standard("ASTM G77", 1 - self.track.body, ("scar", width), volume)
    }

    /// A standard of a body that has worn; what is measured and how wide (m) it is.
    fn standard(
        &self,
        name: &'static str,
        body: usize,
        (measured, width): (&'static str, f64),
        volume: f64,
    ) -> Option<Standard> {
        let Body { name: called, .. } = &self.problem.bodies[body];
        let worn = number(self.row, &of_body(WORN_VOLUME, called)).filter(|worn| *worn > 0.0)?;
        Some(Standard { name, body, measured, width, volume, worn })
    }
}
