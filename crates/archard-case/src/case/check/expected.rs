//! What closed forms expect, in words.

use std::fmt::{self, Formatter};

use super::words::{length, pressure, three};
use archard::closed_form::worn_track::WornTrack;
use archard::estimate::{
    Contact, Estimate, Fretting, FrettingWear, OnTrack, RollingEstimate, SphereWithFriction, Track,
    Warmth, WornCap,
};

/// The contact and its friction, with the elements across it along x and y.
pub(super) fn write_contact(
    f: &mut Formatter<'_>,
    estimate: &Estimate,
    cells: Option<[f64; 2]>,
) -> fmt::Result {
    match &estimate.contact {
        Some(contact) => contact_in_words(f, contact)?,
        None => writeln!(f, "contact           no closed form for these bodies and this motion")?,
    }
    if let Some([x, y]) = cells {
        match estimate.contact {
            Some(Contact { semi_axes: [_, f64::INFINITY], .. }) => {
                writeln!(f, "elements across   {}", three(x))?;
            }
            _ => writeln!(f, "elements across   {} along x, {} along y", three(x), three(y))?,
        }
    }
    if let Some(rolled) = &estimate.rolled {
        rolled_in_words(f, rolled)?;
    }
    if let Some(warmth) = &estimate.warmth {
        warmth_in_words(f, warmth)?;
    }
    if let Some(fretting) = &estimate.fretting {
        fretting_in_words(f, fretting)?;
    }
    if let Some(SphereWithFriction { stick_ratio, .. }) = estimate.pressed {
        writeln!(f, "stick zone        {} of the contact radius (Spence)", three(stick_ratio))?;
    }
    Ok(())
}

/// The wear at the end.
pub(super) fn write_wear(f: &mut Formatter<'_>, estimate: &Estimate) -> fmt::Result {
    let track = estimate.rolled.and_then(|rolled| rolled.track);
    let fretting = estimate.fretting.and_then(|fretting| fretting.wear);
    if let Some(track) = estimate.track {
        return groove_in_words(f, &track);
    }
    match (estimate.cap, track, fretting) {
        (Some(WornCap { volume, depth, semi_axes, .. }), ..) => {
            writeln!(f, "worn volume       {} mm^3 at the end (k F s)", three(volume * 1e9))?;
            writeln!(f, "wear depth        {} at the end (rigid bodies, eq. 55)", length(depth))?;
            writeln!(f, "scar              {} at the end", axes(semi_axes))
        }
        (None, Some(track), _) => track_in_words(f, &track),
        (None, None, Some(wear)) => fretting_wear_in_words(f, &wear),
        (None, None, None) => writeln!(f, "wear              no closed form, or nothing wears"),
    }
}

fn groove_in_words(f: &mut Formatter<'_>, track: &OnTrack) -> fmt::Result {
    let [one, two] = track.volumes.map(|volume| three(volume * 1e9));
    writeln!(f, "worn volumes      {one} and {two} mm^3 at the end (k F s)")?;
    let WornTrack { scar_depth, groove_depth, extent: [_, width] } = track.worn;
    writeln!(
        f,
        "scar              {} deep, {} wide (rigid bodies)",
        length(scar_depth),
        length(width)
    )?;
    let section = three(track.section * 1e6);
    writeln!(f, "groove            {} deep, section {section} mm^2", length(groove_depth))
}

fn contact_in_words(f: &mut Formatter<'_>, contact: &Contact) -> fmt::Result {
    writeln!(f, "Hertz contact     {}", axes(contact.semi_axes))?;
    writeln!(f, "peak pressure     {}", pressure(contact.peak_pressure))?;
    if let Some(approach) = contact.approach {
        writeln!(f, "approach          {}", length(approach))?;
    }
    writeln!(f, "load              {} N", three(contact.load))
}

fn rolled_in_words(f: &mut Formatter<'_>, rolled: &RollingEstimate) -> fmt::Result {
    let [stick, creep] =
        if rolled.line { ["Carter"; 2] } else { ["strip theory", "Vermeulen-Johnson"] };
    if let Some(saturation) = rolled.saturation {
        let creepage = three(saturation.creepage);
        writeln!(f, "saturation        creepage {creepage} (all slips, mu a/R)")?;
    }
    if let Some(share) = rolled.stick_share {
        writeln!(f, "stick share       {} ({stick})", three(share))?;
    }
    if let Some(force) = rolled.linear_force {
        writeln!(f, "linear force      {} (Kalker)", forces(force))?;
    }
    if let Some(force) = rolled.force {
        writeln!(f, "creep force       {} ({creep})", forces(force))?;
    }
    if let Some(creepage) = rolled.free_creepage {
        writeln!(f, "free rolling      creepage {} (cylinders, mu to 0)", three(creepage))?;
    }
    Ok(())
}

fn warmth_in_words(f: &mut Formatter<'_>, warmth: &Warmth) -> fmt::Result {
    let peclet = three(warmth.peclet);
    match warmth.rise.map(|rise| rise.map(three)) {
        Some([largest, mean]) => writeln!(
            f,
            "flash temperature {largest} K at most, {mean} K in the mean (unworn, Peclet number {peclet})"
        ),
        None => writeln!(f, "Peclet number     {peclet}"),
    }
}

fn track_in_words(f: &mut Formatter<'_>, track: &Track) -> fmt::Result {
    let [depth, line_load] = [track.depth, track.line_load_depth].map(length);
    writeln!(f, "wear depth        {depth} at the end (incremental model)")?;
    writeln!(f, "                  {line_load} at the end (uniform line load)")?;
    let width = 2.0 * track.semi_axes[0].max(track.semi_axes[1]);
    writeln!(f, "worn track        {} wide at the end", length(width))
}

fn fretting_in_words(f: &mut Formatter<'_>, fretting: &Fretting) -> fmt::Result {
    let stick = match fretting.stick_radius {
        0.0 => "none at the turns: gross slip".to_owned(),
        radius => format!("radius {} at the turns", length(radius)),
    };
    writeln!(f, "stick zone        {stick} (Cattaneo-Mindlin)")?;
    let [shift, sliding] = [fretting.shift, fretting.contact.sliding_shift].map(length);
    writeln!(f, "shift             {shift} at the turns, all slips from {sliding} on")?;
    let [force, sliding] = [fretting.force, fretting.contact.sliding_force].map(three);
    writeln!(f, "tangential force  {force} N at the turns, {sliding} N if all slips")?;
    writeln!(f, "dissipated        {} J a cycle", three(fretting.dissipated))
}

fn fretting_wear_in_words(f: &mut Formatter<'_>, wear: &FrettingWear) -> fmt::Result {
    let [steady, last] = [wear.steady_volume, wear.end.volume()].map(|v| three(v * 1e9));
    writeln!(f, "worn volume       {steady} mm^3 at the rate of the first cycle")?;
    writeln!(f, "                  {last} mm^3 at most, once the stick zone bears the load")?;
    let [depth, radius] = [wear.end.greatest_depth(), wear.end.scar_radius].map(length);
    writeln!(f, "scar              {depth} deep, radius {radius} then")
}

/// Semi-axes (m) in words.
fn axes([x, y]: [f64; 2]) -> String {
    match (x.is_finite(), y.is_finite()) {
        (true, true) if (x - y).abs() < 1e-9 * x => format!("radius {}", length(x)),
        (true, true) => format!("semi-axes {} along x, {} along y", length(x), length(y)),
        (true, false) => format!("half width {} along x, a line along y", length(x)),
        (false, _) => format!("half width {} along y, a line along x", length(y)),
    }
}

/// Forces (N) along the direction of rolling and across, in words.
fn forces([along, across]: [f64; 2]) -> String {
    match across {
        0.0 => format!("{} N along", three(along)),
        _ => format!("{} N along, {} N across", three(along), three(across)),
    }
}
