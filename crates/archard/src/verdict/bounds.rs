//! The lines there are, each with its bounds and what these were measured on.

use super::{Bound, Line};

/// The load, or approach, against the one prescribed: how far off it is, relative to it.
///
/// Solvers end at residuals of 1e-8 (pressures) and 1e-6 (friction with pressures); a lost contact is off by 1.
pub fn load(off: f64) -> Line {
    let text = "off what was prescribed; a tighter `solver.tolerance` brings it nearer";
    Line::new("load", off, Bound::AtMost([1e-5, 1e-3]), text)
}

/// The share of the load on the edge of the frame, and how many pairs bear it.
///
/// A contact that goes on beyond its frame has its pressures at the edge wrong, and the share is what is missing
/// there: a few per cent of the load move the peak pressure of a ball by as much.
pub fn edges(share: f64, pairs: usize) -> Line {
    let text = match pairs {
        0 => "of the load at the edge of the frame".to_owned(),
        _ => format!(
            "of the load at the edge of the frame, on {pairs} elements: enlarge `frame.size`, or the zone of the mesh"
        ),
    };
    Line::new("edges", share, Bound::AtMost([0.0, 0.03]), text)
}

/// Elements across the contact when it first bears a load: coarse ones spoil the first outputs, and fade.
pub fn first_contact(across: f64) -> Line {
    let text = "elements across the contact at first; below 8 the first outputs are coarse";
    Line::new("elements", across, Bound::AtLeast([8.0, 0.0]), text)
}

/// Elements across the contact where it is largest.
///
/// The peak pressure of a ball is off by 0.3/N^2, the depth worn off a pin by 2/N^2 with N elements: 5 % at 6 and half
/// of it at 2 (`cargo run --release --example accuracy`).
pub fn contact(across: f64) -> Line {
    let text = "elements across the contact at its largest; take more elements or a smaller frame";
    Line::new("contact", across, Bound::AtLeast([6.0, 2.0]), text)
}

/// Elements across the stick zone, where a part of the contact slips.
pub fn stick_zone(across: f64) -> Line {
    let text = "elements across the stick zone; its area is that of whole elements";
    Line::new("stick zone", across, Bound::AtLeast([4.0, 0.0]), text)
}

/// The estimated error of the worn depth that steps or jumps make, against the tolerance asked for.
pub fn time(error: f64, tolerance: f64) -> Line {
    let text = format!("estimated error of the worn depth by steps in time, {tolerance} asked");
    Line::new("time", error, Bound::AtMost([1.5 * tolerance, (10.0 * tolerance).max(0.1)]), text)
}

/// The work of the motion over a cycle against what friction dissipates in it, relative to the latter.
pub fn energy(off: f64) -> Line {
    let text = "between the work of a cycle and what friction dissipates; take more increments";
    Line::new("energy", off, Bound::AtMost([0.02, 0.1]), text)
}

/// Worn volume or section against what the prescribed load, the creepage or the dissipated energy wears.
pub fn volume(off: f64) -> Line {
    let text = "between the worn volume and what was prescribed wears";
    Line::new("volume", off, Bound::AtMost([0.02, 0.1]), text)
}

/// The largest alternation or spike of the pressures from element to element, relative to the peak.
pub fn roughness(off: f64) -> Line {
    let text =
        "of the peak pressure alternates or stands on single elements, which do not resolve it";
    Line::new("pressures", off, Bound::AtMost([0.05, 0.5]), text)
}
