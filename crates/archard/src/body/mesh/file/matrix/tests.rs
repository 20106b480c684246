//! One matrix as several programs write it, and what is said of those that are none.

use std::fmt::Write;

use super::{Holds, Matrix, UNITS, Written, parse, read};

/// Springs of 3, 5 and 7 N/m between two nodes, 4 and 9, and others to the ground.
const STIFFNESS: [[f64; 6]; 6] = [
    [13.0, 0.5, 0.0, -3.0, 0.0, 0.0],
    [0.5, 15.0, 0.0, 0.0, -5.0, 0.25],
    [0.0, 0.0, 17.0, 0.0, 0.0, -7.0],
    [-3.0, 0.0, 0.0, 4.0, 0.0, 0.0],
    [0.0, -5.0, 0.0, 0.0, 6.0, 0.0],
    [0.0, 0.25, -7.0, 0.0, 0.0, 8.0],
];
const NODES: [i64; 2] = [4, 9];

/// Row, column and value of all that is not zero, on and below the diagonal or everywhere.
fn values(all: bool) -> Vec<(usize, usize, f64)> {
    let at = |row: usize| (0..6).map(move |column| (row, column, STIFFNESS[row][column]));
    let each = (0..6).flat_map(at);
    each.filter(|(row, column, value)| *value != 0.0 && (all || column <= row)).collect()
}

fn user() -> String {
    let mut text = "** made by hand\n*USER ELEMENT, NODES= 2, LINEAR\n** ELEMENT NODES\n** 4, 9\n 1, 2, 3\n*MATRIX,TYPE=STIFFNESS\n".to_owned();
    for (row, values) in STIFFNESS.iter().enumerate() {
        for four in values[..=row].chunks(4) {
            let words: Vec<String> = four.iter().map(|value| format!("{value:.5E}")).collect();
            writeln!(text, "{},", words.join(", ")).unwrap();
        }
    }
    text + "*MATRIX,TYPE=MASS\n1.0, 1.0\n"
}

fn list(all: bool) -> String {
    let label = |row: usize| format!("{},{}", NODES[row / 3], row % 3 + 1);
    let each = values(all).into_iter();
    each.map(|(row, column, value)| format!("{},{}, {value:.6e}\n", label(row), label(column)))
        .collect()
}

fn coordinates() -> String {
    let each = values(false).into_iter();
    each.map(|(row, column, value)| format!("{} {} {value:e}\n", row + 1, column + 1)).collect()
}

fn market(array: bool) -> String {
    let head = |kind: &str| format!("%%MatrixMarket matrix {kind}\n% by hand\n");
    if array {
        let column =
            |column: usize| (column..6).map(move |row| format!("{}\n", STIFFNESS[row][column]));
        return head("array real symmetric")
            + "6 6\n"
            + &(0..6).flat_map(column).collect::<String>();
    }
    let all = values(true);
    let lines =
        all.iter().map(|(row, column, value)| format!("{} {} {value}\n", row + 1, column + 1));
    head("coordinate real general") + &format!("6 6 {}\n", all.len()) + &lines.collect::<String>()
}

fn bulk(wide: bool) -> String {
    let mut text = "$ by hand\nDMIG,KAAX,0,6,2,0,,,6\n".to_owned();
    for column in 0..6 {
        let rows: Vec<_> = values(false).into_iter().filter(|one| one.1 == column).collect();
        let (node, along) = (NODES[column / 3], column % 3 + 1);
        if wide {
            writeln!(text, "{:<8}{:<16}{node:>16}{along:>16}{:>16}", "DMIG*", "KAAX", "").unwrap();
        }
        for (place, (row, _, value)) in rows.into_iter().enumerate() {
            let (other, own) = (NODES[row / 3], row % 3 + 1);
            match (wide, place) {
                (true, _) => {
                    let value = format!("{value:.9e}").replace('e', "D");
                    writeln!(text, "{:<8}{other:>16}{own:>16}{value:>16}", "*").unwrap();
                }
                (false, 0) => {
                    writeln!(
                        text,
                        "{:<8}{:<8}{node:>8}{along:>8}{:>8}{other:>8}{own:>8}{value:>8}",
                        "DMIG", "KAAX", ""
                    )
                    .unwrap();
                }
                (false, _) => writeln!(text, "{:<8}{other:>8}{own:>8}{value:>8}", "+").unwrap(),
            }
        }
    }
    text + "DMIG,MAAX,0,6,2\nENDDATA\n"
}

/// Node and direction of the row and of the column, and the value.
type Labelled = ((i64, usize), (i64, usize), f64);

/// The values on and below the diagonal by the labels of rows, in order.
fn by_labels(written: &Written) -> Vec<Labelled> {
    let label = |row: usize| match &written.labels {
        Some(labels) => labels[row],
        None => (NODES[row / 3], row % 3),
    };
    let lower = written.lower().unwrap().into_iter().filter(|one| one.2 != 0.0);
    let mut all: Vec<_> = lower
        .map(|(row, column, value)| {
            let [one, other] = [label(row), label(column)];
            (one.max(other), one.min(other), value)
        })
        .collect();
    all.sort_by_key(|(row, column, _)| (*row, *column));
    all
}

#[test]
fn one_matrix_is_the_same_in_all_formats() {
    let known = by_labels(&read(&user()).unwrap());
    assert_eq!(known.len(), values(false).len());
    let others = [
        list(false),
        list(true),
        coordinates(),
        market(true),
        market(false),
        bulk(false),
        bulk(true),
    ];
    for text in others {
        let written = read(&text).unwrap_or_else(|wrong| panic!("{wrong:?}\n{text}"));
        assert_eq!(by_labels(&written), known, "{text}");
    }
}

/// Short exponents, directions of a node each, rows in any order, and how many digits there are.
#[test]
fn what_fortran_writes_is_read() {
    let text = "*USER ELEMENT,NODES=          2,LINEAR\n** ELEMENT NODES\n**         5,         5,\n         2\n         2,         3\n*MATRIX,TYPE=STIFFNESS\n 0.4935897D+05,\n-1.5-3, 2.5+4\n";
    let written = read(text).unwrap();
    assert_eq!(written.labels, Some(vec![(5, 1), (5, 2)]));
    assert_eq!(written.entries, [(0, 0, 49358.97), (1, 0, -1.5e-3), (1, 1, 2.5e4)]);
    assert_eq!(written.digits, 7);
}

#[track_caller]
fn refused(text: &str, line: Option<usize>, part: &str) {
    let wrong = match read(text) {
        Err(wrong) => wrong,
        Ok(written) => written.lower().unwrap_err(),
    };
    assert!(wrong.message.contains(part), "{wrong:?}");
    assert_eq!(wrong.line, line, "{wrong:?}");
}

#[test]
fn what_is_no_matrix_of_a_body_is_said_with_its_line() {
    refused(&user().replace("** 4, 9\n", "** 4\n"), Some(2), "has 2 nodes and 1 are named");
    refused(&user().replace("-7.00000E0, ", ""), Some(14), "take 21 values of stiffness, found 20");
    refused(&user().replace("1.70000E1", "x"), Some(9), "expected a number, found `x`");
    refused("1,1,1,1,5\n1,2,1,3\n", Some(2), "expected the node and direction of a row");
    refused("1 1 1 1 5\n1 0 1 1 3\n", Some(2), "directions are counted from 1");
    refused("a matrix\n", Some(1), "found `a matrix`");
    refused("", None, "no value");
    refused("1,1,1,1,-5\n", None, "node 1 along x has -5e0 on the diagonal");
    refused("1,1,1,1,5\n1,1,1,2,2\n", None, "node 1 along y has 0e0 on the diagonal");
    refused("1,1,1,1,5\n1,2,1,2,5\n1,1,1,2,2\n1,2,1,1,3\n", None, "not symmetric: 3e0 and 2e0");
    refused("1,1,1,1,5\n1,1,1,1,5\n", None, "there twice");
    let alone = "%%MatrixMarket matrix coordinate real general\n2 2 3\n1 1 5\n2 2 5\n1 2 1\n";
    refused(alone, None, "not symmetric: 1e0 and 0e0 between row 1 and row 2");
    refused(&alone.replace("2 2 3", "2 2 4"), Some(5), "expected 4 values, found 3");
    refused(&alone.replace("1 2 1", "1 3 1"), Some(5), "no row or column 3 of 2");
    refused("%%MatrixMarket matrix array complex general\n", Some(1), "real general");
    refused("DMIG,M2GG,0,6,2\nDMIG,B2GG,0,6,2\n", None, "there are the matrices M2GG, B2GG");
    refused("DMIG,K2GG,0,6,3\n", Some(1), "real numbers (1 or 2), found form `6` and type `3`");
    let unit = *UNITS.iter().find(|unit| unit.1 == Holds::Flexibility).unwrap();
    let wrong = Matrix::new(parse(user().as_bytes()).unwrap(), unit, None).unwrap_err();
    assert!(wrong.message.contains("says that it holds a stiffness"), "{wrong:?}");
}
