//! The force on body 1 over the creepage, with the limit and a closed form beside it.

use anyhow::Result;
use archard::body::Material;
use archard::closed_form::{kalker::Coefficients, vermeulen_johnson};
use archard::motion::{Drive, Rolling};
use archard::simulation::history::{CREEPAGE, FORCE, LOAD};
use kuva::plot::LegendPosition;

use super::figure::{COLOURS, Curves, Panel, Pen};
use super::results::Results;
use super::scale::Unit;
use super::tables::Axis;

/// Share of the larger force below which the other is not drawn.
const NEGLIGIBLE: f64 = 0.01;
/// Points of the curve of the closed form.
const POINTS: usize = 100;

/// The forces along x and y over the larger creepage, or over the share of the spin where the bodies
/// creep by nothing else.
pub(super) fn panel(results: &Results) -> Result<Panel> {
    let sweep = Sweep::of(results)?;
    let mut curves = Curves::new();
    sweep.add_law(results, &mut curves);
    sweep.add_limits(&mut curves);
    for (axis, name) in ["along x", "along y"].into_iter().enumerate() {
        let force = sweep.forces[axis];
        if sweep.shows(size(force)) {
            let points = sweep.places.iter().zip(force).map(|(place, f)| (sweep.shown(*place), *f));
            curves.mark(points, COLOURS[1 + axis], Some(name));
        }
    }
    let body = results.bodies.first().map_or("body 1", |body| body);
    let place = Unit::share().label(sweep.abscissa.name());
    let labels = [&*format!("Force on {body}"), &place, "Force (N)"];
    Ok(curves.panel(labels, |layout| layout.with_legend_position(LegendPosition::OutsideRightTop)))
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
    /// Normal force (N).
    load: f64,
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
            load,
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
        let (Some(index), Some(limit)) = (self.abscissa.index(), self.limit) else { return };
        let Some(law) = Law::of(results, self.load, limit) else { return };
        let mut legend = Some("Vermeulen and Johnson");
        for axis in [0, 1] {
            let curve = law.curve(index, axis);
            if self.shows(curve.iter().fold(0.0, |most, (_, force)| force.abs().max(most))) {
                let points = curve.into_iter().map(|(place, force)| (self.shown(place), force));
                curves.add(points, Pen::closed_form(), legend.take());
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

/// The law of Vermeulen and Johnson for a run that sweeps creepages.
struct Law {
    rolling: Rolling,
    /// Creepages at the end of the sweep.
    creepage: [f64; 2],
    coefficients: Coefficients,
    /// Shear modulus (Pa).
    shear_modulus: f64,
    /// Semi-axes along the direction of rolling and across (m).
    semi_axes: [f64; 2],
    /// Friction times load (N).
    limit: f64,
}

impl Law {
    /// The law, where bodies of one material touch on an ellipse and creep as given, without spin, under friction
    /// that is the same in all directions.
    fn of(results: &Results, load: f64, limit: f64) -> Option<Self> {
        let straight = |rolling: &Rolling| rolling.spin == 0.0 && results.has_isotropic_friction();
        let rolling = results.rolling().filter(straight)?;
        let (Drive::Creepage(along), Drive::Creepage(across)) =
            (rolling.longitudinal, rolling.lateral)
        else {
            return None;
        };
        let [one, other] = results.case.as_ref()?.bodies.each_ref().map(|body| body.material);
        let Material { young, poisson } = one.filter(|_| one == other)?;
        let hertz = results.hertz(load)?;
        let axis = rolling.direction.axis;
        let semi_axes = [hertz.semi_axes[axis], hertz.semi_axes[1 - axis]];
        Some(Self {
            rolling,
            creepage: [along, across],
            coefficients: Coefficients::at(semi_axes[0] / semi_axes[1], poisson)?,
            shear_modulus: young / (2.0 * (1.0 + poisson)),
            semi_axes,
            limit,
        })
    }

    /// Force on body 1 (N) along an axis of the frame over one of the creepages.
    fn curve(&self, creepage: usize, axis: usize) -> Vec<(f64, f64)> {
        let direction = self.rolling.direction;
        let units = [direction.forward(), direction.lateral()];
        let point = |share: f64| {
            // Linear theory counts creepage the other way.
            let against = self.creepage.map(|creepage| -share * creepage);
            let linear =
                self.coefficients.resultant(self.shear_modulus, self.semi_axes, against, 0.0);
            let force = vermeulen_johnson::force(linear.force, self.limit);
            (share * self.creepage[creepage], force[0] * units[0][axis] + force[1] * units[1][axis])
        };
        (0..=POINTS).map(|index| point(index as f64 / POINTS as f64)).collect()
    }
}
