//! Surfaces that repeat themselves, against closed forms and half-spaces.

use std::f64::consts::PI;
use std::fmt::Write;

use approx::assert_relative_eq;
use archard::body::Layer;
use archard::body::profile::{Flat, Paraboloid, Wave};
use archard::closed_form::hertz::Hertz;
use archard::compliance::{Compliance, HalfSpace, Periodic};
use archard::elastic::{Point, Response, Section};
use archard::frame::{ContactFrame, VectorField};
use archard::motion::{Control, Indentation};
use archard::problem::ContactState;
use archard::simulation::Run;
use archard::{Body, Contact, Material, Simulation};
use archard_case::CaseFile;

use super::accuracy::settled;
use crate::common::{case, states};

const LENGTH: f64 = 1e-3;
const AMPLITUDE: f64 = 0.5e-6;

fn steel() -> Material {
    Material::new(210e9, 0.3).unwrap()
}

/// E* of steel on something rigid, and the mean pressure that flattens waves of amplitude a, pi E* a / length.
fn flattening() -> [f64; 2] {
    let modulus = 210e9 / 0.91;
    [modulus, PI * modulus * AMPLITUDE / LENGTH]
}

/// A wave on something rigid under a mean pressure, on so many strips.
fn wavy(pressure: f64, elements: usize) -> (Simulation, ContactState) {
    let wavy = Body::new("wavy", Wave::new(AMPLITUDE, [Some(LENGTH), None]).unwrap());
    let planned = Indentation::new(1).under(Control::Load(pressure * LENGTH)).unwrap();
    let simulation =
        Simulation::builder([wavy.material(steel()), Body::new("flat", Flat)], planned)
            .line([LENGTH, 1.0], elements)
            .periodic()
            .build()
            .unwrap();
    let (state, ..) = states(&simulation).unwrap().pop().unwrap();
    (simulation, state)
}

/// H. M. Westergaard, *J. Appl. Mech.* 6 (1939) A49: flattened altogether, p = mean + p* cos(2 pi x/length).
#[test]
fn flattened_waves_have_the_pressure_of_a_cosine() {
    let [_, flattens] = flattening();
    let (simulation, state) = wavy(1.25 * flattens, 64);
    for (pair, pressure) in state.pressure.iter().enumerate() {
        let [x, _] = simulation.problem.frame.place(pair);
        let known = flattens * (1.25 + (2.0 * PI * x / LENGTH).cos());
        assert_relative_eq!(*pressure, known, max_relative = 1e-6);
    }
}

/// Below them (K. L. Johnson, *Contact Mechanics*, 1985, section 13.2), at places and on a section, of the pressures that were computed.
#[test]
fn flattened_waves_have_the_stresses_and_displacements_of_a_cosine_below() {
    let [modulus, flattens] = flattening();
    let wavy = Body::new("wavy", Wave::new(AMPLITUDE, [Some(LENGTH), None]).unwrap());
    let bodies = [wavy.material(steel()), Body::new("flat", Flat)];
    let pressed = Contact::between(bodies, Control::Load(1.25 * flattens * LENGTH)).unwrap();
    let contact = pressed.line([LENGTH, 1.0], 64).periodic().solve().unwrap();
    let pressed = contact.below(0).unwrap();
    let k = 2.0 * PI / LENGTH;
    let known = |[x, _, z]: [f64; 3]| {
        let (d, mean) = (-k * z, 1.25 * flattens);
        let [cos, sin] = [(k * x).cos(), (k * x).sin()].map(|own| flattens * (-d).exp() * own);
        let [xx, zz] = [-(1.0 - d) * cos, -(1.0 + d) * cos];
        let aside = -0.3 / 0.7 * mean;
        [xx + aside, 0.3 * (xx + zz) + aside, zz - mean, 0.0, d * sin, 0.0]
    };
    let near = |found: &Response, place: [f64; 3]| {
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = found.stress;
        for (found, known) in [xx, yy, zz, xy, xz, yz].into_iter().zip(known(place)) {
            assert!((found - known).abs() < 1e-6 * flattens, "{place:?}: {found} {known}");
        }
    };
    let places = [[0.0; 3], [0.13e-3, 0.0, -0.07e-3], [-0.31e-3, 0.2e-3, -0.4e-3]];
    let points = places.map(|place| Point { name: String::new(), place });
    let found = pressed.points(&points).unwrap();
    found.iter().zip(places).for_each(|(found, place)| near(found, place));
    // From crest to trough the surface is as flat as the rigid one.
    let surface = [0.0, 0.5 * LENGTH].map(|x| pressed.at([x, 0.0, 0.0]).unwrap().displacement[2]);
    assert_relative_eq!(surface[1] - surface[0], 2.0 * AMPLITUDE, max_relative = 1e-6);
    // Displacements are measured from the length of the waves below, where little of them is left.
    let deep = pressed.at([0.0, 0.0, -LENGTH]).unwrap().displacement[2];
    assert!(deep.abs() < 0.03 * flattens / (modulus * k), "{deep}");
    let section = Section {
        name: String::new(),
        through: [0.0; 3],
        normal: [0.3, 1.0, 0.0],
        spacing: 0.04e-3,
        size: Some([0.7e-3, 0.6e-3]),
    };
    let sampled = pressed.section(&section);
    assert!(sampled.places.len() > 100);
    sampled.responses.iter().zip(sampled.places).for_each(|(found, place)| near(found, place));
}

/// The same in part: sin^2(pi a/length) = mean over p*, and 2 mean / sin(pi a/length) at the crest.
#[test]
fn waves_touch_as_wide_as_westergaard_has_it() {
    let [_, flattens] = flattening();
    for share in [0.1_f64, 0.4, 0.8] {
        let (simulation, state) = wavy(share * flattens, 256);
        let half = share.sqrt().asin() * LENGTH / PI;
        let area = state.contact_area(&simulation.problem);
        assert_relative_eq!(area, 2.0 * half, max_relative = 5e-3);
        let crest = simulation.problem.frame.at_centre(&state.pressure);
        assert_relative_eq!(crest, 2.0 * share.sqrt() * flattens, max_relative = 2e-3);
    }
}

/// A ball in a cell far wider than the contact has Hertz's.
#[test]
fn a_lonely_ball_is_as_on_a_half_space() {
    let [modulus, _] = flattening();
    let hertz = Hertz::from_load([100.0; 2], modulus, 10.0).unwrap();
    let ball = Body::new("ball", Paraboloid::new([10e-3; 2]).unwrap()).material(steel());
    let planned = Indentation::new(1).under(Control::Load(10.0)).unwrap();
    let simulation = Simulation::builder([ball, Body::new("flat", Flat)], planned)
        .frame([20.0 * hertz.semi_axes[0]; 2], [320; 2])
        .periodic()
        .build()
        .unwrap();
    let (state, ..) = states(&simulation).unwrap().pop().unwrap();
    let peak = state.pressure.iter().copied().fold(0.0, f64::max);
    assert_relative_eq!(peak, hertz.peak_pressure, max_relative = 5e-3);
    assert_relative_eq!(
        state.contact_area(&simulation.problem),
        hertz.contact_area(),
        max_relative = 5e-3
    );
}

/// All nine components of unlike layered bodies: what a load in the middle of a wide cell does next to it is what it does to
/// half-spaces, apart from what the whole cell moves by.
#[test]
fn all_components_are_those_of_half_spaces_next_to_a_load() {
    let (one, other) = (Material::new(210e9, 0.3).unwrap(), Material::new(70e9, 0.1).unwrap());
    let layer = [Layer::new(Material::new(100e9, 0.2).unwrap(), 40e-6).unwrap()];
    let frame = ContactFrame::uniform([4e-3; 2], [256; 2], [&Flat, &Flat]).unwrap();
    let (materials, layers) = ([Some(&one), Some(&other)], [&layer[..], &[]]);
    let endless = Periodic::new(materials, layers, [4e-3; 2], &frame);
    let alone = HalfSpace::layered(materials, layers, &frame);
    // Smooth loads, which elements and waves take equally.
    let at = |pair: usize| {
        let [x, y] = frame.place(pair);
        let square = (x - 0.1e-3).powi(2) + (y + 0.05e-3).powi(2);
        1e8 * (-square / (0.15e-3_f64).powi(2)).exp()
    };
    let load: Vec<f64> = (0..frame.len()).map(at).collect();
    let zero = vec![0.0; frame.len()];
    let near = [[-0.2e-3, 0.15e-3], [0.2e-3, 0.1e-3], [0.05e-3, -0.25e-3], [0.1e-3, 0.3e-3]];
    let near = near.map(|[x, y]| {
        let distance = |pair: &usize| {
            let place = frame.place(*pair);
            (place[0] - x).hypot(place[1] - y)
        };
        (0..frame.len()).min_by(|one, other| distance(one).total_cmp(&distance(other))).unwrap()
    });
    for component in 0..3 {
        let mut tractions = [zero.clone(), zero.clone(), zero.clone()];
        tractions[component].clone_from(&load);
        let [t1, t2, n] = tractions;
        let tractions = VectorField { t1, t2, n };
        let [periodic, free] = [endless.apply(&tractions), alone.apply(&tractions)];
        let largest = free.components()[component].iter().copied().fold(0.0, f64::max);
        for (displaced, (own, other)) in
            periodic.components().iter().zip(free.components()).enumerate()
        {
            let apart = near.map(|pair| own[pair] - other[pair]);
            let mean = apart.iter().sum::<f64>() / 4.0;
            for difference in apart {
                assert!(
                    (difference - mean).abs() < 4e-3 * largest,
                    "{component} {displaced}: {apart:?} of {largest}"
                );
            }
        }
    }
}

/// A measured surface brings its frame, each reading an element, and wears by what the load and the distance say.
#[test]
fn measured_surfaces_bring_their_frame() {
    let dir = tempfile::tempdir().unwrap();
    let mut table = "x_mm,y_mm,z_um\n".to_owned();
    for (i, j) in (0..24).flat_map(|j| (0..32).map(move |i| (i, j))) {
        let [x, y] = [f64::from(i) / 32.0, f64::from(j) / 24.0].map(|share| 2.0 * PI * share);
        let height = 0.3 * x.cos() + 0.2 * (2.0 * y + x).sin() + 0.1 * (5.0 * x - 3.0 * y).cos();
        let _ =
            writeln!(table, "{:.5},{:.5},{height:.6}", 0.01 * f64::from(i), 0.02 * f64::from(j));
    }
    std::fs::write(dir.path().join("rough.csv"), table).unwrap();
    let text = r#"
        [body.rough]
        material = { young = "210 GPa", poisson = 0.3 }
        profile.table.file = "rough.csv"
        wear.archard.coefficient = "1e-6 mm^3/(N m)"
        [body.flat]
        rigid = true
        profile.flat = {}
        [frame]
        periodic = true
        [motion.sliding]
        load = "20 MPa"
        distance = "10 m"
        tolerance = 0.01
    "#;
    let case = CaseFile::from_text("case.toml", text, dir.path()).resolve().expect("a case").case;
    assert_eq!(case.frame.elements, [32, 24]);
    assert_relative_eq!(case.frame.size[0], 0.32e-3, max_relative = 1e-9);
    assert_relative_eq!(case.frame.size[1], 0.48e-3, max_relative = 1e-9);
    let simulation = case.build().unwrap();
    let (state, ..) = states(&simulation).unwrap().pop().unwrap();
    let load = 20e6 * 0.32e-3 * 0.48e-3;
    assert_relative_eq!(state.load, load, max_relative = 1e-8);
    let volume = simulation.problem.frame.integrate(&state.worn(0));
    assert_relative_eq!(volume, 1e-15 * load * 10.0, max_relative = 1e-8);
    // Coarser runs see no place beyond the readings.
    let options = ["accuracy=0.2", "motion.sliding.tolerance="];
    let file = CaseFile::from_text("case.toml", text, dir.path());
    let file = options.into_iter().fold(file, |file, option| file.set(option));
    let (_, simulation) = settled(file.resolve().expect("a case")).expect("coarser runs");
    assert!(Run::begin(simulation).expect("a contact").report().companions.is_some());
}

/// Pairs that are given do not repeat themselves.
#[test]
fn only_frames_repeat_themselves() {
    let frame = ContactFrame::uniform([1e-3; 2], [8; 2], [&Flat, &Flat]).unwrap();
    let steel = steel();
    let compliance = HalfSpace::new([Some(&steel), None], &frame);
    let bodies = [Body::new("one", Flat).material(steel), Body::new("two", Flat)];
    let planned = Indentation::new(1).under(Control::Load(1.0)).unwrap();
    let built = Simulation::builder(bodies, planned).contact(frame, compliance).periodic().build();
    assert!(built.unwrap_err().to_string().contains("with a frame or a line"));
}

/// Like bodies that are shifted slip in part as J. Jäger (*J. Tribology* 120 (1998) 677) has it: what sticks is as wide as the
/// contact under the load less the force over mu.
#[test]
fn shifted_waves_stick_as_wide_as_under_a_smaller_load() {
    let text = r#"
        [body.turned]
        material = { young = "210 GPa", poisson = 0.3 }
        profile.wave = { amplitude = "0.5 um", length_x = "0.5 mm" }
        [body.flat]
        material = { young = "210 GPa", poisson = 0.3 }
        profile.flat = {}
        [friction.coulomb]
        coefficient = 0.5
        [frame]
        periodic = true
        plane_strain = true
        size = "0.5 mm"
        elements = 256
        [motion.fretting]
        load = "50 MPa"
        force_amplitude = ["6.25 N/mm", "0 N/mm"]
        increments = 40
        cycles = 1
        [output]
        at = [0.25]
    "#;
    let simulation = case(text, &[]);
    let state = states(&simulation).unwrap().into_iter().map(|(state, ..)| state);
    let pushed = state.into_iter().find(|state| (state.progress - 0.25).abs() < 1e-9).unwrap();
    let sticks = pushed.tangential.unwrap().stick_area(&simulation.problem, &pushed.pressure);
    let flattens = PI * (210e9 / 0.91 / 2.0) * 0.5e-6 / 0.5e-3;
    // A force of 12.5 MPa on the whole surface.
    let known = 2.0 * ((50e6_f64 - 12.5e6 / 0.5) / flattens).sqrt().asin() / PI * 0.5e-3;
    let element = 0.5e-3 / 256.0;
    assert!((sticks - known).abs() < 2.0 * element, "{sticks:e} {known:e}");
}
