//! Maps with their holes filled, and maps turned over.

use crate::map::{HeightMap, NoMap};

/// Rest of the residual at which holes are filled, relative to the first: heights have fewer digits.
const FILLED: f64 = 1e-10;

impl HeightMap {
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

#[cfg(test)]
mod tests {
    use crate::map::HeightMap;

    fn map(height: impl Fn(f64, f64) -> f64) -> HeightMap {
        let heights = (0..30 * 20).map(|at| height((at % 30) as f64, (at / 30) as f64)).collect();
        HeightMap::new([30, 20], [2e-6, 3e-6], heights).unwrap()
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
