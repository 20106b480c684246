//! What is done to a map before it is used: levelled, its holes filled, turned over.

use crate::map::{HeightMap, NoMap};

/// What is taken off a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// The plane that fits best.
    Plane,
    /// The surface of second degree that fits best: tilt, bow and twist.
    Quadratic,
}

impl Level {
    /// The terms of the polynomial at a place, each axis from -1 to 1.
    fn terms(self, [x, y]: [f64; 2]) -> Vec<f64> {
        match self {
            Self::Plane => vec![1.0, x, y],
            Self::Quadratic => vec![1.0, x, y, x * x, x * y, y * y],
        }
    }
}

/// Rest of the residual at which holes are filled, relative to the first: heights have fewer digits.
const FILLED: f64 = 1e-10;

impl HeightMap {
    /// The map less what fits best to the points that were measured, by least squares.
    ///
    /// # Errors
    /// If no height is left.
    pub fn levelled(&self, level: Level) -> Result<Self, NoMap> {
        let [nx, ny] = self.elements();
        let place = |at: usize| {
            let share = |index: usize, count: usize| 2.0 * index as f64 / (count - 1) as f64 - 1.0;
            [share(at % nx, nx), share(at / nx, ny)]
        };
        let size = level.terms([0.0; 2]).len();
        let mut equations = vec![vec![0.0; size + 1]; size];
        for (at, height) in self.heights().iter().enumerate().filter(|(_, one)| !one.is_nan()) {
            let terms = level.terms(place(at));
            for (row, one) in equations.iter_mut().zip(&terms) {
                for (value, other) in row.iter_mut().zip(terms.iter().chain([height])) {
                    *value += one * other;
                }
            }
        }
        let fit = solved(equations);
        let surface = |at: usize| -> f64 {
            level.terms(place(at)).iter().zip(&fit).map(|(term, factor)| term * factor).sum()
        };
        let heights = self.heights().iter().enumerate().map(|(at, height)| height - surface(at));
        Self::new(self.elements(), self.pixel(), heights.collect())
    }

    /// The map with heights where nothing was measured: the harmonic function between those that were, flat across the rim. It has no
    /// hill or pit of its own.
    ///
    /// # Errors
    /// If no height is left.
    pub fn filled(&self) -> Result<Self, NoMap> {
        let mut heights = self.heights().to_vec();
        let holes: Vec<usize> = (0..heights.len()).filter(|&at| heights[at].is_nan()).collect();
        if holes.is_empty() {
            return Ok(self.clone());
        }
        let (mean, count) = heights
            .iter()
            .filter(|height| !height.is_nan())
            .fold((0.0, 0.0), |(sum, count), height| (sum + height, count + 1.0));
        holes.iter().for_each(|&at| heights[at] = mean / count);
        let inside: Vec<bool> = self.heights().iter().map(|height| height.is_nan()).collect();
        let [nx, ny] = self.elements();
        // Differences of a pixel to its neighbours count by the inverse square of their distance.
        let weights = self.pixel().map(|size| (self.pixel()[0] / size).powi(2));
        let neighbours = |at: usize| {
            let (x, y) = (at % nx, at / nx);
            let along_x = [(x > 0).then(|| at - 1), (x + 1 < nx).then(|| at + 1)];
            let along_y = [(y > 0).then(|| at - nx), (y + 1 < ny).then(|| at + nx)];
            let along = |places: [Option<usize>; 2], weight: f64| {
                places.into_iter().flatten().map(move |place| (place, weight))
            };
            along(along_x, weights[0]).chain(along(along_y, weights[1]))
        };
        // Conjugate gradients; a field is that of all pixels, and zero outside of holes.
        let applied = |field: &[f64], only_holes: bool| -> Vec<f64> {
            let of = |&at: &usize| {
                let known = |place: usize| !only_holes || inside[place];
                let part = |(place, weight): (usize, f64)| {
                    weight * (field[at] - if known(place) { field[place] } else { 0.0 })
                };
                neighbours(at).map(part).sum::<f64>()
            };
            holes.iter().map(of).collect()
        };
        let dot = |one: &[f64], other: &[f64]| -> f64 {
            one.iter().zip(other).map(|(one, other)| one * other).sum()
        };
        let mut rest: Vec<f64> = applied(&heights, false).iter().map(|one| -one).collect();
        let mut way = rest.clone();
        let mut size = dot(&rest, &rest);
        let aim = FILLED * FILLED * size;
        let mut field = vec![0.0; heights.len()];
        for _ in 0..holes.len() {
            if size <= aim {
                break;
            }
            holes.iter().zip(&way).for_each(|(&at, one)| field[at] = *one);
            let image = applied(&field, true);
            let length = size / dot(&way, &image);
            holes.iter().zip(&way).for_each(|(&at, one)| heights[at] += length * one);
            rest.iter_mut().zip(&image).for_each(|(one, image)| *one -= length * image);
            let next = dot(&rest, &rest);
            way.iter_mut().zip(&rest).for_each(|(one, rest)| *one = rest + next / size * *one);
            size = next;
        }
        Self::new(self.elements(), self.pixel(), heights)
    }

    /// The map with hills for pits, as of a replica or of depths.
    #[must_use]
    pub fn inverted(&self) -> Self {
        self.with(|map, x, y| -map.at(x, y))
    }

    /// The map with its rows in the opposite order, of files whose first row is the upper one.
    #[must_use]
    pub fn flipped(&self) -> Self {
        self.with(|map, x, y| map.at(x, map.elements()[1] - 1 - y))
    }

    fn with(&self, height: impl Fn(&Self, usize, usize) -> f64) -> Self {
        let nx = self.elements()[0];
        let heights = (0..self.heights().len()).map(|at| height(self, at % nx, at / nx)).collect();
        self.of_heights(heights)
    }
}

/// The solution of equations, each with its right-hand side last: Gauss with the largest pivots.
fn solved(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let size = rows.len();
    for at in 0..size {
        let best = (at..size).max_by(|&a, &b| rows[a][at].abs().total_cmp(&rows[b][at].abs()));
        rows.swap(at, best.unwrap_or(at));
        let pivot = rows[at].clone();
        // Points on one line leave a tilt open.
        if pivot[at] == 0.0 {
            continue;
        }
        for (_, row) in rows.iter_mut().enumerate().filter(|(other, _)| *other != at) {
            let share = row[at] / pivot[at];
            row.iter_mut().zip(&pivot).for_each(|(value, pivot)| *value -= share * pivot);
        }
    }
    let value = |at: usize| if rows[at][at] == 0.0 { 0.0 } else { rows[at][size] / rows[at][at] };
    (0..size).map(value).collect()
}

#[cfg(test)]
mod tests {
    use super::Level;
    use crate::map::HeightMap;

    fn map(height: impl Fn(f64, f64) -> f64) -> HeightMap {
        let heights = (0..30 * 20).map(|at| height((at % 30) as f64, (at / 30) as f64)).collect();
        HeightMap::new([30, 20], [2e-6, 3e-6], heights).unwrap()
    }

    #[test]
    fn planes_and_bows_are_taken_off() {
        let hole = |x: f64, y: f64| if x > 5.0 && x < 9.0 && y < 7.0 { f64::NAN } else { 0.0 };
        let plane = map(|x, y| 3.0 + 0.2 * x - 0.1 * y + hole(x, y));
        let bow = map(|x, y| 3.0 + 0.2 * x - 0.1 * y + 0.01 * x * y - 0.02 * y * y + hole(x, y));
        for (map, level) in [(plane, Level::Plane), (bow, Level::Quadratic)] {
            let levelled = map.levelled(level).unwrap();
            assert_eq!(levelled.missing(), map.missing());
            assert!(levelled.heights().iter().all(|one| one.is_nan() || one.abs() < 1e-12));
        }
    }

    /// x^2 - y^2 in metres is harmonic on its pixels too, and what is measured stays.
    #[test]
    fn holes_are_filled_by_harmonic_functions() {
        let saddle = |x: f64, y: f64| (2.0 * x).powi(2) - (3.0 * y).powi(2);
        let inside = |x: f64, y: f64| (10.0..20.0).contains(&x) && (4.0..15.0).contains(&y);
        let whole = map(saddle);
        let holed = map(|x, y| if inside(x, y) { f64::NAN } else { saddle(x, y) });
        let filled = holed.filled().unwrap();
        for (one, other) in whole.heights().iter().zip(filled.heights()) {
            assert!((one - other).abs() < 1e-6, "{one} {other}");
        }
        assert_eq!(filled.missing(), 0);
        assert_eq!(whole.filled().unwrap(), whole);
    }

    #[test]
    fn maps_turn_over() {
        let ramp = map(|x, y| x + 100.0 * y);
        assert_eq!(ramp.flipped().at(3, 0), 1903.0);
        assert_eq!(ramp.inverted().at(3, 0), -3.0);
        assert_eq!(ramp.flipped().flipped(), ramp);
    }
}
