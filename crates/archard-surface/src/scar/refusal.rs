//! Why no scar is found on a profile.

/// Why no scar is found on a profile.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NoScar {
    /// Next to no readings.
    #[error(
        "{readings} readings cannot separate a scar from the surface next to it: at least {least} are needed"
    )]
    Few {
        /// How many there are.
        readings: usize,
        /// How many are needed.
        least: usize,
    },
    /// The readings ask for none.
    #[error(
        "no scar like the computed one is found on the profile: see that heights rise out of the material, that units are right, and that the shape \
         of the body was not taken off"
    )]
    Nothing,
    /// Texture is as large as the scar.
    #[error(
        "no scar stands out from the texture: the profile scatters by {:.3} um about the computed shape, which is {:.3} um deep; see that units \
         and the shape of the body are right",
        1e6 * .texture, 1e6 * .deepest
    )]
    Hidden {
        /// Standard deviation of the texture (m).
        texture: f64,
        /// Depth of the model (m).
        deepest: f64,
    },
    /// Too much of it was not measured.
    #[error(
        "{:.0} % of the scar was not measured, and 20 % may be missing: measure wider, and see that units and the shape of the body are right",
        100.0 * .share
    )]
    Unseen {
        /// The share of the section.
        share: f64,
    },
    /// Nothing to level by.
    #[error(
        "too little was measured beside the scar to level the profile by: {:.3} um on either side are needed, the correlation length of the \
         surface; measure wider, and see that units and the shape of the body are right",
        1e6 * .length
    )]
    Unlevelled {
        /// Correlation length of the surface (m).
        length: f64,
    },
    /// Of another test.
    #[error(
        "the scar has {grown:.2} times the section of the computed one, and .2 to 5 times are compared: see that units are right, or let the run \
         go as far as the test"
    )]
    OtherSize {
        /// Its section over that of the model.
        grown: f64,
    },
}
