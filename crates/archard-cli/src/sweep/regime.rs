//! What fretting was in the last cycle: sticking, partial slip or gross slip, and the energy ratio of its loop.

use std::path::Path;

use archard::numerics::SAME;
use archard::simulation::history::{CYCLE, FORCE, SHIFT, STICK_AREA};
use archard_case::files;

/// The energy that friction dissipated in a cycle.
const DISSIPATED: &str = "dissipated_J";

/// The columns `energy_ratio` and `regime` of a run with a fretting loop, from the last row of its history.
///
/// The energy ratio is E / (4 Q d), with E the energy dissipated in a cycle, Q the amplitude of the tangential force and d that of
/// the shift: 0 where all sticks, 1 where all slips under a constant force (S. Fouvry, Ph. Kapsa and L. Vincent, *Wear* 185 (1995)
/// 35). Slip is gross where at some time of the cycle no element sticks.
pub fn of(dir: &Path, last: &[(String, String)]) -> Option<[(String, String); 2]> {
    let number = |name: &str| last.iter().find(|(known, _)| known == name)?.1.parse::<f64>().ok();
    let text = files::read_text(&dir.join("fretting_loop.csv")).ok()?;
    let (ratio, regime) = told(&text, number(DISSIPATED)?)?;
    let regime = ("regime".to_owned(), regime.to_owned());
    Some([("energy_ratio".to_owned(), format!("{ratio:?}")), regime])
}

/// The energy ratio and the regime of the last cycle of a loop that dissipates that energy (J).
fn told(text: &str, energy: f64) -> Option<(f64, &'static str)> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let head = reader.headers().ok()?.clone();
    let place = |name: &str| head.iter().position(|known| known == name);
    let columns = [CYCLE, SHIFT[0], SHIFT[1], FORCE[0], FORCE[1], STICK_AREA].map(place);
    let mut rows: Vec<[f64; 6]> = vec![];
    for record in reader.records() {
        let record = record.ok()?;
        let cells = columns.map(|place| record.get(place?)?.parse::<f64>().ok());
        let row: Option<Vec<f64>> = cells.into_iter().collect();
        rows.push(row?.try_into().ok()?);
    }
    let end = rows.last()?[0];
    rows.retain(|row| row[0] >= end - 1.0 - SAME * end);
    let amplitude = |place: usize| {
        let values = || rows.iter().map(|row| row[place]);
        0.5 * (values().fold(f64::MIN, f64::max) - values().fold(f64::MAX, f64::min))
    };
    let [shift, force] = [1, 3].map(|first| amplitude(first).hypot(amplitude(first + 1)));
    let work = 4.0 * force * shift;
    let regime = match () {
        () if rows.iter().any(|row| row[5] == 0.0) => "gross slip",
        () if energy <= SAME * work => "stick",
        () => "partial slip",
    };
    (work > 0.0).then_some((energy / work, regime))
}

#[cfg(test)]
mod tests {
    use super::told;

    /// A contact of stiffness 1e7 N/m that slides at 6 N, shifted by 4 um: E = 4 Q (d - Q / S), so that the ratio is
    /// 1 - Q / (S d); and one that only bends. The cycle before has other numbers.
    #[test]
    fn loops_have_their_ratio_and_regime() {
        let head = "cycle,shift_x_m,shift_y_m,force_x_N,force_y_N,load_N,stick_area_m2\n";
        let text = |force: f64, stick: f64| {
            let row = |(cycle, shift, force): (f64, f64, f64)| {
                format!("{cycle},{shift},0,{force},0,10,{stick}\n")
            };
            let before = [(0.0, 0.0, 0.0), (0.5, 9e-6, 99.0)];
            let last =
                [(1.0, 0.0, 0.0), (1.25, 4e-6, force), (1.75, -4e-6, -force), (2.0, 0.0, 0.0)];
            head.to_owned() + &before.into_iter().chain(last).map(row).collect::<String>()
        };
        let energy = 4.0 * 6.0 * (4e-6 - 6.0 / 1e7);
        let (ratio, regime) = told(&text(6.0, 0.0), energy).unwrap();
        assert!(
            (ratio - (1.0 - 6.0 / (1e7 * 4e-6))).abs() < 1e-12 && regime == "gross slip",
            "{ratio}"
        );
        assert_eq!(told(&text(6.0, 1e-9), energy).unwrap().1, "partial slip");
        assert_eq!(told(&text(40.0, 1e-9), 0.0), Some((0.0, "stick")));
        assert_eq!(told(head, 1.0), None);
    }
}
