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
    let least = EDGE * deepest(worn);
    let zone: Vec<usize> = (0..worn.len()).filter(|&pair| worn[pair] > least).collect();
    let shape = if frame.is_line() { 12f64.sqrt() } else { 4.0 };
    let extent = |axis: usize| shape * gyration(frame, &zone, axis);
    if zone.is_empty() { [0.0; 2] } else { [extent(axis), extent(1 - axis)] }
}

/// Radius of gyration (m) of a zone of pairs along an axis.
fn gyration(frame: &ContactFrame, zone: &[usize], axis: usize) -> f64 {
    let all: f64 = zone.iter().map(|&pair| frame.area(pair)).sum();
    let mean = |power: i32, from: f64| {
        let part = |&pair: &usize| frame.area(pair) * (frame.place(pair)[axis] - from).powi(power);
        zone.iter().map(part).sum::<f64>() / all
    };
    // Half a frame has its middle on the plane of symmetry.
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
    let [place, depth] = section[first];
    let (Some(before), Some([one, two])) =
        (first.checked_sub(1), section.get(first + 1..first + 3))
    else {
        return Some(place);
    };
    let slope = |from: [f64; 2], to: [f64; 2]| (to[1] - from[1]) / (to[0] - from[0]);
    let (flank, next) = (slope([place, depth], *one), slope(*one, *two));
    // The flank goes on as it bends, and ends at the latest at the last line that is not worn.
    let straight = depth / flank;
    let bend = 0.5 * (1.0 + straight / (one[0] - place)) * (flank - next);
    let beyond = depth / (flank + bend);
    let most = place - section[before][0];
    let fits = beyond.is_finite() && (0.0..1.0).contains(&(beyond / most));
    Some(place - if fits { beyond } else { most })
}

/// Deepest wear (m), zero at least.
fn deepest(worn: &[f64]) -> f64 {
    worn.iter().copied().fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::edge;

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
}
