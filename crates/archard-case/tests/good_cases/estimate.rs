//! What is said on paper: the same by `check` and in `summary.json`, and near what is computed on both sides of every
//! condition.

use approx::assert_relative_eq;
use archard::estimate::Estimate;
use serde_json::Value;

use super::curvatures::run;
use crate::common::Rows;
use crate::{PIN_ON_DISC, file, fretting, resolve};

/// What the case with these options says before the run, what its summary says, and the rows of the run.
fn said(text: &str, options: &[&str]) -> (Estimate, Value, Rows) {
    let resolved = resolve(&options.iter().fold(file(text), |file, option| file.set(*option)));
    let (summary, rows) = run(&resolved);
    (resolved.forecast.estimate, summary, rows)
}

/// A number of the summary is that of `check`, but for how it is written.
fn same(said: &Value, known: Option<f64>) {
    assert_eq!(said.is_number(), known.is_some());
    if let Some(known) = known {
        assert_relative_eq!(said.as_f64().unwrap(), known, max_relative = 1e-14);
    }
}

/// Young's moduli (GPa) of bodies with a Poisson ratio of 0.3 and this constant of Dundurs, as soft together as steel
/// on steel: (1/E1 - 1/E2) / (1/E1 + 1/E2) = 2 (1 - nu) beta / (1 - 2 nu).
fn unlike(beta: f64) -> [f64; 2] {
    let difference = 2.0 * 0.7 * beta / 0.4;
    [210.0 / (1.0 + difference), 210.0 / (1.0 - difference)]
}

/// A sphere that rolls and slips in part.
const ROLLING: &str = r#"
[body.one]
material = { young = "210 GPa", poisson = 0.3 }
profile.sphere = { radius = "20 mm" }
[body.two]
material = { young = "210 GPa", poisson = 0.3 }
profile.flat = {}
[frame]
size = ["0.4 mm", "0.4 mm"]
elements = [33, 33]
[friction.coulomb]
coefficient = 0.3
[motion.rolling]
load = "40 N"
creepage = 0.001
revolutions = 0
"#;

/// Bodies count as equal up to 0.01: the force and the energy of a cycle are still those of Cattaneo, Mindlin and
/// Deresiewicz (Johnson, eqs. 7.42 and 7.50).
#[test]
fn nearly_alike_bodies_fret_as_alike_ones() {
    for (beta, there) in [(0.0, true), (0.009, true), (0.02, false)] {
        let [one, two] = unlike(beta).map(|young| format!("material.young={young} GPa"));
        let options = [
            &*format!("body.ball.{one}"),
            &format!("body.flat.{two}"),
            "body.ball.wear=",
            "motion.fretting.cycles=2",
        ];
        let (estimate, summary, rows) = said(fretting::FRETTING, &options);
        let block = &summary["cattaneo_mindlin"];
        assert_eq!((estimate.fretting.is_some(), block.is_object()), (there, there), "{beta}");
        let Some(fretting) = estimate.fretting else { continue };
        same(&block["force_amplitude_N"], Some(fretting.force));
        let force = rows.column("force_x_N").into_iter().fold(0.0, f64::max);
        assert_relative_eq!(force, 30.0 * (1.0 - 0.216), max_relative = 0.01);
        // The second cycle; 20 increments cut the corners of its loop.
        assert_relative_eq!(rows.last("dissipated_J"), fretting.dissipated, max_relative = 0.05);
    }
}

/// The stretch of unlike surfaces works as another creepage. Where it is a hundredth of the one given, the force is that
/// of equal bodies; where it is a sixth, 5 % are missing.
#[test]
fn unlike_bodies_roll_as_alike_ones_where_they_creep_by_much_more() {
    for (beta, creepage, there) in [(0.001, 1e-3, true), (0.002, 1e-4, false)] {
        let at = |beta: f64| {
            let [one, two] = unlike(beta).map(|young| format!("material.young={young} GPa"));
            let creepage = format!("motion.rolling.creepage={creepage}");
            let options = [&*format!("body.one.{one}"), &format!("body.two.{two}"), &creepage];
            let (estimate, summary, rows) = said(ROLLING, &options);
            let rolled = estimate.rolled.unwrap();
            same(&summary["strip"]["stick_share"], rolled.stick_share);
            (rolled.force.is_some(), rolled.stick_share.is_some(), rows.last("force_x_N"))
        };
        let (unlike, alike) = (at(beta), at(0.0));
        assert_eq!((unlike.0, unlike.1), (there, there));
        assert_eq!((unlike.2 / alike.2 - 1.0).abs() < 0.01, there, "{unlike:?} {alike:?}");
    }
}

/// At a given approach the load falls with the wear: what is said is the unworn contact, by Hertz
/// F = 4/3 E* sqrt(R) d^(3/2), which the first increment has and the last has not.
#[test]
fn a_given_approach_tells_the_unworn_contact() {
    let options = [
        "motion.fretting.load=",
        "motion.fretting.approach=2.197 um",
        "motion.fretting.cycles=3",
        "motion.fretting.increments=8",
        "body.ball.wear.archard.coefficient=1e-10 1/Pa",
    ];
    let (estimate, summary, rows) = said(fretting::FRETTING, &options);
    let load = 4.0 / 3.0 * 210e9 / (2.0 * 0.91) * 0.1 * 2.197e-6f64.powf(1.5);
    let fretting = estimate.fretting.unwrap();
    assert_relative_eq!(fretting.load, load, max_relative = 1e-9);
    assert_eq!(fretting.wear, None);
    for block in ["hertz", "cattaneo_mindlin"] {
        assert_relative_eq!(summary[block]["load_N"].as_f64().unwrap(), load, max_relative = 1e-9);
    }
    let loads = rows.column("load_N");
    assert_relative_eq!(loads[0], load, max_relative = 0.01);
    assert!(rows.last("load_N") < 0.98 * load, "{}", rows.last("load_N"));
}

/// A cap of depth h on a paraboloid has the volume pi h^2 sqrt(Rx Ry); elasticity leaves 2 % of it.
#[test]
fn an_elliptic_pin_wears_as_a_sphere_of_the_mean_radius() {
    let options = [
        "body.pin.profile={paraboloid={radius_x=50 mm, radius_y=200 mm}}",
        "frame.size=[1.2 mm, 2.4 mm]",
        "motion.sliding.step=10 mm",
    ];
    let (estimate, summary, rows) = said(PIN_ON_DISC, &options);
    let depth = (1.33e-13 * 10.2 * 0.5 / (std::f64::consts::PI * 0.1)).sqrt();
    assert_relative_eq!(estimate.cap.unwrap().depth, depth, max_relative = 1e-4);
    assert_relative_eq!(summary["pin_on_disc"]["radius_m"].as_f64().unwrap(), 0.1);
    let known = summary["pin_on_disc"]["depth_m"].as_f64().unwrap();
    assert_relative_eq!(known, depth, max_relative = 1e-4);
    assert_relative_eq!(rows.last("wear_depth_m"), depth, max_relative = 0.02);
}

/// Published: 0.8 of the contact sticks at 0.23801 and 1.0389 times the load without friction at the same radius; bodies
/// that wear a little are no different.
#[test]
fn little_wear_leaves_spences_stick_zone() {
    let options = [
        "body.ball={rigid=true, profile={sphere={radius=10 mm}}}",
        "body.flat.wear.archard.coefficient=1e-13 1/Pa",
        "friction.coulomb.coefficient=0.23801",
        "motion={indentation={load=50 N, increments=20}}",
        "frame.size=[0.3 mm, 0.3 mm]",
        "frame.elements=[64, 64]",
    ];
    let (estimate, summary, rows) = said(fretting::FRETTING, &options);
    let pressed = estimate.pressed.unwrap();
    assert_relative_eq!(pressed.stick_ratio, 0.8, max_relative = 2e-4);
    let modulus = 210e9 / 0.91;
    let frictionless = 4.0 / 3.0 * modulus * pressed.contact_radius.powi(3) / 10e-3;
    assert_relative_eq!(pressed.load / frictionless, 1.0389, max_relative = 1e-4);
    assert_relative_eq!(pressed.load, 50.0, max_relative = 1e-12);
    assert_relative_eq!(rows.last("approach_m"), pressed.approach, max_relative = 5e-3);
    let sticks = (rows.last("stick_area_m2") / rows.last("contact_area_m2")).sqrt();
    assert_relative_eq!(sticks, 0.8, max_relative = 0.02);
    same(&summary["spence"]["stick_ratio"], Some(pressed.stick_ratio));
}

/// At a given approach the load of discs fades as they wear: from 300 N to 0.04 N over 30,000 revolutions, when models
/// under the last load say a sixtieth of the depth.
#[test]
fn discs_at_a_given_approach_have_no_model_of_wear() {
    let at = |options: &[&str]| {
        let options = [&["motion.rolling.revolutions=200"], options].concat();
        let (estimate, summary, _) = said(crate::TWIN_DISCS, &options);
        assert_eq!(estimate.rolled.unwrap().track.is_some(), summary["twin_discs"].is_object());
        estimate.rolled.unwrap().track.is_some()
    };
    assert!(at(&[]));
    assert!(!at(&["motion.rolling.load=", "motion.rolling.approach=4.18 um"]));
}
