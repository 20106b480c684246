//! Whole profiles and height maps as data of a fit: made up by runs, tilted, shifted and noisy as instruments give them.

use std::error::Error as StdError;
use std::fmt::Write;
use std::fs;
use std::path::Path;

use archard::simulation::{Observer, Report};
use archard_case::CaseFile;
use archard_case::measured::Table;
use archard_lab::{Error, Files, Fit, Request, fit};

use super::made::{Normal, Until, published};

const KEY: &str = "wear.archard.coefficient";
/// Standard deviation of a height (m), and of log k between tests.
const NOISE: f64 = 0.05e-6;
const SCATTER: f64 = 0.15;

/// What is worn off a body on its grid, half way and at the end.
struct Worn {
    body: usize,
    /// Places (m) along x and y.
    places: [Vec<f64>; 2],
    /// How far (m), and depths (m).
    at: Vec<(f64, Vec<f64>)>,
}

impl Observer for Worn {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        let (frame, state) = (&report.problem.frame, report.state);
        let (size, spacing, elements) = (frame.size(), frame.spacing(), frame.elements());
        self.places = [0, 1].map(|axis| {
            let place = |i: usize| (i as f64 + 0.5) * spacing[axis] - 0.5 * size[axis];
            (0..elements[axis]).map(place).collect()
        });
        if report.output && state.progress > 0.0 {
            self.at.push((state.progress, state.worn(self.body).into_owned()));
        }
        Ok(())
    }
}

impl Worn {
    /// The depth at a place (m), between the elements; none beyond the frame.
    fn depth(&self, depths: &[f64], place: [f64; 2]) -> f64 {
        let mut corner = [[0; 2]; 2];
        let mut share = [0.0; 2];
        for axis in 0..2 {
            let places = &self.places[axis];
            let next = places.partition_point(|known| *known < place[axis]);
            if next == 0 || next == places.len() {
                return 0.0;
            }
            corner[axis] = [next - 1, next];
            share[axis] = (place[axis] - places[next - 1]) / (places[next] - places[next - 1]);
        }
        let at = |x: usize, y: usize| depths[corner[0][x] + self.places[0].len() * corner[1][y]];
        let row = |y: usize| at(0, y) + share[0] * (at(1, y) - at(0, y));
        row(0) + share[1] * (row(1) - row(0))
    }
}

fn fitted(dir: &Path, file: &CaseFile, text: &str) -> Result<Fit, Error> {
    fitted_with(dir, file, (text, &[]))
}

fn fitted_with(
    dir: &Path,
    file: &CaseFile,
    (text, uncertain): (&str, &[(String, f64)]),
) -> Result<Fit, Error> {
    let table = Table::read("tests.csv", text.as_bytes()).unwrap();
    // A column that only maps have may be named too.
    let files = Files { folder: dir, columns: &[("z", "Tiefe [um]"), ("y", "Breite")] };
    let request = Request {
        parameters: &[],
        uncertain,
        // The ball on the track is not measured.
        assumed: &["body.ball.wear.archard.coefficient".to_owned()],
        files,
        dir,
        store: None,
        following: &mut Until(None, vec![]),
    };
    fit(file, &table, request)
}

/// What was worn off by a coefficient (1/Pa), a distance (m) and depths (m) on the grid: a section (m^2) or volume (m^3).
type Truth = dyn Fn((f64, f64), &Worn, &[f64]) -> f64;

/// Tests with coefficients of their own around a median, each measured half way and at the end by what writes a surface: the
/// table, and what was worn off.
fn made(
    dir: &Path,
    file: &CaseFile,
    (body, index, median): (&str, usize, f64),
    truth: &Truth,
    write: &mut dyn FnMut(&Worn, &[f64]) -> String,
) -> (String, Vec<f64>) {
    let mut random = Normal(fastrand::Rng::with_seed(21));
    let (mut table, mut truths) = ("test,distance_m,file\n".to_owned(), vec![]);
    for test in 0..4 {
        let k = median * (SCATTER * random.draw()).exp();
        let own = file.clone().set(format!("body.{body}.{KEY}=\"{k:e} 1/Pa\""));
        let mut worn = Worn { body: index, places: Default::default(), at: vec![] };
        own.resolve().unwrap().case.build().unwrap().run(&mut [&mut worn]).unwrap();
        for (place, (progress, depths)) in worn.at.iter().enumerate() {
            let name = format!("t{test}_{place}.csv");
            fs::write(dir.join(&name), write(&worn, depths)).unwrap();
            let _ = writeln!(table, "T{test},{progress},{name}");
            truths.push(truth((k, *progress), &worn, depths));
        }
    }
    (table, truths)
}

/// The section along an axis of what is worn off, by straight lines between the elements.
fn section(axis: usize) -> impl Fn((f64, f64), &Worn, &[f64]) -> f64 {
    move |_, worn, depths| {
        let places = &worn.places[axis];
        let depth = |own: f64| worn.depth(depths, if axis == 0 { [own, 0.0] } else { [0.0, own] });
        places.iter().map(|place| depth(*place)).sum::<f64>() * (places[1] - places[0])
    }
}

/// The load of the pin (N).
const LOAD: f64 = 10.2;

/// What is taken from each file is what was worn off, to three of its uncertainties, and the median lies in its interval.
fn assert_found(found: &Fit, median: f64, truths: &[f64]) {
    for (surface, truth) in found.surfaces.iter().zip(truths) {
        let (worn, uncertainty) = surface.worn();
        let off = (worn - truth) / uncertainty;
        assert!(off.abs() < 3.0, "{truth:e}, off by {off:.1}: {surface}");
        assert!(uncertainty < 0.02 * truth, "{surface}");
    }
    let estimate = &found.coefficients[0].estimate;
    let [low, high] = estimate.interval.unwrap();
    assert!(low < median && median < high, "{median:e}: {found}");
    assert!(estimate.understated.is_none(), "{found}");
    assert!(estimate.between.unwrap() < 3.0 * SCATTER, "{found}");
    assert_eq!(found.coefficients[0].rejected(), None);
    assert_eq!((found.surfaces.len(), truths.len()), (8, 8));
}

fn sphere(x: f64, y: f64) -> f64 {
    -(x * x + y * y) / (50e-3 + (50e-3 * 50e-3 - x * x - y * y).sqrt())
}

const PIN: [&str; 2] = ["motion.sliding.step=\"10 mm\"", "output.every=\"250 mm\""];

#[test]
fn a_pin_is_fitted_by_raw_profiles() {
    let (dir, file) = (tempfile::tempdir().unwrap(), published("pin_on_disc", &PIN));
    let mut random = Normal(fastrand::Rng::with_seed(1));
    let pin = ("pin", 0, 1.33e-13);
    let (text, truths) = made(dir.path(), &file, pin, &section(0), &mut |worn, depths| {
        let mut text = "x [mm];Tiefe [um]\n".to_owned();
        for i in -300..=300 {
            let x = 4e-6 * f64::from(i);
            let z = sphere(x, 0.0) - worn.depth(depths, [x, 0.0]) + NOISE * random.draw();
            let place = x + 3.4e-3;
            let z = z + 12e-6 + 4e-3 * place;
            text += &format!("{:.5};{:.5}\n", 1e3 * place, 1e6 * z).replace('.', ",");
        }
        text
    });
    let found = fitted(dir.path(), &file, &text).unwrap();
    assert_found(&found, 1.33e-13, &truths);
    let words = found.to_string();
    assert!(words.contains("`t0_1.csv`: profile_x") && words.contains("um/mm"), "{words}");
}

#[test]
fn a_pin_is_fitted_by_height_maps() {
    let (dir, file) = (tempfile::tempdir().unwrap(), published("pin_on_disc", &PIN));
    let mut random = Normal(fastrand::Rng::with_seed(2));
    let pin = ("pin", 0, 1.33e-13);
    // Archard's law, whatever the contact: k F s.
    let volume = |(k, s): (f64, f64), _: &Worn, _: &[f64]| k * LOAD * s;
    let (text, truths) = made(dir.path(), &file, pin, &volume, &mut |worn, depths| {
        let mut text = "x [mm],y [mm],Tiefe [um]\n".to_owned();
        for (i, j) in (-50..=50).flat_map(|j| (-50..=50).map(move |i| (i, j))) {
            let [x, y] = [i, j].map(|i| 18e-6 * f64::from(i));
            let worn = worn.depth(depths, [x, y]);
            let z = sphere(x, y) - worn + NOISE * random.draw() - 2e-3 * x + 1e-3 * y;
            // Where the surface reflects nothing.
            let cell =
                if (i * 7 + j * 3) % 23 == 0 { String::new() } else { format!("{:.4}", 1e6 * z) };
            let _ = writeln!(text, "{:.4},{:.4},{cell}", 1e3 * x + 5.0, 1e3 * y - 3.0);
        }
        text
    });
    let found = fitted(dir.path(), &file, &text).unwrap();
    assert_found(&found, 1.33e-13, &truths);
    assert!(found.to_string().contains("places in it have no reading"), "{found}");
}

/// Profiles across the track and maps of it tell the same section.
#[test]
fn a_track_is_fitted_by_profiles_and_maps() {
    let coarse = ["frame.elements=[32, 32]", "motion.sliding.tolerance=0.01"];
    let (dir, file) = (tempfile::tempdir().unwrap(), published("pin_on_disc_track", &coarse));
    let file = file.set("output.every=\"500 m\"");
    let mut random = Normal(fastrand::Rng::with_seed(3));
    let mut count = 0;
    let (text, truths) =
        made(dir.path(), &file, ("disc", 1, 5e-15), &section(1), &mut |worn, depths| {
            count += 1;
            let columns = if count % 2 == 0 { 1 } else { 8 };
            let mut text =
                if columns == 1 { "y [mm],Tiefe [um]\n" } else { "x [mm],y [mm],Tiefe [um]\n" }
                    .to_owned();
            let last = *worn.places[1].last().unwrap();
            for (i, j) in (-150..=150).flat_map(|j| (0..columns).map(move |i| (i, j))) {
                let [x, y] = [0.1e-3 * f64::from(i), 2.0 * last * f64::from(j) / 150.0];
                // Along the motion the depth is the same all over.
                let z = -worn.depth(depths, [0.0, y])
                    + 0.2 * NOISE * random.draw()
                    + 3e-3 * y
                    + 1e-3 * x;
                if columns > 1 {
                    let _ = write!(text, "{:.5},", 1e3 * x);
                }
                let _ = writeln!(text, "{:.5},{:.5}", 1e3 * y + 1.0, 1e6 * z);
            }
            text
        });
    let text = text.replace(",file", ",file_disc");
    let found = fitted(dir.path(), &file, &text).unwrap();
    assert_found(&found, 5e-15, &truths);
    assert_eq!(found.quantities.len(), 1);
    assert_eq!(found.quantities[0].0, "track_section_disc");
}

#[test]
fn files_that_cannot_be_used_are_told_with_their_line() {
    let (dir, file) = (tempfile::tempdir().unwrap(), published("pin_on_disc", &PIN));
    let refused = |surface: &str| {
        fs::write(dir.path().join("scar.csv"), surface).unwrap();
        let text = "test,distance_m,file\nA,0.2,\nA,0.4,scar.csv\n";
        fitted(dir.path(), &file, text).unwrap_err().to_string()
    };
    let profile = |half: f64, factor: f64| {
        let row = |i: i32| {
            let x = half * f64::from(i) / 100.0;
            let z = sphere(x, 0.0) - 2e-6 * (1.0 - (x / 0.4e-3).powi(2)).max(0.0);
            format!("{:.6},{:.6}\n", 1e3 * x, factor * 1e6 * z)
        };
        format!("x [mm],Tiefe [um]\n{}", (-100..=100).map(row).collect::<String>())
    };
    for (surface, said) in [
        ("x [mm],z [um]\n0,1\n".to_owned(), "line 3: scar.csv: no column is titled `Tiefe [um]`"),
        ("a [mm],Tiefe [um]\n0,1\n".to_owned(), "a profile has columns `x` (or `y`) and `z`"),
        // Nothing but the scar; heights in mm; depths in the place of heights.
        (profile(0.42e-3, 1.0), "measure wider"),
        (profile(1.2e-3, 1e-3), "units"),
        (profile(1.2e-3, -1.0), "units"),
    ] {
        let error = refused(&surface);
        let line = error.replace('`', "");
        assert!(error.contains(said) && line.contains("tests.csv, line 3: scar.csv"), "{error}");
    }
    let missing = fitted(dir.path(), &file, "test,distance_m,file\nA,0.4,nowhere.csv\n");
    assert!(missing.unwrap_err().to_string().contains("line 2: `nowhere.csv`: cannot read it"));
    fs::write(dir.path().join("scar.csv"), profile(1.2e-3, 1.0)).unwrap();
    let mixed = "test,distance_m,file,depth_um\nA,0.4,scar.csv,2\n";
    let mixed = fitted(dir.path(), &file, mixed).unwrap();
    assert_eq!(mixed.quantities.len(), 2, "{mixed}");
    // A column without a reading asks for nothing; one that is not used is told.
    let empty = "test,distance_m,file,u_file,section_mm2\nA,0.4,scar.csv,1,\n";
    let found = fitted(dir.path(), &file, empty).unwrap();
    assert!(found.remarks.iter().any(|remark| remark.ends_with("not used: u_file")), "{found}");
    // The shape that files are levelled by does not vary without them.
    let shape = [("body.pin.profile.sphere.radius".to_owned(), 0.01)];
    let text = "test,distance_m,file\nA,0.4,scar.csv\n";
    let refused = fitted_with(dir.path(), &file, (text, &shape)).unwrap_err().to_string();
    assert!(refused.contains("the shape that `scar.csv` was levelled by"), "{refused}");
}
