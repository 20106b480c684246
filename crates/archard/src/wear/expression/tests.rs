mod another_program;
mod tables;

use approx::assert_relative_eq;

use super::parser::{self, Mistake};
use super::tape::Tape;
use super::{Expression, Scope, dimension};
use crate::wear::{Archard, Columns, Input, Per, Rubbing, RunningIn, Threshold, WearLaw};

/// Constants of all kinds.
const CONSTANTS: &[(&str, &str)] =
    &[("k", "1.3e-13 1/Pa"), ("p0", "30 MPa"), ("a", "4"), ("s0", "10 m"), ("t", "2 s")];

fn scope() -> Scope {
    let mut scope = Scope::default();
    CONSTANTS.iter().for_each(|(name, text)| scope.add(name, text).unwrap());
    scope
}

/// A pair under 100 MPa that slides 0.2 m.
fn rubbing() -> Rubbing {
    let rubbing = Rubbing::new(1e8, 0.2).with_friction(0.3 * 1e8 * 0.2, 0.3);
    rubbing.at_speed(0.5).rolling(3.0).after(1.5, 2e-6)
}

/// Columns of one point.
fn one(rubbing: &Rubbing) -> Columns {
    use Input::{CrossShear, Depth, Distance, Friction, Rolled, Speed, Temperature};
    let all = [Friction, Speed, Temperature, Distance, Depth, Rolled, CrossShear];
    Columns::of([*rubbing], &all)
}

/// The value of a formula of any dimension there.
fn value(formula: &str) -> f64 {
    tape(formula).at(&one(&rubbing())).0
}

fn tape(formula: &str) -> Tape {
    Tape::new(&parser::parse(formula).unwrap(), &scope())
}

#[test]
fn operators_bind_as_in_mathematics() {
    for (formula, expected) in [
        ("1 + 2*3", 7.0),
        ("(1 + 2)*3", 9.0),
        ("7 - 2 - 1", 4.0),
        ("8/4/2", 1.0),
        ("2^3^2", 512.0),
        ("-2^2", -4.0),
        ("2^-1", 0.5),
        ("2*-3 + 1", -5.0),
        ("- -3", 3.0),
        ("+3 - +1", 2.0),
        ("2e-1 + .5 + 1.", 1.7),
        ("2e", f64::NAN),
        ("min(3, 1, 2) + max(3, 1, 2)", 4.0),
        ("if(1 < 2, 10, 20)", 10.0),
        ("if(1 >= 2, 10, 20)", 20.0),
        ("if(2 <= 2 and 2 > 1, 10, 20)", 10.0),
        ("if(1 > 2 or 1 < 2 and not 1 < 2, 10, 20)", 20.0),
        ("if(not (1 > 2), 10, 20)", 10.0),
        ("if(not 1 > 2, 10, 20)", 10.0),
        ("abs(-3) + sqrt(16) + exp(0) + ln(1) + cos(0) + sin(0) + tanh(0)", 9.0),
        ("2^0 + 3^1 + 2^2 + 2^3 + 4^0.5 + 4^-1", 18.25),
        ("a*p0/p", 1.2),
        ("mu*p*s/work", 1.0),
        ("v + distance + worn + rolled", 5.000002),
    ] {
        match parser::parse(formula) {
            Ok(_) => assert_relative_eq!(value(formula), expected, max_relative = 1e-15),
            Err(mistake) => assert!(expected.is_nan(), "{formula}: {mistake:?}"),
        }
    }
}

/// What is wrong with a formula: the part it is about and the message.
fn mistake(formula: &str) -> (&str, String) {
    let wrong = match parser::parse(formula) {
        Ok(node) => dimension::check(&node, &scope()).unwrap_err(),
        Err(mistake) => mistake,
    };
    let Mistake { at, message, .. } = wrong;
    (&formula[at], message)
}

#[test]
fn mistakes_show_their_place() {
    for (formula, place, message) in [
        ("", "", "a number, a name or a parenthesis should stand here"),
        ("k*", "", "a number, a name or a parenthesis should stand here"),
        ("k*)", ")", "a number, a name or a parenthesis should stand here"),
        ("k*(p + 1", "(", "this parenthesis is not closed"),
        ("max(p, 1", "(", "this parenthesis is not closed"),
        ("k*p)*s", ")", "a parenthesis is closed that was not opened"),
        ("k p", "p", "an operator like + or * should stand before this"),
        ("(k p)", "p", "an operator like + or * should stand before this"),
        ("2e*s", "e", "an operator like + or * should stand before this"),
        ("k = p", "=", "`=` has no meaning here"),
        ("k·p", "·", "`·` has no meaning here"),
        ("1e999*s", "1e999", "`1e999` is not a finite number"),
        ("sqr(p)", "sqr", "`sqr` is not a known function"),
        ("exp*p", "exp", "`exp` is a function: its values follow in parentheses"),
        ("exp(1, 2)", "exp(1, 2)", "`exp` takes one value, found 2"),
        ("max(p)", "max(p)", "`max` takes two values or more, found 1"),
        ("if(p > p0, s)", "if(p > p0, s)", "`if` takes a condition and two values, found 2"),
        ("k*q*s", "q", "`q` is neither a variable nor a constant of the law"),
        ("k*p*(s + p)", "(s + p)", "cannot add a length and a pressure"),
        ("k*p*s - s/s0", "k*p*s - s/s0", "cannot subtract a length and a pure number"),
        ("if(p > s, s, 0)", "p > s", "cannot compare a pressure and a length"),
        ("max(p - s0, 0)*k*s", "p - s0", "cannot subtract a pressure and a length"),
        ("max(p, s)*k*s", "max(p, s)", "`max` cannot compare a pressure and a length"),
        ("if(p > p0, s, p)", "if(p > p0, s, p)", "cannot choose between a length and a pressure"),
        ("if(p, s, 0)", "p", "a condition like `p > p0` should stand here, and this is a pressure"),
        ("(p > p0)*s", "(p > p0)", "a value should stand here, and this is a condition"),
        ("-(p > p0)*s", "(p > p0)", "a value should stand here, and this is a condition"),
        ("p < p0 < p", "p < p0", "a value should stand here, and this is a condition"),
        ("s*exp(-distance)", "-distance", "`exp` takes a pure number, and this is a length"),
        ("s*sin(t)", "t", "`sin` takes a pure number, and this is a time"),
        ("s*p^a^s", "s", "an exponent is a pure number, and this is a length"),
        ("s*p^mu", "p", "this is a pressure: only a pure number has an exponent that varies"),
        ("k*p", "k*p", "a depth is a length, and this gives a pure number"),
        ("p > p0", "p > p0", "a depth is a length, and this gives a condition"),
        ("k*p*work", "k*p*work", "a depth is a length, and this gives a load per length"),
    ] {
        assert_eq!(mistake(formula), (place, message.to_owned()), "{formula}");
    }
    let deep = format!("{}s{}", "(".repeat(100), ")".repeat(100));
    assert_eq!(mistake(&deep).1, "parts stand in parts more than 64 deep");
    let deep = format!("{}s", "-".repeat(100));
    assert_eq!(mistake(&deep).1, "parts stand in parts more than 64 deep");
    let long = format!("s{}", "+ s".repeat(1000));
    assert_eq!(mistake(&long).1, "is longer than 2000 characters");
}

#[test]
fn dimensions_agree() {
    for formula in [
        "k*p*s",
        "k*max(p - p0, 0)*s*(1 + a*exp(-distance/s0))",
        "k*p0*(p/p0)^1.3*s",
        "k*p0^-0.3*p^1.3*s",
        "sqrt(k*p*s*s)",
        "k*work*mu",
        "if(p > 0 and not (s > s0), k*p*s, 0)",
        "v*t*k*p",
        "min(k*p, 0.5)*s + abs(-worn) - worn",
        "rolled*tanh(p/p0)",
        "s*cos(mu)^2*a^mu",
        "0",
    ] {
        let checked = dimension::check(&parser::parse(formula).unwrap(), &scope());
        assert_eq!(checked, Ok(()), "{formula}");
    }
}

/// d / dp, work and coefficient following the limit of friction, against central differences.
#[test]
fn slopes_are_derivatives() {
    for formula in [
        "k*p*s",
        "k*(p - p0)^2*s",
        "k*p0*(p/p0)^1.3*s",
        "s*(p/p0)^(p/p0)",
        "s*mu^(p/p0)",
        "s*exp(-p0/p) - s*ln(p/p0)",
        "s*sqrt(1 + (p/p0)^3)",
        "s*abs(sin(p/p0) + cos(2*p/p0))*tanh(p/p0)",
        "min(k*p, 2*p/p0, 5)*s",
        "max(-p/p0, p/p0, 0.1)*s",
        "if(p > p0, p/p0, 1)*s/(1 + p0/p)",
        "k*work*mu",
        "work*s/(p0*s0*mu)",
        "-(p0/p)^-0.5*s",
    ] {
        let tape = tape(formula);
        // Friction that grows less than in proportion to the pressure.
        let rubbing = rubbing().with_friction(0.35 * 1e8 * 0.2, 0.2);
        let at = |pressure: f64| tape.at(&one(&rubbing.under(pressure)));
        let difference = (at(1e8 + 1e3).0 - at(1e8 - 1e3).0) / 2e3;
        assert_relative_eq!(1e8 * at(1e8).1, 1e8 * difference, max_relative = 1e-7);
        assert!(difference != 0.0, "{formula}");
    }
    // Where it jumps, towards more pressure.
    for (formula, slope) in [
        ("max(p - p1, 0)", 1.0),
        ("min(p, p1)", 0.0),
        ("abs(p - p1)", 1.0),
        ("max(p1 - p, 0)^2", 0.0),
    ] {
        let mut scope = Scope::default();
        scope.add("p1", "100 MPa").unwrap();
        let tape = Tape::new(&parser::parse(formula).unwrap(), &scope);
        assert_eq!(tape.at(&one(&rubbing())).1, slope, "{formula}");
    }
}

/// Columns of any length give what single points give, to the bit.
#[test]
fn columns_are_points() {
    let formula =
        "k*max(p - p0, 0)*s*(1 + a*exp(-distance/s0))*mu^0.3*tanh(1 + worn/s0)*(v/v0)^0.1";
    let mut constants = CONSTANTS[..4].to_vec();
    constants.push(("v0", "1 m/s"));
    let law = Expression::new(formula, &constants, Per::Cycle).unwrap();
    for count in [0, 1, 63, 64, 65, 200] {
        let points = (0..count).map(|i| {
            let share = f64::from(i) / 50.0;
            Rubbing::new(1e8 * share.sin().abs(), 0.1 * share)
                .with_friction(1e6 * share, 0.2)
                .at_speed(1.0 + share)
                .after(5.0 * share, 1e-6 * share)
        });
        let points = Columns::of(points, law.inputs());
        let (mut depths, mut slopes) = (vec![0.0; points.len()], vec![0.0; points.len()]);
        law.depths(&points, &mut depths, &mut slopes);
        for (point, (depth, slope)) in depths.into_iter().zip(slopes).enumerate() {
            let rubbing = points.at(point);
            assert_eq!(depth.to_bits(), law.depth(rubbing).to_bits());
            assert_eq!(slope.to_bits(), law.slope(rubbing).to_bits());
        }
    }
}

type Law = Box<dyn WearLaw>;

/// The listed laws, written as formulas.
#[test]
fn formulas_of_listed_laws_are_those_laws() {
    let law = |formula: &str, constants: &[(&str, &str)]| -> Law {
        Box::new(Expression::new(formula, constants, Per::Increment).unwrap())
    };
    let k = ("k", "1.3e-13 1/Pa");
    let pairs: [(Law, Law, f64); 3] = [
        (law("k*p*s", &[k]), Box::new(Archard::new(1.3e-13).unwrap()), 0.0),
        (
            law("k*max(p - p0, 0)*s", &[k, ("p0", "30 MPa")]),
            Box::new(Threshold::new(1.3e-13, 3e7).unwrap()),
            0.0,
        ),
        (
            law(
                "p*(k1*s + (k0 - k1)*s0*(1 - exp(-s/s0))*exp(-distance/s0))",
                &[("k0", "5e-13 1/Pa"), ("k1", "1e-13 1/Pa"), ("s0", "20 mm")],
            ),
            Box::new(RunningIn::new([5e-13, 1e-13], 0.02).unwrap()),
            1e-14,
        ),
    ];
    for (formula, listed, within) in pairs {
        for pressure in [0.0, 1e4, 2.9e7, 3e7, 1e8, 3.3e9] {
            for slip in [0.0, 1e-3, 0.7] {
                let rubbing = Rubbing::new(pressure, slip).after(0.013, 0.0);
                let of = |law: &dyn WearLaw| [law.depth(rubbing), law.slope(rubbing)];
                for (one, other) in of(&*formula).into_iter().zip(of(&*listed)) {
                    assert!((one - other).abs() <= within * other.abs(), "{one:e} {other:e}");
                }
            }
        }
    }
}

#[test]
fn a_law_asks_for_what_its_formula_names() {
    let law = |formula| Expression::new(formula, &CONSTANTS[..1], Per::Increment).unwrap();
    assert_eq!(law("k*p*s").inputs(), []);
    assert_eq!(law("k*work*(1 + mu)").inputs(), [Input::Friction]);
    let named = "k*p*s*tanh(1 + distance/(distance + worn) + rolled/(rolled + v*t))";
    let constants = [CONSTANTS[0], CONSTANTS[4]];
    let refused = Expression::new(named, &constants, Per::Increment).unwrap_err();
    assert!(refused.message.contains("is no finite number"), "{refused}");
    let named = named.replace("distance + worn", "distance + worn + s0");
    let constants = [CONSTANTS[0], CONSTANTS[3], CONSTANTS[4]];
    let law = Expression::new(&named, &constants, Per::Cycle).unwrap();
    assert_eq!(law.inputs(), [Input::Distance, Input::Depth, Input::Rolled, Input::Speed]);
    assert_eq!(law.per(), Per::Cycle);
}

/// What a formula is refused for, by the parameter to change.
fn refused(formula: &str, constants: &[(&str, &str)]) -> String {
    Expression::new(formula, constants, Per::Increment).unwrap_err().to_string()
}

#[test]
fn constants_are_used_and_mean_nothing_else() {
    let k = ("k", "1e-13 1/Pa");
    let meant = "has a meaning in formulas already: name the constant otherwise";
    for name in ["p", "worn", "exp", "if", "and"] {
        assert_eq!(refused("k*p*s", &[k, (name, "1")]), format!("`{name}`: {meant}"));
    }
    let surplus = "`k2`: is no key of the law and no constant that the formula names";
    assert_eq!(refused("k*p*s", &[k, ("k2", "1")]), surplus);
    assert!(
        refused("k*p*s", &[("k", "1e-13 1/Paa")]).starts_with("`k`: `Paa` is not a known unit")
    );
    assert!(refused("k*p*s", &[("k", "1e-13")]).contains("this gives a load per length"));
}

#[test]
fn laws_that_break_what_they_owe_are_refused_at_a_point() {
    let constants =
        [("k", "1e-13 1/Pa"), ("p0", "1 GPa"), ("s0", "1 m"), ("w0", "100 nm"), ("m", "0.5")];
    for (formula, message) in [
        ("k*(p + p0)*s", "grows from nothing: 1e-13 m without pressure, at p = 0 Pa, s = 1e-9 m"),
        ("k*p*(s + s0)", "grows from nothing: 1e-13 m without slip, at p = 1 Pa, s = 0 m"),
        ("k*p*s*exp(-p/p0)", "falls as the pressure grows: "),
        ("k*p*s*(1 - worn/w0)", "is negative: -9e-22 m at p = 1 Pa, s = 1e-9 m, worn = 1e-6 m"),
        ("k*p*s*s0/s", "is no finite number, NaN at p = 0 Pa, s = 0 m"),
        ("k*p0*(p/p0)^m*s", "rises infinitely steep with the pressure, at p = 0 Pa"),
        ("k*p*s*(1 + s/s0)", "is not in proportion to the slip: "),
        ("k*max(p*s - p0*s0, 0)", "is not in proportion to the slip: "),
    ] {
        let named =
            constants.iter().filter(|(name, _)| parser::parse(formula).unwrap().names(name));
        let found = refused(formula, &named.copied().collect::<Vec<_>>());
        assert!(found.contains(message), "{formula}: {found}");
    }
    let whole = Expression::new("k*max(p*s - p0*s0, 0)", &constants[..3], Per::Cycle);
    assert!(whole.is_ok());
    assert!(Expression::new("k*p*(p/p0)^0.3*s", &constants[..2], Per::Increment).is_ok());
    // The straight line that the message proposes.
    let straight = [constants[0], ("p1", "1 MPa"), constants[1]];
    let straight = Expression::new("k*p*(max(p, p1)/p0)^-0.5*s", &straight, Per::Increment);
    assert!(straight.is_ok());
}
