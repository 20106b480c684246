//! What is doubtful about a case, in words.

use super::words::{both, length, pressure, size_list_up, three};
use super::{
    Finiteness, Forecast, Parts, Solves, conforming, density, foreseen, heat, rolling, shift,
    texture, track,
};
use crate::case::key::Key;
use crate::case::problem::Problem;
use crate::verdict::{self, EDGES, Line, Word};
use archard::body::Body;
use archard::estimate::Contact;
use archard::motion::Stepping;
use archard::problem;
use archard::simulation::refusal;
use archard::wear::Input;

/// Pressure (Pa) at which laws are read off where no other is known.
const PRESSURE: f64 = 1e8;
/// Cells across the contact below which it is poorly resolved.
const FEW_CELLS: f64 = 8.0;
/// Contact solves beyond which a run is worth a warning.
const MANY_SOLVES: u64 = 1_000_000;
/// Size of a comfortable frame in contact radii: the elastic fields need some room around.
pub(super) const ROOM: f64 = 2.4;
/// Smallest eigenvalue of the half-space compliance on square cells, in h/E*; twice it bounds the explicit step. Pressures that
/// alternate from cell to cell displace their centres by it: 32/pi^3 times the sum of (-1)^(m+n)/(i j hypot(i, j)) over all m and
/// n from zero on, with i = 2 m + 1 and j = 2 n + 1.
const SMALLEST_EIGENVALUE: f64 = 0.5807;

/// All that is wrong or doubtful.
pub(super) fn problems(parts: &Parts<'_>, forecast: &Forecast) -> Vec<Problem> {
    let mut problems = rubbing(parts);
    problems.extend(track::problems(parts, forecast));
    problems.extend(density::problems(parts));
    problems.extend(heat::problems(parts, forecast));
    problems.extend(useless_friction(parts));
    let refused = refusal::of_laws(&parts.bodies, parts.friction.as_deref(), &parts.motion);
    problems.extend(refused.into_iter().filter_map(|one| parts.refused(one)));
    problems.extend(rolling::problems(parts, forecast.estimate.contact.as_ref()));
    problems.extend(shift::problems(parts, forecast));
    problems.extend(explicit(parts));
    problems.extend(texture::problems(parts));
    problems.extend(long(parts, forecast));
    problems.extend(forecast.finiteness.iter().filter_map(Finiteness::doubt));
    if let Some(contact) = &forecast.estimate.contact {
        match (conforming::conforms(parts, contact), too_small(parts, contact)) {
            (Some(body), _) => {
                problems.extend(conforming::problems(parts, &forecast.estimate, body));
                problems.extend(few_cells(parts, forecast));
            }
            (None, Some(problem)) => problems.push(problem),
            (None, None) => {
                problems.extend(reaches_the_edge(parts, forecast));
                problems.extend(few_cells(parts, forecast));
            }
        }
        problems.extend(wide(parts, forecast));
        problems.extend(neglected(parts, forecast));
        problems.extend(too_soft(parts, contact));
    }
    problems
}

/// Wear without sliding, sliding without wear, where that does not depend on friction.
fn rubbing(parts: &Parts<'_>) -> Vec<Problem> {
    if parts.motion.lever_arm().is_none() {
        return vec![];
    }
    let motion = parts.case.motion.choice.name;
    let slides = parts.slip() > 0.0;
    let seeks = parts.case.seeks_inside();
    if slides && !parts.wears() && !seeks {
        let message = "the bodies slide, but neither has a `wear` table: nothing will wear";
        return vec![Problem::warning(Key::of(["motion", motion]), message)];
    }
    let worn = parts.case.bodies.iter().filter(|body| !slides && body.wears());
    worn.map(|body| {
        let message = format!("nothing slides in `motion.{motion}`: this body will not wear");
        Problem::warning(Key::of(["body", &body.name, "wear"]), message)
    })
    .collect()
}

/// Friction where the motion does not ask for it.
fn useless_friction(parts: &Parts<'_>) -> Option<Problem> {
    let asked = parts.bodies.iter().filter_map(|body| body.wear.as_deref()).any(|law| {
        law.inputs().iter().any(|one| matches!(one, Input::Friction | Input::Temperature))
    });
    let swings = parts.motion.amplitude().is_some();
    // What their own warnings or errors speak of, where it has no effect.
    let warms = parts.bodies.iter().any(|body| body.thermal.is_some());
    // Of what slides, friction stresses the inside.
    let stresses = parts.case.seeks_inside() && parts.slip() > 0.0;
    let used = asked || swings || warms || stresses;
    (parts.friction.is_some() && !used && parts.motion.lever_arm().is_some()).then(|| {
        let name = parts.case.motion.choice.name;
        let message = format!("has no effect in `motion.{name}`: all of the contact slides");
        Problem::warning(Key::of(["friction"]), message).at_name()
    })
}

/// Explicit steps beyond their bound: pressures swing from step to step.
fn explicit(parts: &Parts<'_>) -> Option<Problem> {
    let Stepping::Explicit(step) = parts.schedule.stepping else { return None };
    let opening = stable(parts);
    let wear = wear_slope(parts) * parts.motion.slip(step);
    (wear > opening).then(|| {
        let message = format!(
            "the explicit scheme is unstable with this step on square elements: pressures will swing from element to element, though depth and volume look right; the bound is {} here",
            length(step * opening / wear)
        );
        Problem::warning(Key::of(["motion", parts.case.motion.choice.name, "step"]), message)
            .help("take the implicit scheme, shorter steps or larger elements")
    })
}

/// Depth worn off both bodies per pressure and distance slid (1/Pa).
pub(super) fn wear_slope(parts: &Parts<'_>) -> f64 {
    let rubbing =
        problem::rubbing(parts.friction.as_deref(), PRESSURE, 1.0, parts.motion.heading([0.0; 2]));
    let laws = parts.bodies.iter().filter_map(|body| body.wear.as_ref());
    laws.map(|law| law.slope(rubbing)).sum()
}

/// Wear per pressure (m/Pa) up to which explicit steps are stable.
pub(super) fn stable(parts: &Parts<'_>) -> f64 {
    let [dx, dy] = parts.case.frame.spacing();
    2.0 * SMALLEST_EIGENVALUE * dx.min(dy) / parts.subject().contact_modulus()
}

/// More contact solves than anyone will wait for.
fn long(parts: &Parts<'_>, forecast: &Forecast) -> Option<Problem> {
    let (Solves::Exactly(solves) | Solves::AtLeast(solves) | Solves::About(solves)) =
        forecast.solves;
    (solves > MANY_SOLVES).then(|| {
        let motion = parts.case.motion.choice.name;
        let message = format!("the run will take {:.0e} contact solves", solves as f64);
        Problem::warning(Key::of(["motion", motion]), message).help(
            if parts.motion.increments().is_some() {
                "take fewer cycles or increments, or jump over cycles with `tolerance`"
            } else {
                "take longer steps or a larger tolerance"
            },
        )
    })
}

/// A frame smaller than the contact it should hold, which does not grow or lies elsewhere.
fn too_small(parts: &Parts<'_>, contact: &Contact) -> Option<Problem> {
    let size = parts.case.frame.rectangle().about_origin();
    let cut = |axis: usize| {
        contact.semi_axes[axis].is_finite() && 2.0 * contact.semi_axes[axis] > size[axis]
    };
    let held = parts.case.frame.centre == [0.0; 2] && parts.grows();
    (!held && (cut(0) || cut(1))).then(|| {
        let extents = contact.semi_axes.map(|axis| 2.0 * axis);
        if parts.case.frame.centre != [0.0; 2] {
            let message = format!(
                "the frame does not hold the contact, which Hertz expects to be {} wide about x = y = 0",
                extents_in_words(extents)
            );
            return Problem::error(parts.frame_key("centre"), message)
                .help("leave it out: the frame lies in the middle then");
        }
        let message = format!(
            "is smaller than the contact, which Hertz expects to be {} wide",
            extents_in_words(extents)
        );
        let needed = needed(size, contact.semi_axes);
        Problem::error(parts.frame_key("size"), message)
            .help(format!("the contact needs about {}", wanted(parts, needed)))
    })
}

/// The size a frame should have around a contact; as it is along a line contact.
fn needed(size: [f64; 2], semi_axes: [f64; 2]) -> [f64; 2] {
    [0, 1].map(|axis| if semi_axes[axis].is_finite() { ROOM * semi_axes[axis] } else { size[axis] })
}

/// A size of the frame, or of the zone of a file, as it is asked for.
fn wanted(parts: &Parts<'_>, size: [f64; 2]) -> String {
    match parts.zone_of_a_file() {
        true => format!("{} by {}", length(size[0]), length(size[1])),
        false => format!("`size = {}`", size_list_up(size)),
    }
}

fn extents_in_words(extents: [f64; 2]) -> String {
    let finite: Vec<String> =
        extents.into_iter().filter(|extent| extent.is_finite()).map(length).collect();
    match &finite[..] {
        [x, y] if x != y => format!("{x} by {y}"),
        [one, ..] => one.clone(),
        [] => String::new(),
    }
}

/// A contact that fills the frame along an axis, or will once it has worn.
fn reaches_the_edge(parts: &Parts<'_>, forecast: &Forecast) -> Option<Problem> {
    let size = parts.case.last_frame().rectangle().about_origin();
    let (key, word) = (parts.frame_key("size"), parts.frame_word());
    let contact = forecast.estimate.contact.as_ref()?;
    if let Some(axis) = [0, 1].into_iter().find(|&axis| contact.semi_axes[axis].is_infinite()) {
        if parts.case.frame.line || ends_there(parts, axis) {
            return None;
        }
        let message = format!(
            "the bodies touch along a line that runs through both edges of the {word} along {}: they are computed as if cut off there",
            ["x", "y"][axis]
        );
        let problem = Problem::warning(key, message).judged(EDGES);
        let help = "`frame.plane_strain = true` computes a line of contact that does not end";
        return Some(if parts.case.is_meshed() || axis == 0 {
            problem
        } else {
            problem.help(help)
        });
    }
    if parts.grows() {
        return None;
    }
    let reach = forecast.estimate.reach()?;
    let cut: Vec<&str> = [0, 1]
        .into_iter()
        .filter(|&axis| 2.0 * reach[axis] > size[axis])
        .map(|axis| ["x", "y"][axis])
        .collect();
    (!cut.is_empty()).then(|| {
        let message = format!(
            "the contact will reach the edge of the {word} along {} by the end of the motion, when it is about {} wide",
            both(&cut),
            extents_in_words(reach.map(|axis| 2.0 * axis))
        );
        let needed = reach.map(|axis| ROOM * axis);
        Problem::warning(key, message)
            .judged(EDGES)
            .help(format!("the worn contact needs about {}", wanted(parts, needed)))
    })
}

/// Whether both bodies are finite and end along an axis where the zone does.
fn ends_there(parts: &Parts<'_>, axis: usize) -> bool {
    let half = 0.5 * parts.case.frame.size[axis];
    parts.bodies.iter().all(|body| {
        let Some(finite) = &body.finite else { return false };
        let mut vertices = finite.meshed.mesh.vertices.iter();
        finite.elasticity.is_own()
            && !finite.meshed.placed
            && vertices.all(|vertex| vertex[axis].abs() <= half * (1.0 + 1e-9))
    })
}

fn few_cells(parts: &Parts<'_>, forecast: &Forecast) -> Option<Problem> {
    let (contact, cells) = (forecast.estimate.contact?, forecast.cells_across?);
    // A line contact has no width along the line.
    let wide = (0..2).filter(|&axis| contact.semi_axes[axis].is_finite());
    let fewest = wide.map(|axis| cells[axis]).fold(f64::INFINITY, f64::min);
    (fewest < FEW_CELLS).then(|| {
        let pairs = if parts.has_a_zone() { "pairs" } else { "elements" };
        let message = format!(
            "only {} {pairs} lie across the contact at first: below {FEW_CELLS} its pressures are coarse",
            three(fewest)
        );
        let finer = "mesh it finer in Gmsh (`Mesh.MeshSizeMax`, a `Field` of kind Box)";
        let help = match parts.zone_of_a_file() {
            true if parts.bodies.iter().any(Body::carries) => finer.to_owned(),
            true => format!("take more elements there: `contact = {{ near = [x, y, z], size = .., elements = .. }}` divides them, or {finer}"),
            false => format!("take more elements or a smaller {}", parts.frame_word()),
        };
        let line = verdict::first_contact(fewest);
        Problem::warning(parts.frame_key("elements"), message).judged(line.subject).help(help)
    })
}

/// A contact wide against a body's radius, where a half-space no longer stands for the body.
fn wide(parts: &Parts<'_>, forecast: &Forecast) -> Option<Problem> {
    let reach = forecast.estimate.reach()?;
    for body in &parts.bodies {
        let curvatures = body.curvatures()?;
        let finite = body.finite.as_ref();
        if finite.is_some_and(|finite| finite.elasticity.is_own()) {
            continue;
        }
        for (axis, name) in ["x", "y"].into_iter().enumerate() {
            let share = reach[axis] * curvatures[axis].abs();
            if reach[axis].is_finite() && share > verdict::HALF_SPACE {
                let message = format!(
                    "the contact reaches {} along {name}, {} of this body's radius: a half-space is a poor model of it",
                    length(reach[axis]),
                    three(share)
                );
                let shape = if finite.is_some() { "mesh" } else { "profile" };
                let line = verdict::radius(share, &body.name);
                let key = Key::of(["body", &body.name, shape]);
                return Some(Problem::warning(key, message).judged(line.subject));
            }
        }
    }
    None
}

/// What a plane frame neglects of bodies that conform, where it is doubtful.
fn neglected(parts: &Parts<'_>, forecast: &Forecast) -> Vec<Problem> {
    let hollow = parts.bodies.iter().position(|body| {
        body.curvatures().is_some_and(|both| both.iter().any(|curvature| *curvature < 0.0))
    });
    let key = Key::of(["body", &parts.case.bodies[hollow.unwrap_or(1)].name, "profile"]);
    let lines = forecast.estimate.reach().map(|reach| foreseen::neglected(parts, reach));
    let doubts = lines.into_iter().flatten().filter(|line| line.word() != Word::Good);
    let problem = |line: Line| Problem::warning(key.clone(), line.finding()).judged(line.subject);
    doubts.map(problem).collect()
}

/// A pressure that no elastic body of that hardness bears.
fn too_soft(parts: &Parts<'_>, contact: &Contact) -> Vec<Problem> {
    let hard = parts.case.bodies.iter().filter_map(|body| {
        let key = Key::of(["body", &body.name]);
        let by_law = body.wear.as_ref().and_then(|wear| {
            let key = key.child("wear").child(wear.choice.name).child("hardness");
            Some((wear.values.number("hardness")?, key))
        });
        let part = if body.layers.is_empty() { key.child("material") } else { key.child("layers") };
        let own = || Some((body.indentation_hardness()?, part.child("hardness")));
        let (hardness, key) = by_law.or_else(own)?;
        let over = contact.peak_pressure / hardness;
        let line = verdict::hardness(over, &body.name);
        (line.word() != Word::Good).then(|| {
            let message = format!(
                "the peak pressure {} is {} times the hardness: the body would yield, here it stays elastic",
                pressure(contact.peak_pressure),
                three(over)
            );
            Problem::warning(key, message).judged(line.subject)
        })
    });
    hard.collect()
}
