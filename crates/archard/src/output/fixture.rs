//! A pin on a disc without a solver, for tests of the writers: Hertz's pressure on a growing scar
//! whose worn volumes close by construction.

use crate::body::{Body, Material, profile::PROFILES};
use crate::closed_form::pin_on_disc;
use crate::compliance::Compliance;
use crate::frame::{ContactFrame, VectorField};
use crate::kinematics::MOTIONS;
use crate::parameters::{Choice, Value, Values};
use crate::problem::{ContactProblem, ContactState};
use crate::simulation::{Effort, Observer, Report};
use crate::wear::WEAR_LAWS;

/// Bodies that do not deform.
#[derive(Debug)]
struct Stiff;

impl Compliance for Stiff {
    fn apply(&self, tractions: &VectorField) -> VectorField {
        VectorField::zeros(tractions.n.len())
    }

    fn normal_self_term(&self) -> f64 {
        0.0
    }
}

/// Builds the choice of that name.
fn build<T>(choices: &[Choice<T>], name: &str, numbers: &[(&'static str, f64)]) -> T {
    let mut values = Values::default();
    numbers.iter().for_each(|(name, number)| values.insert(name, Value::Number(*number)));
    let choice = choices.iter().find(|choice| choice.name == name).expect(name);
    (choice.build)(&values).expect(name)
}

/// Load (N).
pub(super) const LOAD: f64 = 10.2;
/// Wear coefficients of pin and disc (1/Pa).
pub(super) const COEFFICIENTS: [f64; 2] = [1e-13, 0.33e-13];

/// A made-up run of a pin on a disc.
pub(super) struct Run {
    /// A sphere of 50 mm on a flat, both of steel and both wearing.
    pub(super) problem: ContactProblem,
}

impl Run {
    /// The run on a frame of 1.2 mm with that many elements.
    pub(super) fn pin_on_disc(elements: [usize; 2]) -> Self {
        let body = |name: &str, profile, k| Body {
            name: name.to_owned(),
            profile,
            material: Some(Material { young: 210e9, poisson: 0.3 }),
            wear: Some(build(WEAR_LAWS, "archard", &[("coefficient", k)])),
        };
        let sphere = build(PROFILES, "sphere", &[("radius", 50e-3)]);
        let flat = build(PROFILES, "flat", &[]);
        let motion = [("load", LOAD), ("distance", 0.5), ("step", 5e-3)];
        let frame = ContactFrame::uniform([1.2e-3; 2], elements, [&*sphere, &*flat]);
        Self {
            problem: ContactProblem {
                bodies: [body("pin", sphere, COEFFICIENTS[0]), body("disc", flat, COEFFICIENTS[1])],
                frame: frame.expect("the sphere reaches"),
                compliance: Box::new(Stiff),
                friction: None,
                kinematics: build(MOTIONS, "sliding", &motion).kinematics,
            },
        }
    }

    /// The state after that distance (m).
    pub(super) fn state(&self, distance: f64) -> ContactState {
        let frame = &self.problem.frame;
        let depth = pin_on_disc::depth(50e-3, COEFFICIENTS[0] * LOAD * distance);
        let radius = (0.15e-3_f64.powi(2) + 2.0 * 50e-3 * depth).sqrt();
        let bowl: Vec<f64> = (0..frame.len())
            .map(|pair| {
                let [x, y] = frame.place(pair);
                (1.0 - (x * x + y * y) / (radius * radius)).max(0.0).sqrt()
            })
            .collect();
        let share = 1.0 / frame.integrate(&bowl);
        let scaled = |factor: f64| bowl.iter().map(|value| factor * share * value).collect();
        ContactState {
            progress: distance,
            approach: 0.44e-6 + depth,
            load: LOAD,
            pressure: scaled(LOAD),
            gap: bowl
                .iter()
                .zip(frame.gap())
                .map(|(b, gap)| if *b > 0.0 { 0.0 } else { *gap })
                .collect(),
            worn: COEFFICIENTS.map(|k| scaled(k * LOAD * distance)),
            tangential: None,
        }
    }

    /// Shows an observer the states at these distances (m), each an output where `output` says so.
    pub(super) fn show(
        &self,
        observer: &mut dyn Observer,
        distances: &[f64],
        output: impl Fn(f64) -> bool,
    ) {
        for (step, &distance) in distances.iter().enumerate() {
            let state = self.state(distance);
            let effort = Effort {
                steps: step,
                solves: step + 1,
                iterations: 10,
                applications: 11 * (step + 1),
                residual: 1e-9,
                load_distance: LOAD * distance,
                ..Effort::default()
            };
            let report = Report {
                problem: &self.problem,
                state: &state,
                effort,
                output: output(distance),
                extent: 0.5,
            };
            observer.observe(&report).expect("the temporary folder takes files");
        }
    }
}
