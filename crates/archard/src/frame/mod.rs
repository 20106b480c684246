//! The contact frame: the pairs of points that may touch, and the fields that live on them.
//!
//! Conventions, here and everywhere above:
//!
//! - SI units. Only `case` and `output` know others.
//! - n is the outward normal of body 1. Gaps are body 2 minus body 1 in {t1, t2, n}; tractions act
//!   on body 1. Compression has a negative normal traction, and what a user sees is the pressure
//!   p = -t_n >= 0. The relative displacement of the pairs is
//!   k = k_g + k_o + w n - C L with C the sum of the compliances of both bodies (the paper's
//!   eq. 29, its bodies condensed), so that the normal gap is g + w - approach + C p.
//! - t1 is the x axis of the frame and t2 the y axis. Friction on body 1 points along the slip of
//!   body 2 over body 1.
//! - On a uniform frame a pair is the centre of a rectangular element of uniform traction; pair
//!   i = ix + nx iy. Frames of other pairs are [described](Pairs) one by one: areas of their own, maybe
//!   bases of their own on a curved surface, maybe one half or quarter of a symmetric frame. A uniform
//!   frame stores none of that, so that millions of pairs stay cheap.
//! - Between a ball and its socket, or a shaft and its bush, a uniform frame is [drawn on their surface](Wrap): x and y are no
//!   longer axes of space, and the approach closes each gap by its own share.

mod centre;
mod cloud;
mod direction;
mod field;
mod flow;
mod grid;
mod line;
mod measure;
mod pairs;
mod part;
mod rectangle;
mod region;
mod vectors;
mod wrap;

#[doc(hidden)]
pub use crate::numerics::upwind::DegenerateCloud;
#[doc(hidden)]
pub use crate::numerics::vector::Values;
pub use direction::Direction;
pub use field::VectorField;
#[doc(hidden)]
pub use flow::Flow;
#[doc(hidden)]
pub use line::{Line, Passage};
#[doc(hidden)]
pub use measure::Measure;
#[doc(hidden)]
pub use pairs::{Pairs, PairsError};
#[doc(hidden)]
pub use part::{Extent, Part, extent};
pub use rectangle::Rectangle;
#[doc(hidden)]
pub use wrap::Wrap;

use rayon::prelude::*;

use crate::body::Profile;
use crate::body::profile::Round;
use grid::Grid;
use pairs::Described;

/// The pairs that may touch, and their geometric gap.
#[derive(Debug, Clone)]
pub struct ContactFrame {
    shape: Shape,
    /// Gap of the undeformed bodies at first touch (m).
    gap: Vec<f64>,
    /// How much of the approach closes the gap of each pair of a frame that is drawn on a round surface; none of others.
    closing: Vec<f64>,
}

/// Where the pairs are.
#[derive(Debug, Clone)]
enum Shape {
    Uniform(Grid),
    Described(Box<Described>),
}

/// A frame with a part beyond a body's surface.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("the surface of body {} does not reach the pair at x = {:e} m, y = {:e} m", .body + 1, .place[0], .place[1])]
pub struct OffTheSurface {
    /// The body's index, 0 or 1.
    pub body: usize,
    /// Where (m).
    pub place: [f64; 2],
}

impl ContactFrame {
    /// A frame of that number of elements along x and y between two profiles, over a rectangle: of a size (m) about the
    /// origin, or a [`Rectangle`].
    ///
    /// # Errors
    /// If a profile has no surface at some pair.
    pub fn uniform(
        rectangle: impl Into<Rectangle>,
        elements: [usize; 2],
        profiles: [&dyn Profile; 2],
    ) -> Result<Self, OffTheSurface> {
        let rectangle = rectangle.into();
        let wrap = Wrap::of(profiles).filter(|wrap| wrap.round == Round::Sphere);
        Self::on(Grid { wrap, ..Grid::on(rectangle, elements, false) }, profiles)
    }

    /// A line of contact along y in plane strain: that many elements over the width along x of a rectangle (as in
    /// [`Self::uniform`]), and that many strips along its length, each in plane strain by itself. Forces and volumes are those
    /// of its length along y.
    ///
    /// # Errors
    /// If a profile has no surface at some pair.
    pub fn line(
        rectangle: impl Into<Rectangle>,
        elements: [usize; 2],
        profiles: [&dyn Profile; 2],
    ) -> Result<Self, OffTheSurface> {
        let rectangle = rectangle.into();
        let wrap = Wrap::of(profiles).filter(|wrap| wrap.round == Round::Cylinder);
        Self::on(Grid { wrap, ..Grid::on(rectangle, elements, true) }, profiles)
    }

    fn on(grid: Grid, profiles: [&dyn Profile; 2]) -> Result<Self, OffTheSurface> {
        let elements = grid.elements;
        let recess = |pair: usize| {
            let [x, y] = grid.place(pair);
            profiles.map(|profile| profile.recess(x, y))
        };
        let mut gap: Vec<f64> = (0..elements[0] * elements[1])
            .into_par_iter()
            .with_min_len(4096)
            .map(|pair| undeformed(&grid, profiles, pair))
            .collect();
        if let Some(pair) = gap.iter().position(|gap| !gap.is_finite()) {
            let body = usize::from(recess(pair)[0].is_finite());
            return Err(OffTheSurface { body, place: grid.place(pair) });
        }
        // The bodies may touch between pairs, where the apex of most profiles is.
        let apex = || profiles.iter().map(|profile| profile.recess(0.0, 0.0)).sum();
        let apex = if grid.rectangle.holds([0.0; 2]) { apex() } else { f64::INFINITY };
        // What the approach closes by shares is measured from the pole.
        let least = || gap.iter().copied().fold(apex, f64::min);
        let touch = if grid.wrap.is_some() { 0.0 } else { least() };
        gap.iter_mut().for_each(|gap| *gap -= touch);
        Ok(Self::of(grid, gap))
    }

    /// The pairs of a grid, with these gaps (m).
    fn of(grid: Grid, gap: Vec<f64>) -> Self {
        let closing = match grid.wrap {
            Some(wrap) => (0..gap.len()).map(|pair| wrap.closing(grid.place(pair))).collect(),
            None => vec![],
        };
        Self { shape: Shape::Uniform(grid), gap, closing }
    }

    /// The same pairs where the surfaces end, or repeat themselves, with them: all of them may touch.
    #[must_use]
    pub fn closed(mut self) -> Self {
        match &mut self.shape {
            Shape::Uniform(grid) => grid.closed = true,
            Shape::Described(described) => described.pairs.closed = true,
        }
        self
    }

    /// The pairs of a part of a uniform frame, with the gaps they have; `None` of another one.
    pub fn within(&self, part: &Part) -> Option<Self> {
        let Shape::Uniform(grid) = &self.shape else { return None };
        Some(Self::of(grid.within(part), part.cut(&self.gap)))
    }

    /// The larger uniform frame that this one is a part of, with the gaps it has; `None` of another one, and where a profile
    /// has no surface.
    pub fn around(&self, part: &Part, profiles: [&dyn Profile; 2]) -> Option<Self> {
        let Shape::Uniform(grid) = &self.shape else { return None };
        let touch = self.touch(profiles);
        let larger = grid.around(part);
        let gap: Vec<f64> = (0..larger.elements[0] * larger.elements[1])
            .into_par_iter()
            .with_min_len(4096)
            .map(|pair| match part.place(pair) {
                Some(own) => self.gap[own],
                None => undeformed(&larger, profiles, pair) - touch,
            })
            .collect();
        let known = gap.iter().all(|gap| gap.is_finite());
        known.then_some(Self::of(larger, gap))
    }

    /// How deep (m) the profiles lie below their planes where they touch first, as the gaps of a uniform frame count it.
    pub(crate) fn touch(&self, profiles: [&dyn Profile; 2]) -> f64 {
        match &self.shape {
            Shape::Uniform(grid) => undeformed(grid, profiles, 0) - self.gap[0],
            Shape::Described(_) => 0.0,
        }
    }

    /// Number of pairs.
    pub fn len(&self) -> usize {
        self.gap.len()
    }

    /// Whether there are no pairs.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether the pairs are equal elements of a rectangular grid, without mirror images.
    pub fn is_uniform(&self) -> bool {
        matches!(self.shape, Shape::Uniform(_))
    }

    /// Whether the pairs are a line of contact in plane strain.
    pub fn is_line(&self) -> bool {
        matches!(self.shape, Shape::Uniform(Grid { line: true, .. }))
    }

    /// Whether the pairs lie in rows and columns along x and y.
    pub fn is_grid(&self) -> bool {
        match &self.shape {
            Shape::Uniform(_) => true,
            Shape::Described(described) => described.pairs.elements.is_some(),
        }
    }

    /// What the frame is drawn on between bodies that fit into each other; `None` of other frames.
    pub fn wrap(&self) -> Option<Wrap> {
        if let Shape::Uniform(grid) = &self.shape { grid.wrap } else { None }
    }

    /// Whether all pairs have the axes of the frame for their basis.
    pub fn is_plane(&self) -> bool {
        match &self.shape {
            Shape::Uniform(grid) => grid.wrap.is_none(),
            Shape::Described(described) => described.pairs.bases.is_empty(),
        }
    }

    /// Whether x = 0 and y = 0 are planes of symmetry with pairs on one side only.
    pub fn mirrored(&self) -> [bool; 2] {
        match &self.shape {
            Shape::Uniform(_) => [false; 2],
            Shape::Described(described) => described.pairs.mirrored,
        }
    }

    /// Size along x and y (m), mirror images included.
    pub fn size(&self) -> [f64; 2] {
        match &self.shape {
            Shape::Uniform(grid) => grid.rectangle.size,
            Shape::Described(described) => described.size,
        }
    }

    /// What it covers, mirror images included; pairs that are described one by one lie about the origin.
    pub fn rectangle(&self) -> Rectangle {
        match &self.shape {
            Shape::Uniform(grid) => grid.rectangle,
            Shape::Described(described) => described.size.into(),
        }
    }

    /// Number of pairs along x and y; all along x where they form no grid.
    pub fn elements(&self) -> [usize; 2] {
        match &self.shape {
            Shape::Uniform(grid) => grid.elements,
            Shape::Described(described) => described.pairs.elements.unwrap_or([self.len(), 1]),
        }
    }

    /// Size of an element along x and y (m); on frames that are not uniform, the side of a square of the mean
    /// area of a pair.
    pub fn spacing(&self) -> [f64; 2] {
        match &self.shape {
            Shape::Uniform(grid) => grid.spacing(),
            Shape::Described(_) => [self.measure().side; 2],
        }
    }

    /// Area of an element (m^2); on frames that are not uniform, the mean area of a pair and its images.
    pub fn element_area(&self) -> f64 {
        match &self.shape {
            Shape::Uniform(grid) => {
                let [dx, dy] = grid.spacing();
                dx * dy
            }
            Shape::Described(described) => described.area,
        }
    }

    /// How the pairs count in sums.
    pub fn measure(&self) -> Measure<'_> {
        let area = self.element_area();
        match &self.shape {
            Shape::Uniform(grid) => {
                let (closed, even) = (grid.closed, Measure::even(area));
                let closing = match &*self.closing {
                    [] => even.closing,
                    closing => Values::Each(closing),
                };
                let even = Measure { closed, closing, ..even };
                if grid.line { Measure { side: grid.spacing()[0], ..even } } else { even }
            }
            Shape::Described(described) => {
                let closing = match &*described.closing {
                    [] => Values::All(1.0),
                    closing => Values::Each(closing),
                };
                let images: f64 = described
                    .pairs
                    .mirrored
                    .map(|mirrored| if mirrored { 2.0 } else { 1.0 })
                    .iter()
                    .product();
                let weight = Values::Each(&described.weights);
                let closed = described.pairs.closed;
                Measure { area, weight, closing, side: (area / images).sqrt(), closed }
            }
        }
    }

    /// Gap of the undeformed, unworn bodies at first touch (m), one value a pair.
    pub fn gap(&self) -> &[f64] {
        &self.gap
    }

    /// Where a pair is along x and y (m).
    pub fn place(&self, pair: usize) -> [f64; 2] {
        match &self.shape {
            Shape::Uniform(grid) => grid.place(pair),
            Shape::Described(described) => {
                let [x, y, _] = described.pairs.places[pair];
                [x, y]
            }
        }
    }

    /// How high a pair lies along z (m).
    pub fn height(&self, pair: usize) -> f64 {
        match &self.shape {
            Shape::Uniform(_) => 0.0,
            Shape::Described(described) => described.pairs.places[pair][2],
        }
    }

    /// Area (m^2) of a pair and its mirror images.
    pub fn area(&self, pair: usize) -> f64 {
        match &self.shape {
            Shape::Uniform(_) => self.element_area(),
            Shape::Described(described) => described.pairs.areas[pair],
        }
    }

    /// How much of the approach closes the gap of a pair.
    pub fn closing(&self, pair: usize) -> f64 {
        self.measure().closing.at(pair)
    }

    /// One of the largest pairs: the middle one of a uniform frame, otherwise that nearest to the centre.
    pub fn largest(&self) -> usize {
        match &self.shape {
            Shape::Uniform(Grid { elements: [nx, ny], .. }) => nx / 2 + nx * (ny / 2),
            Shape::Described(described) => described.largest,
        }
    }

    /// The place (m) at which values at the centre are read: the middle of the frame, before it grew.
    pub fn centre(&self) -> [f64; 2] {
        match &self.shape {
            Shape::Uniform(grid) => grid.centre(),
            Shape::Described(_) => [0.0; 2],
        }
    }

    /// Value of a field at the frame's centre, in the field's unit: the pair's own where one sits
    /// there, otherwise the mean of the two or four around it, corrected for curvature by their next
    /// neighbours unless the field vanishes at one of those, as pressures do outside a contact. On frames
    /// that are not uniform a parabola is fitted to the pairs around the centre and their mirror images.
    pub fn at_centre(&self, field: &[f64]) -> f64 {
        let grid = match &self.shape {
            Shape::Uniform(grid) => grid,
            Shape::Described(described) => return described.centre.value(field),
        };
        grid.at_centre(field)
    }
}

/// How far (m) profiles are apart at a pair of a grid.
fn undeformed(grid: &Grid, profiles: [&dyn Profile; 2], pair: usize) -> f64 {
    let [x, y] = grid.place(pair);
    match grid.wrap {
        Some(wrap) => wrap.gap([x, y]),
        None => profiles.iter().map(|profile| profile.recess(x, y)).sum(),
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::ContactFrame;
    use crate::body::profile::Flat;

    #[test]
    fn all_pairs_of_a_closed_frame_may_touch() {
        let frame = ContactFrame::uniform([2.0, 1.0], [4, 2], [&Flat, &Flat]).unwrap();
        assert!(!frame.measure().closed);
        assert!(frame.closed().measure().closed);
    }

    #[test]
    fn the_centre_of_a_smooth_field_is_exact_for_cubics() {
        for elements in [[5, 5], [6, 5], [5, 6], [4, 8]] {
            let frame = ContactFrame::uniform([2.0, 1.0], elements, [&Flat, &Flat]).unwrap();
            let cubic = |[x, y]: [f64; 2]| 3.0 + x - 2.0 * y + x * y + x * x - y * y * y;
            let field: Vec<f64> = (0..frame.len()).map(|pair| cubic(frame.place(pair))).collect();
            assert_relative_eq!(frame.at_centre(&field), 3.0, epsilon = 1e-13);
        }
    }
}
