//! The force on body 1 over the creepage, with the limit and a closed form next to it.

use anyhow::Result;
use archard::motion::Drive;
use archard::simulation::history::{CREEPAGE, FORCE, LOAD};

use super::CELLS;
use super::NEGLIGIBLE;
use super::figure::{COLOURS, Curves, LegendPosition, OTHERS, Panel, Pen};
use super::results::Results;
use super::scale::Unit;
use super::tables::Axis;

/// The forces along x and y over the larger creepage, or over the share of the spin where the bodies
/// creep by nothing else.
pub(crate) fn panel(results: &Results) -> Result<Panel> {
    let sweep = Sweep::of(results)?;
    let mut curves = Curves::new();
    sweep.add_law(results, &mut curves);
    sweep.add_limits(&mut curves);
    for (axis, name) in ["along x", "along y"].into_iter().enumerate() {
        let force = sweep.forces[axis];
        if sweep.shows(size(force)) {
            let points = sweep.places.iter().zip(force).map(|(place, f)| (sweep.shown(*place), *f));
            curves.mark(points, OTHERS[axis], Some(name));
        }
    }
    let body = results.bodies.first().map_or("body 1", |body| body);
    let place = Unit::share().label(sweep.abscissa.name());
    let labels = [&*format!("Force on {body}"), &place, "Force (N)"];
    Ok(curves.panel(labels, |view| view.legend(LegendPosition::OutsideRightTop)))
}

/// A run at rising creepages.
struct Sweep<'a> {
    abscissa: Abscissa,
    /// What the forces are drawn over.
    places: &'a [f64],
    /// Forces on body 1 along x and y (N).
    forces: [&'a [f64]; 2],
    /// The larger of them at its largest (N).
    most: f64,
    /// Friction times load (N) along the axis of the larger force, where the law is known.
    limit: Option<f64>,
}

impl<'a> Sweep<'a> {
    fn of(results: &'a Results) -> Result<Self> {
        let history = &results.history;
        let creepages = [history.column(CREEPAGE[0])?, history.column(CREEPAGE[1])?];
        let forces = [history.column(FORCE[0])?, history.column(FORCE[1])?];
        let abscissa = Abscissa::of(creepages.map(size));
        let load = history.column(LOAD)?.last().copied().unwrap_or_default();
        let sizes = forces.map(size);
        let axis = if sizes[0] >= sizes[1] { Axis::X } else { Axis::Y };
        let limit = results.friction_limits(&[load], axis);
        Ok(Self {
            abscissa,
            places: abscissa.index().map_or(results.progress().1, |index| creepages[index]),
            forces,
            most: sizes[0].max(sizes[1]),
            limit: limit.and_then(|limit| limit.first().copied()),
        })
    }

    /// Whether a force (N) is large enough to be drawn.
    fn shows(&self, force: f64) -> bool {
        self.most == 0.0 || force > NEGLIGIBLE * self.most
    }

    /// A place in the unit of the axis.
    fn shown(&self, place: f64) -> f64 {
        place * Unit::share().factor
    }

    /// Adds the closed form, where there is one.
    fn add_law(&self, results: &Results, curves: &mut Curves) {
        let (Some(index), Some((direction, drives))) = (self.abscissa.index(), results.rolling())
        else {
            return;
        };
        let Drive::Slip(most) = drives.both()[index] else { return };
        let shares = || (0..=CELLS).map(|point| point as f64 / CELLS as f64);
        let estimates = results.case.as_ref().map_or(vec![], |case| case.estimates(shares()));
        let forces: Option<Vec<_>> = estimates.iter().map(|one| one.rolled?.force).collect();
        let Some(forces) = forces else { return };
        let line = estimates.iter().any(|one| one.rolled.is_some_and(|rolled| rolled.line));
        let mut legend = Some(if line { "Carter" } else { "Vermeulen and Johnson" });
        let units = [direction.forward(), direction.lateral()];
        for axis in [0, 1] {
            let along = |force: &[f64; 2]| force[0] * units[0][axis] + force[1] * units[1][axis];
            let forces: Vec<f64> = forces.iter().map(along).collect();
            if self.shows(size(&forces)) {
                let places = shares().map(|share| self.shown(share * most));
                curves.add(places.zip(forces), Pen::closed_form(), legend.take());
            }
        }
    }

    /// Adds what friction bears, on the sides to which the forces point.
    fn add_limits(&self, curves: &mut Curves) {
        let Some(limit) = self.limit else { return };
        let ends = [self.places.first(), self.places.last()];
        let ends = ends.map(|end| self.shown(end.copied().unwrap_or_default()));
        let last = |force: &[f64]| force.last().copied().unwrap_or_default();
        let mut legend = Some("limit");
        for sign in [1.0, -1.0] {
            if self.forces.iter().any(|force| self.shows(sign * last(force))) {
                let line = ends.map(|place| (place, sign * limit));
                curves.add(line, Pen::line(COLOURS[0]), legend.take());
            }
        }
    }
}

/// Largest magnitude.
fn size(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| value.abs().max(most))
}

/// What the forces are drawn over.
#[derive(Clone, Copy)]
enum Abscissa {
    Longitudinal,
    Lateral,
    Share,
}

impl Abscissa {
    /// The larger of both creepages, if there is any.
    fn of([longitudinal, lateral]: [f64; 2]) -> Self {
        match longitudinal.max(lateral) {
            0.0 => Self::Share,
            _ if longitudinal >= lateral => Self::Longitudinal,
            _ => Self::Lateral,
        }
    }

    /// Which of the creepages.
    fn index(self) -> Option<usize> {
        match self {
            Self::Longitudinal => Some(0),
            Self::Lateral => Some(1),
            Self::Share => None,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Longitudinal => "Creepage",
            Self::Lateral => "Lateral creepage",
            Self::Share => "Share of the spin",
        }
    }
}
