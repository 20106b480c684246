//! A half-space under the tractions of a meshed body's contact zone.
//!
//! Boussinesq's and Cerruti's solutions, integrated over the elements of the zone as laid flat on the plane of
//! contact (K. L. Johnson, *Contact Mechanics*, Cambridge 1985, sections 3.2 and 3.6): with z into the solid
//! and x, y from the force,
//!
//! ```text
//! 4 pi G u_z(p_z) = 2 (1 - nu) / r        4 pi G u_x(q_x) = 2 (1 - nu) / r + 2 nu x^2 / r^3
//! 4 pi G u_x(p_z) = -(1 - 2 nu) x / r^2   4 pi G u_y(q_x) = 2 nu x y / r^3
//! ```

use std::f64::consts::PI;

use faer::Mat;
use glam::{DMat3, DVec3};
use rayon::prelude::*;

use super::super::element::evaluate;
use super::super::patch::{Patch, distance};
use super::super::rules::{Places, Rules};
use super::host::Host;
use crate::body::Material;

/// The compliance of a half-space that is body `which`, 0 or 1, at the pairs of a host.
pub(super) fn compliance(host: &Host<'_>, material: &Material, which: usize) -> Mat<f64> {
    let plane = |point: DVec3| {
        let place = host.in_frame(point);
        DVec3::new(place.x, place.y, 0.0)
    };
    // n is the outward normal of body 1.
    let into = if which == 1 { 1.0 } else { -1.0 };
    let kernel = Kernel { shear: material.shear_modulus(), poisson: material.poisson, into };
    let mut pair_of = vec![None; host.surface.tractions.len()];
    for (pair, (node, _)) in host.contact.iter().enumerate() {
        pair_of[*node] = Some(pair);
    }
    let zone = &host.finite.meshed.zone.faces;
    let patches: Vec<Patch> = zone
        .iter()
        .map(|&face| {
            let patch = &host.surface.patches[face];
            let corners = patch.corners.iter().map(|&corner| plane(corner)).collect();
            Patch::new(corners, patch.element)
        })
        .collect();
    let rules = Rules::new(host.finite.tolerance);
    let count = host.contact.len();
    let rows: Vec<Vec<f64>> = (0..count)
        .into_par_iter()
        .map(|pair| {
            let mut row = vec![0.0; 9 * count];
            let node = host.contact[pair].0;
            let point = plane(host.surface.tractions[node].place);
            let mut places = Places::default();
            for (image, (&face, patch)) in host
                .surface
                .images()
                .into_iter()
                .flat_map(|image| zone.iter().zip(&patches).map(move |of| (image, of)))
            {
                let seen = image * point;
                let own = host.surface.tractions_of(face).position(|other| other == node);
                places.clear();
                match own.filter(|_| seen == point) {
                    Some(own) => rules.polar(patch, patch.element.nodes[own], &mut places),
                    None if Rules::far(patch, distance(seen, &patch.corners)) => {
                        let orders = rules.orders(patch, distance(seen, &patch.corners));
                        rules.whole(patch, orders, &mut places);
                    }
                    None => rules.near(patch, seen, &mut places),
                }
                let columns: Vec<Option<usize>> =
                    host.surface.tractions_of(face).map(|other| pair_of[other]).collect();
                for ((&s, &t), weight) in places.s.iter().zip(&places.t).zip(&places.weight) {
                    let area = weight * patch.area_vector([s, t]).length();
                    let value = area * kernel.value(seen - patch.at([s, t]));
                    for (column, polynomial) in columns.iter().zip(patch.element.shape) {
                        let Some(column) = column else { continue };
                        let share = evaluate(polynomial, [s, t]);
                        for d in 0..3 {
                            for e in 0..3 {
                                row[(3 * column + e) * 3 + d] += share * image[d] * value.col(e)[d];
                            }
                        }
                    }
                }
            }
            row
        })
        .collect();
    Mat::from_fn(3 * count, 3 * count, |row, column| rows[row / 3][3 * column + row % 3])
}

struct Kernel {
    shear: f64,
    poisson: f64,
    into: f64,
}

impl Kernel {
    /// Displacement (m/N): column e for a unit force along e, at a place seen from it.
    fn value(&self, away: DVec3) -> DMat3 {
        let r = away.length();
        let unit = away / r;
        let factor = 1.0 / (4.0 * PI * self.shear * r);
        let (normal, shear) = (2.0 * (1.0 - self.poisson), 2.0 * self.poisson);
        let couple = self.into * (1.0 - 2.0 * self.poisson) * unit;
        factor
            * DMat3::from_cols(
                DVec3::new(normal + shear * unit.x * unit.x, shear * unit.x * unit.y, couple.x),
                DVec3::new(shear * unit.x * unit.y, normal + shear * unit.y * unit.y, couple.y),
                DVec3::new(-couple.x, -couple.y, normal),
            )
    }
}
