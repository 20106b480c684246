//! Layered half-spaces against Hankel integrals and an axisymmetric integral equation.

use approx::assert_relative_eq;
use archard::body::Layer;
use archard::body::profile::{Flat, Paraboloid};
use archard::compliance::{Compliance, HalfSpace};
use archard::frame::{ContactFrame, VectorField};
use archard::friction::Coulomb;
use archard::motion::{Control, Indentation};
use archard::{Body, Material, Simulation};
use archard_case::CaseFile;

use crate::common::states;

const PARABOLOID: &str = include_str!("../layered/paraboloid.csv");
const DISPLACEMENTS: &str = include_str!("../layered/displacements.csv");

/// Of that shear modulus.
fn material(shear: f64, poisson: f64) -> Material {
    Material::new(2.0 * (1.0 + poisson) * shear, poisson).unwrap()
}

/// The cells of a table, without the head and what is said of it.
fn cells(table: &str) -> Vec<Vec<String>> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(table.as_bytes());
    reader.records().map(|row| row.unwrap().iter().map(str::to_owned).collect()).collect()
}

/// The numbers in some text.
fn numbers(text: &str) -> Vec<f64> {
    let parts = text.split(|c: char| !(c.is_ascii_digit() || c == '.'));
    parts.filter_map(|part| part.parse().ok()).collect()
}

/// Loads and pressures of a rigid paraboloid on eight stacks, on 97 x 97 elements.
#[test]
#[ignore = "long: in .ci/long"]
fn paraboloids_press_layers_as_computed_independently() {
    const RADIUS: f64 = 100.0;
    for row in cells(PARABOLOID) {
        let [shear, poisson, _, _, reach, load, approach, pressure, _] =
            [0, 1, 2, 3, 4, 5, 6, 7, 8].map(|i| row[i].parse::<f64>().unwrap_or(f64::NAN));
        let layer = Layer::new(material(shear, poisson), 1.0).unwrap();
        let block = Body::new("block", Flat).layers([layer]);
        let block = match &*row[2] {
            "rigid" => block,
            base => block.material(material(base.parse().unwrap(), row[3].parse().unwrap())),
        };
        let punch = Body::new("punch", Paraboloid::new([RADIUS; 2]).unwrap());
        let control = Control::Approach(approach * reach * reach / RADIUS);
        let planned = Indentation::new(1).under(control).unwrap();
        let simulation = Simulation::builder([punch, block], planned)
            .frame([2.6 * reach; 2], [97; 2])
            .build()
            .unwrap();
        let (state, ..) = states(&simulation).unwrap().pop().unwrap();
        let modulus = shear / (1.0 - poisson);
        let known = load * 8.0 / 3.0 * modulus * reach.powi(3) / RADIUS;
        println!("{row:?}: load {:+.1e}", state.load / known - 1.0);
        assert_relative_eq!(state.load, known, max_relative = 2e-4);
        let centre = simulation.problem.frame.at_centre(&state.pressure);
        let known = pressure * 4.0 * modulus * reach / (std::f64::consts::PI * RADIUS);
        println!("    pressure {:+.1e}", centre / known - 1.0);
        assert_relative_eq!(centre, known, max_relative = 4e-4);
    }
}

/// What a load of (1 - r^2)^2 on a grid of some spacing displaces: as a pressure, and drawn along x.
fn displaced(
    spacing: f64,
    base: Option<&Material>,
    layers: &[Layer],
) -> (ContactFrame, [VectorField; 2]) {
    let elements = 2 * (2.0 / spacing).round() as usize + 1;
    let size = [spacing * elements as f64; 2];
    let frame = ContactFrame::uniform(size, [elements; 2], [&Flat, &Flat]).unwrap();
    let compliance = HalfSpace::layered([None, base], [&[], layers], &frame);
    let load = |pair: usize| {
        let [x, y] = frame.place(pair);
        (1.0 - x * x - y * y).max(0.0).powi(2)
    };
    let load: Vec<f64> = (0..frame.len()).map(load).collect();
    let zero = vec![0.0; frame.len()];
    let pressed = VectorField { t1: zero.clone(), t2: zero.clone(), n: load.clone() };
    let drawn = VectorField { t1: load, t2: zero.clone(), n: zero };
    let displaced = [pressed, drawn].map(|tractions| compliance.apply(&tractions));
    (frame, displaced)
}

/// All components, extrapolated from two grids, which pressures and tractions that are smooth converge on by the second order.
#[test]
#[ignore = "long: in .ci/long"]
fn displacements_of_layers_are_those_of_hankel_integrals() {
    let rows = cells(DISPLACEMENTS);
    for rows in rows.chunk_by(|one, other| one[..3] == other[..3]) {
        let layers = numbers(&rows[0][1]);
        let layers: Vec<_> = layers
            .chunks(3)
            .map(|one| Layer::new(material(one[0], one[1]), one[2]).unwrap())
            .collect();
        let base = numbers(&rows[0][2]);
        let base = (!base.is_empty()).then(|| material(base[0], base[1]));
        let grids = [0.05, 0.025].map(|spacing| displaced(spacing, base.as_ref(), &layers));
        for row in rows {
            let [x, y, zz, xx, xy, zx, xz] =
                [3, 4, 5, 6, 7, 8, 9].map(|i| row[i].parse::<f64>().unwrap());
            // Where the place is that of an element.
            let at = |(frame, [pressed, drawn]): &(ContactFrame, [VectorField; 2])| {
                let place = (0..frame.len()).find(|&pair| {
                    let [px, py] = frame.place(pair);
                    (px - x).hypot(py - y) < 1e-9
                })?;
                let [one, other] = [pressed, drawn].map(|own| [own.n[place], own.t1[place]]);
                Some([one[0], other[1], drawn.t2[place], other[0], one[1]])
            };
            let [Some(coarse), Some(fine)] = grids.each_ref().map(at) else { continue };
            println!("{} at {x}, {y}", row[0]);
            for (i, known) in [zz, xx, xy, zx, xz].into_iter().enumerate() {
                let found = (4.0 * fine[i] - coarse[i]) / 3.0;
                println!("   {found:+.6} {known:+.6} {:+.1e}", (found - known) / zz.max(xx));
                assert_relative_eq!(found, known, epsilon = 2e-4 * zz.max(xx), max_relative = 1e-9);
            }
        }
    }
}

/// Layers of what is below them are nothing, under areas and along lines.
#[test]
fn layers_of_the_same_material_change_nothing() {
    let steel = Material::new(210e9, 0.3).unwrap();
    let layers = [1e-6, 3e-5, 2e-4].map(|thickness| Layer::new(steel, thickness).unwrap());
    let area = ContactFrame::uniform([1e-3; 2], [24; 2], [&Flat, &Flat]).unwrap();
    let line = ContactFrame::line([1e-3, 1.0], [24, 1], [&Flat, &Flat]).unwrap();
    let bases = [Some(&steel), None];
    for (frame, plain, layered) in [
        (&area, HalfSpace::new(bases, &area), HalfSpace::layered(bases, [&layers, &[]], &area)),
        (
            &line,
            HalfSpace::plane_strain(bases, [&[]; 2], [1e-2; 2], &line),
            HalfSpace::plane_strain(bases, [&layers, &[]], [1e-2; 2], &line),
        ),
    ] {
        let wave = |k: f64| (0..frame.len()).map(|i| (k * i as f64).sin() + 0.3).collect();
        let tractions = VectorField { t1: wave(1.0), t2: wave(1.3), n: wave(0.6) };
        let [one, other] = [plain.apply(&tractions), layered.apply(&tractions)];
        let scale = one.n.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        for (one, other) in [(one.t1, other.t1), (one.t2, other.t2), (one.n, other.n)] {
            for (one, other) in one.iter().zip(&other) {
                assert_relative_eq!(*one, *other, epsilon = 1e-12 * scale);
            }
        }
    }
}

/// A ball that rubs a coated block, as body 1 and as body 2: the same load at the same approach, and friction that pushes the other
/// way. Pressures move a coated surface sideways by more than a half-space, so that a wrong sign of either shows.
#[test]
fn the_order_of_bodies_changes_signs_alone() {
    let steel = Material::new(210e9, 0.3).unwrap();
    let layer = Layer::new(Material::new(70e9, 0.1).unwrap(), 20e-6).unwrap();
    let pressed = |first: bool| {
        let ball = Body::new("ball", Paraboloid::new([5e-3; 2]).unwrap());
        let block = Body::new("block", Flat).material(steel).layers([layer]);
        let bodies = if first { [ball, block] } else { [block, ball] };
        let planned = Indentation::new(6).under(Control::Load(20.0)).unwrap();
        let builder = Simulation::builder(bodies, planned).frame([0.4e-3, 0.32e-3], [25, 20]);
        let simulation = builder.friction(Coulomb::new(0.3).unwrap()).build().unwrap();
        let (state, ..) = states(&simulation).unwrap().pop().unwrap();
        (state.approach, state.tangential.expect("friction"))
    };
    let [(one, by_ball), (other, by_block)] = [true, false].map(pressed);
    assert_relative_eq!(one, other, max_relative = 1e-7);
    let largest = by_ball.traction[0].iter().copied().fold(0.0, f64::max);
    assert!(largest > 1e6, "{largest}");
    for (one, other) in by_ball.traction[0].iter().zip(&by_block.traction[0]) {
        // Tractions act on body 1.
        assert_relative_eq!(*one, -*other, epsilon = 1e-3 * largest);
    }
}

/// What is worn off each material, over its coefficient, is load times distance; at the end both wear down equally, so that pressures
/// go as one over the coefficients.
#[test]
fn layers_and_what_is_below_share_load_times_distance() {
    let case = r#"
        [body.ball]
        material = { young = "210 GPa", poisson = 0.3 }
        profile.sphere = { radius = "3 mm" }
        [body.disc]
        layers = [
            { thickness = "0.4 um", young = "150 GPa", poisson = 0.2, wear.archard.coefficient = "1e-15 1/Pa" },
            { thickness = "0.3 um", young = "250 GPa", poisson = 0.25, wear.archard.coefficient = "3e-15 1/Pa" },
        ]
        material = { young = "210 GPa", poisson = 0.3 }
        profile.flat = {}
        wear.archard.coefficient = "2e-15 1/Pa"
        [frame]
        size = ["0.4 mm", "0.4 mm"]
        elements = [41, 41]
        [motion.sliding]
        load = "5 N"
        surfaces = "stay"
        distance = "20 m"
        step = "0.25 m"
    "#;
    let case = CaseFile::from_text("case.toml", case, "").resolve().expect("a case").case;
    let simulation = case.build().unwrap();
    let (state, ..) = states(&simulation).unwrap().pop().unwrap();
    let frame = &simulation.problem.frame;
    let between = |top: f64, bottom: f64| -> f64 {
        let part = |depth: &f64| (depth.min(bottom) - top).max(0.0);
        frame.integrate(&state.worn(1).iter().map(part).collect::<Vec<_>>())
    };
    let strata = [between(0.0, 0.4e-6), between(0.4e-6, 0.7e-6), between(0.7e-6, f64::INFINITY)];
    let rubbed: f64 = strata.iter().zip([1e-15, 3e-15, 2e-15]).map(|(volume, k)| volume / k).sum();
    assert!(strata.iter().all(|volume| *volume > 0.0), "{strata:?}");
    assert_relative_eq!(rubbed, 100.0, max_relative = 1e-6);
}
