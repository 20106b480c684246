//! Surfaces made up with scars of known section and volume.

use std::fmt::Write;

use super::{NoScar, Scar, Surface, Unworn};
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

/// A profile in mm and um around a place on a flat, tilted by 3 um/mm, with debris and noise.
fn profile(middle: f64, length: f64, random: &mut Normal) -> Surface {
    let row = |i: i32| {
        let x = length * f64::from(i) / 800.0;
        let debris = if (40..46).contains(&i) { 3e-6 } else { 0.0 };
        let z = 20e-6 + 3e-3 * x - worn(x - middle) + debris + NOISE * random.draw();
        vec![1e3 * x, 1e6 * z]
    };
    let rows: Vec<Vec<f64>> = (0..=800).map(row).collect();
    surface("x [mm],z [um]", rows.into_iter())
}

/// A map of a worn ball in mm and um, tilted along both axes; `gap` says where there is no reading.
fn bowl(middle: [f64; 2], gap: impl Fn(f64, f64) -> bool, random: &mut Normal) -> Surface {
    let mut rows = vec![];
    for j in 0..=90 {
        for i in 0..=100 {
            let [x, y] = [12e-6 * f64::from(i), 12e-6 * f64::from(j)];
            let [u, v] = [x - middle[0], y - middle[1]];
            let z = sphere([u, v]) - 5e-6 + 2e-3 * x - 1e-3 * y - worn(u.hypot(v))
                + NOISE * random.draw();
            rows.push(vec![1e3 * x, 1e3 * y, if gap(u, v) { f64::NAN } else { 1e6 * z }]);
        }
    }
    surface("x [mm],y [mm],z [um]", rows.into_iter())
}

const FLAT: Unworn<'_> = Unworn { height: &|_| 0.0, through: [false; 2] };
const BALL: Unworn<'_> = Unworn { height: &sphere, through: [false; 2] };

/// The section lies within the stated uncertainty as often as it says, and so do tilt and place.
#[test]
fn grooves_are_measured_wherever_they_lie() {
    let mut random = Normal(fastrand::Rng::with_seed(2));
    let section = 4.0 / 3.0 * DEPTH * HALF;
    let mut squares = 0.0;
    for round in 0..60 {
        let middle = 0.5e-3 + 1e-5 * f64::from(round);
        let scar = Scar::find(&profile(middle, 1.6e-3, &mut random), FLAT).unwrap();
        squares += ((scar.worn - section) / scar.uncertainty).powi(2) / 60.0;
        assert!((scar.plane.tilt[0] - 3e-3).abs() < 1e-4, "{scar:?}");
        assert!((scar.middle[0] - middle).abs() < 5e-6, "{scar:?}");
        assert!((scar.deepest / DEPTH - 1.0).abs() < 0.06, "{scar:?}");
        assert!(scar.uncertainty < 0.02 * section);
    }
    // The mean square of 60 is 1 +- 0.18.
    assert!((0.5..1.6).contains(&squares), "{squares}");
}

/// Where more of a profile is worn than not, the level is found all the same.
#[test]
fn wide_scars_are_levelled_by_what_is_left() {
    let mut random = Normal(fastrand::Rng::with_seed(4));
    let scar = Scar::find(&profile(0.45e-3, 1.0e-3, &mut random), FLAT).unwrap();
    let section = 4.0 / 3.0 * DEPTH * HALF;
    assert!((scar.worn - section).abs() < 3.0 * scar.uncertainty, "{scar:?}");
    // From nine tenths of it on nothing is left to level by.
    for (middle, length) in [(0.32e-3, 0.64e-3), (0.25e-3, 0.5e-3), (0.1e-3, 0.8e-3)] {
        let refused = Scar::find(&profile(middle, length, &mut random), FLAT).unwrap_err();
        let said = refused.to_string();
        assert!(said.contains("measure") || said.contains("no scar stands out"), "{said}");
    }
}

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

/// The map of a track tells its mean section.
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
    let track = Unworn { through: [true, false], ..FLAT };
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
    let shape = Scar::find(&made(&|_| 0.0), Unworn { height: &|[x, _]| -100.0 * x * x, ..FLAT });
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
        ("x [mm],y [mm],z [um]\n0,1,1\n1,2,1\n2,3,1\n3,4,1\n", "of a grid of 4 by 4 places 4 have"),
    ] {
        let error = refused(text);
        assert!(error.contains(said), "{text}: {error}");
    }
}
