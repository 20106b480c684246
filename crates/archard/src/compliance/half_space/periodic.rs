//! Surfaces that repeat themselves without end along x and y.
//!
//! A wave of tractions of wave number k displaces surfaces by the compliance of their [stack](super::stack), so that an
//! application is one Fourier transform there and back, without padding. With c = kx/k and s = ky/k,
//!
//! ```text
//! xx = c^2 C11 + s^2 CT   yy = s^2 C11 + c^2 CT   xy = c s (C11 - CT)   nn = C22   xn = -i c C12   yn = -i s C12
//! ```
//!
//! Tractions are known at the pairs and are waves between them. The mean of a field, which would displace a half-space without
//! end, squeezes and shears a plate of the body's depth.

use std::f64::consts::PI;
use std::sync::OnceLock;

use super::stack::{Scalars, Stack, half_space};
use crate::body::{Body, Layer, Material};
use crate::compliance::{Compliance, Preconditioner};
use crate::frame::{ContactFrame, VectorField};
use crate::numerics::SAME;
use crate::numerics::convolution::{Convolution, Parity, Spectrum};

/// The sum of the compliances of two bodies whose surfaces repeat themselves with the frame.
///
/// Spectra are made when first needed, but for that of the pressures.
#[derive(Debug)]
pub struct Periodic {
    bodies: [One; 2],
    /// Length of the frame along x and y (m).
    size: [f64; 2],
    elements: [usize; 2],
    convolution: Convolution,
    normal: Spectrum,
    /// xx, xy and yy.
    tangential: OnceLock<[Spectrum; 3]>,
    /// xn and yn.
    coupling: OnceLock<[Spectrum; 2]>,
    couples: bool,
    own: f64,
    /// The same bodies under elements of twice the size.
    coarser: OnceLock<Box<Periodic>>,
}

impl Periodic {
    /// How far below the contact (m) displacements of bodies are measured from: the length of the longest waves where none is given.
    pub fn depths(bodies: [&Body; 2], frame: &ContactFrame) -> [f64; 2] {
        let [along, across] = frame.size();
        let longest = if frame.is_line() { along } else { along.max(across) };
        bodies.map(|body| body.depth.unwrap_or(longest))
    }

    /// The bodies of these materials, `None` for something rigid, under layers from the surface down; their displacements are
    /// measured from so far below the contact (m).
    ///
    /// The frame has an even number of elements along each axis, or one.
    pub fn new(
        materials: [Option<&Material>; 2],
        layers: [&[Layer]; 2],
        depths: [f64; 2],
        frame: &ContactFrame,
    ) -> Self {
        let bodies = [0, 1].map(|body| One {
            layers: layers[body].to_vec(),
            base: materials[body].copied(),
            depth: depths[body],
        });
        Self::on(bodies, frame.size(), frame.elements())
    }

    fn on(bodies: [One; 2], size: [f64; 2], elements: [usize; 2]) -> Self {
        let convolution = Convolution::wrapping(elements);
        let normal =
            spectrum(&convolution, &bodies, size, [Parity::Even; 2], |_, [_, _, nn, _]| nn);
        let shortest = both(&bodies, PI * elements[0] as f64 / size[0]);
        let couples = shortest[1].abs() > SAME * shortest[2];
        let mut own = vec![0.0; elements[0] * elements[1]];
        let mut pressed = own.clone();
        pressed[0] = 1.0;
        convolution.apply(&normal, &pressed, &mut own);
        Self {
            bodies,
            size,
            elements,
            convolution,
            normal,
            tangential: OnceLock::new(),
            coupling: OnceLock::new(),
            couples,
            own: own[0],
            coarser: OnceLock::new(),
        }
    }

    fn spectrum(&self, parity: [Parity; 2], factor: fn([f64; 2], Scalars) -> f64) -> Spectrum {
        spectrum(&self.convolution, &self.bodies, self.size, parity, factor)
    }

    /// xx, xy and yy.
    fn tangential(&self) -> &[Spectrum; 3] {
        use Parity::{Even, Odd};
        self.tangential.get_or_init(|| {
            [
                self.spectrum([Even; 2], |[c, s], [along, .., across]| {
                    c * c * along + s * s * across
                }),
                self.spectrum([Odd; 2], |[c, s], [along, .., across]| c * s * (along - across)),
                self.spectrum([Even; 2], |[c, s], [along, .., across]| {
                    s * s * along + c * c * across
                }),
            ]
        })
    }

    /// xn and yn.
    fn coupling(&self) -> &[Spectrum; 2] {
        use Parity::{Even, Odd};
        self.coupling.get_or_init(|| {
            [
                self.spectrum([Odd, Even], |[c, _], [_, coupling, ..]| -c * coupling),
                self.spectrum([Even, Odd], |[_, s], [_, coupling, ..]| -s * coupling),
            ]
        })
    }
}

/// The compliance (m/Pa) of both bodies together for a wave number (1/m); what couples has the sign of the first.
fn both(bodies: &[One; 2], k: f64) -> Scalars {
    let [one, other] = bodies.each_ref().map(|body| body.compliance(k));
    [0, 1, 2, 3].map(|i| one[i] + if i == 1 { -other[i] } else { other[i] })
}

/// What waves along a direction (cosine and sine) are multiplied by, on a frame of that size (m).
fn spectrum(
    convolution: &Convolution,
    bodies: &[One; 2],
    size: [f64; 2],
    parity: [Parity; 2],
    factor: fn([f64; 2], Scalars) -> f64,
) -> Spectrum {
    convolution.transfer(parity, |waves| {
        let [x, y] = [0, 1].map(|axis| 2.0 * PI * waves[axis] as f64 / size[axis]);
        let k = x.hypot(y);
        let direction = if k > 0.0 { [x / k, y / k] } else { [1.0, 0.0] };
        factor(direction, both(bodies, k))
    })
}

/// One of the bodies.
#[derive(Debug, Clone)]
struct One {
    layers: Vec<Layer>,
    base: Option<Material>,
    depth: f64,
}

impl One {
    /// Its compliance (m/Pa) for a wave number (1/m).
    fn compliance(&self, k: f64) -> Scalars {
        let (layers, base) = (&self.layers[..], self.base.as_ref());
        match (layers, base) {
            _ if k == 0.0 => self.mean(),
            ([], None) => [0.0; 4],
            ([], Some(base)) => half_space(base).map(|value| value / k),
            _ => Stack { layers, base, hollow: None }.compliance(k).map(|value| value / k),
        }
    }

    /// That of its layers and what is below them down to its depth, evenly sheared and squeezed.
    fn mean(&self) -> Scalars {
        let coated: f64 = self.layers.iter().map(|layer| layer.thickness).sum();
        let layers = self.layers.iter().map(|layer| (&layer.material, layer.thickness));
        let below = self.base.as_ref().map(|base| (base, (self.depth - coated).max(0.0)));
        let plates = layers.chain(below).map(|(material, thickness)| {
            let sheared = thickness / material.shear_modulus();
            let poisson = material.poisson;
            [sheared, 0.5 * (1.0 - 2.0 * poisson) / (1.0 - poisson) * sheared]
        });
        let [sheared, squeezed] =
            plates.fold([0.0; 2], |sum, plate| [sum[0] + plate[0], sum[1] + plate[1]]);
        [sheared, 0.0, squeezed, sheared]
    }
}

impl Compliance for Periodic {
    fn apply(&self, tractions: &VectorField) -> VectorField {
        let [xx, xy, yy] = self.tangential();
        let [xn, yn] = self.coupling();
        let kernels = [
            [(xx, 1.0), (xy, 1.0), (xn, 1.0)],
            [(xy, 1.0), (yy, 1.0), (yn, 1.0)],
            [(xn, -1.0), (yn, -1.0), (&self.normal, 1.0)],
        ];
        let mut displacements = VectorField::zeros(tractions.n.len());
        let VectorField { t1, t2, n } = &mut displacements;
        self.convolution.apply_matrix(kernels, tractions.components(), [t1, t2, n]);
        displacements
    }

    fn apply_normal(&self, pressure: &[f64], displacement: &mut [f64]) {
        self.convolution.apply(&self.normal, pressure, displacement);
    }

    fn normal_self_term(&self) -> f64 {
        self.own
    }

    fn repeats(&self) -> bool {
        true
    }

    fn couples(&self) -> bool {
        self.couples
    }

    fn normal_preconditioner(&self, addition: f64) -> Box<dyn Preconditioner + '_> {
        let points = self.convolution.period().iter().product::<usize>() as f64;
        // A spectrum carries the factor 1/points of one convolution; its inverse has to carry it too.
        let inverse = self.normal.map(|value| 1.0 / (value * points + addition) / points);
        Box::new(Inverse { convolution: &self.convolution, inverse })
    }

    fn coarser(&self) -> Option<&dyn Compliance> {
        // Of both, an even number of elements along each axis.
        let halves = self.elements.iter().all(|elements| elements.is_multiple_of(4));
        halves.then(|| {
            let coarser = || {
                let bodies = self.bodies.clone();
                Box::new(Self::on(bodies, self.size, self.elements.map(|elements| elements / 2)))
            };
            &**self.coarser.get_or_init(coarser) as &dyn Compliance
        })
    }
}

/// Division by the spectrum: the inverse where all pairs touch.
#[derive(Debug)]
struct Inverse<'a> {
    convolution: &'a Convolution,
    inverse: Spectrum,
}

impl Preconditioner for Inverse<'_> {
    fn apply(&self, displacement: &[f64], pressure: &mut [f64]) {
        self.convolution.apply(&self.inverse, displacement, pressure);
    }
}
