//! Problems the tests are made of.

#![allow(dead_code, reason = "every test binary uses a part of it")]

pub mod dense;

use std::sync::Arc;

use archard::body::profile::{Flat, Paraboloid};
use archard::body::{Body, Material};
use archard::frame::ContactFrame;
use archard::motion::{Control, Schedule, Sliding, Stepping};
use archard::parameters::{Choice, Value, Values};
use archard::problem::{ContactProblem, ContactState, Surface, Tangential};
use archard::simulation::history::number;
use archard::simulation::{Effort, Error, Observer, Report, Simulation, row};
use archard::solve::{ConjugateGradient, SOLVERS, Settings, Solver, Step};
use archard::wear::Archard;
use archard_case::{CaseFile, RunnableCase};

/// The steel of the reference problems.
pub const STEEL: Material = Material { young: 210e9, poisson: 0.3 };

/// Builds the entry of a list from numbers (SI).
pub fn choose<T>(list: &[Choice<T>], name: &str, numbers: &[(&'static str, f64)]) -> T {
    let mut values = Values::default();
    for (name, number) in numbers {
        values.insert(name, Value::Number(*number));
    }
    let choice = list.iter().find(|choice| choice.name == name).expect("a listed name");
    (choice.build)(&values).expect("valid values")
}

/// A solver of that name with that tolerance.
pub fn solver(name: &str, tolerance: f64) -> Box<dyn Solver> {
    choose(SOLVERS, name, &[("tolerance", tolerance)])
}

/// A ball (or paraboloid) on a flat.
#[derive(Debug, Clone, Copy)]
pub struct Ball {
    /// Radii of curvature along x and y (m).
    pub radii: [f64; 2],
    /// Materials of body 1 and body 2.
    pub materials: [Option<Material>; 2],
    /// Size of the frame (m).
    pub size: [f64; 2],
    /// Elements of the frame.
    pub elements: [usize; 2],
    /// Wear coefficients of body 1 and body 2 (1/Pa).
    pub wear: [f64; 2],
    /// Load or approach.
    pub control: Control,
    /// Tolerance of the contact solver.
    pub solver_tolerance: f64,
}

impl Ball {
    /// The pin on disc of the paper's section 6.2.
    pub fn pin_on_disc(elements: usize) -> Self {
        Self {
            radii: [0.05; 2],
            materials: [Some(STEEL); 2],
            size: [1.2e-3; 2],
            elements: [elements; 2],
            wear: [1.33e-13, 0.0],
            control: Control::Load(10.2),
            solver_tolerance: 1e-8,
        }
    }

    /// The bodies in contact.
    pub fn problem(&self) -> ContactProblem {
        self.sliding(1.0, Stepping::Explicit(1.0), &[]).problem
    }

    /// Its sliding over an extent (m) with outputs there (m).
    pub fn sliding(&self, extent: f64, stepping: Stepping, outputs: &[f64]) -> Simulation {
        let paraboloid = Paraboloid::new(self.radii).expect("radii");
        let mut bodies = [Body::new("pin", paraboloid), Body::new("disc", Flat)];
        for (index, body) in bodies.iter_mut().enumerate() {
            body.material = self.materials[index];
            let law = Some(self.wear[index]).filter(|&coefficient| coefficient > 0.0);
            body.wear = law.map(|k| Arc::new(Archard::new(k).expect("a coefficient")) as _);
        }
        let once = Sliding::new().over(1.0, Control::Load(1.0), Stepping::ToOutputs);
        let (motion, _) = once.expect("a motion");
        let planned = (motion, Schedule::steady(self.control, extent, stepping));
        let settings = Settings::new(self.solver_tolerance, 500).expect("a tolerance");
        let builder = Simulation::builder(bodies, planned).frame(self.size, self.elements);
        let simulation = builder.solver(ConjugateGradient::new(settings)).build();
        let mut simulation = simulation.expect("paraboloids have no end");
        simulation.schedule.outputs = outputs.to_vec();
        simulation
    }

    /// Its contact, unworn.
    pub fn contact(&self) -> ContactState {
        let simulation = self.sliding(1e-9, Stepping::Explicit(1e-9), &[]);
        let mut states = States::of(&simulation);
        simulation.run(&mut [&mut states]).expect("a contact that converges");
        states.0.swap_remove(0).0
    }
}

/// The simulation of a case file with that text and these options.
pub fn case(text: &str, options: &[&str]) -> Simulation {
    resolved(text, options).case.build().expect("a checked case")
}

/// The same, checked.
pub fn resolved(text: &str, options: &[&str]) -> RunnableCase {
    let file = CaseFile::from_text("case", text, ".");
    let file = options.iter().fold(file, |file, option| file.set(*option));
    file.resolve().unwrap_or_else(|problems| {
        let described: Vec<String> =
            problems.iter().map(|problem| file.describe(problem)).collect();
        panic!("{}", described.join("\n"))
    })
}

/// A step of a problem at rest, under its control.
pub fn at_rest<'a>(problem: &'a ContactProblem, addition: &'a [f64], control: Control) -> Step<'a> {
    Step {
        compliance: &*problem.compliance,
        gap: problem.frame.gap(),
        addition,
        elements: problem.frame.elements(),
        measure: problem.frame.measure(),
        control,
        hardness: f64::INFINITY,
    }
}

/// Keeps every state with what it took, and whether it was due for output.
#[derive(Debug)]
pub struct States(pub Vec<(ContactState, Effort, bool)>, ContactFrame);

impl States {
    /// None yet; they lie in the frame of a simulation.
    pub fn of(simulation: &Simulation) -> Self {
        Self(vec![], simulation.problem.frame.clone())
    }
}

impl Observer for States {
    fn observe(
        &mut self,
        report: &Report<'_>,
    ) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
        self.0.push((within(&self.1, report), report.effort, report.output));
        Ok(())
    }
}

/// Runs to the end and returns all states, in the frame of the simulation: where that has grown, nothing touches beyond.
pub fn states(simulation: &Simulation) -> Result<Vec<(ContactState, Effort, bool)>, Error> {
    let mut states = States::of(simulation);
    simulation.run(&mut [&mut states])?;
    Ok(states.0)
}

/// The part of a state that lies in a frame.
fn within(frame: &ContactFrame, report: &Report<'_>) -> ContactState {
    let (state, larger) = (report.state, &report.problem.frame);
    if larger.len() == frame.len() {
        return state.clone();
    }
    let (elements, spacing) = (frame.elements(), frame.spacing());
    let first = [0, 1].map(|axis| {
        let apart = frame.rectangle().corner()[axis] - larger.rectangle().corner()[axis];
        (apart / spacing[axis]).round() as usize
    });
    let cut = |field: &[f64]| -> Vec<f64> {
        let pair = |own: usize| {
            let [x, y] = [own % elements[0] + first[0], own / elements[0] + first[1]];
            field[x + larger.elements()[0] * y]
        };
        if field.is_empty() { vec![] } else { (0..frame.len()).map(pair).collect() }
    };
    let both = |fields: &[Vec<f64>; 2]| fields.each_ref().map(|field| cut(field));
    let pressure = cut(&state.pressure);
    let pressed = |field: &[f64]| field.iter().filter(|pressure| **pressure > 0.0).count();
    assert_eq!(pressed(&pressure), pressed(&state.pressure), "pairs touch beyond the frame");
    ContactState {
        pressure,
        gap: cut(&state.gap_of(report.problem)).into(),
        surfaces: [0, 1].map(|body| Surface {
            slid: cut(&state.surfaces[body].distance()),
            ..Surface::of_pairs(frame.elements(), cut(&state.worn(body)))
        }),
        tangential: state.tangential.as_ref().map(|own| Tangential {
            traction: both(&own.traction),
            slip: both(&own.slip),
            grip: own.grip.map(cut),
            ..own.clone()
        }),
        ..state.clone()
    }
}

/// Deepest total wear (m).
pub fn depth(state: &ContactState) -> f64 {
    peak(&state.total_worn())
}

/// Largest value.
pub fn peak(field: &[f64]) -> f64 {
    field.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

/// Keeps the rows of a run.
#[derive(Debug, Default)]
pub struct Rows(pub Vec<Vec<(String, f64)>>);

impl Observer for Rows {
    fn observe(
        &mut self,
        report: &Report<'_>,
    ) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
        self.0.push(row(report));
        Ok(())
    }
}

impl Rows {
    /// A column.
    pub fn column(&self, name: &str) -> Vec<f64> {
        let value = |row: &Vec<_>| number(row, name).expect("a column of that name");
        self.0.iter().map(value).collect()
    }

    /// The last value of a column.
    pub fn last(&self, name: &str) -> f64 {
        *self.column(name).last().expect("a row")
    }
}
