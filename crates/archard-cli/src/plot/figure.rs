//! How the pictures look, and how they become files.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use anyhow::Context;
use kuva::backend::svg::SvgBackend;
use kuva::plot::{ColorMap, LinePlot, ScatterPlot};
use kuva::render::figure::Figure;
use kuva::render::layout::{Layout, TickFormat};
use kuva::render::plots::Plot;

use super::raster;
use super::scale::tick;

/// Width of a PNG (px).
const PNG_WIDTH: f64 = 1600.0;

/// Black, blue and vermilion of M. Okabe and K. Ito, *Color Universal Design* (2008): told apart
/// with any colour vision.
pub(super) const COLOURS: [&str; 3] = ["#000000", "#0072b2", "#d55e00"];
/// The same, pale: for what lies below.
pub(super) const PALE: [&str; 3] = ["#bdbdbd", "#9ad0f5", "#f5c19a"];

/// Curves or a map between two axes.
pub(super) struct Panel {
    plots: Vec<Plot>,
    layout: Layout,
}

/// Curves between two axes.
pub(super) struct Curves {
    plots: Vec<Plot>,
}

/// How a curve is drawn. Curves are told apart by width as well as colour, so that one on top of
/// another leaves both to be seen.
pub(super) struct Pen {
    /// As `#rrggbb`.
    colour: String,
    /// Width of the line (px).
    width: f64,
}

impl Pen {
    /// The usual line.
    pub(super) fn line(colour: impl Into<String>) -> Self {
        Self { colour: colour.into(), width: 2.2 }
    }

    /// A line under a usual one.
    pub(super) fn broad(colour: impl Into<String>) -> Self {
        Self { colour: colour.into(), width: 5.0 }
    }

    /// A band under everything else.
    pub(super) fn under(colour: impl Into<String>) -> Self {
        Self { colour: colour.into(), width: 7.0 }
    }

    /// A line through some points.
    pub(super) fn draw(self, points: impl IntoIterator<Item = (f64, f64)>) -> Plot {
        self.through(points).into()
    }

    fn through(self, points: impl IntoIterator<Item = (f64, f64)>) -> LinePlot {
        let points: Vec<(f64, f64)> = points.into_iter().collect();
        LinePlot::new().with_data(points).with_color(self.colour).with_stroke_width(self.width)
    }

    /// The pale band of a closed form, under whatever was computed.
    pub(super) fn closed_form() -> Self {
        Self::under(PALE[0])
    }
}

/// The colour of one of several moments of a run, from light at its start to dark at its end.
pub(super) fn moment(index: usize, count: usize) -> String {
    let share = if count > 1 { index as f64 / (count - 1) as f64 } else { 1.0 };
    // The yellow end of the map is lost on white paper.
    ColorMap::Viridis.map(0.82 * (1.0 - share))
}

impl Curves {
    /// No curves yet.
    pub(super) fn new() -> Self {
        Self { plots: Vec::new() }
    }

    /// Adds a curve; only one with a legend appears there.
    pub(super) fn add(
        &mut self,
        points: impl IntoIterator<Item = (f64, f64)>,
        pen: Pen,
        legend: Option<&str>,
    ) {
        let mut line = pen.through(points);
        if let Some(legend) = legend {
            line = line.with_legend(legend);
        }
        self.plots.push(line.into());
    }

    /// Adds points without a line between them; only some with a legend appear there.
    pub(super) fn mark(
        &mut self,
        points: impl IntoIterator<Item = (f64, f64)>,
        colour: &str,
        legend: Option<&str>,
    ) {
        let points: Vec<(f64, f64)> = points.into_iter().collect();
        let mut marks = ScatterPlot::new().with_data(points).with_color(colour).with_size(5.0);
        if let Some(legend) = legend {
            marks = marks.with_legend(legend);
        }
        self.plots.push(marks.into());
    }

    /// The curves alone.
    pub(super) fn into_plots(self) -> Vec<Plot> {
        self.plots
    }

    /// The panel with these curves; `adapt` changes what is particular to it.
    pub(super) fn panel(
        self,
        [title, x, y]: [&str; 3],
        adapt: impl FnOnce(Layout) -> Layout,
    ) -> Panel {
        Panel::new(self.plots, [title, x, y], |layout| adapt(layout.with_legend_box(false)))
    }
}

impl Panel {
    /// A panel of plots with its title and the labels of its axes; `adapt` changes what is particular to it.
    pub(super) fn new(
        plots: Vec<Plot>,
        [title, x, y]: [&str; 3],
        adapt: impl FnOnce(Layout) -> Layout,
    ) -> Self {
        let layout = Layout::auto_from_plots(&plots)
            .with_title(title)
            .with_x_label(x)
            .with_y_label(y)
            .with_title_size(18)
            .with_label_size(16)
            .with_tick_size(14)
            .with_body_size(14)
            .with_tick_format(TickFormat::Custom(Arc::new(tick)));
        Self { plots, layout: adapt(layout) }
    }
}

/// Writes panels in that many columns, each of that size (px), as `path.svg` and `path.png`, below a mark if there is
/// one.
pub(super) fn save(
    path: &Path,
    columns: usize,
    [width, height]: [f64; 2],
    (panels, mark): (Vec<Panel>, Option<&str>),
) -> anyhow::Result<[PathBuf; 2]> {
    let rows = panels.len().div_ceil(columns);
    let several = panels.len() > 1;
    let (plots, layouts) = panels.into_iter().map(|panel| (panel.plots, panel.layout)).unzip();
    let mut figure = Figure::new(rows, columns)
        .with_cell_size(width, height)
        .with_plots(plots)
        .with_layouts(layouts);
    if let Some(mark) = mark {
        figure = figure.with_title(mark).with_title_size(20);
    }
    if several {
        figure = figure.with_labels_lowercase();
    }
    let scene = figure.render();
    let svg = SvgBackend::new().render_scene(&scene);
    let png = raster::png(&scene, PNG_WIDTH)
        .with_context(|| format!("cannot draw `{}.png`", path.display()))?;
    let files = [path.with_extension("svg"), path.with_extension("png")];
    for (file, bytes) in files.iter().zip([svg.as_bytes(), &png]) {
        fs::write(file, bytes).with_context(|| format!("cannot write `{}`", file.display()))?;
    }
    Ok(files)
}
