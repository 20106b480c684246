//! A measured shape: heights at points of a rectangular grid, or a profile along one axis.

use super::Profile;
use crate::numerics::interpolate::interpolate;
use crate::parameters::{Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Profile>> = Choice {
    name: "table",
    meaning: "measured heights of the surface, positive towards the other body",
    parameters: &[Parameter::required(
        "file",
        Quantity::Table(&[]),
        "CSV with columns x, y and z, or x and z, or y and z, units in the header (x_mm, z_um)",
    )],
    build: |values| {
        let columns = values.table("file").unwrap_or_default();
        let column = |name| columns.iter().find(|known| known.0 == name).map(|known| &known.1[..]);
        let table = match (columns.len(), column("x"), column("y"), column("z")) {
            (3, Some(x), Some(y), Some(z)) => Table::new(x, y, z),
            (2, Some(x), None, Some(z)) => Table::new(x, &vec![0.0; x.len()], z),
            (2, None, Some(y), Some(z)) => Table::new(&vec![0.0; y.len()], y, z),
            _ => Err(wrong("the columns must be x, y and z, or x and z, or y and z")),
        };
        Ok(Box::new(table?))
    },
};

/// An edge is a place at which the slope changes by more than this share of the most it changes by along a row of heights.
const EDGE: f64 = 0.3;

/// Heights on a rectangular grid, interpolated by cubics; along an axis with a single place the
/// height does not vary.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Rising places along x (m).
    x: Vec<f64>,
    /// Rising places along y (m).
    y: Vec<f64>,
    /// Recess (m) below the highest point, x running fastest.
    recess: Vec<f64>,
}

impl Table {
    /// Heights z (m), positive towards the other body, at points x and y (m) in any order that fill a rectangular
    /// grid; with all x or all y equal, the height varies along the other axis alone.
    ///
    /// # Errors
    /// If the lists differ in length, a value is not finite, the grid has holes, or a point is there twice.
    pub fn new(x: &[f64], y: &[f64], z: &[f64]) -> Result<Self, Invalid> {
        if x.len() != z.len() || y.len() != z.len() {
            return Err(wrong(format!("{} x, {} y and {} z are given", x.len(), y.len(), z.len())));
        }
        if !x.iter().chain(y).chain(z).all(|value| value.is_finite()) {
            return Err(wrong("places and heights must be finite numbers"));
        }
        let (places_x, places_y) = (distinct(x), distinct(y));
        if places_x.len().max(places_y.len()) < 2 {
            return Err(wrong("at least two different places are needed"));
        }
        let top = z.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let mut recess = vec![f64::NAN; places_x.len() * places_y.len()];
        for ((&x, &y), &z) in x.iter().zip(y).zip(z) {
            let column = places_x.partition_point(|&known| known < x);
            let row = places_y.partition_point(|&known| known < y);
            let place = &mut recess[row * places_x.len() + column];
            if !place.is_nan() {
                return Err(wrong(format!("the point x = {x} m, y = {y} m is there twice")));
            }
            *place = top - z;
        }
        if let Some(hole) = recess.iter().position(|recess| recess.is_nan()) {
            let (row, column) = (hole / places_x.len(), hole % places_x.len());
            return Err(wrong(format!(
                "the table has holes: no height at x = {} m, y = {} m; the points must fill a rectangular grid",
                places_x[column], places_y[row]
            )));
        }
        Ok(Self { x: places_x, y: places_y, recess })
    }

    /// Heights z (m), positive towards the other body, on rising places along x and y (m), x running fastest.
    ///
    /// # Errors
    /// If there are not as many heights as places, fewer than two places along an axis, or a value is not finite.
    pub fn on_grid([x, y]: [Vec<f64>; 2], z: impl Into<Vec<f64>>) -> Result<Self, Invalid> {
        let mut z: Vec<f64> = z.into();
        if x.len().min(y.len()) < 2 || x.len() * y.len() != z.len() {
            return Err(wrong(format!("{} heights on {} x {} places", z.len(), x.len(), y.len())));
        }
        if !x.iter().chain(&y).chain(&z).all(|value| value.is_finite()) {
            return Err(wrong("places and heights must be finite numbers"));
        }
        if ![&x, &y].iter().all(|places| places.is_sorted_by(|one, next| one < next)) {
            return Err(wrong("places must rise"));
        }
        let top = z.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        z.iter_mut().for_each(|z| *z = top - *z);
        Ok(Self { x, y, recess: z })
    }

    /// Recess (m) along the row at x (m).
    fn along_row(&self, row: usize, x: f64) -> f64 {
        let values = &self.recess[row * self.x.len()..][..self.x.len()];
        if values.len() == 1 { values[0] } else { interpolate(&self.x, |i| values[i], x) }
    }
}

/// The largest change of the slope at a place, and that from the least slope to the largest, of heights at rising places.
fn changes(places: &[f64], height: impl Fn(usize) -> f64) -> [f64; 2] {
    let slope = |i: usize| (height(i) - height(i - 1)) / (places[i] - places[i - 1]);
    let slopes: Vec<f64> = (1..places.len()).map(slope).collect();
    let range = |slopes: &[f64]| {
        let ends = [f64::max, f64::min].map(|end| slopes.iter().copied().reduce(end));
        ends[0].zip(ends[1]).map_or(0.0, |(most, least)| most - least)
    };
    [slopes.windows(2).map(range).fold(0.0, f64::max), range(&slopes)]
}

impl Profile for Table {
    fn recess(&self, x: f64, y: f64) -> f64 {
        if self.y.len() == 1 {
            self.along_row(0, x)
        } else {
            interpolate(&self.y, |row| self.along_row(row, x), y)
        }
    }

    fn extent(&self) -> [[f64; 2]; 2] {
        [&self.x, &self.y].map(|places| match places[..] {
            [first, .., last] => [first, last],
            _ => [f64::NEG_INFINITY, f64::INFINITY],
        })
    }

    fn sharpest(&self) -> f64 {
        let at = |row: usize, column: usize| self.recess[row * self.x.len() + column];
        let rows = (0..self.y.len()).map(|row| changes(&self.x, |column| at(row, column)));
        let columns = (0..self.x.len()).map(|column| changes(&self.y, |row| at(row, column)));
        let most = |one: [f64; 2], other: [f64; 2]| [0, 1].map(|i| one[i].max(other[i]));
        let [at_a_place, in_all] = rows.chain(columns).fold([0.0; 2], most);
        if at_a_place > EDGE * in_all { 0.0 } else { 2.0 }
    }

    fn places(&self) -> [&[f64]; 2] {
        [&self.x, &self.y].map(|places| if places.len() > 1 { &places[..] } else { &[] })
    }
}

fn wrong(message: impl Into<String>) -> Invalid {
    Invalid::new("file", message)
}

/// The different values, rising.
fn distinct(values: &[f64]) -> Vec<f64> {
    let mut values = values.to_vec();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::Table;
    use crate::body::Profile;

    /// A chamfer has an edge; a paraboloid has none, nor has a cylinder with a little noise along its axis.
    #[test]
    fn edges_are_where_slopes_jump() {
        let has_edge = |height: &dyn Fn(f64, f64) -> f64| {
            let places: Vec<[f64; 2]> =
                (0..400).map(|i| [f64::from(i % 20), f64::from(i / 20)]).collect();
            let [x, y] = [0, 1].map(|axis| places.iter().map(|place| place[axis]).collect());
            let z: Vec<f64> = places.iter().map(|[x, y]| height(x - 9.5, y - 9.5)).collect();
            let [x, y]: [Vec<f64>; 2] = [x, y];
            Table::new(&x, &y, &z).unwrap().sharpest() == 0.0
        };
        assert!(has_edge(&|x, y| -0.1 * (x.hypot(y) - 6.0).max(0.0)));
        assert!(!has_edge(&|x, y| -0.01 * (x * x + 2.0 * y * y)));
        assert!(!has_edge(&|x, y| -0.01 * x * x + 0.002 * (7.0 * y).sin()));
        assert!(!has_edge(&|_, _| 1.0));
    }

    #[test]
    fn a_tabulated_paraboloid_is_exact() {
        let (mut x, mut y, mut z) = (vec![], vec![], vec![]);
        for i in -3..=3 {
            for j in -2..=2 {
                let (a, b) = (f64::from(i), f64::from(j) * 1.5);
                x.push(a);
                y.push(b);
                z.push(7.0 - a * a - 0.5 * b * b);
            }
        }
        let table = Table::new(&x, &y, &z).unwrap();
        assert_relative_eq!(table.recess(1.3, -2.2), 1.3 * 1.3 + 0.5 * 2.2 * 2.2, epsilon = 1e-12);
        assert!(table.recess(3.1, 0.0).is_nan());
    }

    #[test]
    fn holes_and_doubled_points_are_named() {
        let hole = Table::new(&[0.0, 1.0, 0.0], &[0.0, 0.0, 1.0], &[0.0; 3]).unwrap_err();
        assert!(hole.message.contains("x = 1 m, y = 1 m"), "{hole}");
        let twice = Table::new(&[0.0, 0.0], &[0.0, 0.0], &[1.0, 2.0]).unwrap_err();
        assert!(twice.message.contains("two different places"), "{twice}");
    }
}
