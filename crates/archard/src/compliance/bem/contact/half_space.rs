//! A half-space under the tractions of a meshed body's contact zone.
//!
//! Boussinesq's and Cerruti's solutions, integrated over the elements of the zone (K. L. Johnson, *Contact
//! Mechanics*, Cambridge 1985, sections 3.2 and 3.6): with m the unit normal into the solid and e the unit vector
//! from the force to a place on the surface, r away,
//!
//! ```text
//! 4 pi G r u = [2 (1 - nu) I + 2 nu e e^T + (1 - 2 nu) (m e^T - e m^T)] f
//! ```
//!
//! The elements are laid flat on the plane of contact, where a half-space stands for a body; or they stay where
//! they are, where its singular part is all that matters.

use std::f64::consts::PI;

use faer::Mat;
use glam::{DMat3, DVec3};
use rayon::prelude::*;

use super::super::element::evaluate;
use super::super::patch::Patch;
use super::super::rules::{Places, Rules};
use super::host::Host;
use crate::body::Material;

/// The compliance of a half-space that is body `which`, 0 or 1, at the pairs of a host laid flat.
pub(super) fn compliance(host: &Host<'_>, material: &Material, which: usize) -> Mat<f64> {
    let n = host.axes[2];
    let flat = |point: DVec3| point - point.dot(n) * n;
    let zone = host.finite.meshed.zone.faces.iter();
    let patches = zone
        .map(|&face| {
            let patch = &host.surface.patches[face];
            Patch::new(patch.corners.iter().map(|&corner| flat(corner)).collect(), patch.element)
        })
        .collect();
    let place = |node: usize| flat(host.surface.tractions[node].place);
    let zone = Zone {
        patches,
        places: host.contact.iter().map(|(node, _)| place(*node)).collect(),
        bases: vec![host.axes; host.contact.len()],
    };
    zone.compliance(host, material, which)
}

/// The same on the elements as they are, each pair along its own axes.
pub(super) fn on_the_surface(host: &Host<'_>, material: &Material, which: usize) -> Mat<f64> {
    let zone = host.finite.meshed.zone.faces.iter();
    let place = |node: usize| host.surface.tractions[node].place;
    let zone = Zone {
        patches: zone.map(|&face| host.surface.patches[face].clone()).collect(),
        places: host.contact.iter().map(|(node, _)| place(*node)).collect(),
        bases: host.contact.iter().map(|(_, basis)| *basis).collect(),
    };
    zone.compliance(host, material, which)
}

/// The elements and pairs of a host in the coordinates of its body.
struct Zone {
    patches: Vec<Patch>,
    places: Vec<DVec3>,
    bases: Vec<[DVec3; 3]>,
}

impl Zone {
    fn compliance(&self, host: &Host<'_>, material: &Material, which: usize) -> Mat<f64> {
        let pair_of = host.pair_of();
        let kernel = Kernel { shear: material.shear_modulus(), poisson: material.poisson };
        // Normals of the elements point out of the host.
        let into = if which == host.which { -1.0 } else { 1.0 };
        let rules = Rules::new(host.finite.tolerance);
        let count = self.places.len();
        let row = |pair: usize| {
            let mut row = vec![0.0; 9 * count];
            let (node, point) = (host.contact[pair].0, self.places[pair]);
            let mut places = Places::default();
            for image in host.surface.images() {
                let seen = image * point;
                let basis = self.bases[pair].map(|unit| image * unit);
                for (&face, patch) in host.finite.meshed.zone.faces.iter().zip(&self.patches) {
                    let own = host.surface.tractions_of(face).position(|other| other == node);
                    places.clear();
                    match own.filter(|_| seen == point) {
                        Some(own) => rules.polar(patch, patch.element.nodes[own], &mut places),
                        None => rules.near(patch, seen, &mut places),
                    }
                    let columns: Vec<Option<usize>> =
                        host.surface.tractions_of(face).map(|other| pair_of[other]).collect();
                    let mut sums = vec![DMat3::ZERO; columns.len()];
                    for ((&s, &t), weight) in places.s.iter().zip(&places.t).zip(&places.weight) {
                        let vector = patch.area_vector([s, t]);
                        let area = vector.length();
                        let away = seen - patch.at([s, t]);
                        let value = weight * area * kernel.value(away, into / area * vector);
                        for (sum, polynomial) in sums.iter_mut().zip(patch.element.shape) {
                            *sum += evaluate(polynomial, [s, t]) * value;
                        }
                    }
                    for (column, sum) in columns.iter().zip(&sums) {
                        let Some(column) = *column else { continue };
                        for (e, unit) in self.bases[column].iter().enumerate() {
                            let displacement = *sum * *unit;
                            for (d, along) in basis.iter().enumerate() {
                                row[(3 * column + e) * 3 + d] += along.dot(displacement);
                            }
                        }
                    }
                }
            }
            row
        };
        let rows: Vec<Vec<f64>> = (0..count).into_par_iter().map(row).collect();
        Mat::from_fn(3 * count, 3 * count, |row, column| rows[row / 3][3 * column + row % 3])
    }
}

struct Kernel {
    shear: f64,
    poisson: f64,
}

impl Kernel {
    /// Displacement (m/N): column e for a unit force along e, at a place seen from it, with the normal into
    /// the solid.
    fn value(&self, away: DVec3, into: DVec3) -> DMat3 {
        let r = away.length();
        let unit = away / r;
        let outer = |a: DVec3, b: DVec3| DMat3::from_cols(b.x * a, b.y * a, b.z * a);
        let couple = outer(into, unit) - outer(unit, into);
        let along = DMat3::from_diagonal(DVec3::splat(2.0 * (1.0 - self.poisson)));
        let shear = 2.0 * self.poisson * outer(unit, unit);
        1.0 / (4.0 * PI * self.shear * r) * (along + shear + (1.0 - 2.0 * self.poisson) * couple)
    }
}
