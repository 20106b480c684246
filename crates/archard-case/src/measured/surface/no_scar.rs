//! Why no scar is found on a surface.

/// Why no scar is found.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NoScar {
    /// Nothing to be seen.
    #[error(
        "no scar stands out from the shape of the body and a plane: see that enough was measured beside the scar, half as wide \
         again as it, that heights rise out of the material, that the units are right, and that the shape of the body was not \
         taken off"
    )]
    Nothing,
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
    /// Nothing to level by.
    #[error(
        "the scar reaches the end of what was measured along {axis}, or nearly: nothing lies beside it to level by; measure \
         half as wide again as the scar"
    )]
    Fills {
        /// The axis.
        axis: &'static str,
    },
    /// Too many places without a reading.
    #[error(
        "{:.0} % of the scar have no reading, or one far off those around it: measure them, or interpolate them yourself",
        100.0 * .share
    )]
    Gaps {
        /// Their share.
        share: f64,
    },
    /// Readings far apart.
    #[error(
        "readings are {:.3} um apart along {axis} and the scar is {:.3} um wide: measure at least eight across it",
        1e6 * .step, 1e6 * .width
    )]
    Coarse {
        /// The axis.
        axis: &'static str,
        /// Distance of readings (m).
        step: f64,
        /// From the first worn reading to the last (m).
        width: f64,
    },
    /// What is worn off is not told.
    #[error(
        "what is worn off is uncertain by {:.0} %: the scar is {:.3} um deep, and the surface beside it off its shape by \
         {:.3} um; see that units and shape of the body are right, or measure more and wider",
        100.0 * .share, 1e6 * .deepest, 1e6 * .scatter
    )]
    Uncertain {
        /// The standard uncertainty, relative.
        share: f64,
        /// Depth of the scar (m).
        deepest: f64,
        /// Scatter next to it (m).
        scatter: f64,
    },
}
