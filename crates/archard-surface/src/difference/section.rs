//! The section across a scar, before and after.

use super::Difference;
use super::sample::Spline;
use crate::level::Level;
use crate::map::HeightMap;

/// A point of a section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionPoint {
    /// Place (m) from the deepest point, across the scar.
    pub place: f64,
    /// Height (m) of the earlier surface above its own plane.
    pub before: f64,
    /// Height (m) of the later one above the same plane, laid on the earlier one.
    pub after: f64,
}

impl Difference {
    /// The section across the largest scar through the deepest point, from rim to rim; `before` is the earlier map.
    pub fn section(&self, before: &HeightMap) -> Vec<SectionPoint> {
        let flat = before.levelled(Level::Plane).unwrap_or_else(|_| before.clone());
        let [change, before] = [&self.change, &flat].map(Spline::of);
        let across = self.scar.direction + std::f64::consts::FRAC_PI_2;
        let (sine, cosine) = across.sin_cos();
        let step = self.change.pixel()[0].min(self.change.pixel()[1]);
        let reach = self.change.size()[0].hypot(self.change.size()[1]) / step;
        let point = |index: i64| {
            let place = step * index as f64;
            let on_map = [self.deepest[0] + place * cosine, self.deepest[1] + place * sine];
            let (depth, _) = change.at(on_map)?;
            let (height, _) = before.at(self.placement.on_the_earlier(on_map))?;
            Some(SectionPoint { place, before: height, after: height + depth })
        };
        (-(reach as i64)..=reach as i64).filter_map(point).collect()
    }
}
