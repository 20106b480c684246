//! What is doubtful about bodies that are pressed and shifted step by step, in words.

use super::forecast::Forecast;
use super::judge::{ROOM, stable, wear_slope};
use super::surfaces::FAR;
use super::words::{length, size_list_up, three};
use super::{Parts, Solves};
use crate::case::definition::Output;
use crate::case::key::Key;
use crate::case::problem::Problem;
use crate::verdict::EDGES;
use archard::body::Elasticity;
use archard::estimate::Contact;
use archard::motion::{Control, Drive, Shift, Station, Stepping};

/// All that is wrong or doubtful about pressing and shifting.
pub(super) fn problems(parts: &Parts<'_>, forecast: &Forecast) -> Vec<Problem> {
    let Some(shift) = parts.motion.increments() else { return vec![] };
    let mut problems: Vec<Problem> = sliding_away(parts, shift).into_iter().collect();
    problems.extend(no_effect(parts, shift));
    problems.extend(far(parts, shift, forecast.estimate.contact.as_ref()));
    problems.extend(useless_phases(parts));
    problems.extend(useless_jumps(parts, forecast));
    problems.extend(coarse_increments(parts, shift));
    problems.extend(scar_beyond_the_frame(parts, forecast));
    problems
}

/// A key of the motion.
fn key(parts: &Parts<'_>, name: &str) -> Key {
    Key::of(["motion", parts.case.motion.choice.name, name])
}

/// Whether the motion was given a value of that name.
fn given(parts: &Parts<'_>, name: &str) -> bool {
    parts.case.motion.values.get(name).is_some()
}

/// A force that nothing bears.
fn sliding_away(parts: &Parts<'_>, shift: &Shift) -> Option<Problem> {
    // What leads to a first line of a path grows evenly: that line is the one to change.
    let first = shift.lead.last().map(|station| (0.0, station));
    let cycle = shift.places.iter().copied().zip(&shift.cycle);
    let asked = first.into_iter().chain(cycle).filter(|(_, station)| size(force(station)) > 0.0);
    let mut beyond = asked.filter_map(|(place, station)| {
        let excess = size(force(station)) - (1.0 - 1e-9) * borne(parts, station)?;
        (excess >= 0.0).then_some((place, station, excess))
    });
    let (name, when, station) = if given(parts, "force_amplitude") {
        let (_, station, _) = beyond.max_by(|one, other| one.2.total_cmp(&other.2))?;
        ("force_amplitude", String::new(), station)
    } else {
        let (place, station, _) = beyond.next()?;
        ("file", format!(" at {}", parts.motion.progress.at(place)), station)
    };
    let force = three(size(force(station)));
    let message = if parts.friction.is_none() {
        format!("nothing bears the force of {force} N{when} without a `friction` table")
    } else {
        let bears = three(borne(parts, station)?);
        format!(
            "{force} N{when} is no less than friction bears under the load there, {bears} N: the bodies would slide away"
        )
    };
    Some(Problem::error(key(parts, name), message))
}

/// The tangential force (N) prescribed at a station, along x and y.
fn force(station: &Station) -> [f64; 2] {
    station.guides.map(|guide| match guide {
        Drive::Force(force) => force,
        Drive::Slip(_) => 0.0,
    })
}

fn size([x, y]: [f64; 2]) -> f64 {
    x.hypot(y)
}

/// The force (N) friction bears at a station in the direction of the one prescribed, where the load there is known.
fn borne(parts: &Parts<'_>, station: &Station) -> Option<f64> {
    if parts.friction.is_none() {
        return Some(0.0);
    }
    let load = match station.control {
        Control::Load(load) => load,
        Control::Approach(_) => parts.subject().contact(station.control)?.load,
    };
    let given = station.guides.map(|guide| matches!(guide, Drive::Force(_)));
    Some(parts.subject().largest_force(force(station), given)? * load)
}

/// Whether a body deforms as its shape gives: those of one elasticity then slip as well.
fn shaped(parts: &Parts<'_>) -> bool {
    parts.meshed().any(|(_, finite)| finite.elasticity != Elasticity::HalfSpace)
}

/// Friction and wear that cannot show where bodies of one elasticity are pressed together.
fn no_effect(parts: &Parts<'_>, shift: &Shift) -> Vec<Problem> {
    let mut problems = vec![];
    for name in ["amplitude", "force_amplitude"] {
        if parts.case.motion.values.pair(name) == Some([0.0; 2]) {
            let message = "both amplitudes are zero: nothing moves the bodies along each other";
            problems.push(Problem::warning(key(parts, name), message));
        }
    }
    if shift.moves() || !parts.alike() || shaped(parts) {
        return problems;
    }
    const REASON: &str = "bodies of one elasticity that are only pressed together do not slip";
    if parts.friction.is_some() {
        let message = format!("has no effect: {REASON}");
        problems.push(Problem::warning(Key::of(["friction"]), message).at_name());
    }
    let worn = parts.case.bodies.iter().filter(|body| body.wears());
    problems.extend(worn.map(|body| {
        let message = format!("{REASON}: this body will not wear");
        Problem::warning(Key::of(["body", &body.name, "wear"]), message)
    }));
    problems
}

/// Shifts that are not small against the contact: pairs are taken to stay opposite each other.
fn far(parts: &Parts<'_>, shift: &Shift, contact: Option<&Contact>) -> Option<Problem> {
    let half_width = contact?.semi_axes.into_iter().fold(f64::INFINITY, f64::min);
    let reaches = shift.cycle.iter().map(|station| {
        let [x, y] = station.guides.map(|guide| match guide {
            Drive::Slip(shift) => shift,
            Drive::Force(_) => 0.0,
        });
        x.hypot(y)
    });
    let reach = reaches.fold(0.0, f64::max);
    (reach > FAR * half_width).then(|| {
        let message = format!(
            "the bodies are shifted by {}, {} of the half width of the contact: surfaces are computed as if they stayed opposite each other",
            length(reach),
            three(reach / half_width)
        );
        if !given(parts, "amplitude") {
            return Problem::warning(key(parts, "file"), message);
        }
        let help = "in gross slip, `surfaces = \"swing\"` wears each where its own points are; staying, the scar comes out some 8 % too deep";
        Problem::warning(key(parts, "amplitude"), message).help(help)
    })
}

/// Angles between oscillations where there is only one.
fn useless_phases(parts: &Parts<'_>) -> Vec<Problem> {
    let values = &parts.case.motion.values;
    let amplitudes = values.pair("amplitude").or(values.pair("force_amplitude"));
    let mut problems = vec![];
    if given(parts, "phase") && amplitudes.is_some_and(|[_, along_y]| along_y == 0.0) {
        let message = "has no effect: nothing oscillates along y";
        problems.push(Problem::warning(key(parts, "phase"), message).at_name());
    }
    if given(parts, "load_phase") && !given(parts, "load_amplitude") {
        let message = "has no effect without a `load_amplitude`";
        problems.push(Problem::warning(key(parts, "load_phase"), message).at_name());
    }
    problems
}

/// Jumps that jump over nothing.
fn useless_jumps(parts: &Parts<'_>, forecast: &Forecast) -> Option<Problem> {
    let total = forecast.cycles?.total;
    let (Solves::Exactly(computed) | Solves::AtLeast(computed) | Solves::About(computed)) =
        forecast.cycles?.computed;
    // The tolerance that goes with an accuracy was not asked for.
    if parts.case.accuracy.is_some() && (parts.wears() || computed == total) {
        return None;
    }
    let (name, jump) = match parts.schedule.stepping {
        Stepping::Jumps(jump) => ("jump", jump as u64),
        Stepping::Tolerance(_) => ("tolerance", 0),
        Stepping::Implicit(_) | Stepping::Explicit(_) | Stepping::ToOutputs => return None,
    };
    let warning = |message: String| Problem::warning(key(parts, name), message).at_name();
    if !parts.wears() {
        let message =
            "neither body has a `wear` table: cycles that are jumped over are only left out";
        return Some(warning(message.to_owned()).help("a few `cycles` are enough without wear"));
    }
    if total == 1 {
        return Some(warning("has no effect: there is only one cycle".to_owned()));
    }
    if jump > total {
        let message = format!(
            "is more than all {total} cycles: only outputs decide which of them are computed"
        );
        return Some(warning(message));
    }
    (computed == total && jump != 1).then(|| crowded(parts, total))?
}

/// Outputs so close that every cycle is computed for one of them.
fn crowded(parts: &Parts<'_>, total: u64) -> Option<Problem> {
    let period = parts.schedule.extent / total as f64;
    let name = match &parts.case.output {
        Output::Every(interval) if *interval < 1.5 * period => "every",
        Output::At(places) if places.len() as u64 >= total => "at",
        _ => return None,
    };
    let message = "every cycle with an output is computed: these leave none to be jumped over";
    Some(
        Problem::warning(Key::of(["output", name]), message)
            .help("take longer stretches between outputs, like `output.every = 100`"),
    )
}

/// Increments in which so much wears that pressures swing: wear follows explicitly from one to the next.
fn coarse_increments(parts: &Parts<'_>, shift: &Shift) -> Option<Problem> {
    let (slip, farthest) = (slip_of_an_increment(parts, shift), farthest_slip(parts)?);
    (slip > farthest).then(|| {
        let message = format!(
            "pairs may slide {} in an increment, each worn before the next: from about {} on pressures will swing from element to element",
            length(slip),
            length(farthest)
        );
        let problem = if given(parts, "increments") {
            Problem::warning(key(parts, "increments"), message)
        } else {
            Problem::warning(Key::of(["motion", parts.case.motion.choice.name]), message).at_name()
        };
        let more = three((slip / farthest).ceil());
        problem.help(format!("take {more} times as many `increments`, or larger elements"))
    })
}

/// The slip (m) in one increment up to which wear is stable; `None` where nothing wears.
fn farthest_slip(parts: &Parts<'_>) -> Option<f64> {
    let slope = wear_slope(parts);
    (slope > 0.0).then(|| stable(parts) / slope)
}

/// The farthest (m) that pairs may slide in an increment of a cycle: the shift of the bodies, and what
/// pressing unlike ones together makes the edge of the contact slip without friction.
fn slip_of_an_increment(parts: &Parts<'_>, shift: &Shift) -> f64 {
    // A sphere of radius R draws the edge of its contact of radius a inwards by 4 beta a^2 / (3 pi R).
    let drawn = 4.0 * parts.subject().dundurs_beta().abs() / (3.0 * std::f64::consts::PI);
    let approach = |station: &Station| match station.control {
        Control::Approach(approach) => Some(approach),
        Control::Load(0.0) => Some(0.0),
        load => parts.subject().contact(load)?.approach,
    };
    let between = |before: &Station, after: &Station| {
        let moved = [0, 1].map(|axis| match (before.guides[axis], after.guides[axis]) {
            (Drive::Slip(one), Drive::Slip(other)) => other - one,
            _ => 0.0,
        });
        let pressed = approach(before).zip(approach(after)).map_or(0.0, |(one, two)| two - one);
        moved[0].hypot(moved[1]) + drawn * pressed.abs()
    };
    let slips = shift.cycle.windows(2).map(|pair| between(&pair[0], &pair[1]));
    slips.fold(0.0, f64::max)
}

/// A zone that the scar grows out of.
fn scar_beyond_the_frame(parts: &Parts<'_>, forecast: &Forecast) -> Option<Problem> {
    let radius = forecast.estimate.fretting?.wear.filter(|wear| wear.ends())?.end.scar_radius;
    let width = 2.0 * radius;
    let cut = parts.case.frame.size.iter().any(|&size| size < width);
    (cut && !parts.grows()).then(|| {
        let message = format!(
            "the scar will reach the edge of the {}: it ends {} wide, when the stick zone bears all of the load",
            parts.frame_word(),
            length(width)
        );
        Problem::warning(parts.frame_key("size"), message)
            .judged(EDGES)
            .help(format!("it needs about `size = {}`", size_list_up([ROOM * radius; 2])))
    })
}
