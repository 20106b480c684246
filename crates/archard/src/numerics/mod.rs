//! Numerical tools that know nothing of mechanics.

pub mod bordered;
pub mod convolution;
pub mod dense;
pub mod gmres;
pub mod interpolate;
pub mod large;
pub mod piecewise;
pub mod quadrature;
pub mod seal;
pub mod single;
pub(crate) mod triangle;
pub mod upwind;
pub mod vector;
