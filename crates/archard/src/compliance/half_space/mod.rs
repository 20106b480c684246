//! Two elastic half-spaces: the uniform tractions of rectangular elements (Boussinesq, Cerruti, Love),
//! summed by fast convolution.

mod influence;

use std::fmt;
use std::sync::OnceLock;

use crate::body::Material;
use crate::compliance::{Compliance, Preconditioner};
use crate::frame::{ContactFrame, VectorField};
use crate::numerics::convolution::{Convolution, Parity, Spectrum};

use influence::{Constants, Influence};

/// The sum of the compliances of two half-spaces on a uniform frame; a rigid body adds nothing.
///
/// An application costs O(N log N) and memory is O(N) in the number of pairs. Kernels are made when
/// first needed: a frictionless problem never makes the tangential ones.
pub struct HalfSpace {
    influence: Influence,
    convolution: Convolution,
    normal: Spectrum,
    tangential: OnceLock<Tangential>,
    periodic: OnceLock<(Convolution, Spectrum)>,
}

/// The spectra of the other components.
#[derive(Debug)]
struct Tangential {
    xx: Spectrum,
    yy: Spectrum,
    xy: Spectrum,
    xn: Spectrum,
    yn: Spectrum,
}

impl fmt::Debug for HalfSpace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("HalfSpace").field("influence", &self.influence).finish_non_exhaustive()
    }
}

impl HalfSpace {
    /// The half-spaces of these materials under the elements of a frame; `None` for a rigid body.
    pub fn new(materials: [Option<&Material>; 2], frame: &ContactFrame) -> Self {
        let influence = Influence::new(Constants::of(materials), frame.elements(), frame.spacing());
        let convolution = Convolution::padded(frame.elements());
        let normal = convolution.spectrum(&influence.nn(), frame.elements()[0], [Parity::Even; 2]);
        Self {
            influence,
            convolution,
            normal,
            tangential: OnceLock::new(),
            periodic: OnceLock::new(),
        }
    }

    fn tangential(&self) -> &Tangential {
        self.tangential.get_or_init(|| {
            use Parity::{Even, Odd};
            let width = self.influence.elements()[0];
            let spectrum =
                |kernel: Vec<f64>, parity| self.convolution.spectrum(&kernel, width, parity);
            Tangential {
                xx: spectrum(self.influence.xx(), [Even, Even]),
                yy: spectrum(self.influence.yy(), [Even, Even]),
                xy: spectrum(self.influence.xy(), [Odd, Odd]),
                xn: spectrum(self.influence.xn(), [Odd, Even]),
                yn: spectrum(self.influence.yn(), [Even, Odd]),
            }
        })
    }

    /// The normal compliance as if the frame repeated itself without end.
    fn periodic(&self) -> &(Convolution, Spectrum) {
        self.periodic.get_or_init(|| {
            let elements = self.influence.elements();
            let convolution = Convolution::periodic(elements);
            let reach = [0, 1].map(|axis| elements[axis].min(convolution.period()[axis] / 2 + 1));
            let kernel = self.influence.within(reach).nn();
            let spectrum = convolution.spectrum(&kernel, reach[0], [Parity::Even; 2]);
            (convolution, spectrum)
        })
    }
}

impl Compliance for HalfSpace {
    fn apply(&self, tractions: &VectorField) -> VectorField {
        let Tangential { xx, yy, xy, xn, yn } = self.tangential();
        let kernels = [
            [(xx, 1.0), (xy, 1.0), (xn, 1.0)],
            [(xy, 1.0), (yy, 1.0), (yn, 1.0)],
            [(xn, -1.0), (yn, -1.0), (&self.normal, 1.0)],
        ];
        let [t1, t2, n] = self.convolution.apply_matrix(kernels, tractions.components());
        VectorField { t1, t2, n }
    }

    fn apply_normal(&self, pressure: &[f64], displacement: &mut [f64]) {
        self.convolution.apply(&self.normal, pressure, displacement);
    }

    fn normal_self_term(&self) -> f64 {
        self.influence.normal_self_term()
    }

    fn normal_preconditioner(&self, addition: f64) -> Box<dyn Preconditioner + '_> {
        let (convolution, spectrum) = self.periodic();
        Box::new(Circulant::new(convolution, spectrum, self.normal_self_term(), addition))
    }
}

/// Division by the spectrum of the compliance of a frame that repeats itself: nearly the inverse
/// away from the edge of the contact.
#[derive(Debug)]
struct Circulant<'a> {
    convolution: &'a Convolution,
    inverse: Spectrum,
}

impl<'a> Circulant<'a> {
    fn new(
        convolution: &'a Convolution,
        spectrum: &Spectrum,
        self_term: f64,
        addition: f64,
    ) -> Self {
        // A spectrum carries the factor 1/points of one convolution; its inverse has to carry it too.
        let points = convolution.period().iter().product::<usize>() as f64;
        // The smallest eigenvalue on square elements is 0.53 of the self term; the images cut off at
        // half a period must not bring a value near zero or below.
        let floor = 0.25 * self_term;
        let inverse = spectrum.map(|value| 1.0 / ((value * points).max(floor) + addition) / points);
        Self { convolution, inverse }
    }
}

impl Preconditioner for Circulant<'_> {
    fn apply(&self, displacement: &[f64], pressure: &mut [f64]) {
        self.convolution.apply(&self.inverse, displacement, pressure);
    }
}
