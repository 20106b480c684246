//! Panels as files, drawn by `kuva`.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use anyhow::{Context, anyhow};
use archard_case::output::Place;
#[cfg(feature = "pdf")]
use kuva::backend::pdf::{PageSize, PdfBackend};
use kuva::backend::svg::SvgBackend;
use kuva::plot::{self, BandPlot, ColorMap, ContourPlot, Heatmap, LinePlot, ScatterPlot};
use kuva::render::annotations::TextAnnotation;
use kuva::render::color::Color;
use kuva::render::figure::Figure;
use kuva::render::layout::{Layout, TickFormat};
use kuva::render::plots::Plot;

use super::figure::{Contours, LegendPosition, Map, Mark, Panel, Parts, Shape, View};
use super::parts::{self, colour};
use super::raster;
use super::scale::{tick, tick_of_decades};
use kuva::render::render::{Primitive, Scene};

/// Width of a PNG (px).
const PNG_WIDTH: f64 = 1600.0;

/// The size (px) of panels, how many stand side by side, and what the files are for.
pub(crate) struct Sheet<'a> {
    pub(crate) columns: usize,
    pub(crate) size: [f64; 2],
    pub(crate) paper: &'a Paper,
}

/// What pictures are drawn for.
#[derive(Debug, Clone, Default)]
pub(crate) struct Paper {
    /// The width they fill; that of a screen if not given.
    pub(crate) width: Option<Width>,
    /// Kinds of files; SVG and PNG if none is named.
    pub(crate) formats: Vec<Format>,
}

/// The width of a picture in print, with letters of about eight points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Width {
    /// A column of a journal, 85 mm
    Column,
    /// A page of a journal, 175 mm
    Page,
}

/// A kind of file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// Scalable, for browsers and drawing programs
    Svg,
    /// Pixels, 600 dpi where a width in print is given
    Png,
    /// Scalable, for LaTeX and print
    Pdf,
}

impl Width {
    /// The width (mm).
    fn millimetres(self) -> f64 {
        match self {
            Width::Column => 85.0,
            Width::Page => 175.0,
        }
    }

    /// Panels side by side: one, or two.
    fn columns(self) -> usize {
        match self {
            Width::Column => 1,
            Width::Page => 2,
        }
    }
}

impl Format {
    fn extension(self) -> &'static str {
        match self {
            Format::Svg => "svg",
            Format::Png => "png",
            Format::Pdf => "pdf",
        }
    }
}

/// Pixels that 85 mm have while a picture is laid out: letters of 16 px are printed with eight points.
const COLUMN: f64 = 480.0;
/// Dots per millimetre of a PNG for print.
const DOTS: f64 = 600.0 / 25.4;
/// Points (1/72 inch) per millimetre.
#[cfg(feature = "pdf")]
const POINTS: f64 = 72.0 / 25.4;

/// Writes panels as `path.svg` and so on, below a mark if there is one; returns the files.
pub(crate) fn save(
    path: &Path,
    sheet: &Sheet<'_>,
    (panels, mark): (Vec<Panel>, Option<&str>),
) -> anyhow::Result<Vec<PathBuf>> {
    let width = sheet.paper.width;
    let columns = width.map_or(sheet.columns, |width| width.columns()).min(panels.len()).max(1);
    let [across, up] = match width {
        None => sheet.size,
        Some(width) => {
            let across = COLUMN * width.millimetres() / 85.0 / width.columns() as f64;
            [across, across * sheet.size[1] / sheet.size[0]]
        }
    };
    let scene = scene(&panels, (columns, [across, up]), mark);
    let draw = |(format, place): (Format, Place)| {
        let millimetres =
            width.map(|width| width.millimetres() * columns as f64 / width.columns() as f64);
        let bytes = match format {
            Format::Svg => Ok((svg(&scene, millimetres) + SIGNED_SVG).into_bytes()),
            Format::Png => raster::png(&scene, millimetres.map_or(PNG_WIDTH, |mm| mm * DOTS)),
            Format::Pdf => pdf(&scene, millimetres).map(|pdf| [&pdf, SIGNED_PDF].concat()),
        };
        Ok((bytes.with_context(|| format!("cannot draw `{}`", place.path().display()))?, place))
    };
    // All are drawn before one is written.
    let drawn = places(path, sheet.paper)?.into_iter().map(draw);
    let drawn: Vec<(Vec<u8>, Place)> = drawn.collect::<anyhow::Result<_>>()?;
    drawn.iter().try_for_each(|(bytes, place)| place.write(bytes))?;
    Ok(drawn.into_iter().map(|(_, place)| place.into_path()).collect())
}

/// How an SVG of this program ends.
const SIGNED_SVG: &str = "<!-- archard -->\n";
/// How a PDF of this program ends.
const SIGNED_PDF: &[u8] = b"\n% archard\n";

/// The places of a picture, each with its format: free, or those of other pictures of this program.
///
/// # Errors
/// If other files stand there.
pub(crate) fn places(path: &Path, paper: &Paper) -> anyhow::Result<Vec<(Format, Place)>> {
    let both = [Format::Svg, Format::Png];
    let formats = if paper.formats.is_empty() { &both[..] } else { &paper.formats };
    let place = |format: &Format| {
        let is_ours = |known: &[u8]| match format {
            Format::Svg => known.ends_with(SIGNED_SVG.as_bytes()),
            Format::Png => raster::is_signed(known),
            Format::Pdf => known.ends_with(SIGNED_PDF),
        };
        let place = Place::free_or(&path.with_extension(format.extension()), is_ours)?;
        Ok((*format, place))
    };
    formats.iter().map(place).collect()
}

/// Panels laid out side by side, each of that size (px), below a mark if there is one.
fn scene(panels: &[Panel], (columns, size): (usize, [f64; 2]), mark: Option<&str>) -> Scene {
    let (plots, layouts) = panels.iter().map(drawn).unzip();
    let mut figure = Figure::new(panels.len().div_ceil(columns), columns)
        .with_cell_size(size[0], size[1])
        .with_plots(plots)
        .with_layouts(layouts);
    if let Some(mark) = mark {
        figure = figure.with_title(mark).with_title_size(20);
    }
    if panels.len() > 1 {
        figure = figure.with_labels_lowercase();
    }
    let mut scene = figure.render();
    let shapes = panels.iter().flat_map(|panel| &panel.marks).map(|mark| &mark.shape);
    let parts: Vec<&Parts> = shapes
        .filter_map(|shape| match shape {
            Shape::Parts(parts) => Some(parts),
            _ => None,
        })
        .collect();
    parts::put(&mut scene, &parts);
    colour_notes(&mut scene, panels);
    scene
}

/// Size of words at places, which nothing else has: they are known by it.
const NOTE: u32 = 13;

/// Gives words at places their colours, which the library draws in that of all text.
fn colour_notes(scene: &mut Scene, panels: &[Panel]) {
    let notes = panels.iter().flat_map(|panel| &panel.view.notes);
    let drawn = scene.elements.iter_mut().filter_map(|element| match element {
        Primitive::Text { size: NOTE, color, .. } => Some(color),
        _ => None,
    });
    drawn.zip(notes).for_each(|(drawn, (_, _, colour))| *drawn = Some(Color::from(*colour)));
}

/// A picture for a page: its kind, `image/svg+xml` or `image/png`, and its bytes.
#[derive(Debug)]
pub(crate) struct Still {
    pub(crate) kind: &'static str,
    pub(crate) bytes: Vec<u8>,
}

/// Size (px) of a picture on a page, and of one to scale.
const STILL: [f64; 2] = [600.0, 400.0];
const STILL_MAP: [f64; 2] = [560.0, 440.0];
/// Bytes of an SVG from which its picture in pixels is the smaller one.
const LARGE: usize = 120_000;

/// A panel as a picture for a page, which has the title above it.
pub(crate) fn still(panel: &Panel) -> anyhow::Result<Still> {
    let panel = Panel { title: String::new(), ..panel.clone() };
    let size = if panel.view.to_scale { STILL_MAP } else { STILL };
    let scene = scene(std::slice::from_ref(&panel), (1, size), None);
    let bytes = svg(&scene, None).into_bytes();
    match bytes.len() < LARGE {
        true => Ok(Still { kind: "image/svg+xml", bytes }),
        false => Ok(Still { kind: "image/png", bytes: raster::png(&scene, 2.0 * STILL[0])? }),
    }
}

/// The scene as SVG, of that width (mm) if it is given.
fn svg(scene: &Scene, millimetres: Option<f64>) -> String {
    let text = SvgBackend::new().render_scene(scene);
    let Some(width) = millimetres else { return text };
    let (x, y) = (scene.width, scene.height);
    let sized =
        format!(r#"width="{width}mm" height="{:.3}mm" viewBox="0 0 {x} {y}""#, width * y / x);
    text.replacen(&format!(r#"width="{x}" height="{y}""#), &sized, 1)
}

/// The scene as a PDF, of that width (mm) if it is given.
#[cfg(feature = "pdf")]
fn pdf(scene: &Scene, millimetres: Option<f64>) -> anyhow::Result<Vec<u8>> {
    let width = millimetres.map_or(scene.width, |mm| mm * POINTS);
    let size = PageSize::points(width, width * scene.height / scene.width);
    let drawn = PdfBackend::new().with_page_size(size).render_scenes(std::slice::from_ref(scene));
    drawn.map_err(|message| anyhow!(message))
}

#[cfg(not(feature = "pdf"))]
fn pdf(_: &Scene, _: Option<f64>) -> anyhow::Result<Vec<u8>> {
    Err(anyhow!(
        "this archard was built without PDF: build it with `--features pdf`, or take `--format svg`"
    ))
}

/// A panel as the library that draws takes it.
fn drawn(panel: &Panel) -> (Vec<Plot>, Layout) {
    let plots: Vec<Plot> = panel.marks.iter().map(plot).collect();
    let layout = Layout::auto_from_plots(&plots)
        .with_title(&*panel.title)
        .with_x_label(&*panel.labels[0])
        .with_y_label(&*panel.labels[1])
        .with_title_size(18)
        .with_label_size(16)
        .with_tick_size(14)
        .with_body_size(14)
        .with_legend_box(false)
        .with_tick_format(TickFormat::Custom(Arc::new(tick)));
    let maps = panel
        .marks
        .iter()
        .any(|mark| matches!(mark.shape, Shape::Map(_) | Shape::Parts(_) | Shape::Contours(_)));
    (plots, framed(layout.with_show_grid(!maps), &panel.view))
}

/// Sets an end of an axis.
type End = fn(Layout, f64) -> Layout;

/// A layout with what is particular to a panel.
fn framed(layout: Layout, view: &View) -> Layout {
    let mut layout = layout.with_legend_position(match view.legend {
        LegendPosition::OutsideRightTop => plot::LegendPosition::OutsideRightTop,
        LegendPosition::InsideTopLeft => plot::LegendPosition::InsideTopLeft,
        LegendPosition::InsideBottomRight => plot::LegendPosition::InsideBottomRight,
    });
    let ends = view.ends;
    let set: [(Option<f64>, End); 4] = [
        (ends[0][0], Layout::with_x_axis_min),
        (ends[0][1], Layout::with_x_axis_max),
        (ends[1][0], Layout::with_y_axis_min),
        (ends[1][1], Layout::with_y_axis_max),
    ];
    for (end, set) in set {
        layout = end.into_iter().fold(layout, set);
    }
    if let Some(title) = &view.legend_title {
        layout = layout.with_legend_title(&**title);
    }
    if view.to_scale {
        layout = layout.with_equal_aspect();
    }
    if !view.named {
        layout = layout.with_y_tick_format(TickFormat::Custom(Arc::new(|_| String::new())));
    }
    let [x, y] = &view.steps;
    if !x.is_empty() {
        layout = layout.with_x_tick_format(names(x));
        layout.x_tick_step = Some(1.0);
    }
    if !y.is_empty() {
        layout = layout.with_y_tick_format(names(y));
        layout.y_tick_step = Some(1.0);
    }
    if view.log {
        layout =
            layout.with_log_scale().with_tick_format(TickFormat::Custom(Arc::new(tick_of_decades)));
    }
    view.notes.iter().fold(layout, |layout, (words, [x, y], _)| {
        layout.with_annotation(TextAnnotation::new(&**words, *x, *y).with_font_size(NOTE))
    })
}

/// Names at the places 1, 2, 3, and nothing between them.
fn names(names: &[String]) -> TickFormat {
    let names = names.to_vec();
    TickFormat::Custom(Arc::new(move |place: f64| {
        let whole = (place - place.round()).abs() < 1e-6 && place > 0.5;
        let name = whole.then(|| names.get(place.round() as usize - 1)).flatten();
        name.cloned().unwrap_or_default()
    }))
}

fn plot(Mark { shape, legend }: &Mark) -> Plot {
    let legend = legend.as_deref();
    match shape {
        Shape::Line(points, pen) => {
            let line = LinePlot::new().with_data(points.iter().copied());
            let line = line.with_color(&*pen.colour).with_stroke_width(pen.width);
            legend.into_iter().fold(line, LinePlot::with_legend).into()
        }
        Shape::Dots(points, colour) => {
            let dots = ScatterPlot::new().with_data(points.iter().copied());
            let dots = dots.with_color(&**colour).with_size(5.0);
            legend.into_iter().fold(dots, ScatterPlot::with_legend).into()
        }
        Shape::Band { places, colour, opacity } => {
            let of = |index: usize| places.iter().map(move |place| place[index]);
            let band = BandPlot::new(of(0), of(1), of(2)).with_color(&**colour);
            let band = band.with_opacity(*opacity);
            Plot::Band(legend.into_iter().fold(band, BandPlot::with_legend))
        }
        Shape::Map(Map { edges, rows }) => {
            let signed = rows.iter().flatten().any(|value| *value < 0.0);
            let colour = if signed { parts::colour_of_any } else { colour };
            cells(*edges, rows.iter().map(Vec::as_slice), colour)
        }
        Shape::Contours(Contours { places: [x, y], rows, levels }) => {
            // The library draws no line next to a value that is no number.
            let known = |value: &f64| if value.is_nan() { 0.0 } else { *value };
            let rows = rows.iter().map(|row| row.iter().map(known).collect()).collect();
            let contours = ContourPlot::new().with_grid(rows, x.clone(), y.clone());
            let contours = contours.with_levels(levels).with_filled();
            let contours = contours.with_line_color("#ffffff").with_line_width(0.8);
            Plot::Contour(legend.into_iter().fold(contours, ContourPlot::with_legend))
        }
        Shape::Parts(parts) => {
            cells(parts.edges, parts.stand_in().iter().map(<[f64; 2]>::as_slice), colour)
        }
    }
}

/// A map of equal cells between edges along x and y.
fn cells<'a>(
    [x, y]: [[f64; 2]; 2],
    rows: impl Iterator<Item = &'a [f64]>,
    colour: fn(f64) -> String,
) -> Plot {
    Heatmap::new()
        .with_data(rows.map(|row| row.iter().copied()))
        .with_x_range(x[0], x[1])
        .with_y_range(y[0], y[1])
        .with_cell_size(1.0)
        .with_color_map(ColorMap::Custom(Arc::new(colour)))
        .into()
}
