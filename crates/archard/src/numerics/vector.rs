//! Sums and updates of long vectors, in parallel with results that do not depend on the number of
//! threads: partial sums of fixed blocks and lanes, added in order.

use std::sync::{Mutex, PoisonError};

use rayon::prelude::*;

/// Elements of a block, handled by one thread: 128 KiB. A choice of cost.
const BLOCK: usize = 16_384;
/// Elements handled side by side: doubles of a line of the cache, and of the widest vectors of processors.
pub(crate) const LANES: usize = 8;
/// Elements handled side by side.
type Group = [f64; LANES];

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
    fn lanes(self, group: usize) -> Group {
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

/// Sums over all elements of what `term` makes of the vectors' values and those next to them.
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
/// and returns the sums of what it returns next to them. All vectors have the same length.
pub fn sweep<const M: usize, const R: usize, const N: usize>(
    vectors: [&mut [f64]; M],
    others: [&[f64]; R],
    change: impl Fn([f64; M], [f64; R]) -> ([f64; M], [f64; N]) + Sync,
) -> [f64; N] {
    sweep_with([], vectors, others, |[], values, others| change(values, others))
}

/// The same with values next to the vectors.
pub fn sweep_with<const W: usize, const M: usize, const R: usize, const N: usize>(
    beside: [Values<'_>; W],
    vectors: [&mut [f64]; M],
    others: [&[f64]; R],
    change: impl Fn([f64; W], [f64; M], [f64; R]) -> ([f64; M], [f64; N]) + Sync,
) -> [f64; N] {
    let mut block = Block { beside, vectors, others };
    if block.length() <= BLOCK {
        return block.sweep(&change);
    }
    let parts: Vec<Mutex<(Block<'_, W, M, R>, [f64; N])>> =
        block.divided().into_iter().map(|block| Mutex::new((block, [0.0; N]))).collect();
    for_each(parts.len(), &|index| {
        let (block, partial) = &mut *parts[index].lock().unwrap_or_else(PoisonError::into_inner);
        *partial = block.sweep(&change);
    });
    let mut total = [0.0; N];
    for part in parts {
        let (_, partial) = part.into_inner().unwrap_or_else(PoisonError::into_inner);
        add(&mut total, partial);
    }
    total
}

/// Does the work of every index below a count, in parallel; compiled once for all sweeps.
fn for_each(count: usize, work: &(dyn Fn(usize) + Sync)) {
    (0..count).into_par_iter().for_each(work);
}

/// Does some work on a thread of the pool, so that its many short parallel passes start without waking
/// the pool each time.
pub fn in_pool<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    rayon::scope(|_| work())
}

/// The same stretch of several vectors.
///
/// Sweeps are compiled for each of a hundred callers. They are written in plain loops and without threads: closures over
/// arrays and parallel iterators would be most of what the compiler has to do here.
struct Block<'a, const W: usize, const M: usize, const R: usize> {
    beside: [Values<'a>; W],
    vectors: [&'a mut [f64]; M],
    others: [&'a [f64]; R],
}

impl<'a, const W: usize, const M: usize, const R: usize> Block<'a, W, M, R> {
    /// Elements that all vectors have.
    fn length(&self) -> usize {
        let vectors = self.vectors.iter().map(|v| v.len());
        vectors.chain(self.others.iter().map(|v| v.len())).min().unwrap_or(0)
    }

    /// Its parts of the size of a block.
    fn divided(self) -> Vec<Self> {
        let length = self.length();
        let mut parts = self.vectors.map(|vector| vector.chunks_mut(BLOCK));
        let mut other_parts = self.others.map(|vector| vector.chunks(BLOCK));
        (0..length.div_ceil(BLOCK))
            .map(|block| Block {
                beside: self.beside.map(|values| values.part(block * BLOCK, BLOCK)),
                vectors: parts.each_mut().map(|parts| parts.next().unwrap_or_default()),
                others: other_parts.each_mut().map(|parts| parts.next().unwrap_or_default()),
            })
            .collect()
    }

    /// Whole groups of lanes, then the rest.
    fn sweep<const N: usize>(
        &mut self,
        change: &impl Fn([f64; W], [f64; M], [f64; R]) -> ([f64; M], [f64; N]),
    ) -> [f64; N] {
        let length = self.length();
        let groups = length / LANES;
        // Copied: what is written might overlap with it otherwise, for all that the compiler knows.
        let stays = self.beside;
        let (mut written, read) = groups_of(&mut self.vectors, &self.others, groups);
        let mut lanes = [[0.0; LANES]; N];
        for group in 0..groups {
            // Copies on the stack: the compiler sees that nothing overlaps and takes lanes together.
            let (mut beside, mut before, mut others) =
                ([[0.0; LANES]; W], [[0.0; LANES]; M], [[0.0; LANES]; R]);
            for (values, from) in beside.iter_mut().zip(&stays) {
                *values = from.lanes(group);
            }
            for (values, from) in before.iter_mut().zip(&written) {
                *values = from[group];
            }
            for (values, from) in others.iter_mut().zip(&read) {
                *values = from[group];
            }
            let (mut after, mut terms) = ([[0.0; LANES]; M], [[0.0; LANES]; N]);
            for lane in 0..LANES {
                let (values, sums) =
                    change(of(&beside, lane), of(&before, lane), of(&others, lane));
                for (after, value) in after.iter_mut().zip(values) {
                    after[lane] = value;
                }
                for (terms, sum) in terms.iter_mut().zip(sums) {
                    terms[lane] = sum;
                }
            }
            for (to, values) in written.iter_mut().zip(after) {
                to[group] = values;
            }
            for (lanes, terms) in lanes.iter_mut().zip(terms) {
                add(lanes, terms);
            }
        }
        let mut total = [0.0; N];
        for (total, lanes) in total.iter_mut().zip(lanes) {
            *total = lanes.iter().sum();
        }
        for i in groups * LANES..length {
            let (mut beside, mut before, mut others) = ([0.0; W], [0.0; M], [0.0; R]);
            for (value, from) in beside.iter_mut().zip(&stays) {
                *value = from.at(i);
            }
            for (value, from) in before.iter_mut().zip(&self.vectors) {
                *value = from[i];
            }
            for (value, from) in others.iter_mut().zip(&self.others) {
                *value = from[i];
            }
            let (values, terms) = change(beside, before, others);
            for (to, value) in self.vectors.iter_mut().zip(values) {
                to[i] = value;
            }
            add(&mut total, terms);
        }
        total
    }
}

/// The first groups of some vectors that are written and of others that are read.
fn groups_of<'a, const M: usize, const R: usize>(
    vectors: &'a mut [&mut [f64]; M],
    others: &'a [&[f64]; R],
    groups: usize,
) -> ([&'a mut [Group]; M], [&'a [Group]; R]) {
    let written = vectors.each_mut().map(|vector| &mut vector.as_chunks_mut().0[..groups]);
    (written, others.each_ref().map(|vector| &vector.as_chunks().0[..groups]))
}

/// One lane of some groups.
#[inline(always)]
fn of<const N: usize>(groups: &[Group; N], lane: usize) -> [f64; N] {
    let mut values = [0.0; N];
    for (value, group) in values.iter_mut().zip(groups) {
        *value = group[lane];
    }
    values
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
