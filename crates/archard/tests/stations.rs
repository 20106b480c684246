//! Surfaces that roam under the contact from station to station of a table.

use std::f64::consts::{PI, TAU};

use approx::assert_relative_eq;
use archard::body::profile::{Flat, Sphere};
use archard::motion::{Control, Cycles, Row, Table, Within};
use archard::simulation::Run;
use archard::wear::{Archard, CrossShear};
use archard::{Body, Material, Simulation};

const RADIUS: f64 = 5e-3;
const LOAD: f64 = 5.0;
/// Half of what the frame measures (m), and the elements along it.
const HALF: f64 = 0.36e-3;
const ELEMENTS: usize = 48;

/// Radius of the contact (m) and its largest pressure (Pa), by Hertz.
fn hertz() -> [f64; 2] {
    let modulus = 1.0 / ((1.0 - 0.09) / 210e9 + (1.0 - 0.16) / 1e9);
    let radius = (0.75 * LOAD * RADIUS / modulus).cbrt();
    [radius, 1.5 * LOAD / (PI * radius * radius)]
}

fn ball() -> Body {
    Body::new("ball", Sphere::new(RADIUS).unwrap()).material(Material::new(210e9, 0.3).unwrap())
}

fn plate() -> Body {
    Body::new("plate", Flat).material(Material::new(1e9, 0.4).unwrap())
}

/// Stations of one load at places on body 1 and body 2 (m).
fn rows(places: &[[[f64; 2]; 2]]) -> Vec<Row> {
    let row =
        |&offsets: &[[f64; 2]; 2]| Row { duration: 0.1, control: Control::Load(LOAD), offsets };
    places.iter().map(row).collect()
}

/// The end of cycles through stations, in steps of so many.
fn gone_through(bodies: [Body; 2], rows: Vec<Row>, (cycles, step): (usize, usize)) -> Run {
    let planned = Table::new(rows).unwrap().over(Cycles::new(cycles).jump(step)).unwrap();
    let builder = Simulation::builder(bodies, planned);
    let simulation = builder.frame([2.0 * HALF; 2], [ELEMENTS; 2]).build().unwrap();
    let mut run = Run::begin(simulation).unwrap();
    while run.step().unwrap() {}
    run
}

/// Worn volume (m^3) of a body.
fn volume(run: &Run, body: usize) -> f64 {
    let (problem, state) = (&run.simulation().problem, run.report().state);
    state.surfaces[body].depth.iter().sum::<f64>() * problem.frame.area(0)
}

/// Worn depth (m) at a place (m) on a body that roams, between the elements around it, where the table shows the contact at an offset (m).
fn depth(run: &Run, body: usize, shown: [f64; 2], place: [f64; 2]) -> f64 {
    let surface = &run.report().state.surfaces[body];
    let (element, before) = (2.0 * HALF / ELEMENTS as f64, surface.grid.before());
    let [x, y] =
        [0, 1].map(|axis| (place[axis] - shown[axis] + HALF) / element - 0.5 + before[axis] as f64);
    let at = |x: f64, y: f64| surface.depth[x as usize + surface.grid.elements()[0] * y as usize];
    let (i, j) = (x.floor(), y.floor());
    let (u, v) = (x - i, y - j);
    (1.0 - v) * ((1.0 - u) * at(i, j) + u * at(i + 1.0, j))
        + v * ((1.0 - u) * at(i, j + 1.0) + u * at(i + 1.0, j + 1.0))
}

/// What a place goes through under Hertz's pressures that are led along a polygon: the integral of p over the way (Pa m), and the share of
/// it across the main direction.
fn rubbed(polygon: &[[f64; 2]], [x, y]: [f64; 2]) -> [f64; 2] {
    const PARTS: usize = 400;
    let [radius, largest] = hertz();
    let mut sums = [0.0; 3];
    for (side, from) in polygon.iter().enumerate() {
        let to = polygon[(side + 1) % polygon.len()];
        let way = [to[0] - from[0], to[1] - from[1]];
        let length = way[0].hypot(way[1]);
        let [c, s] = way.map(|part| part / length);
        for part in 0..PARTS {
            let share = (part as f64 + 0.5) / PARTS as f64;
            let [u, v] = [x - from[0] - share * way[0], y - from[1] - share * way[1]];
            let inside = 1.0 - (u * u + v * v) / (radius * radius);
            let work = largest * inside.max(0.0).sqrt() * length / PARTS as f64;
            sums = [sums[0] + work * c * c, sums[1] + work * s * s, sums[2] + work * c * s];
        }
    }
    let [xx, yy, xy] = sums;
    let smaller = 0.5 * (xx + yy - (xx - yy).hypot(2.0 * xy));
    [xx + yy, if xx + yy > 0.0 { smaller / (xx + yy) } else { 0.0 }]
}

/// An egg that is symmetric to nothing, in that many stations.
fn egg(count: usize) -> Vec<[f64; 2]> {
    let place = |station: usize| {
        let angle = TAU * station as f64 / count as f64;
        let radius = 0.5e-3 * (1.0 + 0.3 * angle.cos() + 0.1 * (2.0 * angle).sin());
        [0.3e-3 + radius * angle.cos(), -0.2e-3 + 0.8 * radius * angle.sin()]
    };
    (0..count).map(place).collect()
}

/// Both bodies wear by k F s, under loads that change and over ways on both of them.
#[test]
fn volumes_follow_from_the_loads_and_the_ways() {
    let (cycles, k) = (2000, [1e-16, 3e-16]);
    let mut stations =
        rows(&egg(20).iter().map(|&[x, y]| [[0.2 * y, -0.1 * x], [x, y]]).collect::<Vec<_>>());
    for (index, row) in stations.iter_mut().enumerate() {
        row.control = Control::Load(LOAD * (0.6 + 0.4 * (0.7 * index as f64).sin()));
    }
    let slid = |from: usize| {
        let [here, next] = [from, from + 1].map(|row| stations[row % 20].offsets);
        let part = |axis: usize| (next[1][axis] - here[1][axis]) - (next[0][axis] - here[0][axis]);
        part(0).hypot(part(1))
    };
    let load = |row: usize| match stations[row % 20].control {
        Control::Load(load) => load,
        Control::Approach(_) => f64::NAN,
    };
    let work: f64 = (0..20).map(|row| 0.5 * slid(row) * (load(row) + load(row + 1))).sum();
    let law = |k: f64| Archard::new(k).unwrap();
    let bodies = [ball().wear(law(k[0])), plate().wear(law(k[1]))];
    let run = gone_through(bodies, stations.clone(), (cycles, 500));
    for (body, k) in k.iter().enumerate() {
        assert_relative_eq!(volume(&run, body), k * work * cycles as f64, max_relative = 1e-6);
    }
    assert_relative_eq!(
        run.report().effort.load_distance,
        work * cycles as f64,
        max_relative = 1e-9
    );
}

/// What is worn off an unworn plate lies where the contact was, as deep as the pressures and the crossing of directions there ask for,
/// whichever body the plate is.
#[test]
fn plates_wear_where_the_contact_was() {
    const CYCLES: usize = 100;
    let law = || CrossShear::new([1e-16, 1e-15]).unwrap();
    let stations = egg(40);
    let coefficient = |crossing: f64| 1e-16 + 9e-16 * 2.0 * crossing;
    let expected = |place: [f64; 2]| {
        let [work, crossing] = rubbed(&stations, place);
        coefficient(crossing) * work * CYCLES as f64
    };
    let deepest = stations.iter().map(|&place| expected(place)).fold(0.0, f64::max);
    for plate_is in [0, 1] {
        let places: Vec<_> = stations
            .iter()
            .map(|&place| if plate_is == 1 { [[0.0; 2], place] } else { [place, [0.0; 2]] })
            .collect();
        let mut bodies = [ball(), plate().wear(law())];
        if plate_is == 0 {
            bodies.reverse();
        }
        let run = gone_through(bodies, rows(&places), (CYCLES, CYCLES));
        for place in [
            [0.0, 0.0],
            [0.3, -0.2],
            [0.8, -0.2],
            [0.95, -0.1],
            [0.2, 0.35],
            [-0.2, -0.1],
            [0.4, -0.6],
        ] {
            let place = place.map(|part| 1e-3 * part);
            let found = depth(&run, plate_is, stations[0], place);
            let error = (found - expected(place)).abs() / deepest;
            assert!(error < 0.02, "{plate_is} {place:?}: {found:e} {:e}", expected(place));
        }
    }
}

/// A ball that circles keeps its place under the contact and slides through all directions there.
#[test]
fn balls_that_circle_wear_by_crossing_directions() {
    const CYCLES: usize = 10;
    let law = CrossShear::new([1e-16, 1e-15]).unwrap();
    let circle = |station: usize| {
        let angle = TAU * station as f64 / 36.0;
        [[0.0; 2], [0.4e-3 * angle.cos(), 0.4e-3 * angle.sin()]]
    };
    let stations: Vec<_> = (0..36).map(circle).collect();
    let bodies = [ball().wear(law), plate()];
    let run = gone_through(bodies, rows(&stations), (CYCLES, CYCLES));
    let way = 36.0 * 0.8e-3 * (PI / 36.0).sin() * CYCLES as f64;
    assert_relative_eq!(volume(&run, 0), 1e-15 * LOAD * way, max_relative = 1e-6);
    // To and fro there is one direction.
    let line = [[[0.0; 2], [0.0; 2]], [[0.0; 2], [0.4e-3, 0.0]]];
    let run = gone_through([ball().wear(law), plate()], rows(&line), (CYCLES, CYCLES));
    let way = 0.8e-3 * CYCLES as f64;
    assert_relative_eq!(volume(&run, 0), 1e-16 * LOAD * way, max_relative = 1e-6);
}

/// Where the way turns at a corner, a station slides along one side and then along the other: a square of its corners alone crosses as one of
/// many stations does.
#[test]
fn corners_cross_as_their_sides_do() {
    let square = |parts: usize| {
        let corners = [[-0.3e-3, -0.3e-3], [0.3e-3, -0.3e-3], [0.3e-3, 0.3e-3], [-0.3e-3, 0.3e-3]];
        let place = |at: usize| {
            let (from, to) = (corners[at / parts], corners[(at / parts + 1) % 4]);
            let share = (at % parts) as f64 / parts as f64;
            [[0.0; 2], [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis]))]
        };
        let law = || CrossShear::new([1e-16, 1e-14]).unwrap();
        let places: Vec<_> = (0..4 * parts).map(place).collect();
        let run = gone_through([ball(), plate().wear(law())], rows(&places), (10, 10));
        volume(&run, 1)
    };
    let [few, many] = [square(1), square(24)];
    assert!((few / many - 1.0).abs() < 0.03, "{few} {many}");
    // Without crossing it would be the hundredth.
    assert!(many > 10.0 * 1e-16 * LOAD * 4.0 * 0.6e-3 * 10.0);
}

/// Stations are left out by load and distance: laws that ask for directions need all of them.
#[test]
fn laws_of_directions_need_all_stations() {
    let places: Vec<_> = egg(400).into_iter().map(|place| [[0.0; 2], place]).collect();
    let within = Within { share: 0.05, way: 0.2e-3 };
    let built = |wear: CrossShear| {
        let table = Table::merging(&rows(&places), within).unwrap();
        let planned = table.over(Cycles::new(10).jump(10)).unwrap();
        let builder = Simulation::builder([ball(), plate().wear(wear)], planned);
        builder.frame([2.0 * HALF; 2], [ELEMENTS; 2]).build()
    };
    let refused = built(CrossShear::new([1e-16, 1e-14]).unwrap()).unwrap_err().to_string();
    assert!(refused.contains("directions"), "{refused}");
}
