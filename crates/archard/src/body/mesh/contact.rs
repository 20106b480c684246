//! The zone that may touch, as cases ask for it.

use std::f64::consts::FRAC_PI_2;

use super::MeshError;
use super::axis::{Growth, Middle};
use crate::parameters::{Bound, Invalid, Parameter, Quantity, Values};

/// Largest number of elements of a zone; more would not fit any computer's memory.
pub(super) const MOST_ELEMENTS: usize = 1_000_000;
/// Largest number of divisions of an edge.
const MOST_DIVISIONS: usize = 400;
/// Divisions of the shortest edge that are enough, and of a quarter of the circumference where no wall is thin.
pub(super) const ENOUGH: usize = 4;

/// The parameter of the zone, on one of these sides of the body.
pub(super) const fn parameter(inside: &'static [Parameter]) -> Parameter {
    Parameter::optional("contact", Quantity::Section(inside), "the zone that may touch")
}

/// The parameters of the zone, without its side.
pub(super) const SIZE: Parameter = Parameter::required(
    "size",
    Quantity::Pair(&Quantity::Length),
    "lengths of the zone along x and y, along the surface",
);
pub(super) const ELEMENTS: Parameter = Parameter::required(
    "elements",
    Quantity::Pair(&Quantity::Count),
    "numbers of elements of the zone along x and y",
);
pub(super) const GROWTH: Parameter = Parameter::optional(
    "growth",
    Quantity::Number,
    "largest ratio of neighbouring elements away from the zone; 2 unless given",
)
.bound(Bound::Between(1.05, 10.0));
/// The parameter of a body that is divided evenly, without a zone.
pub(super) const DIVISIONS: Parameter = Parameter::optional(
    "divisions",
    Quantity::Count,
    "instead of `contact`: equal elements along a quarter of the circumference",
);

/// The parameter of a box that is divided evenly.
pub(super) const DIVISIONS_OF_EDGES: Parameter = Parameter::optional(
    "divisions",
    Quantity::OneOrThree(&Quantity::Count),
    "instead of `contact`: equal elements along the shortest edge, which the others follow, or along x, y and z",
);

/// How the elements of a body are laid out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Layout {
    /// Around a zone that may touch.
    Contact(Contact),
    /// Evenly.
    Even(Divisions),
}

/// Equal elements of a body without a zone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Divisions {
    /// As many as are enough.
    Enough,
    /// So many along the shortest edge, or a quarter of the circumference; others follow.
    Along(usize),
    /// So many along x, y and z.
    Each([usize; 3]),
}

/// The zone that may touch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Contact {
    /// Lengths along x and y (m).
    pub size: [f64; 2],
    /// Elements along x and y.
    pub elements: [usize; 2],
    /// Largest ratio of neighbouring elements.
    pub growth: f64,
}

impl Layout {
    /// What the values ask for, the zone no longer than `room` (m) along x and y.
    pub fn read(values: &Values, room: [f64; 2]) -> Result<Self, Invalid> {
        match (values.section("contact"), values.get("divisions")) {
            (Some(section), None) => Ok(Self::Contact(Contact::read(section, room)?)),
            (None, _) => Divisions::read(values).map(Self::Even),
            (Some(_), Some(_)) => Err(Invalid::exclusive("divisions", "contact", "keep one")),
        }
    }

    /// The same around a round body whose elements may be so long, in radii.
    ///
    /// # Errors
    /// If fewer divisions are asked for than that takes.
    pub fn around(self, longest: f64) -> Result<Self, Invalid> {
        let least = (FRAC_PI_2 / longest).ceil() as usize;
        let invalid = |message: String| Err(Invalid::new("divisions", message));
        match self {
            Self::Even(Divisions::Along(count)) if count < least => invalid(format!(
                "elements of the wall would be too long compared with its thickness: take {least} at least"
            )),
            Self::Even(Divisions::Enough) if least > MOST_DIVISIONS => {
                invalid("is missing, and the wall is too thin for boundary elements".to_owned())
            }
            Self::Even(Divisions::Enough) => {
                Ok(Self::Even(Divisions::Along(least.max(ENOUGH).next_multiple_of(2))))
            }
            _ => Ok(self),
        }
    }

    /// An error where a plane of symmetry would halve elements.
    pub fn check(&self, mirrored: [bool; 2]) -> Result<(), MeshError> {
        for (place, axis) in ['x', 'y'].into_iter().enumerate() {
            match *self {
                _ if !mirrored[place] => {}
                Self::Contact(Contact { elements, .. }) if elements[place] % 2 == 1 => {
                    return Err(MeshError::OddElements { axis, count: elements[place] });
                }
                Self::Even(Divisions::Along(count)) if count % 2 == 1 => {
                    return Err(MeshError::OddDivisions { axis, count });
                }
                Self::Even(Divisions::Each(counts)) if counts[place] % 2 == 1 => {
                    return Err(MeshError::OddDivisions { axis, count: counts[place] });
                }
                _ => {}
            }
        }
        Ok(())
    }
}

impl Divisions {
    fn read(values: &Values) -> Result<Self, Invalid> {
        let number = values.number("divisions").map(|number| number as usize);
        let each = values.triple("divisions").map(|three| three.map(|number| number as usize));
        let most = each.map_or(number, |three| three.into_iter().max());
        if let Some(most) = most
            && most > MOST_DIVISIONS
        {
            let message = format!("{most} divisions are too many: take {MOST_DIVISIONS} at most");
            return Err(Invalid::new("divisions", message));
        }
        Ok(match (each, number) {
            (Some(three), _) => Self::Each(three),
            (None, Some(number)) => Self::Along(number),
            (None, None) => Self::Enough,
        })
    }

    /// How many along a quarter of the circumference, where they count there.
    pub fn of_a_quarter(self) -> usize {
        match self {
            Self::Along(number) => number,
            Self::Enough | Self::Each(_) => ENOUGH,
        }
    }
}

impl Contact {
    fn read(values: &Values, room: [f64; 2]) -> Result<Self, Invalid> {
        let missing = |name| Invalid::new(name, "is missing");
        let size = values.pair("size").ok_or_else(|| missing("contact.size"))?;
        let elements = values.pair("elements").ok_or_else(|| missing("contact.elements"))?;
        for ((axis, size), room) in ["x", "y"].into_iter().zip(size).zip(room) {
            if size > room * (1.0 + 1e-12) {
                let message = format!(
                    "the zone is {size} m long along {axis}, the body has room for {room} m"
                );
                return Err(Invalid::new("contact.size", message));
            }
        }
        if elements[0] * elements[1] > MOST_ELEMENTS as f64 {
            let message = format!("more than {MOST_ELEMENTS} elements: take fewer");
            return Err(Invalid::new("contact.elements", message));
        }
        let elements = elements.map(|number| (number as usize).max(1));
        Ok(Self { size, elements, growth: values.number("growth").unwrap_or(2.0) })
    }

    /// The middle part of an axis, 0 for x and 1 for y.
    pub fn middle(&self, axis: usize) -> Middle {
        Middle { length: self.size[axis], elements: self.elements[axis] }
    }

    /// How elements grow, none wider than that (m).
    pub fn growth(&self, widest: f64) -> Growth {
        Growth { ratio: self.growth, widest }
    }

    /// The smaller width of the elements of the zone (m).
    pub fn width(&self) -> f64 {
        let [x, y] = [0, 1].map(|axis| self.size[axis] / self.elements[axis] as f64);
        x.min(y)
    }

    /// The elements of the zone that are kept.
    pub fn kept(&self, mirrored: [bool; 2]) -> [usize; 2] {
        [0, 1]
            .map(|axis| if mirrored[axis] { self.elements[axis] / 2 } else { self.elements[axis] })
    }
}
