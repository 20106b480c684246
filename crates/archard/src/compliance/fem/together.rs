//! What cubic functions add all together, relative to what each adds by itself.
//!
//! Quadratic and cubic functions are solved for at once, by conjugate gradients behind the factors of the quadratic ones and each cubic
//! function by itself: their equations are about as well conditioned on any mesh (R. E. Bank, SIAM J. Numer. Anal. 33 (1996), 921).

use glam::{DMat3, DVec3};
use rayon::prelude::*;

use super::Solid;
use super::held::Held;
use super::stiffness::lame;
use super::surplus::Cubic;
use crate::body::mesh::tetrahedron::{cubic_slopes, points, slopes, turn};

/// Tetrahedra that are gone through at once.
const BATCH: usize = 256;
/// A step that adds less than this share to the energy is the last: errors are stated to two digits.
const SETTLED: f64 = 0.01;

/// One load's iterate: values of the quadratic functions of all nodes, behind them of the cubic ones.
type Values = Vec<DVec3>;

fn dot(one: &Values, other: &Values) -> f64 {
    one.iter().zip(other).map(|(one, other)| one.dot(*other)).sum()
}

/// What cubic functions add under a load.
pub(super) struct Together {
    /// The energy (N m or its square per unit load) that all add together.
    pub energy: f64,
    /// The sum of those that each adds by itself.
    pub each: f64,
    /// What is added to the functions (m): quadratic ones node by node, behind them the cubic ones.
    pub values: Vec<DVec3>,
}

/// What cubic functions add under what is left over on them, load by load.
pub(super) fn together(
    solid: &Solid,
    cubic: &Cubic<'_>,
    residuals: &[Vec<DVec3>],
) -> Vec<Together> {
    let nodes = solid.volume.nodes.len();
    let mut residual: Vec<Values> = residuals
        .iter()
        .map(|own| {
            let free = own.iter().zip(cubic.held).map(|(one, held)| held.free(*one));
            vec![DVec3::ZERO; nodes].into_iter().chain(free).collect()
        })
        .collect();
    let mut direction = behind(solid, cubic, &residual);
    let each: Vec<f64> =
        residual.iter().zip(&direction).map(|(residual, one)| dot(residual, one)).collect();
    let (mut energy, mut left) = (vec![0.0; each.len()], each.clone());
    let mut values: Vec<Values> = vec![vec![DVec3::ZERO; nodes + cubic.held.len()]; each.len()];
    loop {
        let pulled = times(solid, cubic, &direction);
        let mut grows = false;
        for load in 0..each.len() {
            let resists = dot(&direction[load], &pulled[load]);
            if resists <= 0.0 || left[load] <= 0.0 {
                continue;
            }
            let step = left[load] / resists;
            energy[load] += step * left[load];
            let pairs = values[load].iter_mut().zip(&direction[load]);
            pairs.for_each(|(value, direction)| *value += step * *direction);
            grows |= step * left[load] > SETTLED * energy[load];
            let pairs = residual[load].iter_mut().zip(&pulled[load]);
            pairs.for_each(|(residual, pulled)| *residual -= step * *pulled);
        }
        if !grows {
            let all = energy.into_iter().zip(each).zip(values);
            return all.map(|((energy, each), values)| Together { energy, each, values }).collect();
        }
        let next = behind(solid, cubic, &residual);
        for load in 0..each.len() {
            let now = dot(&residual[load], &next[load]);
            let share = if left[load] > 0.0 { now / left[load] } else { 0.0 };
            left[load] = now;
            let pairs = direction[load].iter_mut().zip(&next[load]);
            pairs.for_each(|(direction, next)| *direction = *next + share * *direction);
        }
    }
}

/// The preconditioner: the factors of the quadratic functions, and each cubic one by itself.
fn behind(solid: &Solid, cubic: &Cubic<'_>, residual: &[Values]) -> Vec<Values> {
    let nodes = solid.volume.nodes.len();
    let flat = |values: &Values| -> Vec<f64> {
        values[..nodes].iter().flat_map(|value| value.to_array()).collect()
    };
    let forces: Vec<Vec<f64>> = residual.iter().map(flat).collect();
    let mut moved = vec![vec![0.0; 3 * nodes]; forces.len()];
    if forces.iter().flatten().any(|force| *force != 0.0) {
        solid.solve(&mut moved, &forces);
    }
    let whole = |(moved, residual): (&Vec<f64>, &Values)| {
        let quadratic = moved.chunks_exact(3).map(DVec3::from_slice);
        let own = residual[nodes..].iter().zip(cubic.directions).map(|(residual, directions)| {
            directions.iter().map(|one| residual.dot(*one) * *one).sum::<DVec3>()
        });
        quadratic.chain(own).collect()
    };
    moved.iter().zip(residual).map(whole).collect()
}

/// Forces on all functions by displacements along them; none on what is held.
fn times(solid: &Solid, cubic: &Cubic<'_>, values: &[Values]) -> Vec<Values> {
    let nodes = solid.volume.nodes.len();
    let mut forces = vec![vec![DVec3::ZERO; values[0].len()]; values.len()];
    let elements: Vec<usize> = (0..solid.volume.elements.len()).collect();
    for batch in elements.chunks(BATCH) {
        let found: Vec<_> =
            batch.par_iter().map(|element| of_element(solid, cubic, *element, values)).collect();
        for (&element, found) in batch.iter().zip(&found) {
            for (own, place) in functions(solid, cubic, element).into_iter().enumerate() {
                for (force, found) in forces.iter_mut().zip(found) {
                    force[place.0] += place.1 * found[own];
                }
            }
        }
    }
    let held = |place: usize| -> &Held {
        if place < nodes { &solid.nodes[place] } else { &cubic.held[place - nodes] }
    };
    for force in &mut forces {
        force.iter_mut().enumerate().for_each(|(place, one)| *one = held(place).free(*one));
    }
    forces
}

/// The places of the functions of a tetrahedron among all values, each with its sign there.
fn functions(solid: &Solid, cubic: &Cubic<'_>, element: usize) -> [(usize, f64); 20] {
    let nodes = solid.volume.nodes.len();
    std::array::from_fn(|own| match own {
        0..10 => (solid.volume.elements[element][own], 1.0),
        _ => {
            let (function, sign) = cubic.functions[element][own - 10];
            (nodes + function, sign)
        }
    })
}

fn of_element(
    solid: &Solid,
    cubic: &Cubic<'_>,
    element: usize,
    values: &[Values],
) -> Vec<[DVec3; 20]> {
    let places = solid.volume.elements[element].map(|node| DVec3::from(solid.volume.nodes[node]));
    let own = functions(solid, cubic, element);
    let [lame, shear] = lame(&solid.material);
    let mut forces = vec![[DVec3::ZERO; 20]; values.len()];
    for (at, weight) in points() {
        let turn = turn(&places, at);
        let weight = weight * turn.determinant() / 6.0;
        let inverse = turn.inverse().transpose();
        let (quadratic, cubic) = (slopes(at), cubic_slopes(at));
        let slopes: [DVec3; 20] = std::array::from_fn(|own| {
            inverse * if own < 10 { quadratic[own] } else { cubic[own - 10] }
        });
        for (values, forces) in values.iter().zip(&mut forces) {
            let mut gradient = DMat3::ZERO;
            for ((place, sign), slope) in own.iter().zip(&slopes) {
                let value = *sign * values[*place];
                gradient += DMat3::from_cols(slope.x * value, slope.y * value, slope.z * value);
            }
            let trace = gradient.x_axis.x + gradient.y_axis.y + gradient.z_axis.z;
            let stress = shear * (gradient + gradient.transpose()) + lame * trace * DMat3::IDENTITY;
            for (force, slope) in forces.iter_mut().zip(&slopes) {
                *force += weight * (stress * *slope);
            }
        }
    }
    forces
}
