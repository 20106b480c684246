//! The level of a surface that is worn in part, found without knowing where.
//!
//! Of the planes through the medians of a few patches it is the one that a share of the patches lies closest to, with next
//! to none above it: wear only lowers a surface. This is least quantile of squares (Rousseeuw, J. Am. Stat. Assoc. 79 (1984)
//! 871) over all pairs or triples.

use super::Surface;
use crate::measured::plane::BEYOND_CHANCE;
use crate::measured::plane::{Height, Plane};

/// Patches along a profile, and along each axis of a map.
const ALONG: usize = 48;
const ACROSS: usize = 8;
/// Share of the patches that is to lie on the level; half as many may lie above it: ridges and debris.
const LEVEL: f64 = 0.3;
/// The distance within which that share of normal deviations lies, over their standard deviation: their quantile of 0.65.
const CLOSEST: f64 = 0.385;

/// The level of heights on the places of a surface.
pub(super) fn level(surface: &Surface, heights: &[Height]) -> Option<Plane> {
    let patches = patches(surface, heights);
    let planes: Box<dyn Iterator<Item = Plane>> = match surface.axis {
        Some(axis) => Box::new(pairs(&patches, axis)),
        None => Box::new(triples(&patches)),
    };
    let cost = |plane: &Plane| -> Option<f64> {
        let off: Vec<f64> = patches.iter().map(|patch| plane.above(patch)).collect();
        let mut sizes: Vec<f64> = off.iter().map(|off| off.abs()).collect();
        let place = ((LEVEL * sizes.len() as f64) as usize).min(sizes.len() - 1);
        let (_, within, _) = sizes.select_nth_unstable_by(place, f64::total_cmp);
        let within = *within;
        let above = off.iter().filter(|off| **off > BEYOND_CHANCE * within).count();
        (2.0 * above as f64 <= LEVEL * off.len() as f64).then_some(within)
    };
    let known = planes.filter_map(|plane| Some((plane, cost(&plane)?)));
    known.min_by(|one, other| one.1.total_cmp(&other.1)).map(|(plane, _)| plane)
}

/// The standard deviation of readings about their level, by the share of them that lies closest to it.
pub(super) fn deviation(level: &Plane, heights: &[Height]) -> f64 {
    let mut sizes: Vec<f64> = heights.iter().map(|own| level.above(own).abs()).collect();
    let place = (LEVEL * sizes.len() as f64) as usize;
    let (_, within, _) = sizes.select_nth_unstable_by(place, f64::total_cmp);
    *within / CLOSEST
}

/// The median height of the readings in each of some patches, at the middle of their places.
fn patches(surface: &Surface, heights: &[Height]) -> Vec<Height> {
    let counts = [0, 1].map(|axis| match surface.axis {
        Some(own) if own == axis => ALONG,
        Some(_) => 1,
        None => ACROSS,
    });
    let index = |own: &Height| {
        [0, 1].map(|axis| {
            let [low, high] = surface.extent(axis);
            let share = if high > low { (own[axis] - low) / (high - low) } else { 0.0 };
            ((share * counts[axis] as f64) as usize).min(counts[axis] - 1)
        })
    };
    let mut groups: Vec<Vec<Height>> = vec![vec![]; counts[0] * counts[1]];
    for own in heights {
        let [column, row] = index(own);
        groups[row * counts[0] + column].push(*own);
    }
    let median = |group: &mut Vec<Height>| {
        let size = group.len() as f64;
        let middle = [0, 1].map(|axis| group.iter().map(|own| own[axis]).sum::<f64>() / size);
        group.sort_by(|one, other| one[2].total_cmp(&other[2]));
        let last = group.len() - 1;
        [middle[0], middle[1], 0.5 * (group[last / 2][2] + group[last.div_ceil(2)][2])]
    };
    groups.iter_mut().filter(|group| !group.is_empty()).map(median).collect()
}

fn pairs(patches: &[Height], axis: usize) -> impl Iterator<Item = Plane> {
    let line = move |one: &Height, other: &Height| {
        let slope = (other[2] - one[2]) / (other[axis] - one[axis]);
        let mut tilt = [0.0; 2];
        tilt[axis] = slope;
        Plane::given(one[2] - slope * one[axis], tilt)
    };
    (0..patches.len())
        .flat_map(move |i| (0..i).map(move |j| line(&patches[j], &patches[i])))
        .filter(|plane| plane.offset.is_finite())
}

fn triples(patches: &[Height]) -> impl Iterator<Item = Plane> {
    let plane = |one: &Height, other: &Height, third: &Height| {
        let [a, b] = [other, third].map(|own| [0, 1, 2].map(|i| own[i] - one[i]));
        let whole = a[0] * b[1] - a[1] * b[0];
        let size = a[0].hypot(a[1]) * b[0].hypot(b[1]);
        if whole.abs() <= 0.1 * size {
            return None;
        }
        let tilt = [(a[2] * b[1] - a[1] * b[2]) / whole, (a[0] * b[2] - a[2] * b[0]) / whole];
        let offset = one[2] - tilt[0] * one[0] - tilt[1] * one[1];
        Some(Plane::given(offset, tilt))
    };
    (0..patches.len()).flat_map(move |i| {
        (0..i).flat_map(move |j| {
            (0..j).filter_map(move |k| plane(&patches[k], &patches[j], &patches[i]))
        })
    })
}
