//! Answers to an accuracy: each published case whose result is known, with nothing but `accuracy` in the place of its frame, its
//! steps and its increments.

use std::fs;
use std::path::Path;
use std::sync::LazyLock;
use std::time::Instant;

use archard::simulation::history::{Row, number, stated};
use archard_case::CaseFile;
use toml::de::{DeTable, DeValue};

use crate::common::Rows;
use crate::{Expected, expected, folders, read};

/// What all cases are asked for.
const ASKED: &str = "0.01";
/// What some are asked for besides.
const ASKED_MORE: [(&str, &[&str]); 11] = [
    ("carter", &["0.1", "0.001"]),
    ("hertz", &["0.1", "0.001"]),
    ("mccoll_fretting", &["0.1", "0.001"]),
    ("pin_on_disc", &["0.1", "0.001"]),
    ("pin_on_disc_track", &["0.1", "0.001"]),
    ("twin_disc", &["0.1"]),
    ("warm_twin_disc", &["0.1", "0.001"]),
    ("wheel_steel_twin_disc", &["0.1", "0.001"]),
    ("running_in_flat_punch", &["0.1"]),
    ("spence", &["0.1"]),
    ("running_in_law", &["0.1"]),
];

/// Cases that are asked for less: a hundredth of the depth under the edge of a punch, or after so many cycles of fretting, takes more
/// than ten minutes of a processor.
const LESS: [(&str, &str); 4] = [
    ("running_in_flat_punch", "0.03"),
    ("running_in_law", "0.03"),
    ("fretting_sphere", "0.1"),
    ("orthotropic_fretting", "0.1"),
];

/// Keys of a motion that an accuracy takes the place of.
const OF_STEPS: [&str; 4] = ["step", "tolerance", "jump", "increments"];
/// Motions whose increments are what is put out, not what they are computed in.
const OF_OUTPUTS: [&str; 1] = ["creepage_sweep"];

/// A case without what an accuracy takes the place of.
fn bare(folder: &Path) -> Vec<String> {
    let text = fs::read_to_string(folder.join("case.toml")).expect("a case");
    let document = DeTable::parse(&text).expect("TOML").into_inner();
    let DeValue::Table(motions) = document.get("motion").expect("a motion").get_ref() else {
        panic!("a motion in {}", folder.display())
    };
    let (kind, motion) = motions.iter().next().expect("a motion");
    let motion = motion.get_ref().as_table().expect("a table");
    let goes = |key: &&str| {
        motion.contains_key(*key)
            && !(OF_OUTPUTS.contains(&&**kind.get_ref()) && *key == "increments")
    };
    let mut options: Vec<String> = OF_STEPS
        .iter()
        .copied()
        .filter(goes)
        .map(|key| format!("motion.{}.{key}=", kind.get_ref()))
        .collect();
    let frame = document.get("frame").and_then(|frame| frame.get_ref().as_table());
    let given = ["size", "elements"].into_iter();
    let given = given.filter(|key| frame.is_some_and(|frame| frame.contains_key(*key)));
    options.extend(given.map(|key| format!("frame.{key}=")));
    options
}

/// Seconds that processors have worked for this process, as Linux counts them; those since the first call elsewhere.
fn worked() -> f64 {
    static FIRST: LazyLock<Instant> = LazyLock::new(Instant::now);
    let since = FIRST.elapsed().as_secs_f64();
    let known = || {
        let text = fs::read_to_string("/proc/self/stat").ok()?;
        // Behind the name in brackets; in hundredths.
        let mut fields = text.rsplit_once(") ")?.1.split(' ').skip(11);
        let mut next = || fields.next()?.parse::<f64>().ok();
        Some((next()? + next()?) / 100.0)
    };
    known().unwrap_or(since)
}

/// The rows of a case with an accuracy, its elements, and the seconds of one processor.
fn answer(folder: &Path, accuracy: &str) -> Result<(Vec<Row>, [usize; 2], f64), String> {
    let start = worked();
    let file = CaseFile::read(folder).map_err(|error| error.to_string())?;
    let file = bare(folder).iter().fold(file, |file, option| file.set(option));
    let file = file.set(format!("accuracy={accuracy}"));
    let wrong = |problems: Vec<archard_case::Problem>| {
        problems.iter().map(|problem| file.describe(problem)).collect::<Vec<_>>().join(" ")
    };
    let resolved = file.resolve().map_err(wrong)?;
    let settled = resolved.settle(&mut |case| Ok(case.build()?), &mut |_| Ok(()));
    let (resolved, simulation) = settled.map_err(|error| error.to_string())?;
    let mut rows = Rows::default();
    simulation.run(&mut [&mut rows]).map_err(|error| error.to_string())?;
    Ok((rows.0, resolved.case.frame.elements, worked() - start))
}

/// The row that a value is expected in.
fn row_of<'a>(rows: &'a [Row], at: Option<&String>) -> Option<&'a Row> {
    let Some(at) = at else { return rows.last() };
    let place = read(at, &rows.first()?.first()?.0);
    rows.iter().find(|row| (row[0].1 - place).abs() <= 1e-9 * place)
}

/// A line of the table, and whether the value is off by more than what is stated and what its source leaves.
fn line(rows: &[Row], one: &Expected) -> (String, bool) {
    let Expected { column, at, value, known_to, .. } = one;
    let Some(row) = row_of(rows, at.as_ref()) else { return (format!("no row at {at:?}"), true) };
    let found = number(row, column).expect("a column");
    let truth = read(value, column);
    let off = (found / truth - 1.0).abs();
    let known_to = known_to.expect("known");
    let place = at.as_ref().map_or(String::new(), |at| format!(" at {at}"));
    let error = stated(column, |name| number(row, name)).map(|error| error / truth.abs());
    let bar = error.map_or("-".to_owned(), |error| format!("{:.2} %", 100.0 * error));
    let text = format!(
        "`{column}`{place} | {found:.4e} | {bar} | {:+.3} % | {:.1e}",
        100.0 * (found / truth - 1.0),
        known_to
    );
    (text, error.is_some_and(|error| off > error + known_to))
}

#[test]
#[ignore = "prints a table, which takes minutes"]
fn answers_to_an_accuracy() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let mut lies = vec![];
    // Some cases, if it names them: `ARCHARD_CASES=hertz,carter`.
    let some = std::env::var("ARCHARD_CASES").ok();
    let wanted =
        |name: &str| some.as_ref().is_none_or(|some| some.split(',').any(|one| one == name));
    println!("| case | asked | elements | CPU s | column | found | stated | off | known to |");
    println!("|---|---|---|---|---|---|---|---|---|");
    for folder in folders() {
        let name = folder.file_name().unwrap().to_string_lossy().into_owned();
        if !wanted(&name) {
            continue;
        }
        let all = expected(&fs::read_to_string(folder.join("expected.toml")).unwrap());
        let known: Vec<&Expected> = all.iter().filter(|one| one.known_to.is_some()).collect();
        let more =
            ASKED_MORE.iter().find(|(case, _)| *case == name).map_or(&[][..], |(_, more)| *more);
        let less = LESS.iter().find(|(case, _)| *case == name).map(|(_, less)| *less);
        for accuracy in [&[less.unwrap_or(ASKED)], more].concat() {
            if known.is_empty() {
                continue;
            }
            let (rows, [nx, ny], seconds) = match pool.install(|| answer(&folder, accuracy)) {
                Ok(answer) => answer,
                Err(error) => {
                    println!("| `{name}` | {accuracy} | - | - | {error} | - | - | - | - |");
                    continue;
                }
            };
            for one in &known {
                let (text, lie) = line(&rows, one);
                println!("| `{name}` | {accuracy} | {nx} x {ny} | {seconds:.1} | {text} |");
                if lie {
                    lies.push(format!("{name} {accuracy}: {text}"));
                }
            }
        }
    }
    assert!(lies.is_empty(), "{lies:#?}");
}
