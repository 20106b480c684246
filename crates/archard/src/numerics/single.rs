//! Substitution in single precision, for a vector at a time: several columns of the factors at once, and each
//! is read once.

use super::vector::LANES;
use faer::MatRef;
use pulp::{Arch, Simd, WithSimd};

/// Numbers of double precision in a vector of the processor.
pub fn lanes() -> usize {
    struct Lanes;
    impl WithSimd for Lanes {
        type Output = usize;

        fn with_simd<S: Simd>(self, _: S) -> usize {
            S::F64_LANES
        }
    }
    Arch::new().dispatch(Lanes)
}

/// Replaces an image by the vector that a matrix makes it of. The factors of the matrix stand in one place: a lower
/// triangle with ones on its diagonal, left out, and an upper one.
pub(super) fn substitute(factors: MatRef<'_, f32>, image: &mut [f32]) {
    let arch = Arch::new();
    let size = image.len();
    for start in (0..size).step_by(LANES) {
        let end = (start + LANES).min(size);
        for column in start..end {
            let values = &column_of(factors, column)[column + 1..end];
            let (head, tail) = image.split_at_mut(column + 1);
            take_off(tail, values, head[column]);
        }
        let (known, rest) = image.split_at_mut(end);
        take_off_all(arch, factors, start, end, &known[start..], rest);
    }
    for start in (0..size).step_by(LANES).rev() {
        let end = (start + LANES).min(size);
        for column in (start..end).rev() {
            let values = column_of(factors, column);
            image[column] /= values[column];
            let (head, tail) = image.split_at_mut(column);
            take_off(&mut head[start..], &values[start..column], tail[0]);
        }
        let (rest, known) = image.split_at_mut(start);
        take_off_all(arch, factors, start, 0, &known[..end - start], rest);
    }
}

/// The values of a column, none where they are not in a row.
fn column_of(matrix: MatRef<'_, f32>, index: usize) -> &[f32] {
    matrix.col(index).try_as_col_major().map(|column| column.as_slice()).unwrap_or_default()
}

fn take_off(image: &mut [f32], column: &[f32], factor: f32) {
    image.iter_mut().zip(column).for_each(|(image, value)| *image -= factor * value);
}

/// Takes the columns from `start` on, times what is known of their unknowns, off the rows from `row` on.
fn take_off_all(
    arch: Arch,
    factors: MatRef<'_, f32>,
    start: usize,
    row: usize,
    known: &[f32],
    rest: &mut [f32],
) {
    let length = rest.len();
    let column = |index: usize| &column_of(factors, start + index)[row..row + length];
    match <[f32; LANES]>::try_from(known) {
        Ok(known) => {
            let columns = std::array::from_fn(column);
            arch.dispatch(Columns { columns, known, rest });
        }
        Err(_) => {
            known
                .iter()
                .enumerate()
                .for_each(|(index, known)| take_off(rest, column(index), *known));
        }
    }
}

/// Takes multiples of columns off.
struct Columns<'a> {
    columns: [&'a [f32]; LANES],
    known: [f32; LANES],
    rest: &'a mut [f32],
}

impl WithSimd for Columns<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { columns, known, rest } = self;
        let factors = known.map(|known| simd.splat_f32s(-known));
        let (head, tail) = S::as_mut_simd_f32s(rest);
        let split = columns[0].len() - tail.len();
        let heads = columns.map(|column| &S::as_simd_f32s(column).0[..head.len()]);
        for (index, rest) in head.iter_mut().enumerate() {
            let mut sum = *rest;
            for (factor, column) in factors.iter().zip(&heads) {
                sum = simd.mul_add_e_f32s(*factor, column[index], sum);
            }
            *rest = sum;
        }
        for (known, column) in known.iter().zip(&columns) {
            take_off(tail, &column[split..], *known);
        }
    }
}
