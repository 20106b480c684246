//! What does not fit bodies that fit into each other: a solid or rigid ball in whatever is around it, such a shaft in layers on something
//! rigid, without friction, which stay opposite each other.

use std::f64::consts::FRAC_PI_2;

use super::refusal::{Part, Refusal};
use crate::body::profile::{ClearanceFit, Round};
use crate::body::{Body, Profile};
use crate::compliance::HalfSpace;
use crate::frame::Wrap;
use crate::motion::{Lever, Motion};
use crate::wear::{Input, Per, WearLaw};

/// The kind of a frame.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Kind {
    /// Whether it is a line of contact in plane strain.
    pub line: bool,
    /// Whether surfaces end or repeat themselves with it.
    pub closed: bool,
}

/// The first of what does not fit a ball and its socket, or a shaft and its bush; `None` of bodies that do not fit into each other.
pub fn fitted(bodies: &[Body; 2], kind: Kind, friction: bool, motion: &Motion) -> Option<Refusal> {
    let profiles = bodies.each_ref().map(|body| &*body.profile);
    let of = profiles.map(Profile::fitted);
    let Some(one) = of[0].or(of[1]) else {
        return motion.joint().map(|_| {
            let what = "turns a ball in a socket, and these bodies are none";
            Refusal::new(Part::Motion, what, "give them the profiles `ball` and `socket`")
        });
    };
    if let Some(refusal) = pair(bodies, of, one) {
        return Some(refusal);
    }
    let wrap = Wrap::of(profiles)?;
    let (inner, outer) = (&bodies[1 - wrap.hollow], &bodies[wrap.hollow]);
    let [inside, outside] = wrap.round.names();
    let material = |body: &Body, what: String, help: &str| {
        Some(Refusal::new(Part::Material(body.name.clone()), what, help))
    };
    if let Some(body) = bodies.iter().find(|body| body.finite.is_some()) {
        let what = format!("is meshed, and the contact of a {inside} is drawn on its surface");
        return material(body, what, "leave the mesh out, or give both bodies one and no profile");
    }
    match wrap.round {
        _ if !inner.layers.is_empty() => {
            let what = format!("has layers: a {inside} in a {outside} is solid");
            return material(inner, what, "leave them out, or give both bodies meshes");
        }
        Round::Cylinder if outer.layers.is_empty() || outer.material.is_some() => {
            let what = format!("is no layer on something rigid, as a {outside} has");
            let help = "give its wall as `layers = [{ thickness = .., .. }]` with `substrate = \"rigid\"`, or give both bodies meshes";
            return material(outer, what, help);
        }
        _ => {}
    }
    if wrap.rim < FRAC_PI_2 && (outer.layers.is_empty() || outer.material.is_some()) {
        let what = "has a rim near the contact, which is known of layers on something rigid alone";
        let help = "give its wall as `layers` with `substrate = \"rigid\"`, or leave `rim` out";
        return Some(Refusal::new(Part::Profile(outer.name.clone()), what, help));
    }
    let round = (wrap.round, wrap.radius);
    if let Some(why) = HalfSpace::refuses_round(outer.material.as_ref(), &outer.layers, round) {
        return material(outer, why, "");
    }
    let (frame, help) = match wrap.round {
        Round::Sphere if kind.line => {
            ("is a line of contact", "leave `plane_strain` and `length` out")
        }
        Round::Cylinder if !kind.line => {
            ("is no line of contact", "give it the `length` of the bush along its axis, y")
        }
        _ if kind.closed => ("repeats itself", "leave `periodic` out"),
        _ => ("", ""),
    };
    if !frame.is_empty() {
        let what = format!("{frame}, and a {inside} touches its {outside} on their surface");
        return Some(Refusal::new(Part::Frame, what, help));
    }
    if friction {
        let what = format!(
            "is not computed between a {inside} and its {outside}: friction would turn the load off their pole"
        );
        return Some(Refusal::new(
            Part::Friction,
            what,
            "leave it out: wear by pressure and slip needs none",
        ));
    }
    if let Some(body) = bodies.iter().find(|body| body.hardness.is_some()) {
        let what = format!("is for plane frames: a {inside} and its {outside} stay elastic");
        return Some(Refusal::new(Part::Hardness(body.name.clone()), what, "leave it out"));
    }
    let directed =
        |law: &dyn WearLaw| law.per() == Per::Increment && law.inputs().contains(&Input::Vectors);
    let turning = motion.joint().map(|joint| &bodies[joint.turning(wrap.hollow)]);
    if let Some(body) = turning.filter(|body| body.wear.as_deref().is_some_and(directed)) {
        let what = "depends on the direction of slip along axes of the frame, and the body turns under them";
        let help =
            "take a law that does not, or `cross_shear`, which counts directions on the body";
        return Some(Refusal::new(Part::Wear(body.name.clone()), what, help));
    }
    let joint = motion.joint().is_some() && wrap.round == Round::Sphere;
    let even = motion.lever_arm() == Some(Lever::Even);
    let pressed = motion.increments().is_some() && motion.crosses() == [false; 2];
    (!(motion.stays() && (even || pressed || joint))).then(|| {
        let what = format!(
            "is for plane frames: on a {inside} in its {outside} it would move what wears over a round surface"
        );
        let help = "take `motion.indentation`, `motion.sliding` without a track, where the slip is the same everywhere, or of a ball `motion.joint`";
        Refusal::new(Part::Motion, what, help)
    })
}

/// Two profiles that do not fit into each other.
fn pair(bodies: &[Body; 2], of: [Option<ClearanceFit>; 2], one: ClearanceFit) -> Option<Refusal> {
    let refusal = |body: usize, what: String, help: String| {
        Some(Refusal::new(Part::Profile(bodies[body].name.clone()), what, help))
    };
    let [inside, outside] = one.round.names();
    let own = usize::from(of[0].is_none());
    let [Some(first), Some(second)] = of else {
        let (word, needs, plain) = match one.hollow {
            true => (outside, inside, "a `sphere` or a `cylinder` of negative radius"),
            false => (
                inside,
                outside,
                if one.round == Round::Sphere { "a `sphere`" } else { "a `cylinder`" },
            ),
        };
        let what = format!("a `{word}` needs a `{needs}`");
        let help =
            format!("give `{}` the profile `{needs}`, or this body {plain}", bodies[1 - own].name);
        return refusal(own, what, help);
    };
    if first.round != second.round || first.hollow == second.hollow {
        let word = |one: ClearanceFit| one.round.names()[usize::from(one.hollow)];
        let what = format!("a `{}` does not fit a `{}`", word(second), word(first));
        return refusal(
            1,
            what,
            "a `ball` fits into a `socket`, a `shaft` into a `bush`".to_owned(),
        );
    }
    let [inner, outer] = if first.hollow { [second, first] } else { [first, second] };
    (outer.radius <= inner.radius).then(|| {
        let [ball, socket] = [inner, outer].map(|one| (1e9 * one.radius).round() * 1e-6);
        let hollow = usize::from(second.hollow);
        let what = format!(
            "a {inside} of {ball} mm leaves no clearance in a {outside} of {socket} mm: they would touch everywhere"
        );
        let help = format!("give the {outside} a larger radius");
        Refusal::new(Part::Profile(bodies[hollow].name.clone()), what, help)
    })
}
