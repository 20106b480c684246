//! Archard's law with a coefficient from a map over pressure and speed.
//!
//! depth = k p s / H with a dimensionless k that is constant in each region of a map over p / H and the speed of sliding v,
//! as wear maps of wheel and rail have it: T. Jendel, *Wear* 253 (2002) 89. The regions are the fields of a grid, each
//! named by its lowest pressure and speed; the last of a row or column has no end. Over 2 % of each edge k passes smoothly
//! from one region to the next, since an implicit step needs a slope.
//!
//! Limits: k must not fall from a region to the one of higher pressure: more pressure would wear less. No map comes with the
//! program.

use super::{Input, Rubbing, WearLaw};
use crate::parameters::{About, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn WearLaw>> = Choice {
    name: "map",
    meaning: "Archard with a coefficient from a map over p / H and speed: depth = k p s / H; sliding at a known speed",
    parameters: &[
        HARDNESS,
        Parameter::required(
            "file",
            Quantity::Table(&[
                ("pressure", Quantity::Number),
                ("speed", Quantity::Speed),
                ("coefficient", Quantity::Number),
            ]),
            "CSV of regions: lowest `pressure` over hardness, lowest `speed`, `coefficient` k_ad",
        ),
    ],
    build: |values| {
        let columns = values.table("file").unwrap_or_default();
        let column =
            |name: &str| columns.iter().find(|known| known.0 == name).map(|known| &known.1);
        let named = ["pressure", "speed", "coefficient"].map(column);
        let ([Some(pressures), Some(speeds), Some(coefficients)], 3) = (named, columns.len())
        else {
            return Err(wrong("the columns must be `pressure`, `speed` and `coefficient`"));
        };
        let rows = pressures.iter().zip(speeds).zip(coefficients);
        let regions: Vec<[f64; 3]> = rows.map(|((p, v), k)| [*p, *v, *k]).collect();
        Ok(Box::new(Map::new(values.require("hardness")?, &regions)?))
    },
};

pub(super) const ABOUT: About = About::new(
    CHOICE.name,
    "T. Jendel, Wear 253 (2002) 89",
    "{ hardness = \"3 GPa\", file = \"regions.csv\" }",
)
.reading(&[(
    "regions.csv",
    "pressure,speed_m/s,coefficient\n0,0,1e-4\n0.5,0,1e-3\n0,0.2,2e-4\n0.5,0.2,2e-3\n",
)]);

const HARDNESS: Parameter =
    Parameter::required("hardness", Quantity::Pressure, "hardness H of the softer body");

/// Half of the width of an edge, over its place.
const EDGE: f64 = 0.01;

/// depth = k(p / H, v) p s / H.
#[derive(Debug, Clone, PartialEq)]
pub struct Map {
    hardness: f64,
    /// Lowest p / H of the columns, and lowest speeds (m/s) of the rows, of regions.
    edges: [Vec<f64>; 2],
    /// One value a region, the pressure running fastest.
    coefficients: Vec<f64>,
}

/// Where a place lies between regions.
struct Between {
    /// The regions below and above.
    regions: [usize; 2],
    /// The share of the region above, and its derivative.
    share: f64,
    slope: f64,
}

impl Between {
    /// A place among rising edges, the first of them zero.
    fn of(edges: &[f64], place: f64) -> Self {
        let low = |edge: &f64| (1.0 - EDGE) * edge <= place;
        let above = edges.iter().rposition(low).unwrap_or_default();
        let width = 2.0 * EDGE * edges[above];
        let way = if above == 0 { 1.0 } else { (place - (1.0 - EDGE) * edges[above]) / width };
        if way >= 1.0 {
            return Self { regions: [above; 2], share: 1.0, slope: 0.0 };
        }
        let share = way * way * (3.0 - 2.0 * way);
        Self { regions: [above - 1, above], share, slope: 6.0 * way * (1.0 - way) / width }
    }
}

impl Map {
    /// The law with a hardness (Pa) and regions in any order that fill a grid: lowest pressure over hardness, lowest speed
    /// (m/s), dimensionless wear coefficient.
    ///
    /// # Errors
    /// If the hardness is not greater than zero, a number of a region is negative or not finite, the regions begin beyond
    /// zero, fill no grid or lie closer than 2 %, or a coefficient falls with the pressure.
    pub fn new(hardness: f64, regions: &[[f64; 3]]) -> Result<Self, Invalid> {
        let hardness = HARDNESS.admit(hardness)?;
        if let Some(number) = regions.iter().flatten().find(|one| !one.is_finite() || **one < 0.0) {
            return Err(wrong(format!("{number:e} is negative, or no finite number")));
        }
        let edges = [0, 1].map(|axis| distinct(regions.iter().map(|region| region[axis])));
        for (edges, name) in edges.iter().zip(["pressure", "speed"]) {
            if edges.first() != Some(&0.0) {
                return Err(wrong(format!("the lowest `{name}` must be zero")));
            }
            // Edges do not run into each other.
            let close = |pair: &&[f64]| (1.0 - EDGE) * pair[1] < (1.0 + EDGE) * pair[0];
            if let Some(pair) = edges.windows(2).find(close) {
                let message = format!("of `{name}`, {:e} and {:e} are too close", pair[0], pair[1]);
                return Err(wrong(message));
            }
        }
        let [pressures, speeds] = &edges;
        let mut coefficients = vec![f64::NAN; pressures.len() * speeds.len()];
        for &[pressure, speed, coefficient] in regions {
            let [column, row] = [(pressures, pressure), (speeds, speed)]
                .map(|(edges, place)| edges.partition_point(|&edge| edge < place));
            let region = &mut coefficients[row * pressures.len() + column];
            if !region.is_nan() {
                return Err(wrong(format!(
                    "the region from {pressure}, {speed} m/s is there twice"
                )));
            }
            *region = coefficient;
        }
        if let Some(hole) = coefficients.iter().position(|coefficient| coefficient.is_nan()) {
            let [pressure, speed] =
                [pressures[hole % pressures.len()], speeds[hole / pressures.len()]];
            return Err(wrong(format!("the region from {pressure}, {speed} m/s is missing")));
        }
        if coefficients.chunks(pressures.len()).any(|row| !row.is_sorted()) {
            return Err(wrong("a coefficient falls with the pressure: more would wear less"));
        }
        Ok(Self { hardness, edges, coefficients })
    }

    /// The coefficient at a pressure over hardness and a speed (m/s), and its derivative with respect to the former.
    fn coefficient(&self, pressure: f64, speed: f64) -> [f64; 2] {
        let [along, across] =
            [(0, pressure), (1, speed)].map(|(axis, place)| Between::of(&self.edges[axis], place));
        let mut sums = [0.0; 2];
        for (row, share) in across.regions.into_iter().zip([1.0 - across.share, across.share]) {
            let of = |column: usize| self.coefficients[row * self.edges[0].len() + column];
            let [low, high] = along.regions.map(of);
            sums[0] += share * (low + along.share * (high - low));
            sums[1] += share * along.slope * (high - low);
        }
        sums
    }
}

impl WearLaw for Map {
    fn hardness(&self) -> Option<f64> {
        Some(self.hardness)
    }

    fn inputs(&self) -> &'static [Input] {
        &[Input::Speed]
    }

    fn depth(&self, Rubbing { pressure, slip, speed, .. }: Rubbing) -> f64 {
        let ratio = pressure / self.hardness;
        self.coefficient(ratio, speed)[0] * ratio * slip
    }

    fn slope(&self, Rubbing { pressure, slip, speed, .. }: Rubbing) -> f64 {
        let ratio = pressure / self.hardness;
        let [coefficient, slope] = self.coefficient(ratio, speed);
        (coefficient + slope * ratio) * slip / self.hardness
    }
}

fn wrong(message: impl Into<String>) -> Invalid {
    Invalid::new("file", message)
}

/// The different values, rising.
fn distinct(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::{Rubbing, WearLaw};
    use super::Map;

    /// Mild below half of the hardness, ten times more beyond; and five times more from 0.2 m/s on.
    fn map() -> Map {
        let regions = [[0.0, 0.0, 1.0], [0.5, 0.0, 10.0], [0.0, 0.2, 5.0], [0.5, 0.2, 50.0]];
        Map::new(2.0, &regions).unwrap()
    }

    #[test]
    fn each_region_has_its_coefficient() {
        for (pressure, speed, k) in
            [(0.9, 0.1, 1.0), (1.1, 0.1, 10.0), (0.9, 0.3, 5.0), (4.0, 9.0, 50.0)]
        {
            let rubbing = Rubbing::new(pressure, 3.0).at_speed(speed);
            assert_relative_eq!(map().depth(rubbing), k * pressure * 3.0 / 2.0);
            assert_relative_eq!(map().slope(rubbing), k * 3.0 / 2.0);
        }
    }

    /// In the middle of an edge the mean of both sides; the slope against a central difference.
    #[test]
    fn edges_are_smooth() {
        let at = |pressure: f64| Rubbing::new(pressure, 1.0).at_speed(0.1);
        assert_relative_eq!(map().depth(at(1.0)), 5.5 * 0.5, max_relative = 1e-12);
        for pressure in [0.992, 0.997, 1.0, 1.004] {
            let rise = map().depth(at(pressure + 1e-7)) - map().depth(at(pressure - 1e-7));
            assert_relative_eq!(map().slope(at(pressure)), rise / 2e-7, max_relative = 1e-5);
        }
        let sides = [0.1979, 0.2, 0.2021].map(|v| map().depth(Rubbing::new(0.5, 4.0).at_speed(v)));
        assert_relative_eq!(sides[0], 1.0);
        assert_relative_eq!(sides[1], 3.0, max_relative = 1e-12);
        assert_relative_eq!(sides[2], 5.0);
    }

    #[test]
    fn regions_fill_a_grid() {
        let new = |regions: &[[f64; 3]]| Map::new(2.0, regions).unwrap_err().message;
        let hole = [[0.0, 0.0, 1.0], [0.5, 0.0, 2.0], [0.0, 0.2, 3.0]];
        assert_eq!(new(&hole), "the region from 0.5, 0.2 m/s is missing");
        assert!(new(&[[0.0, 0.0, 1.0], [0.0, 0.0, 2.0]]).contains("twice"));
        assert!(new(&[[0.1, 0.0, 1.0]]).contains("must be zero"));
        assert!(new(&[[0.0, 0.0, 2.0], [0.5, 0.0, 1.0]]).contains("falls with the pressure"));
        assert!(new(&[[0.0, 0.0, 1.0], [0.5, 0.0, 2.0], [0.51, 0.0, 3.0]]).contains("too close"));
        assert!(new(&[]).contains("must be zero"));
    }
}
