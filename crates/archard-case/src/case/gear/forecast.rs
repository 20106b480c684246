//! What two gears go through in a mesh, before any wear.

use std::fmt::{self, Display, Formatter};

use archard_gear::{Mesh, Station};

/// What two gears go through in a mesh, before any wear.
#[non_exhaustive]
#[derive(Debug, Clone, Default)]
pub struct GearForecast {
    /// The names of the gears.
    pub names: [String; 2],
    /// The gears under load; `None` where values do not fit together.
    pub mesh: Option<Mesh>,
}

impl GearForecast {
    /// The stations where pairs of teeth begin and cease to touch, the pitch point, and the middles between, with the letters of those
    /// that have one.
    pub fn stations(&self) -> Vec<(&'static str, Station)> {
        let Some(mesh) = &self.mesh else { return vec![] };
        let pair = &mesh.pair;
        let [joined, left] = [pair.start + pair.pitch, pair.end - pair.pitch];
        let letters = [
            ("A", pair.start),
            ("B", left),
            ("C", pair.pitch_point),
            ("D", joined),
            ("E", pair.end),
        ];
        let stations = mesh.stations();
        let near =
            |station: &Station, place: f64| (station.place - place).abs() < 1e-6 * pair.pitch;
        let ends = |index: usize| {
            let beside = |other: Option<usize>| {
                other
                    .and_then(|other| stations.get(other))
                    .is_none_or(|other| near(other, stations[index].place))
            };
            beside(index.checked_sub(1)) || beside(Some(index + 1))
        };
        let mut told: Vec<(&'static str, Station)> = vec![];
        for (index, station) in stations.iter().enumerate().filter(|(index, _)| ends(*index)) {
            let letter = letters.iter().find(|(_, place)| near(station, *place));
            let letter = letter.map_or("", |(letter, _)| letter);
            // Where the load does not jump, one row stands for both sides.
            let same = |(_, last): &(&str, Station)| {
                near(last, station.place) && (last.load - station.load).abs() < 1e-9 * mesh.load
            };
            if !told.last().is_some_and(same) {
                told.push((letter, stations[index]));
            }
        }
        told
    }
}

impl Display for GearForecast {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Some(mesh) = &self.mesh else { return Ok(()) };
        let pair = &mesh.pair;
        writeln!(f, "contact ratio     {:.4}", pair.contact_ratio())?;
        writeln!(f, "pressure angle    {:.4} deg, working", pair.working_angle.to_degrees())?;
        writeln!(f, "backlash          {:.4} mm on the pitch circles", 1e3 * pair.backlash)?;
        writeln!(
            f,
            "line of action    {:.4} mm from T1 to T2, teeth touch from {:.4} to {:.4} mm",
            1e3 * pair.length,
            1e3 * pair.start,
            1e3 * pair.end
        )?;
        writeln!(f, "load              {:.4} N/mm along it", 1e-3 * mesh.load)?;
        let [one, two] = &self.names;
        writeln!(f)?;
        writeln!(
            f,
            "   path_mm   share  p0_MPa  half_width_mm  slide_roll  slid_mm_{one}  slid_mm_{two}  diameter_mm_{one}  diameter_mm_{two}"
        )?;
        for (letter, station) in self.stations() {
            let [d1, d2] = pair.diameters(station.place);
            let [w1, w2] = [one, two].map(|name| name.len());
            writeln!(
                f,
                "{letter:<2} {:8.4} {:7.4} {:7.1} {:14.5} {:11.4} {:>a$.5} {:>b$.5} {:>c$.4} {:>d$.4}",
                1e3 * station.place,
                station.load / mesh.load,
                1e-6 * station.peak_pressure,
                1e3 * station.half_width,
                station.sliding() / (0.5 * (station.speeds[0] + station.speeds[1])),
                1e3 * station.slide(0),
                1e3 * station.slide(1),
                1e3 * d1,
                1e3 * d2,
                a = w1 + 9,
                b = w2 + 9,
                c = w1 + 13,
                d = w2 + 13,
            )?;
        }
        Ok(())
    }
}
