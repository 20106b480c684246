//! Pictures as data, for who draws them by other means. Numbers that are none are null.

use serde_json::{Value, json};

use super::Picture;
use super::figure::{Contours, LegendPosition, Map, Mark, Panel, Parts, Points, Shape, View};

impl Picture {
    /// The picture: its name, how many panels stand side by side, the size (px) of a panel, and the panels.
    pub(crate) fn json(&self) -> Value {
        let panels: Vec<Value> = self.panels.iter().map(panel).collect();
        json!({ "name": self.name, "columns": self.columns, "size": self.size, "panels": panels })
    }
}

fn panel(Panel { title, labels, marks, view }: &Panel) -> Value {
    let View { ends, legend, legend_title, notes, to_scale, named, steps, log } = view;
    let legend = match legend {
        LegendPosition::OutsideRightTop => "outside",
        LegendPosition::InsideTopLeft => "upper left",
        LegendPosition::InsideBottomRight => "lower right",
    };
    json!({
        "title": title, "labels": labels, "marks": marks.iter().map(mark).collect::<Vec<_>>(), "ends": ends,
        "legend": legend, "legend_title": legend_title, "notes": notes, "to_scale": to_scale, "named": named,
        "steps": steps, "log": log,
    })
}

fn mark(Mark { shape, legend }: &Mark) -> Value {
    let mut told = match shape {
        Shape::Line(points, pen) => {
            json!({ "line": places(points), "colour": pen.colour, "width": pen.width })
        }
        Shape::Dots(points, colour) => json!({ "dots": places(points), "colour": colour }),
        Shape::Band { places, colour, opacity } => {
            let of = |index: usize| places.iter().map(|place| place[index]).collect::<Vec<_>>();
            json!({ "band": [of(0), of(1), of(2)], "colour": colour, "opacity": opacity })
        }
        Shape::Map(Map { edges, rows }) => json!({ "map": rows, "edges": edges }),
        Shape::Parts(Parts { edges, parts }) => json!({ "parts": parts, "edges": edges }),
        Shape::Contours(Contours { places, rows, levels }) => {
            json!({ "contours": rows, "places": places, "levels": levels })
        }
    };
    told["legend"] = json!(legend);
    told
}

/// Places along x, and values there.
fn places(points: &Points) -> [Vec<f64>; 2] {
    points.iter().copied().unzip().into()
}
