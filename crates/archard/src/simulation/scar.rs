//! How far the worn zones of bodies on a track reach: the scar on the body that stays, the track on the one that passes.

use super::report::Report;
use crate::frame::ContactFrame;

/// Wear relative to the deepest below which a place is outside of a scar or a track.
const EDGE: f64 = 1e-3;

/// Extent (m) of the scar on the body that stays, along the track and across: that of the ellipse with the second moments
/// of the worn zone, along a line of contact that of the rectangle. `None` where there is no track, or the body does not
/// wear.
pub(super) fn scar(report: &Report<'_>) -> Option<[f64; 2]> {
    let Report { problem, state, .. } = report;
    let track = problem.motion.track()?;
    let stays = 1 - track.body;
    problem.bodies[stays].wear.as_ref()?;
    Some(zone(&problem.frame, &state.worn(stays), problem.motion.direction.axis))
}

/// Extent (m) of the worn zone of a body that keeps its place under the contact, along the motion and across, as that of a
/// scar on a track; of bodies that are shifted along x. `None` where the body does not wear, passes or swings, or repeats itself.
pub fn worn_extent(report: &Report<'_>, body: usize) -> Option<[f64; 2]> {
    let Report { problem, state, .. } = report;
    problem.bodies[body].wear.as_ref()?;
    let passes = problem.motion.surfaces[body].passes();
    let endless = problem.frame.is_uniform() && problem.frame.measure().closed;
    let swings = state.surfaces.iter().any(|one| one.grid.swings().is_some());
    if passes || endless || swings {
        return None;
    }
    Some(zone(&problem.frame, &state.worn(body), problem.motion.direction.axis))
}

/// What is worn off the section through the middle of a uniform frame along an axis (m^2), of a body that keeps its place under the
/// contact or swings about it; `None` where it does not wear, passes, or repeats itself, and on other frames.
pub fn worn_middle(report: &Report<'_>, (body, axis): (usize, usize)) -> Option<f64> {
    let problem = report.problem;
    problem.bodies[body].wear.as_ref()?;
    let endless = problem.frame.is_uniform() && problem.frame.measure().closed;
    if problem.motion.surfaces[body].passes() || endless {
        return None;
    }
    let profile = worn_profile(report, (body, axis))?;
    Some(report.problem.frame.spacing()[axis] * profile.iter().map(|own| own[1]).sum::<f64>())
}

/// Places along an axis (m) and what is worn off there (m), through the middle of a uniform frame; `None` of other frames, and across a
/// line of contact.
pub fn worn_profile(report: &Report<'_>, (body, axis): (usize, usize)) -> Option<Vec<[f64; 2]>> {
    let (frame, worn) = (&report.problem.frame, report.state.worn(body));
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
    let point = |along: usize| [frame.place(pair(along, rows[0]))[axis], depth(along)];
    Some((0..elements[axis]).map(point).collect())
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

/// Radius of gyration (m) of the worn zone along an axis: of chords, one a row of elements along it, from its first flank to its
/// last. What sticks in the middle of a scar belongs to it. Zero where nothing is worn.
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
        if let Some([low, high]) = chord(&section, (least, half)) {
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

/// Where a section of places and depths (m) is worn deeper than that: from its first place to its last, between elements where
/// a flank says so, else half an element beyond. `None` where it is not.
fn chord(section: &[[f64; 2]], (least, half): (f64, f64)) -> Option<[f64; 2]> {
    let deep = |&index: &usize| section[index][1] > least;
    let first = (0..section.len()).find(deep)?;
    let last = (0..section.len()).rev().find(deep)?;
    let inside = |index: usize| Some(index).filter(|index| *index < section.len()).filter(deep);
    let end = |outside: Option<usize>, own: usize, inner: [Option<usize>; 2]| {
        let (outside, [one, two]) = (outside?, [inner[0]?, inner[1]?]);
        Some(flank_end(section[outside][0], [own, one, two].map(|index| section[index])))
    };
    let low = end(first.checked_sub(1), first, [1, 2].map(|n| inside(first + n)));
    let beyond = Some(last + 1).filter(|index| *index < section.len());
    let high = end(beyond, last, [1, 2].map(|n| last.checked_sub(n).and_then(inside)));
    Some([low.unwrap_or(section[first][0] - half), high.unwrap_or(section[last][0] + half)])
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
    let element = frame.spacing()[axis];
    (mean(2, middle) + element * element / 12.0).sqrt()
}

/// Width (m) of the track on the body that passes: between the places where the flanks of its section, continued
/// beyond the outermost lines, end. `None` where there is no track, or the body does not wear.
pub(super) fn track_width(report: &Report<'_>) -> Option<f64> {
    let Report { problem, state, .. } = report;
    let (track, direction) = (problem.motion.track()?, problem.motion.direction);
    problem.bodies[track.body].wear.as_ref()?;
    let (frame, worn) = (&problem.frame, state.worn(track.body));
    if frame.is_line() {
        return Some(frame.size()[1 - direction.axis]);
    }
    let Ok(flow) = frame.flow(direction) else { return Some(f64::NAN) };
    let lines = flow.lines();
    let mut section: Vec<[f64; 2]> =
        lines.iter().map(|line| [line.place, line.mean(&worn)]).collect();
    section.sort_by(|one, other| other[0].total_cmp(&one[0]));
    let high = edge(&section);
    if frame.mirrored()[1 - direction.axis] {
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

    use super::{chord, edge, zone};
    use crate::body::profile::Flat;
    use crate::frame::{ContactFrame, Pairs};

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

    /// Pairs of meshes lie in no rows: a scar that is round comes out as round.
    #[test]
    fn a_round_scar_of_scattered_pairs_is_round() {
        let number = 60;
        let side = 2.0 / f64::from(number);
        let place = |index: i32| {
            let [x, y] =
                [index % number, index / number].map(|at| side * (f64::from(at) + 0.5) - 1.0);
            [x, y, 0.0]
        };
        let places: Vec<_> = (0..number * number).map(place).collect();
        let pairs = places.len();
        let (areas, gap) = (vec![side * side; pairs], vec![0.0; pairs]);
        let corners = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]];
        let outline =
            |[x, y, _]: &[f64; 3]| corners.map(|[u, v]| [x + side * u, y + side * v, 0.0]).to_vec();
        let outlines = places.iter().map(outline).collect();
        let frame = Pairs { places, areas, gap, outlines, ..Pairs::default() };
        let frame = ContactFrame::described(frame).unwrap();
        let depth = |pair: usize| {
            let [x, y] = frame.place(pair);
            (0.5 - x * x - y * y).max(0.0)
        };
        let worn: Vec<f64> = (0..pairs).map(depth).collect();
        for extent in zone(&frame, &worn, 0) {
            assert_relative_eq!(extent, 2.0 * 0.5f64.sqrt(), max_relative = 0.01);
        }
    }

    /// What sticks in the middle of a scar belongs to it; what is worn up to the rim of the frame ends there.
    #[test]
    fn a_section_ends_at_its_outermost_flanks() {
        let section = |depth: &dyn Fn(f64) -> f64| -> Vec<[f64; 2]> {
            let places = (0..40).map(|index| -1.0 + 0.05 * (f64::from(index) + 0.5));
            places.map(|place| [place, depth(place).max(0.0)]).collect()
        };
        let ends = |depth: &dyn Fn(f64) -> f64| chord(&section(depth), (1e-3, 0.025));
        let ring = ends(&|x| 0.23 - (x.abs() - 0.5).abs()).unwrap();
        let whole = ends(&|_| 1.0).unwrap();
        for (found, expected) in [(ring, [-0.73, 0.73]), (whole, [-1.0, 1.0])] {
            assert_relative_eq!(found[0], expected[0], epsilon = 1e-12);
            assert_relative_eq!(found[1], expected[1], epsilon = 1e-12);
        }
        assert_eq!(ends(&|_| 0.0), None);
    }

    /// Partial slip wears a ring, and the scar is as wide as it is.
    #[test]
    fn a_ring_is_as_wide_as_its_outer_edge() {
        let frame = ContactFrame::uniform([2.0, 2.0], [60, 60], [&Flat, &Flat]).unwrap();
        let depth = |pair: usize| {
            let [x, y] = frame.place(pair);
            let r = x.hypot(y);
            ((r - 0.4) * (0.7 - r)).max(0.0)
        };
        let worn: Vec<f64> = (0..frame.len()).map(depth).collect();
        for extent in zone(&frame, &worn, 0) {
            assert_relative_eq!(extent, 1.4, max_relative = 0.01);
        }
    }
}
