//! The estimate of a run, in the blocks of its summary.

use serde_json::{Map, Value, json};

use archard::estimate::{Course, Estimate, Estimator, Fretting, RollingEstimate, Subject};
use archard::simulation::Report;

/// What closed forms say of a report; null where the curvatures of the bodies are not known.
pub(super) fn of(report: &Report<'_>, estimator: &Estimator) -> Value {
    let course = Course {
        control: report.prescribed,
        progress: report.state.progress,
        load_distance: Some(report.effort.load_distance),
    };
    blocks(&estimator.of(&Subject::from(report.problem), &course))
}

/// The blocks of an estimate, those that are there.
pub(crate) fn blocks(estimate: &Estimate) -> Value {
    let Some(curvatures) = estimate.curvatures else { return Value::Null };
    let known = [
        ("curvatures_per_m", Some(json!(curvatures))),
        ("contact_modulus_Pa", Some(json!(estimate.contact_modulus))),
        ("hertz", hertz(estimate)),
        ("pin_on_disc", pin_on_disc(estimate)),
        ("worn_track", worn_track(estimate)),
        ("flash_temperature", flash_temperature(estimate)),
    ];
    let rolled = estimate.rolled.map(rolled).into_iter().flatten();
    let shifted = [
        ("fretting_wear", estimate.fretting.and_then(fretting_wear)),
        ("cattaneo_mindlin", estimate.fretting.map(cattaneo_mindlin)),
        ("spence", spence(estimate)),
    ];
    let all = known.into_iter().chain(rolled).chain(shifted);
    let there = all.filter_map(|(name, block)| Some((name.to_owned(), block?)));
    Value::Object(there.collect::<Map<_, _>>())
}

fn hertz(estimate: &Estimate) -> Option<Value> {
    let contact = estimate.contact?;
    Some(json!({
        "load_N": contact.load,
        "semi_axes_m": contact.semi_axes,
        "peak_pressure_Pa": contact.peak_pressure,
        "approach_m": contact.approach?,
    }))
}

fn pin_on_disc(estimate: &Estimate) -> Option<Value> {
    let cap = estimate.cap?;
    Some(json!({
        "radius_m": cap.radius,
        "coefficient_per_Pa": cap.coefficient,
        "volume_m3": cap.volume,
        "depth_m": cap.depth,
    }))
}

fn worn_track(estimate: &Estimate) -> Option<Value> {
    let track = estimate.track?;
    Some(json!({
        "scar_depth_m": track.worn.scar_depth,
        "groove_depth_m": track.worn.groove_depth,
        "groove_section_m2": track.section,
        "contact_length_m": track.worn.extent[0],
        "contact_width_m": track.worn.extent[1],
        "volumes_m3": track.volumes,
    }))
}

fn flash_temperature(estimate: &Estimate) -> Option<Value> {
    let warmth = estimate.warmth?;
    let [largest, mean] = warmth.rise.map_or([None; 2], |rise| rise.map(Some));
    Some(json!({
        "peclet_number": warmth.peclet,
        "largest_K": largest,
        "mean_K": mean,
    }))
}

fn rolled(rolled: RollingEstimate) -> [(&'static str, Option<Value>); 3] {
    let stick = rolled.stick_share.zip(rolled.relative_creepage).filter(|_| !rolled.line);
    let strip = stick.map(|(share, creepage)| {
        json!({
            "relative_creepage": creepage.abs(),
            "stick_share": share,
        })
    });
    let carter = rolled.saturation.map(|saturation| {
        json!({
            "friction_coefficient": saturation.friction,
            "half_width_m": saturation.half_width,
            "radius_m": saturation.radius,
            "saturation_creepage": saturation.creepage,
        })
    });
    let twin_discs = rolled.track.map(|track| {
        json!({
            "coefficient_per_Pa": track.discs.coefficient,
            "creepage": track.discs.creepage,
            "load_N": track.load,
            "crown_m": track.discs.crown,
            "half_width_m": track.discs.half_width,
            "revolutions": track.revolutions,
            "line_load_depth_m": track.line_load_depth,
            "incremental_depth_m": track.depth,
        })
    });
    [("strip", strip), ("carter", carter), ("twin_discs", twin_discs)]
}

fn fretting_wear(fretting: Fretting) -> Option<Value> {
    let end = fretting.wear?.end;
    Some(json!({
        "stick_radius_m": end.stick_radius,
        "approach_m": end.approach,
        "scar_radius_m": end.scar_radius,
        "wear_depth_m": end.greatest_depth(),
        "worn_volume_m3": end.volume(),
    }))
}

fn cattaneo_mindlin(fretting: Fretting) -> Value {
    json!({
        "axis": (["x", "y"][fretting.axis]),
        "load_N": fretting.load,
        "friction_coefficient": fretting.contact.friction,
        "contact_radius_m": fretting.contact.contact_radius,
        "peak_pressure_Pa": fretting.contact.peak_pressure,
        "sliding_force_N": fretting.contact.sliding_force,
        "sliding_shift_m": fretting.contact.sliding_shift,
        "force_amplitude_N": fretting.force,
        "shift_amplitude_m": fretting.shift,
        "stick_radius_m": fretting.stick_radius,
        "dissipated_per_cycle_J": fretting.dissipated,
    })
}

fn spence(estimate: &Estimate) -> Option<Value> {
    let pressed = estimate.pressed?;
    Some(json!({
        "coupling": pressed.coupling,
        "friction_coefficient": pressed.friction,
        "stick_ratio": pressed.stick_ratio,
        "approach_m": pressed.approach,
        "load_N": pressed.load,
        "contact_radius_m": pressed.contact_radius,
    }))
}
