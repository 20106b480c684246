//! Two elastic half-spaces: the uniform tractions of rectangular elements (Boussinesq, Cerruti, Love), or of strips in
//! plane strain (Flamant), summed by fast convolution; with layers as images at depths below the surface.

mod differences;
mod images;
mod influence;
pub mod inside;
mod periodic;
mod rolling;
mod round;
mod shifting;
mod stack;

use std::fmt;
use std::ops::Deref;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use crate::body::profile::Round;
use crate::body::{Layer, Material};
use crate::compliance::{Compliance, Preconditioner, SlipMap};
use crate::frame::{ContactFrame, Flow, Part, VectorField, Wrap};
use crate::numerics::convolution::{Convolution, Parity, Spectrum};

use images::Image;
pub(in crate::compliance) use influence::Constants;
use influence::Influence;
pub use periodic::Periodic;
use rolling::Rolling;
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
        Self::on(Influence::new(Constants::of(materials), frame.elements(), frame.spacing()))
    }

    /// The half-spaces of these materials, `None` for something rigid, under layers from the surface down. Where the frame is drawn
    /// on a [round surface](crate::frame::Wrap), those of the hollow body are round too.
    pub fn layered(
        materials: [Option<&Material>; 2],
        layers: [&[Layer]; 2],
        frame: &ContactFrame,
    ) -> Self {
        let constants = Constants::of(uppermost(materials, layers));
        let influence = Influence::new(constants, frame.elements(), frame.spacing());
        Self::on(influence.layered(images(materials, layers, frame.wrap())))
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
        let influence = Influence::plane_strain(constants, materials, depths, elements, width);
        Self::on(influence.layered(images(materials, layers, frame.wrap())))
    }

    /// Why layers on a material are not computed, if they are not: their images miss the compliance.
    pub fn refuses(material: Option<&Material>, layers: &[Layer]) -> Option<String> {
        Self::misses(material, layers, None)
    }

    /// The same of layers of a hollow of some radius (m) that are round too.
    pub fn refuses_round(layers: &[Layer], hollow: (Round, f64)) -> Option<String> {
        Self::misses(None, layers, Some(hollow))
    }

    fn misses(
        base: Option<&Material>,
        layers: &[Layer],
        hollow: Option<(Round, f64)>,
    ) -> Option<String> {
        let missed = match layers {
            [] => 0.0,
            layers => images::images(&Stack { layers, base, hollow }).1,
        };
        (missed > MISSED || missed.is_nan()).then(|| {
            format!(
                "differ too much from each other or from what is below them: their compliance would be off by {missed:.0e} of that of the uppermost one, and {MISSED:.0e} is allowed"
            )
        })
    }

    fn on(influence: Influence) -> Self {
        let convolution = Convolution::padded(influence.elements());
        Self {
            influence,
            convolution,
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
    fn beside(&self, influence: Influence) -> Self {
        let other = Self::on(influence);
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
        self.coarser.get_or_init(|| Arc::new(self.beside(self.influence.coarser())))
    }

    /// The same half-spaces under that many elements, made anew where none of the last parts had as many.
    pub(super) fn part(&self, elements: [usize; 2]) -> Arc<HalfSpace> {
        let mut parts = self.parts.lock().unwrap_or_else(PoisonError::into_inner);
        let known = parts.iter().position(|part| part.influence.elements() == elements);
        let part = match known {
            Some(index) => parts.remove(index),
            None => Arc::new(self.beside(self.influence.within(elements))),
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
            [(xn, -1.0), (yn, -1.0), (self.normal(), 1.0)],
        ];
        let mut displacements = VectorField::zeros(tractions.n.len());
        let VectorField { t1, t2, n } = &mut displacements;
        self.convolution.apply_matrix(kernels, tractions.components(), [t1, t2, n]);
        displacements
    }

    fn apply_normal(&self, pressure: &[f64], displacement: &mut [f64]) {
        self.convolution.apply(self.normal(), pressure, displacement);
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
        Some(Box::new(WholeOrPart::Part(self.part(part.size()))))
    }

    fn on(&self, frame: &ContactFrame) -> Option<Arc<dyn Compliance>> {
        let elements = frame.elements();
        self.influence.reaches(elements).then(|| self.part(elements) as Arc<dyn Compliance>)
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

/// The images of the layers of both bodies. What couples pressures and friction has the sign of body 1.
fn images(
    materials: [Option<&Material>; 2],
    layers: [&[Layer]; 2],
    wrap: Option<Wrap>,
) -> Vec<Image> {
    let of = |body: usize| {
        let hollow = wrap.filter(|wrap| wrap.hollow == body).map(|wrap| (wrap.round, wrap.radius));
        let stack = Stack { layers: layers[body], base: materials[body], hollow };
        let images = if layers[body].is_empty() { vec![] } else { images::images(&stack).0 };
        let sign = if body == 0 { 1.0 } else { -1.0 };
        images.into_iter().map(move |image| Image {
            scalars: [0, 1, 2, 3].map(|i| if i == 1 { sign } else { 1.0 } * image.scalars[i]),
            ..image
        })
    };
    of(0).chain(of(1)).collect()
}

/// Half-spaces of the whole frame, or of a part of it.
#[derive(Debug)]
enum WholeOrPart<'a> {
    Whole(&'a HalfSpace),
    Part(Arc<HalfSpace>),
}

impl Deref for WholeOrPart<'_> {
    type Target = HalfSpace;

    fn deref(&self) -> &HalfSpace {
        match self {
            WholeOrPart::Whole(half_space) => half_space,
            WholeOrPart::Part(half_space) => half_space,
        }
    }
}

impl Compliance for WholeOrPart<'_> {
    fn apply(&self, tractions: &VectorField) -> VectorField {
        (**self).apply(tractions)
    }

    fn apply_normal(&self, pressure: &[f64], displacement: &mut [f64]) {
        (**self).apply_normal(pressure, displacement);
    }

    fn normal_self_term(&self) -> f64 {
        (**self).normal_self_term()
    }

    fn couples(&self) -> bool {
        (**self).couples()
    }

    fn normal_preconditioner(&self, addition: f64) -> Box<dyn Preconditioner + '_> {
        (**self).normal_preconditioner(addition)
    }
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
