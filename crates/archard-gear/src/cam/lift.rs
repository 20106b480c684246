//! A lift over the angle of a cam, from a table.

use std::f64::consts::TAU;

use archard::parameters::Invalid;

/// How far the angles of a table may be from a turn (rad), and its ends from each other, over the largest lift: six digits, as tables
/// are rounded to. Its last row counts as the first, a turn later.
const ROUNDED: f64 = 1e-6;
/// The fewest rows: every other one of them, four, makes a lift that says how far off this one is.
const FEWEST: usize = 7;
/// The fewest rows of a spline that closes.
const ROWS: usize = 4;

/// A lift (m) over an angle (rad): the cubic spline through the rows of a table, a turn after which it repeats itself.
#[derive(Debug, Clone, PartialEq)]
pub struct Lift {
    /// Angle and lift; the last row is the first, a turn later.
    rows: Vec<[f64; 2]>,
    /// Second derivatives (m/rad^2) at the rows.
    bends: Vec<f64>,
}

impl Lift {
    /// The lift of the rows of a table: angle (rad) and lift (m).
    ///
    /// # Errors
    /// If there are fewer than seven, angles do not rise over one turn, or the lift does not close.
    pub fn new(rows: Vec<[f64; 2]>) -> Result<Self, Invalid> {
        Self::of(rows, FEWEST)
    }

    /// The same of so many rows or more.
    fn of(mut rows: Vec<[f64; 2]>, fewest: usize) -> Result<Self, Invalid> {
        let wrong = |message: String| Err(Invalid::new("file", message));
        let ([.., last], [first, ..]) = (&rows[..], &rows[..]) else {
            return wrong("the table has no rows".to_owned());
        };
        if rows.len() < fewest {
            return wrong(format!("{fewest} rows at least are needed, here are {}", rows.len()));
        }
        for (row, pair) in rows.windows(2).enumerate() {
            if pair[1][0] <= pair[0][0] {
                return wrong(format!("row {}: angles must rise", row + 2));
            }
        }
        let turn = last[0] - first[0];
        if (turn - TAU).abs() > ROUNDED {
            return wrong(format!(
                "the angles go from {:.6} to {:.6} deg, {:.3e} deg off: a whole turn is needed, whose last row is the first, 360 deg later",
                first[0].to_degrees(),
                last[0].to_degrees(),
                (turn - TAU).to_degrees()
            ));
        }
        let largest = rows.iter().map(|row| row[1].abs()).fold(0.0, f64::max);
        if (last[1] - first[1]).abs() > ROUNDED * largest {
            return wrong(format!(
                "the lift does not close: it begins with {:.6} mm and is {:.6} mm a turn later, {:.3e} mm off",
                1e3 * first[1],
                1e3 * last[1],
                1e3 * (last[1] - first[1])
            ));
        }
        let (count, closed) = (rows.len(), [first[0] + TAU, first[1]]);
        rows[count - 1] = closed;
        let bends = bends(&rows);
        Ok(Self { rows, bends })
    }

    /// How many rows there are.
    pub(super) fn rows(&self) -> usize {
        self.rows.len()
    }

    /// Lift (m), and its first and second derivative by the angle (rad).
    pub fn at(&self, angle: f64) -> [f64; 3] {
        let start = self.rows[0][0];
        let angle = start + (angle - start).rem_euclid(TAU);
        let next = self.rows.partition_point(|row| row[0] <= angle).clamp(1, self.rows.len() - 1);
        let ([from, low], [to, high]) = (self.rows[next - 1], self.rows[next]);
        let [bend, then] = [self.bends[next - 1], self.bends[next]];
        let width = to - from;
        let along = angle - from;
        let slope = (high - low) / width - width * (2.0 * bend + then) / 6.0;
        let rise = (then - bend) / width;
        [
            low + along * (slope + along * (0.5 * bend + along * rise / 6.0)),
            slope + along * (bend + 0.5 * along * rise),
            bend + along * rise,
        ]
    }

    /// The spline through every other row: as far from this one as three quarters of the error of rounded lifts, and more than that of
    /// rows far apart. `None` of few rows.
    pub(super) fn coarser(&self) -> Option<Self> {
        let last = self.rows.len() - 1;
        let keep = |&row: &usize| row.is_multiple_of(2) && row + 1 < last || row == last;
        let rows: Vec<[f64; 2]> = (0..=last).filter(keep).map(|row| self.rows[row]).collect();
        Self::of(rows, ROWS).ok()
    }
}

/// Second derivatives of the closed spline: a tridiagonal system whose corners are of rank one (Sherman & Morrison).
fn bends(rows: &[[f64; 2]]) -> Vec<f64> {
    let count = rows.len() - 1;
    let width = |at: usize| rows[at % count + 1][0] - rows[at % count][0];
    let slope = |at: usize| (rows[at % count + 1][1] - rows[at % count][1]) / width(at);
    let before = |at: usize| at + count - 1;
    let beside: Vec<f64> = (0..count).map(|at| width(at) / 6.0).collect();
    let mut middle: Vec<f64> = (0..count).map(|at| (width(before(at)) + width(at)) / 3.0).collect();
    let right: Vec<f64> = (0..count).map(|at| slope(at) - slope(before(at))).collect();
    // Rank one: u = (g, 0, .., corner), v = (1, 0, .., corner/g).
    let corner = beside[count - 1];
    let g = -middle[0];
    middle[0] -= g;
    middle[count - 1] -= corner * corner / g;
    let mut u = vec![0.0; count];
    (u[0], u[count - 1]) = (g, corner);
    let solve = |right: &[f64]| {
        let (mut main, mut found) = (middle.clone(), right.to_vec());
        for at in 1..count {
            let factor = beside[at - 1] / main[at - 1];
            main[at] -= factor * beside[at - 1];
            found[at] -= factor * found[at - 1];
        }
        found[count - 1] /= main[count - 1];
        for at in (0..count - 1).rev() {
            found[at] = (found[at] - beside[at] * found[at + 1]) / main[at];
        }
        found
    };
    let (found, other) = (solve(&right), solve(&u));
    let share = |of: &[f64]| of[0] + of[count - 1] * corner / g;
    let factor = share(&found) / (1.0 + share(&other));
    let mut bends: Vec<f64> =
        found.iter().zip(&other).map(|(found, other)| found - factor * other).collect();
    bends.push(bends[0]);
    bends
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::Lift;

    fn table(count: usize, uneven: f64, lift: impl Fn(f64) -> f64) -> Lift {
        let angle = |row: usize| {
            let even = TAU * row as f64 / count as f64;
            even + uneven * (3.0 * even).sin() / 3.0
        };
        let mut rows: Vec<[f64; 2]> =
            (0..count).map(|row| [angle(row), lift(angle(row))]).collect();
        rows.push([TAU, rows[0][1]]);
        Lift::new(rows).unwrap()
    }

    /// The second derivative of the spline is off by h^2/12 times the fourth, in the middle of rows by half as much with the other sign.
    #[test]
    fn the_spline_follows_a_lift_and_its_derivatives() {
        for (count, uneven) in [(90, 0.0), (91, 0.0), (180, 0.3)] {
            let lift = table(count, uneven, |angle| 4e-3 * (1.0 - (angle - 0.3).cos()));
            let width = (1.0 + uneven) * TAU / count as f64;
            for step in 0..1000 {
                let angle = TAU * (f64::from(step) / 1000.0 - 0.2);
                let [value, slope, bend] = lift.at(angle);
                let off = angle - 0.3;
                assert!((value - 4e-3 * (1.0 - off.cos())).abs() < 4e-3 * width.powi(4) / 100.0);
                assert!((slope - 4e-3 * off.sin()).abs() < 4e-3 * width.powi(3) / 10.0);
                assert!((bend - 4e-3 * off.cos()).abs() < 4e-3 * width.powi(2) / 6.0, "{count}");
            }
        }
    }

    #[test]
    fn tables_that_do_not_close_are_refused() {
        let even =
            |count: usize| (0..=count).map(move |row| [TAU * row as f64 / count as f64, 1e-3]);
        let refused = |rows: Vec<[f64; 2]>| Lift::new(rows).unwrap_err().message.to_string();
        let mut open: Vec<_> = even(12).collect();
        open[12][1] = 1.1e-3;
        assert!(
            refused(open)
                .contains("begins with 1.000000 mm and is 1.100000 mm a turn later, 1.000e-1 mm")
        );
        assert!(refused(even(12).take(12).collect()).contains("from 0.000000 to 330.000000 deg"));
        assert!(refused(even(2).collect()).contains("7 rows at least"));
        let mut back: Vec<_> = even(12).collect();
        back[5][0] = 0.1;
        assert!(refused(back).contains("row 6: angles must rise"));
    }
}
