//! Pairs that are described one by one, as those of meshed bodies are.

use super::{ContactFrame, Shape, centre::Centre, cloud::Clouds};
use crate::numerics::WRITTEN;

/// Pairs that may touch, in the axes of the frame, one entry a pair in each list.
///
/// The bodies approach along z. Where the frame is mirrored, only the pairs on one side of the plane of
/// symmetry are listed.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Pairs {
    /// Where they are (m).
    pub places: Vec<[f64; 3]>,
    /// What area (m^2) each stands for, that of its mirror images included.
    pub areas: Vec<f64>,
    /// Unit vectors t1, t2 and n of each; none on a plane frame, whose axes serve everywhere.
    pub bases: Vec<[[f64; 3]; 3]>,
    /// Gaps of the undeformed bodies at first touch (m).
    pub gap: Vec<f64>,
    /// Corners (m) of the part of the surface that each stands for, in order; for pictures.
    pub outlines: Vec<Vec<[f64; 3]>>,
    /// Rows and columns, where the pairs form a grid along x and y: pair i = ix + nx iy.
    pub elements: Option<[usize; 2]>,
    /// Whether x = 0 and y = 0 are planes of symmetry.
    pub mirrored: [bool; 2],
    /// Whether the surfaces end where the pairs do, so that all of them may touch; otherwise a contact that
    /// takes all of them has outgrown the frame.
    pub closed: bool,
}

/// A description of pairs that describes none.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum PairsError {
    /// No pairs.
    #[error("a frame needs at least one pair")]
    Empty,
    /// A list of another length than that of the places.
    #[error("{found} {what} are given for {pairs} pairs")]
    Length {
        /// What is listed.
        what: &'static str,
        /// Length of the list.
        found: usize,
        /// Number of pairs.
        pairs: usize,
    },
    /// A value that is no number.
    #[error("the {what} of pair {pair} is not finite")]
    NotFinite {
        /// What is listed.
        what: &'static str,
        /// The pair.
        pair: usize,
    },
    /// An area that is zero or negative.
    #[error("the area of pair {pair} is {area:e} m^2, not positive")]
    NoArea {
        /// The pair.
        pair: usize,
        /// Its area (m^2).
        area: f64,
    },
    /// Vectors that are not of unit length, at right angles and right-handed.
    #[error("the basis of pair {pair} is not orthonormal and right-handed")]
    NotABasis {
        /// The pair.
        pair: usize,
    },
    /// An outline without an area.
    #[error("the outline of pair {pair} has fewer than three corners")]
    NoOutline {
        /// The pair.
        pair: usize,
    },
    /// A grid of another number of pairs.
    #[error("a grid of {} by {} does not have {pairs} pairs", .elements[0], .elements[1])]
    NotAGrid {
        /// Columns and rows.
        elements: [usize; 2],
        /// Number of pairs.
        pairs: usize,
    },
}

impl Pairs {
    fn check(&self) -> Result<(), PairsError> {
        let pairs = self.places.len();
        if pairs == 0 {
            return Err(PairsError::Empty);
        }
        let bases = if self.bases.is_empty() { pairs } else { self.bases.len() };
        for (what, found) in [
            ("areas", self.areas.len()),
            ("gaps", self.gap.len()),
            ("outlines", self.outlines.len()),
            ("bases", bases),
        ] {
            if found != pairs {
                return Err(PairsError::Length { what, found, pairs });
            }
        }
        if let Some(elements) = self.elements
            && elements[0].checked_mul(elements[1]) != Some(pairs)
        {
            return Err(PairsError::NotAGrid { elements, pairs });
        }
        (0..pairs).try_for_each(|pair| self.check_pair(pair))
    }

    fn check_pair(&self, pair: usize) -> Result<(), PairsError> {
        let finite = |values: &[f64]| values.iter().all(|value| value.is_finite());
        for (what, found) in [
            ("place", finite(&self.places[pair])),
            ("area", self.areas[pair].is_finite()),
            ("gap", self.gap[pair].is_finite()),
            ("outline", self.outlines[pair].iter().all(|corner| finite(corner))),
        ] {
            if !found {
                return Err(PairsError::NotFinite { what, pair });
            }
        }
        if self.areas[pair] <= 0.0 {
            return Err(PairsError::NoArea { pair, area: self.areas[pair] });
        }
        if self.outlines[pair].len() < 3 {
            return Err(PairsError::NoOutline { pair });
        }
        match self.bases.get(pair) {
            Some(basis) if !is_basis(basis) => Err(PairsError::NotABasis { pair }),
            _ => Ok(()),
        }
    }
}

/// Whether vectors are of unit length, at right angles and right-handed.
fn is_basis([t1, t2, n]: &[[f64; 3]; 3]) -> bool {
    let dot = |a: &[f64; 3], b: &[f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let cross = [0, 1, 2].map(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        t1[j] * t2[k] - t1[k] * t2[j]
    });
    let off = [dot(t1, t1) - 1.0, dot(t2, t2) - 1.0, dot(t1, t2), dot(&cross, n) - 1.0];
    off.iter().all(|off| off.abs() < WRITTEN)
}

/// Pairs with what follows from them.
#[derive(Debug, Clone)]
pub(super) struct Described {
    pub pairs: Pairs,
    /// Mean area (m^2), and the areas relative to it.
    pub area: f64,
    pub weights: Vec<f64>,
    /// How much of the approach closes each gap; none on a plane frame.
    pub closing: Vec<f64>,
    /// Size along x and y (m), mirror images included.
    pub size: [f64; 2],
    pub centre: Centre,
    pub clouds: Clouds,
    pub largest: usize,
}

impl ContactFrame {
    /// A frame of pairs that are described one by one.
    ///
    /// # Errors
    /// If the description contradicts itself.
    pub fn described(mut pairs: Pairs) -> Result<Self, PairsError> {
        pairs.check()?;
        let gap = std::mem::take(&mut pairs.gap);
        let area = pairs.areas.iter().sum::<f64>() / pairs.areas.len() as f64;
        let described = Described {
            area,
            weights: pairs.areas.iter().map(|one| one / area).collect(),
            closing: pairs.bases.iter().map(|[_, _, n]| n[2]).collect(),
            size: [0, 1].map(|axis| extent(&pairs, axis)),
            centre: Centre::of(&pairs.places, pairs.mirrored),
            clouds: Clouds::default(),
            largest: largest(&pairs),
            pairs,
        };
        Ok(Self { shape: Shape::Described(Box::new(described)), gap, closing: vec![] })
    }
}

/// The largest pair, of equal ones that nearest to the centre.
fn largest(pairs: &Pairs) -> usize {
    let most = pairs.areas.iter().copied().fold(0.0, f64::max);
    let large = (0..pairs.areas.len()).filter(|&pair| pairs.areas[pair] >= (1.0 - WRITTEN) * most);
    let distance = |pair: usize| pairs.places[pair][0].hypot(pairs.places[pair][1]);
    large.min_by(|&a, &b| distance(a).total_cmp(&distance(b))).unwrap_or_default()
}

/// Extent (m) along an axis, mirror images included.
fn extent(pairs: &Pairs, axis: usize) -> f64 {
    let corners = pairs.outlines.iter().flatten().map(|corner| corner[axis]);
    if pairs.mirrored[axis] {
        return 2.0 * corners.fold(0.0, |most: f64, place| most.max(place.abs()));
    }
    let lowest = corners.clone().fold(f64::INFINITY, f64::min);
    corners.fold(f64::NEG_INFINITY, f64::max) - lowest
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{ContactFrame, Pairs, PairsError};
    use crate::frame::VectorField;

    /// Two pairs on a roof over a frame mirrored at x = 0.
    fn roof() -> Pairs {
        let (c, s) = (0.8, 0.6);
        let basis = [[c, 0.0, -s], [0.0, 1.0, 0.0], [s, 0.0, c]];
        let outline =
            |y: f64| vec![[0.0, y, 0.6], [0.8, y, 0.0], [0.8, y + 2.0, 0.0], [0.0, y + 2.0, 0.6]];
        Pairs {
            places: vec![[0.4, -1.0, 0.3], [0.4, 1.0, 0.3]],
            areas: vec![4.0, 4.0],
            bases: vec![basis; 2],
            gap: vec![0.0, 1.0],
            outlines: vec![outline(-2.0), outline(0.0)],
            elements: Some([1, 2]),
            mirrored: [true, false],
            closed: true,
        }
    }

    #[test]
    fn forces_are_those_of_all_images() {
        let frame = ContactFrame::described(roof()).unwrap();
        let field = |value: f64| vec![value, 2.0 * value];
        let pressed = VectorField { t1: field(0.0), t2: field(1.0), n: field(-1.0) };
        let [x, y, z] = frame.force(&pressed);
        assert_eq!(x, 0.0);
        assert_relative_eq!(y, 12.0);
        assert_relative_eq!(z, -12.0 * 0.8);
        assert_relative_eq!(frame.measure().load(&field(1.0)), 12.0 * 0.8);
        assert_relative_eq!(frame.measure().side, 2.0_f64.sqrt());
        assert_relative_eq!(frame.integrate(&field(1.0)), 12.0);
        assert_relative_eq!(frame.area_where(|pair| pair == 1), 4.0);
        assert_eq!(frame.size(), [1.6, 4.0]);
        // Body 2 approaches along -z: down the roof and onto it.
        let moved = frame.moved([0.0, 0.0, -1.0]);
        assert_relative_eq!(moved.t1[0], 0.6);
        assert_relative_eq!(moved.n[0], -0.8);
    }

    #[test]
    fn what_contradicts_itself_is_refused() {
        let refused = |change: fn(&mut Pairs)| {
            let mut pairs = roof();
            change(&mut pairs);
            ContactFrame::described(pairs).map(|_| ()).unwrap_err()
        };
        assert_eq!(refused(|pairs| *pairs = Pairs::default()), PairsError::Empty);
        let length = PairsError::Length { what: "areas", found: 1, pairs: 2 };
        assert_eq!(refused(|pairs| pairs.areas.truncate(1)), length);
        let area = PairsError::NoArea { pair: 1, area: -1.0 };
        assert_eq!(refused(|pairs| pairs.areas[1] = -1.0), area);
        let gap = PairsError::NotFinite { what: "gap", pair: 0 };
        assert_eq!(refused(|pairs| pairs.gap[0] = f64::NAN), gap);
        let basis = PairsError::NotABasis { pair: 1 };
        assert_eq!(refused(|pairs| pairs.bases[1][2] = [0.0, 0.0, 1.0]), basis);
        let grid = PairsError::NotAGrid { elements: [2, 2], pairs: 2 };
        assert_eq!(refused(|pairs| pairs.elements = Some([2, 2])), grid);
        let outline = PairsError::NoOutline { pair: 0 };
        assert_eq!(refused(|pairs| pairs.outlines[0].truncate(2)), outline);
    }
}
