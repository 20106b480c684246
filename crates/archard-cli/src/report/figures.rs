//! Panels as the page shows them: a picture, traces and axes for plotly.js, and words for who cannot see them.

use std::fs;
use std::path::Path;

use anyhow::Result;
use archard_case::files::{self, Contents};
use kuva::plot::ColorMap;
use serde_json::{Value, json};

use super::html::{Html, fill};
use super::words::plain;
use crate::plot::draw::{Still, still};
use crate::plot::figure::{Contours, Map, Mark, Panel, Parts, Pen, Points, Shape};
use archard::numerics::SAME;

/// Most points of a curve: more cannot be told apart on a page.
const MOST: usize = 1500;
/// Bytes of the largest picture of a folder that a page takes. A choice of size.
const LARGEST: u64 = 4_000_000;

/// A figure: its picture, what draws it where scripts run, and what it shows in words.
#[derive(Debug)]
pub(super) struct Figure {
    title: String,
    words: String,
    data: Vec<Value>,
    layout: Value,
    still: Still,
}

impl Figure {
    /// A picture that the script draws of something else than a panel.
    pub(super) fn pictured(panel: &Panel, words: String) -> Result<Self> {
        let still = still(panel)?;
        Ok(Self { title: panel.title.clone(), words, data: vec![], layout: Value::Null, still })
    }

    /// A picture of a file.
    fn file(title: &str, words: &str, still: Still) -> Self {
        let [title, words] = [title, words].map(str::to_owned);
        Self { title, words, data: vec![], layout: Value::Null, still }
    }

    /// The first picture of a folder that there is and that is not too large for a page, by name and kind. It is shown as an
    /// image, in which nothing runs.
    pub(super) fn in_folder(
        dir: &Path,
        pictures: &[(&str, &'static str)],
        [title, words]: [&str; 2],
    ) -> Option<Self> {
        let small = |path: &Path| fs::metadata(path).is_ok_and(|file| file.len() < LARGEST);
        let read = |(name, kind): &(&str, &'static str)| {
            let path = dir.join(name);
            let bytes =
                small(&path).then(|| files::read(&path, Contents::Numbers).ok()).flatten()?;
            Some(Still { kind, bytes })
        };
        pictures.iter().find_map(read).map(|still| Self::file(title, words, still))
    }

    /// The figure without anything for a script to draw.
    pub(super) fn alone(&self) -> Html {
        let Self { title, words, .. } = self;
        fill(
            "<figure>\n<h3>{}</h3>\n{}\n<figcaption>{}</figcaption>\n</figure>\n",
            &[title, &self.picture("still"), words],
        )
    }

    /// What plotly.js draws.
    pub(super) fn json(&self) -> Value {
        json!({ "data": self.data, "layout": self.layout })
    }

    /// The picture alone, as it stands on the first screen.
    pub(super) fn small(&self) -> Html {
        fill(
            "<figure class=\"glance\">{}<figcaption>{}</figcaption></figure>\n",
            &[&self.picture("still"), &self.title],
        )
    }

    fn picture(&self, class: &'static str) -> Html {
        let Still { kind, bytes } = &self.still;
        fill(
            "<img class=\"{}\" alt=\"{}. {}\" src=\"data:{};base64,{}\">",
            &[&class, &self.title, &self.words, kind, &Html::packed(bytes)],
        )
    }

    /// A panel as a figure.
    pub(super) fn of(panel: &Panel) -> Result<Self> {
        let [x, y] = &panel.labels;
        let view = &panel.view;
        let mut layout = json!({
            "xaxis": axis(x, view.ends[0]),
            "yaxis": axis(y, view.ends[1]),
            "showlegend": panel.marks.iter().any(|mark| mark.legend.is_some()),
        });
        if let Some(title) = &view.legend_title {
            layout["legend"] = json!({ "title": { "text": title } });
        }
        for (axis, names) in ["xaxis", "yaxis"].into_iter().zip(&view.steps) {
            if !names.is_empty() {
                let places: Vec<usize> = (1..=names.len()).collect();
                layout[axis]["tickmode"] = json!("array");
                layout[axis]["tickvals"] = json!(places);
                layout[axis]["ticktext"] = json!(names);
            }
        }
        if view.to_scale {
            layout["yaxis"]["scaleanchor"] = json!("x");
        }
        let note = |(words, [x, y], colour): &(String, [f64; 2], &str)| json!({ "text": words, "x": x, "y": y, "showarrow": false, "font": { "color": colour } });
        layout["annotations"] = view.notes.iter().map(note).collect();
        Ok(Self {
            title: panel.title.clone(),
            words: words(panel),
            data: panel.marks.iter().flat_map(traces).collect(),
            layout,
            still: still(panel)?,
        })
    }
}

/// The place of a figure: its picture, which gives way to what the script draws.
pub(super) fn drawn(id: &str, figure: &Figure) -> Html {
    let Figure { title, words, .. } = figure;
    fill(
        "<figure>\n<h3>{}</h3>\n<div class=\"plot\" id=\"{}\" role=\"img\" aria-label=\"{}. {}\"></div>\n{}\n\
         <figcaption>{}</figcaption>\n</figure>\n",
        &[title, &id, title, words, &figure.picture("still"), words],
    )
}

/// An axis with its label; ends that are not given follow from what is drawn.
fn axis(label: &str, [low, high]: [Option<f64>; 2]) -> Value {
    match (low, high) {
        (None, None) => json!({ "title": { "text": label } }),
        (low, high) => json!({
            "title": { "text": label },
            "autorangeoptions": { "minallowed": low, "maxallowed": high, "include": [low, high] },
        }),
    }
}

/// Colours that elements are filled with.
const SHADES: usize = 32;

/// What is drawn of a mark: elements are filled shade by shade.
fn traces(mark: &Mark) -> Vec<Value> {
    let Shape::Parts(Parts { parts, .. }) = &mark.shape else { return vec![trace(mark)] };
    let most = parts.iter().map(|(_, value)| *value).fold(0.0, f64::max);
    let shade = |value: f64| ((value / most * SHADES as f64) as usize).min(SHADES - 1);
    let mut shades: Vec<[Vec<Value>; 2]> = vec![[vec![], vec![]]; SHADES];
    for (corners, value) in parts.iter().filter(|(_, value)| *value > 0.0) {
        let [x, y] = &mut shades[shade(*value)];
        for corner in corners.iter().chain(corners.first()) {
            x.push(json!(rounded(corner[0])));
            y.push(json!(rounded(corner[1])));
        }
        x.push(Value::Null);
        y.push(Value::Null);
    }
    let filled = shades.into_iter().enumerate().filter(|(_, [x, _])| !x.is_empty());
    let filled = filled.map(|(index, [x, y])| {
        let colour = ColorMap::Viridis.map((index as f64 + 0.5) / SHADES as f64);
        json!({
            "type": "scatter", "mode": "lines", "x": x, "y": y, "fill": "toself", "fillcolor": colour,
            "line": { "width": 0.4, "color": colour }, "hoverinfo": "skip", "showlegend": false,
        })
    });
    let bar = json!({
        "type": "scatter", "mode": "markers", "x": [null], "y": [null], "showlegend": false,
        "marker": { "color": [0.0], "cmin": 0.0, "cmax": rounded(most), "colorscale": "Viridis", "showscale": true },
    });
    filled.chain([bar]).collect()
}

fn trace(Mark { shape, legend }: &Mark) -> Value {
    let mut trace = match shape {
        Shape::Line(points, Pen { colour, width }) => {
            let (x, y) = columns(points);
            let width = 0.8 * width;
            json!({ "type": "scatter", "mode": "lines", "x": x, "y": y, "line": { "color": colour, "width": width } })
        }
        Shape::Dots(points, colour) => {
            let (x, y) = columns(points);
            json!({ "type": "scatter", "mode": "markers", "x": x, "y": y, "marker": { "color": colour, "size": 6 } })
        }
        Shape::Band { places, colour, opacity } => {
            let forth = places.iter().map(|[x, low, _]| (*x, *low));
            let back = places.iter().rev().map(|[x, _, high]| (*x, *high));
            let points: Points = forth.chain(back).collect();
            let x: Vec<f64> = points.iter().map(|point| rounded(point.0)).collect();
            let y: Vec<f64> = points.iter().map(|point| rounded(point.1)).collect();
            json!({
                "type": "scatter", "mode": "lines", "x": x, "y": y, "fill": "toself", "fillcolor": colour,
                "opacity": opacity, "line": { "width": 0 }, "hoverinfo": "skip",
            })
        }
        // Drawn in several traces.
        Shape::Parts(_) => Value::Null,
        Shape::Contours(Contours { places: [x, y], rows, levels }) => {
            let z: Vec<Vec<Value>> =
                rows.iter().map(|row| row.iter().map(|value| number(*value)).collect()).collect();
            let [x, y] = [x, y].map(|own| own.iter().map(|own| rounded(*own)).collect::<Vec<_>>());
            let step = levels.windows(2).map(|ends| ends[1] - ends[0]).next().unwrap_or(1.0);
            let contours = json!({
                "start": levels.first(), "end": levels.last(), "size": rounded(step), "showlabels": true,
            });
            json!({
                "type": "contour", "colorscale": "Viridis", "x": x, "y": y, "z": z, "contours": contours,
                "line": { "color": "#ffffff", "width": 0.8 },
            })
        }
        Shape::Map(Map { edges: [x, y], rows }) => {
            let places = |[low, high]: [f64; 2], count: usize| -> Vec<f64> {
                let step = (high - low) / count.max(1) as f64;
                (0..count).map(|i| rounded(low + (i as f64 + 0.5) * step)).collect()
            };
            let cell =
                |value: &f64| if *value > 0.0 { json!(rounded(*value)) } else { Value::Null };
            let z: Vec<Vec<Value>> =
                rows.iter().map(|row| row.iter().map(cell).collect()).collect();
            json!({
                "type": "heatmap", "colorscale": "Viridis", "z": z,
                "x": places(*x, rows.first().map_or(0, Vec::len)), "y": places(*y, rows.len()),
            })
        }
    };
    trace["showlegend"] = json!(legend.is_some());
    if let Some(legend) = legend {
        trace["name"] = json!(legend);
    }
    trace
}

/// Places and values of points, no more than can be told apart.
fn columns(points: &Points) -> (Vec<f64>, Vec<Value>) {
    let every = points.len().div_ceil(MOST).max(1);
    let last = points.len().saturating_sub(1);
    let shown = points.iter().enumerate().filter(|(place, _)| place % every == 0 || *place == last);
    shown.map(|(_, (x, y))| (rounded(*x), number(*y))).unzip()
}

/// A number, or nothing where none exists.
fn number(value: f64) -> Value {
    if value.is_finite() { json!(rounded(value)) } else { Value::Null }
}

/// Six digits, which is more than a page shows.
pub(super) fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

/// What a panel shows, in words: its curves with their ends.
fn words(panel: &Panel) -> String {
    let [x, y] = &panel.labels;
    let mut parts = Vec::new();
    let told = panel.marks.iter().flat_map(|mark| match &mark.shape {
        Shape::Line(points, _) | Shape::Dots(points, _) => &points[..],
        _ => &[],
    });
    let sizes = told.map(|point| point.1.abs()).filter(|size| size.is_finite());
    let nothing = SAME * sizes.fold(0.0, f64::max);
    let plain = |value: f64| plain(if value.abs() > nothing { value } else { 0.0 });
    for Mark { shape, legend } in &panel.marks {
        let (Some(legend), Shape::Line(points, _) | Shape::Dots(points, _)) = (legend, shape)
        else {
            continue;
        };
        let finite = || points.iter().filter(|point| point.1.is_finite());
        let (Some(first), Some(last)) = (finite().next(), finite().next_back()) else { continue };
        let high = finite().map(|point| point.1).fold(f64::NEG_INFINITY, f64::max);
        let most = if high > first.1.max(last.1) + 1e-3 * high.abs() {
            format!(", at most {}", plain(high))
        } else {
            String::new()
        };
        parts.push(format!("{legend}: from {} to {}{most}", plain(first.1), plain(last.1)));
    }
    // Many sections begin and end equally: their values are seen, not told.
    if parts.len() > 4 {
        return format!("{y} over {x}, {} curves.", parts.len());
    }
    let curves = if parts.is_empty() { String::new() } else { format!(" {}.", parts.join("; ")) };
    format!("{y} over {x}.{curves}")
}

#[cfg(test)]
mod tests {
    use super::words;
    use crate::plot::figure::{Curves, Pen};

    #[test]
    fn rounding_is_no_number_of_a_curve() {
        let mut curves = Curves::new();
        curves.add([(0.0, 0.0), (1.0, 2.5), (0.0, 4.2e-16)], Pen::line("red"), Some("cycle 1"));
        let panel = curves.panel(["Loop", "Shift", "Force"], |view| view);
        assert_eq!(words(&panel), "Force over Shift. cycle 1: from 0 to 0, at most 2.5.");
    }
}
