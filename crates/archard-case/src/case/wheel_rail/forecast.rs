//! What a wheel on its rail gives before any elasticity.

use std::fmt::{self, Display, Formatter};

use archard::parameters::Invalid;
use archard_rail::conicity::{equivalent_conicity, rolling_radius_difference};
use archard_rail::search::{Onset, Search};
use archard_rail::setup::Side;

use super::prepared::PreparedContact;

/// Amplitude (m) of the lateral motion that the equivalent conicity is told for: that of UIC 519 and EN 15302.
pub const AMPLITUDE: f64 = 3e-3;

/// What the set-up gives before any elasticity.
#[non_exhaustive]
#[derive(Debug, Clone, Default)]
pub struct WheelRailForecast {
    /// Roll (rad) of the wheelset.
    pub roll: f64,
    /// Each side with its first touch.
    pub sides: Vec<(Side, Onset)>,
    /// Rolling radius (m) of the right wheel less that of the left one, where both stand on their rails.
    pub radius_difference: Option<f64>,
    /// Equivalent conicity for an amplitude of 3 mm, where the wheelset steers itself back.
    pub conicity: Option<f64>,
    /// Points of the route.
    pub points: usize,
}

impl PreparedContact {
    /// What the set-up gives before any elasticity.
    pub(super) fn forecast(&self) -> Result<WheelRailForecast, Invalid> {
        let states = self.running.states()?;
        if !self.running.route.is_empty() || self.wears() != [false; 2] {
            self.journey()?;
        }
        let mut attitude = states[0].attitude;
        if !states[0].rolls {
            attitude.roll = self.setup.roll(&self.setup, attitude.shift, attitude.yaw)?;
        }
        let touch = |&side: &Side| {
            let onset = Search::first_touch(&self.setup, side.attitude(attitude))?;
            let onset =
                onset.ok_or_else(|| Invalid::new("shift", "the wheel is not over its rail"))?;
            Ok((side, onset))
        };
        let sides = self.running.sides.iter().map(touch).collect::<Result<_, Invalid>>()?;
        let both = [&self.setup; 2];
        let (shift, yaw, roll) = (attitude.shift, attitude.yaw, Some(attitude.roll));
        Ok(WheelRailForecast {
            roll: attitude.roll,
            sides,
            radius_difference: rolling_radius_difference(both, shift, yaw, roll).ok(),
            conicity: equivalent_conicity(both, AMPLITUDE).ok(),
            points: states.len(),
        })
    }
}

impl Display for WheelRailForecast {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if self.points > 1 {
            writeln!(f, "route             {} points; the first touches like this:", self.points)?;
        }
        writeln!(f, "roll              {:.5} mrad", 1e3 * self.roll)?;
        for (side, onset) in &self.sides {
            let [x, y, z] = onset.at.point.to_array().map(|one| 1e3 * one);
            let height = 1e3 * onset.height;
            writeln!(f, "{:<18}touches at a height of {height:.4} mm", side.name())?;
            writeln!(f, "                  x {x:.3} mm, y {y:.3} mm, z {z:.3} mm of the track")?;
        }
        if let Some(difference) = self.radius_difference {
            writeln!(f, "rolling radii     right less left {:.4} mm", 1e3 * difference)?;
        }
        if let Some(conicity) = self.conicity {
            writeln!(f, "conicity          {conicity:.4} at an amplitude of 3 mm")?;
        }
        Ok(())
    }
}
