//! What is worn between two scans, as a picture: the map of depths with the section below it.

use super::Compared;
use crate::plot::cells::Cells;
use crate::plot::figure::{COLOURS, Curves, Map, Panel, Pen, View};
use crate::plot::scale::Unit;
use crate::plot::{Picture, SLENDER};

impl Compared<'_> {
    pub(super) fn picture(&self) -> Picture {
        Picture::new("difference", vec![self.map(), self.across()]).stacked()
    }

    fn map(&self) -> Panel {
        let image = self.image();
        let windows = [0, 1].map(|axis| {
            let end = -image.origin[axis];
            [-end, end]
        });
        let cells = Cells::of(&image, &self.depths(), windows);
        let across = Unit::across(windows[0][1].max(windows[1][1]));
        let depth = Unit::depth(self.found.depth.value.abs());
        let edges = cells.edges.map(|edges| edges.map(|edge| edge * across.factor));
        let scaled = |row: Vec<f64>| row.into_iter().map(|own| own * depth.factor).collect();
        let rows = cells.rows.into_iter().map(scaled).collect();
        let mut curves = Curves::new();
        curves.map(Map { edges, rows });
        curves.add(self.line(across.factor), Pen::line(COLOURS[2]), None);
        let title = format!("{}, section marked", depth.label("Worn depth"));
        let labels = [&*title, &across.label("x"), &across.label("y")];
        let [one, other] = windows.map(|[low, high]| high - low);
        let to_scale = one.max(other) <= SLENDER * one.min(other);
        curves.panel(labels, |view| View { to_scale, ..view })
    }

    /// The ends of the section, on the map.
    fn line(&self, factor: f64) -> Vec<(f64, f64)> {
        let across = self.found.scar.direction + std::f64::consts::FRAC_PI_2;
        let place = |far: f64| {
            let [x, y] = self.found.deepest;
            ((x + far * across.cos()) * factor, (y + far * across.sin()) * factor)
        };
        let ends = [self.section.first(), self.section.last()];
        ends.into_iter().flatten().map(|point| place(point.place)).collect()
    }

    fn across(&self) -> Panel {
        let reach = self.section.iter().map(|point| point.place.abs()).fold(0.0, f64::max);
        let heights = self.section.iter().flat_map(|point| [point.before, point.after]);
        let most = heights.map(f64::abs).fold(0.0, f64::max);
        let (across, height) = (Unit::across(reach), Unit::depth(most));
        let mut curves = Curves::new();
        let scaled = |place: f64, own: f64| (place * across.factor, own * height.factor);
        let before = self.section.iter().map(|point| scaled(point.place, point.before));
        curves.add(before, Pen::line(COLOURS[0]), Some("before"));
        let after = self.section.iter().map(|point| scaled(point.place, point.after));
        curves.add(after, Pen::line(COLOURS[2]), Some("after"));
        let labels = ["Section across the scar", &*across.label("Place"), &*height.label("Height")];
        curves.panel(labels, |view| view)
    }
}
