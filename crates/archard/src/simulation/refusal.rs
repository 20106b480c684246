//! What does not fit together: laws that depend on what a motion does not define, motions and friction that planes of symmetry or
//! the pairs do not allow. The builder, a case and the engine refuse by the same words.

use std::borrow::Cow;
use std::fmt;

use super::fitted::{Kind, fitted};
use crate::body::Body;
use crate::compliance::bem::contact::ContactError;
use crate::frame::{ContactFrame, OffTheSurface};
use crate::friction::{Circumstance, Friction};
use crate::motion::{Lever, Motion, Passage, Slip};
use crate::parameters::Invalid;
use crate::problem::{ContactProblem, Heating, NoTemperature};
use crate::wear::{Input, Per, WearLaw};

/// The axes of the frame.
const AXES: [&str; 2] = ["x", "y"];

/// The part of a problem that is refused.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Part {
    /// The wear law of the body of that name.
    Wear(String),
    /// The share of the heat that flows into the body of that name.
    Share(String),
    /// The hardness of a body, by its name.
    Hardness(String),
    /// The profile of the body of that name.
    Profile(String),
    /// The layers, or the material, of the body of that name.
    Material(String),
    /// The frame.
    Frame,
    /// The law of friction.
    Friction,
    /// The motion.
    Motion,
    /// The shape or the mesh of the bodies.
    Bodies,
    /// A value of that name.
    Value(Cow<'static, str>),
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Wear(body) => write!(f, "the wear law of `{body}`"),
            Self::Share(body) => write!(f, "the share of the heat of `{body}`"),
            Self::Hardness(body) => write!(f, "the hardness of `{body}`"),
            Self::Profile(body) => write!(f, "the profile of `{body}`"),
            Self::Material(body) => write!(f, "the material of `{body}`"),
            Self::Frame => f.write_str("the frame"),
            Self::Friction => f.write_str("the law of friction"),
            Self::Motion => f.write_str("the motion"),
            Self::Bodies => f.write_str("the bodies"),
            Self::Value(name) => write!(f, "`{name}`"),
        }
    }
}

/// A part that does not fit the others.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    /// The part to change.
    pub part: Part,
    /// What is wrong with it, as the end of a sentence about it.
    pub what: String,
    /// What to do; empty where `what` says it.
    pub help: String,
}

impl Refusal {
    pub(super) fn new(part: Part, what: impl Into<String>, help: impl Into<String>) -> Self {
        Self { part, what: what.into(), help: help.into() }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { part, what, help } = self;
        write!(f, "{part}: {what}")?;
        if help.is_empty() { Ok(()) } else { write!(f, "; {help}") }
    }
}

/// All parts that do not fit together.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub struct Refusals(pub Vec<Refusal>);

impl fmt::Display for Refusals {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, refusal) in self.0.iter().enumerate() {
            write!(f, "{}{refusal}", if index > 0 { "\n" } else { "" })?;
        }
        Ok(())
    }
}

impl From<Invalid> for Refusals {
    fn from(invalid: Invalid) -> Self {
        let Invalid { parameter, message, help, .. } = invalid;
        Self(vec![Refusal::new(Part::Value(parameter), message, help.unwrap_or_default())])
    }
}

impl From<OffTheSurface> for Refusals {
    fn from(error: OffTheSurface) -> Self {
        Self(vec![Refusal::new(Part::Bodies, error.to_string(), "")])
    }
}

impl From<ContactError> for Refusals {
    fn from(error: ContactError) -> Self {
        Self(vec![Refusal::new(Part::Bodies, error.to_string(), "")])
    }
}

impl ContactProblem {
    /// Whether the laws have what they depend on, and the motion is possible on the frame.
    pub(super) fn fits(&self) -> Result<(), Refusals> {
        let Self { bodies, frame, friction, motion, .. } = self;
        let mut all = of_laws(bodies, friction.as_deref(), motion);
        all.extend(across_symmetry(motion, frame.mirrored()));
        all.extend(friction.as_deref().and_then(|law| inclined(law, frame.mirrored())));
        all.extend(of_pairs(motion, frame));
        let shape = Kind { line: frame.is_line(), closed: frame.measure().closed };
        all.extend(fitted(bodies, shape, friction.is_some(), motion));
        all.extend(roaming(bodies, motion));
        if self.goes_by_temperature()
            && let Err(reason @ NoTemperature::NoRows) = self.tells_temperature()
        {
            let what = format!("a law depends on the temperature: {reason}");
            all.push(Refusal::new(Part::Motion, what, ""));
        }
        if all.is_empty() { Ok(()) } else { Err(Refusals(all)) }
    }
}

/// Laws that depend on what is not there.
pub fn of_laws(
    bodies: &[Body; 2],
    friction: Option<&dyn Friction>,
    motion: &Motion,
) -> Vec<Refusal> {
    let about_axes = matches!(&motion.slip, Slip::Sought(drives) if drives.axes.is_some());
    let unshaped = bodies.iter().find(|body| about_axes && body.curvatures().is_none());
    let unshaped = unshaped.map(|body| {
        let what = format!(
            "how bodies creep about their axes follows from their curvatures, and the shape of `{}` has none",
            body.name
        );
        Refusal::new(Part::Motion, what, "give the spin in place of the axes")
    });
    let of_friction = friction.and_then(|law| {
        let known = Known { bodies, friction: true, motion };
        law.inputs().iter().find_map(|input| match input {
            Circumstance::Speed => {
                known.speed(Part::Friction).or_else(|| known.one_speed(Part::Friction))
            }
            Circumstance::Temperature => known.temperature(Part::Friction),
            Circumstance::Distance => known.one_place(Part::Friction),
        })
    });
    let known = Known { bodies, friction: friction.is_some(), motion };
    let of_wear = bodies
        .iter()
        .filter_map(|body| known.wear(&**body.wear.as_ref()?, Part::Wear(body.name.clone())));
    let refused = of_wear.chain(of_friction).chain(yielding(bodies, friction, motion));
    refused.chain(unshaped).chain(directed(bodies, motion)).collect()
}

/// A law that asks for directions of slip where stations of a table are left out, which are so by load and distance alone.
fn directed(bodies: &[Body; 2], motion: &Motion) -> Option<Refusal> {
    motion.table()?.merged()?;
    let asks = |law: &dyn WearLaw| {
        [Input::Vectors, Input::CrossShear].iter().any(|input| law.inputs().contains(input))
    };
    let body = bodies.iter().find(|body| body.wear.as_deref().is_some_and(asks))?;
    let what = "asks for the directions of slip: stations of the table are left out by load and distance alone, and directions with them";
    Some(Refusal::new(
        Part::Wear(body.name.clone()),
        what,
        "leave out `within`: all stations count",
    ))
}

/// A body that yields where its surface does not stay opposite the other, or rubs in increments, or is meshed.
fn yielding(
    bodies: &[Body; 2],
    friction: Option<&dyn Friction>,
    motion: &Motion,
) -> Option<Refusal> {
    let body = bodies.iter().find(|body| body.hardness.is_some())?;
    let moves = !motion.stays() || motion.lever_arm() == Some(Lever::Radius);
    let what = if moves {
        "is for surfaces that stay opposite each other: what passes presses a surface in evenly, which changes no shape, so that it would yield again each time; hardening and residual stresses, by which it settles, are not computed"
    } else if friction.is_some() && motion.increments().is_some() {
        "is for bodies without friction under this motion: what slips is computed of elastic ones"
    } else if bodies.iter().any(|body| body.finite.is_some()) {
        "is for half-spaces: bodies of finite shape stay elastic"
    } else {
        return None;
    };
    Some(Refusal::new(Part::Hardness(body.name.clone()), what, "leave it out"))
}

/// What laws can depend on.
#[derive(Clone, Copy)]
struct Known<'a> {
    bodies: &'a [Body; 2],
    friction: bool,
    motion: &'a Motion,
}

impl Known<'_> {
    fn wear(self, law: &dyn WearLaw, part: Part) -> Option<Refusal> {
        let lacks = |input: &Input| match input {
            Input::Friction => (!self.friction).then(|| {
                let what = "depends on the work of friction, and there is none";
                Refusal::new(part.clone(), what, "give a `friction` table")
            }),
            Input::Speed => self.speed(part.clone()),
            Input::Temperature => self.temperature(part.clone()),
            Input::Rolled => self.motion.driven(0.0).is_none().then(|| {
                let what = "depends on the distance rolled, and the bodies do not roll";
                Refusal::new(part.clone(), what, "this law is one of `motion.rolling`")
            }),
            Input::Vectors | Input::CrossShear | Input::Distance | Input::Depth => None,
        };
        law.inputs().iter().find_map(lacks).or_else(|| {
            let slides = self.motion.lever_arm().is_some()
                && self.motion.track().is_none()
                && self.motion.table().is_none()
                && self.motion.joint().is_none();
            (slides && law.per() == Per::Cycle).then(|| {
                let what =
                    "takes a whole cycle at once, and bodies that slide on the same spot have none";
                let help = "give the motion a track, a stroke or a table, or take a law of every increment";
                Refusal::new(part, what, help)
            })
        })
    }

    fn one_speed(self, part: Part) -> Option<Refusal> {
        let what =
            "depends on the sliding speed, and friction takes one for all stations of a table";
        self.motion.table().map(|_| Refusal::new(part, what, "take a law of friction without it"))
    }

    fn one_place(self, part: Part) -> Option<Refusal> {
        let what = "depends on the distance slid, and friction does not follow points that roam from station to station";
        self.motion.table().map(|_| Refusal::new(part, what, "take a law of friction without it"))
    }

    fn speed(self, part: Part) -> Option<Refusal> {
        let what = "depends on the sliding speed, which this motion does not define";
        let help = "give the `speed`, or the `time`, of a motion that takes it";
        self.motion.speed.is_none().then(|| Refusal::new(part, what, help))
    }

    fn temperature(self, part: Part) -> Option<Refusal> {
        let reason = Heating::for_laws(self.bodies, self.motion, self.friction).err()?;
        let part = match reason {
            NoTemperature::NoShare { body } | NoTemperature::TwoShares { body } => {
                Part::Share(self.bodies[body].name.clone())
            }
            _ => part,
        };
        let help = match reason {
            NoTemperature::NoShare { .. } | NoTemperature::TwoShares { .. } => String::new(),
            NoTemperature::NoBody | NoTemperature::Stays { .. } => {
                "for example `thermal = { conductivity = \"50 W/(m K)\", diffusivity = \"13 mm^2/s\", temperature = \"20 degC\" }`".to_owned()
            }
            NoTemperature::NoBulk { body } => format!(
                "give `body.{}.thermal.temperature`, for example \"20 degC\"",
                self.bodies[body].name
            ),
            NoTemperature::NoSpeed => "give the `speed` of the motion".to_owned(),
            NoTemperature::NoFriction => "give a `friction` table".to_owned(),
            NoTemperature::NoStream | NoTemperature::NoRows => "take another law".to_owned(),
        };
        Some(Refusal::new(part, format!("depends on the temperature: {reason}"), help))
    }
}

/// Axes of friction at an angle to planes of symmetry (x = 0, y = 0), so that it differs on both sides.
pub fn inclined(friction: &dyn Friction, mirrored: [bool; 2]) -> Option<Refusal> {
    let what =
        "its axes lie at an angle to a plane of symmetry: friction is not the same on both sides";
    let help = "model both sides (leave `symmetry` out), or turn the axes along x and y";
    (mirrored != [false; 2] && !friction.map().is_aligned())
        .then(|| Refusal::new(Part::Friction, what, help))
}

/// A motion that takes the bodies across planes of symmetry (x = 0, y = 0).
pub fn across_symmetry(motion: &Motion, mirrored: [bool; 2]) -> Option<Refusal> {
    let moves = motion.crosses();
    let axis = AXES[(0..2).find(|&axis| mirrored[axis] && moves[axis])?];
    let what = format!("moves the bodies along {axis}, across their plane of symmetry {axis} = 0");
    let help = format!("model both sides: take \"{axis}\" out of `symmetry`");
    Some(Refusal::new(Part::Motion, what, help))
}

/// A body that roams from station to station, and whose shape has places of its own: edges, or heights that were measured.
pub fn roaming(bodies: &[Body; 2], motion: &Motion) -> Option<Refusal> {
    let roams = |&body: &usize| motion.roams(body);
    let body = (0..2).filter(roams).find(|&body| bodies[body].curvatures().is_none())?;
    let what = format!(
        "moves `{}`, whose shape has edges or heights at places of their own: a table moves what is worn, and shapes stay as the frame sees them",
        bodies[body].name
    );
    Some(Refusal::new(Part::Motion, what, "let the other body roam, or give a smooth shape"))
}

/// A motion that the pairs do not allow.
fn of_pairs(motion: &Motion, frame: &ContactFrame) -> Option<Refusal> {
    let refusal = |what: &str, help: &str| Some(Refusal::new(Part::Motion, what, help));
    let uniform = frame.is_uniform();
    if let Some(refused) = of_frame(motion, uniform, uniform && frame.measure().closed) {
        return Some(refused);
    }
    if motion.lever_arm() == Some(Lever::Radius) && frame.is_line() {
        return refusal("bodies turn about a point, and a line of contact has none", "");
    }
    if motion.table().is_some() && frame.is_line() && motion.crosses()[1] {
        return refusal("the line of contact lies along y: offsets change along x", "");
    }
    if let Some(refused) = of_strips(motion, frame.is_line().then(|| frame.elements()[1])) {
        return Some(refused);
    }
    if !motion.surfaces.iter().any(Passage::passes) {
        return None;
    }
    if !frame.is_plane() {
        return Some(curved());
    }
    match frame.flow(motion.direction) {
        Err(error) => {
            let what = format!("particles do not pass from pair to pair: {error}");
            refusal(&what, "")
        }
        Ok(flow) if !flow.has_rows() && matches!(motion.slip, Slip::Given(..)) => {
            let help = "take a grid, or a zone with `elements`";
            refusal("a track needs pairs in rows along it", help)
        }
        Ok(_) => None,
    }
}

/// Strips along a line of contact, where there is one, that the motion does not ask for; or a motion that asks for them.
pub fn of_strips(motion: &Motion, strips: Option<usize>) -> Option<Refusal> {
    let uneven = matches!(&motion.slip, Slip::Sought(drives) if !drives.is_even());
    match strips {
        Some(1) if uneven => {
            let what = "bodies that spin, or turn about such axes, slip differently all along a line of contact";
            let help =
                "divide it into strips: `elements = [60, 40]`, the second number along the line";
            Some(Refusal::new(Part::Motion, what, help))
        }
        Some(2..) if !uneven => {
            let what =
                "has strips along the line of contact, and all of them would go through the same";
            let help = "give the number of elements along x alone; strips are for `spin`, `axis_one` and `axis_two`";
            Some(Refusal::new(Part::Frame, what, help))
        }
        _ => None,
    }
}

/// A motion that a frame does not allow which may be uniform, no mesh, and may repeat itself.
pub fn of_frame(motion: &Motion, uniform: bool, periodic: bool) -> Option<Refusal> {
    let refusal = |what: &str, help: &str| Some(Refusal::new(Part::Motion, what, help));
    if motion.surfaces.contains(&Passage::Recurs) && !periodic {
        let what = "surfaces slide past each other for ever only where they repeat themselves";
        return refusal(what, "set `frame.periodic = true`, or leave out `surfaces = \"pass\"`");
    }
    if motion.amplitude().is_some() && !uniform {
        return refusal("surfaces swing on a uniform frame only, not on a mesh", "");
    }
    if motion.table().is_some() && !uniform {
        return refusal("surfaces roam on a uniform frame only, not on a mesh", "");
    }
    if motion.lever_arm() == Some(Lever::Radius) && !uniform {
        return refusal("bodies turn on a uniform frame only, not on a mesh", "");
    }
    None
}

/// Rolling, or a track, on a curved frame.
pub fn curved() -> Refusal {
    let what =
        "bodies roll, and surfaces pass, only where the frame, or the zone of the mesh, is plane";
    Refusal::new(Part::Motion, what, "")
}
