//! A pin on a disc, one that frets and twin discs without a solver, for tests of the writers: bowls of pressure on
//! growing scars whose worn volumes or sections close by construction.

use std::sync::Arc;

use archard::body::{Body, Material, Profile, profile::PROFILES};
use archard::closed_form::pin_on_disc;
use archard::compliance::Compliance;
use archard::frame::{ContactFrame, Direction, VectorField};
use archard::friction::{FRICTION as FRICTION_LAWS, Grip};
use archard::motion::{Control, Drive, MOTIONS, Rolling, Sequence, Slip, Stepping};
use archard::parameters::{Choice, Value, Values};
use archard::problem::{ContactProblem, ContactState, Surface, Tangential, UnwornRecess};
use archard::simulation::{Effort, Observer, Report};
use archard::wear::WEAR_LAWS;

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

    fn couples(&self) -> bool {
        false
    }
}

/// Builds the choice of that name.
pub(super) fn build<T>(choices: &[Choice<T>], name: &str, numbers: &[(&'static str, f64)]) -> T {
    let mut values = Values::default();
    numbers.iter().for_each(|(name, number)| values.insert(name, Value::Number(*number)));
    let choice = choices.iter().find(|choice| choice.name == name).expect(name);
    (choice.build)(&values).expect(name)
}

/// Load (N).
pub(super) const LOAD: f64 = 10.2;
/// Wear coefficients of body 1 and body 2 (1/Pa).
pub(super) const COEFFICIENTS: [f64; 2] = [1e-13, 0.33e-13];
/// Creepage of the twin discs.
pub(super) const CREEPAGE: f64 = 0.005;
/// Coefficient of friction of the twin discs.
pub(super) const FRICTION: f64 = 0.6;
/// Amplitude of the pin that frets (m).
pub(super) const AMPLITUDE: f64 = 0.06e-6;
/// What it dissipates a cycle (J).
pub(super) const DISSIPATED: f64 = 7e-9;
/// Crown of the first disc (m).
pub(super) const CROWN: f64 = 125e-3;

/// A steel body that wears.
fn body(name: &str, profile: Box<dyn Profile>, coefficient: f64) -> Body {
    Body {
        name: name.to_owned(),
        profile: profile.into(),
        finite: None,
        material: Some(Material { young: 210e9, poisson: 0.3 }),
        layers: vec![],
        wear: Some(build(WEAR_LAWS, "archard", &[("coefficient", coefficient)]).into()),
        depth: None,
        density: None,
        indentation_hardness: None,
        hardness: None,
        thermal: None,
    }
}

/// A made-up run.
pub(super) struct Run {
    /// Two bodies of steel, both wearing.
    pub(super) problem: ContactProblem,
}

impl Run {
    /// A sphere of 50 mm on a flat, on a frame of 1.2 mm with that many elements.
    pub(super) fn pin_on_disc(elements: [usize; 2]) -> Self {
        let sphere = build(PROFILES, "sphere", &[("radius", 50e-3)]);
        let flat = build(PROFILES, "flat", &[]);
        let motion = [("load", LOAD), ("distance", 0.5), ("step", 5e-3)];
        let frame = ContactFrame::uniform([1.2e-3; 2], elements, [&*sphere, &*flat]);
        Self {
            problem: ContactProblem {
                bodies: [body("pin", sphere, COEFFICIENTS[0]), body("disc", flat, COEFFICIENTS[1])],
                frame: frame.expect("the sphere reaches"),
                compliance: Arc::new(Stiff),
                friction: None,
                motion: build(MOTIONS, "sliding", &motion).0,
                unworn: UnwornRecess::default(),
            },
        }
    }

    /// The same sphere on a track of the disc, which passes.
    pub(super) fn pin_on_track(elements: [usize; 2]) -> Self {
        let mut values = Values::default();
        let numbers = [("load", LOAD), ("distance", 0.5), ("step", 5e-3), ("track_radius", 10e-3)];
        numbers.iter().for_each(|(name, number)| values.insert(name, Value::Number(*number)));
        values.insert("passes", Value::Body(1, "disc".to_owned()));
        let motion = MOTIONS.iter().find(|motion| motion.name == "sliding").expect("sliding");
        let (motion, _) = (motion.build)(&values).expect("a track");
        Self { problem: ContactProblem { motion, ..Self::pin_on_disc(elements).problem } }
    }

    /// The same sphere with friction, fretting along x in cycles of 8 increments.
    pub(super) fn fretting(elements: [usize; 2]) -> Self {
        let mut values = Values::default();
        values.insert("load", Value::Number(LOAD));
        values.insert("amplitude", Value::Pair([AMPLITUDE, 0.0]));
        values.insert("increments", Value::Number(8.0));
        let motion = MOTIONS.iter().find(|motion| motion.name == "fretting").expect("fretting");
        let (motion, _) = (motion.build)(&values).expect("fretting");
        let mut run = Self::pin_on_disc(elements);
        run.problem.friction =
            Some(build(FRICTION_LAWS, "coulomb", &[("coefficient", FRICTION)]).into());
        run.problem.motion = motion;
        run
    }

    /// A rigid sphere that is only pressed on, with friction and without wear.
    pub(super) fn pressed(elements: [usize; 2], friction: f64) -> Self {
        let mut run = Self::pin_on_disc(elements);
        run.problem.bodies[0].material = None;
        run.problem.bodies.iter_mut().for_each(|body| body.wear = None);
        run.problem.friction =
            Some(build(FRICTION_LAWS, "coulomb", &[("coefficient", friction)]).into());
        run.problem.motion = build(MOTIONS, "indentation", &[("load", LOAD)]).0;
        run
    }

    /// Discs of 30 mm, the first crowned, on a frame of 0.5 mm by 2 mm with that many elements.
    pub(super) fn twin_discs(elements: [usize; 2], direction: Direction) -> Self {
        let crowned = build(PROFILES, "disc", &[("radius", 30e-3), ("crown", CROWN)]);
        let plain = build(PROFILES, "disc", &[("radius", 30e-3)]);
        let frame = ContactFrame::uniform([0.5e-3, 2e-3], elements, [&*crowned, &*plain]);
        let rolling = Rolling::along(direction).longitudinal(Drive::Slip(CREEPAGE));
        let planned = rolling.over(1.0, Control::Load(LOAD), Stepping::Implicit(1.0));
        Self {
            problem: ContactProblem {
                bodies: [
                    body("one", crowned, COEFFICIENTS[0]),
                    body("two", plain, COEFFICIENTS[1]),
                ],
                frame: frame.expect("the discs reach"),
                compliance: Arc::new(Stiff),
                friction: Some(
                    build(FRICTION_LAWS, "coulomb", &[("coefficient", FRICTION)]).into(),
                ),
                motion: planned.expect("a motion").0,
                unworn: UnwornRecess::default(),
            },
        }
    }

    /// The state at that progress (m or revolutions).
    pub(super) fn state(&self, progress: f64) -> ContactState {
        let motion = &self.problem.motion;
        match (&motion.slip, &motion.sequence) {
            (Slip::Given(..), _) => self.slid(progress),
            (Slip::Sought(_), Sequence::Cycle(_)) => self.fretted(progress),
            (Slip::Sought(_), _) => self.rolled(motion.direction, progress),
        }
    }

    /// Load times distance (N m), or work of the creepage over friction (N).
    pub(super) fn load_distance(&self, progress: f64) -> f64 {
        match &self.state(progress).tangential {
            Some(tangential) if self.problem.motion.driven(0.0).is_some() => {
                let [along_x, along_y] = tangential.force(&self.problem.frame);
                CREEPAGE * along_x.hypot(along_y) / FRICTION * progress
            }
            _ => LOAD * progress,
        }
    }

    /// The pin after some cycles: its tractions are half of what friction allows, at most.
    fn fretted(&self, cycles: f64) -> ContactState {
        let state = self.slid(0.0);
        let wave = (std::f64::consts::TAU * cycles).sin();
        let scaled = |factor: f64| -> Vec<f64> {
            state.pressure.iter().map(|pressure| factor * pressure).collect()
        };
        let none = || vec![0.0; state.pressure.len()];
        let tangential = Tangential {
            traction: [scaled(0.5 * FRICTION * wave), none()],
            slip: [none(), none()],
            creepage: [0.0; 2],
            shift: [AMPLITUDE * wave, 0.0],
            grip: Grip::default(),
        };
        ContactState { progress: cycles, tangential: Some(tangential), ..state }
    }

    /// Discs after some revolutions: the leading half of the contact bears half of what friction allows,
    /// and every line wears as its tractions have it.
    fn rolled(&self, direction: Direction, revolutions: f64) -> ContactState {
        let frame = &self.problem.frame;
        let (forward, elements) = (direction.forward(), frame.elements());
        let bowl = |pair: usize| {
            let [x, y] = frame.place(pair);
            (1.0 - (x / 0.15e-3).powi(2) - (y / 0.6e-3).powi(2)).max(0.0).sqrt()
        };
        let bowl: Vec<f64> = (0..frame.len()).map(bowl).collect();
        let peak = LOAD / frame.integrate(&bowl);
        let pressure: Vec<f64> = bowl.iter().map(|bowl| peak * bowl).collect();
        let traction = |pair: usize| {
            let [x, y] = frame.place(pair);
            let leads = x * forward[0] + y * forward[1] > 0.0;
            FRICTION * pressure[pair] * if leads { 0.5 } else { 1.0 }
        };
        let traction: Vec<f64> = (0..frame.len()).map(traction).collect();
        let advance = frame.flow(direction).unwrap().advance();
        let mut worn = [vec![0.0; frame.len()], vec![0.0; frame.len()]];
        for line in direction.lines(elements) {
            let sum: f64 = line.clone().map(|pair| traction[pair]).sum();
            let work = revolutions * CREEPAGE * sum * advance / FRICTION;
            for pair in line {
                worn.iter_mut().zip(COEFFICIENTS).for_each(|(worn, k)| worn[pair] = k * work);
            }
        }
        let along = |values: &[f64], factor: f64| {
            forward.map(|unit| values.iter().map(|value| factor * unit * value).collect())
        };
        let slip = along(&vec![1.0; frame.len()], CREEPAGE * advance);
        ContactState {
            progress: revolutions,
            load: LOAD,
            tangential: Some(Tangential {
                traction: along(&traction, 1.0),
                slip,
                creepage: [CREEPAGE, 0.0],
                shift: [0.0; 2],
                grip: Grip::default(),
            }),
            pressure,
            surfaces: worn.map(|depth| Surface::of_pairs(frame.elements(), depth)),
            ..ContactState::untouched(frame)
        }
    }

    /// The pin after that distance (m).
    fn slid(&self, distance: f64) -> ContactState {
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
                .collect::<Vec<_>>()
                .into(),
            surfaces: COEFFICIENTS
                .map(|k| Surface::of_pairs(frame.elements(), scaled(k * LOAD * distance))),
            tangential: None,
        }
    }

    /// Shows an observer the states at this progress, each an output where `output` says so.
    pub(super) fn show(
        &self,
        observer: &mut dyn Observer,
        places: &[f64],
        output: impl Fn(f64) -> bool,
    ) {
        for (step, &progress) in places.iter().enumerate() {
            let state = self.state(progress);
            let effort = Effort {
                steps: step,
                solves: step + 1,
                iterations: 10,
                applications: 11 * (step + 1),
                residual: 1e-9,
                load_distance: self.load_distance(progress),
                true_cycles: progress as usize,
                dissipated: [DISSIPATED * progress.fract(), DISSIPATED * progress],
                ..Effort::default()
            };
            let report = Report {
                problem: &self.problem,
                state: &state,
                effort,
                output: output(progress),
                extent: places.last().copied().unwrap_or_default(),
                prescribed: Control::Load(state.load),
                stepping: Stepping::Implicit(1.0),
                companions: None,
                again: false,
                march: None,
            };
            observer.observe(&report).expect("the temporary folder takes files");
        }
    }
}
