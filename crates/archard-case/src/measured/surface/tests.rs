//! Surfaces made up with scars of known section and volume.

use std::fmt::Write;

use super::{NoScar, Scar, Surface, UnwornSurface};
use crate::measured::Table;

/// Numbers of a normal distribution, by Box and Muller.
struct Normal(fastrand::Rng);

impl Normal {
    fn draw(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.0.f64()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.0.f64()).cos()
    }
}

const DEPTH: f64 = 2e-6;
const HALF: f64 = 0.3e-3;
const RADIUS: f64 = 50e-3;
const NOISE: f64 = 0.1e-6;

/// A groove of parabolic section, 4/3 of depth times half width, or a bowl, of half its cylinder.
fn worn(distance: f64) -> f64 {
    DEPTH * (1.0 - (distance / HALF).powi(2)).max(0.0)
}

fn sphere([x, y]: [f64; 2]) -> f64 {
    -(x * x + y * y) / (RADIUS + (RADIUS * RADIUS - x * x - y * y).sqrt())
}

fn surface(header: &str, rows: impl Iterator<Item = Vec<f64>>) -> Surface {
    let mut text = format!("{header}\n");
    for row in rows {
        let cells: Vec<String> = row
            .iter()
            .map(|x| if x.is_nan() { String::new() } else { format!("{x:.9}") })
            .collect();
        let _ = writeln!(text, "{}", cells.join(","));
    }
    Surface::of(&Table::read("scar.csv", text.as_bytes()).unwrap()).unwrap()
}

/// A map of a worn ball in mm and um, tilted along both axes; `gap` says where there is no reading.
fn bowl(middle: [f64; 2], gap: impl Fn(f64, f64) -> bool, random: &mut Normal) -> Surface {
    failing(middle, |u, v| if gap(u, v) { f64::NAN } else { 0.0 }, random)
}

/// The same with readings that are off by so much (m).
fn failing(middle: [f64; 2], mut off: impl FnMut(f64, f64) -> f64, random: &mut Normal) -> Surface {
    let mut rows = vec![];
    for j in 0..=90 {
        for i in 0..=100 {
            let [x, y] = [12e-6 * f64::from(i), 12e-6 * f64::from(j)];
            let [u, v] = [x - middle[0], y - middle[1]];
            let z = sphere([u, v]) - 5e-6 + 2e-3 * x - 1e-3 * y - worn(u.hypot(v))
                + NOISE * random.draw();
            rows.push(vec![1e3 * x, 1e3 * y, 1e6 * (z + off(u, v))]);
        }
    }
    surface("x [mm],y [mm],z [um]", rows.into_iter())
}

const FLAT: UnwornSurface<'_> = UnwornSurface { height: &|_| 0.0, through: [false; 2] };
const BALL: UnwornSurface<'_> = UnwornSurface { height: &sphere, through: [false; 2] };

#[test]
fn the_volume_of_a_worn_ball_is_that_of_the_bowl() {
    let mut random = Normal(fastrand::Rng::with_seed(6));
    let volume = 0.5 * std::f64::consts::PI * HALF * HALF * DEPTH;
    let mut squares = 0.0;
    for round in 0..12 {
        let middle = [0.55e-3 + 5e-6 * f64::from(round), 0.5e-3];
        let scar = Scar::find(&bowl(middle, |_, _| false, &mut random), BALL).unwrap();
        squares += ((scar.worn - volume) / scar.uncertainty).powi(2) / 12.0;
        assert!((scar.worn / volume - 1.0).abs() < 0.02, "{scar:?}");
        assert!((scar.middle[0] - middle[0]).hypot(scar.middle[1] - middle[1]) < 5e-6);
    }
    // The mean square of 12 is 1 +- 0.4.
    assert!((0.2..2.2).contains(&squares), "{squares}");
}

/// Single readings that failed are bridged; a scar that was not seen is refused.
#[test]
fn gaps_are_bridged_as_far_as_they_are_few() {
    let mut random = Normal(fastrand::Rng::with_seed(8));
    let volume = 0.5 * std::f64::consts::PI * HALF * HALF * DEPTH;
    let speckled = |u: f64, v: f64| ((1e6 * u) as i64 * 7 + (1e6 * v) as i64 * 3) % 11 == 0;
    let scar = Scar::find(&bowl([0.6e-3, 0.5e-3], speckled, &mut random), BALL).unwrap();
    assert!((scar.worn / volume - 1.0).abs() < 0.02 && scar.gaps > 100, "{scar:?}");
    let unseen = |u: f64, v: f64| u.hypot(v) < 0.2e-3;
    let refused = Scar::find(&bowl([0.6e-3, 0.5e-3], unseen, &mut random), BALL).unwrap_err();
    assert!(matches!(refused, NoScar::Gaps { .. }), "{refused}");
}

/// The map of a track gives its mean section.
#[test]
fn a_track_runs_through_its_map() {
    let mut random = Normal(fastrand::Rng::with_seed(10));
    let mut rows = vec![];
    for j in 0..=80 {
        for i in 0..=30 {
            let [x, y] = [20e-6 * f64::from(i), 15e-6 * f64::from(j)];
            let z = 4e-6 - 1e-3 * x + 2e-3 * y - worn(y - 0.65e-3) + NOISE * random.draw();
            rows.push(vec![1e3 * x, 1e3 * y, 1e6 * z]);
        }
    }
    let map = surface("x [mm],y [mm],z [um]", rows.into_iter());
    let track = UnwornSurface { through: [true, false], ..FLAT };
    let scar = Scar::find(&map, track).unwrap();
    let section = 4.0 / 3.0 * DEPTH * HALF;
    assert!((scar.worn - section).abs() < 4.0 * scar.uncertainty, "{scar:?}");
    assert!(scar.uncertainty < 0.01 * section, "{scar:?}");
    // Taken for a bowl it has no end.
    let refused = Scar::find(&map, FLAT).unwrap_err();
    assert_eq!(refused, NoScar::Fills { axis: "x" });
}

#[test]
fn surfaces_without_a_scar_are_refused() {
    let mut random = Normal(fastrand::Rng::with_seed(12));
    let mut made = |z: &dyn Fn(f64) -> f64| {
        let row = |i: i32| vec![f64::from(i), z(f64::from(i) - 200.0) + 0.1 * random.draw()];
        let rows: Vec<Vec<f64>> = (0..=400).map(row).collect();
        surface("x [um],z [um]", rows.into_iter())
    };
    // Nothing is worn; depths for heights; a ball whose shape was taken off.
    let flat = Scar::find(&made(&|_| 0.0), FLAT);
    let pile = Scar::find(&made(&|x| 2.0 * (1.0 - (x / 100.0).powi(2)).max(0.0)), FLAT);
    let shape =
        Scar::find(&made(&|_| 0.0), UnwornSurface { height: &|[x, _]| -100.0 * x * x, ..FLAT });
    for refused in [flat, pile, shape] {
        let said = refused.unwrap_err().to_string();
        assert!(said.contains("units") || said.contains("lies beside it"), "{said}");
    }
}

#[test]
fn tables_that_are_no_surfaces() {
    let refused = |text: &str| {
        let table = Table::read("scar.csv", text.as_bytes()).unwrap();
        Surface::of(&table).unwrap_err().to_string()
    };
    for (text, said) in [
        ("a [mm],z [um]\n0,1\n", "a profile has columns `x` (or `y`) and `z`"),
        ("x [mm],h [um]\n0,1\n", "a column `z [mm]` is needed"),
        ("x [mm],z [N]\n0,1\n", "title it like `z [mm]`"),
        ("x [mm],z\n0,1\n", "has no unit"),
        ("x [mm],z [um]\n,1\n", "needs a value in every row"),
        ("x [mm],z [um]\n0,\n1,\n", "no place has a height"),
        ("x [mm],y [mm],z [um]\n0,0,\n1,0,\n", "no place has a height"),
        ("x [mm],y [mm],z [um]\n0,1,1\n1,2,1\n2,3,1\n3,4,1\n", "of a grid of 4 by 4 places 4 have"),
    ] {
        let error = refused(text);
        assert!(error.contains(said), "{text}: {error}");
    }
}

const SECTION: f64 = 4.0 / 3.0 * DEPTH * HALF;
const VOLUME: f64 = 0.5 * std::f64::consts::PI * HALF * HALF * DEPTH;

/// Readings that failed, low or high, many or few, change nothing beyond the uncertainty.
#[test]
fn readings_that_failed_are_left_out() {
    let mut random = Normal(fastrand::Rng::with_seed(14));
    for (share, off) in [(0.005, -5e-6), (0.01, -20e-6), (0.01, 20e-6), (0.03, -9999e-6)] {
        let mut chance = fastrand::Rng::with_seed(15);
        let pits = |_: f64, _: f64| if chance.f64() < share { off } else { 0.0 };
        let map = failing([0.6e-3, 0.5e-3], pits, &mut random);
        let scar = Scar::find(&map, BALL).unwrap();
        assert!(scar.gaps > 0 && (scar.worn - VOLUME).abs() < 3.0 * scar.uncertainty, "{scar:?}");
    }
}

/// A number that stands for lost readings is not a height, however many of them lie side by side.
#[test]
fn marks_of_lost_readings_are_no_heights() {
    let mut random = Normal(fastrand::Rng::with_seed(24));
    for mark in [0.0, -9999.0, 9999.0] {
        let rows: Vec<Vec<f64>> = (0..=800)
            .map(|i| {
                let x = 2e-6 * f64::from(i);
                let z = 20e-6 + 3e-3 * x - worn(x - 0.7e-3) + NOISE * random.draw();
                let lost = (30..50).contains(&i)
                    || (340..360).contains(&i)
                    || (480..500).contains(&i)
                    || i % 90 == 0;
                vec![1e3 * x, if lost { mark } else { 1e6 * z }]
            })
            .collect();
        let scar = Scar::find(&surface("x [mm],z [um]", rows.into_iter()), FLAT).unwrap();
        assert!((scar.worn - SECTION).abs() < 3.0 * scar.uncertainty, "{mark}: {scar:?}");
        assert!(scar.gaps > 40 && scar.uncertainty < 0.01 * SECTION, "{mark}: {scar:?}");
    }
}

/// What a hole may hide is in the uncertainty.
#[test]
fn holes_make_a_volume_uncertain() {
    let mut random = Normal(fastrand::Rng::with_seed(16));
    for (hole, most) in [(0.1, 0.01), (0.3, 0.02), (0.5, 0.09), (0.55, 0.12)] {
        for aside in [0.0, 0.3] {
            let unseen = |u: f64, v: f64| (u - aside * HALF).hypot(v) < hole * HALF;
            let scar = Scar::find(&bowl([0.6e-3, 0.5e-3], unseen, &mut random), BALL).unwrap();
            assert!((scar.worn - VOLUME).abs() < 2.5 * scar.uncertainty, "{hole}: {scar:?}");
            assert!(scar.uncertainty < most * VOLUME && scar.gaps > 0, "{hole}: {scar:?}");
        }
    }
}

/// Five to thirty readings across a groove, wherever they fall, and next to no noise.
#[test]
fn few_readings_across_a_groove_tell_it_as_well_as_is_stated() {
    let mut random = Normal(fastrand::Rng::with_seed(18));
    for (across, most) in [(5.0, 0.08), (7.0, 0.04), (10.0, 0.02), (30.0, 0.003)] {
        let step = 2.0 * HALF / across;
        for phase in 0..10 {
            let middle = step * 0.1 * f64::from(phase);
            let count = (2.2 * across) as i32;
            let z = |x: f64, noise: f64| 1e6 * (1e-3 * x - worn(x - middle) + 1e-9 * noise);
            let places = || (-count..=count).map(|i| step * f64::from(i));
            let rows: Vec<Vec<f64>> =
                places().map(|x| vec![1e3 * x, z(x, random.draw())]).collect();
            let profile = surface("y [mm],z [um]", rows.into_iter());
            let rows: Vec<Vec<f64>> = places()
                .flat_map(|x| [0.0, 0.1, 0.2].map(|along| (along, x)))
                .map(|(along, x)| vec![along, 1e3 * x, z(x, random.draw())])
                .collect();
            let map = surface("x [mm],y [mm],z [um]", rows.into_iter());
            for surface in [profile, map] {
                let scar =
                    Scar::find(&surface, UnwornSurface { through: [true, false], ..FLAT }).unwrap();
                let off = (scar.worn - SECTION).abs();
                assert!(off < 2.0 * scar.uncertainty, "{across} {phase}: {scar:?}");
                assert!(scar.uncertainty < most * SECTION, "{across}: {scar:?}");
            }
        }
    }
}

/// The map of a track of two to five lines, and of one that lies askew.
#[test]
fn a_track_is_measured_square_to_it() {
    let mut random = Normal(fastrand::Rng::with_seed(20));
    let mut track = |degrees: f64, [columns, rows]: [i32; 2]| {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let places = |count: i32, length: f64| {
            (0..=count).map(move |i| length * (f64::from(i) / f64::from(count) - 0.5))
        };
        let rows: Vec<Vec<f64>> = places(rows, 2.4e-3)
            .flat_map(|y| places(columns, 0.6e-3).map(move |x| (x, y)))
            .map(|(x, y)| {
                let z = 2e-3 * y - worn(y * cosine - x * sine) + NOISE * random.draw();
                vec![1e3 * x, 1e3 * y, 1e6 * z]
            })
            .collect();
        let map = surface("x [mm],y [mm],z [um]", rows.into_iter());
        Scar::find(&map, UnwornSurface { through: [true, false], ..FLAT })
    };
    for (degrees, columns) in
        [(0.0, 1), (0.0, 2), (0.0, 3), (0.0, 4), (-5.0, 1), (20.0, 3), (30.0, 30)]
    {
        let scar = track(degrees, [columns, 200]).unwrap();
        assert!((scar.worn - SECTION).abs() < 3.0 * scar.uncertainty, "{degrees}: {scar:?}");
        assert!((scar.angle.to_degrees() - degrees).abs() < 1.2, "{degrees}: {scar:?}");
        assert!(scar.gaps == 0 && scar.uncertainty < 0.02 * SECTION, "{scar:?}");
    }
    // As uncertain as it says, with that of the angle.
    let off =
        |_| track(30.0, [6, 200]).map(|scar| (scar.worn - SECTION) / scar.uncertainty).unwrap();
    let spread = (0..200).map(off).map(|off: f64| off * off).sum::<f64>() / 200.0;
    assert!((0.6..1.5).contains(&spread), "{spread}");
    let refused = track(0.0, [30, 12]).unwrap_err();
    assert!(matches!(refused, NoScar::Coarse { axis: "y", .. }), "{refused}");
}

#[test]
fn a_few_readings_are_no_surface_with_a_scar() {
    let rows = (0..17).map(|i| vec![f64::from(i), 0.0]);
    let refused = Scar::find(&surface("x [um],z [um]", rows), FLAT).unwrap_err();
    assert_eq!(refused, NoScar::Few { readings: 17, least: 18 });
}

/// What it costs that the body had another radius than the case says, which no uncertainty knows: a scar 0.91 mm wide and
/// 2.08 um deep, on a ball 1 % larger than the 50 mm of the case.
#[test]
fn form_error_is_in_no_uncertainty() {
    const WIDE: f64 = 0.456e-3;
    const DEEP: f64 = 2.08e-6;
    let height = |r: f64| {
        let radius: f64 = 1.01 * RADIUS;
        let depth = DEEP * (1.0 - (r / WIDE).powi(2)).max(0.0);
        -r * r / (radius + (radius * radius - r * r).sqrt()) - depth
    };
    let mut random = Normal(fastrand::Rng::with_seed(22));
    let places =
        |count: i32| (-count..=count).map(move |i| 0.9e-3 * f64::from(i) / f64::from(count));
    let mut noisy = |r: f64| 1e6 * (height(r) + 0.05e-6 * random.draw());
    let found = |rows: Vec<Vec<f64>>, truth: f64| {
        let head = if rows[0].len() == 2 { "x [mm],z [um]" } else { "x [mm],y [mm],z [um]" };
        let scar = Scar::find(&surface(head, rows.into_iter()), BALL).unwrap();
        [scar.worn, scar.uncertainty].map(|own| 100.0 * own / truth)
    };
    let mut sections: Vec<[f64; 2]> = (0..9)
        .map(|_| {
            let rows = places(400).map(|x| vec![1e3 * x, noisy(x)]).collect();
            found(rows, 4.0 / 3.0 * DEEP * WIDE)
        })
        .collect();
    sections.sort_by(|one, other| one[0].total_cmp(&other[0]));
    assert!((103.3..105.3).contains(&sections[4][0]) && sections[4][1] < 1.0, "{sections:?}");
    let rows = places(60)
        .flat_map(|y| places(60).map(move |x| (x, y)))
        .map(|(x, y)| vec![1e3 * x, 1e3 * y, noisy(x.hypot(y))])
        .collect();
    let volume = found(rows, 0.5 * std::f64::consts::PI * WIDE * WIDE * DEEP);
    assert!((107.0..111.0).contains(&volume[0]) && volume[1] < 2.0, "{volume:?}");
}

#[test]
fn columns_of_surfaces_are_known_by_their_names() {
    for name in ["x", "Z", "z [um]", "y_mm"] {
        assert!(Surface::has_column(name), "{name}");
    }
    for name in ["zeit", "x_ray", "depth", "z_score"] {
        assert!(!Surface::has_column(name), "{name}");
    }
}

/// A file of Gwyddion with heights 3 x - 50 y + 7 x y (nm) of 5 x 4 points, one of them masked, in pixels of 2 x 3 um; by
/// `archard-surface/tests/files/make.py`.
#[test]
fn files_of_instruments_are_height_maps() {
    let bytes = include_bytes!("../../../../archard-surface/tests/files/gwyfile.gwy");
    let of = |name: &str, memory: f64| Surface::of_file(name, bytes, memory);
    let surface = of("scan.gwy", 1e6).unwrap().unwrap();
    assert_eq!((surface.axis(), surface.source()), (None, "scan.gwy"));
    let readings = surface.readings();
    assert_eq!(readings.len(), 19);
    for [x, y, z] in readings {
        let [x, y] = [x / 2e-6 + 2.0, y / 3e-6 + 1.5];
        assert!((z - 1e-9 * (3.0 * x - 50.0 * y + 7.0 * x * y)).abs() < 1e-15, "{x} {y} {z}");
    }
    assert!(of("scan.csv", 1e6).is_none());
    let error = of("scan.x3p", 1e6).unwrap().unwrap_err().to_string();
    assert!(error.starts_with("scan.x3p: is no X3P (.x3p) file: it is Gwyddion"), "{error}");
    let error = of("scan.gwy", 5e2).unwrap().unwrap_err().to_string();
    assert!(error.contains("5 x 4 points take"), "{error}");
}
