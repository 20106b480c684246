//! `archard log`: a log made up as a TE67 writes it, read, and written as rows.

use std::fs;

use tempfile::TempDir;

use super::{archard, printed, said};

const NAMES: &str = "\tTime\tThis Step\tTest Time\tSliding Velocity\tMass\tLoad\tTOTAL REVOLUTIONS\tContact Potential\tRadius\t\
                     Distance\tFriction Force\tFriction Coefficient\tDisplacement\tFriction Force\t";

/// 0.15 m/s for an hour at 60 N, wear of 0.5 um/m, which the transducer counts downwards in whole um.
fn made() -> String {
    let mut text =
        format!("Data file\t\tA.TSV\n\nTest started at 23:30:00 on 2019-04-11\n{NAMES}\n");
    for row in 0..3600 {
        let far = 0.15 * f64::from(row);
        let (minute, second) = (30 + row / 60, row % 60);
        let (hour, minute) = ((23 + minute / 60) % 24, minute % 60);
        let depth = (3400.0 - 0.5 * far + 0.8 * f64::from(row * 7 % 11) / 11.0).round();
        let row = format!(
            "\t{hour:02}:{minute:02}:{second:02}\t2\t{row}.\t0.150\t6118\t60.000\t{row}\t90.7\t14\t{far:.3}\t12.0\t0.2\t{depth}\t12.0\t\n"
        );
        text += &row.replace('.', ",");
    }
    text + "Test completed at 00:30:00 on 2019-04-12\n"
}

#[test]
fn a_log_tells_rate_and_friction_and_its_rows_are_written() {
    let dir = TempDir::new().unwrap();
    fs::write(dir.path().join("a.tsv"), made()).unwrap();
    let words = printed(&archard(&dir, &["log", "a.tsv", "-o", "rows.csv"]).success());
    assert!(words.contains("TE67") && words.contains("dead weight"), "{words}");
    let json = printed(&archard(&dir, &["log", "a.tsv", "--json"]).success());
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let rate = json["depth_rate"].as_f64().unwrap();
    assert!((rate / 0.5e-6 - 1.0).abs() < 0.01, "{json}");
    assert_eq!(json["load_N"], 60.0);
    assert!((json["friction"].as_f64().unwrap() - 0.2).abs() < 1e-9);
    let rows = fs::read_to_string(dir.path().join("rows.csv")).unwrap();
    assert!(rows.starts_with("test,distance [m],depth [um],u_depth [um],load [N]\na,"), "{rows}");
    fs::write(dir.path().join("mine.csv"), "mine").unwrap();
    archard(&dir, &["log", "a.tsv", "-o", "mine.csv"]).code(2);
    assert_eq!(fs::read_to_string(dir.path().join("mine.csv")).unwrap(), "mine");
}

/// Several logs: each its line, those of one name held against each other, one picture, rows of different names; what is no log is
/// named, and the others are told all the same.
#[test]
fn several_logs_are_told_at_once() {
    let dir = TempDir::new().unwrap();
    let put = |name: &str, text: &str| fs::write(dir.path().join(name), text).unwrap();
    put("peek_1.tsv", &made());
    put("peek_2.tsv", &made());
    put("profile.csv", "\"Distance\",\"Profile\"\n\"0,1\",\"0,03\"\n\"0,2\",\"0,05\"\n");
    let logs = ["log", "peek_1.tsv", "peek_2.tsv"];
    let drawn = [&logs[..], &["--picture", "p.svg", "-o", "rows.csv"]].concat();
    let words = printed(&archard(&dir, &drawn).success());
    assert!(words.contains("peek at 60.00 N: 2 (peek_1, peek_2)"), "{words}");
    assert!(words.contains("their intervals explain the difference"), "{words}");
    let picture = fs::read_to_string(dir.path().join("p.svg")).unwrap();
    assert!(picture.contains("peek_2, 60 N") && picture.contains("steady, 0.5 \u{b5}m per m"));
    assert_eq!(fs::read_to_string(dir.path().join("rows.csv")).unwrap().lines().count(), 3);
    let json = printed(&archard(&dir, &[&logs[..], &["--json"]].concat()).success());
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(
        (json["groups"][0]["agree"].as_bool(), json["logs"].as_array().map(Vec::len)),
        (Some(true), Some(2))
    );
    let wrong = archard(&dir, &[&logs[..], &["profile.csv"]].concat()).code(2);
    assert!(said(&wrong).contains("profile.csv:1") && printed(&wrong).contains("peek_2: 60.00 N"));
    archard(&dir, &["log", "peek_1.tsv", "--picture", "peek_1.tsv"]).code(2);
    archard(&dir, &["log", "peek_1.tsv", "-o", "./peek_1.tsv"]).code(2);
    assert_eq!(fs::read_to_string(dir.path().join("peek_1.tsv")).unwrap(), made());
}

/// A log without depth gives load and distance to a profile of what was worn.
#[test]
fn a_profile_stands_in_the_row_of_its_log() {
    let dir = TempDir::new().unwrap();
    let rows = (0..100).map(|row| format!("{row}\t{}\t0,2\t1,0\n", 2 * row));
    let text = format!("Laps\tDistance\tmu\tFrictionForce\n{}", rows.collect::<String>());
    fs::create_dir(dir.path().join("d")).unwrap();
    fs::write(dir.path().join("d/a.txt"), text).unwrap();
    fs::write(dir.path().join("d/p.csv"), "x_mm,z_um\n0,0\n1,0\n").unwrap();
    let beside = ["log", "d/a.txt", "--profile", "d/p.csv", "-o", "d/rows.csv"];
    archard(&dir, &beside).success();
    let rows = fs::read_to_string(dir.path().join("d/rows.csv")).unwrap();
    assert_eq!(rows, "test,distance [m],load [N],file\na,1.980000e2,5.000000e0,\"p.csv\"\n");
    archard(&dir, &["log", "d/a.txt", "--profile", "d/none.csv"]).code(2);
    archard(&dir, &["log", "d/a.txt", "d/a.txt", "--profile", "d/p.csv"]).code(2);
}

#[test]
fn a_log_without_load_says_what_to_give() {
    let dir = TempDir::new().unwrap();
    let rows = (0..100).map(|row| format!("{row},{}\n", 0.2 * f64::from(row)));
    let text = format!("distance [m],wear [um]\n{}", rows.collect::<String>());
    fs::write(dir.path().join("b.csv"), text).unwrap();
    let refused = archard(&dir, &["log", "b.csv"]).code(1);
    assert!(printed(&refused).contains("0.2000 um/m") && printed(&refused).contains("--set load"));
    archard(&dir, &["log", "b.csv", "--set", "load=5 N"]).success();
    assert!(said(&archard(&dir, &["log", "b.csv", "--set", "load=5"]).code(2)).contains("unit"));
}
