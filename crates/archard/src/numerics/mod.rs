//! Numerical tools that know nothing of mechanics.

pub mod bordered;
pub mod control;
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

/// Computed numbers that differ by less, relative to their scale, are the same: half of the digits of a double, the square root of
/// `f64::EPSILON`. Rounding takes fewer.
pub const SAME: f64 = 1.0 / (1 << 26) as f64;

/// Numbers from files that differ by less, relative to their scale, are the same: files carry seven digits, as single precision
/// does, and the last one is rounded.
pub const WRITTEN: f64 = 1e-6;

/// The number of elements from some number on that is even or odd as another is; beyond what can be counted there are as many as
/// there can be.
pub fn counted(elements: f64, as_another: usize) -> usize {
    let odd = as_another % 2;
    ((0.5 * (elements - odd as f64)).ceil() as usize).saturating_mul(2).saturating_add(odd)
}
