//! Whether meshed bodies lie opposite each other, are held, and suit the motion.

use super::Parts;
use super::words::both;
use crate::case::definition::{BodyCase, FrameCase};
use crate::case::key::Key;
use crate::case::problem::Problem;
use archard::body::Body;
use archard::compliance::Image;
use archard::compliance::bem::Indeterminacy;
use archard::compliance::bem::contact::{BodiesInContact, ContactError};
use archard::frame::Pairs;
use archard::motion::Passage;
use archard::simulation::offsets;
use archard::simulation::refusal;

const AXES: [&str; 2] = ["x", "y"];

/// What is wrong with meshed bodies; there is one at least.
pub(super) fn problems(parts: &Parts<'_>) -> Vec<Problem> {
    let mut problems = on_the_zone(parts);
    if let Some((_, mirrored)) = parts.halved() {
        let across = refusal::across_symmetry(&parts.motion, mirrored);
        let askew = parts.friction.as_deref().and_then(|law| refusal::inclined(law, mirrored));
        problems.extend(across.into_iter().chain(askew).filter_map(|one| parts.refused(one)));
    }
    match BodiesInContact::of(parts.bodies.each_ref()) {
        Err(error) => problems.push(said(parts, error)),
        Ok(meeting) => {
            problems.extend(lopsided(parts, meeting.pairs()));
            if parts.motion.surfaces.iter().any(Passage::passes) && !meeting.is_plane() {
                problems.extend(parts.refused(refusal::curved()));
            }
        }
    }
    problems
}

/// What is wrong with bodies that have image fields.
pub(super) fn of_images(parts: &Parts<'_>) -> Option<Problem> {
    let FrameCase { line, periodic, .. } = parts.case.frame;
    if !parts.bodies.iter().any(Body::has_image) {
        return None;
    }
    if line || periodic {
        let name = if line { "plane_strain" } else { "periodic" };
        let message = "a body of finite shape has an end: it touches neither along an endless line nor again and again";
        return Some(Problem::error(Key::of(["frame", name]), message));
    }
    let offsets = offsets(&parts.bodies, &parts.motion);
    let met = Image::meets(parts.bodies.each_ref(), offsets, parts.case.frame.rectangle());
    met.err().map(|error| said(parts, error))
}

/// The key of something of a body.
fn key(body: &BodyCase, name: &str) -> Key {
    Key::of(["body", &body.name, name])
}

/// An error where it can be put right.
fn said(parts: &Parts<'_>, error: ContactError) -> Problem {
    let bodies = &parts.case.bodies;
    let message = error.to_string();
    match error {
        ContactError::Symmetry => symmetry(bodies),
        ContactError::Undetermined { body, cause } => {
            let body = &bodies[body];
            let problem = undetermined(parts, body, &cause);
            Problem { key: key(body, "supports"), ..problem }
        }
        ContactError::NotOpposite { body, place: [x, y, z] } => {
            let message = format!(
                "reaches beyond the zone of `{}`, which has nothing opposite to x = {x:.4e} m, y = {y:.4e} m, z = {z:.4e} m of this body",
                bodies[1 - body].name
            );
            Problem::error(parts.zone_key(&bodies[body], "size"), message)
                .help("make it smaller, or the zone of the other body larger")
        }
        ContactError::Steep { body, angle } => {
            let message = format!(
                "the zone turns by {angle:.0} degrees from the plane of contact: no half-space stands for it"
            );
            Problem::error(key(&bodies[body], "elasticity"), message)
                .help("make the zone smaller, or leave `elasticity` out")
        }
        ContactError::BesideTheFace => {
            let message = "reaches beyond the flat face of a body of finite shape";
            Problem::error(parts.frame_key("size"), message)
                .help("make it smaller, or let a mesh say where the body touches: `elasticity = \"boundary_elements\"`")
        }
        ContactError::LeavesTheFace { body } => {
            let message = format!(
                "moves `{}` until the frame reaches beyond its flat face",
                bodies[body].name
            );
            Problem::error(Key::of(["motion", parts.case.motion.choice.name]), message)
                .help("move it less, or make it longer")
        }
        ContactError::OffTheSurface(off) => {
            let name = &bodies[off.body].name;
            let message = format!("reaches beyond the surface of the body `{name}`");
            Problem::error(parts.frame_key("size"), message)
                .help("the profile does not cover the zone of the mesh")
        }
        ContactError::SameWay { body } => {
            Problem::error(parts.zone_key(&bodies[body], "size"), message)
                .help("turn the body over in its file, or name the other side of it as `contact`")
        }
        ContactError::Matrix { body, message } => {
            let mesh = key(&bodies[body], "mesh").child("file");
            Problem::error(mesh.child("compliance"), message)
        }
        ContactError::NoZone { body }
        | ContactError::HasImage { body }
        | ContactError::Hollow { body }
        | ContactError::Singular { body, .. } => {
            Problem::error(key(&bodies[body], "mesh"), message).at_name()
        }
        ContactError::Pairs(_) | ContactError::NoMemory(_) => {
            Problem::error(parts.frame_key("elements"), message)
        }
    }
}

/// One body is halved and the other is not.
fn symmetry(bodies: &[BodyCase; 2]) -> Problem {
    let mirrored =
        |body: usize| bodies[body].finite.as_ref().map_or([false; 2], |one| one.mirrored);
    let axis = usize::from(mirrored(0)[0] == mirrored(1)[0]);
    let halved = usize::from(mirrored(1)[axis]);
    let message = format!(
        "the plane {} = 0 halves this body, and not `{}`",
        AXES[axis],
        bodies[1 - halved].name
    );
    Problem::error(key(&bodies[halved], "symmetry"), message)
        .help("give both bodies the same `symmetry`")
}

/// A body that is not held, or held twice.
fn undetermined(parts: &Parts<'_>, body: &BodyCase, cause: &Indeterminacy) -> Problem {
    match cause {
        Indeterminacy::Free { modes } => {
            let message = format!("nothing holds the body against {}", both(modes));
            Problem::error(Key::default(), message)
                .help("clamp a surface, or give rollers or displacements on several")
        }
        Indeterminacy::TwoSupports { place: [x, y, z], surfaces } => {
            let mesh = parts.meshed().find(|(other, _)| other.name == body.name);
            let names = surfaces.map(|surface| {
                let name = mesh.and_then(|(_, finite)| finite.meshed.mesh.surfaces.get(surface));
                name.map_or_else(String::new, |name| format!("`{name}`"))
            });
            let message = format!(
                "{} and {} both say how the body is displaced where they meet at x = {x:.4e} m, y = {y:.4e} m, z = {z:.4e} m: continuous elements bear one traction there",
                names[0], names[1]
            );
            Problem::error(Key::default(), message).help(
                "take `boundary_elements.interpolation = \"discontinuous\"`, or hold one of them",
            )
        }
    }
}

/// Supports of a surface that may touch all over.
fn on_the_zone(parts: &Parts<'_>) -> Vec<Problem> {
    let mut problems = vec![];
    for (body, finite) in parts.meshed() {
        let (mesh, zone) = (&finite.meshed.mesh, &finite.meshed.zone.faces);
        for (surface, _) in &finite.supports {
            let of_it = |face: usize| mesh.faces[face].surface == *surface;
            let touching = zone.iter().filter(|&&face| of_it(face)).count();
            if touching > 0 && touching == (0..mesh.faces.len()).filter(|&face| of_it(face)).count()
            {
                let message = "is the surface that may touch: what acts on it is found, not given";
                let key = key(body, "supports").child(&mesh.surfaces[*surface]);
                problems.push(Problem::error(key, message).at_name());
            }
        }
    }
    problems
}

/// A profile that is not symmetric where a mesh is.
fn lopsided(parts: &Parts<'_>, pairs: &Pairs) -> Option<Problem> {
    let (halved, mirrored) = parts.halved()?;
    let largest = pairs.gap.iter().fold(0.0_f64, |largest, gap| largest.max(gap.abs()));
    for (axis, name) in AXES.into_iter().enumerate().filter(|(axis, _)| mirrored[*axis]) {
        let uneven = |body: &&Body| {
            pairs.places.iter().any(|&[x, y, _]| {
                let [there_x, there_y] = if axis == 0 { [-x, y] } else { [x, -y] };
                let difference = body.profile.recess(x, y) - body.profile.recess(there_x, there_y);
                // A table that ends on the other side is uneven as well.
                difference.is_nan() || difference.abs() > 1e-6 * largest
            })
        };
        let Some(body) = parts.bodies.iter().find(uneven) else { continue };
        let message = format!(
            "the profile of `{}` is not the same on both sides of the plane {name} = 0",
            body.name
        );
        return Some(Problem::error(key(halved, "symmetry"), message));
    }
    None
}
