//! Elements of a mesh on a picture, each with its own outline.
//!
//! The library that draws knows maps of equal cells. A map of two cells stands for the elements while axes and the bar of
//! colours are laid out; its cells are then replaced by the elements.

use kuva::plot::ColorMap;
use kuva::render::color::Color;
use kuva::render::render::{PathData, Primitive, Scene};

use super::figure::Parts;

/// What the library adds to cells to hide the gaps between them (px), and so the width of the line around an element in its own
/// colour.
const ADDED: f64 = 0.5;

impl Parts {
    /// The largest value.
    fn most(&self) -> f64 {
        self.parts.iter().map(|(_, value)| *value).fold(0.0, f64::max)
    }

    /// The rows of the map that stands for them.
    pub(super) fn stand_in(&self) -> [[f64; 2]; 1] {
        [[0.0, self.most()]]
    }
}

/// The colour of a value relative to the largest: none for none.
pub(super) fn colour(share: f64) -> String {
    if share > 0.0 { ColorMap::Viridis.map(share) } else { "#ffffff".to_owned() }
}

/// Black or white: what is read on the colour of a value relative to the largest. Viridis becomes brighter all the way, and passes the
/// relative luminance of .18, on which both are read as well (WCAG 2.2), half way.
pub(super) fn ink(share: f64) -> &'static str {
    if share > 0.0 && share < 0.5 { "#ffffff" } else { "#000000" }
}

/// The same of the lowest value too: none for what is no number.
pub(super) fn colour_of_any(share: f64) -> String {
    if share.is_nan() { "#ffffff".to_owned() } else { ColorMap::Viridis.map(share) }
}

/// Replaces the maps that stand for elements, in the order of their panels.
pub(super) fn put(scene: &mut Scene, all: &[&Parts]) {
    let mut all = all.iter();
    let elements = std::mem::take(&mut scene.elements);
    for element in elements {
        match &element {
            Primitive::RectBatch { x, y, h, .. } if x.len() == 2 => match all.next() {
                Some(parts) => scene.elements.extend(drawn(parts, [x[0], x[1]], [y[0], h[0]])),
                None => scene.elements.push(element),
            },
            _ => scene.elements.push(element),
        }
    }
}

/// The elements of a picture whose map began and was halved there along x, and began and was as high along y (px).
fn drawn(parts: &Parts, [left, middle]: [f64; 2], [top, height]: [f64; 2]) -> Vec<Primitive> {
    let [[low_x, high_x], [low_y, high_y]] = parts.edges;
    let across = 2.0 * (middle - left) / (high_x - low_x);
    let up = (height - ADDED) / (high_y - low_y);
    let most = parts.most();
    let shown = parts.parts.iter().filter(|(corners, value)| *value != 0.0 && corners.len() > 2);
    shown
        .map(|(corners, value)| {
            let place = |[x, y]: &[f64; 2]| {
                format!("{:.2},{:.2}", left + across * (x - low_x), top + up * (high_y - y))
            };
            let corners: Vec<String> = corners.iter().map(place).collect();
            let fill = Color::from(colour(value / most));
            Primitive::Path(Box::new(PathData {
                d: format!("M{} Z", corners.join(" L")),
                fill: Some(fill.clone()),
                stroke: fill,
                stroke_width: ADDED,
                opacity: None,
                stroke_dasharray: None,
            }))
        })
        .collect()
}
