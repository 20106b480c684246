//! The contact of the Manchester benchmark's right side against the field's reference program, at eight shifts of the
//! wheelset, if `ARCHARD_WHEEL_RAIL` names the folder with its profiles and results.

mod common;

use std::sync::Arc;

use archard::body::Profile;
use archard::body::profile::Flat;
use archard::frame::Rectangle;
use archard::friction::Coulomb;
use archard::motion::{Control, Indentation};
use archard::simulation::{Run, Simulation};
use archard::{Body, Material};
use archard_rail::contact::{Bodies, Operation, Patch, Resolution, contact, roll};
use archard_rail::search::{Gap, JOIN, Search};
use common::Row;

/// What friction bears at most, over the load.
const FRICTION: f64 = 0.3;

/// A value of a patch, its error, the reference and how far it may be from it.
struct Held {
    name: &'static str,
    value: f64,
    error: f64,
    reference: f64,
    most: f64,
}

/// Forces and pressures may be off by a hundredth, on the flange by three: there the reference has patches 7 elements wide, and
/// its own pressures fall by 1.5 % on finer ones. Where the contact sticks, at the shift 0, tangential forces count against what
/// friction bears.
///
/// Of the area the reference's grid is held against: see `the_reference_counts_whole_elements`.
fn held(patch: &Patch, row: &Row) -> Vec<Held> {
    let (of, errors) = (&patch.values, &patch.errors);
    let flange = of.contact_angle.abs() > 0.5;
    let part = if flange { 0.03 } else { 0.01 };
    let held = |name, value, error, column, unit: f64, least: f64, part: f64| {
        let reference = row.get(column) * unit;
        Held { name, value, error, reference, most: least.max(part * reference.abs()) }
    };
    let sticks = if row.get("NADH") > 0.0 { part * FRICTION * row.get("FN") } else { 0.0 };
    // Of values printed with four digits, half of the last one.
    vec![
        held("onset", of.onset, errors.onset, "Z_ONSET", 1e-3, 1e-6, 0.0),
        held("z", of.z_wheel, errors.z_wheel, "Z_WS", 1e-3, 1e-6, 0.0),
        held("y", of.y_track, errors.y_track, "YCP(TR)", 1e-3, 5e-6, 0.0),
        held("y rail", of.y_rail, errors.y_rail, "YCP(R)", 1e-3, 5e-6, 0.0),
        held("y wheel", of.y_wheel, errors.y_wheel, "YCP(W)", 1e-3, 5e-6, 0.0),
        held("angle", of.contact_angle, errors.contact_angle, "DELTCP(TR)", 1.0, 1e-4, 0.0),
        held("xi", of.creepage, errors.creepage, "CKSI", 1.0, 0.0, 0.01),
        held("eta", of.lateral_creepage, errors.lateral_creepage, "CETA", 1.0, 1e-9, 0.01),
        held("phi", of.spin, errors.spin, "CPHI", 1e3, 0.0, 0.01),
        held("FN", of.normal_force, errors.normal_force, "FN", 1.0, 0.0, part),
        held("Fx", of.force_x, errors.force_x, "FX", 1.0, sticks, part),
        held("Fs", of.force_s, errors.force_s, "FS", 1.0, sticks, part),
        held("approach", of.approach, errors.approach, "APPROACH", 1e-3, 0.0, 0.01),
        held("peak", of.peak_pressure, errors.peak_pressure, "PMAX", 1e6, 0.0, part),
        held("area", of.contact_area, errors.contact_area, "AREA", 1e-6, 0.0, 3.5 * part),
    ]
}

#[test]
fn eight_shifts_bear_the_same() {
    let Some(folder) = common::folder() else { return };
    let setup = common::setup(&folder);
    // G = 82 GPa.
    let steel = Material::new(2.0 * 82e9 * 1.28, 0.28).unwrap();
    let friction = Arc::new(Coulomb::new(FRICTION).unwrap());
    let bodies = Bodies {
        wheel: steel,
        rail: steel,
        thermal: [None, None],
        friction,
        flange: None,
        wear: [None, None],
        flange_wear: None,
        shear_yield: 800e6,
    };
    let mut wrong = vec![];
    for row in common::rows(&folder) {
        let (attitude, velocity) = (row.attitude(), row.velocity());
        let operation = Operation {
            attitude,
            velocity,
            load: row.get("FZ(TR)"),
            transfer: 0.0,
            creepages: Default::default(),
        };
        // The reference is computed in the plane.
        let resolution = Resolution { curved: false, ..Resolution::default() };
        let patches = contact(&setup, &bodies, &operation, &resolution).unwrap();
        let [patch] = &patches[..] else { panic!("{} patches", patches.len()) };
        let bends = patch.angle_spread.to_degrees();
        eprintln!("y = {} mm, bent by {bends:.1} degrees:", row.get("Y_WS"));
        for Held { name, value, error, reference, most } in held(patch, &row) {
            let off = value - reference;
            let share = |off: f64| 100.0 * off / reference.abs();
            eprintln!(
                "  {name:9} {value:12.5e}, {:+9.3} %, error told {:8.3} %",
                share(off),
                share(error)
            );
            if off.is_nan() || off.abs() > most {
                wrong.push(format!("y = {}: {name} off by {off:.3e}", row.get("Y_WS")));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// 2e-6 rad are 1.5 um at a wheel, as much as the heights of the wheel differ on the flange; on the tread it is 3e-7 rad.
#[test]
fn the_wheelset_rolls_until_both_wheels_carry() {
    let Some(folder) = common::folder() else { return };
    let setup = common::setup(&folder);
    let steel = Material::new(2.0 * 82e9 * 1.28, 0.28).unwrap();
    let friction = Arc::new(Coulomb::new(FRICTION).unwrap());
    let bodies = Bodies {
        wheel: steel,
        rail: steel,
        thermal: [None, None],
        friction,
        flange: None,
        wear: [None, None],
        flange_wear: None,
        shear_yield: 800e6,
    };
    for row in common::rows(&folder) {
        let (attitude, velocity) = (row.attitude(), row.velocity());
        let operation = Operation {
            attitude,
            velocity,
            load: 10e3,
            transfer: 0.0,
            creepages: Default::default(),
        };
        let resolution = Resolution { elements: 16, ..Resolution::default() };
        let roll = roll(&setup, &bodies, &operation, &resolution).unwrap();
        let off = roll - attitude.roll;
        eprintln!("y = {} mm: roll {roll:.4e}, {off:+.1e} off", row.get("Y_WS"));
        assert!(off.abs() < 2e-6);
    }
}

/// The gap of a patch as the recess of the wheel.
#[derive(Debug)]
struct Recess(Vec<f64>, Rectangle, [usize; 2]);

/// Side (m) of the reference's elements.
const SIDE: f64 = 0.2e-3;

impl Recess {
    fn new(gap: &Gap<'_>, ranges: [[f64; 2]; 2]) -> Self {
        let counts = ranges.map(|[from, to]| ((to - from) / SIDE).ceil() as usize);
        let size = counts.map(|count| count as f64 * SIDE);
        let centre = ranges.map(|[from, to]| 0.5 * (from + to));
        let [x, s] = [0, 1].map(|axis| {
            let places = (0..counts[axis]).map(|at| (at as f64 + 0.5) * SIDE - 0.5 * size[axis]);
            places.map(|off| centre[axis] + off).collect::<Vec<f64>>()
        });
        Self(gap.grid(&x, &s), Rectangle { centre, size }, counts)
    }
}

impl Profile for Recess {
    fn recess(&self, x: f64, y: f64) -> f64 {
        let at = |axis: usize| {
            let off = [x, y][axis] - self.1.corner()[axis];
            ((off / SIDE) as usize).min(self.2[axis] - 1)
        };
        self.0[at(0) * self.2[1] + at(1)]
    }

    fn extent(&self) -> [[f64; 2]; 2] {
        [0, 1].map(|axis| [self.1.corner()[axis], self.1.corner()[axis] + self.1.size[axis]])
    }
}

/// On elements of the reference's size at its height of the wheel as many touch as there, to 2 % on the tread. The area up to the
/// edge is 2 to 4 % smaller: elements whose middles lie next to the contact by less than a sixth of one bear something. On
/// the flange the contact is 7 elements wide, and one row more or less is a seventh.
#[test]
fn the_reference_counts_whole_elements() {
    let Some(folder) = common::folder() else { return };
    let setup = common::setup(&folder);
    let steel = Material::new(2.0 * 82e9 * 1.28, 0.28).unwrap();
    for row in common::rows(&folder) {
        let search = Search::new(&setup, row.attitude()).unwrap();
        let patch = search.patches(row.get("Z_WS") * 1e-3, JOIN).unwrap().remove(0);
        let recess = Recess::new(&search.gap(&patch), [patch.along, patch.across]);
        let (rectangle, elements) = (recess.1, recess.2);
        let approach = -recess.0.iter().copied().fold(f64::MAX, f64::min);
        let bodies = [Body::new("wheel", recess), Body::new("rail", Flat)];
        let bodies = bodies.map(|body| body.material(steel));
        let pressed = Indentation::new(1).under(Control::Approach(approach)).unwrap();
        let simulation = Simulation::builder(bodies, pressed).frame(rectangle, elements);
        let mut run = Run::begin(simulation.build().unwrap()).unwrap();
        while run.step().unwrap() {}
        let state = run.report().state;
        let share = |value: f64, name: &str| value / row.get(name) - 1.0;
        let counted = share(state.pairs_in_contact() as f64, "NCON");
        let ended = share(1e6 * state.contact_area(&run.simulation().problem), "AREA");
        let force = share(state.load, "FN");
        let peak = share(1e-6 * state.pressure.iter().copied().fold(0.0, f64::max), "PMAX");
        eprintln!(
            "y = {} mm: FN {force:+.4}, peak {peak:+.4}, elements {counted:+.4}, area {ended:+.4}",
            row.get("Y_WS")
        );
        assert!(patch.angle.abs() > 0.5 || counted.abs() < 0.02);
    }
}
