//! Heights on a grid of equal pixels.

/// Most pixels of a map: 20 000 squared, 3.2 GB.
pub const MOST: usize = 400_000_000;

/// Heights (m) at the middles of equal pixels, positive out of the material; not a number where nothing was measured.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightMap {
    elements: [usize; 2],
    pixel: [f64; 2],
    heights: Vec<f64>,
}

/// Why heights make no map.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NoMap {
    /// Too few pixels.
    #[error("{} x {} points make no surface: 2 x 2 at least", .0[0], .0[1])]
    Size([usize; 2]),
    /// Too many pixels.
    #[error(
        "{} x {} points take {:.1} GB, and there is room for {:.1} million points: save a part of the surface, or every second point",
        .elements[0], .elements[1], gigabytes(.elements), 1e-6 * *.most as f64
    )]
    Room {
        /// How many points there are along x and y.
        elements: [usize; 2],
        /// How many points there may be.
        most: usize,
    },
    /// A pixel without a size.
    #[error("a pixel of {:e} x {:e} m has no size", .0[0], .0[1])]
    Pixel([f64; 2]),
    /// Another number of heights than pixels.
    #[error("{found} heights for {} x {} points", .elements[0], .elements[1])]
    Count {
        /// How many points there are along x and y.
        elements: [usize; 2],
        /// How many heights.
        found: usize,
    },
    /// Nothing was measured.
    #[error("no point has a height: all are marked as not measured")]
    Empty,
    /// A single point was measured.
    #[error(
        "one point alone has a height, all others are marked as not measured: a surface takes more"
    )]
    Single,
}

/// Memory (GB) for the heights of so many points.
fn gigabytes(elements: &[usize; 2]) -> f64 {
    1e-9 * size_of::<f64>() as f64 * elements[0] as f64 * elements[1] as f64
}

/// How many points a map has, which is told before memory is taken for them.
///
/// # Errors
/// If there are too few along an axis, or more than `most` in all.
pub(crate) fn count(elements: [usize; 2], most: usize) -> Result<usize, NoMap> {
    if elements.iter().any(|&count| count < 2) {
        return Err(NoMap::Size(elements));
    }
    let count = elements[0].checked_mul(elements[1]).filter(|count| *count <= most);
    count.ok_or(NoMap::Room { elements, most })
}

impl HeightMap {
    /// The map of so many points along x and y, pixels of that size (m), and heights (m), those along x first, from the lowest y.
    ///
    /// # Errors
    /// If there are too few points or too many, a pixel has no size, or fewer than two heights are numbers.
    pub fn new(elements: [usize; 2], pixel: [f64; 2], heights: Vec<f64>) -> Result<Self, NoMap> {
        let count = count(elements, MOST)?;
        if !pixel.iter().all(|size| size.is_finite() && *size > 0.0) {
            return Err(NoMap::Pixel(pixel));
        }
        if heights.len() != count {
            return Err(NoMap::Count { elements, found: heights.len() });
        }
        match heights.iter().filter(|height| height.is_finite()).take(2).count() {
            0 => return Err(NoMap::Empty),
            1 => return Err(NoMap::Single),
            _ => {}
        }
        let heights = heights.into_iter().map(|one| if one.is_finite() { one } else { f64::NAN });
        Ok(Self { elements, pixel, heights: heights.collect() })
    }

    /// The same with other heights (m), as many.
    pub(crate) fn of_heights(&self, heights: Vec<f64>) -> Self {
        Self { heights, ..self.clone() }
    }

    /// Points along x and y.
    pub fn elements(&self) -> [usize; 2] {
        self.elements
    }

    /// Size (m) of a pixel along x and y.
    pub fn pixel(&self) -> [f64; 2] {
        self.pixel
    }

    /// Heights (m), those along x first, from the lowest y; not a number where nothing was measured.
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// Size (m) along x and y, of whole pixels.
    pub fn size(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.pixel[axis] * self.elements[axis] as f64)
    }

    /// How many points were not measured.
    pub fn missing(&self) -> usize {
        self.heights.iter().filter(|height| height.is_nan()).count()
    }

    /// The height (m) of a point.
    pub fn at(&self, x: usize, y: usize) -> f64 {
        self.heights[x + self.elements[0] * y]
    }

    /// Places (m) of the points that were measured, from the middle of the map, with their heights (m).
    pub(crate) fn measured(&self) -> impl Iterator<Item = ([f64; 2], f64)> {
        let nx = self.elements[0];
        let heights = self.heights.iter().enumerate().filter(|(_, height)| !height.is_nan());
        heights.map(move |(at, &height)| ([self.place(0, at % nx), self.place(1, at / nx)], height))
    }

    /// The map less a surface, whose height (m) is known at each place (m).
    pub(crate) fn less(&self, surface: impl Fn([f64; 2]) -> f64) -> Self {
        let nx = self.elements[0];
        let place = |at: usize| [self.place(0, at % nx), self.place(1, at / nx)];
        let heights = self.heights.iter().enumerate();
        self.of_heights(heights.map(|(at, height)| height - surface(place(at))).collect())
    }

    /// Place (m) of a point along x (0) or y (1), from the middle of the map.
    pub fn place(&self, axis: usize, index: usize) -> f64 {
        self.pixel[axis] * (index as f64 - 0.5 * (self.elements[axis] - 1) as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::{HeightMap, NoMap};

    #[test]
    fn one_point_makes_no_surface() {
        let of = |heights: [f64; 4]| HeightMap::new([2, 2], [1e-6; 2], heights.to_vec());
        let none = f64::NAN;
        assert_eq!(of([none; 4]), Err(NoMap::Empty));
        assert_eq!(of([none, 1e-6, none, none]), Err(NoMap::Single));
        assert!(of([none, 1e-6, none, 2e-6]).is_ok());
    }
}
