//! Wear laws as formulas: what is printed is read back, and errors point into the formula.

use archard_case::{CaseFile, Problem, Source};

const CASE: &str = r#"
[body.pin]
material = { young = "210 GPa", poisson = 0.3 }
profile.sphere = { radius = "50 mm" }
WEAR
[body.disc]
material = { young = "210 GPa", poisson = 0.3 }
profile.flat = {}
[frame]
size = ["1.2 mm", "1.2 mm"]
elements = [30, 30]
[motion.sliding]
load = "10.2 N"
distance = "500 mm"
step = "5 mm"
surfaces = "stay"
"#;

fn file(wear: &str) -> CaseFile {
    CaseFile::from_text("case", CASE.replace("WEAR", wear), ".")
}

/// Constants are printed as they were written, numbers as numbers.
#[test]
fn a_formula_and_its_constants_come_back() {
    let wear = r#"wear.expression = { depth = "k*max(p - p0, 0)*s*(1 + a*exp(-distance/s0))", k = "1.3e-7 mm^2/N", NAME = "4", p0 = "30 MPa", a = 4, s0 = "10 m", per = "increment" }"#;
    let wear = wear.replace("1 + a", "1 + 0*NAME + a");
    let case = file(&wear).resolve().expect("a case").case;
    let printed = case.to_string();
    for line in [
        r#"body.pin.wear.expression.depth = "k*max(p - p0, 0)*s*(1 + 0*NAME + a*exp(-distance/s0))""#,
        r#"body.pin.wear.expression.per = "increment""#,
        r#"body.pin.wear.expression.k = "1.3e-7 mm^2/N""#,
        "body.pin.wear.expression.NAME = 4.0",
        "body.pin.wear.expression.a = 4.0",
    ] {
        assert!(printed.lines().any(|known| known == line), "{line} in\n{printed}");
    }
    let again = CaseFile::from_text("printed", &*printed, ".").resolve().expect("a case").case;
    assert_eq!(again, case);
    assert_eq!(again.to_string(), printed);
}

/// What the problems of a case point at.
fn pointed(file: &CaseFile) -> Vec<&str> {
    let problems: Vec<Problem> = file.task().expect_err("a wrong case");
    let at = problems.into_iter().map(|problem| problem.location.expect("a place"));
    at.map(|at| &file.text(at.source)[at.span]).collect()
}

#[test]
fn errors_point_at_the_characters_of_the_formula() {
    for (formula, expected) in [
        (r#""k*q*s""#, "q"),
        ("'k*q*s'", "q"),
        ("\"\"\"\nk*p*\n  (s + p)\"\"\"", "(s + p)"),
        ("\"\"\"\n\n  k*p*(s + p)\"\"\"", "(s + p)"),
        ("'''k*(s + p)'''", "(s + p)"),
        // What is written is not what is meant: all of it.
        (r#""k*\u0071*s""#, r#""k*\u0071*s""#),
        (r#""kµ*p*s""#, "µ"),
        // A depth that breaks what a law owes: all of it.
        (r#""k*p*s - k*p*s*1.5""#, r#""k*p*s - k*p*s*1.5""#),
    ] {
        let table = format!("[body.pin.wear.expression]\ndepth = {formula}\nk = \"1e-13 1/Pa\"");
        let file = file(&table);
        assert_eq!(pointed(&file), [expected], "{formula}");
    }
    let sound = r#"wear.expression = { depth = "k*p*s", k = "1e-13 1/Pa" }"#;
    for (option, expected) in [
        ("body.pin.wear.expression.depth=k*q*s", "q"),
        ("body.pin.wear.expression.depth='k*q*s'", "q"),
        ("body.pin.wear.expression={depth = k*q*s}", "{depth = k*q*s}"),
    ] {
        let file = file(sound).set(option);
        assert_eq!(pointed(&file), [expected], "{option}");
        let problems = file.task().expect_err("a wrong case");
        let place = problems[0].location.as_ref().expect("a place");
        assert_eq!(place.source, Source::Option(0));
    }
}
