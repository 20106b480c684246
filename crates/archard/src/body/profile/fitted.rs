//! Bodies that fit into each other: a ball in a socket, a shaft in a bush. Their contact is drawn on their round surface.
//!
//! Places of the frame are no projections of it. On a sphere of radius R they lie on Lambert's map, at r = 2 R sin(theta/2) from the
//! pole (theta: angle from the pole), which keeps areas; on a cylinder x is the arc R theta. The recess is how far the surface lies
//! below the pole along the axis of the load, R (1 - cos theta).

use std::f64::consts::{FRAC_PI_2, SQRT_2};

use super::Profile;
use crate::parameters::{Bound, Choice, Invalid, Parameter, Quantity, Values};

/// What a surface is a part of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Round {
    /// A sphere.
    Sphere,
    /// A cylinder whose axis lies along y.
    Cylinder,
}

impl Round {
    /// The cosine of the angle from the pole at a place (m) of a frame that is drawn on such a surface of some radius (m); not a
    /// number where there is no such place.
    pub fn cosine(self, radius: f64, [x, y]: [f64; 2]) -> f64 {
        match self {
            Self::Sphere => {
                let half = 0.5 * (x * x + y * y) / (radius * radius);
                if half <= 2.0 { 1.0 - half } else { f64::NAN }
            }
            Self::Cylinder => {
                let angle = x / radius;
                if angle.abs() <= 2.0 * FRAC_PI_2 { angle.cos() } else { f64::NAN }
            }
        }
    }

    /// The names of the body that fits and of the one it fits into.
    pub fn names(self) -> [&'static str; 2] {
        match self {
            Self::Sphere => [BALL.name, SOCKET.name],
            Self::Cylinder => [SHAFT.name, BUSH.name],
        }
    }
}

/// A body that fits into another one, or another one into it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClearanceFit {
    /// What its surface is a part of.
    pub round: Round,
    /// Radius (m) of its surface.
    pub radius: f64,
    /// Whether the other one fits into it.
    pub hollow: bool,
    /// Angle (rad) from the pole to the nearest place of its rim: a right angle, but of a socket that is tilted.
    pub rim: f64,
}

pub(super) const BALL: Choice<Box<dyn Profile>> = Choice {
    name: "ball",
    meaning: "a ball in a `socket`; on other bodies write `sphere`",
    parameters: &[RADIUS],
    build: |values| built(values, Round::Sphere, false),
};

pub(super) const SOCKET: Choice<Box<dyn Profile>> = Choice {
    name: "socket",
    meaning: "a spherical hollow that a `ball` fits into; its layers are spherical too",
    parameters: &[RADIUS, RIM],
    build: |values| {
        let radius = values.require("radius")?;
        let socket = ClearanceFit::new(Round::Sphere, radius, true)?;
        Ok(Box::new(values.number("rim").map_or(Ok(socket), |rim| socket.with_rim(rim))?))
    },
};

pub(super) const SHAFT: Choice<Box<dyn Profile>> = Choice {
    name: "shaft",
    meaning: "a shaft in a `bush`; on other bodies write `cylinder`",
    parameters: &[RADIUS],
    build: |values| built(values, Round::Cylinder, false),
};

pub(super) const BUSH: Choice<Box<dyn Profile>> = Choice {
    name: "bush",
    meaning: "a cylindrical hollow that a `shaft` fits into; its layers are rings, its axis lies along y",
    parameters: &[RADIUS],
    build: |values| built(values, Round::Cylinder, true),
};

const RADIUS: Parameter = Parameter::required(
    "radius",
    Quantity::Length,
    "radius of the surface that touches, positive of a hollow too",
)
.bound(Bound::Positive);

const RIM: Parameter = Parameter::optional(
    "rim",
    Quantity::Angle,
    "angle from the load to the nearest place of the rim; 90 deg if not given, 45 deg of a half sphere that is tilted by 45 deg",
)
.bound(Bound::UpTo(0.0, FRAC_PI_2));

fn built(values: &Values, round: Round, hollow: bool) -> Result<Box<dyn Profile>, Invalid> {
    Ok(Box::new(ClearanceFit::new(round, values.require("radius")?, hollow)?))
}

impl ClearanceFit {
    /// A surface of that radius (m), hollow or not.
    ///
    /// # Errors
    /// If the radius is not greater than zero.
    pub fn new(round: Round, radius: f64, hollow: bool) -> Result<Self, Invalid> {
        Ok(Self { round, radius: RADIUS.admit(radius)?, hollow, rim: FRAC_PI_2 })
    }

    /// The same surface with a rim that comes as near to the pole as an angle (rad).
    ///
    /// # Errors
    /// If the angle is not greater than zero or is more than a right angle.
    pub fn with_rim(self, rim: f64) -> Result<Self, Invalid> {
        Ok(Self { rim: RIM.admit(rim)?, ..self })
    }
}

impl Profile for ClearanceFit {
    fn recess(&self, x: f64, y: f64) -> f64 {
        let depth = self.radius * (1.0 - self.round.cosine(self.radius, [x, y]));
        if self.hollow { -depth } else { depth }
    }

    /// Up to a right angle from the pole.
    fn extent(&self) -> [[f64; 2]; 2] {
        let about = |half: f64| [-half, half];
        match self.round {
            Round::Sphere => [about(SQRT_2 * self.radius); 2],
            Round::Cylinder => [about(FRAC_PI_2 * self.radius), [f64::NEG_INFINITY, f64::INFINITY]],
        }
    }

    fn fitted(&self) -> Option<ClearanceFit> {
        Some(*self)
    }
}
