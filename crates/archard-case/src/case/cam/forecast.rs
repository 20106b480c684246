//! What a cam and its follower go through in a turn, before any wear.

use std::fmt::{self, Display, Formatter};

use archard_gear::cam::{Cam, Station};

/// Rows of a turn, however many angles are looked at: 15 degrees apart.
const ROWS: usize = 24;

/// What a cam and its follower go through in a turn, before any wear.
#[non_exhaustive]
#[derive(Debug, Clone, Default)]
pub struct CamForecast {
    /// The names of cam and follower.
    pub names: [String; 2],
    /// The cam on its follower; `None` where values do not fit together.
    pub cam: Option<Cam>,
}

impl CamForecast {
    /// The stations to show, some of a turn.
    pub fn stations(&self) -> Vec<Station> {
        let stations = self.cam.as_ref().map(Cam::stations).unwrap_or_default();
        let every = (stations.len() / ROWS).max(1);
        stations.into_iter().step_by(every).collect()
    }

    /// The least and the largest of what stations have.
    pub fn range(&self, of: impl Fn(&Station) -> f64) -> [f64; 2] {
        let stations = self.cam.as_ref().map(Cam::stations).unwrap_or_default();
        let all = || stations.iter().map(&of);
        [all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max)]
    }
}

impl Display for CamForecast {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Some(cam) = &self.cam else { return Ok(()) };
        let mut line = |name: &str, unit: &str, factor: f64, [least, most]: [f64; 2]| {
            // Not "-0.0000", which rounding is.
            let [least, most] =
                [least, most].map(|value| (1e4 * factor * value).round() / 1e4 + 0.0);
            writeln!(f, "{name:<17} {least:.4} to {most:.4} {unit}")
        };
        let lift = self.range(|station| station.touch.lift);
        line("lift", "mm", 1e3, lift)?;
        let radius = |station: &Station| cam.radii(station)[0];
        if matches!(cam.follower, archard_gear::cam::Follower::Flat) {
            line("cam", "mm, radius of curvature", 1e3, self.range(radius))?;
        }
        let place = self.range(|station| station.touch.place);
        line("contact", "mm along the follower", 1e3, place)?;
        line("load", "N/mm", 1e-3, self.range(|station| station.load))?;
        line("peak pressure", "MPa", 1e-6, self.range(|station| station.peak_pressure))?;
        writeln!(f)?;
        let [one, two] = &self.names;
        writeln!(
            f,
            " angle_deg  lift_mm  load_N_mm   p0_MPa  half_width_mm  follower_mm  slid_mm_{one}  speed_mm_{two}"
        )?;
        for station in self.stations() {
            let Station { angle, touch, load, half_width, peak_pressure } = station;
            writeln!(
                f,
                "{:10.2} {:8.4} {:10.4} {:8.1} {:14.5} {:12.4} {:>a$.5} {:>b$.4}",
                angle.to_degrees(),
                1e3 * touch.lift,
                1e-3 * load,
                1e-6 * peak_pressure,
                1e3 * half_width,
                1e3 * touch.place,
                1e3 * 2.0 * half_width * touch.sliding / touch.speeds[0],
                1e3 * touch.speeds[1],
                a = one.len() + 9,
                b = two.len() + 10,
            )?;
        }
        writeln!(f, "\nspeed_mm is that of the contact over the follower a radian of the cam")
    }
}
