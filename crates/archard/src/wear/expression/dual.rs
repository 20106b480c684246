//! Dual numbers: values that carry their derivative with respect to the pressure (R. E. Wengert, *Comm. ACM* 7 (1964) 463).
//!
//! Where a derivative jumps it is the one towards more pressure.

use crate::numerics::piecewise::Piecewise;

/// A value and its derivative with respect to the pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Dual {
    pub value: f64,
    pub slope: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Unary {
    Negative,
    Not,
    Exp,
    Ln,
    Sqrt,
    Abs,
    Sin,
    Cos,
    Tanh,
    /// To a constant power.
    Power(f64),
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Binary {
    Plus,
    Minus,
    Times,
    Over,
    Power,
    Min,
    Max,
    Less,
    LessOrEqual,
    And,
    Or,
}

/// An outer derivative times an inner one; what does not change stays as it is, however steep the function.
#[inline]
fn chain(outer: f64, inner: f64) -> f64 {
    if inner == 0.0 { 0.0 } else { outer * inner }
}

/// A part of the derivative of a product; where the other factor is zero none, however steep the one: p * p^0.3 is level at
/// p = 0.
#[inline]
fn part(slope: f64, other: f64) -> f64 {
    if other == 0.0 { 0.0 } else { slope * other }
}

/// The value of a table; at its points the slope on the side towards more pressure.
pub(super) fn looked_up(table: &Piecewise, a: Dual) -> Dual {
    let outer = if a.slope < 0.0 { table.slope_before(a.value) } else { table.slope(a.value) };
    Dual { value: table.at(a.value), slope: chain(outer, a.slope) }
}

#[inline]
pub(super) fn one(unary: Unary, a: Dual) -> Dual {
    let (value, outer) = match unary {
        Unary::Negative => (-a.value, -1.0),
        Unary::Not => (f64::from(a.value == 0.0), 0.0),
        Unary::Exp => {
            let value = a.value.exp();
            (value, value)
        }
        Unary::Ln => (a.value.ln(), 1.0 / a.value),
        Unary::Sqrt => {
            let value = a.value.sqrt();
            (value, 0.5 / value)
        }
        Unary::Abs => {
            let falls = a.value < 0.0 || a.value == 0.0 && a.slope < 0.0;
            (a.value.abs(), if falls { -1.0 } else { 1.0 })
        }
        Unary::Sin => (a.value.sin(), a.value.cos()),
        Unary::Cos => (a.value.cos(), -a.value.sin()),
        Unary::Tanh => {
            let value = a.value.tanh();
            (value, 1.0 - value * value)
        }
        Unary::Power(exponent) => {
            let value = raised(a.value, exponent);
            (value, raised_slope(a.value, exponent, value))
        }
    };
    Dual { value, slope: chain(outer, a.slope) }
}

/// A power; small whole exponents by products.
#[inline]
fn raised(base: f64, exponent: f64) -> f64 {
    match exponent {
        1.0 => base,
        2.0 => base * base,
        3.0 => base * base * base,
        0.5 => base.sqrt(),
        -1.0 => 1.0 / base,
        _ => base.powf(exponent),
    }
}

/// The derivative of a power with respect to its base.
#[inline]
fn raised_slope(base: f64, exponent: f64, value: f64) -> f64 {
    match (base, exponent) {
        (_, 0.0) => 0.0,
        (0.0, _) => exponent * raised(base, exponent - 1.0),
        _ => exponent * value / base,
    }
}

#[inline]
pub(super) fn two(binary: Binary, a: Dual, b: Dual) -> Dual {
    let truth = |truth: bool| Dual { value: f64::from(truth), slope: 0.0 };
    match binary {
        Binary::Plus => Dual { value: a.value + b.value, slope: a.slope + b.slope },
        Binary::Minus => Dual { value: a.value - b.value, slope: a.slope - b.slope },
        Binary::Times => {
            let slope = part(a.slope, b.value) + part(b.slope, a.value);
            Dual { value: a.value * b.value, slope }
        }
        Binary::Over => {
            let value = a.value / b.value;
            Dual { value, slope: (a.slope - value * b.slope) / b.value }
        }
        Binary::Power => {
            let value = a.value.powf(b.value);
            let by_base = chain(raised_slope(a.value, b.value, value), a.slope);
            Dual { value, slope: by_base + chain(value * a.value.ln(), b.slope) }
        }
        Binary::Min => if_else(a.value < b.value || a.value.is_nan(), a, b, f64::min),
        Binary::Max => if_else(a.value > b.value || a.value.is_nan(), a, b, f64::max),
        Binary::Less => truth(a.value < b.value),
        Binary::LessOrEqual => truth(a.value <= b.value),
        Binary::And => truth(a.value != 0.0 && b.value != 0.0),
        Binary::Or => truth(a.value != 0.0 || b.value != 0.0),
    }
}

/// The one or the other; where both are the same, the slope that is further on that side.
#[inline]
fn if_else(one: bool, a: Dual, b: Dual, further: fn(f64, f64) -> f64) -> Dual {
    let chosen = if one { a } else { b };
    let slope = if a.value == b.value { further(a.slope, b.slope) } else { chosen.slope };
    Dual { slope, ..chosen }
}
