//! A sum of products of polynomials on a uniform grid: what acts, what sees it, and how they belong together.

use std::sync::Arc;

use faer::Mat;
use rayon::prelude::*;

use crate::compliance::bem::image::Polynomials;
use crate::frame::{Direction, Part, Rectangle, VectorField};
use crate::numerics::vector::{sum, update};

/// Polynomials at the elements of a grid: of each degree its means over columns, and over rows.
#[derive(Debug, Clone)]
struct Modes {
    columns: Vec<Vec<f64>>,
    rows: Vec<Vec<f64>>,
}

/// What an image field adds to a compliance on the elements of a grid (m/Pa).
#[derive(Debug, Clone)]
pub(super) struct Term {
    /// (m/N) between polynomials: row and column d m + i.
    compliance: Arc<Mat<f64>>,
    polynomials: Arc<Polynomials>,
    rectangle: Rectangle,
    elements: [usize; 2],
    acting: Arc<Modes>,
    seeing: Arc<Modes>,
    /// Displacements are what particles gain of them on the way to a pair.
    direction: Option<Direction>,
}

impl Modes {
    /// Means over elements, less those over the elements ahead where there is a direction.
    fn new(
        polynomials: &Polynomials,
        rectangle: Rectangle,
        elements: [usize; 2],
        direction: Option<Direction>,
    ) -> Self {
        let of = |axis: usize| -> Vec<Vec<f64>> {
            let width = rectangle.size[axis] / elements[axis] as f64;
            let middle = |index: usize| {
                let steps = 2.0 * index as f64 + 1.0 - elements[axis] as f64;
                rectangle.centre[axis] + 0.5 * width * steps
            };
            let ahead = direction.filter(|direction| direction.axis == axis);
            let value = |index: usize| {
                let place = middle(index);
                let ends = |place: f64| [place - 0.5 * width, place + 0.5 * width];
                let mut own = polynomials.means(axis, ends(place));
                if let Some(ahead) = ahead {
                    let next = place + width * ahead.forward()[axis];
                    let next = polynomials.means(axis, ends(next));
                    own.iter_mut().zip(next).for_each(|(own, next)| *own -= next);
                }
                own
            };
            let values: Vec<Vec<f64>> = (0..elements[axis]).map(value).collect();
            let degree = |n: usize| values.iter().map(|own| own[n]).collect();
            (0..=polynomials.degree).map(degree).collect()
        };
        Self { columns: of(0), rows: of(1) }
    }
}

impl Term {
    /// On the elements of a grid over a rectangle.
    pub fn new(
        (polynomials, compliance): (Arc<Polynomials>, Arc<Mat<f64>>),
        rectangle: Rectangle,
        elements: [usize; 2],
    ) -> Self {
        let acting = Arc::new(Modes::new(&polynomials, rectangle, elements, None));
        let seeing = Arc::clone(&acting);
        Self { compliance, polynomials, rectangle, elements, acting, seeing, direction: None }
    }

    /// The same on other elements.
    pub fn on(&self, rectangle: Rectangle, elements: [usize; 2]) -> Self {
        let parts = (Arc::clone(&self.polynomials), Arc::clone(&self.compliance));
        let plain = Self::new(parts, rectangle, elements);
        match self.direction {
            Some(direction) => plain.gained(direction),
            None => plain,
        }
    }

    /// The same, displacements being what particles gain of them on the way to a pair.
    pub fn gained(&self, direction: Direction) -> Self {
        let seeing = Modes::new(&self.polynomials, self.rectangle, self.elements, Some(direction));
        Self { seeing: Arc::new(seeing), direction: Some(direction), ..self.clone() }
    }

    /// On a part of the elements.
    pub fn within(&self, part: &Part) -> Self {
        self.on(part.rectangle(self.rectangle), part.size())
    }

    /// On as few elements of twice the size as cover these.
    pub fn coarser(&self) -> Self {
        let elements = self.elements.map(|count| count.div_ceil(2));
        let spacing = [0, 1].map(|axis| self.rectangle.size[axis] / self.elements[axis] as f64);
        let size = [0, 1].map(|axis| 2.0 * spacing[axis] * elements[axis] as f64);
        let corner = self.rectangle.corner();
        let centre = [0, 1].map(|axis| corner[axis] + 0.5 * size[axis]);
        self.on(Rectangle { centre, size }, elements)
    }

    /// Number of elements along x and y.
    pub fn elements(&self) -> [usize; 2] {
        self.elements
    }

    /// The same of another compliance (m/N) between the polynomials.
    pub fn of(&self, compliance: &Arc<Mat<f64>>) -> Self {
        Self { compliance: Arc::clone(compliance), ..self.clone() }
    }

    /// Adds the displacements (m) under tractions (Pa).
    pub fn add_all(&self, tractions: &VectorField, displacements: &mut VectorField) {
        let [one, two, three] = tractions.components();
        let VectorField { t1, t2, n } = displacements;
        self.add([(0, one), (1, two), (2, three)], [(0, t1), (1, t2), (2, n)]);
    }

    /// Adds the displacements (m) along some axes under tractions (Pa) along some.
    pub fn add<const N: usize, const M: usize>(
        &self,
        tractions: [(usize, &[f64]); N],
        displacements: [(usize, &mut [f64]); M],
    ) {
        let loads = tractions.map(|(along, field)| (along, self.project(field)));
        let count = self.count();
        for (along, field) in displacements {
            let row = |index: usize| -> f64 {
                let of = |(other, load): &(usize, Vec<f64>)| -> f64 {
                    let row = along * count + index;
                    let terms = load.iter().enumerate();
                    terms.map(|(at, load)| self.compliance[(row, other * count + at)] * load).sum()
                };
                loads.iter().map(of).sum()
            };
            let weights: Vec<f64> = (0..count).map(row).collect();
            self.expand(&weights, field);
        }
    }

    /// The forces (N) that polynomials feel of tractions (Pa): d m + i is that of the i-th of m along axis d.
    pub fn forces(
        polynomials: &Polynomials,
        elements: [usize; 2],
        tractions: &VectorField,
    ) -> Vec<f64> {
        let parts = (Arc::new(polynomials.clone()), Arc::new(Mat::zeros(0, 0)));
        let term = Self::new(parts, polynomials.rectangle, elements);
        tractions.components().into_iter().flat_map(|field| term.project(field)).collect()
    }

    /// Number of polynomials.
    fn count(&self) -> usize {
        self.compliance.nrows() / 3
    }

    /// The forces (N) that polynomials feel of tractions (Pa), times what they are.
    fn project(&self, field: &[f64]) -> Vec<f64> {
        let Modes { columns, rows } = &*self.acting;
        let of_row = |row: &[f64]| -> Vec<f64> {
            if row.iter().all(|value| *value == 0.0) {
                return vec![0.0; columns.len()];
            }
            let product = |column: &Vec<f64>| sum([row, column], |[value, mode]| [value * mode])[0];
            columns.iter().map(product).collect()
        };
        let lines: Vec<Vec<f64>> =
            field.par_chunks(self.elements[0]).with_min_len(LINES).map(of_row).collect();
        let area: f64 =
            (0..2).map(|axis| self.rectangle.size[axis] / self.elements[axis] as f64).product();
        let force = |[x, y]: [usize; 2]| -> f64 {
            area * lines.iter().zip(&rows[y]).map(|(line, row)| line[x] * row).sum::<f64>()
        };
        self.polynomials.degrees().into_iter().map(force).collect()
    }

    /// Adds a sum of polynomials to a field.
    fn expand(&self, weights: &[f64], field: &mut [f64]) {
        let Modes { columns, rows } = &*self.seeing;
        let degrees = self.polynomials.degrees();
        let lines = field.par_chunks_mut(self.elements[0]).with_min_len(LINES).enumerate();
        lines.for_each(|(line, values)| {
            let mut along = vec![0.0; columns.len()];
            for ([x, y], weight) in degrees.iter().zip(weights) {
                along[*x] += weight * rows[*y][line];
            }
            for (weight, column) in along.into_iter().zip(columns) {
                update(values, [column], |value, [mode]| value + weight * mode);
            }
        });
    }
}

/// Lines of elements that are worth a thread. A choice of cost.
const LINES: usize = 64;
