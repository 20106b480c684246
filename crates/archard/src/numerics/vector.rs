//! Sums and updates of long vectors, in parallel with results that do not depend on the number of
//! threads: partial sums of fixed blocks and lanes, added in order.

use std::array::from_fn;

use rayon::prelude::*;

/// Elements of a block, handled by one thread.
const BLOCK: usize = 16_384;
/// Elements of a block handled side by side.
const LANES: usize = 8;

/// A vector that may be one value throughout, which then is not stored.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Values<'a> {
    /// The same value everywhere.
    All(f64),
    /// One value an element.
    Each(&'a [f64]),
}

impl<'a> Values<'a> {
    /// The value of an element.
    pub fn at(self, index: usize) -> f64 {
        match self {
            Self::All(value) => value,
            Self::Each(values) => values[index],
        }
    }

    /// Some elements from one on.
    fn part(self, start: usize, length: usize) -> Self {
        match self {
            Self::All(_) => self,
            Self::Each(values) => {
                Self::Each(&values[start.min(values.len())..(start + length).min(values.len())])
            }
        }
    }

    /// A group of lanes.
    #[inline]
    fn lanes(self, group: usize) -> [f64; LANES] {
        match self {
            Self::All(value) => [value; LANES],
            Self::Each(values) => values.as_chunks().0[group],
        }
    }
}

/// Sums over all elements of what `term` makes of the vectors' values.
pub fn sum<const R: usize, const N: usize>(
    vectors: [&[f64]; R],
    term: impl Fn([f64; R]) -> [f64; N] + Sync,
) -> [f64; N] {
    sweep([], vectors, |[], values| ([], term(values)))
}

/// Sums over all elements of what `term` makes of the vectors' values and those beside them.
pub fn sum_with<const W: usize, const R: usize, const N: usize>(
    beside: [Values<'_>; W],
    vectors: [&[f64]; R],
    term: impl Fn([f64; W], [f64; R]) -> [f64; N] + Sync,
) -> [f64; N] {
    sweep_with(beside, [], vectors, |beside, [], values| ([], term(beside, values)))
}

/// A vector of what `value` makes of the values of others of one length.
pub fn map<const R: usize>(
    vectors: [&[f64]; R],
    value: impl Fn([f64; R]) -> f64 + Sync,
) -> Vec<f64> {
    let mut result = vec![0.0; vectors.first().map_or(0, |vector| vector.len())];
    update(&mut result, vectors, |_, values| value(values));
    result
}

/// Sets every element of a vector to what `change` makes of it and of the other vectors' values.
pub fn update<const R: usize>(
    vector: &mut [f64],
    others: [&[f64]; R],
    change: impl Fn(f64, [f64; R]) -> f64 + Sync,
) {
    let [] = sweep([vector], others, |[value], values| ([change(value, values)], []));
}

/// Sets the elements of some vectors to what `change` makes of them and of the other vectors' values,
/// and returns the sums of what it returns beside them. All vectors have the same length.
pub fn sweep<const M: usize, const R: usize, const N: usize>(
    vectors: [&mut [f64]; M],
    others: [&[f64]; R],
    change: impl Fn([f64; M], [f64; R]) -> ([f64; M], [f64; N]) + Sync,
) -> [f64; N] {
    sweep_with([], vectors, others, |[], values, others| change(values, others))
}

/// The same with values beside the vectors.
pub fn sweep_with<const W: usize, const M: usize, const R: usize, const N: usize>(
    beside: [Values<'_>; W],
    vectors: [&mut [f64]; M],
    others: [&[f64]; R],
    change: impl Fn([f64; W], [f64; M], [f64; R]) -> ([f64; M], [f64; N]) + Sync,
) -> [f64; N] {
    let length =
        vectors.iter().map(|v| v.len()).chain(others.iter().map(|v| v.len())).next().unwrap_or(0);
    if length <= BLOCK {
        return Block { beside, vectors, others }.sweep(&change);
    }
    let mut parts = vectors.map(|vector| vector.chunks_mut(BLOCK));
    let mut other_parts = others.map(|vector| vector.chunks(BLOCK));
    let blocks: Vec<Block<'_, W, M, R>> = (0..length.div_ceil(BLOCK))
        .map(|block| Block {
            beside: beside.map(|values| values.part(block * BLOCK, BLOCK)),
            vectors: parts.each_mut().map(|parts| parts.next().unwrap_or_default()),
            others: other_parts.each_mut().map(|parts| parts.next().unwrap_or_default()),
        })
        .collect();
    let partial: Vec<[f64; N]> = blocks.into_par_iter().map(|block| block.sweep(&change)).collect();
    partial.into_iter().fold([0.0; N], |mut total, part| {
        add(&mut total, part);
        total
    })
}

/// Does some work on a thread of the pool, so that its many short parallel passes start without waking
/// the pool each time.
pub fn in_pool<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    rayon::scope(|_| work())
}

/// The same stretch of several vectors.
struct Block<'a, const W: usize, const M: usize, const R: usize> {
    beside: [Values<'a>; W],
    vectors: [&'a mut [f64]; M],
    others: [&'a [f64]; R],
}

impl<const W: usize, const M: usize, const R: usize> Block<'_, W, M, R> {
    /// Whole groups of lanes, then the rest.
    fn sweep<const N: usize>(
        self,
        change: &impl Fn([f64; W], [f64; M], [f64; R]) -> ([f64; M], [f64; N]),
    ) -> [f64; N] {
        let mut lanes = [[0.0; LANES]; N];
        let mut written = self.vectors.map(|vector| vector.as_chunks_mut::<LANES>());
        let read = self.others.map(|vector| vector.as_chunks::<LANES>());
        let groups = written
            .iter()
            .map(|w| w.0.len())
            .chain(read.iter().map(|r| r.0.len()))
            .min()
            .unwrap_or(0);
        for group in 0..groups {
            // Copies on the stack: the compiler sees that nothing overlaps and takes lanes together.
            let before: [[f64; LANES]; M] = from_fn(|v| written[v].0[group]);
            let others: [[f64; LANES]; R] = from_fn(|v| read[v].0[group]);
            let beside = self.beside.map(|values| values.lanes(group));
            let (mut after, mut terms) = ([[0.0; LANES]; M], [[0.0; LANES]; N]);
            for lane in 0..LANES {
                let (values, sums) = change(
                    from_fn(|v| beside[v][lane]),
                    from_fn(|v| before[v][lane]),
                    from_fn(|v| others[v][lane]),
                );
                (0..M).for_each(|v| after[v][lane] = values[v]);
                (0..N).for_each(|n| terms[n][lane] = sums[n]);
            }
            (0..M).for_each(|v| written[v].0[group] = after[v]);
            (0..N).for_each(|n| (0..LANES).for_each(|lane| lanes[n][lane] += terms[n][lane]));
        }
        let mut total = lanes.map(|lanes| lanes.iter().sum());
        let rest = written
            .iter()
            .map(|w| w.1.len())
            .chain(read.iter().map(|r| r.1.len()))
            .min()
            .unwrap_or(0);
        for i in 0..rest {
            let values = written.each_ref().map(|vector| vector.1[i]);
            let beside = self.beside.map(|beside| beside.at(groups * LANES + i));
            let (values, terms) = change(beside, values, read.map(|vector| vector.1[i]));
            written.iter_mut().zip(values).for_each(|(vector, value)| vector.1[i] = value);
            add(&mut total, terms);
        }
        total
    }
}

fn add<const N: usize>(total: &mut [f64; N], terms: [f64; N]) {
    total.iter_mut().zip(terms).for_each(|(total, term)| *total += term);
}

#[cfg(test)]
mod tests {
    use super::{BLOCK, Values, sum, sum_with, sweep, update};

    #[test]
    fn sums_and_sweeps_cover_every_element_once() {
        for length in [0, 1, 13, BLOCK, 2 * BLOCK + 3] {
            let places: Vec<f64> = (0..length).map(|i| i as f64).collect();
            let mut values = vec![1.0; length];
            let [count] =
                sweep([&mut values], [&places], |[value], [place]| ([value + place], [1.0]));
            assert_eq!(count, length as f64);
            update(&mut values, [], |value, []| 2.0 * value);
            let [total, of_places] = sum([&values, &places], |values| values);
            assert_eq!(total, (length * (length + 1)) as f64);
            assert_eq!(of_places, 0.5 * total - count);
            let beside = [Values::All(2.0), Values::Each(&places)];
            let [twice] =
                sum_with(beside, [&values], |[two, place], [value]| [value - two * place]);
            assert_eq!(twice, 2.0 * count);
        }
    }
}
