//! The contact of a wheel with its rail: the height of the wheel under its load, and pressures and friction of each patch.
//!
//! A patch lies in its own tangent plane. Both bodies are half-spaces there (Kalker's three-dimensional theory of steady
//! rolling), on a grid over the overlap, with the creepages and the spin at its reference point. Where the profiles curve away from the
//! plane the rolling radius is another one, and the wheel slips by the difference (Heathcote). The height of the wheel
//! follows from the vertical force, to which friction in an inclined plane adds its part. Stretches of overlap that are near
//! each other share a plane and its grid; patches with planes of their own press each other apart.
//!
//! All of it is solved on three grids, each of elements half the size of those before. Errors of rolling contact are of
//! first order or higher in the size, so that a halving changes a value by what is left after it, or by more. The error that is
//! told is the last change, or half the one before where that is larger, and the share of the load that is not met. A patch that a coarser
//! grid misses bears nothing there: all of it is its change, or what it bears more with the wheel lower by the error of its height,
//! where that is larger. It holds for the grid, not for the
//! profiles, nor for the plane: [`Patch::angle_spread`] says how far a patch bends. The onset depends on no grid.

mod apart;
mod counterpart;
mod error;
mod height;
mod lattice;
mod loaded;
mod pitch;
mod pressed;
mod quantities;
mod roll;
mod sampled;

pub use error::ContactError;
pub(crate) use loaded::Loaded;
pub use pitch::pitch;
pub use pressed::PatchMap;
pub(crate) use pressed::Pressed;
pub use quantities::Quantities;
pub use roll::roll;
pub use sampled::{GROUPS, sampled};

use std::f64::consts::PI;
use std::sync::Arc;

use glam::{DMat3, DVec3};

use archard::Material;
use archard::body::Thermal;
use archard::friction::Friction;
use archard::wear::{Input, WearLaw};

use crate::search::JOIN;
use crate::setup::{Attitude, Setup, Side, Velocity};
use archard::parameters::Invalid;

/// Bending of a patch (rad) from which on a plane is an approximation: 10 degrees.
pub const BENT: f64 = PI / 18.0;

/// What wheel and rail are made of, and what friction they bear.
#[derive(Debug, Clone)]
pub struct Bodies {
    /// Of the wheel.
    pub wheel: Material,
    /// Of the rail.
    pub rail: Material,
    /// How the wheel and the rail conduct heat, and how warm they are; `None` where nobody asks for their temperature.
    pub thermal: [Option<Thermal>; 2],
    /// Between both.
    pub friction: Arc<dyn Friction>,
    /// Between both on the flange, where it differs, as where that is lubricated.
    pub flange: Option<Zone>,
    /// How the wheel and the rail wear.
    pub wear: Wear,
    /// How both wear where the flange of the wheel touches, where that differs.
    pub flange_wear: Option<FlangeWear>,
    /// Yield stress in shear (Pa) of the softer of both.
    pub shear_yield: f64,
}

/// A zone of the wheel with a friction of its own.
#[derive(Debug, Clone)]
pub struct Zone {
    /// y (m) on the profile of the wheel where it begins: it reaches from there to the tip of the flange.
    pub from: f64,
    /// Its friction.
    pub friction: Arc<dyn Friction>,
}

/// The wear of a zone of the wheel, and of what it touches.
#[derive(Debug, Clone)]
pub struct FlangeWear {
    /// y (m) on the profile of the wheel where it begins: it reaches from there to the tip of the flange.
    pub from: f64,
    /// Its wear laws; `None` of a body that wears there by its own law.
    pub wear: Wear,
}

impl Bodies {
    /// The friction of a patch whose reference point lies at that y (m) on the profile of the wheel.
    pub fn friction_at(&self, y: f64) -> &Arc<dyn Friction> {
        match &self.flange {
            Some(zone) if y <= zone.from => &zone.friction,
            _ => &self.friction,
        }
    }
}

impl Bodies {
    /// The wear laws on the flange: its own, and where it has none those of the bodies.
    pub fn wear_on_the_flange(&self) -> Option<(f64, Wear)> {
        let FlangeWear { from, wear } = self.flange_wear.as_ref()?;
        Some((*from, [0, 1].map(|body| wear[body].clone().or_else(|| self.wear[body].clone()))))
    }

    /// Whether a wear law asks for something.
    pub fn asks_for(&self, input: Input) -> bool {
        let on_the_flange = self.flange_wear.iter().flat_map(|flange| &flange.wear);
        self.wear.iter().chain(on_the_flange).flatten().any(|law| law.inputs().contains(&input))
    }
}

/// The wear laws of the wheel and of the rail; `None` of one that does not wear.
pub type Wear = [Option<Arc<dyn WearLaw>>; 2];

/// How the wheelset stands and moves, and what a wheel carries; as its side sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Operation {
    /// Where it stands.
    pub attitude: Attitude,
    /// How it moves.
    pub velocity: Velocity,
    /// Vertical force (N) on the rail, greater than zero.
    pub load: f64,
    /// How much more (N) the right wheel bears than `load`, and the left one less: what [`of_side`](Self::of_side) makes of it counts.
    pub transfer: f64,
    /// Creepage, lateral creepage and spin (1/m) of the own wheel and of the other one, each as its side sees it, in all patches; found
    /// from the velocities where they are not given.
    pub creepages: [[Option<f64>; 3]; 2],
}

impl Operation {
    /// The operation of the right side as a side sees it.
    #[must_use]
    pub fn of_side(&self, side: Side) -> Self {
        let (attitude, velocity) = (side.attitude(self.attitude), side.velocity(self.velocity));
        let [own, other] = self.creepages;
        let (share, creepages) = match side {
            Side::Right => (self.transfer, [own, other]),
            Side::Left => (-self.transfer, [other, own]),
        };
        Self { attitude, velocity, load: self.load + share, transfer: 0.0, creepages }
    }
}

/// How finely patches are divided, and which stretches of overlap share a grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resolution {
    /// Elements along x and as many along s over the overlap of each patch; the contact fills about half of them. A
    /// multiple of 4 from 16 on.
    pub elements: usize,
    /// Distance (m) from edge to edge up to which two stretches of overlap are one patch.
    pub join: f64,
    /// Whether the rolling radius differs over a patch as it does on the profiles; without, it is that of the tangent plane.
    pub curved: bool,
}

impl Resolution {
    /// The same, checked.
    ///
    /// # Errors
    /// If the number of elements is not a multiple of 4 from 16 to 1024.
    pub fn checked(self) -> Result<Self, Invalid> {
        let Self { elements, .. } = self;
        if (16..=1024).contains(&elements) && elements.is_multiple_of(4) {
            return Ok(self);
        }
        let message = format!("{elements} has to be a multiple of 4 from 16 to 1024");
        Err(Invalid::new("elements", message))
    }
}

impl Default for Resolution {
    fn default() -> Self {
        Self { elements: 32, join: JOIN, curved: true }
    }
}

/// A patch of contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Patch {
    /// What is known of it.
    pub values: Quantities,
    /// The error of each value, positive: all of the value where coarser grids miss the patch, without a bound of its surface fatigue.
    pub errors: Quantities,
    /// How much the inclination of the rail (rad) differs within the contact: beyond [`BENT`] its plane is an
    /// approximation.
    pub angle_spread: f64,
    /// Pressures, tractions and slip.
    pub map: PatchMap,
    /// How friction warms it; `None` where wheel and rail do not say how they conduct heat.
    pub warmth: Option<Warmth>,
    /// The turn (rad) about the axis of a roller, before that by the contact angle; 0 of a straight rail.
    pub turn: f64,
}

/// How friction warms the surfaces of a patch (M. Ertz and K. Knothe, *Wear* 253 (2002) 498).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Warmth {
    /// The largest rise (K) above the temperature of the bodies, and its error.
    pub rise: [f64; 2],
    /// Peclet number of its longest row: below 5 rises are too high.
    pub peclet: f64,
}

impl Patch {
    /// The force (N) on the rail: forward, to the field side and downwards in the track.
    pub fn force(&self) -> [f64; 3] {
        let Quantities { force_x, force_s, normal_force, contact_angle, .. } = self.values;
        let frame = DMat3::from_rotation_y(self.turn) * DMat3::from_rotation_x(contact_angle);
        (frame * DVec3::new(force_x, force_s, normal_force)).to_array()
    }
}

/// The patches of contact of a wheel under its load, from the field side to the flange.
///
/// # Errors
/// If a value cannot be used, the wheel does not stand over the rail, a contact comes to the end of a profile, no height
/// of the wheel makes its contacts bear the load, or a contact cannot be solved.
pub fn contact(
    setup: &Setup,
    bodies: &Bodies,
    operation: &Operation,
    resolution: &Resolution,
) -> Result<Vec<Patch>, ContactError> {
    let elements = resolution.checked()?.elements;
    let loaded = Loaded::new(setup, bodies, operation, resolution)?;
    let mut guess = loaded.guess();
    let mut grids = vec![];
    for elements in [elements / 4, elements / 2, elements] {
        let (down, pressed) = loaded.on(elements, guess)?;
        guess = down;
        grids.push((pressed, loaded.height(down)));
    }
    let finest = || grids[2].0.iter().filter(|pressed| pressed.normal > 0.0);
    let bears = |grid: &[Pressed], pressed: &Pressed| {
        counterpart::on(grid, pressed).is_some_and(|one| one.normal > 0.0)
    };
    let missed = |pressed: &Pressed| grids[..2].iter().any(|(patches, _)| !bears(patches, pressed));
    // What a patch that coarser grids miss may bear more, with the wheel lower by the error of its height, the others bear less.
    let lower = match finest().any(missed) {
        true => {
            loaded.at(elements, grids[2].1 + last_change([0, 1, 2].map(|grid| grids[grid].1)))?
        }
        false => vec![],
    };
    let more = |pressed: &Pressed| {
        let lower = counterpart::on(&lower, pressed).filter(|_| missed(pressed))?;
        Some(loaded.tell(lower).with(&loaded.tell(pressed), |lower, own| (lower - own).abs()))
    };
    let moved: f64 = finest().filter_map(more).map(|more| more.normal_force).sum();
    let off = loaded.off(&grids[2].0) + moved / operation.load;
    let patches = finest().map(|pressed| {
        let values = loaded.tell(pressed);
        let on = |grid: usize| {
            let (patches, height) = &grids[grid];
            loaded.tell(&loaded.counterpart(pressed, patches, *height))
        };
        let [coarse, middle] = [on(0), on(1)];
        let change = |fine: &Quantities, coarse: &Quantities| {
            // The index of a patch that bears nothing is no number: it falls without a bound as the pressure goes.
            fine.with(coarse, |fine, coarse| match (fine - coarse).abs() {
                change if change.is_nan() => f64::INFINITY,
                change => change,
            })
        };
        let errors = change(&values, &middle)
            .with(&change(&middle, &coarse), |last, before| last.max(0.5 * before));
        let errors = more(pressed).map_or(errors, |more| errors.with(&more, f64::max));
        let errors = errors.with(&values, |error, value| error + off * value.abs());
        let warmth = pressed.flash.map(|[rise, peclet]| {
            let on = |grid: usize| {
                let (patches, height) = &grids[grid];
                let [rise, _] =
                    loaded.counterpart(pressed, patches, *height).flash.unwrap_or_default();
                rise
            };
            Warmth { rise: [rise, last_change([on(0), on(1), rise])], peclet }
        });
        Patch {
            warmth,
            values,
            errors,
            angle_spread: pressed.angle_spread,
            map: pressed.map.clone(),
            turn: pressed.patch.turn,
        }
    });
    Ok(patches.collect())
}

/// The error of a value on three grids: its last change, or half the one before where that is larger.
fn last_change([coarse, middle, fine]: [f64; 3]) -> f64 {
    (fine - middle).abs().max(0.5 * (middle - coarse).abs())
}
