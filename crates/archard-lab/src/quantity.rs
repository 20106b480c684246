//! What is measured, and where a run has it.

use archard::body::Body;
use archard::simulation::history::{
    BODY_DEPTH, MASS_LOSS, TRACK_WIDTH, WORN_SECTION, WORN_VOLUME, number, of_body,
};
use archard::simulation::{Report, worn_extent, worn_middle};
use archard::units::Measure;

/// Kinds of readings, by the names of their columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Volume,
    Depth,
    Section,
    Mass,
    Width,
    Length,
    Diameter,
    /// The section through the middle of the frame, along an axis.
    Middle(usize),
}

/// All kinds with their columns.
pub(super) const KINDS: [(&str, Kind); 7] = [
    ("volume", Kind::Volume),
    ("depth", Kind::Depth),
    ("section", Kind::Section),
    ("mass", Kind::Mass),
    ("width", Kind::Width),
    ("length", Kind::Length),
    ("diameter", Kind::Diameter),
];

/// What was measured, and the body it belongs to.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Quantity {
    /// The name of its column.
    pub name: String,
    pub kind: Kind,
    /// The body, by its place.
    pub body: usize,
}

impl Kind {
    /// What it measures.
    pub fn measure(self) -> Measure {
        match self {
            Kind::Volume => Measure::VOLUME,
            Kind::Section | Kind::Middle(_) => Measure::AREA,
            Kind::Mass => Measure::MASS,
            Kind::Depth | Kind::Width | Kind::Length | Kind::Diameter => Measure::LENGTH,
        }
    }

    /// A factor from SI to a unit that suits worn bodies, and that unit.
    pub fn shown(self) -> (f64, &'static str) {
        match self {
            Kind::Volume => (1e9, "mm3"),
            Kind::Section | Kind::Middle(_) => (1e6, "mm2"),
            Kind::Mass => (1e6, "mg"),
            Kind::Depth => (1e6, "um"),
            Kind::Width | Kind::Length | Kind::Diameter => (1e3, "mm"),
        }
    }
}

impl Quantity {
    /// The value in a report and its row (SI); `None` where runs of the case have none.
    pub fn value(&self, report: &Report<'_>, row: &[(String, f64)]) -> Option<f64> {
        let body: &Body = &report.problem.bodies[self.body];
        let column = |column: &str| number(row, &of_body(column, &body.name));
        match self.kind {
            Kind::Volume => column(WORN_VOLUME),
            // Along a line of contact volumes are those of a length of one.
            Kind::Section => column(WORN_SECTION)
                .or_else(|| column(WORN_VOLUME).filter(|_| report.problem.frame.is_line())),
            Kind::Mass => column(MASS_LOSS),
            Kind::Depth => column(BODY_DEPTH),
            Kind::Middle(axis) => worn_middle(report, (self.body, axis)),
            Kind::Width => self.extents(report, row).map(|[_, across]| across),
            Kind::Length => self.extents(report, row).map(|[along, _]| along),
            Kind::Diameter => {
                self.extents(report, row).map(|[along, across]| (along * across).sqrt())
            }
        }
    }

    /// Along and across the motion; of a body that passes the width of its track alone.
    fn extents(&self, report: &Report<'_>, row: &[(String, f64)]) -> Option<[f64; 2]> {
        let track = || number(row, TRACK_WIDTH).filter(|_| self.kind == Kind::Width);
        worn_extent(report, self.body).or_else(|| track().map(|width| [width; 2]))
    }
}
