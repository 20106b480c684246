//! Wear laws that are not linear in the pressure, or go by the work of friction.

use std::sync::Arc;

use approx::assert_relative_eq;
use archard::motion::Stepping;
use archard::simulation::refusal::Part;
use archard::simulation::{Error, Simulation};
use archard::wear::{Columns, Input, Per, Rubbing, WearLaw};

use crate::common::{Ball, Rows, case, peak, states};

/// k p (p / p_0)^(1/2) s.
#[derive(Debug)]
struct Power;

impl WearLaw for Power {
    fn depth(&self, Rubbing { pressure, slip, .. }: Rubbing) -> f64 {
        1.33e-13 * pressure * (pressure / 100e6).sqrt() * slip
    }
}

/// k (p - p_c) s beyond a threshold.
#[derive(Debug)]
struct Threshold;

impl WearLaw for Threshold {
    fn depth(&self, Rubbing { pressure, slip, .. }: Rubbing) -> f64 {
        1.33e-13 * (pressure - 30e6).max(0.0) * slip
    }
}

/// Every implicit step wears what the law says of the pressure at its end, and that pressure is a
/// contact of the worn surfaces: p >= 0, g >= 0, p g = 0 with the compliance applied anew.
#[test]
fn implicit_steps_obey_the_law_and_the_contact() {
    let laws: [fn() -> Box<dyn WearLaw>; 2] = [|| Box::new(Power), || Box::new(Threshold)];
    for law in laws {
        let step = 10e-3;
        let mut simulation = Ball::pin_on_disc(24).sliding(0.1, Stepping::Implicit(step), &[]);
        simulation.problem.bodies[0].wear = Some(law().into());
        let states = states(&simulation).unwrap();
        assert_eq!(states.len(), 11);
        for pair in states.windows(2) {
            let (before, after) = (&pair[0].0, &pair[1].0);
            let deepest = peak(&after.worn(0));
            let mut displacement = vec![0.0; after.pressure.len()];
            simulation.problem.compliance.apply_normal(&after.pressure, &mut displacement);
            for (i, &pressure) in after.pressure.iter().enumerate() {
                let worn = after.worn(0)[i] - before.worn(0)[i];
                let expected = law().depth(Rubbing::new(pressure, step));
                assert!((worn - expected).abs() < 1e-12 * deepest);
                let gap = simulation.problem.frame.gap()[i] + after.worn(0)[i] + displacement[i]
                    - after.approach;
                assert!(pressure >= 0.0 && gap > -1e-6 * deepest, "{gap:e}");
                assert!(
                    pressure == 0.0 || gap.abs() < 1e-6 * deepest,
                    "{gap:e} under {pressure:e}"
                );
            }
        }
    }
}

/// Depth = alpha times the work of friction, its slope left to the difference.
#[derive(Debug)]
struct Energy {
    /// alpha (1/Pa).
    alpha: f64,
}

impl WearLaw for Energy {
    fn inputs(&self) -> &'static [Input] {
        &[Input::Friction]
    }

    fn depth(&self, rubbing: Rubbing) -> f64 {
        self.alpha * rubbing.work
    }
}

fn rows(simulation: &Simulation) -> Rows {
    let mut rows = Rows::default();
    simulation.run(&mut [&mut rows]).expect("it converges");
    rows
}

const BODIES: &str = r#"
    [body.ball]
    material = { young = "210 GPa", poisson = 0.3 }
    profile.sphere = { radius = "50 mm" }
    wear.archard.coefficient = "3e-13 1/Pa"
    [body.flat]
    material = { young = "210 GPa", poisson = 0.3 }
    profile.flat = {}
    [friction.coulomb]
    coefficient = 0.3
    [frame]
    size = ["1 mm", "1 mm"]
    elements = [20, 20]
"#;

/// Where surfaces slide, or roll under Coulomb's law, an energy law is Archard's with k = alpha mu, implicit steps included:
/// its slope has to know that the limit of friction grows with the pressure.
#[test]
fn by_the_work_of_friction_is_archards_law_where_all_slides() {
    let rolls = |creepage: &str| {
        let motion = "[motion.rolling]\nload = \"20 N\"\nrevolutions = 300\nstep = 100";
        format!("{motion}\ncreepage = {creepage}")
    };
    let slides = "[motion.sliding]\nload = \"10 N\"\ndistance = \"0.3 m\"\nstep = \"60 mm\"";
    for motion in [slides.to_owned(), rolls("1.0"), rolls("0.002")] {
        let mut simulation = case(&format!("{BODIES}{motion}"), &[]);
        let archard = rows(&simulation);
        simulation.problem.bodies[0].wear = Some(Arc::new(Energy { alpha: 1e-12 }));
        let energy = rows(&simulation);
        for column in ["approach_m", "centre_pressure_Pa", "wear_depth_ball_m"] {
            let pairs = archard.column(column).into_iter().zip(energy.column(column));
            pairs.for_each(|(one, other)| assert_relative_eq!(one, other, max_relative = 1e-6));
        }
        assert!(archard.last("wear_depth_ball_m") > 1e-8, "{motion}");
    }
}

/// In fretting the worn volume is alpha times the work of the motion, in stick and slip; jumps wear as much.
#[test]
fn by_the_work_of_friction_wears_by_the_work_of_the_motion() {
    let motion = "[motion.fretting]\nload = \"10 N\"\namplitude = [\"0.3 um\", \"0 um\"]\ncycles = 40\nincrements = 20";
    let [every, jumps] = ["", "jump = 10"].map(|jumps| {
        let mut simulation = case(&format!("{BODIES}{motion}\n{jumps}"), &[]);
        simulation.problem.bodies[0].wear = Some(Arc::new(Energy { alpha: 1e-12 }));
        rows(&simulation)
    });
    let [force, shift] = ["force_x_N", "shift_x_m"].map(|column| every.column(column));
    let work = |end: usize| 0.5 * (force[end - 1] + force[end]) * (shift[end] - shift[end - 1]);
    // From the end of the first cycle on: what the bodies store on their way into it is no loss.
    let cycle = every.column("cycle");
    let first = cycle.iter().position(|&cycle| cycle == 1.0).expect("the end of the first cycle");
    let work: f64 = (first + 1..force.len()).map(work).sum();
    let volumes = every.column("worn_volume_ball_m3");
    let [volume, other] = [&every, &jumps].map(|rows| rows.last("worn_volume_ball_m3"));
    assert_relative_eq!((volume - volumes[first]) / (1e-12 * work), 1.0, max_relative = 0.001);
    // A jump goes on at the rate of the cycle before it, and the first cycles change most.
    assert_relative_eq!(other / volume, 1.0, max_relative = 0.02);
}

/// Without friction there is no work to go by.
#[test]
fn by_the_work_of_friction_asks_for_friction() {
    let motion = "[motion.sliding]\nload = \"10 N\"\ndistance = \"0.3 m\"\nstep = \"60 mm\"";
    let mut simulation = case(&format!("{BODIES}{motion}"), &["friction="]);
    simulation.problem.bodies[0].wear = Some(Arc::new(Energy { alpha: 1e-12 }));
    let refused = simulation.run(&mut []);
    assert!(
        matches!(&refused, Err(Error::Refused(all)) if all.0[0].part == Part::Wear("ball".into())),
        "{refused:?}"
    );
}

/// alpha (work - threshold) where that is positive, of what is taken at once; on whole columns.
#[derive(Debug)]
struct Beyond {
    /// alpha (1/Pa) and the threshold (J/m^2).
    alpha: f64,
    threshold: f64,
    per: Per,
}

impl WearLaw for Beyond {
    fn per(&self) -> Per {
        self.per
    }

    fn inputs(&self) -> &'static [Input] {
        &[Input::Friction]
    }

    fn depth(&self, rubbing: Rubbing) -> f64 {
        self.alpha * (rubbing.work - self.threshold).max(0.0)
    }

    fn depths(&self, points: &Columns, depths: &mut [f64], slopes: &mut [f64]) {
        assert!(points.len() == depths.len() && depths.len() == slopes.len());
        for (point, work) in points.work.iter().enumerate() {
            let rubbing = points.at(point);
            depths[point] = self.alpha * (work - self.threshold).max(0.0);
            slopes[point] = self.slope(rubbing);
        }
    }
}

/// Depths (m) worn off the ball between the first and the last state, by a law so weak that the contact stays.
fn worn(motion: &str, threshold: f64, per: Per) -> Vec<f64> {
    let mut simulation = case(&format!("{BODIES}{motion}"), &[]);
    simulation.problem.bodies[0].wear = Some(Arc::new(Beyond { alpha: 1e-18, threshold, per }));
    let states = states(&simulation).expect("it converges");
    let [first, last] = [states[0].0.worn(0), states[states.len() - 1].0.worn(0)];
    first.iter().zip(&*last).map(|(first, last)| last - first).collect()
}

/// A law that takes a cycle at once sees all the work that a point has gone through in it: a cycle of fretting, or a
/// passage of bodies that roll. One that is in proportion to the work does not mind.
#[test]
fn a_law_may_take_a_whole_cycle_at_once() {
    let fretting = "[motion.fretting]\nload = \"10 N\"\namplitude = [\"0.3 um\", \"0 um\"]";
    let rolling = "[motion.rolling]\nload = \"20 N\"\nrevolutions = 4\nstep = 4\ncreepage = 0.002";
    for (motion, cycles) in [(fretting, 1.0), (rolling, 4.0)] {
        let whole = worn(motion, 0.0, Per::Cycle);
        let parts = worn(motion, 0.0, Per::Increment);
        let most = peak(&whole);
        assert!(most > 0.0, "{motion}");
        for (one, other) in whole.iter().zip(&parts) {
            assert!((one - other).abs() < 1e-8 * most, "{motion}: {one:e}, {other:e}");
        }
        // Half of the largest work of a cycle (J/m^2).
        let threshold = 0.5 * most / 1e-18 / cycles;
        let beyond = worn(motion, threshold, Per::Cycle);
        let expected = |work: &f64| (work - 0.5 * most).max(0.0);
        for (found, whole) in beyond.iter().zip(&whole) {
            assert!((found - expected(whole)).abs() < 1e-6 * most, "{motion}: {found:e}");
        }
        assert!(peak(&beyond) > 0.4 * most, "{motion}");
        // No part of a cycle reaches it.
        assert_eq!(peak(&worn(motion, threshold, Per::Increment)), 0.0, "{motion}");
    }
}

/// Surfaces that stay and slide have no cycle.
#[test]
fn a_law_of_whole_cycles_asks_for_cycles() {
    let motion = "[motion.sliding]\nload = \"10 N\"\ndistance = \"0.3 m\"\nstep = \"60 mm\"";
    let mut simulation = case(&format!("{BODIES}{motion}"), &[]);
    let law = Beyond { alpha: 1e-12, threshold: 1.0, per: Per::Cycle };
    simulation.problem.bodies[0].wear = Some(Arc::new(law));
    let refused = simulation.run(&mut []);
    assert!(
        matches!(&refused, Err(Error::Refused(all)) if all.0[0].part == Part::Wear("ball".into())),
        "{refused:?}"
    );
}
