//! Zeros and least values of functions of one number within an interval.

/// Where the function is zero between two places at which its signs differ: bisection, to the last digit that counts.
pub(crate) fn zero(from: f64, to: f64, value: impl Fn(f64) -> f64) -> f64 {
    zero_within(from, to, 1e-15, value)
}

/// The same, where two places so far from each other count as one.
pub(crate) fn zero_within(from: f64, to: f64, one: f64, value: impl Fn(f64) -> f64) -> f64 {
    let (mut a, mut b) = (from, to);
    let (mut fa, mut fb) = (value(a), value(b));
    let mut kept = 0;
    for _ in 0..100 {
        if fa == 0.0 || (b - a).abs() <= one {
            return a;
        }
        // False position halves the value at an end that stays (Illinois).
        let share = fa / (fa - fb);
        let middle = if share > 0.0 && share < 1.0 { a + share * (b - a) } else { 0.5 * (a + b) };
        let fm = value(middle);
        let near = (middle - a).abs().min((middle - b).abs()) <= one;
        if near || !fm.is_finite() || fm.abs() < 1e-15 {
            return middle;
        }
        if (fm > 0.0) == (fb > 0.0) {
            (b, fb) = (middle, fm);
            if kept == 1 {
                fa *= 0.5;
            }
            kept = 1;
        } else {
            (a, fa) = (middle, fm);
            if kept == -1 {
                fb *= 0.5;
            }
            kept = -1;
        }
    }
    0.5 * (a + b)
}

/// Where the function is least between two places, if it has one valley there: golden section.
pub(crate) fn least(from: f64, to: f64, value: impl Fn(f64) -> f64) -> f64 {
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let (mut a, mut b) = (from, to);
    let (mut c, mut d) = (b - golden * (b - a), a + golden * (b - a));
    let (mut fc, mut fd) = (value(c), value(d));
    for _ in 0..60 {
        if fc <= fd {
            (b, d, fd) = (d, c, fc);
            c = b - golden * (b - a);
            fc = value(c);
        } else {
            (a, c, fc) = (c, d, fd);
            d = a + golden * (b - a);
            fd = value(d);
        }
    }
    0.5 * (a + b)
}
