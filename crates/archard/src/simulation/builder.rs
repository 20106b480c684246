//! A simulation put together from its parts, in SI.

use std::sync::{Arc, OnceLock};

use super::periodic::repeats;
use super::refusal::Refusals;
use super::setup::Simulation;
use super::swing::offsets;
use crate::body::{Body, Elasticity};
use crate::compliance::bem::contact::{self, Condense, Contact};
use crate::compliance::{Compliance, HalfSpace, Image, Periodic};
use crate::frame::{ContactFrame, Rectangle};
use crate::friction::Friction;
use crate::motion::{Planned, Schedule};
use crate::parameters::{Bound, Invalid, Parameter, Quantity};
use crate::problem::{ContactProblem, UnwornRecess};
use crate::solve::tangential::{FrictionSolver, Newton};
use crate::solve::{ConjugateGradient, Solver};

/// The parts of a [`Simulation`]: two bodies and a motion are always there.
///
/// ```
/// use archard::body::profile::{Flat, Sphere};
/// use archard::body::{Body, Material};
/// use archard::motion::{Control, Sliding, Stepping};
/// use archard::simulation::Simulation;
/// use archard::wear::Archard;
///
/// let steel = Material::new(210e9, 0.3)?;
/// let pin = Body::new("pin", Sphere::new(50e-3)?).material(steel).wear(Archard::new(1.33e-13)?);
/// let disc = Body::new("disc", Flat).material(steel);
/// let sliding = Sliding::new().over(0.5, Control::Load(10.2), Stepping::Implicit(5e-3))?;
/// let simulation =
///     Simulation::builder([pin, disc], sliding).frame([1.2e-3; 2], [30; 2]).build()?;
/// # assert_eq!(simulation.problem.frame.len(), 900);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Builder {
    pub(crate) bodies: [Body; 2],
    pub(crate) planned: Planned,
    /// How much friction the pairs bear, if any.
    pub friction: Option<Arc<dyn Friction>>,
    /// What finds the pressures.
    pub solver: Arc<dyn Solver>,
    /// What finds the friction.
    pub friction_solver: Arc<dyn FrictionSolver>,
    contact: Touch,
    periodic: bool,
}

/// Where the bodies may touch, and how they deform there.
#[derive(Debug, Clone)]
enum Touch {
    /// At the nodes of a mesh.
    Meshed,
    /// On a uniform frame over that rectangle, of so many elements, as half-spaces.
    Frame(Rectangle, [usize; 2]),
    /// Along a line, in plane strain: over that rectangle, of so many elements along x in each of so many strips along y.
    Line(Rectangle, [usize; 2]),
    /// As given.
    Given(ContactFrame, Arc<dyn Compliance>),
}

/// Pairs that a frame may grow to where nobody says how many the memory holds.
const MOST: usize = 1 << 24;

const SIZE: Parameter = Parameter::required("size", Quantity::Length, "size of the frame");
const CENTRE: Parameter =
    Parameter::required("centre", Quantity::Length, "centre of the frame").bound(Bound::Any);
const ELEMENTS: Parameter =
    Parameter::required("elements", Quantity::Count, "number of elements of the frame");

impl Simulation {
    /// Begins with two bodies, body 1 first, and what they are put through, as the motions of
    /// [`motion`](crate::motion) make it.
    pub fn builder(bodies: [Body; 2], planned: Planned) -> Builder {
        Builder {
            bodies,
            planned,
            friction: None,
            solver: Arc::new(ConjugateGradient::default()),
            friction_solver: Arc::new(Newton::default()),
            contact: Touch::Meshed,
            periodic: false,
        }
        .outputs([])
    }
}

impl Builder {
    /// Half-spaces may touch in a rectangle, divided into so many elements along x and y: one of a size (m) about the
    /// origin, or a [`Rectangle`]. Meshed bodies need no frame: theirs are the nodes of a mesh.
    #[must_use]
    pub fn frame(self, rectangle: impl Into<Rectangle>, elements: [usize; 2]) -> Self {
        Self { contact: Touch::Frame(rectangle.into(), elements), ..self }
    }

    /// Half-spaces touch along y in plane strain, within the width along x of a rectangle (as in [`Self::frame`]), divided
    /// into so many elements. Loads, forces and volumes are those of its length along y.
    #[must_use]
    pub fn line(self, rectangle: impl Into<Rectangle>, elements: usize) -> Self {
        self.strips(rectangle, [elements, 1])
    }

    /// A [line](Self::line) in so many strips along its length, for bodies that creep differently along it: that many elements
    /// along x, and strips along y. Each is in plane strain by itself: strips share the approach, and nothing else.
    #[must_use]
    pub fn strips(self, rectangle: impl Into<Rectangle>, elements: [usize; 2]) -> Self {
        Self { contact: Touch::Line(rectangle.into(), elements), ..self }
    }

    /// The surfaces repeat themselves with the frame or the width of the line: loads, forces and volumes are those of one of them.
    /// Both have an even number of elements.
    #[must_use]
    pub fn periodic(self) -> Self {
        Self { periodic: true, ..self }
    }

    /// The elements of the frame or the line; `None` where the pairs are given or those of a mesh.
    pub(crate) fn elements(&self) -> Option<[usize; 2]> {
        match self.contact {
            Touch::Frame(_, elements) | Touch::Line(_, elements) => Some(elements),
            Touch::Meshed | Touch::Given(..) => None,
        }
    }

    /// The same on so many elements, its frame or line moved along x and y (m).
    pub(crate) fn on(self, elements: [usize; 2], by: [f64; 2]) -> Self {
        let moved = |Rectangle { centre, size }| Rectangle {
            centre: [0, 1].map(|axis| centre[axis] + by[axis]),
            size,
        };
        let contact = match self.contact {
            Touch::Frame(rectangle, _) => Touch::Frame(moved(rectangle), elements),
            Touch::Line(rectangle, _) => Touch::Line(moved(rectangle), elements),
            given => given,
        };
        Self { contact, ..self }
    }

    /// The bodies may touch at these pairs, and deform there by that compliance.
    #[must_use]
    pub fn contact(self, frame: ContactFrame, compliance: impl Compliance + 'static) -> Self {
        Self { contact: Touch::Given(frame, Arc::new(compliance)), ..self }
    }

    /// Friction between the bodies; none otherwise.
    #[must_use]
    pub fn friction(self, law: impl Friction + 'static) -> Self {
        Self { friction: Some(Arc::new(law)), ..self }
    }

    /// The solver of the contact steps; [`ConjugateGradient`] otherwise.
    #[must_use]
    pub fn solver(self, solver: impl Solver + 'static) -> Self {
        Self { solver: Arc::new(solver), ..self }
    }

    /// The solver of friction; [`Newton`] otherwise.
    #[must_use]
    pub fn friction_solver(self, solver: impl FrictionSolver + 'static) -> Self {
        Self { friction_solver: Arc::new(solver), ..self }
    }

    /// Fields are due at these places (the motion's own unit) and, always, at the end of the motion; places beyond
    /// it are left out.
    #[must_use]
    pub fn outputs(mut self, places: impl IntoIterator<Item = f64>) -> Self {
        let Schedule { extent, outputs, .. } = &mut self.planned.1;
        *outputs = places.into_iter().filter(|place| place < extent).collect();
        outputs.push(*extent);
        outputs.sort_by(f64::total_cmp);
        outputs.dedup();
        self
    }

    /// Puts the parts together.
    ///
    /// # Errors
    /// If a part is missing, parts do not fit together, or a body does not reach over the frame.
    pub fn build(self) -> Result<Simulation, Refusals> {
        self.build_with(&contact::condense)
    }

    /// The same with something that condenses meshed bodies or knows that they were.
    pub fn build_with(self, condense: Condense<'_>) -> Result<Simulation, Refusals> {
        self.check()?;
        let Self {
            bodies,
            planned: (motion, schedule),
            friction,
            solver,
            friction_solver,
            contact,
            periodic,
        } = self;
        let motion = motion.of_bodies(&bodies);
        let kernel =
            |frame: ContactFrame| -> Result<(ContactFrame, Arc<dyn Compliance>), Refusals> {
                if bodies.iter().any(Body::has_image) {
                    let compliance =
                        Image::moved(bodies.each_ref(), offsets(&bodies, &motion), &frame)?;
                    return Ok((frame, Arc::new(compliance)));
                }
                let materials = bodies.each_ref().map(|body| body.material.as_ref());
                let layers = bodies.each_ref().map(|body| &body.layers[..]);
                let [along, _] = frame.size();
                Ok(if periodic {
                    let depths = Periodic::depths(bodies.each_ref(), &frame);
                    let compliance = Periodic::new(materials, layers, depths, &frame);
                    (frame.closed(), Arc::new(compliance))
                } else if frame.is_line() {
                    let depths = Body::depths(bodies.each_ref(), along);
                    let compliance = HalfSpace::plane_strain(materials, layers, depths, &frame);
                    (frame, Arc::new(compliance))
                } else {
                    let compliance = HalfSpace::layered(materials, layers, &frame);
                    (frame, Arc::new(compliance))
                })
            };
        let (frame, compliance): (_, Arc<dyn Compliance>) = match contact {
            Touch::Given(frame, compliance) => (frame, compliance),
            Touch::Meshed => {
                let Contact { frame, compliance } = Contact::new(bodies.each_ref(), condense)?;
                (frame, compliance)
            }
            Touch::Line(rectangle, elements) => {
                let profiles = bodies.each_ref().map(|body| &*body.profile);
                kernel(ContactFrame::line(rectangle, elements, profiles)?)?
            }
            Touch::Frame(rectangle, elements) => {
                let profiles = bodies.each_ref().map(|body| &*body.profile);
                kernel(ContactFrame::uniform(rectangle, elements, profiles)?)?
            }
        };
        if periodic {
            repeats(&motion, &frame)?;
        }
        let problem = ContactProblem {
            bodies,
            frame,
            compliance,
            friction,
            motion,
            unworn: UnwornRecess::default(),
        };
        problem.fits()?;
        Ok(Simulation {
            problem,
            solver,
            friction_solver,
            schedule,
            companions: None,
            beside: f64::INFINITY,
            wider: None,
            most: MOST,
            surroundings: OnceLock::new(),
        })
    }

    fn check(&self) -> Result<(), Invalid> {
        let wrong = |part, message: &str| Err(Invalid::new(part, message));
        let [one, two] = &self.bodies;
        if let Some(body) = self.bodies.iter().find(|body| !Body::is_name(&body.name)) {
            let message =
                format!("`{}` cannot become part of column names: {}", body.name, Body::NAMES);
            return Err(Invalid::new("name", message));
        }
        if one.name == two.name {
            return wrong("name", "the bodies have the same name");
        }
        if one.uppermost().is_none() && two.uppermost().is_none() {
            return wrong("material", "both bodies are rigid: one has to be elastic");
        }
        for body in &self.bodies {
            if body.finite.is_some() && !body.layers.is_empty() {
                return wrong(
                    "layers",
                    "a body of finite shape has no layers: give its mesh alone",
                );
            }
            if let Some(why) = HalfSpace::refuses(body.material.as_ref(), &body.layers) {
                return Err(Invalid::new("layers", why));
            }
            if body.depth.is_some_and(|depth| depth <= body.coated()) {
                return wrong("depth", "the layers are as thick as the body is deep");
            }
            body.density.map(|density| Body::DENSITY.admit(density)).transpose()?;
            body.hardness.map(|hardness| Body::HARDNESS.admit(hardness)).transpose()?;
            let Some(finite) = &body.finite else { continue };
            match body.material {
                None => {
                    return wrong(
                        "finite",
                        "a rigid body does not deform: give its shape as a profile",
                    );
                }
                Some(material)
                    if material.poisson == 0.5 && finite.elasticity != Elasticity::HalfSpace =>
                {
                    return wrong(
                        "poisson",
                        "a body of finite shape must be compressible: below 0.5",
                    );
                }
                _ => {}
            }
        }
        let meshed = self.bodies.iter().any(|body| body.finite.is_some());
        let images = self.bodies.iter().any(Body::has_image);
        if images && self.bodies.iter().any(|body| body.finite.is_some() && !body.has_image()) {
            return wrong(
                "elasticity",
                "a body with an image field touches a half-space, a rigid body or one with an image field",
            );
        }
        match &self.contact {
            Touch::Given(..) | Touch::Meshed if self.periodic => {
                wrong("periodic", "surfaces repeat themselves with a frame or a line: give one")
            }
            Touch::Frame(..) if images && self.periodic => {
                wrong("periodic", "a body of finite shape does not repeat itself")
            }
            Touch::Meshed if images => wrong(
                "frame",
                "the contact zone of a body with an image field is missing: give the frame's size and elements",
            ),
            Touch::Frame(..) | Touch::Line(..) if meshed && !images => {
                wrong("frame", "the pairs are the nodes of the mesh: leave the frame out")
            }
            Touch::Line(..) if images => wrong(
                "line",
                "a body of finite shape touches on a frame: give its size along y as well",
            ),
            Touch::Frame(rectangle, elements) => {
                admit(rectangle)?;
                elements.iter().try_for_each(|&count| ELEMENTS.admit(count as f64).map(|_| ()))
            }
            Touch::Line(rectangle, elements) => {
                admit(rectangle)?;
                elements.iter().try_for_each(|&count| ELEMENTS.admit(count as f64).map(|_| ()))?;
                self.bodies.iter().try_for_each(|body| line_of_contact(body, rectangle))
            }
            Touch::Meshed if !meshed => wrong(
                "frame",
                "the contact zone of half-spaces is missing: give the frame's size and elements",
            ),
            _ => Ok(()),
        }
    }
}

const DEPTH: Parameter =
    Parameter::optional("depth", Quantity::Length, "depth below the contact in plane strain");

/// Whether the values of a rectangle can be computed with.
fn admit(rectangle: &Rectangle) -> Result<(), Invalid> {
    let Rectangle { centre, size } = rectangle;
    size.iter().try_for_each(|&size| SIZE.admit(size).map(|_| ()))?;
    centre.iter().try_for_each(|&centre| CENTRE.admit(centre).map(|_| ()))
}

/// Whether a body can touch along y within the width along x of a rectangle: its surface must be the same all along y, and the depth
/// (m) it is measured from at least the width, or its compliance would not be positive.
pub fn line_of_contact(body: &Body, rectangle: &Rectangle) -> Result<(), Invalid> {
    let Body { name, profile, depth, .. } = body;
    let (middle, width) = (rectangle.centre[0], rectangle.size[0]);
    let shares = [-0.45, -0.2, 0.0, 0.3, 0.5];
    let varies = shares.iter().any(|x| {
        let recess = |y: f64| profile.recess(middle + x * width, y * width);
        shares.iter().any(|&y| recess(y) != recess(0.0))
    });
    if varies {
        let message = format!(
            "the surface of `{name}` varies along y: in a line of contact it is the same all along"
        );
        return Err(Invalid::new("profile", message));
    }
    match depth.map(|depth| DEPTH.admit(depth)).transpose()? {
        Some(depth) if depth < width => Err(Invalid::new(
            "depth",
            format!(
                "the depth of `{name}` is less than the width of the frame; it has to lie well below the contact"
            ),
        )),
        _ => Ok(()),
    }
}
