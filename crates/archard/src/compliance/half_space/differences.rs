//! From functions of the corners of elements to influence coefficients.

/// Differences over the corners of elements of a function that is even (1) or odd (-1) along x and along y, from its values at the
/// corners with x and y above zero, `[i + elements_x j]`: coefficients at offsets zero and greater.
pub(super) fn differences(
    mut values: Vec<f64>,
    [nx, ny]: [usize; 2],
    parity: [f64; 2],
) -> Vec<f64> {
    // Backwards, so that the corners still to be read are those not yet overwritten.
    for j in (0..ny).rev() {
        for i in (0..nx).rev() {
            let here = values[i + nx * j];
            let low = if j > 0 { values[i + nx * (j - 1)] } else { parity[1] * here };
            let left = if i > 0 { values[i - 1 + nx * j] } else { parity[0] * here };
            let left_low = match (i, j) {
                (0, _) => parity[0] * low,
                (_, 0) => parity[1] * left,
                _ => values[i - 1 + nx * (j - 1)],
            };
            values[i + nx * j] = (here - left) - (low - left_low);
        }
    }
    values
}
