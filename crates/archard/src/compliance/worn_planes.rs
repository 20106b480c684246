//! The compliance of bodies that wear as they roll: pressures in a plane of rolling wear all of it.
//!
//! Over some revolutions a plane wears by its slope times the sum of its pressures, and that opens the gap
//! along the whole plane: a matrix of rank one beside the elastic compliance, plane by plane. It is
//! symmetric and positive, so that an implicit step of wear is one normal contact problem.

use super::{Compliance, Preconditioner};
use crate::frame::{Direction, VectorField};
use crate::numerics::dense::Cholesky;

/// A compliance with the wear of its planes.
#[derive(Debug)]
pub struct WornPlanes<'a> {
    elastic: &'a dyn Compliance,
    planes: Vec<Plane>,
    /// Elastic displacement (m/Pa) that uniform unit pressure on the contact of a plane makes, a pair on the
    /// average, of a plane that many planes away.
    between: Vec<f64>,
}

/// A plane of rolling.
#[derive(Debug)]
struct Plane {
    /// All its pairs, and those in contact.
    pairs: Vec<usize>,
    contact: Vec<usize>,
    /// Wear (m) of the plane under a unit pressure (Pa) on one pair.
    slope: f64,
}

impl<'a> WornPlanes<'a> {
    /// Planes along a direction on a grid of that many elements, that wear by these slopes (m/Pa) while about
    /// the pairs under the given pressure are in contact.
    pub fn new(
        elastic: &'a dyn Compliance,
        direction: Direction,
        elements: [usize; 2],
        slopes: &[f64],
        pressure: &[f64],
    ) -> Self {
        let planes = direction.planes(elements).zip(slopes);
        let planes: Vec<Plane> = planes
            .map(|(pairs, &slope)| Plane {
                contact: pairs.clone().filter(|&pair| pressure[pair] > 0.0).collect(),
                pairs: pairs.collect(),
                slope,
            })
            .collect();
        let between = between(elastic, &planes, pressure.len());
        Self { elastic, planes, between }
    }

    /// Adds to displacements (m) what pressures (Pa) wear, times a factor.
    pub fn add_wear(&self, pressure: &[f64], factor: f64, displacement: &mut [f64]) {
        for plane in &self.planes {
            let sum: f64 = plane.pairs.iter().map(|&pair| pressure[pair]).sum();
            if sum != 0.0 {
                let depth = factor * plane.slope * sum;
                plane.pairs.iter().for_each(|&pair| displacement[pair] += depth);
            }
        }
    }
}

/// See [`WornPlanes`]: found from the widest contact.
fn between(elastic: &dyn Compliance, planes: &[Plane], pairs: usize) -> Vec<f64> {
    let widest = planes.iter().max_by_key(|plane| plane.contact.len());
    let Some(widest) = widest.filter(|plane| !plane.contact.is_empty()) else { return vec![] };
    let number = |pair: &usize| widest.pairs.iter().position(|other| other == pair);
    let numbers: Vec<usize> = widest.contact.iter().filter_map(number).collect();
    let mut pressure = vec![0.0; pairs];
    numbers.iter().for_each(|&number| pressure[planes[0].pairs[number]] = 1.0);
    let mut displacement = vec![0.0; pairs];
    elastic.apply_normal(&pressure, &mut displacement);
    let sum = |plane: &Plane| numbers.iter().map(|&n| displacement[plane.pairs[n]]).sum::<f64>();
    planes.iter().map(|plane| sum(plane) / (numbers.len() * numbers.len()) as f64).collect()
}

impl Compliance for WornPlanes<'_> {
    fn apply(&self, tractions: &VectorField) -> VectorField {
        let mut displacement = self.elastic.apply(tractions);
        self.add_wear(&tractions.n, 1.0, &mut displacement.n);
        displacement
    }

    fn apply_normal(&self, pressure: &[f64], displacement: &mut [f64]) {
        self.elastic.apply_normal(pressure, displacement);
        self.add_wear(pressure, 1.0, displacement);
    }

    fn normal_self_term(&self) -> f64 {
        self.elastic.normal_self_term()
    }

    fn couples(&self) -> bool {
        self.elastic.couples()
    }

    /// The mean over the contact of a plane and the deviations from it are taken apart: wear does not see
    /// the deviations, and the means are few enough to be solved for.
    fn normal_preconditioner(&self, addition: f64) -> Box<dyn Preconditioner + '_> {
        let elastic = self.elastic.normal_preconditioner(addition);
        let rows: Vec<&Plane> =
            self.planes.iter().filter(|plane| !plane.contact.is_empty()).collect();
        let numbers: Vec<usize> =
            (0..self.planes.len()).filter(|&n| !self.planes[n].contact.is_empty()).collect();
        let element = |row: usize, column: usize| {
            let [one, other] = [row, column].map(|index| rows[index].contact.len() as f64);
            let own = if row == column { rows[row].slope + addition / one } else { 0.0 };
            one * other * (self.between[numbers[row].abs_diff(numbers[column])] + own)
        };
        match Cholesky::new(rows.len(), element) {
            Some(means) => Box::new(ByPlanes { elastic, rows, means }),
            None => elastic,
        }
    }
}

/// Means over the contact of each plane by Cholesky's factors, deviations by the elastic preconditioner.
#[derive(Debug)]
struct ByPlanes<'a> {
    elastic: Box<dyn Preconditioner + 'a>,
    rows: Vec<&'a Plane>,
    means: Cholesky,
}

impl ByPlanes<'_> {
    /// Takes the mean over its contact from each plane; returns the sums.
    fn deviate(&self, values: &mut [f64]) -> Vec<f64> {
        let take = |row: &&Plane| {
            let sum: f64 = row.contact.iter().map(|&pair| values[pair]).sum();
            let mean = sum / row.contact.len() as f64;
            row.contact.iter().for_each(|&pair| values[pair] -= mean);
            sum
        };
        self.rows.iter().map(take).collect()
    }
}

impl Preconditioner for ByPlanes<'_> {
    fn apply(&self, displacement: &[f64], pressure: &mut [f64]) {
        let mut deviations = displacement.to_vec();
        let sums = self.deviate(&mut deviations);
        self.elastic.apply(&deviations, pressure);
        self.deviate(pressure);
        for (row, mean) in self.rows.iter().zip(self.means.solve(&sums)) {
            row.contact.iter().for_each(|&pair| pressure[pair] += mean);
        }
    }
}
