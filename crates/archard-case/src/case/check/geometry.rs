//! Whether the bodies meet inside the frame.

use super::Parts;
use super::words::{self, size_list};
use crate::case::definition::FrameCase;
use crate::case::key::Key;
use crate::case::problem::Problem;
use crate::verdict::EDGES;
use archard::body::{Body, Profile};
use archard::frame::ContactFrame;
use archard::numerics::SAME;

/// What is wrong with frame and profiles; nothing else is worth checking then.
pub(super) fn problems(parts: &Parts<'_>) -> Vec<Problem> {
    let case = parts.case;
    let frame = case.frame;
    if !parts.plane() {
        return vec![];
    }
    if let Some(problem) = beside(parts).or_else(|| hollow(parts)) {
        return vec![problem];
    }
    let profiles = parts.bodies.each_ref().map(|body| &*body.profile);
    let on = |frame: FrameCase| ContactFrame::uniform(frame.rectangle(), frame.elements, profiles);
    let widest = (!case.doubles.is_empty()).then(|| on(case.last_frame()));
    match (on(frame), widest) {
        (Err(off), _) => vec![beyond(parts, off.body)],
        (_, Some(Err(off))) => {
            let name = &case.bodies[off.body].name;
            let message = format!("the frame becomes wider than the surface of the body `{name}`");
            vec![Problem::error(Key::of(["frame", "doubles"]), message)]
        }
        (Ok(built), _) => touch(parts, built.gap()).into_iter().collect(),
    }
}

/// A frame next to the middle, where bodies of known curvatures touch.
fn beside(parts: &Parts<'_>) -> Option<Problem> {
    let curvatures = parts.subject().curvatures()?;
    let held = parts.case.frame.rectangle().about_origin();
    (0..2).any(|axis| curvatures[axis] > 0.0 && held[axis] < 0.0).then(|| {
        let message = "the frame does not hold the place where the bodies touch, x = y = 0";
        Problem::error(parts.frame_key("centre"), message)
            .help("leave it out: the frame lies in the middle then")
    })
}

/// Curvatures of both bodies along x and y (1/m), where they have some; their elasticity does not count.
fn curvatures(parts: &Parts<'_>) -> Option<[[f64; 2]; 2]> {
    let [one, two] = parts.bodies.each_ref().map(Body::curvatures);
    Some([one?, two?]).filter(|_| !parts.case.frame.periodic)
}

/// A body that does not fit into the hollow of the other, or fills it.
fn hollow(parts: &Parts<'_>) -> Option<Problem> {
    let [one, two] = curvatures(parts)?;
    let sum = [0, 1].map(|axis| one[axis] + two[axis]);
    let fills = |axis: usize| {
        let [sum, size] = [sum[axis].abs(), one[axis].abs()];
        size > 0.0 && sum <= SAME * size
    };
    let deeper = |axis: &usize| sum[*axis] < 0.0 && !fills(*axis);
    let inner = [one, two].map(|both| both.iter().any(|curvature| *curvature < 0.0));
    let bodies = &parts.case.bodies;
    let hollow = usize::from(!inner[0]);
    let (name, other) = (&bodies[hollow].name, &bodies[1 - hollow].name);
    let key = Key::of(["body", name, "profile"]);
    let radius = |axis: usize| {
        [[one, two][1 - hollow][axis], [one, two][hollow][axis]].map(|curvature| {
            if curvature == 0.0 { "a plane".to_owned() } else { words::radius(curvature.recip()) }
        })
    };
    let word = parts.frame_word();
    if let Some(axis) = (0..2).find(deeper) {
        let [inside, around] = radius(axis);
        let along = ["x", "y"][axis];
        let message = format!(
            "the bodies together are hollow along {along}: `{other}` ({inside}) does not fit into `{name}` ({around}), and they would touch at the edge of the {word} first"
        );
        let help = "a hollow needs a larger radius than what lies in it: the curvatures 1/R of both bodies have to add up to more than zero";
        return Some(Problem::error(key, message).help(help));
    }
    let flat = (0..2).all(|axis| fills(axis) || sum[axis] == 0.0);
    let axis = (0..2).find(|&axis| fills(axis)).filter(|_| flat)?;
    let [_, around] = radius(axis);
    let message = format!(
        "`{other}` fills the hollow of `{name}`: both have the radius {around}, and the contact would fill the whole {word}"
    );
    Some(
        Problem::error(key, message)
            .help("give the hollow a larger radius: the clearance between them"),
    )
}

/// The frame reaches beyond the surface of that body.
fn beyond(parts: &Parts<'_>, body: usize) -> Problem {
    let case = parts.case;
    let message = format!("reaches beyond the surface of the body `{}`", case.bodies[body].name);
    let problem = Problem::error(parts.frame_key("size"), message);
    match largest_share(parts, &*parts.bodies[body].profile) {
        share if share < 1e-6 => problem.help("the profile does not cover the centre of the frame"),
        share => {
            let sizes = case.frame.size.map(|size| size * share);
            problem.help(format!("with this shape, the largest that fits is {}", size_list(sizes)))
        }
    }
}

/// The share of the frame's size up to which its corner elements lie on a surface.
fn largest_share(parts: &Parts<'_>, profile: &dyn Profile) -> f64 {
    let frame = parts.case.frame;
    let (spacing, middle) = (frame.spacing(), frame.centre);
    let corner = [0, 1].map(|axis| 0.5 * (frame.size[axis] - spacing[axis]));
    let reaches = |share: f64| {
        [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]].iter().all(|[x, y]| {
            let place = [middle[0] + share * x * corner[0], middle[1] + share * y * corner[1]];
            profile.recess(place[0], place[1]).is_finite()
        })
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if reaches(middle) { low = middle } else { high = middle }
    }
    low
}

/// Gaps that show nothing of the shape: the centres of up to two elements along an axis lie at the same distance
/// from the middle, those of more do not.
fn alike(parts: &Parts<'_>, what: &str) -> Problem {
    let word = parts.frame_word();
    let (key, why) = match parts.case.frame.elements.iter().all(|&elements| elements <= 2) {
        true => ("elements", "has too few elements"),
        false => ("size", "is too small compared with the shape of the bodies"),
    };
    Problem::error(parts.frame_key(key), format!("{what}: the {word} {why}"))
}

/// Whether the bodies touch where a contact can grow.
fn touch(parts: &Parts<'_>, gap: &[f64]) -> Option<Problem> {
    let largest = gap.iter().copied().fold(0.0, f64::max);
    let least = gap.iter().copied().fold(f64::INFINITY, f64::min);
    if largest > 0.0 && largest - least <= 1e-9 * largest {
        return Some(alike(parts, "every element has the same gap"));
    }
    let curvatures = parts.subject().curvatures();
    if largest == 0.0 && curvatures != Some([0.0; 2]) {
        return Some(alike(parts, "no gap between the bodies at any element"));
    }
    if largest == 0.0 {
        let key = Key::of(["body", &parts.case.bodies[1].name, "profile"]);
        let message = format!(
            "both surfaces are the same plane: the contact would fill the whole {}",
            parts.frame_word()
        );
        return Some(Problem::error(key, message).help("give one of the bodies a curved profile"));
    }
    let [nx, ny] = parts.case.frame.elements;
    let edge = |pair: usize| {
        pair.is_multiple_of(nx) || pair % nx + 1 == nx || pair < nx || pair >= nx * (ny - 1)
    };
    let lowest = |inside: bool| {
        let pairs = (0..gap.len()).filter(|&pair| edge(pair) != inside);
        pairs.map(|pair| gap[pair]).fold(f64::INFINITY, f64::min)
    };
    // Surfaces that repeat themselves have no edge.
    let ends = !parts.grows() && !parts.case.frame.periodic;
    (ends && nx > 2 && ny > 2 && lowest(false) < lowest(true)).then(|| {
        let message = format!(
            "the bodies touch first at the edge of the {}: the contact is cut off there",
            parts.frame_word()
        );
        Problem::warning(parts.frame_key("size"), message).judged(EDGES)
    })
}
