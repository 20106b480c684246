//! Folders of made-up runs, read back.

mod fretting;

use std::fs;

use approx::assert_relative_eq;
use serde_json::Value;
use tempfile::tempdir;

use super::{Claim, ResultFolder};
use crate::output::fixture::{COEFFICIENTS, CREEPAGE, CROWN, FRICTION, LOAD, Run};
use crate::output::{Error, Image, Totals};
use archard::frame::Direction;
use archard::motion::{Control, Stepping};
use archard::problem::ContactState;
use archard::simulation::{Effort, Observer, Report};

/// A run of three steps with outputs at its start and end, and the folder it left.
fn folder() -> tempfile::TempDir {
    let dir = tempdir().unwrap();
    let run = Run::pin_on_disc([9, 8]);
    let mut folder = ResultFolder::create(dir.path(), "title = \"a pin\"\n").unwrap();
    run.show(&mut folder, &[0.0, 0.1, 0.3, 0.5], |s| s == 0.0 || s == 0.5);
    let totals = Totals { seconds: 1.5, threads: 2, ..Totals::default() };
    folder.finish(&totals).unwrap();
    dir
}

/// A run of twin discs over 1,000 revolutions with outputs at its start and end, and its folder.
fn rolled(direction: Direction) -> tempfile::TempDir {
    let dir = tempdir().unwrap();
    let run = Run::twin_discs([13, 9], direction);
    let mut folder = ResultFolder::create(dir.path(), "").unwrap();
    run.show(&mut folder, &[0.0, 500.0, 1000.0], |n| n != 500.0);
    folder.finish(&Totals::default()).unwrap();
    dir
}

/// Rolling forward along x.
const ALONG_X: Direction = Direction { axis: 0, reversed: false };

/// The summary of a folder.
fn summary(dir: &tempfile::TempDir) -> Value {
    let text = fs::read_to_string(dir.path().join("summary.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

/// The header of a table and its rows.
fn table(dir: &tempfile::TempDir, name: &str) -> (String, Vec<Vec<f64>>) {
    let mut table = csv::Reader::from_path(dir.path().join(name)).unwrap();
    let header = table.headers().unwrap().iter().collect::<Vec<_>>().join(" ");
    let number = |cell: &str| cell.parse().unwrap();
    let rows = table.records().map(|row| row.unwrap().iter().map(number).collect());
    (header, rows.collect())
}

#[test]
fn bodies_that_roll_leave_their_profiles() {
    for (axis, across, count) in [(0, "y_m", 9), (1, "x_m", 13)] {
        let dir = rolled(Direction { axis, reversed: true });
        let (header, rows) = table(&dir, "worn_profiles.csv");
        let body = |name: &str| format!("height_{name}_before_m height_{name}_m wear_{name}_m");
        assert_eq!(header, format!("revolutions {across} {} {}", body("one"), body("two")));
        assert_eq!(rows.len(), 2 * count);
        let mut wear = [0.0; 2];
        for row in &rows {
            let [revolutions, _, one_before, one, one_wear, two_before, two, two_wear] = row[..]
            else {
                panic!("{row:?}");
            };
            assert_relative_eq!(one_before - one, one_wear, epsilon = 1e-18);
            assert_relative_eq!(two - two_before, two_wear, epsilon = 1e-18);
            if revolutions == 0.0 {
                assert_eq!([one_wear, two_wear], [0.0; 2]);
            }
            wear = [wear[0] + one_wear, wear[1] + two_wear];
        }
        // Both lose by their coefficients.
        assert_relative_eq!(wear[1], wear[0] * COEFFICIENTS[1] / COEFFICIENTS[0], epsilon = 1e-18);
        assert!(wear[0] > 0.0);
    }
}

/// On the plane through the middle, only the crown recedes: R - sqrt(R^2 - y^2).
#[test]
fn profiles_lie_on_the_middle_plane() {
    let (_, rows) = table(&rolled(ALONG_X), "worn_profiles.csv");
    for row in &rows[..9] {
        let crown = CROWN - (CROWN * CROWN - row[1] * row[1]).sqrt();
        assert_relative_eq!(row[2], -crown, epsilon = 1e-15);
        assert_eq!(row[5], 0.0);
    }
}

#[test]
fn bodies_that_slide_have_no_worn_profiles() {
    let dir = rolled(ALONG_X);
    assert!(dir.path().join("worn_profiles.csv").exists());
    let run = Run::pin_on_disc([6, 5]);
    let mut folder = ResultFolder::create(dir.path(), "").unwrap();
    run.show(&mut folder, &[0.0, 0.5], |_| true);
    assert!(!dir.path().join("worn_profiles.csv").exists());
}

/// The section of the body that stays is the one through its middle, whatever the frame next to it; the track's is the mean of
/// each line, as its points go through all of it.
#[test]
fn a_body_that_stays_on_a_track_shows_its_section() {
    for elements in [[9, 8], [8, 8]] {
        let dir = tempdir().unwrap();
        let run = Run::pin_on_track(elements);
        let mut folder = ResultFolder::create(dir.path(), "").unwrap();
        run.show(&mut folder, &[0.0, 0.5], |_| true);
        let (header, rows) = table(&dir, "worn_profiles.csv");
        let column = |name: &str| header.split(' ').position(|known| known == name).unwrap();
        let [pin, disc, place] = ["wear_pin_m", "wear_disc_m", "y_m"].map(column);
        let state = run.state(0.5);
        for row in &rows[8..] {
            let line: Vec<usize> = (0..elements[0] * elements[1])
                .filter(|&pair| (run.problem.frame.place(pair)[1] - row[place]).abs() < 1e-9)
                .collect();
            let count = elements[0];
            let middle = 0.5
                * [(count - 1) / 2, count / 2].map(|i| state.worn(0)[line[i]]).iter().sum::<f64>();
            let mean = line.iter().map(|&pair| state.worn(1)[pair]).sum::<f64>() / count as f64;
            assert_relative_eq!(row[pin], middle, max_relative = 1e-12);
            assert_relative_eq!(row[disc], mean, max_relative = 1e-12);
        }
        assert!(rows[8..].iter().any(|row| row[pin] > 0.0));
    }
}

#[test]
fn fields_of_friction_are_read_back_and_cut() {
    let dir = rolled(ALONG_X);
    let image = Image::read(&dir.path().join("fields/0001.vti")).unwrap();
    let run = Run::twin_discs([13, 9], ALONG_X);
    assert_eq!(image, Image::of(&run.problem, &run.state(1000.0)));
    let mut table = csv::Reader::from_path(dir.path().join("profiles.csv")).unwrap();
    let header: Vec<String> = table.headers().unwrap().iter().map(str::to_owned).collect();
    let friction = &header[header.len() - 5..];
    assert_eq!(friction.join(" "), "traction_x_Pa traction_y_Pa slip_x_m slip_y_m stick");
}

#[test]
fn the_summary_closes_the_sections() {
    let summary = summary(&rolled(ALONG_X));
    for (name, k) in ["one", "two"].into_iter().zip(COEFFICIENTS) {
        let wear = &summary["wear"][name];
        // Half of the contact bears half of its limit: three quarters of the work of full slip,
        // but for the middle elements, which lie on neither side.
        let full = k * CREEPAGE * LOAD * 1000.0;
        let expected = wear["expected_section_m2"].as_f64().unwrap();
        assert!(0.75 * full < expected && expected < 0.85 * full, "{}", expected / full);
        assert!(wear["relative_difference"].as_f64().unwrap().abs() < 1e-13);
        assert!(wear["worn_volume_m3"].is_null());
    }
}

#[test]
fn the_summary_has_the_closed_forms_of_rolling() {
    let summary = summary(&rolled(ALONG_X));
    let number = |block: &str, key: &str| summary["closed_form"][block][key].as_f64().unwrap();
    assert!(summary["closed_form"]["pin_on_disc"].is_null());
    let semi_axis =
        |axis: usize| summary["closed_form"]["hertz"]["semi_axes_m"][axis].as_f64().unwrap();
    // mu a / R with R = 15 mm of two discs of 30 mm.
    let saturation = number("carter", "saturation_creepage");
    assert_relative_eq!(saturation, FRICTION * semi_axis(0) / 15e-3, max_relative = 1e-14);
    let relative = number("strip", "relative_creepage");
    assert_relative_eq!(relative, CREEPAGE / saturation, max_relative = 1e-14);
    // (3 k c F n / (4 sqrt(2 R)))^(2/3).
    let worn = (COEFFICIENTS[0] + COEFFICIENTS[1]) * CREEPAGE * LOAD * 1000.0;
    let depth = (0.75 * worn / (2.0 * CROWN).sqrt()).powf(2.0 / 3.0);
    let known = number("twin_discs", "line_load_depth_m");
    assert_relative_eq!(known, depth, max_relative = 1e-14);
    assert_eq!(number("twin_discs", "half_width_m"), semi_axis(1));
    // The track is still narrower than the contact: k c F n / (2 b).
    let known = number("twin_discs", "incremental_depth_m");
    assert_relative_eq!(known, worn / (2.0 * semi_axis(1)), max_relative = 1e-13);
}

#[test]
fn the_history_has_a_row_a_step() {
    let dir = folder();
    let mut table = csv::Reader::from_path(dir.path().join("history.csv")).unwrap();
    let header = table.headers().unwrap().clone();
    let column = |name: &str| header.iter().position(|column| column == name).unwrap();
    let rows: Vec<_> = table.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 4);
    assert_eq!(&rows[2][column("distance_m")], "0.3");
    assert_eq!(&rows[2][column("time_error")], "");
    let volume: f64 = rows[3][column("worn_volume_disc_m3")].parse().unwrap();
    assert_relative_eq!(volume, COEFFICIENTS[1] * LOAD * 0.5, max_relative = 1e-13);
}

#[test]
fn the_fields_are_those_of_the_state() {
    let dir = folder();
    let run = Run::pin_on_disc([9, 8]);
    let image = Image::read(&dir.path().join("fields/0001.vti")).unwrap();
    assert_eq!(image, Image::of(&run.problem, &run.state(0.5)));
    assert!(!dir.path().join("fields/0002.vti").exists());
    let collection = fs::read_to_string(dir.path().join("fields.pvd")).unwrap();
    assert!(collection.contains("timestep=\"0.5\" file=\"fields/0001.vti\""), "{collection}");
}

#[test]
fn the_profiles_have_both_axes_of_each_output() {
    let dir = folder();
    let mut table = csv::Reader::from_path(dir.path().join("profiles.csv")).unwrap();
    let header: Vec<String> = table.headers().unwrap().iter().map(str::to_owned).collect();
    let known = "distance_m axis coordinate_m pressure_Pa gap_m wear_pin_m wear_disc_m wear_m height_pin_m height_disc_m";
    assert_eq!(header.join(" "), known);
    let axes: Vec<String> = table.records().map(|row| row.unwrap()[1].to_owned()).collect();
    assert_eq!(axes.len(), 2 * (9 + 8));
    assert_eq!(axes.iter().filter(|axis| *axis == "y").count(), 2 * 8);
}

#[test]
fn the_summary_closes_the_volumes() {
    let dir = folder();
    let summary = summary(&dir);
    for (name, k) in ["pin", "disc"].into_iter().zip(COEFFICIENTS) {
        let wear = &summary["wear"][name];
        assert_relative_eq!(
            wear["expected_volume_m3"].as_f64().unwrap(),
            k * LOAD * 0.5,
            max_relative = 1e-14
        );
        assert!(wear["relative_difference"].as_f64().unwrap().abs() < 1e-13);
    }
    assert_eq!(summary["complete"], true);
    assert_eq!(summary["iterations"], 40);
    assert_eq!(summary["applications"], 44);
    assert_eq!(summary["last"]["distance_m"], 0.5);
    assert!(summary["last"]["time_error"].is_null());
    // Hertz and eq. 55 of this sphere.
    let known = &summary["closed_form"];
    let peak = known["hertz"]["peak_pressure_Pa"].as_f64().unwrap();
    assert_relative_eq!(peak, 219.0547e6, max_relative = 3e-7);
    let depth = known["pin_on_disc"]["depth_m"].as_f64().unwrap();
    assert_relative_eq!(depth, 2.078040e-6, max_relative = 3e-7);
}

#[test]
fn a_run_without_a_step_has_a_summary() {
    let dir = tempdir().unwrap();
    let folder = ResultFolder::create(dir.path(), "").unwrap();
    let totals = Totals { failure: Some("no luck".to_owned()), ..Totals::default() };
    folder.finish(&totals).unwrap();
    let summary = summary(&dir);
    assert_eq!(summary["complete"], false);
    assert_eq!(summary["failure"], "no luck");
    assert_eq!(summary["verdict"]["word"], "wrong");
    assert!(summary["last"].is_null());
}

#[test]
fn a_new_run_removes_the_results_of_the_old_one_only() {
    let dir = folder();
    for name in ["notes.txt", "fields/mine.vti"] {
        fs::write(dir.path().join(name), "keep").unwrap();
    }
    ResultFolder::create(dir.path(), "").unwrap();
    let there = |name: &str| dir.path().join(name).exists();
    assert!(there("notes.txt") && there("fields/mine.vti"));
    assert!(!there("summary.json") && !there("fields.pvd") && !there("fields/0000.vti"));
}

/// Whatever has a name that a run needs, and is not a run's, is named and stays, with all else.
#[test]
fn files_of_others_are_in_the_way() {
    for name in ["profiles.csv", "case.toml", "checkpoint", "fields/2024.vti", "sections/pin_a.vtu"]
    {
        let dir = tempdir().unwrap();
        let path = dir.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, "mine").unwrap();
        let claim = Claim::take(dir.path()).unwrap().adding(vec!["sections/pin_a.vtu".to_owned()]);
        let error = claim.adopting().begin("").unwrap_err().to_string();
        assert!(error.contains(name) && error.contains("is in the way"), "{error}");
        assert_eq!(fs::read_to_string(&path).unwrap(), "mine");
        let first = std::path::Path::new(name).iter().next().unwrap();
        let left: Vec<_> =
            fs::read_dir(dir.path()).unwrap().map(|e| e.unwrap().file_name()).collect();
        assert_eq!(left, [first], "nothing is added");
    }
}

/// What a run has removed again is no longer its own.
#[test]
fn a_name_that_is_free_again_may_be_anyones() {
    let dir = folder();
    fs::write(dir.path().join("checkpoint"), "mine").unwrap();
    let error = ResultFolder::create(dir.path(), "").unwrap_err().to_string();
    assert!(error.contains("`") && error.contains("checkpoint` is in the way"), "{error}");
    assert!(dir.path().join("summary.json").exists());
}

/// Folders without a list are taken for results only where they look like some, and only when that is asked for.
#[test]
fn results_of_an_earlier_version_are_replaced_when_asked() {
    let dir = folder();
    fs::remove_file(dir.path().join("manifest.txt")).unwrap();
    let mine = ["fields/2024.vti", "points.txt"].map(|name| dir.path().join(name));
    mine.iter().for_each(|path| fs::write(path, "mine").unwrap());
    let refused = || Claim::take(dir.path()).unwrap().begin("").unwrap_err().to_string();
    assert!(refused().contains("`--force` replaces them"), "{}", refused());
    let error = Claim::take(dir.path()).unwrap().adopting().begin("").unwrap_err().to_string();
    assert!(error.contains("fields/2024.vti` is in the way"), "{error}");
    assert!(dir.path().join("fields/0001.vti").exists());
    fs::remove_file(&mine[0]).unwrap();
    let begun = Claim::take(dir.path()).unwrap().adopting().begin("").unwrap();
    assert!(!dir.path().join("fields/0001.vti").exists() && mine[1].exists());
    drop(begun);
}

#[test]
fn a_folder_that_cannot_be_made_is_named() {
    let dir = tempdir().unwrap();
    fs::write(dir.path().join("taken"), "").unwrap();
    let error = ResultFolder::create(&dir.path().join("taken"), "").unwrap_err();
    assert!(matches!(&error, Error::Write { path, .. } if path.ends_with("taken")));
    assert!(error.to_string().contains("taken"), "{error}");
}

#[test]
fn a_folder_is_held_while_results_are_written() {
    let dir = tempdir().unwrap();
    let folder = ResultFolder::create(dir.path(), "").unwrap();
    assert!(matches!(Claim::take(dir.path()), Err(Error::InUse { .. })));
    folder.finish(&Totals::default()).unwrap();
    let claim = Claim::take(dir.path()).unwrap();
    assert!(
        !claim.holds_another(str::is_empty)
            && claim.holds_another(|known| known == "title = \"else\"\n")
    );
}

#[test]
fn results_stay_until_others_begin() {
    let dir = folder();
    let before = fs::read(dir.path().join("history.csv")).unwrap();
    let [part, other] = ["fields/0001.vti", "fields/mine.vti"]
        .map(|name| dir.path().join(format!("{name}.4194305.3.part")));
    for part in [&part, &other] {
        fs::write(part, "half").unwrap();
    }
    let claim = Claim::take(dir.path()).unwrap();
    assert_eq!(fs::read(dir.path().join("history.csv")).unwrap(), before);
    assert!(dir.path().join("summary.json").exists() && part.exists());
    claim.give_up();
    assert!(dir.path().join("summary.json").exists());
    let _folder = Claim::take(dir.path()).unwrap().begin("").unwrap();
    assert!(!dir.path().join("summary.json").exists() && !part.exists() && other.exists());
    assert_eq!(fs::read(dir.path().join("history.csv")).unwrap(), b"");
}

#[test]
fn a_folder_made_for_nothing_is_removed() {
    let dir = tempdir().unwrap();
    let made = dir.path().join("out");
    Claim::take(&made).unwrap().give_up();
    assert!(!made.exists());
    Claim::take(dir.path()).unwrap().give_up();
    assert!(dir.path().exists());
}

/// What is no number neither becomes a row nor the end of a summary.
#[test]
fn numbers_that_are_none_are_refused() {
    for spoil in [
        (|state| state.load = f64::NAN) as fn(&mut ContactState),
        |state| state.approach = f64::INFINITY,
        |state| state.pressure[3] = f64::NAN,
        |state| state.surfaces[1].depth[0] = f64::NEG_INFINITY,
    ] {
        let dir = tempdir().unwrap();
        let run = Run::pin_on_disc([6, 5]);
        let mut folder = ResultFolder::create(dir.path(), "").unwrap();
        run.show(&mut folder, &[0.0, 0.25], |_| true);
        let mut state = run.state(0.5);
        spoil(&mut state);
        let (effort, extent) = (Effort::default(), 0.5);
        let report = Report {
            problem: &run.problem,
            state: &state,
            effort,
            output: true,
            extent,
            prescribed: Control::Load(state.load),
            stepping: Stepping::Implicit(1.0),
            companions: None,
            again: false,
            march: None,
        };
        let error = folder.observe(&report).unwrap_err();
        assert!(error.to_string().contains("is not a finite number at distance"), "{error}");
        let failure = Some(error.to_string());
        folder.finish(&Totals { failure, ..Totals::default() }).unwrap();
        let history = fs::read_to_string(dir.path().join("history.csv")).unwrap();
        assert_eq!(history.lines().count(), 1 + 2, "{history}");
        assert_eq!(summary(&dir)["last"]["distance_m"], 0.25);
    }
}
