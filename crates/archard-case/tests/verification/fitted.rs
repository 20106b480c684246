//! Balls in layered sockets and shafts in bushes against finite elements, exact wear of rigid ones, and columns.

use std::error::Error;
use std::sync::Arc;

use approx::assert_relative_eq;
use archard::body::Layer;
use archard::body::profile::{ClearanceFit, Round};
use archard::motion::{Control, Cycles, Indentation, Joint, Sliding, Stepping};
use archard::simulation::{Observer, Report};
use archard::wear::{Archard, CrossShear, WearLaw};
use archard::{Body, Material, Simulation};

use super::accuracy::{answer, assert_within};
use crate::common::states;

/// Radius, clearance and thickness (mm), Young's modulus (MPa), Poisson's ratio, load (N), then approach (mm), largest pressure (MPa)
/// and the angle of the edge (degrees) of axisymmetric finite elements: nine nodes, frictionless, bonded outside, the rim free at a
/// right angle, converged to 3e-5, their edge known to an element, a degree. Then approach and pressure of whole shells, by harmonics as
/// below: the rim adds up to 0.9 and 0.3 %.
const SOCKETS: &[[f64; 11]] = &[
    [14.0, 0.1, 8.0, 1000.0, 0.4, 300.0, 0.01498, 3.8769, 26.0, 0.014985, 3.87742],
    [14.0, 0.1, 8.0, 1000.0, 0.4, 3000.0, 0.05884, 14.742, 47.5, 0.058792, 14.7377],
    [14.0, 0.1, 3.0, 1000.0, 0.4, 300.0, 0.00937, 5.6669, 22.0, 0.0093686, 5.66548],
    [14.0, 0.1, 3.0, 1000.0, 0.4, 3000.0, 0.03298, 21.010, 40.0, 0.0329854, 21.0103],
    [14.0, 0.1, 8.0, 1000.0, 0.46, 300.0, 0.01351, 4.0698, 25.0, 0.013490, 4.07034],
    [14.0, 0.1, 8.0, 1000.0, 0.46, 3000.0, 0.04965, 15.585, 46.0, 0.049219, 15.5456],
    [18.0, 0.15, 6.0, 700.0, 0.45, 300.0, 0.01355, 3.4223, 22.0, 0.013546, 3.42171],
    [18.0, 0.15, 6.0, 700.0, 0.45, 3000.0, 0.04590, 12.837, 39.0, 0.045867, 12.8332],
    [14.0, 0.02, 8.0, 1000.0, 0.4, 300.0, 0.00762, 1.9049, 40.0, 0.007615, 1.90468],
    [14.0, 0.02, 8.0, 1000.0, 0.4, 3000.0, 0.03741, 9.4669, 66.0, 0.037309, 9.45107],
];

/// Radius and clearance (mm), Young's modulus (MPa) and Poisson's ratio of the ball, thickness of what is around it (mm; on something rigid,
/// or without end), its modulus and ratio, load (N), then approach (mm), largest pressure (MPa) and the angle of the edge (degrees) by sums
/// of Legendre's polynomials on rings, pressures linear in the cosine between them. 250 and 400 rings agree to 2e-5. The ball's own sums
/// agree with axisymmetric finite elements under a body force to 1e-5.
const BALLS: &[[f64; 11]] = &[
    [14.0, 0.03, 210e3, 0.3, 4.0, 210e3, 0.3, 3000.0, 0.00263605, 69.449, 19.27],
    [16.0, 0.05, 380e3, 0.23, 5.0, 380e3, 0.23, 3000.0, 0.00221628, 105.54, 13.39],
    [14.0, 0.05, 210e3, 0.3, f64::INFINITY, 110e3, 0.34, 3000.0, 0.00509966, 67.884, 19.17],
    [14.0, 0.1, 210e3, 0.3, 8.0, 1000.0, 0.4, 3000.0, 0.0591132, 14.6797, 47.93],
    [14.0, 0.1, 3500.0, 0.36, 4.0, 3500.0, 0.36, 300.0, 0.0118428, 5.17078, 22.64],
    [14.0, 0.1, 3500.0, 0.36, 4.0, 3500.0, 0.36, 3000.0, 0.0443427, 15.8562, 44.15],
    [14.0, 0.1, 1000.0, 0.4, 8.0, 1000.0, 0.4, 3000.0, 0.0991401, 9.58447, 61.80],
    [14.0, 0.1, 1000.0, 0.4, 0.0, 1000.0, 0.4, 3000.0, 0.0688619, 10.2670, 56.25],
];

/// Radius, clearance and length (mm), Young's modulus (MPa; zero of a rigid one) and Poisson's ratio of the shaft, thickness of the ring
/// around it (mm) on something rigid, its modulus and ratio, load (N), then approach (mm), largest pressure (MPa) and the angle of the edge
/// (degrees; to an element, 0.3) by sums of 60,000 harmonics: Michell's functions on 300 and 600 strips, which agree to 2e-5.
const SHAFTS: &[[f64; 12]] = &[
    [10.0, 0.02, 20.0, 210e3, 0.3, 5.0, 210e3, 0.3, 5e3, 0.00191326, 49.145, 19.2],
    [10.0, 0.05, 20.0, 210e3, 0.3, 3.0, 1000.0, 0.4, 2e3, 0.0168057, 10.7824, 40.8],
    [10.0, 0.02, 20.0, 70e3, 0.33, 5.0, 70e3, 0.33, 5e4, 0.0216925, 178.618, 63.7],
    [10.0, 0.01, 20.0, 3500.0, 0.36, 20.0, 110e3, 0.34, 5e4, 0.163221, 146.910, 94.4],
    [10.0, 0.05, 20.0, 0.0, 0.0, 3.0, 1000.0, 0.4, 2e3, 0.0165908, 10.8347, 40.6],
];

/// Two bodies that fit into each other (mm), the outer one a layer (mm, MPa) on something rigid.
fn bodies(round: Round, [radius, clearance, thickness]: [f64; 3], layer: [f64; 2]) -> [Body; 2] {
    let fitted =
        |radius: f64, hollow: bool| ClearanceFit::new(round, 1e-3 * radius, hollow).unwrap();
    let material = Material::new(1e6 * layer[0], layer[1]).unwrap();
    let layer = Layer::new(material, 1e-3 * thickness).unwrap();
    let inner = Body::new("inner", fitted(radius, false));
    [inner, Body::new("outer", fitted(radius + clearance, true)).layers([layer])]
}

/// Approach (mm), largest pressure (MPa) and angle of the edge (degrees) of a ball of some radius (mm) under a load (N), on a frame that
/// reaches as far as some angle.
fn pressed(bodies: [Body; 2], radius: f64, load: f64, reach: f64) -> [f64; 3] {
    let planned = Indentation::new(1).under(Control::Load(load)).unwrap();
    let reach = 2.0 * radius * 1e-3 * (0.5 * reach.to_radians()).sin();
    let simulation =
        Simulation::builder(bodies, planned).frame([2.0 * reach; 2], [97; 2]).build().unwrap();
    let (state, ..) = states(&simulation).unwrap().pop().unwrap();
    let frame = &simulation.problem.frame;
    let peak = state.pressure.iter().copied().fold(0.0, f64::max);
    let area = frame.area_where(|pair| state.pressure[pair] > 0.0);
    let edge = 2.0 * (0.5 * (area / std::f64::consts::PI).sqrt() / (1e-3 * radius)).asin();
    [1e3 * state.approach, 1e-6 * peak, edge.to_degrees()]
}

#[test]
#[ignore = "long: in .ci/long"]
fn balls_in_sockets_are_as_by_finite_elements() {
    for &[radius, clearance, thickness, young, poisson, load, ref known @ ..] in SOCKETS {
        let bodies = bodies(Round::Sphere, [radius, clearance, thickness], [young, poisson]);
        let [approach, pressure, angle, whole, peak] = *known;
        let found = pressed(bodies, radius, load, angle + 8.0);
        let off = [approach, pressure, whole, peak];
        let off: [f64; 4] = std::array::from_fn(|i| found[i % 2] / off[i] - 1.0);
        println!(
            "{radius} {clearance} {thickness} {young} {poisson} {load}: {found:?}, off {off:?}"
        );
        assert!(off[0].abs() < 9e-3 && off[1].abs() < 3e-3);
        assert!(off[2].abs() < 1e-3 && off[3].abs() < 1e-3);
        assert!((found[2] - angle).abs() < 1.2);
    }
}

#[test]
fn elastic_balls_are_as_by_harmonics() {
    for &[radius, clearance, own, ratio, thickness, young, poisson, load, ref known @ ..] in BALLS {
        let [approach, pressure, angle] = *known;
        let layer = if thickness.is_finite() { thickness.max(1.0) } else { 1.0 };
        let [ball, socket] = bodies(Round::Sphere, [radius, clearance, layer], [young, poisson]);
        let ball = ball.material(Material::new(1e6 * own, ratio).unwrap());
        let socket = match thickness {
            f64::INFINITY => Body { layers: vec![], ..socket }
                .material(Material::new(1e6 * young, poisson).unwrap()),
            0.0 => Body { layers: vec![], ..socket },
            _ => socket,
        };
        let found = pressed([ball, socket], radius, load, angle + 4.0);
        let off = [found[0] / approach - 1.0, found[1] / pressure - 1.0];
        println!(
            "{radius} {clearance} {own} {thickness} {young} {load}: {found:?}, off {:+.3} % and {:+.3} %",
            1e2 * off[0],
            1e2 * off[1],
        );
        // What the verdict says of chords, and what the elements leave.
        let most = 0.125 * (0.5 * angle.to_radians()).sin().powi(4) + 1e-4;
        assert!(off.iter().all(|off| off.abs() < most), "{most}");
        assert!((found[2] - angle).abs() < 0.4);
    }
}

/// A contact that is small for both bodies is Hertz's, but for parts of the order of its size over the radius.
#[test]
fn small_contacts_in_sockets_are_hertzian() {
    let (radius, clearance, load) = (14.0, 0.05, 3e-4);
    let [ball, socket] = bodies(Round::Sphere, [radius, clearance, 1.0], [110e3, 0.34]);
    let ball = ball.material(Material::new(210e9, 0.3).unwrap());
    let socket = Body { layers: vec![], ..socket }.material(Material::new(110e9, 0.34).unwrap());
    let modulus = 1.0 / ((1.0 - 0.3 * 0.3) / 210e3 + (1.0 - 0.34 * 0.34) / 110e3);
    let curvature = 1.0 / radius - 1.0 / (radius + clearance);
    let half = (0.75 * load / curvature / modulus).cbrt();
    let found = pressed([ball, socket], radius, load, 1.3 * (half / radius).to_degrees());
    println!(
        "{found:?} {half} {} {}",
        1.5 * load / half / half / std::f64::consts::PI,
        half * half * curvature
    );
    assert_relative_eq!(
        found[1],
        1.5 * load / (std::f64::consts::PI * half * half),
        max_relative = 6e-3
    );
    assert_relative_eq!(found[0], half * half * curvature, max_relative = 6e-3);
    assert_relative_eq!(found[2].to_radians() * radius, half, max_relative = 6e-3);
}

#[test]
fn elastic_shafts_are_as_by_harmonics() {
    for &[radius, clearance, length, own, ratio, thickness, young, poisson, load, ref known @ ..] in
        SHAFTS
    {
        let [approach, pressure, angle] = *known;
        let [shaft, bush] =
            bodies(Round::Cylinder, [radius, clearance, thickness], [young, poisson]);
        let shaft = match own > 0.0 {
            true => shaft.material(Material::new(1e6 * own, ratio).unwrap()),
            false => shaft,
        };
        let planned = Indentation::new(1).under(Control::Load(load)).unwrap();
        let rectangle = [2e-3 * radius * (angle + 9.0).to_radians(), 1e-3 * length];
        let simulation =
            Simulation::builder([shaft, bush], planned).line(rectangle, 501).build().unwrap();
        let (state, ..) = states(&simulation).unwrap().pop().unwrap();
        let peak = 1e-6 * state.pressure.iter().copied().fold(0.0, f64::max);
        let area = simulation.problem.frame.area_where(|pair| state.pressure[pair] > 0.0);
        let edge = (0.5 * area / (1e-6 * length * radius)).to_degrees();
        println!("{radius} {own} {young} {load}: {} {peak} {edge}", 1e3 * state.approach);
        assert_relative_eq!(1e3 * state.approach, approach, max_relative = 1e-4);
        assert_relative_eq!(peak, pressure, max_relative = 1e-4);
        assert!((edge - angle).abs() < 0.5);
    }
}

/// A shaft in a thin bush: columns, each of them a ring under an even pressure, p = K (d cos theta - c) with d the distance of the axes,
/// and F = R L K (d (t + sin t cos t) - 2 c sin t) with cos t = c/d. They are the limit of a layer that is thin for the contact.
#[test]
fn shafts_in_thin_bushes_are_columns() {
    let [radius, length, clearance, thickness, young, poisson] =
        [10.0, 20.0, 0.05, 0.1, 100.0, 0.3];
    let ratio: f64 = 1.0 + thickness / radius;
    let stiffness = young / (radius * (1.0 + poisson))
        * (1.0 / (1.0 - 2.0 * poisson) + ratio.powi(2))
        / (ratio.powi(2) - 1.0);
    let distance = 0.08;
    let angle = f64::acos(clearance / distance);
    let load = radius
        * length
        * stiffness
        * (distance * (angle + angle.sin() * angle.cos()) - 2.0 * clearance * angle.sin());
    let bodies = bodies(Round::Cylinder, [radius, clearance, thickness], [young, poisson]);
    let planned = Indentation::new(1).under(Control::Load(load)).unwrap();
    let rectangle = [2e-3 * radius * 1.2, 1e-3 * length];
    let simulation = Simulation::builder(bodies, planned).line(rectangle, 1001).build().unwrap();
    let (state, ..) = states(&simulation).unwrap().pop().unwrap();
    let peak = 1e-6 * state.pressure.iter().copied().fold(0.0, f64::max);
    let area = simulation.problem.frame.area_where(|pair| state.pressure[pair] > 0.0);
    let edge = 0.5 * area / (1e-6 * length * radius);
    println!(
        "{peak} {} {} {} {edge} {angle}",
        stiffness * (distance - clearance),
        1e3 * state.approach,
        distance - clearance
    );
    // What columns neglect is of the order of the square of the thickness over the half width: (0.1/9)^2, and at the edge a thickness.
    assert_relative_eq!(peak, stiffness * (distance - clearance), max_relative = 1e-3);
    assert_relative_eq!(1e3 * state.approach, distance - clearance, max_relative = 1e-3);
    assert_relative_eq!(edge, angle, epsilon = 1e-2);
}

/// Wear of hollows that are stiff against the worn layer, under even slip: the
/// worn surface is that of the inner body moved on, so that with w the depth at the pole and cos t = c/(c + w)
/// s = R L c/(k F) (t/cos t - sin t) of a bush, 2 pi R^2/(3 k F) (w - c/2 (1 - cos^2 t)) of a socket.
#[test]
fn hollows_wear_as_rigid_ones_in_closed_form() {
    let (clearance, load, worn) = (0.1e-3, 2000.0, 0.1e-3);
    let coefficient = 1e-15;
    let angle = f64::acos(0.5);
    let [shaft, ball] = [10e-3, 14e-3];
    let bush = shaft * 20e-3 * clearance / (coefficient * load) * (angle / 0.5 - angle.sin());
    let socket = 2.0 * std::f64::consts::PI * ball * ball / (3.0 * coefficient * load)
        * (worn - 0.5 * clearance * 0.75);
    for (round, radius, distance) in [(Round::Cylinder, shaft, bush), (Round::Sphere, ball, socket)]
    {
        let [inner, outer] = bodies(round, [1e3 * radius, 1e3 * clearance, 1.0], [50e3, 0.3]);
        let outer = outer.wear(Archard::new(coefficient).unwrap());
        let stepping = Stepping::Tolerance(2e-3);
        let planned = Sliding::new().over(distance, Control::Load(load), stepping).unwrap();
        let builder = Simulation::builder([inner, outer], planned);
        let builder = match round {
            Round::Cylinder => builder.line([2.4 * radius, 20e-3], 241),
            Round::Sphere => builder.frame([2.1 * radius; 2], [65; 2]),
        };
        let simulation = builder.build().unwrap();
        let (state, effort, _) = states(&simulation).unwrap().pop().unwrap();
        let depth = state.worn(1).iter().copied().fold(0.0, f64::max);
        let frame = &simulation.problem.frame;
        let volume = frame.integrate(&state.worn(1));
        // All of what is worn: (c + w) cos - c over the cap, or the arc.
        let far = clearance + worn;
        let known = match round {
            Round::Cylinder => 2.0 * radius * 20e-3 * (far * angle.sin() - clearance * angle),
            Round::Sphere => {
                2.0 * std::f64::consts::PI
                    * radius
                    * radius
                    * (0.5 * far * (1.0 - 0.25) - clearance * 0.5)
            }
        };
        println!(
            "{round:?}: depth {depth:e} of {worn:e}, volume {volume:e} of {known:e}, {} solves, load {}",
            effort.solves, state.load
        );
        assert_relative_eq!(depth, worn, max_relative = 4e-3);
        assert_relative_eq!(volume, known, max_relative = 4e-3);
        assert_relative_eq!(state.load, load, max_relative = 1e-6);
    }
}

/// What a cup loses (mm^3, mm) under the curve after ISO 14242-1.
fn hip(layer: [f64; 3], law: impl WearLaw + 'static, cycles: Cycles) -> [f64; 2] {
    worn_hip(layer, [None, Some(Arc::new(law))], (cycles, 45))[1]
}

/// The same of the head and of the cup.
fn worn_hip(
    [thickness, young, poisson]: [f64; 3],
    laws: [Option<Arc<dyn WearLaw>>; 2],
    (cycles, elements): (Cycles, usize),
) -> [[f64; 2]; 2] {
    let mut bodies = bodies(Round::Sphere, [14.0, 0.1, thickness], [young, poisson]);
    bodies.iter_mut().zip(laws).for_each(|(body, law)| body.wear = law);
    let planned = Joint::iso_14242_1(60).unwrap().over(cycles).unwrap();
    let reach = 28e-3 * (0.5 * 68_f64.to_radians()).sin();
    let simulation = Simulation::builder(bodies, planned)
        .frame([2.0 * reach; 2], [elements; 2])
        .build()
        .unwrap();
    let mut worn = Worn::default();
    simulation.run(&mut [&mut worn]).unwrap();
    worn.0
}

/// Volume (mm^3) and depth (mm) that both bodies have lost at the end.
#[derive(Default)]
struct Worn([[f64; 2]; 2]);

impl Observer for Worn {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn Error + Send + Sync>> {
        let area = report.problem.frame.area(0);
        self.0 = report.state.surfaces.each_ref().map(|surface| {
            let depth = surface.depth.iter().copied().fold(0.0, f64::max);
            [1e9 * area * surface.depth.iter().sum::<f64>(), 1e3 * depth]
        });
        Ok(())
    }
}

/// A million cycles at the rate of the unworn cup, under the pressures of finite elements in 120 stations.
#[test]
fn unworn_cups_wear_as_under_pressures_of_finite_elements() {
    let law = Archard::new(1.0656e-15).unwrap();
    let found = hip([8.0, 1000.0, 0.4], law, Cycles::new(1000).jump(1000)).map(|one| 1e3 * one);
    println!("{found:?}");
    assert_relative_eq!(found[0], 31.406, max_relative = 1e-3);
    assert_relative_eq!(found[1], 0.18914, max_relative = 6e-3);
}

/// A million cycles whose shape is followed, by columns under a ball that is free across the load, in 60 stations on 90 x 180 places, with
/// 24 steps of Heun's method: a layer that is thin for the contact is columns but for the square of 0.4 over 12. Under a guided ball they are
/// 32.621 mm3 and 0.10481 mm, 24.458 and 0.08689.
#[test]
#[ignore = "long: in .ci/long"]
fn cups_of_thin_layers_wear_as_columns() {
    let crossing = CrossShear::new([1e-16, 2e-15]).unwrap().with_exponent(0.5).unwrap();
    let cycles = Cycles::new(1_000_000).tolerance(0.01);
    let layer = [0.4, 100.0, 0.3];
    let archard = hip(layer, Archard::new(1.0656e-15).unwrap(), cycles);
    let crossing = hip(layer, crossing, cycles);
    println!("{archard:?} {crossing:?}");
    for (found, known) in [(archard, [33.0597, 0.105707]), (crossing, [24.6942, 0.087359])] {
        assert_relative_eq!(found[0], known[0], max_relative = 2e-3);
        assert_relative_eq!(found[1], known[1], max_relative = 6e-3);
    }
}

/// What a ball of a million cycles loses, with its cup or alone, by the same columns: each place of the ball gathers what it goes through
/// as it turns, on 107 x 160 places of its own, with 16 steps of Heun's method.
#[test]
#[ignore = "long: in .ci/long"]
fn balls_in_thin_layers_wear_as_columns() {
    let cycles = Cycles::new(1_000_000).tolerance(0.02);
    let layer = [0.4, 100.0, 0.3];
    let archard = |k: f64| -> Option<Arc<dyn WearLaw>> { Some(Arc::new(Archard::new(k).unwrap())) };
    let crossing = CrossShear::new([1e-16, 2e-15]).unwrap().with_exponent(0.5).unwrap();
    let none = [0.0; 2];
    for (laws, known) in [
        ([archard(0.31968e-15), archard(1.0656e-15)], [[9.98447, 0.02769], [33.2824, 0.0994288]]),
        ([Some(Arc::new(crossing) as _), None], [[22.5507, 0.0816239], none]),
    ] {
        let found = worn_hip(layer, laws, (cycles, 41));
        println!("{found:?} {known:?}");
        for (found, known) in found.iter().zip(known) {
            assert_relative_eq!(found[0], known[0], max_relative = 3e-3);
            assert_relative_eq!(found[1], known[1], max_relative = 1e-2);
        }
    }
}

/// A ball that turns about the load alone wears as its socket would: both slide in the same circles. Its elements and those of the socket
/// are turned against each other, by which wear has no ripples.
#[test]
fn balls_that_turn_about_the_load_wear_as_their_sockets() {
    let law = || -> Option<Arc<dyn WearLaw>> { Some(Arc::new(Archard::new(1e-15).unwrap())) };
    let angles = [0.0, 20.0, 40.0, 20.0].map(|angle: f64| [0.0, 0.0, angle.to_radians()]);
    let [ball, socket] = [0, 1].map(|body| {
        let mut bodies = bodies(Round::Sphere, [14.0, 0.1, 8.0], [1000.0, 0.4]);
        bodies[body].wear = law();
        let joint = Joint::new(&angles, &[1e3; 4]).unwrap();
        let planned = joint.over(Cycles::new(500_000).jump(100_000)).unwrap();
        let simulation =
            Simulation::builder(bodies, planned).frame([24e-3; 2], [41; 2]).build().unwrap();
        let mut worn = Worn::default();
        simulation.run(&mut [&mut worn]).unwrap();
        worn.0[body]
    });
    println!("{ball:?} {socket:?}");
    assert_relative_eq!(ball[0], socket[0], max_relative = 1e-3);
    assert_relative_eq!(ball[1], socket[1], max_relative = 5e-3);
}

/// A load that is fixed in the ball wears ball and socket as one that is fixed in the socket wears socket and ball, if the ball turns the
/// other way: by the angles of the transposed matrices.
#[test]
fn loads_in_the_ball_wear_the_other_body() {
    let law = || -> Option<Arc<dyn WearLaw>> { Some(Arc::new(Archard::new(1e-15).unwrap())) };
    let angles = [[25.0, 3.0, -10.0], [5.0, 7.0, -4.0], [-18.0, -4.0, 2.0], [9.0, 0.0, -8.0]];
    let angles = angles.map(|one: [f64; 3]| one.map(f64::to_radians));
    let loads = [3e3, 1e3, 2e3, 5e2];
    let one = Joint::new(&angles, &loads).unwrap();
    let back: Vec<[f64; 3]> = (one.turns().iter())
        .map(|turn| {
            let of = |row: usize, column: usize| turn.from[column][row];
            [(-of(1, 2)).atan2(of(2, 2)), of(0, 2).asin(), (-of(0, 1)).atan2(of(0, 0))]
        })
        .collect();
    let other = Joint::new(&back, &loads).unwrap();
    let [[ball, socket], [other_ball, other_socket]] = [one.loaded_in_ball(), other].map(|joint| {
        let mut bodies = bodies(Round::Sphere, [14.0, 0.1, 0.4], [100.0, 0.3]);
        bodies.iter_mut().for_each(|body| body.wear = law());
        let planned = joint.over(Cycles::new(100_000).jump(50_000)).unwrap();
        let reach = 28e-3 * (0.5 * 68_f64.to_radians()).sin();
        let simulation =
            Simulation::builder(bodies, planned).frame([2.0 * reach; 2], [41; 2]).build().unwrap();
        let mut worn = Worn::default();
        simulation.run(&mut [&mut worn]).unwrap();
        worn.0
    });
    println!("{ball:?} {socket:?} {other_ball:?} {other_socket:?}");
    for part in [0, 1] {
        assert_relative_eq!(ball[part], other_socket[part], max_relative = 1e-6);
        assert_relative_eq!(socket[part], other_ball[part], max_relative = 1e-6);
    }
    assert!((ball[1] / socket[1] - 1.0).abs() > 0.03);
}

/// A bush as a user writes it, on a frame that follows and grows with the contact, from 9 to 70 degrees: its depth after the distance in
/// which a rigid one wears by 0.1 mm. The elastic one leaves 2e-5 of it.
#[test]
fn bushes_of_a_case_grow_with_their_contact() {
    let case = "accuracy = 0.01\n[body.shaft]\nrigid = true\nprofile.shaft.radius = \"10 mm\"\n\
        [body.bush]\nlayers = [{ thickness = \"1 mm\", young = \"50 GPa\", poisson = 0.3 }]\nsubstrate = \"rigid\"\n\
        profile.bush.radius = \"10.05 mm\"\nwear.archard.coefficient = \"1e-6 mm^3/(N m)\"\n\
        [frame]\nlength = \"20 mm\"\n[motion.sliding]\nload = \"2 kN\"\ndistance = \"13750.35 m\"\n";
    let row = answer(case, &[]);
    assert_within(&row, "wear_depth_bush_m", (0.1e-3, 2e-8), "bush");
    let angle = f64::acos(1.0 / 3.0).to_degrees();
    assert_within(&row, "edge_angle_deg", (angle, 1e-2), "bush");
}

/// A metal head in a metal cup as a user writes it, on a frame that follows: harmonics on rings, for cups of 4 mm on something rigid.
#[test]
fn heads_of_metal_in_cups_of_metal_are_a_case() {
    let case = "accuracy = 0.01\n[body.head]\nmaterial = { young = \"210 GPa\", poisson = 0.3 }\nprofile.ball.radius = \"14 mm\"\n\
        [body.cup]\nlayers = [{ thickness = \"4 mm\", young = \"210 GPa\", poisson = 0.3 }]\nsubstrate = \"rigid\"\n\
        profile.socket = { radius = \"14.03 mm\", rim = \"45 deg\" }\n\
        [motion.indentation]\nload = \"3 kN\"\n";
    let row = answer(case, &[]);
    assert_within(&row, "peak_pressure_Pa", (69.449e6, 69.449e6 * 1e-3), "head");
    assert_within(&row, "approach_m", (2.63605e-6, 2.63605e-6 * 1e-3), "head");
    assert_within(&row, "edge_angle_deg", (19.27, 0.02), "head");
}
