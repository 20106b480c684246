//! Why there is no contact to tell of.

use archard::parameters::Invalid;

/// What keeps a wheel from being set on its rail.
#[non_exhaustive]
#[derive(Debug, thiserror::Error)]
pub enum ContactError {
    /// A value that cannot be used.
    #[error(transparent)]
    Invalid(#[from] Invalid),
    /// The wheel is nowhere over the rail.
    #[error(
        "the wheel does not stand over the rail: change `shift`, `gauge` or the distance of the wheels"
    )]
    NoContact,
    /// A contact comes to the end of a profile.
    #[error(
        "the contact at y = {:.3} mm of the track comes to where the wheel or the rail ends, or turns away from the tangent plane: give longer profiles, a smaller shift or a smaller load; where a worn flange conforms to its rail, a plane contact does not hold it", .y * 1e3
    )]
    Short {
        /// y (m) of the reference point in the track.
        y: f64,
    },
    /// No height of the wheel makes its contacts bear the load.
    #[error(
        "no height of the wheel makes its contacts bear {load:.6e} N: they bore {found:.6e} N at the last one; change the load or the friction"
    )]
    Unbearable {
        /// What is to be borne (N), upwards.
        load: f64,
        /// What was borne (N).
        found: f64,
    },
    /// Patches that press each other apart do not agree on their forces.
    #[error(
        "patches that press each other apart do not agree on their forces: give a larger `join`"
    )]
    Unsettled,
    /// Friction does not bear the moment that drives or brakes the wheelset.
    #[error(
        "friction does not bear an axle moment of {moment:.6e} N m: {most:.6e} N m is all, where every contact slips"
    )]
    Saturated {
        /// The moment (N m) asked for.
        moment: f64,
        /// What is borne at most.
        most: f64,
    },
    /// No roll makes both wheels carry their load at one height.
    #[error("no `roll` makes both wheels carry their load at one height: give it")]
    NoRoll,
    /// The parts of a contact do not fit together.
    #[error(transparent)]
    Refused(#[from] archard::simulation::Refusals),
    /// A contact could not be solved.
    #[error(transparent)]
    Unsolved(#[from] archard::simulation::Error),
}
