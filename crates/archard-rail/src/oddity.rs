//! What looks wrong about the points of a profile.

/// Points nearer than this (m) are one point twice.
pub const DOUBLED: f64 = 1e-9;
