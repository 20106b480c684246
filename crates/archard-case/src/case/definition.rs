//! A case that passed every check: what to compute, in SI.

use std::sync::Arc;

use super::check::{Parts, footprint, memory};
use super::chosen::ChosenPart;
use super::finite::FiniteCase;
use super::material::MaterialCase;
use crate::output::{Inside, Limit, Store, WantedStresses};
pub(in crate::case) use archard::accuracy::MOST;
use archard::body::mesh::MeshError;
use archard::body::{Body, Elasticity, Layer, Profile, Thermal};
use archard::compliance::bem::contact::{self, Condense, Job, condense};
use archard::compliance::bem::{Listener, StageProgress};
use archard::elastic::{Point, Section};
use archard::frame::Rectangle;
use archard::friction::Friction;
use archard::motion::Planned;
use archard::numerics::SAME;
use archard::parameters::Invalid;
use archard::simulation::{self, Simulation};
use archard::solve::Solver;
use archard::solve::tangential::FrictionSolver;
use archard::wear::{LayeredWear, WearLaw};

/// Elements up to which one thread is the default: `twin_disc`, with 41 x 81, hardly gains from a second one, which
/// takes far more of the processors' time.
const FEW_ELEMENTS: usize = 60 * 60;

/// A checked case in SI. It prints as a case file that reads back to the same bits.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// What it is about.
    pub title: Option<String>,
    /// Relative error that is asked for; `None` where none is.
    pub accuracy: Option<f64>,
    /// The bodies in the order in which they are written.
    pub bodies: [BodyCase; 2],
    /// The potential contact zone.
    pub frame: FrameCase,
    /// From where on (the motion's own unit) it is twice as wide, with elements twice as large; rising.
    pub doubles: Vec<f64>,
    /// The friction between the bodies; `None` without.
    pub friction: Option<ChosenPart<Box<dyn Friction>>>,
    /// The motion.
    pub motion: ChosenPart<Planned>,
    /// The solver of the contact steps.
    pub solver: ChosenPart<Box<dyn Solver>>,
    /// The solver of friction.
    pub friction_solver: ChosenPart<Box<dyn FrictionSolver>>,
    /// When fields are put out.
    pub output: Output,
    /// Limits at which the run ends before the end of the motion, at the first that is reached.
    pub until: Vec<Limit>,
    /// Points of each body where displacement and stress are put out at the end.
    pub points: [Vec<Point>; 2],
    /// Sections of each body on which they are put out at the end.
    pub sections: [Vec<Section>; 2],
    /// What is wanted of the largest stresses in each body, at the end.
    pub stresses: [Option<WantedStresses>; 2],
}

/// One body of a case.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq)]
pub struct BodyCase {
    /// Its name.
    pub name: String,
    /// What it is made of, below its layers; `None` if that is rigid.
    pub material: Option<MaterialCase>,
    /// Layers from its surface down.
    pub layers: Vec<LayerCase>,
    /// Its shape; of a meshed body, what its surface lies below the mesh.
    pub profile: ChosenPart<Box<dyn Profile>>,
    /// Its mesh; `None` for a half-space.
    pub finite: Option<FiniteCase>,
    /// How it wears; `None` if it does not.
    pub wear: Option<ChosenPart<Box<dyn WearLaw>>>,
    /// How far below a line of contact its approach and shift are measured from (m); `None` for the default.
    pub depth: Option<f64>,
    /// Its density (kg/m^3); `None` where that of its material counts.
    pub density: Option<f64>,
    /// The pressure (Pa) under which it yields; `None` where it stays elastic.
    pub hardness: Option<f64>,
    /// How it conducts heat; `None` where its material gives all that is known.
    pub thermal: Option<Thermal>,
}

/// A layer, its values in SI.
#[derive(Debug, Clone, PartialEq)]
pub struct LayerCase {
    /// What it is made of, and how thick it is.
    pub layer: Layer,
    /// The name of its material; `None` for one of the user's.
    pub name: Option<String>,
    /// Its indentation hardness (Pa); `None` where it is not known.
    pub hardness: Option<f64>,
    /// How it wears; `None` if it wears as the body below it.
    pub wear: Option<ChosenPart<Box<dyn WearLaw>>>,
}

/// The frame of a case; where a body is meshed, what its contact zone amounts to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameCase {
    /// Its middle along x and y (m).
    pub centre: [f64; 2],
    /// Size along x and y (m).
    pub size: [f64; 2],
    /// Number of elements along x and y.
    pub elements: [usize; 2],
    /// Size (m) that elements are to have along x and y, until their number is chosen by it; zero where nobody asks for one.
    pub(crate) element: [f64; 2],
    /// Whether it is a line of contact along y in plane strain.
    pub line: bool,
    /// Whether the surfaces repeat themselves with it.
    pub periodic: bool,
}

/// When fields are put out; the end of the motion always is one of the places.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq)]
pub enum Output {
    /// Each time the motion went on by that much (its own unit).
    Every(f64),
    /// At these places, rising (the motion's own unit).
    At(Vec<f64>),
}

/// A case whose parts cannot be put together; a checked one can.
#[non_exhaustive]
#[derive(Debug, thiserror::Error)]
pub enum BuildError {
    /// Values that do not fit together.
    #[error(transparent)]
    Invalid(#[from] Invalid),
    /// A mesh that cannot be made.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// More elements than the memory that is free holds.
    #[error(
        "the run would take about {needed} of memory, {free} are free: take fewer `frame.elements`"
    )]
    Memory {
        /// The memory it takes, in words.
        needed: String,
        /// The memory there is, in words.
        free: String,
    },
    /// Parts that do not make a simulation.
    #[error(transparent)]
    Parts(#[from] simulation::Refusals),
}

impl Output {
    /// The places up to an extent (the motion's own unit), which is the last of them.
    pub fn places(&self, extent: f64) -> Vec<f64> {
        let inside = |place: &f64| *place < extent * (1.0 - 1e-9);
        let mut places: Vec<f64> = match self {
            Output::At(places) => places.iter().copied().filter(inside).collect(),
            Output::Every(interval) => {
                let intervals = (extent / interval).round();
                let whole = (intervals * interval - extent).abs() < 1e-9 * extent;
                // Where the extent is a multiple, parts of it are rounded less than sums.
                let place = |i: f64| if whole { extent * i / intervals } else { interval * i };
                (1..).map(|i| place(f64::from(i))).take_while(inside).collect()
            }
        };
        places.push(extent);
        places
    }
}

impl FrameCase {
    /// As many elements as cover it, none larger than the size that is asked for; an even number where it repeats itself.
    pub(super) fn count(&mut self) {
        for axis in 0..if self.line { 1 } else { 2 } {
            let count = (1.0 - SAME) * self.size[axis] / self.element[axis];
            let whole = if self.periodic { 2.0 * (0.5 * count).ceil() } else { count.ceil() };
            self.elements[axis] = whole as usize;
        }
        self.element = [0.0; 2];
    }

    /// One whose size and elements follow from an accuracy.
    pub(super) fn to_be_chosen() -> Self {
        let (centre, size, elements) = ([0.0; 2], [0.0; 2], [0; 2]);
        Self { centre, size, elements, element: [0.0; 2], line: false, periodic: false }
    }

    /// What it covers.
    pub fn rectangle(&self) -> Rectangle {
        Rectangle { centre: self.centre, size: self.size }
    }

    /// Size of an element along x and y (m).
    pub fn spacing(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.size[axis] / self.elements[axis] as f64)
    }
}

impl BodyCase {
    /// Whether it wears, or one of its layers does.
    pub fn wears(&self) -> bool {
        self.wear.is_some() || self.layers.iter().any(|layer| layer.wear.is_some())
    }

    /// How it wears: layers without a law of their own by that of the body.
    pub(super) fn law(&self) -> Result<Option<Arc<dyn WearLaw>>, Invalid> {
        let of = |wear: &Option<ChosenPart<Box<dyn WearLaw>>>| -> Result<_, Invalid> {
            Ok(wear.as_ref().map(ChosenPart::build).transpose()?.map(Arc::from))
        };
        let below = of(&self.wear)?;
        if self.layers.iter().all(|layer| layer.wear.is_none()) {
            return Ok(below);
        }
        let layers = self.layers.iter().map(|one| {
            let own = of(&one.wear)?;
            Ok((one.layer.thickness, own.or_else(|| below.clone())))
        });
        let layers = layers.collect::<Result<Vec<_>, Invalid>>()?;
        Ok(Some(Arc::new(LayeredWear::new(layers, below)?)))
    }

    /// What its material gives of the body; nothing of one with layers, which is another at its surface.
    pub(super) fn made_of<T>(&self, tells: fn(&MaterialCase) -> Option<T>) -> Option<T> {
        self.material.as_ref().filter(|_| self.layers.is_empty()).and_then(tells)
    }

    /// Indentation hardness (Pa) of what it is made of at its surface, where that is known.
    pub fn indentation_hardness(&self) -> Option<f64> {
        match self.layers.first() {
            Some(layer) => layer.hardness,
            None => self.made_of(|material| material.hardness),
        }
    }

    /// Whether it is meshed where it touches.
    pub(super) fn is_meshed(&self) -> bool {
        self.finite.as_ref().is_some_and(|finite| finite.elasticity != Elasticity::Image)
    }

    /// Whether it deforms as a half-space with an image field.
    pub(super) fn has_image(&self) -> bool {
        self.finite.as_ref().is_some_and(|finite| finite.elasticity == Elasticity::Image)
    }

    /// Builds the body, which touches on a frame where no mesh says where.
    pub(super) fn build(&self, frame: &FrameCase) -> Result<Body, BuildError> {
        Ok(Body {
            name: self.name.clone(),
            profile: self.profile.build()?.into(),
            material: self.material.as_ref().map(|material| material.elastic),
            layers: self.layers.iter().map(|layer| layer.layer).collect(),
            finite: self.finite.as_ref().map(|finite| finite.build(frame)).transpose()?,
            wear: self.law()?,
            depth: self.depth,
            hardness: self.hardness,
            density: self.density.or(self.made_of(|material| material.density)),
            indentation_hardness: self.indentation_hardness(),
            thermal: self.thermal,
        })
    }
}

impl Case {
    /// Whether the pairs are the nodes of a mesh.
    pub fn is_meshed(&self) -> bool {
        self.bodies.iter().any(BodyCase::is_meshed)
    }

    /// Whether something inside of its bodies is put out at the end.
    pub(super) fn seeks_inside(&self) -> bool {
        self.points.iter().any(|own| !own.is_empty())
            || self.sections.iter().any(|own| !own.is_empty())
            || self.stresses.iter().any(Option::is_some)
    }

    /// What puts out the inside of its bodies at the end.
    pub fn inside(&self) -> Inside {
        Inside::at(self.points.clone())
            .on(self.sections.clone())
            .largest(self.stresses.clone())
            .repeating(self.frame.periodic)
    }

    /// The frame after it became wider so many times.
    pub(super) fn frame_after(&self, doubled: usize) -> FrameCase {
        let factor = 2f64.powi(i32::try_from(doubled).unwrap_or(i32::MAX));
        FrameCase { size: self.frame.size.map(|size| factor * size), ..self.frame }
    }

    /// The frame at the end.
    pub(super) fn last_frame(&self) -> FrameCase {
        self.frame_after(self.doubles.len())
    }

    /// Whether a second thread would cost more than it saves: half-spaces on a frame of few elements.
    pub fn is_small(&self) -> bool {
        let [nx, ny] = self.frame.elements;
        !self.is_meshed() && nx * ny <= FEW_ELEMENTS
    }

    /// The parts, if the memory that is free holds the run. What meshed bodies take follows from what is kept of them.
    fn fitting(&self) -> Result<Parts<'_>, BuildError> {
        let parts = Parts::of(self)?;
        let (needed, free) = (footprint::memory(&parts), memory::free_memory());
        if needed > free && !self.is_meshed() {
            let [needed, free] = [needed, free].map(memory::size);
            return Err(BuildError::Memory { needed, free });
        }
        Ok(parts)
    }

    /// Puts the parts together.
    ///
    /// # Errors
    /// If they do not fit, which a checked case does.
    pub fn build(&self) -> Result<Simulation, BuildError> {
        self.build_with(&contact::condense)
    }

    /// The same, compliances of meshed bodies taken from a store or kept there.
    ///
    /// # Errors
    /// As [`Case::build`].
    pub fn build_keeping(&self, store: &Store) -> Result<Simulation, BuildError> {
        self.build_with(&|finite, material, job| store.condense(finite, material, job))
    }

    /// The same, with a store or without, and told how far the equations of meshed bodies are.
    ///
    /// # Errors
    /// As [`Case::build`].
    pub fn build_telling(
        &self,
        store: Option<&Store>,
        tell: &(dyn Fn(StageProgress) + Sync),
    ) -> Result<Simulation, BuildError> {
        self.build_with(&|finite, material, job| {
            let job = Job { told: Listener::by(tell), ..*job };
            match store {
                Some(store) => store.condense(finite, material, &job),
                None => condense(finite, material, &job),
            }
        })
    }

    /// The same with something that condenses meshed bodies or knows that they were.
    #[doc(hidden)]
    pub fn build_with(&self, condense: Condense<'_>) -> Result<Simulation, BuildError> {
        let mut simulation = self.build_on(self.last_frame(), condense)?;
        for (doubled, from) in self.doubles.iter().enumerate().rev() {
            simulation =
                self.build_on(self.frame_after(doubled), condense)?.widened(*from, simulation)?;
        }
        Ok(simulation)
    }

    fn build_on(&self, frame: FrameCase, condense: Condense<'_>) -> Result<Simulation, BuildError> {
        let parts = self.fitting()?;
        let most = footprint::pairs_within(&parts, memory::free_memory());
        let Parts { bodies, friction, motion, schedule, .. } = parts;
        let outputs = self.output.places(schedule.extent);
        let mut builder = Simulation::builder(bodies, (motion, schedule)).outputs(outputs);
        builder.friction = friction.map(Into::into);
        builder.solver = self.solver.build()?.into();
        builder.friction_solver = self.friction_solver.build()?.into();
        let (rectangle, elements) = (frame.rectangle(), frame.elements);
        let builder = match frame.line {
            _ if self.is_meshed() => builder,
            true => builder.strips(rectangle, elements),
            false => builder.frame(rectangle, elements),
        };
        let builder = if frame.periodic { builder.periodic() } else { builder };
        let mut simulation = builder.build_with(condense)?;
        // A frame grows as far as the memory goes.
        simulation.most = simulation.most.min(most);
        Ok(simulation)
    }
}
