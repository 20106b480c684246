//! Why two maps tell no worn volume.

/// Why two maps tell no worn volume.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NoDifference {
    /// The maps hardly overlap.
    #[error(
        "the maps have {points} points in common where they fit best, and {least} are needed: measure the same place twice, with fewer points \
         missing, and see that the pixels of both are right"
    )]
    NoOverlap {
        /// Points of the later map with a height in both.
        points: usize,
        /// How many are needed.
        least: usize,
    },
    /// The one is not found in the other.
    #[error(
        "the surface of the one map is not found again in the other: where they fit best, their difference keeps {:.0} % of the texture, and maps of one place \
         keep {:.0} % at most; give two maps of the same place, or say that they lie as they were measured",
        100.0 * .kept, 100.0 * .most
    )]
    Different {
        /// Variance of what did not wear, without noise, over that of both textures.
        kept: f64,
        /// Its most.
        most: f64,
    },
    /// The turn is the largest that was sought, and fits no place.
    #[error(
        "the surface of the one map is not found again in the other by turns of up to {:.3} degrees, and fits best at the largest: let larger turns be \
         sought, or give two maps of the same place",
        .turn.to_degrees()
    )]
    Turned {
        /// The largest turn (rad).
        turn: f64,
    },
    /// Nothing is left to align by.
    #[error(
        "{:.0} % of the overlap differs: what did not wear is not known; give two maps of the same place, measure wider, or give the part in \
         which wear is to be found",
        100.0 * .share
    )]
    AllWorn {
        /// Share of the overlap that changed.
        share: f64,
    },
    /// Nothing stands out.
    #[error(
        "nothing is worn that stands out: a depth of {:.3} nm over {:.3} um would; give the part in which wear is to be found, and \
         what is missing there is integrated all the same",
        1e9 * .depth, 1e6 * .width
    )]
    NothingWorn {
        /// The mean depth (m) that would stand out.
        depth: f64,
        /// Over a spot of that width (m).
        width: f64,
    },
    /// No part of the surface stayed as it was.
    #[error(
        "the scans differ by {:.3} um over lengths of the map: no part of it stayed as it was, or the instrument bends it; measure \
         wider, or give the part in which wear is to be found", 1e6 * .scatter
    )]
    NoReference {
        /// Standard deviation (m) of what did not stand out.
        scatter: f64,
    },
    /// The part that was given does not exist.
    #[error(
        "the part in which wear is to be found has {inside} points of the overlap inside and {outside} outside, and {least} of each are needed"
    )]
    Part {
        /// Points inside.
        inside: usize,
        /// Points outside.
        outside: usize,
        /// How many are needed.
        least: usize,
    },
}
