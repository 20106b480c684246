//! Archard predicts how surfaces in contact wear away.
//!
//! Two elastic bodies are pressed together and slide. Archard finds the pressure between them, lets
//! it wear the surfaces by the Holm-Archard law or one of yours, and repeats the two until the motion
//! is over. Boundary elements do the elasticity: nothing but the surfaces near the contact is
//! divided into elements.
//!
//! # One contact
//!
//! Two materials, two shapes and a load give pressures and approach. The same lines solve bodies with layers
//! ([`Body::layers`]), surfaces that repeat themselves ([`periodic`](simulation::Builder::periodic)) and bodies that are meshed.
//!
//! ```
//! use archard::body::profile::{Flat, Sphere};
//! use archard::motion::Control;
//! use archard::{Body, Contact, Material};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let steel = Material::new(210e9, 0.3)?;
//! let ball = Body::new("ball", Sphere::new(50e-3)?).material(steel);
//! let flat = Body::new("flat", Flat).material(steel);
//! let pressed = Contact::between([ball, flat], Control::Load(10.2))?;
//! let contact = pressed.frame([0.36e-3; 2], [48; 2]).solve()?;
//! // Hertz
//! assert!((contact.peak_pressure() / 219e6 - 1.0).abs() < 0.01);
//! assert!((contact.approach() / 0.444e-6 - 1.0).abs() < 0.01);
//! # Ok(())
//! # }
//! ```
//!
//! [`Contact::rolling`] and [`Contact::shifted`] add friction: tractions, slip and what sticks.
//!
//! # Wear
//!
//! A simulation carries a contact through a motion.
//!
//! ```
//! use archard::body::profile::{Flat, Sphere};
//! use archard::motion::{Control, Sliding, Stepping};
//! use archard::wear::Archard;
//! use archard::{Body, Material, Simulation};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let steel = Material::new(210e9, 0.3)?;
//! let pin = Body::new("pin", Sphere::new(50e-3)?).material(steel).wear(Archard::new(1.33e-13)?);
//! let disc = Body::new("disc", Flat).material(steel);
//! let sliding = Sliding::new().over(0.5, Control::Load(10.2), Stepping::Implicit(5e-3))?;
//! let simulation = Simulation::builder([pin, disc], sliding).frame([1.2e-3; 2], [30; 2]).build()?;
//! let effort = simulation.run(&mut [])?;
//! assert_eq!(effort.steps, 100);
//! # Ok(())
//! # }
//! ```
//!
//! Values are in SI units, as a case in SI would list them. A constructor that checks what it is given
//! returns an [`Invalid`](parameters::Invalid), which names the parameter. The other motions are
//! [`Rolling`](motion::Rolling), [`Fretting`](motion::Fretting), [`Indentation`](motion::Indentation) and
//! [`Path`](motion::Path); the [`Builder`](simulation::Builder) also takes friction, solvers and outputs.
//! The folder `examples` has a program for each motion.
//!
//! [`Builder::settle`](simulation::Builder::settle) takes a relative error in place of elements and steps that are known to be
//! enough: see [`accuracy`].
//!
//! Results go to the [observers](simulation::Observer) handed to `run`: a [`Report`](simulation::Report) has loads, pressures, forces and
//! wear.
//!
//! Case files, files of results and what can be believed of them are in the crate `archard-case`, fits in `archard-lab`.
//!
//! # The names
//!
//! A [`Simulation`] is a [`ContactProblem`], a [`Solver`] and a schedule. The problem
//! is two [`Body`]s, the [`ContactFrame`] of pairs that may touch, the [`Compliance`] of both bodies
//! seen from the frame, and their [`Motion`]; each body may have a [`WearLaw`].
//! What is known at the end of a step is a [`ContactState`]; a [`Contact`] is a problem and a state. Profiles, wear laws, motions and solvers
//! are interchangeable parts. What these pages leave out serves the other crates of the workspace, and may change with any version.
//!
//! SI units everywhere. Signs and axes are
//! stated in [`frame`].

pub mod accuracy;
pub mod body;
pub mod closed_form;
pub mod compliance;
pub mod elastic;
#[doc(hidden)]
pub mod estimate;
pub mod frame;
pub mod friction;
pub mod motion;
#[doc(hidden)]
pub mod numerics;
pub mod parameters;
pub mod problem;
pub mod simulation;
pub mod solve;
pub mod stress;
#[doc(hidden)]
pub mod units;
pub mod wear;

pub use body::{Body, Material};
pub use compliance::Compliance;
pub use frame::ContactFrame;
pub use friction::Friction;
pub use motion::Motion;
pub use problem::{ContactProblem, ContactState};
pub use simulation::{Contact, Simulation};
pub use solve::Solver;
pub use wear::WearLaw;
