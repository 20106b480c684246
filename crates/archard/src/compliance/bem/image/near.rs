//! What a half-space does below loads on its zone, at the surface of the body that it stands for.

use std::sync::OnceLock;

use glam::{DMat3, DVec3};

use super::super::TractionNode;
use super::field::HalfSpaceField;
use super::zone::{Polynomials, ratio};
use crate::body::Material;
use crate::numerics::SAME;
use crate::numerics::quadrature::gauss_legendre;

/// Points of a rule along a side at most: places nearer to the zone than they resolve are as good as it.
const MOST_POINTS: usize = 64;

/// The field of a half-space at z < 0 under polynomials on its zone.
pub(in crate::compliance) struct NearField<'a> {
    field: HalfSpaceField,
    polynomials: &'a Polynomials,
    columns: &'a Columns,
    /// By their points along a side.
    rules: Vec<OnceLock<Rule>>,
}

impl<'a> NearField<'a> {
    pub fn new(material: &Material, polynomials: &'a Polynomials, columns: &'a Columns) -> Self {
        let rules = (0..=MOST_POINTS).map(|_| OnceLock::new()).collect();
        Self { field: HalfSpaceField::new(material), polynomials, columns, rules }
    }

    /// On a plane of that normal through a place (m).
    pub fn at(&self, place: DVec3, normal: DVec3) -> Field {
        let points = points(ratio(&self.polynomials.rectangle, place), self.polynomials.degree);
        let rule = self.rules[points].get_or_init(|| Rule::new(self.polynomials, points));
        rule.field(place, normal, &self.field, self.columns)
    }

    /// The same on a surface; `None` on the face of the zone, where the half-space has no traction.
    pub fn off_the_face(&self, place: DVec3, normal: DVec3) -> Option<Field> {
        (!on_the_face(place, normal)).then(|| self.at(place, normal))
    }

    /// The displacement (m) and the traction (Pa) on a surface under loads (N), three times as many as polynomials.
    pub(super) fn under(&self, node: &TractionNode, loads: &[f64]) -> [DVec3; 2] {
        let Some(field) = self.off_the_face(node.place, node.normal) else {
            return [DVec3::ZERO; 2];
        };
        [&field.displacement, &field.traction].map(|each| self.sum(each, loads))
    }

    /// What loads (N), three times as many as polynomials, make of vectors of those that are kept.
    pub fn sum(&self, each: &[DVec3], loads: &[f64]) -> DVec3 {
        let kept = self.columns.kept.iter();
        kept.zip(each).map(|(load, own)| loads[*load] * *own).sum()
    }

    /// The even loads among those that are kept, one along each axis.
    pub fn even(&self) -> impl Iterator<Item = usize> + '_ {
        let even = |column: &usize| column.is_multiple_of(self.columns.polynomials);
        (0..self.loads()).filter(move |load| even(&self.columns.kept[*load]))
    }

    /// How many loads there are.
    pub fn loads(&self) -> usize {
        self.columns.count()
    }

    /// No field.
    pub fn nothing(&self) -> Field {
        let loads = self.loads();
        Field { displacement: vec![DVec3::ZERO; loads], traction: vec![DVec3::ZERO; loads] }
    }
}

/// Whether a place of a surface lies on the face of the zone, where the half-space has no traction.
pub(super) fn on_the_face(place: DVec3, normal: DVec3) -> bool {
    normal.z > 1.0 - SAME && place.z.abs() <= SAME * place.length()
}

/// Points of Gauss along a side that integrate a field of such a ratio, times polynomials, to rounding of single precision: the error
/// falls by the square of the ratio with each.
fn points(ratio: f64, degree: usize) -> usize {
    let digits = f64::from(f32::EPSILON).recip().ln();
    let points = (0.5 * (digits / ratio.ln() + degree as f64)).ceil() + 1.0;
    if points.is_finite() { (points as usize).min(MOST_POINTS) } else { MOST_POINTS }
}

/// The loads that planes of symmetry let be.
pub(in crate::compliance) struct Columns {
    /// Of all polynomials.
    pub(super) polynomials: usize,
    /// Indices d m + i of those that are kept.
    pub(super) kept: Vec<usize>,
}

impl Columns {
    pub fn new(polynomials: &Polynomials, mirrored: [bool; 2]) -> Self {
        let degrees = polynomials.degrees();
        let count = degrees.len();
        let symmetric = |&column: &usize| {
            let (along, degrees) = (column / count, degrees[column % count]);
            let odd = |axis: usize| degrees[axis] % 2 == usize::from(along == axis);
            (0..2).all(|axis| !mirrored[axis] || odd(axis))
        };
        Self { polynomials: count, kept: (0..3 * count).filter(symmetric).collect() }
    }

    /// How many loads are kept.
    pub fn count(&self) -> usize {
        self.kept.len()
    }
}

/// Displacements (m) and tractions (Pa) of the half-space at a place of a surface, one a load.
pub(in crate::compliance) struct Field {
    pub displacement: Vec<DVec3>,
    pub traction: Vec<DVec3>,
}

/// Points of Gauss on the zone with the polynomials there, weighed.
struct Rule {
    points: Vec<(DVec3, Vec<f64>)>,
}

impl Rule {
    fn new(polynomials: &Polynomials, points: usize) -> Self {
        let along = [0, 1].map(|axis| {
            let half = 0.5 * polynomials.rectangle.size[axis];
            let middle = polynomials.rectangle.centre[axis];
            let point = |(x, weight): (f64, f64)| {
                let place = middle + half * x;
                (place, half * weight, polynomials.along(axis, place))
            };
            gauss_legendre(points).into_iter().map(point).collect::<Vec<_>>()
        });
        let degrees = &polynomials.degrees();
        let [x, y] = &along;
        let points = y.iter().flat_map(|(y, across, of_y)| {
            x.iter().map(move |(x, along, of_x)| {
                let value = |[i, j]: &[usize; 2]| along * across * of_x[*i] * of_y[*j];
                (DVec3::new(*x, *y, 0.0), degrees.iter().map(value).collect())
            })
        });
        Self { points: points.collect() }
    }

    fn field(
        &self,
        place: DVec3,
        normal: DVec3,
        field: &HalfSpaceField,
        columns: &Columns,
    ) -> Field {
        let mut sums = vec![[DMat3::ZERO; 2]; columns.polynomials];
        for (point, values) in &self.points {
            let [displacement, traction] = field.at(place - *point, normal);
            for (sum, value) in sums.iter_mut().zip(values) {
                sum[0] += *value * displacement;
                sum[1] += *value * traction;
            }
        }
        let of = |which: usize| {
            let kept = columns.kept.iter();
            kept.map(|column| {
                sums[column % columns.polynomials][which].col(column / columns.polynomials)
            })
            .collect()
        };
        Field { displacement: of(0), traction: of(1) }
    }
}
