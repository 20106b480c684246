//! How far the surface of bonded layers moves under a traction that is a wave, exp(i(kx x + ky y)).
//!
//! With s along the wave, n across it and z into the solid, the surface of an isotropic stack moves by
//!
//! ```text
//! u_s = C11 t_s + i C12 t_z    u_z = -i C12 t_s + C22 t_z    u_n = CT t_n
//! ```
//!
//! four numbers for each wave number k. They are carried from the base up to the surface, layer by layer. In a layer, with q = k h
//! and primes by k z, the state y = (U, W, S/Gk, N/Gk) with u_s = i U, u_z = W, sigma_sz = i S and sigma_zz = N obeys y' = A y. The
//! eigenvalues of A are 1 and -1, both double, so that with M = A^2 - 1 and M^2 = 0
//!
//! ```text
//! exp(-q A) = cosh q + (q sinh q / 2) M - A (sinh q + (q cosh q - sinh q) / 2 M)
//! ```
//!
//! In 2 x 2 blocks Q of exp(-q A), the compliance C (times G k) below the layer is (Q11 C - Q12) / (Q22 - Q21 C) above it. The
//! solutions that grow upward are those that are wanted, so nothing cancels; both sides are divided by exp(q). Of the tractions (S, N)
//! above a layer, exp(-q) over the same denominator arrives below it. Layers were first computed by D. M. Burmister, *J. Appl. Phys.* 16
//! (1945) 89.
//!
//! What a layer bears is two waves: one that decays downward from its upper face, as in a half-space of its material under tractions
//! there, and one that decays upward from its lower face. With t the tractions (S, N) at the face, C what is below it, and K+ and K- the
//! compliance of a half-space of that material with C12 and with -C12,
//!
//! ```text
//! downward (C + K-) t / (2 K11)    upward (K+ - C) t / (2 K11)
//! ```

use super::round;
use crate::body::profile::Round;
use crate::body::{Layer, Material};

/// C11, C12, C22 and CT, times the wave number (1/Pa).
pub(super) type Scalars = [f64; 4];

/// Tractions of a wave on a face: S and N under unit pressure, S and N under a unit traction along it, and those across the wave under
/// a unit traction across it. Those along it are of the other phase; tension and what pulls is positive.
pub(super) type Tractions = [f64; 5];

/// From this k h on nothing is felt of what lies below a layer: exp(-2q) q^2 is less than 1e-23.
const DEEP: f64 = 30.0;
/// Below this q, q cosh q - sinh q is taken from its series, whose next term is less than 1e-16 of it.
const THIN: f64 = 0.05;

type Matrix<const N: usize> = [[f64; N]; N];

/// Layers from the surface down, on a half-space, or on something rigid.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stack<'a> {
    /// One at least, of a hollow on a base none as well.
    pub layers: &'a [Layer],
    pub base: Option<&'a Material>,
    /// The radius (m) of a hollow whose layers are round too; `None` of plane layers. Its friction is that of plane ones.
    pub hollow: Option<(Round, f64)>,
}

impl Stack<'_> {
    /// The compliance for a wave number (1/m), times it.
    pub fn compliance(&self, k: f64) -> Scalars {
        let base = self.bottom();
        let layers = self.layers.iter().rev();
        let plane =
            layers.fold(base, |below, layer| above(layer, below, k * layer.thickness).compliance);
        let Some(hollow) = self.hollow else { return plane };
        let [along, coupling, _, across] = plane;
        [along, coupling, round::compliance(hollow, self.layers, self.base, k), across]
    }

    /// The tractions of the waves that go down from the upper face of a layer and up from its lower one, for a wave number (1/m) of
    /// tractions on the surface: of the layer with that index, or of what is below all, from which nothing comes up.
    pub fn waves(&self, piece: usize, k: f64) -> [Tractions; 2] {
        let mut below = self.bottom();
        let mut faces = vec![below];
        let mut passing = vec![];
        for layer in self.layers.iter().rev() {
            let above = above(layer, below, k * layer.thickness);
            below = above.compliance;
            faces.push(below);
            passing.push((above.passed, above.across));
        }
        faces.reverse();
        passing.reverse();
        // S and N under unit pressure and under a unit traction along the wave, and what is borne across it.
        let mut borne = ([[0.0, 1.0], [-1.0, 0.0]], -1.0);
        let through = |borne: (Matrix<2>, f64), (passed, across): (Matrix<2>, f64)| {
            (product(passed, borne.0), across * borne.1)
        };
        for layer in &passing[..piece] {
            borne = through(borne, *layer);
        }
        let material = self.layers.get(piece).map(|layer| &layer.material).or(self.base);
        let Some(material) = material else { return [[0.0; 5]; 2] };
        let own = half_space(material);
        let wave =
            |side: f64, [along, coupling, normal, across]: Scalars, borne: (Matrix<2>, f64)| {
                let factors = [
                    [own[0] + side * along, side * (coupling - own[1])],
                    [side * (coupling - own[1]), own[2] + side * normal],
                ];
                let [shear, normal] =
                    product(factors, borne.0).map(|row| row.map(|t| t / (2.0 * own[0])));
                let across = 0.5 * borne.1 * (1.0 + side * across / own[3]);
                [shear[0], normal[0], shear[1], normal[1], across]
            };
        let down = wave(1.0, faces[piece], borne);
        match passing.get(piece) {
            Some(layer) => [down, wave(-1.0, faces[piece + 1], through(borne, *layer))],
            None => [down, [0.0; 5]],
        }
    }

    /// That of the shortest waves, which is the half-space of the uppermost layer.
    pub fn top(&self) -> Scalars {
        let uppermost = self.layers.first().map(|layer| &layer.material);
        uppermost.or(self.base).map_or([0.0; 4], half_space)
    }

    /// That of the longest waves, times their wave number.
    pub fn bottom(&self) -> Scalars {
        self.base.map_or([0.0; 4], half_space)
    }

    /// The longest length (m) over which the stack differs from its base: its thickness, that of its bending, or that of its
    /// stretching.
    pub fn reach(&self) -> f64 {
        let thickness: f64 = self.layers.iter().map(|layer| layer.thickness).sum();
        let Some(base) = self.base.map(Material::shear_modulus) else { return thickness };
        let moduli = self.layers.iter().map(|layer| layer.material.shear_modulus() / base);
        let stiffest = moduli.clone().fold(0.0, f64::max);
        let stretching: f64 =
            moduli.zip(self.layers).map(|(ratio, layer)| ratio * layer.thickness).sum();
        thickness.max(thickness * stiffest.cbrt()).max(stretching)
    }
}

/// The compliance of a half-space, times the wave number.
pub(super) fn half_space(material: &Material) -> Scalars {
    let (shear, poisson) = (material.shear_modulus(), material.poisson);
    let along = (1.0 - poisson) / shear;
    [along, 0.5 * (1.0 - 2.0 * poisson) / shear, along, 1.0 / shear]
}

/// What there is above a layer.
struct Above {
    compliance: Scalars,
    /// What arrives below of S and N above, and of what is borne across the wave.
    passed: Matrix<2>,
    across: f64,
}

/// What there is above a layer by the compliance below it; q is its thickness times the wave number.
fn above(layer: &Layer, below: Scalars, q: f64) -> Above {
    if q > DEEP {
        let compliance = half_space(&layer.material);
        return Above { compliance, passed: [[0.0; 2]; 2], across: 0.0 };
    }
    let shear = layer.material.shear_modulus();
    let [along, coupling, normal, across] = below.map(|value| value * shear);
    let transfer = transfer(layer.material.poisson, q);
    let block = |row: usize, column: usize| -> Matrix<2> {
        [0, 1].map(|i| [0, 1].map(|j| transfer[2 * row + i][2 * column + j]))
    };
    let below = [[along, coupling], [coupling, normal]];
    let numerator = sum(product(block(0, 0), below), 1.0, block(0, 1), -1.0);
    let denominator = sum(block(1, 1), 1.0, product(block(1, 0), below), -1.0);
    let [[a, b], [c, d]] = denominator;
    let determinant = a * d - b * c;
    let inverse = [[d, -b], [-c, a]].map(|row| row.map(|value| value / determinant));
    let [[along, one], [other, normal]] = product(numerator, inverse);
    let (tanh, decay) = (q.tanh(), (-q).exp());
    let passed = inverse.map(|row| row.map(|value| value * decay));
    let square = decay * decay;
    let through = 2.0 * decay / ((1.0 + square) + across * (1.0 - square));
    let across = (across + tanh) / (1.0 + across * tanh);
    let compliance = [along, 0.5 * (one + other), normal, across].map(|value| value / shear);
    Above { compliance, passed, across: through }
}

/// exp(-q A) exp(-q).
fn transfer(poisson: f64, q: f64) -> Matrix<4> {
    let n = poisson / (1.0 - poisson);
    let m = (1.0 - 2.0 * poisson) / (2.0 * (1.0 - poisson));
    let a = [
        [0.0, -1.0, 1.0, 0.0],
        [n, 0.0, 0.0, m],
        [2.0 / (1.0 - poisson), 0.0, 0.0, -n],
        [0.0, 0.0, 1.0, 0.0],
    ];
    let identity = [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| f64::from(u8::from(i == j))));
    let square = sum(product(a, a), 1.0, identity, -1.0);
    let decay = (-q).exp();
    let (cosh, sinh) = (0.5 * (1.0 + decay * decay), -0.5 * (-2.0 * q).exp_m1());
    let difference = if q < THIN {
        let series = 1.0 / 3.0 + q * q * (1.0 / 30.0 + q * q / 840.0);
        q.powi(3) * series * decay
    } else {
        q * cosh - sinh
    };
    let even = sum(identity, cosh, square, 0.5 * q * sinh);
    let odd = sum(a, sinh, product(a, square), 0.5 * difference);
    sum(even, 1.0, odd, -1.0)
}

fn product<const N: usize>(one: Matrix<N>, other: Matrix<N>) -> Matrix<N> {
    let mut result = [[0.0; N]; N];
    for (row, values) in result.iter_mut().zip(one) {
        for (column, value) in row.iter_mut().enumerate() {
            *value = values.iter().zip(other).map(|(factor, row)| factor * row[column]).sum();
        }
    }
    result
}

/// a A + b B.
fn sum<const N: usize>(one: Matrix<N>, a: f64, other: Matrix<N>, b: f64) -> Matrix<N> {
    let mut result = one;
    for (row, others) in result.iter_mut().zip(other) {
        for (value, other) in row.iter_mut().zip(others) {
            *value = a * *value + b * other;
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    use super::{Stack, half_space};
    use crate::body::{Layer, Material};

    /// Of that shear modulus.
    fn material(shear: f64, poisson: f64) -> Material {
        Material { young: 2.0 * (1.0 + poisson) * shear, poisson }
    }

    fn layer(shear: f64, poisson: f64, thickness: f64) -> Layer {
        Layer { material: material(shear, poisson), thickness }
    }

    /// Wave numbers from 1e-6 to 1e6.
    fn waves() -> impl Iterator<Item = f64> {
        (-24..=24).map(|power| 10_f64.powf(0.25 * f64::from(power)))
    }

    #[test]
    fn equal_layers_are_a_half_space() {
        let base = material(2.0, 0.31);
        let layers = [layer(2.0, 0.31, 0.1), layer(2.0, 0.31, 3.0), layer(2.0, 0.31, 0.02)];
        for k in waves() {
            let found = Stack { layers: &layers, base: Some(&base), hollow: None }.compliance(k);
            for (found, known) in found.into_iter().zip(half_space(&base)) {
                assert_relative_eq!(found, known, max_relative = 1e-12);
            }
        }
    }

    /// K. L. Johnson, *Contact Mechanics*, section 5.8, among others: a layer bonded to a rigid base.
    #[test]
    fn a_layer_on_a_rigid_base_is_as_in_closed_form() {
        for poisson in [0.0, 0.2, 0.3, 0.45, 0.499] {
            let kappa = 3.0 - 4.0 * poisson;
            for q in waves().filter(|q| (1e-2..=1e2).contains(q)) {
                let found = Stack { layers: &[layer(1.0, poisson, 1.0)], base: None, hollow: None }
                    .compliance(q)[2];
                let (sinh, cosh) = ((2.0 * q).sinh(), (2.0 * q).cosh());
                let bottom =
                    kappa * cosh + 2.0 * q * q + 5.0 - 12.0 * poisson + 8.0 * poisson * poisson;
                let known = (1.0 - poisson) * (kappa * sinh - 2.0 * q) / bottom;
                assert_relative_eq!(found, known, max_relative = 1e-9);
            }
        }
    }

    /// h/G along and across, h (1 - 2 nu)/(2 G (1 - nu)) down; where nothing is squeezed out k^2 h^3/(3 G).
    #[test]
    fn a_thin_layer_on_a_rigid_base_gives_by_its_thickness() {
        let k = 1e-3;
        let found =
            Stack { layers: &[layer(1.0, 0.3, 1.0)], base: None, hollow: None }.compliance(k);
        let [along, _, normal, across] = found.map(|value| value / k);
        for (found, known) in [(along, 1.0), (across, 1.0), (normal, 0.4 / 1.4)] {
            assert_relative_eq!(found, known, max_relative = 2e-6);
        }
        let rubber =
            Stack { layers: &[layer(1.0, 0.5, 1.0)], base: None, hollow: None }.compliance(k);
        assert_relative_eq!(rubber[2] / k, k * k / 3.0, max_relative = 1e-5);
    }

    #[test]
    fn the_shortest_waves_feel_the_uppermost_layer_alone() {
        let (layers, base) = ([layer(5.0, 0.2, 1.0), layer(1.0, 0.4, 2.0)], material(3.0, 0.3));
        let stack = Stack { layers: &layers, base: Some(&base), hollow: None };
        for k in [1e3, 1e6] {
            assert_eq!(stack.compliance(k), stack.top());
        }
        for (found, known) in stack.compliance(1e-7).into_iter().zip(stack.bottom()) {
            assert_abs_diff_eq!(found, known, epsilon = 1e-5);
        }
    }
}
