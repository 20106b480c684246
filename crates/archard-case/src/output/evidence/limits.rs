//! How near a run comes to the limits of its theory: small strains of elastic half-spaces, small creepages, coefficients
//! that hold.
//!
//! All of them are judged here, at the end of every run, by the worst state of it.

use serde::{Deserialize, Serialize};

use super::{keep, worst};
use crate::verdict::{self, Line};
use archard::body::Body;
use archard::body::profile::Round;
use archard::estimate::ConformingEdge;
use archard::frame::{ContactFrame, VectorField};
use archard::problem::{ContactProblem, Flash};
use archard::simulation::Report;

/// The worst of all reports; where a body has its own limit, with its name.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(super) struct Limits {
    /// Largest pressure over the hardness of a body.
    hardness: Option<(f64, String)>,
    /// The same over Young's modulus of a body without a hardness that can yield.
    modulus: Option<(f64, String)>,
    /// Part of a layer, of another stiffness than what is below it, that is worn off where it is thinnest.
    layers: Option<(f64, String)>,
    /// How far the contact reaches from its middle, over the smallest radius of a body.
    radius: Option<(f64, String)>,
    /// What a plane frame neglects of bodies that conform: the form of the profiles, and how they slope.
    form: Option<f64>,
    slope: Option<f64>,
    /// Where the frame is drawn on a round surface: how far the contact reaches (degrees), and the clearance over the radius.
    angle: Option<f64>,
    clearance: Option<f64>,
    /// How far (degrees) it reaches on an elastic ball.
    ball: Option<f64>,
    /// The least way to the rim of a layered socket, over the thickness of its layers.
    rim: Option<f64>,
    /// There, the force that is left across the axis of the load, over the load.
    side: Option<f64>,
    /// Length of a line of contact over its width: the smallest. A line is as long as its frame, or as it is said to be.
    length: Option<f64>,
    /// What strips along it neglect of the load of one.
    strips: Option<f64>,
    /// The warmest place (K).
    temperature: Option<f64>,
    /// Creepage, regardless of its direction.
    creepage: Option<f64>,
    /// Limit of friction over the pressure, where that is largest.
    friction: Option<f64>,
}

impl Limits {
    /// Takes up a report, with what it says of heat.
    pub fn take(&mut self, report: &Report<'_>, flash: Option<&Flash>) {
        let Report { problem, state, .. } = report;
        let peak = state.pressure.iter().copied().fold(0.0, f64::max);
        for (i, body) in problem.bodies.iter().enumerate() {
            let deepest = state.surfaces[i].depth.iter().copied().fold(0.0, f64::max);
            if let Some(gone) = gone(body, deepest) {
                worst_of(&mut self.layers, gone, body);
            }
            let young = body.uppermost().map(|material| material.young);
            let young = young.filter(|young| *young >= verdict::ELASTOMERS);
            match (body.known_hardness(), young) {
                (Some(hardness), _) => worst_of(&mut self.hardness, peak / hardness, body),
                (None, Some(young)) => worst_of(&mut self.modulus, peak / young, body),
                (None, None) => {}
            }
        }
        if let Some(extent) = Extent::of(&problem.frame, &state.pressure) {
            self.take_extent(problem, extent);
        }
        worst(&mut self.side, side(problem, &state.pressure));
        worst(&mut self.strips, problem.strips_neglect(&state.pressure));
        let warmest = flash.map(|flash| {
            let rise = flash.rise.iter().copied().fold(0.0, f64::max);
            flash.bulk.unwrap_or_default() + rise
        });
        worst(&mut self.temperature, warmest);
        let creepage = state.tangential.as_ref().map(|own| own.creepage[0].hypot(own.creepage[1]));
        worst(&mut self.creepage, creepage.filter(|creepage| *creepage > 0.0));
        let limit = problem.friction.as_ref().filter(|_| peak > 0.0);
        worst(&mut self.friction, limit.map(|law| law.limit(peak) / peak));
    }

    /// Takes up how far a contact reaches.
    fn take_extent(&mut self, problem: &ContactProblem, Extent { size }: Extent) {
        let frame = &problem.frame;
        let even = [0, 1].map(|axis| frame.is_uniform() && problem.is_even(axis));
        let [x, y] = [0, 1].map(|axis| if even[axis] { 0.0 } else { 0.5 * size[axis] });
        for body in problem.bodies.iter().filter(|body| !is_meshed(body)) {
            let curvatures = body.curvatures().unwrap_or_default();
            let sharpest = curvatures.into_iter().fold(0.0, |most: f64, one| most.max(one.abs()));
            if sharpest > 0.0 {
                worst_of(&mut self.radius, x.max(y) * sharpest, body);
            }
        }
        let conforming = ConformingEdge::of(&problem.bodies, [x, y]);
        let conforming = conforming.filter(|_| !problem.bodies.iter().any(is_meshed));
        worst(&mut self.form, conforming.map(|own| own.form));
        worst(&mut self.slope, conforming.map(|own| own.slope));
        if let Some(wrap) = frame.wrap() {
            let reach = wrap.closing(if frame.is_line() { [x, 0.0] } else { [x.max(y), 0.0] });
            let angle = reach.clamp(-1.0, 1.0).acos().to_degrees();
            worst(&mut self.angle, Some(angle));
            let inner = &problem.bodies[1 - wrap.hollow];
            let elastic = wrap.round == Round::Sphere && inner.uppermost().is_some();
            worst(&mut self.ball, elastic.then_some(angle));
            let thick = problem.bodies[wrap.hollow].coated();
            if wrap.round == Round::Sphere && thick > 0.0 {
                let room =
                    (wrap.rim - problem.motion.tilt() - angle.to_radians()) * wrap.radius / thick;
                self.rim = Some(self.rim.map_or(room, |known| known.min(room)));
            }
            self.clearance = Some(wrap.clearance / wrap.radius);
        }
        if let Some(axis) = [0, 1].into_iter().find(|&axis| even[axis] && !even[1 - axis]) {
            let length = frame.rectangle().size[axis] / size[1 - axis];
            self.length = Some(self.length.map_or(length, |known| known.min(length)));
        }
    }

    /// The lines that follow.
    pub fn lines(&self) -> impl Iterator<Item = Line> {
        let of = |known: &Option<(f64, String)>, line: fn(f64, &str) -> Line| {
            known.as_ref().map(|(value, body)| line(*value, body))
        };
        let lines = [
            of(&self.hardness, verdict::hardness),
            of(&self.modulus, verdict::modulus),
            of(&self.layers, verdict::layers),
            of(&self.radius, verdict::radius),
            self.form.map(verdict::form),
            self.slope.map(verdict::slope),
            self.angle.map(verdict::angle),
            self.clearance.map(verdict::clearance),
            self.rim.map(verdict::rim),
            self.ball.map(verdict::map),
            self.side.map(verdict::side),
            self.length.map(verdict::length),
            self.strips.map(verdict::strips),
            self.temperature.map(verdict::temperature),
            self.creepage.map(verdict::creepage),
            self.friction.map(verdict::friction),
        ];
        lines.into_iter().flatten()
    }
}

/// The force of pressures (Pa) across the axis of the load over that along it, of bodies that fit into each other; `None` of others,
/// and without a load.
fn side(problem: &ContactProblem, pressure: &[f64]) -> Option<f64> {
    problem.frame.wrap()?;
    let mut tractions = VectorField::zeros(pressure.len());
    tractions.n.iter_mut().zip(pressure).for_each(|(normal, pressure)| *normal = -pressure);
    let [x, y, along] = problem.frame.force(&tractions);
    (along != 0.0).then(|| x.hypot(y) / along.abs())
}

/// The largest part of a layer that is worn off at some depth (m), of those that are stiffer or softer by half than what is below
/// them; `None` where there are none.
fn gone(body: &Body, depth: f64) -> Option<f64> {
    let below = body.layers.iter().skip(1).map(|layer| Some(layer.material));
    let below = below.chain([body.material]);
    let mut top = 0.0;
    let parts = body.layers.iter().zip(below).filter_map(|(layer, below)| {
        let part = ((depth - top) / layer.thickness).clamp(0.0, 1.0);
        top += layer.thickness;
        let stiffer = below.map_or(0.0, |below| layer.material.young / below.young);
        let alike = stiffer.max(stiffer.recip()) < 1.0 + verdict::BY_HALF;
        (!alike).then_some(part)
    });
    parts.reduce(f64::max)
}

/// Whether a body is computed with the shape it has.
fn is_meshed(body: &Body) -> bool {
    body.finite.as_ref().is_some_and(|one| one.elasticity.is_own())
}

/// Keeps the larger of two numbers with its body.
fn worst_of(known: &mut Option<(f64, String)>, found: f64, body: &Body) {
    if keep(known.as_ref().map(|(value, _)| *value), found) == found {
        *known = Some((found, body.name.clone()));
    }
}

/// How wide a contact is along x and y (m).
struct Extent {
    size: [f64; 2],
}

impl Extent {
    /// That of the pairs under pressure, mirror images included; `None` where there are none.
    fn of(frame: &ContactFrame, pressure: &[f64]) -> Option<Self> {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for pair in (0..frame.len()).filter(|&pair| pressure[pair] > 0.0) {
            for (axis, place) in frame.place(pair).into_iter().enumerate() {
                (low[axis], high[axis]) = (low[axis].min(place), high[axis].max(place));
            }
        }
        let own = if frame.is_uniform() { frame.spacing() } else { [0.0; 2] };
        let size = |axis: usize| match frame.mirrored()[axis] {
            true => 2.0 * low[axis].abs().max(high[axis].abs()),
            false => high[axis] - low[axis] + own[axis],
        };
        low[0].is_finite().then(|| Self { size: [size(0), size(1)] })
    }
}
