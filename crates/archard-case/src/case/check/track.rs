//! Whether surfaces that slide stay opposite each other, or one of them passes, as it should.

use super::words::length;
use super::{Forecast, Parts};
use crate::case::key::Key;
use crate::case::problem::Problem;
use archard::motion::Track;
use archard::numerics::SAME;

/// What is wrong or doubtful about a track, or about none.
pub(super) fn problems(parts: &Parts<'_>, forecast: &Forecast) -> Vec<Problem> {
    match &parts.motion.track() {
        None => stays(parts).into_iter().collect(),
        Some(track) => {
            let axis = parts.motion.direction.axis;
            let short = short(parts, track, axis, forecast);
            short.into_iter().chain(uneven(parts, track, axis)).collect()
        }
    }
}

/// Both bodies wear and nothing is said of how their surfaces meet.
fn stays(parts: &Parts<'_>) -> Option<Problem> {
    let motion = &parts.motion;
    if motion.lever_arm().is_none() || !motion.stays() || motion.has_positions() {
        return None;
    }
    let said = parts.case.motion.values.get("surfaces").is_some();
    if said || !parts.bodies.iter().all(|body| body.wear.is_some()) {
        return None;
    }
    let message = "both bodies wear where they stay opposite each other, so that a disc gets a pit and no track";
    let help = "of a disc, ring or flat that is longer give `track_radius`, `track` or `stroke`, and `passes = \"NAME\"`; say `surfaces = \"stay\"` where it is meant so";
    Some(Problem::warning(self::motion(parts), message).at_name().help(help))
}

/// A track that is shorter than the contact on it, or than the frame where nothing says how long the contact gets.
fn short(parts: &Parts<'_>, track: &Track, axis: usize, forecast: &Forecast) -> Option<Problem> {
    let reach =
        forecast.estimate.reach().map(|reach| reach[axis]).filter(|reach| reach.is_finite());
    let (long, what) = match reach {
        Some(reach) => (2.0 * reach, "the contact on it, which gets"),
        None => (parts.case.frame.size[axis], "the frame on it, which is"),
    };
    (long > track.length).then(|| {
        let message = format!(
            "the track is {} long, shorter than {what} {}",
            length(track.length),
            length(long)
        );
        Problem::error(key_of_length(parts), message)
    })
}

/// A body whose surface changes along the track: what passes has to look the same everywhere.
fn uneven(parts: &Parts<'_>, track: &Track, axis: usize) -> Option<Problem> {
    let body = &parts.bodies[track.body];
    if body.curvatures().is_some() {
        return None;
    }
    let half = parts.case.frame.size.map(|size| 0.5 * size);
    let shares = [-1.0, -0.6, -0.3, 0.0, 0.2, 0.5, 0.9];
    let height = |along: f64, across: f64| {
        let mut place = [0.0; 2];
        (place[axis], place[1 - axis]) = (along, across);
        body.profile.recess(place[0] * half[0], place[1] * half[1])
    };
    let all = shares.iter().flat_map(|&x| shares.map(|y| height(x, y).abs()));
    let most = all.fold(0.0, f64::max);
    let even = shares.iter().all(|&across| {
        let first = height(0.0, across);
        shares.iter().all(|&along| (height(along, across) - first).abs() <= SAME * most)
    });
    (!even).then(|| {
        let message = format!(
            "the surface of `{}` changes along the track, and what passes has to be the same all along",
            body.name
        );
        Problem::error(motion(parts).child("passes"), message)
            .help("let the other body pass, or leave the track out")
    })
}

fn motion(parts: &Parts<'_>) -> Key {
    Key::of(["motion", parts.case.motion.choice.name])
}

/// The key that gives the length of the track.
fn key_of_length(parts: &Parts<'_>) -> Key {
    let given = ["track_radius", "track", "stroke"]
        .into_iter()
        .find(|name| parts.case.motion.values.get(name).is_some());
    motion(parts).child(given.unwrap_or("track"))
}
