//! How far a body is off close to where it is loaded, from its compliance alone.
//!
//! What varies over lengths that are small against a body displaces it as a half-space, whatever its shape and its supports. Pressures
//! less their means over circles vary like that: they have no force and no moment. The work that they do on the displacements of the
//! body, against that on those of a half-space, is by how much its elements are too stiff at the size of the circles. Elements that grow
//! with the depth are too stiff at all larger sizes too, by no more than that.

use faer::Mat;
use glam::DVec3;
use rayon::prelude::*;

use super::super::element::evaluate;
use super::super::rules::{Places, Rules};
use super::host::{Host, spots};
use crate::body::Material;

/// Relative error of integrals over elements; what is sought is known to a tenth at best.
const TOLERANCE: f64 = 1e-2;

/// The normal compliances of a body and of a half-space of its material, at the same pairs.
#[derive(Debug)]
pub(crate) struct Near {
    places: Vec<DVec3>,
    areas: Vec<f64>,
    half_space: Mat<f64>,
    body: Mat<f64>,
}

impl Near {
    /// Of the pairs of a host and of the compliance of a body there, row 3 i + d and column 3 j + e as [`Dense`] takes them.
    ///
    /// [`Dense`]: crate::compliance::Dense
    pub(super) fn new(host: &Host<'_>, material: &Material, compliance: &Mat<f64>) -> Self {
        let count = host.contact.len();
        let body =
            Mat::from_fn(count, count, |row, column| compliance[(3 * row + 2, 3 * column + 2)]);
        Self {
            places: (0..count).map(|pair| host.place(pair)).collect(),
            areas: (0..count).map(|pair| host.area(pair)).collect(),
            half_space: half_space(host, material),
            body,
        }
    }

    /// The work (N m) of pressures (Pa) on displacements (m).
    pub fn work(&self, pressure: &[f64], displacement: &[f64]) -> f64 {
        let pairs = self.areas.iter().zip(pressure).zip(displacement);
        pairs.map(|((area, pressure), displacement)| area * pressure * displacement).sum()
    }

    /// The work (N m) of pressures (Pa) that the elements miss, or do too much.
    pub fn missed(&self, pressure: &[f64]) -> f64 {
        let on = |compliance: &Mat<f64>, pressure: &[f64]| {
            let own = faer::MatRef::from_column_major_slice(pressure, pressure.len(), 1);
            let moved = compliance * own;
            self.work(pressure, moved.col_as_slice(0))
        };
        let rough = self.less_means(pressure, self.reach(pressure));
        let [own, known] = [&self.body, &self.half_space].map(|one| on(one, &rough));
        if known > 0.0 { (own / known - 1.0).abs() * on(&self.half_space, pressure) } else { 0.0 }
    }

    /// How far pressures lie from their middle (m), and no less than two pairs.
    fn reach(&self, pressure: &[f64]) -> f64 {
        let forces = || self.areas.iter().zip(pressure).map(|(area, one)| area * one.abs());
        let all: f64 = forces().sum();
        if all == 0.0 {
            return 0.0;
        }
        let middle: DVec3 =
            forces().zip(&self.places).map(|(force, place)| force / all * *place).sum();
        let square: f64 = forces()
            .zip(&self.places)
            .map(|(force, place)| force / all * place.distance_squared(middle))
            .sum();
        let width = self.areas.iter().copied().fold(0.0, f64::max).sqrt();
        square.sqrt().max(2.0 * width)
    }

    /// Pressures less what they are when the force of each pair is spread evenly over those within a distance (m).
    fn less_means(&self, pressure: &[f64], reach: f64) -> Vec<f64> {
        let near = |pair: usize| {
            let own = self.places[pair];
            let others = 0..self.places.len();
            others.filter(move |other| self.places[*other].distance(own) <= reach)
        };
        let mut left = pressure.to_vec();
        for (pair, pressure) in pressure.iter().enumerate().filter(|(_, one)| **one != 0.0) {
            let area: f64 = near(pair).map(|other| self.areas[other]).sum();
            near(pair).for_each(|other| left[other] -= pressure * self.areas[pair] / area);
        }
        left
    }
}

/// Mean normal displacements (m) of pairs on a half-space under a unit pressure (Pa) of each.
fn half_space(host: &Host<'_>, material: &Material) -> Mat<f64> {
    let count = host.contact.len();
    let pair_of = host.pair_of();
    let zone = &host.finite.meshed.zone.faces;
    let rules = Rules::new(TOLERANCE);
    let factor = (1.0 - material.poisson.powi(2)) / (std::f64::consts::PI * material.young);
    let spots = spots(host.finite, &host.surface, host.normals());
    let pairs = |face: usize| -> Vec<Option<usize>> {
        host.surface.tractions_of(face).map(|node| pair_of[node]).collect()
    };
    let columns: Vec<Vec<Option<usize>>> = zone.iter().map(|face| pairs(*face)).collect();
    let rows = spots.par_iter().map(|spot| {
        let seen = host.surface.patches[spot.face].at(spot.at);
        let mut row = vec![0.0; count];
        let mut places = Places::default();
        for (face, columns) in zone.iter().zip(&columns) {
            let patch = &host.surface.patches[*face];
            places.clear();
            match *face == spot.face {
                true => rules.polar(patch, spot.at, &mut places),
                false => rules.near(patch, seen, &mut places),
            }
            for ((&s, &t), weight) in places.s.iter().zip(&places.t).zip(&places.weight) {
                let area = weight * patch.area_vector([s, t]).length();
                let value = factor * area / seen.distance(patch.at([s, t]));
                for (column, shape) in columns.iter().zip(patch.element.shape) {
                    if let Some(column) = column {
                        row[*column] += value * evaluate(shape, [s, t]);
                    }
                }
            }
        }
        row
    });
    let rows: Vec<Vec<f64>> = rows.collect();
    let mut means = Mat::zeros(count, count);
    for (spot, row) in spots.iter().zip(&rows) {
        for (node, share) in spot.shares(&host.surface) {
            let Some(pair) = pair_of[node] else { continue };
            let share = share / host.area(pair);
            row.iter()
                .enumerate()
                .for_each(|(column, value)| means[(pair, column)] += share * value);
        }
    }
    means
}
