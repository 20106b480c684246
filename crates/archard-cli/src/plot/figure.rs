//! What a picture shows, apart from how it is drawn: curves, points, bands and maps between two axes.
//!
//! [`draw`](super::draw) makes files of panels, [`report`](crate::report) shows the same ones on a page.

use kuva::plot::ColorMap;

/// Black, blue and vermilion of M. Okabe and K. Ito, *Color Universal Design* (2008): told apart
/// with any colour vision. The second is that of body 1, the third that of body 2.
pub(crate) const COLOURS: [&str; 3] = ["#000000", "#0072b2", "#d55e00"];
/// The same, pale: for what lies below.
pub(crate) const PALE: [&str; 3] = ["#bdbdbd", "#9ad0f5", "#f5c19a"];
/// Green and purple of the same: for what belongs to no body.
pub(crate) const OTHERS: [&str; 2] = ["#009e73", "#cc79a7"];

/// Places and values, in the units of the axes.
pub(crate) type Points = Vec<(f64, f64)>;

/// Curves or a map between two axes.
#[derive(Debug, Clone)]
pub(crate) struct Panel {
    pub(crate) title: String,
    /// Labels of the axes along x and y, with their units.
    pub(crate) labels: [String; 2],
    pub(crate) marks: Vec<Mark>,
    pub(crate) view: View,
}

/// Something drawn, with its legend if it has one.
#[derive(Debug, Clone)]
pub(crate) struct Mark {
    pub(crate) shape: Shape,
    pub(crate) legend: Option<String>,
}

/// What is drawn.
#[derive(Debug, Clone)]
pub(crate) enum Shape {
    /// A line through points.
    Line(Points, Pen),
    /// Points without a line between them, of that colour.
    Dots(Points, String),
    /// Places with the lowest and the highest value there, filled.
    Band { places: Vec<[f64; 3]>, colour: String, opacity: f64 },
    /// Values on cells.
    Map(Map),
    /// Values on elements of any shape.
    Parts(Parts),
    /// Values at places, with isolines.
    Contours(Contours),
}

/// Values at the places of a grid, filled between levels.
#[derive(Debug, Clone)]
pub(crate) struct Contours {
    /// Places along x and along y, rising.
    pub(crate) places: [Vec<f64>; 2],
    /// A row along x after the other, from the lowest y; no number where none is known.
    pub(crate) rows: Vec<Vec<f64>>,
    /// Values that lines are drawn at, rising.
    pub(crate) levels: Vec<f64>,
}

/// Values on elements, white where they are zero.
#[derive(Debug, Clone)]
pub(crate) struct Parts {
    /// Lowest and highest place along x and along y.
    pub(crate) edges: [[f64; 2]; 2],
    /// The corners of each element, around it, and its value.
    pub(crate) parts: Vec<(Vec<[f64; 2]>, f64)>,
}

/// Values on cells, white where they are zero; of values with a sign white where there are none.
#[derive(Debug, Clone)]
pub(crate) struct Map {
    /// Lowest and highest place along x and along y.
    pub(crate) edges: [[f64; 2]; 2],
    /// A row along x after the other, from the lowest y.
    pub(crate) rows: Vec<Vec<f64>>,
}

/// How a line is drawn. Lines are told apart by width as well as colour, so that one on top of
/// another leaves both to be seen.
#[derive(Debug, Clone)]
pub(crate) struct Pen {
    /// As `#rrggbb`.
    pub(crate) colour: String,
    /// Width of the line (px).
    pub(crate) width: f64,
}

/// Where a legend stands.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum LegendPosition {
    #[default]
    OutsideRightTop,
    InsideTopLeft,
    InsideBottomRight,
}

/// What is particular to the axes of a panel.
#[derive(Debug, Clone)]
pub(crate) struct View {
    /// Ends of the axes along x and y where they do not follow from what is drawn.
    pub(crate) ends: [[Option<f64>; 2]; 2],
    pub(crate) legend: LegendPosition,
    pub(crate) legend_title: Option<String>,
    /// Words at places, and their colours.
    pub(crate) notes: Vec<(String, [f64; 2], &'static str)>,
    /// Whether a length is shown as long along y as along x.
    pub(crate) to_scale: bool,
    /// Whether values along y are named.
    pub(crate) named: bool,
    /// What stands at the places 1, 2, 3 along x and along y in the place of numbers, if anything does.
    pub(crate) steps: [Vec<String>; 2],
    /// Whether both axes are logarithmic.
    pub(crate) log: bool,
}

impl Pen {
    /// The usual line.
    pub(crate) fn line(colour: impl Into<String>) -> Self {
        Self { colour: colour.into(), width: 2.2 }
    }

    /// A line under a usual one.
    pub(crate) fn broad(colour: impl Into<String>) -> Self {
        Self { colour: colour.into(), width: 5.0 }
    }

    /// A band under everything else.
    pub(crate) fn under(colour: impl Into<String>) -> Self {
        Self { colour: colour.into(), width: 7.0 }
    }

    /// The pale band of a closed form, under whatever was computed.
    pub(crate) fn closed_form() -> Self {
        Self::under(PALE[0])
    }
}

impl Default for View {
    fn default() -> Self {
        Self {
            ends: [[None; 2]; 2],
            legend: LegendPosition::default(),
            legend_title: None,
            notes: Vec::new(),
            to_scale: false,
            named: true,
            steps: [vec![], vec![]],
            log: false,
        }
    }
}

impl View {
    /// The same from that place to that along x.
    pub(crate) fn along_x(mut self, [from, to]: [f64; 2]) -> Self {
        self.ends[0] = [Some(from), Some(to)];
        self
    }

    /// The same as far as that place along x.
    pub(crate) fn below_x(mut self, to: f64) -> Self {
        self.ends[0][1] = Some(to);
        self
    }

    /// The same from that value on along y.
    pub(crate) fn above_y(mut self, from: f64) -> Self {
        self.ends[1][0] = Some(from);
        self
    }

    /// The same as far as that value along y.
    pub(crate) fn below_y(mut self, to: f64) -> Self {
        self.ends[1][1] = Some(to);
        self
    }

    /// The same with the legend there.
    pub(crate) fn legend(self, legend: LegendPosition) -> Self {
        Self { legend, ..self }
    }

    /// The same with a title above the legend.
    pub(crate) fn legend_title(self, title: String) -> Self {
        Self { legend_title: Some(title), ..self }
    }

    /// The same with words at a place.
    pub(crate) fn note(self, words: impl Into<String>, place: [f64; 2]) -> Self {
        self.note_in(words, place, COLOURS[0])
    }

    /// The same in another colour.
    pub(crate) fn note_in(
        mut self,
        words: impl Into<String>,
        place: [f64; 2],
        colour: &'static str,
    ) -> Self {
        self.notes.push((words.into(), place, colour));
        self
    }
}

/// Curves between two axes.
#[derive(Debug, Default)]
pub(crate) struct Curves {
    marks: Vec<Mark>,
}

impl Curves {
    /// No curves yet.
    pub(crate) fn new() -> Self {
        Self::default()
    }

    fn push(&mut self, shape: Shape, legend: Option<&str>) {
        self.marks.push(Mark { shape, legend: legend.map(str::to_owned) });
    }

    /// Adds a curve; only one with a legend appears there.
    pub(crate) fn add(
        &mut self,
        points: impl IntoIterator<Item = (f64, f64)>,
        pen: Pen,
        legend: Option<&str>,
    ) {
        self.push(Shape::Line(points.into_iter().collect(), pen), legend);
    }

    /// Adds points without a line between them; only some with a legend appear there.
    pub(crate) fn mark(
        &mut self,
        points: impl IntoIterator<Item = (f64, f64)>,
        colour: &str,
        legend: Option<&str>,
    ) {
        self.push(Shape::Dots(points.into_iter().collect(), colour.to_owned()), legend);
    }

    /// Adds what lies between two values at each place.
    pub(crate) fn band(
        &mut self,
        places: impl IntoIterator<Item = [f64; 3]>,
        colour: &str,
        opacity: f64,
        legend: Option<&str>,
    ) {
        let (places, colour) = (places.into_iter().collect(), colour.to_owned());
        self.push(Shape::Band { places, colour, opacity }, legend);
    }

    /// Adds a map.
    pub(crate) fn map(&mut self, map: Map) {
        self.push(Shape::Map(map), None);
    }

    /// Adds values on elements.
    pub(crate) fn parts(&mut self, parts: Parts) {
        self.push(Shape::Parts(parts), None);
    }

    /// Adds values with isolines; a legend names their bar of colours.
    pub(crate) fn contours(&mut self, contours: Contours, legend: &str) {
        self.push(Shape::Contours(contours), Some(legend));
    }

    /// The panel with these curves; `adapt` changes what is particular to it.
    pub(crate) fn panel(self, [title, x, y]: [&str; 3], adapt: impl FnOnce(View) -> View) -> Panel {
        let view = adapt(View::default());
        let labels = [x, y].map(str::to_owned);
        Panel { title: title.to_owned(), labels, marks: self.marks, view }
    }
}

/// The colour of one of several moments of a run, from light at its start to dark at its end.
pub(crate) fn moment(index: usize, count: usize) -> String {
    let share = if count > 1 { index as f64 / (count - 1) as f64 } else { 1.0 };
    // The yellow end of the map is lost on white paper.
    ColorMap::Viridis.map(0.82 * (1.0 - share))
}
