//! A relative error in place of elements and steps, for those who put a simulation together themselves.

use archard::accuracy::{AccuracyFailure, Event, Grid, SettledRun, settle};
use archard::body::contact_modulus;
use archard::body::profile::{Cylinder, Flat, Sphere};
use archard::closed_form::hertz::{Hertz, Line};
use archard::friction::Coulomb;
use archard::motion::{Control, Fretting, Indentation, Planned, Sliding, Stepping};
use archard::simulation::history::{APPROACH, CENTRE_PRESSURE, ERROR, Row, number, row, stated};
use archard::simulation::{Builder, Error, Run};
use archard::wear::Archard;
use archard::{Body, Material, Simulation};

const RADIUS: f64 = 50e-3;
const LOAD: f64 = 10.2;

fn steel() -> Material {
    Material::new(210e9, 0.3).unwrap()
}

fn pressed(load: f64) -> Planned {
    Indentation::new(1).under(Control::Load(load)).unwrap()
}

/// A ball on a flat that does what is planned, on a frame of 2.4 times the contact's radius of 0.149 mm to either side.
fn ball(planned: Planned, elements: usize) -> Builder {
    let ball = Body::new("ball", Sphere::new(RADIUS).unwrap()).material(steel());
    let flat = Body::new("flat", Flat).material(steel());
    Simulation::builder([ball, flat], planned).frame([0.72e-3; 2], [elements; 2])
}

/// A ball that wears while it slides over a flat, on the same frame.
fn pin(stepping: Stepping, elements: usize) -> Builder {
    let pin = Body::new("pin", Sphere::new(RADIUS).unwrap()).material(steel());
    let pin = pin.wear(Archard::new(1.33e-13).unwrap());
    let disc = Body::new("disc", Flat).material(steel());
    let sliding = Sliding::new().over(0.02, Control::Load(LOAD), stepping).unwrap();
    Simulation::builder([pin, disc], sliding).frame([0.72e-3; 2], [elements; 2])
}

/// The last row of a run.
fn last(SettledRun { simulation, .. }: SettledRun) -> Row {
    let mut run = Run::begin(simulation).unwrap();
    while run.step().unwrap() {}
    row(&run.report())
}

/// Asserts that a value lies within the error stated, and that error within what was asked for.
fn assert_within(row: &Row, (column, truth): (&str, f64), asked: f64) {
    let value = |name: &str| number(row, name);
    let (found, error) = (value(column).unwrap(), stated(column, value).unwrap());
    assert!((found - truth).abs() <= error, "{column}: {found:e}, {truth:e} +- {error:e}");
    assert!(error <= asked * found, "{column}: {error:e} of {truth:e}");
}

/// Hertz's point and line contact lie within the errors stated, on grids that begin too coarse, too.
#[test]
fn hertz_lies_within_what_was_asked_for() {
    let modulus = contact_modulus([Some(&steel()); 2]);
    let hertz = Hertz::from_load([1.0 / RADIUS; 2], modulus, LOAD).unwrap();
    for (accuracy, elements) in [(0.03, 36), (0.01, 36), (0.01, 50)] {
        let settled = ball(pressed(LOAD), elements).settle(accuracy, &mut |_| Ok(())).unwrap();
        let row = last(settled);
        for truth in [(APPROACH, hertz.approach), (CENTRE_PRESSURE, hertz.peak_pressure)] {
            assert_within(&row, truth, accuracy);
        }
    }
    let (length, load) = (10e-3, 500.0);
    let line = Line::from_load(1.0 / RADIUS, modulus, load / length).unwrap();
    let along_y = Cylinder::along_y(RADIUS).unwrap();
    let roller = Body::new("roller", along_y).material(steel());
    let bodies = [roller, Body::new("flat", Flat).material(steel())];
    let builder = Simulation::builder(bodies, pressed(load));
    let builder = builder.line([4.0 * line.half_width, length], 40);
    let row = last(builder.settle(0.01, &mut |_| Ok(())).unwrap());
    assert_within(&row, (CENTRE_PRESSURE, line.peak_pressure), 0.01);
}

/// A wear track meets what is asked for by finer elements and steps; the builder and a function that builds agree to the bit.
#[test]
fn a_builder_and_a_function_settle_the_same() {
    let built = pin(Stepping::Tolerance(0.5), 50).settle(0.05, &mut |_| Ok(())).unwrap();
    let start = Grid { tolerance: Some(0.05 / 3.0), ..Grid::new([50; 2]) };
    let mut build = |grid: &Grid| {
        let one = pin(Stepping::Tolerance(grid.tolerance.unwrap_or_default()), 50);
        Ok(one.frame([0.72e-3; 2], grid.elements).build()?)
    };
    let function = settle(0.05, start, &mut build, &mut |_| Ok(())).unwrap();
    assert_eq!(built.grid, function.grid);
    let [one, other] = [built, function].map(last);
    assert_eq!(one, other);
    assert!(number(&one, ERROR).unwrap() <= 0.05);
}

/// Who watches ends a companion at once, and the search with the grid that was judged last.
#[test]
fn a_search_ends_where_it_is_watched() {
    let shown = |event: Event<'_>| match event {
        Event::Shows(_) => Err("enough".into()),
        _ => Ok(()),
    };
    let stopped = ball(pressed(LOAD), 36).settle(0.01, &mut { shown }).unwrap_err();
    let AccuracyFailure::Run { cause, .. } = stopped else { panic!("{stopped}") };
    assert!(matches!(*cause, Error::Observer(_)), "{cause}");
    let (mut plans, mut short) = (vec![], 0);
    let mut watch = |event: Event<'_>| {
        match event {
            Event::Plans(elements) => plans.extend(elements.last().copied()),
            Event::Judged => return Err("enough".into()),
            Event::FallsShort(_) => short += 1,
            _ => {}
        }
        Ok(())
    };
    let settled = ball(pressed(LOAD), 36).settle(0.0005, &mut watch).unwrap();
    assert_eq!((settled.grid.elements, &plans[..], short), ([36; 2], &[[36; 2]][..], 1));
}

/// What can not be made coarser, or is too coarse already, is refused, and it is said what to do.
#[test]
fn what_can_not_be_made_coarser_is_refused() {
    let fret = Fretting::shifted([1e-6, 0.0]).increments(20).under(Control::Load(LOAD)).unwrap();
    let refused = [
        (pin(Stepping::Implicit(1e-3), 50), 0.01, "Stepping::Tolerance"),
        (ball(fret, 50).friction(Coulomb::new(0.3).unwrap()), 0.01, "accuracy::settle"),
        (ball(pressed(LOAD), 50), 0.5, "at most 0.2"),
        (ball(pressed(LOAD), 12), 0.01, "too few to estimate"),
    ];
    for (builder, accuracy, says) in refused {
        let said = builder.settle(accuracy, &mut |_| Ok(())).unwrap_err().to_string();
        assert!(said.contains(says), "{said}");
    }
}
