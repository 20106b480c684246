//! How far the worn zones of bodies on a track reach: the scar on the body that stays, the track on the one that passes.

use super::Report;
use crate::frame::ContactFrame;

/// Wear relative to the deepest below which a place is outside of a scar or a track.
const EDGE: f64 = 1e-3;

/// Extent (m) of the scar on the body that stays, along the track and across: that of the ellipse with the second moments
/// of the worn zone, along a line of contact that of the rectangle. `None` where there is no track, or the body does not
/// wear.
pub(super) fn scar(report: &Report<'_>) -> Option<[f64; 2]> {
    let Report { problem, state, .. } = report;
    let sliding = problem.motion.sliding()?;
    let track = sliding.track?;
    let stays = 1 - track.body;
    problem.bodies[stays].wear.as_ref()?;
    Some(zone(&problem.frame, &state.worn[stays], sliding.direction.axis))
}

/// Extent (m) of the worn zone of a body that keeps its place under the contact, along the motion and across, as that of a
/// scar on a track; of bodies that are shifted along x. `None` where the body does not wear, passes or swings.
pub fn worn_extent(report: &Report<'_>, body: usize) -> Option<[f64; 2]> {
    let Report { problem, state, .. } = report;
    problem.bodies[body].wear.as_ref()?;
    let passes = problem.motion.passing().is_some_and(|passing| passing.bodies[body]);
    if passes || state.swung.is_some() || problem.motion.rolling().is_some() {
        return None;
    }
    let axis = problem.motion.sliding().map_or(0, |sliding| sliding.direction.axis);
    Some(zone(&problem.frame, &state.worn[body], axis))
}

/// What is worn off the section through the middle of the frame along an axis (m^2), of a body that keeps its place under the
/// contact on a uniform frame; `None` of any other.
pub fn worn_middle(report: &Report<'_>, (body, axis): (usize, usize)) -> Option<f64> {
    worn_extent(report, body)?;
    let (frame, worn) = (&report.problem.frame, &report.state.worn[body]);
    if !frame.is_uniform() || frame.is_line() && axis == 1 {
        return None;
    }
    let elements = frame.elements();
    let across = elements[1 - axis];
    // The middle row or, where the line runs between two rows, both.
    let rows = [(across - 1) / 2, across / 2];
    let pair = |along: usize, row: usize| {
        if axis == 0 { along + elements[0] * row } else { row + elements[0] * along }
    };
    let depth = |along: usize| 0.5 * rows.iter().map(|&row| worn[pair(along, row)]).sum::<f64>();
    Some(frame.spacing()[axis] * (0..elements[axis]).map(depth).sum::<f64>())
}

/// Extent (m) of the worn zone along an axis and across.
fn zone(frame: &ContactFrame, worn: &[f64], axis: usize) -> [f64; 2] {
    let shape = if frame.is_line() { 12f64.sqrt() } else { 4.0 };
    let gyration = |axis: usize| match frame.is_uniform() {
        true => gyration_of_rows(frame, worn, axis),
        false => gyration_of_pairs(frame, worn, axis),
    };
    [axis, 1 - axis].map(|axis| shape * gyration(axis))
}

/// Radius of gyration (m) of the worn zone along an axis: of chords, one a row of elements along it, which end where the flanks
/// of what is worn do, between elements. Zero where nothing is worn.
fn gyration_of_rows(frame: &ContactFrame, worn: &[f64], along: usize) -> f64 {
    let (elements, least) = (frame.elements(), EDGE * deepest(worn));
    let half = 0.5 * frame.spacing()[along];
    let pair = |one: usize, row: usize| match along {
        0 => one + elements[0] * row,
        _ => row + elements[0] * one,
    };
    let [mut length, mut first, mut second] = [0.0; 3];
    for row in 0..elements[1 - along] {
        let pairs = (0..elements[along]).map(|one| pair(one, row));
        let section: Vec<[f64; 2]> =
            pairs.map(|pair| [frame.place(pair)[along], worn[pair]]).collect();
        for [low, high] in chords(&section, (least, half)) {
            length += high - low;
            first += (high * high - low * low) / 2.0;
            second += (high.powi(3) - low.powi(3)) / 3.0;
        }
    }
    if length == 0.0 {
        return 0.0;
    }
    // Half a frame has its middle on the plane of symmetry.
    let middle = if frame.mirrored()[along] { 0.0 } else { first / length };
    (second / length - middle * middle).max(0.0).sqrt()
}

/// Where a section of places and depths (m) is worn deeper than that: the ends of each part, between elements where a flank says
/// so, else half an element beyond the last.
fn chords(section: &[[f64; 2]], (least, half): (f64, f64)) -> Vec<[f64; 2]> {
    let deep = |index: usize| section[index][1] > least;
    let end = |outside: Option<usize>, own: usize, inner: [Option<usize>; 2]| {
        let flank = inner.map(|index| index.filter(|index| deep(*index)));
        let (Some(outside), [Some(one), Some(two)]) = (outside, flank) else { return None };
        Some(flank_end(section[outside][0], [own, one, two].map(|index| section[index])))
    };
    let inside = |index: usize| (index < section.len()).then_some(index);
    let (mut found, mut from) = (vec![], 0);
    while let Some(first) = (from..section.len()).find(|index| deep(*index)) {
        let last = (first..section.len()).take_while(|index| deep(*index)).last().unwrap_or(first);
        let low = end(first.checked_sub(1), first, [1, 2].map(|n| inside(first + n)));
        let high = end(inside(last + 1), last, [1, 2].map(|n| last.checked_sub(n)));
        let [first, next] = [section[first][0] - half, section[last][0] + half];
        found.push([low.unwrap_or(first), high.unwrap_or(next)]);
        from = last + 1;
    }
    found
}

/// Radius of gyration (m) of the worn pairs along an axis, where they form no rows. Zero where nothing is worn.
fn gyration_of_pairs(frame: &ContactFrame, worn: &[f64], axis: usize) -> f64 {
    let least = EDGE * deepest(worn);
    let zone = || (0..worn.len()).filter(|&pair| worn[pair] > least);
    let all: f64 = zone().map(|pair| frame.area(pair)).sum();
    if all == 0.0 {
        return 0.0;
    }
    let mean = |power: i32, from: f64| {
        let part = |pair: usize| frame.area(pair) * (frame.place(pair)[axis] - from).powi(power);
        zone().map(part).sum::<f64>() / all
    };
    let middle = if frame.mirrored()[axis] { 0.0 } else { mean(1, 0.0) };
    // What an element spreads over belongs to it.
    let own = frame.elements()[axis].max(1) as f64;
    let element = frame.size()[axis] / own / if frame.mirrored()[axis] { 2.0 } else { 1.0 };
    (mean(2, middle) + element * element / 12.0).sqrt()
}

/// Width (m) of the track on the body that passes: between the places where the flanks of its section, continued
/// beyond the outermost lines, end. `None` where there is no track, or the body does not wear.
pub(super) fn track_width(report: &Report<'_>) -> Option<f64> {
    let Report { problem, state, .. } = report;
    let sliding = problem.motion.sliding()?;
    let track = sliding.track?;
    problem.bodies[track.body].wear.as_ref()?;
    let (frame, worn) = (&problem.frame, &state.worn[track.body]);
    if frame.is_line() {
        return Some(frame.size()[1 - sliding.direction.axis]);
    }
    let Ok(flow) = frame.flow(sliding.direction) else { return Some(f64::NAN) };
    let lines = flow.lines();
    let mut section: Vec<[f64; 2]> =
        lines.iter().map(|line| [line.place, line.mean(worn)]).collect();
    section.sort_by(|one, other| other[0].total_cmp(&one[0]));
    let high = edge(&section);
    if frame.mirrored()[1 - sliding.direction.axis] {
        return Some(high.map_or(0.0, |high| 2.0 * high));
    }
    section.reverse();
    Some(edge(&section).zip(high).map_or(0.0, |(low, high)| high - low))
}

/// Where a section of places and depths (m) begins, from its first line on; `None` of one without depth.
fn edge(section: &[[f64; 2]]) -> Option<f64> {
    let least = EDGE * section.iter().map(|[_, depth]| *depth).fold(0.0, f64::max);
    let first = section.iter().position(|[_, depth]| *depth > least)?;
    let outside = first.checked_sub(1).map(|before| section[before][0]);
    Some(match (outside, &section[first..]) {
        (Some(outside), &[own, one, two, ..]) => flank_end(outside, [own, one, two]),
        _ => section[first][0],
    })
}

/// Where a flank ends, by its three outermost places and depths (m) from the edge inwards: it goes on as it bends, and ends at
/// the latest at the last place (m) that is not worn.
fn flank_end(outside: f64, [[place, depth], one, two]: [[f64; 2]; 3]) -> f64 {
    let slope = |from: [f64; 2], to: [f64; 2]| (to[1] - from[1]) / (to[0] - from[0]);
    let (flank, next) = (slope([place, depth], one), slope(one, two));
    let straight = depth / flank;
    let bend = 0.5 * (1.0 + straight / (one[0] - place)) * (flank - next);
    let beyond = depth / (flank + bend);
    let most = place - outside;
    let fits = beyond.is_finite() && (0.0..1.0).contains(&(beyond / most));
    place - if fits { beyond } else { most }
}

/// Deepest wear (m), zero at least.
fn deepest(worn: &[f64]) -> f64 {
    worn.iter().copied().fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{chords, edge, zone};
    use crate::body::profile::Flat;
    use crate::frame::ContactFrame;

    /// A groove between two places, whatever the lines it is seen on: straight flanks are found exactly, those of a
    /// parabola to a fiftieth of an element each.
    #[test]
    fn edges_lie_between_lines() {
        let width = |depth: &dyn Fn(f64) -> f64, shift: f64| {
            let line = |index: i32| {
                let place = 0.1 * (f64::from(index) + shift);
                [place, depth(place).max(0.0)]
            };
            let mut section: Vec<[f64; 2]> = (-20..=20).map(line).collect();
            let low = edge(&section).unwrap();
            section.reverse();
            edge(&section).unwrap() - low
        };
        for shift in [0.03, 0.21, 0.5, 0.77, 0.95] {
            assert_relative_eq!(width(&|x| 1.0 - x.abs(), shift), 2.0, max_relative = 1e-12);
            assert_relative_eq!(width(&|x| 1.0 - x * x, shift), 2.0, epsilon = 4e-3);
        }
        assert_eq!(edge(&[[0.0, 0.0], [0.1, 0.0]]), None);
    }

    /// The diameter of a scar with a radius of five to seven elements is found to 1.3 % wherever its edge lies; whole elements
    /// are up to 4.6 % off.
    #[test]
    fn scars_grow_without_steps() {
        for elements in [[24, 24], [25, 24]] {
            let frame = ContactFrame::uniform([2.0, 2.0], elements, [&Flat, &Flat]).unwrap();
            for radius in (0..40).map(|step| 0.45 + 0.0025 * f64::from(step)) {
                let depth = |pair: usize| {
                    let [x, y] = frame.place(pair);
                    (radius * radius - x * x - y * y).max(0.0)
                };
                let worn: Vec<f64> = (0..frame.len()).map(depth).collect();
                for extent in zone(&frame, &worn, 0) {
                    assert_relative_eq!(extent, 2.0 * radius, max_relative = 0.013);
                }
            }
        }
    }

    /// A ring is worn within two edges on each side; what is worn up to the rim of the frame ends there.
    #[test]
    fn every_part_of_a_section_has_its_ends() {
        let section = |depth: &dyn Fn(f64) -> f64| -> Vec<[f64; 2]> {
            let places = (0..40).map(|index| -1.0 + 0.05 * (f64::from(index) + 0.5));
            places.map(|place| [place, depth(place).max(0.0)]).collect()
        };
        let ring = section(&|x| 0.23 - (x.abs() - 0.5).abs());
        let found = chords(&ring, (1e-3, 0.025));
        let expected = [[-0.73, -0.27], [0.27, 0.73]];
        for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
            assert_relative_eq!(found, expected, epsilon = 1e-12);
        }
        assert_eq!(found.len(), 2);
        let [whole] = chords(&section(&|_| 1.0), (1e-3, 0.025))[..] else { panic!() };
        assert_relative_eq!(whole[0], -1.0, epsilon = 1e-12);
        assert_relative_eq!(whole[1], 1.0, epsilon = 1e-12);
        assert_eq!(chords(&section(&|_| 0.0), (0.0, 0.025)), Vec::<[f64; 2]>::new());
    }
}
