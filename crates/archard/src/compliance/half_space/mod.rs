//! Two elastic half-spaces: the uniform tractions of rectangular elements (Boussinesq, Cerruti, Love), or of strips in
//! plane strain (Flamant), summed by fast convolution; with layers as images at depths below the surface.

mod curved;
mod differences;
mod images;
mod influence;
#[doc(hidden)]
pub mod inside;
mod part;
mod periodic;
mod rolling;
mod round;
mod shaft;
mod shifting;
mod sphere;
mod stack;

use std::fmt;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use crate::body::profile::Round;
use crate::body::{Layer, Material};
use crate::compliance::{Compliance, Preconditioner, SlipMap};
use crate::frame::{ContactFrame, Flow, Part, VectorField};
use crate::numerics::convolution::{Convolution, Parity, Spectrum};

use curved::{Bending, Curved};
pub(in crate::compliance) use influence::Constants;
use influence::Influence;
use part::WholeOrPart;
pub use periodic::Periodic;
use rolling::Rolling;
use shaft::Shaft;
use shifting::Shifting;
use stack::Stack;

/// By how much images may miss the compliance of layers, relative to that of the uppermost one: less than elements do.
const MISSED: f64 = 1e-4;

/// The sum of the compliances of two half-spaces on a uniform frame; a rigid body adds nothing.
///
/// An application costs O(N log N) and memory is O(N) in the number of pairs. Kernels are made when
/// first needed: a frictionless problem never makes the tangential ones.
pub struct HalfSpace {
    influence: Influence,
    convolution: Convolution,
    /// Where the elements lie on a sphere; `None` of a plane frame or an arc.
    curved: Option<Curved>,
    bending: OnceLock<Bending>,
    normal: OnceLock<Spectrum>,
    /// xx, xy and yy.
    tangential: OnceLock<[Spectrum; 3]>,
    /// xn and yn.
    coupling: OnceLock<[Spectrum; 2]>,
    periodic: OnceLock<(Convolution, Spectrum)>,
    /// The inverse of the tangential compliance of a frame that repeats itself: xx, xy and yy.
    tangential_inverse: OnceLock<(Convolution, [Spectrum; 3])>,
    /// The same half-spaces under elements of twice the size, and under parts of the elements, the one last asked for
    /// at the end.
    coarser: OnceLock<Arc<HalfSpace>>,
    parts: Mutex<Vec<Arc<HalfSpace>>>,
}

impl fmt::Debug for HalfSpace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("HalfSpace").field("influence", &self.influence).finish_non_exhaustive()
    }
}

impl HalfSpace {
    /// The half-spaces of these materials under the elements of a frame; `None` for a rigid body.
    pub fn new(materials: [Option<&Material>; 2], frame: &ContactFrame) -> Self {
        Self::on(Influence::new(Constants::of(materials), frame.elements(), frame.spacing()), None)
    }

    /// The half-spaces of these materials, `None` for something rigid, under layers from the surface down. Where the frame is drawn
    /// on a [round surface](crate::frame::Wrap), the bodies and their layers are round too.
    pub fn layered(
        materials: [Option<&Material>; 2],
        layers: [&[Layer]; 2],
        frame: &ContactFrame,
    ) -> Self {
        let constants = Constants::of(uppermost(materials, layers));
        let influence = Influence::new(constants, frame.elements(), frame.spacing());
        let images = images::of_bodies(materials, layers, frame.wrap());
        Self::on(influence.layered(images), Curved::of(frame))
    }

    /// The half-spaces of these materials in plane strain, under the elements of a line of contact along y. Their
    /// displacements are measured from so far below the contact (m), which under a load changes approach and shift alone.
    pub fn plane_strain(
        materials: [Option<&Material>; 2],
        layers: [&[Layer]; 2],
        depths: [f64; 2],
        frame: &ContactFrame,
    ) -> Self {
        let (elements, width) = (frame.elements(), frame.spacing()[0]);
        let constants = Constants::of(uppermost(materials, layers));
        let wrap = frame.wrap();
        let inner = wrap.map(|wrap| 1 - wrap.hollow);
        let shaft = wrap.zip(inner.and_then(|inner| materials[inner].copied()));
        let shaft = shaft.map(|(wrap, material)| Shaft { radius: wrap.radius, material });
        // A shaft has no depth: it ends.
        let bases = [0, 1].map(|body| materials[body].filter(|_| inner != Some(body)));
        let influence = Influence::plane_strain(constants, bases, depths, elements, width);
        let images = images::of_bodies(materials, layers, wrap);
        Self::on(influence.layered(images).around(shaft), None)
    }

    /// Why layers on a material are not computed, if they are not: their images miss the compliance.
    pub fn refuses(material: Option<&Material>, layers: &[Layer]) -> Option<String> {
        Self::misses(material, layers, None)
    }

    /// The same around a hollow of some radius (m), of layers that are round too.
    pub fn refuses_round(
        material: Option<&Material>,
        layers: &[Layer],
        hollow: (Round, f64),
    ) -> Option<String> {
        Self::misses(material, layers, Some(hollow))
    }

    fn misses(
        base: Option<&Material>,
        layers: &[Layer],
        hollow: Option<(Round, f64)>,
    ) -> Option<String> {
        let missed = match (layers, base) {
            ([], None) => 0.0,
            ([], _) if hollow.is_none() => 0.0,
            _ => images::images(&Stack { layers, base, hollow }).1,
        };
        (missed > MISSED || missed.is_nan()).then(|| {
            format!(
                "differ too much from each other or from what is below them: their compliance would be off by {missed:.0e} of that of the uppermost one, and {MISSED:.0e} is allowed"
            )
        })
    }

    fn on(influence: Influence, curved: Option<Curved>) -> Self {
        let convolution = Convolution::padded(influence.elements());
        Self {
            influence,
            convolution,
            curved,
            bending: OnceLock::new(),
            normal: OnceLock::new(),
            tangential: OnceLock::new(),
            coupling: OnceLock::new(),
            periodic: OnceLock::new(),
            tangential_inverse: OnceLock::new(),
            coarser: OnceLock::new(),
            parts: Mutex::new(vec![]),
        }
    }

    /// On other elements, for which there is no work at the same time.
    fn beside(&self, influence: Influence, curved: Option<Curved>) -> Self {
        let other = Self::on(influence, curved);
        Self { convolution: other.convolution.sharing_space(&self.convolution), ..other }
    }

    /// Kernel nn.
    fn normal(&self) -> &Spectrum {
        self.normal.get_or_init(|| {
            let width = self.influence.elements()[0];
            self.convolution.spectrum(&self.influence.nn(), width, [Parity::Even; 2])
        })
    }

    /// Kernels xx, xy and yy.
    fn tangential(&self) -> [&Spectrum; 3] {
        let spectra = self.tangential.get_or_init(|| {
            // One more offset than the field has, to difference the results along an axis.
            let influence = self.influence.within(self.influence.elements().map(|n| n + 1));
            tangential_spectra(&influence, &self.convolution)
        });
        spectra.each_ref()
    }

    /// Kernels xn and yn.
    fn coupling(&self) -> &[Spectrum; 2] {
        self.coupling.get_or_init(|| {
            use Parity::{Even, Odd};
            let width = self.influence.elements()[0];
            [
                self.convolution.spectrum(&self.influence.xn(), width, [Odd, Even]),
                self.convolution.spectrum(&self.influence.yn(), width, [Even, Odd]),
            ]
        })
    }

    /// The inverse of the tangential compliance as if the frame repeated itself without end.
    fn tangential_inverse(&self) -> &(Convolution, [Spectrum; 3]) {
        self.tangential_inverse.get_or_init(|| {
            let convolution =
                Convolution::periodic(self.influence.elements()).sharing_space(&self.convolution);
            let influence = self.influence.within(self.reach(&convolution));
            let compliance = tangential_spectra(&influence, &convolution);
            let points = convolution.period().iter().product::<usize>() as f64;
            // The images cut off at half a period must not bring a value near zero or below.
            let floor = FLOOR * self.normal_self_term();
            let inverse = Spectrum::combine(&compliance, |[xx, xy, yy]| {
                let (xx, xy, yy) =
                    ((xx * points).max(floor), xy * points, (yy * points).max(floor));
                let determinant = (xx * yy - xy * xy).max(FLOOR * xx * yy);
                [yy, -xy, xx].map(|value| value / (determinant * points))
            });
            (convolution, inverse)
        })
    }

    /// The same half-spaces under elements of twice the size, one more where their number is odd.
    pub(super) fn on_coarser(&self) -> &Arc<HalfSpace> {
        let curved = self.curved.as_ref().map(Curved::coarser);
        self.coarser.get_or_init(|| Arc::new(self.beside(self.influence.coarser(), curved)))
    }

    /// The same half-spaces under that many elements of a plane frame, made anew where none of the last parts had as many.
    pub(super) fn part(&self, elements: [usize; 2]) -> Arc<HalfSpace> {
        self.placed(elements, None)
    }

    /// The same under elements that lie there on a sphere.
    fn placed(&self, elements: [usize; 2], curved: Option<Curved>) -> Arc<HalfSpace> {
        let mut parts = self.parts.lock().unwrap_or_else(PoisonError::into_inner);
        let is = |part: &Arc<Self>| part.influence.elements() == elements && part.curved == curved;
        let part = match parts.iter().position(is) {
            Some(index) => parts.remove(index),
            None => Arc::new(self.beside(self.influence.within(elements), curved)),
        };
        if parts.len() == PARTS {
            parts.remove(0);
        }
        parts.push(Arc::clone(&part));
        part
    }

    /// The most offsets along each axis of a kernel on a grid that repeats itself.
    fn reach(&self, convolution: &Convolution) -> [usize; 2] {
        let elements = self.influence.elements();
        [0, 1].map(|axis| elements[axis].min(convolution.period()[axis] / 2 + 1))
    }

    /// The normal compliance as if the frame repeated itself without end.
    fn periodic(&self) -> &(Convolution, Spectrum) {
        self.periodic.get_or_init(|| {
            let elements = self.influence.elements();
            let convolution = Convolution::periodic(elements).sharing_space(&self.convolution);
            let reach = self.reach(&convolution);
            let kernel = self.influence.within(reach).nn();
            let spectrum = convolution.spectrum(&kernel, reach[0], [Parity::Even; 2]);
            (convolution, spectrum)
        })
    }
}

impl Compliance for HalfSpace {
    fn apply(&self, tractions: &VectorField) -> VectorField {
        let [xx, xy, yy] = self.tangential();
        let [xn, yn] = self.coupling();
        let kernels = [
            [(xx, 1.0), (xy, 1.0), (xn, 1.0)],
            [(xy, 1.0), (yy, 1.0), (yn, 1.0)],
            [
                (xn, -1.0),
                (yn, -1.0),
                (self.normal(), if self.curved.is_some() { 0.0 } else { 1.0 }),
            ],
        ];
        let mut displacements = VectorField::zeros(tractions.n.len());
        let VectorField { t1, t2, n } = &mut displacements;
        self.convolution.apply_matrix(kernels, tractions.components(), [t1, t2, n]);
        if self.curved.is_some() {
            let mut pressed = vec![0.0; tractions.n.len()];
            self.apply_normal(&tractions.n, &mut pressed);
            displacements.n.iter_mut().zip(pressed).for_each(|(up, own)| *up += own);
        }
        displacements
    }

    fn apply_normal(&self, pressure: &[f64], displacement: &mut [f64]) {
        let normal = self.normal();
        let bending = self.curved.as_ref().map(|curved| {
            let made = || Bending::new(curved, &self.influence, &self.convolution);
            self.bending.get_or_init(made)
        });
        match bending {
            Some(own) => own.apply((&self.convolution, normal), pressure, displacement),
            None => self.convolution.apply(normal, pressure, displacement),
        }
    }

    fn normal_self_term(&self) -> f64 {
        self.influence.normal_self_term()
    }

    fn couples(&self) -> bool {
        self.influence.couples()
    }

    fn rolling<'a>(&'a self, flow: Flow<'a>) -> Box<dyn SlipMap + 'a> {
        Box::new(Rolling::new(self, flow.direction()))
    }

    fn shifting<'a>(&'a self, _: &'a ContactFrame) -> Box<dyn SlipMap + 'a> {
        Box::new(Shifting::new(self))
    }

    fn normal_preconditioner(&self, addition: f64) -> Box<dyn Preconditioner + '_> {
        let (convolution, spectrum) = self.periodic();
        Box::new(Circulant::new(convolution, spectrum, self.normal_self_term(), addition))
    }

    fn within(&self, part: &Part) -> Option<Box<dyn Compliance + '_>> {
        let curved = self.curved.as_ref().map(|curved| curved.within(&part.extent()));
        Some(Box::new(WholeOrPart::Part(self.placed(part.size(), curved))))
    }

    fn on(&self, frame: &ContactFrame) -> Option<Arc<dyn Compliance>> {
        let elements = frame.elements();
        let other = || self.placed(elements, Curved::of(frame)) as Arc<dyn Compliance>;
        self.influence.reaches(elements).then(other)
    }

    fn coarser(&self) -> Option<&dyn Compliance> {
        Some(&**self.on_coarser())
    }

    fn least_displacement(&self, away: [usize; 2]) -> f64 {
        self.influence.least_nn(away)
    }
}

/// What bodies are made of at their surfaces.
fn uppermost<'a>(
    materials: [Option<&'a Material>; 2],
    layers: [&'a [Layer]; 2],
) -> [Option<&'a Material>; 2] {
    [0, 1].map(|body| layers[body].first().map(|layer| &layer.material).or(materials[body]))
}

/// Parts whose kernels are kept: for the pressures and the friction of two evolutions side by side. A choice of memory.
const PARTS: usize = 4;

/// The smallest value of a spectrum, relative to the self term: half of the smallest eigenvalue on square elements, 0.53 of it. It
/// only preconditions.
const FLOOR: f64 = 0.25;

/// The spectra of xx, xy and yy.
fn tangential_spectra(influence: &Influence, convolution: &Convolution) -> [Spectrum; 3] {
    let width = influence.elements()[0];
    [
        convolution.spectrum(&influence.xx(), width, [Parity::Even; 2]),
        convolution.spectrum(&influence.xy(), width, [Parity::Odd; 2]),
        convolution.spectrum(&influence.yy(), width, [Parity::Even; 2]),
    ]
}

/// Division by the spectrum of the compliance of a frame that repeats itself: nearly the inverse
/// away from the edge of the contact.
#[derive(Debug)]
pub(in crate::compliance) struct Circulant<'a> {
    convolution: &'a Convolution,
    inverse: Spectrum,
}

impl<'a> Circulant<'a> {
    pub(in crate::compliance) fn new(
        convolution: &'a Convolution,
        spectrum: &Spectrum,
        self_term: f64,
        addition: f64,
    ) -> Self {
        // A spectrum carries the factor 1/points of one convolution; its inverse has to carry it too.
        let points = convolution.period().iter().product::<usize>() as f64;
        // The images cut off at half a period must not bring a value near zero or below.
        let floor = FLOOR * self_term;
        let inverse = spectrum.map(|value| 1.0 / ((value * points).max(floor) + addition) / points);
        Self { convolution, inverse }
    }
}

impl Preconditioner for Circulant<'_> {
    fn apply(&self, displacement: &[f64], pressure: &mut [f64]) {
        self.convolution.apply(&self.inverse, displacement, pressure);
    }
}
