//! The derivative along a direction of values known at scattered points of a plane, from upstream.
//!
//! The convective derivative of steady rolling (the paper's eq. 35) on frames of any shape. At a
//! point i it is sum_j c_j (u_i - u_j) over neighbours j, exact for linear fields:
//! sum_j c_j (x_i - x_j) = d, the unit vector along the direction. Where every c_j is positive and
//! every j upstream, the operator is triangular in the order in which the points are passed, its
//! eigenvalues are positive and du/dt = -D u obeys a maximum principle. Its error is a diffusion of
//! tensor (1/2) sum_j c_j (x_i - x_j)(x_i - x_j)'. Of all consistent c the one of least
//! sum_j |c_j| |x_i - x_j|^2 is taken, with what is negative or from downstream counting several
//! times. This is a fit by weighted least absolute coefficients, a linear programme of two
//! conditions, so that two neighbours suffice: where nothing forbids it, the corners of the Delaunay
//! triangle through which the particle comes. On a uniform grid passed along an axis it is the upwind
//! difference, passed askew the sum of those along both axes. A fit by least *squares* is neither and
//! has coefficients of both signs.
//!
//! Where particles enter, nothing lies upstream. What is convected, a displacement, does not vanish
//! outside the frame: the derivative is then taken from downstream, and
//! [`Derivative::extrapolated`] says where.
//!
//! - M. Tabata, A finite element approximation corresponding to the upwind finite differencing,
//!   Mem. Numer. Math. 4 (1977) 47-63.
//! - B. Seibold, Minimal positive stencils in meshfree finite difference methods for the Poisson
//!   equation, Comput. Methods Appl. Mech. Engrg. 198 (2008) 592-601.

mod cloud;
mod stencil;
#[cfg(test)]
mod tests;

use cloud::Cloud;
use stencil::{Row, Shares};

/// The derivative along a direction on a fixed cloud of points.
#[derive(Debug, Clone)]
pub struct Derivative {
    /// A row of the sparse operator has two neighbours at most.
    rows: Vec<Row>,
    shares: Vec<Shares>,
    extrapolated: Vec<usize>,
}

/// Points that carry no derivative along the direction.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum DegenerateCloud {
    /// Fewer than three points.
    #[error("a derivative needs three points or more, found {points}")]
    TooFew {
        /// How many there are.
        points: usize,
    },
    /// A direction that is zero or not finite.
    #[error("({:e}, {:e}) is no direction", .direction[0], .direction[1])]
    NoDirection {
        /// The direction given.
        direction: [f64; 2],
    },
    /// A place that is not finite.
    #[error("the place of point {point} is not finite")]
    NotFinite {
        /// The point's index.
        point: usize,
    },
    /// Two points at one place.
    #[error("points {} and {} coincide: remove one of them", .points[0], .points[1])]
    Coincident {
        /// The points' indices, rising.
        points: [usize; 2],
    },
    /// All points on one line that does not run along the direction.
    #[error("the points lie on one line, and it does not run along the direction")]
    Collinear,
}

impl Derivative {
    /// The derivative along the direction in which particles pass the points, for values at `places`.
    ///
    /// The direction may have any length. The derivative has the values' unit over that of the
    /// places. Points on one line are accepted if it runs along the direction.
    ///
    /// # Errors
    /// If the points carry no such derivative.
    pub fn along(places: &[[f64; 2]], direction: [f64; 2]) -> Result<Self, DegenerateCloud> {
        let cloud = Cloud::new(places, direction)?;
        let (mut rows, mut shares) = (Vec::with_capacity(places.len()), vec![]);
        let mut extrapolated = vec![];
        for point in 0..places.len() {
            let stencil = cloud.stencil(point)?;
            rows.push(stencil.row);
            shares.push(stencil.shares);
            if stencil.extrapolates {
                extrapolated.push(point);
            }
        }
        Ok(Self { rows, shares, extrapolated })
    }

    /// The points, rising, whose derivative is not a positive combination of differences from
    /// upstream: those at which particles enter, and those on a ragged border along which they pass.
    pub fn extrapolated(&self) -> &[usize] {
        &self.extrapolated
    }

    /// Sets `out` to the derivative of `values`, both with one value a point.
    pub fn apply(&self, values: &[f64], out: &mut [f64]) {
        for ((out, row), value) in out.iter_mut().zip(&self.rows).zip(values) {
            *out = row.iter().map(|&(other, weight)| weight * (value - values[other])).sum();
        }
    }

    /// Sets `out` to the values where particles come from: the mean over the neighbours, each weighed by
    /// what it contributes to the derivative of the place along the direction.
    /// On a grid passed along an axis, the value of the point before.
    pub fn upstream(&self, values: &[f64], out: &mut [f64]) {
        for ((out, row), shares) in out.iter_mut().zip(&self.rows).zip(&self.shares) {
            *out = row.iter().zip(shares).map(|(&(other, _), share)| share * values[other]).sum();
        }
    }
}
