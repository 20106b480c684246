//! Wear by the work of friction over the contact, T gamma / A, through whole runs.

use approx::assert_relative_eq;

use super::wear_laws::{BODIES, ROLLS, agree, run};
use crate::common::{Rows, case};

/// Wear of an element by T gamma / A (m per m rolled), x in Pa.
fn t_gamma(x: f64) -> f64 {
    let x = 1e-6 * x;
    1e-3 / 7850.0 * ((5.3 * x).min(55.0) + 61.9 * (x - 77.2).max(0.0))
}

/// A line contact that slips all over wears by x = mu p times the slip over the distance rolled, integrated over Hertz's
/// pressures. That slip is the creepage and, under the tractions mu p, mu a / R times the place from the middle over a.
#[test]
fn t_gamma_wears_a_line_contact_by_its_local_work() {
    let discs = |elements: usize, creepage: f64| {
        let text = format!(
            r#"
            [body.wheel]
            material = {{ young = "210 GPa", poisson = 0.3 }}
            profile.cylinder = {{ radius = "23.5 mm", axis = "y" }}
            wear.t_gamma.density = "7850 kg/m^3"
            [body.rail]
            material = {{ young = "210 GPa", poisson = 0.3 }}
            profile.cylinder = {{ radius = "23.5 mm", axis = "y" }}
            [frame]
            size = "0.8 mm"
            elements = {elements}
            length = "10 mm"
            [friction.coulomb]
            coefficient = 0.4
            [motion.rolling]
            load = "7338 N"
            creepage = {creepage}
            revolutions = 1e-3
            step = 1e-3
            "#
        );
        let mut rows = Rows::default();
        case(&text, &[]).run(&mut [&mut rows]).expect("it converges");
        1e3 * rows.last("wear_depth_wheel_m")
    };
    // Hertz: E* = 115.385 GPa, R = 11.75 mm, F / L = 733.8 N/mm.
    let (modulus, radius, load) = (0.5 * 210e9 / (1.0 - 0.09), 11.75e-3, 733.8e3);
    let half = (4.0 * load * radius / (std::f64::consts::PI * modulus)).sqrt();
    let peak = 2.0 * load / (std::f64::consts::PI * half);
    for creepage in [0.015, 0.03, 0.05, 0.2] {
        let parts = 20000;
        let place = |part: i32| (f64::from(part) + 0.5) / f64::from(parts) * 2.0 - 1.0;
        let pressure = |part: i32| peak * (1.0 - place(part).powi(2)).sqrt();
        let slip = |part: i32| creepage + 0.4 * half / radius * place(part);
        let depths = (0..parts).map(|part| t_gamma(0.4 * pressure(part) * slip(part)));
        let expected = depths.sum::<f64>() * 2.0 * half / f64::from(parts);
        let [coarse, fine] = [100, 200].map(|elements| discs(elements, creepage));
        assert_relative_eq!(coarse / expected, 1.0, max_relative = 1e-3);
        assert_relative_eq!(fine / expected, 1.0, max_relative = 3e-4);
    }
}

/// Where a part of the contact sticks, the law sees the work of the elements that slip: while all of it is mild, the worn
/// section is alpha times the work of the creepage.
#[test]
fn t_gamma_in_the_mild_regime_wears_by_the_work_of_the_creepage() {
    let motion = ROLLS.replace("creepage = 1", "creepage = 0.0005");
    let (_, energy) = run("energy.coefficient = \"6.751592357e-4 mm^3/J\"", "flat", &motion);
    let (_, local) = run("t_gamma.density = \"7850 kg/m^3\"", "flat", &motion);
    agree(&energy[1], &local[1], 1e-6);
}

/// The worn section converges as passages are divided into more elements, which all slip by their own work.
#[test]
fn t_gamma_does_not_depend_on_how_passages_are_divided() {
    let depth = |elements: usize| {
        let motion = ROLLS.replace("creepage = 1", "creepage = 0.3");
        let frame = format!("elements = [{elements}, 20]");
        let bodies = BODIES.replace("elements = [20, 20]", &frame);
        let bodies =
            bodies.replace("[body.ball]", "[body.ball]\nwear.t_gamma.density = \"7850 kg/m^3\"");
        let mut rows = Rows::default();
        let motion =
            motion.replace("revolutions = 30\nstep = 5", "revolutions = 1e-3\nstep = 1e-3");
        case(&format!("{bodies}{motion}"), &[]).run(&mut [&mut rows]).expect("it converges");
        rows.last("worn_section_ball_m2")
    };
    let finest = depth(160);
    assert_relative_eq!(depth(40) / finest, 1.0, max_relative = 0.02);
    assert_relative_eq!(depth(80) / finest, 1.0, max_relative = 0.01);
}
