//! Whether the elements see the texture of a surface that was measured, or made of waves.

use super::Parts;
use super::words::{length, three};
use crate::case::problem::Problem;
use archard::body::Profile;

/// Share of the mean square slope that elements may miss: pressures on summits go with the slope, so that they are 5 % too low. A
/// judgement.
const MISSED: f64 = 0.1;
/// Lines across the frame on which slopes are compared: a choice of cost.
const LINES: usize = 32;

/// A surface whose texture is finer than the elements, where the case chose them itself.
pub(super) fn problems(parts: &Parts<'_>) -> Vec<Problem> {
    let frame = &parts.case.frame;
    if parts.case.accuracy.is_some() || frame.line || parts.case.is_meshed() {
        return vec![];
    }
    let axes = parts.bodies.iter().flat_map(|body| [(body, 0), (body, 1)]);
    axes.filter_map(|(body, axis)| {
        let seen = Slopes::of(parts, &*body.profile, axis)?;
        let missed = 1.0 - (seen.of_elements / seen.of_places).powi(2);
        (missed > MISSED).then(|| {
            let [name, along] = [&body.name, ["x", "y"][axis]];
            let message = format!(
                "elements of {} see an rms slope of {} along {along} of `{name}`, and its surface has {}: finer texture is left out",
                length(frame.spacing()[axis]), three(seen.of_elements), three(seen.of_places),
            );
            let help = format!(
                "take elements of {}, or leave it out on purpose by `smooth` in a `profile.surface`",
                length(seen.apart)
            );
            Problem::warning(parts.frame_key("elements"), message).help(help)
        })
    })
    .collect()
}

/// Root mean square slopes of a surface along an axis, within the frame.
struct Slopes {
    /// From the middle of an element to the next.
    of_elements: f64,
    /// From a place where the surface is known to the next.
    of_places: f64,
    /// How far those are apart (m), in the mean.
    apart: f64,
}

impl Slopes {
    /// `None` where a formula gives the surface, or the elements are no larger than places are apart.
    fn of(parts: &Parts<'_>, profile: &dyn Profile, axis: usize) -> Option<Self> {
        let frame = &parts.case.frame;
        let (corner, spacing) = (frame.rectangle().corner(), frame.spacing());
        let middle = |axis: usize, share: f64| corner[axis] + share * frame.size[axis];
        let [from, to] = [0.0, 1.0].map(|share| middle(axis, share));
        let places = profile.places()[axis].iter().copied();
        let places: Vec<f64> = places.filter(|place| (from..=to).contains(place)).collect();
        let (first, last) = (places.first()?, places.last()?);
        let apart = (last - first) / (places.len() - 1).max(1) as f64;
        if places.len() < 2 || spacing[axis] <= apart {
            return None;
        }
        let elements = frame.elements[axis];
        let middles: Vec<f64> = (0..elements)
            .map(|index| middle(axis, (index as f64 + 0.5) / elements as f64))
            .collect();
        let slope = |along: &[f64]| {
            let mut sum = [0.0; 2];
            for line in 0..LINES {
                let across = middle(1 - axis, (line as f64 + 0.5) / LINES as f64);
                let recess = |place: f64| match axis {
                    0 => profile.recess(place, across),
                    _ => profile.recess(across, place),
                };
                for ends in along.windows(2) {
                    let slope = (recess(ends[1]) - recess(ends[0])) / (ends[1] - ends[0]);
                    if slope.is_finite() {
                        sum = [sum[0] + slope * slope, sum[1] + 1.0];
                    }
                }
            }
            (sum[0] / sum[1]).sqrt()
        };
        Some(Self { of_elements: slope(&middles), of_places: slope(&places), apart })
    }
}
