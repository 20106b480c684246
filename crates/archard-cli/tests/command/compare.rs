//! `archard compare`: measurements made from a run itself, tilted and moved, are found again.

use std::fs;
use std::path::Path;

use tempfile::TempDir;

use super::{archard, case, printed, said};

const RADIUS: f64 = 50e-3;

/// Runs a pin on a disc into `run`.
fn run(dir: &TempDir, name: &str) {
    let case = case(name);
    let settings = ["--set", "frame.elements=[48, 48]", "--set", "motion.sliding.step=10 mm"];
    let mut arguments = vec!["run", case.to_str().unwrap(), "-o", name, "--quiet"];
    arguments.extend(settings);
    archard(dir, &arguments).success();
}

/// Columns of a table of results, of the rows that are asked for.
fn column(path: &Path, name: &str, keep: impl Fn(&csv::StringRecord) -> bool) -> Vec<f64> {
    let mut reader = csv::Reader::from_path(path).unwrap();
    let place = reader.headers().unwrap().iter().position(|known| known == name).unwrap();
    let rows = reader.records().map(Result::unwrap).filter(keep);
    rows.map(|row| row[place].parse().unwrap()).collect()
}

/// A value behind a name in what was printed: the first number after it.
fn number(text: &str, name: &str) -> f64 {
    let line = text.lines().find(|line| line.trim().starts_with(name));
    let line = line.unwrap_or_else(|| panic!("no `{name}` in\n{text}"));
    let words = line.trim()[name.len()..].split_whitespace();
    words.filter_map(|word| word.trim_end_matches(',').parse().ok()).next().unwrap()
}

/// The worn pin along x, with the sphere next to the frame, shifted by 0.4 mm, tilted by 2 um/mm and 30 um high, in the
/// units and with the commas of a German instrument; the pin's own depth times a factor.
fn profile(dir: &TempDir, factor: f64) -> String {
    let path = dir.path().join("pin_on_disc/profiles.csv");
    let last = |row: &csv::StringRecord| &row[0] == "0.5" && &row[1] == "x";
    let places = column(&path, "coordinate_m", last);
    let worn = column(&path, "wear_pin_m", last);
    let mut text = String::from("Ort [mm];Tiefe [um];Kommentar\n");
    for i in -150..=150 {
        let x = 8e-6 * f64::from(i);
        let next = places.partition_point(|known| *known < x).clamp(1, places.len() - 1);
        let share = (x - places[next - 1]) / (places[next] - places[next - 1]);
        let within = (0.0..=1.0).contains(&share);
        let depth =
            if within { worn[next - 1] + share * (worn[next] - worn[next - 1]) } else { 0.0 };
        let z = -RADIUS + (RADIUS * RADIUS - x * x).sqrt() - factor * depth;
        let place = x + 0.4e-3;
        let z = z + 30e-6 + 2e-3 * place;
        text += &format!("{:.6};{:.6};\n", place * 1e3, z * 1e6).replace('.', ",");
    }
    text
}

const TITLES: [&str; 4] = ["--column", "x=Ort [mm]", "--column", "z_um=\"Tiefe [um]\""];

#[test]
fn a_tilted_profile_of_the_run_itself_is_the_run() {
    let dir = TempDir::new().unwrap();
    run(&dir, "pin_on_disc");
    fs::write(dir.path().join("scar.csv"), profile(&dir, 1.0)).unwrap();
    let mut arguments = vec!["compare", "pin_on_disc", "scar.csv"];
    arguments.extend(TITLES);
    let said = printed(&archard(&dir, &arguments).success());
    let line = said.lines().find(|line| line.contains("of the deepest")).unwrap();
    let share = line.split(", ").last().unwrap().split(' ').next().unwrap();
    assert!(share.parse::<f64>().unwrap() < 1.0, "{said}");
    assert!(said.contains("not used: column `Kommentar`"), "{said}");
    assert!(said.contains("on a curved body a shift and a tilt"), "{said}");
    for name in ["compare.svg", "compare.png"] {
        assert!(dir.path().join("pin_on_disc/plots").join(name).is_file(), "{name}");
    }
    let svg = fs::read_to_string(dir.path().join("pin_on_disc/plots/compare.svg")).unwrap();
    assert!(svg.contains(">measured<") && svg.contains(">computed<"));
}

/// Half as deep again: the run is a third too shallow, and the section says the same.
#[test]
fn a_deeper_scar_is_told() {
    let dir = TempDir::new().unwrap();
    run(&dir, "pin_on_disc");
    fs::write(dir.path().join("scar.csv"), profile(&dir, 1.5)).unwrap();
    let mut arguments = vec!["compare", "pin_on_disc", "scar.csv"];
    arguments.extend(TITLES);
    let said = printed(&archard(&dir, &arguments).success());
    for name in ["deepest", "worn section"] {
        let line = said.lines().find(|line| line.trim().starts_with(name)).unwrap();
        let share = line.split("computed ").last().unwrap().split(' ').next().unwrap();
        let share: f64 = share.parse().unwrap();
        assert!((share + 33.3).abs() < 1.5, "{line}");
    }
    archard(
        &dir,
        &[
            "report",
            "pin_on_disc",
            "--measured",
            "scar.csv",
            TITLES[0],
            TITLES[1],
            TITLES[2],
            TITLES[3],
        ],
    )
    .success();
    let page = fs::read_to_string(dir.path().join("pin_on_disc/report.html")).unwrap();
    assert!(
        page.contains("pin along x compared with `scar.csv`") && page.contains("tilt taken off")
    );
}

#[test]
fn depths_over_the_distance_are_held_against_the_history() {
    let dir = TempDir::new().unwrap();
    run(&dir, "pin_on_disc");
    let path = dir.path().join("pin_on_disc/history.csv");
    let (distance, depth) =
        (column(&path, "distance_m", |_| true), column(&path, "wear_depth_pin_m", |_| true));
    let mut text = String::from("distance [m],depth [um]\n");
    for i in (0..distance.len()).step_by(5) {
        text += &format!("{},{}\n", distance[i], 1.1e6 * depth[i]);
    }
    fs::write(dir.path().join("wear.csv"), text + "0.7,3\n").unwrap();
    let said = printed(&archard(&dir, &["compare", "pin_on_disc", "wear.csv"]).success());
    // 1/1.1 - 1.
    assert!(said.contains("computed -9.1 % against measured"), "{said}");
    assert!(
        said.contains("readings of the depth beyond the end of the run, left out: 1"),
        "{said}"
    );
}

#[test]
fn runs_are_compared_at_their_ends() {
    let dir = TempDir::new().unwrap();
    ["pin_on_disc", "pin_on_disc_both"].iter().for_each(|name| run(&dir, name));
    let said = printed(&archard(&dir, &["compare", "pin_on_disc", "pin_on_disc_both"]).success());
    assert!(said.contains("wear depth") && said.contains("in `pin_on_disc_both`"), "{said}");
    let verdict = |said: &str| {
        let line = said.lines().find(|line| line.trim().starts_with("verdict")).unwrap();
        line.split_whitespace().skip(1).collect::<Vec<_>>().join(" ")
    };
    assert_eq!(verdict(&said), "good (2 checks)");
    // What is doubtful in one of the runs is doubtful in what they are compared by, and so is another end.
    let case = case("pin_on_disc");
    let run = ["run", case.to_str().unwrap(), "-o", "coarse", "--quiet"];
    let short = ["motion.sliding.distance=250 mm", "frame.elements=[8, 8]"];
    let short = [&run[..], &["--set", short[0], "--set", short[1]]].concat();
    archard(&dir, &short).success();
    for pair in [["pin_on_disc", "coarse"], ["coarse", "pin_on_disc"]] {
        let said = printed(&archard(&dir, &["compare", pair[0], pair[1]]).success());
        assert!(verdict(&said).starts_with("doubtful (2 of "), "{said}");
        assert!(said.contains("`coarse`: doubtful: ") && said.contains("ends at"), "{said}");
    }
    archard(&dir, &["report", "pin_on_disc", "--measured", "coarse"]).success();
    let page = fs::read_to_string(dir.path().join("pin_on_disc/report.html")).unwrap();
    assert!(page.contains("doubtful (2 of "));
}

#[test]
fn what_cannot_be_compared_is_refused_in_words() {
    let dir = TempDir::new().unwrap();
    run(&dir, "pin_on_disc");
    let refused = |text: &str, more: &[&str]| {
        fs::write(dir.path().join("bad.csv"), text).unwrap();
        let mut arguments = vec!["compare", "pin_on_disc", "bad.csv"];
        arguments.extend(more);
        said(&archard(&dir, &arguments).code(2))
    };
    let message = refused("a [mm],b [mm]\n1,2\n", &[]);
    assert!(
        message.contains("neither a column x or y") && message.contains("`a [mm]`"),
        "{message}"
    );
    let message = refused("x [mm],z [um]\n0,1\n0.1,2\n", &[]);
    assert!(message.contains("2 readings cannot separate a scar"), "{message}");
    let message = refused("x [mm],z [um]\n0,1\n0.1,2\n", &["--body", "ball"]);
    assert!(message.contains("the bodies are pin and disc"), "{message}");
    let message = refused("x [mm],y [mm],z [um]\n0,1,1\n", &[]);
    assert!(message.contains("1 readings cannot separate a scar"), "{message}");
    let message = refused("x [mm],z [um]\n0,\n0.1,\n", &[]);
    assert!(message.contains("no place has a height"), "{message}");
    let message = refused("x [mm],y [mm],z [um]\n0,1,1\n", &["--levelled"]);
    assert!(message.contains("leave --levelled out"), "{message}");
    // What a fit refuses.
    let message = refused("distance [m],depth [um]\n0.1,1\n0.2,-1\n", &[]);
    assert!(message.contains("line 3: `depth` is negative"), "{message}");
    let message = refused("distance [m],depth [km]\n0.1,-1e308\n", &[]);
    assert!(message.contains("line 2: `-1e308` in the column `depth [km]`"), "{message}");
    let message = refused("distance [m],depth [um]\n0.1,-1e300\n", &[]);
    assert!(message.contains("in the column `depth` (SI) is too large"), "{message}");
    let message = refused("distance [m],mass [mg]\n0.1,1\n", &[]);
    assert!(message.contains("no reading of depth"), "{message}");
    let message = said(&archard(&dir, &["compare", "pin_on_disc", "nowhere.csv"]).code(2));
    assert!(message.contains("cannot read `nowhere.csv`"), "{message}");
}

/// A track is as deep all along: a profile said to go along it was taken across it.
#[test]
fn a_profile_along_a_track_is_refused() {
    let dir = TempDir::new().unwrap();
    let case = case("pin_on_disc_track");
    let coarse = ["--set", "frame.elements=[32, 32]"];
    let run = ["run", case.to_str().unwrap(), "-o", "track", "--quiet"];
    archard(&dir, &[&run[..], &coarse].concat()).success();
    let row = |i: i32| {
        let y = 0.05 * f64::from(i);
        format!("{y:.3},{:.3}\n", -2.4 * (1.0 - (y / 0.27).powi(2)).max(0.0))
    };
    let rows: String = (-16..=16).map(row).collect();
    fs::write(dir.path().join("scar.csv"), format!("x [mm],z [um]\n{rows}")).unwrap();
    let arguments = ["compare", "track", "scar.csv", "--body", "disc"];
    let refused = said(&archard(&dir, &arguments).code(2));
    assert!(refused.contains("as deep all along") && refused.contains("--column y="), "{refused}");
    let across = archard(&dir, &[&arguments[..], &["--column", "y=x [mm]"]].concat()).success();
    let deepest = printed(&across);
    assert!((number(&deepest, "deepest") - 2.4).abs() < 0.1, "{deepest}");
    // A map of three lines across it, and one of a track that lies askew.
    for (slope, said) in [(0.0, "worn section"), (0.1, "lies askew in the map by 5.7 degrees")] {
        let mut text = String::from("x [mm],y [mm],z [um]\n");
        for (i, j) in (-80..=80).flat_map(|j| (0..3).map(move |i| (i, j))) {
            let [x, y] = [0.2 * f64::from(i), 0.01 * f64::from(j)];
            let depth = 2.4 * (1.0 - ((y - slope * x) / 0.27).powi(2)).max(0.0);
            text += &format!("{x},{y},{:.6}\n", 0.5 * y - depth);
        }
        fs::write(dir.path().join("map.csv"), text).unwrap();
        let output = archard(&dir, &["compare", "track", "map.csv", "--body", "disc"]);
        let output =
            if slope == 0.0 { printed(&output.success()) } else { super::said(&output.code(2)) };
        assert!(output.contains(said), "{output}");
        if slope == 0.0 {
            assert!((number(&output, "deepest") - 2.4).abs() < 0.01, "{output}");
        }
    }
}

/// A height map made of the worn pin, which is a body of revolution: tilted, moved, with gaps, and half as deep again.
#[test]
fn a_height_map_of_the_run_itself_is_the_run() {
    let dir = TempDir::new().unwrap();
    run(&dir, "pin_on_disc");
    let path = dir.path().join("pin_on_disc/profiles.csv");
    let last = |row: &csv::StringRecord| &row[0] == "0.5" && &row[1] == "x";
    let places = column(&path, "coordinate_m", last);
    let worn = column(&path, "wear_pin_m", last);
    let depth = |place: f64| {
        let next = places.partition_point(|known| *known < place).clamp(1, places.len() - 1);
        let share = (place - places[next - 1]) / (places[next] - places[next - 1]);
        if share > 1.0 { 0.0 } else { worn[next - 1] + share * (worn[next] - worn[next - 1]) }
    };
    for (factor, off) in [(1.0, 0.0), (1.5, -33.3)] {
        let mut text = String::from("x [mm];y [mm];z [um]\n");
        // The same as an instrument writes it, whose middle is at 0.
        let mut scan = String::from(
            "aISO-1.0\nNumPoints = 91\nNumProfiles = 91\nXscale = 18e-6\nYscale = 18e-6\nZscale = 1e-6\n*\n",
        );
        for (i, j) in (-45..=45).flat_map(|j| (-45..=45).map(move |i| (i, j))) {
            let [x, y] = [i, j].map(|i| 18e-6 * f64::from(i));
            let r = x.hypot(y);
            let z = -RADIUS + (RADIUS * RADIUS - r * r).sqrt() - factor * depth(r);
            let z = z + 30e-6 + 2e-3 * x - 1e-3 * y;
            let cell =
                if (3 * i + 5 * j) % 29 == 0 { String::new() } else { format!("{:.5}", z * 1e6) };
            scan += if cell.is_empty() { "BAD" } else { &cell };
            scan += "\n";
            text += &format!("{:.4};{:.4};{cell}\n", x * 1e3 + 7.0, y * 1e3).replace('.', ",");
        }
        for (file, text) in [("map.csv", text), ("map.sdf", scan + "*\n")] {
            fs::write(dir.path().join(file), text).unwrap();
            let said = printed(&archard(&dir, &["compare", "pin_on_disc", file]).success());
            for name in ["deepest", "worn volume"] {
                let line = said.lines().find(|line| line.trim().starts_with(name)).unwrap();
                let share = line.split("computed ").last().unwrap().split(' ').next().unwrap();
                let share: f64 = share.parse().unwrap();
                // Depths are averaged over a fiftieth of the map; the pin is round to the size of an element.
                assert!((share - off).abs() < 3.0, "{file}: {line}");
            }
            assert!(said.contains("places in the scar without a reading"), "{said}");
            let tilt = "2.0000 \u{b5}m/mm along x, -1.0000 \u{b5}m/mm along y";
            assert!(said.contains(tilt), "{said}");
        }
    }
}
