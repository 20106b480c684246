//! Tables in formulas.

use approx::assert_relative_eq;

use crate::units::Dimension;
use crate::wear::expression::{Expression, LookUp};
use crate::wear::{Columns, Over, Per, Rubbing, Table, WearLaw};

/// k over the pressure: 1e-13 1/Pa up to 100 MPa, falling by a fifth up to 300 MPa.
fn over_pressure() -> LookUp {
    let dimensions = [Dimension::PRESSURE, Dimension::WEAR_COEFFICIENT];
    LookUp::new(&[1e8, 3e8], &[1e-13, 0.8e-13], dimensions).unwrap()
}

fn tabulated(formula: &str) -> Result<Expression, crate::parameters::Invalid> {
    let tables = [("k.csv", over_pressure())];
    Expression::with_tables(formula, &[("f", "2")], &tables, Per::Increment)
}

/// The law `table` over the pressure, value and slope, between the points, at them and beyond; in chunks as one by one.
#[test]
fn values_are_looked_up_as_by_the_law_of_tables() {
    let law = tabulated("f*table('k.csv', p)*p*s/2").unwrap();
    let listed = Table::new(Over::Pressure, &[1e8, 3e8], &[1e-13, 0.8e-13]).unwrap();
    let points = [0.0, 5e7, 1e8, 1.7e8, 3e8, 9e8].map(|pressure| Rubbing::new(pressure, 0.2));
    let columns = Columns::of(points, law.inputs());
    let (mut depths, mut slopes) = ([0.0; 6], [0.0; 6]);
    law.depths(&columns, &mut depths, &mut slopes);
    for (at, point) in points.into_iter().enumerate() {
        assert_relative_eq!(1e6 * depths[at], 1e6 * listed.depth(point), max_relative = 1e-14);
        assert_relative_eq!(1e14 * slopes[at], 1e14 * listed.slope(point), max_relative = 1e-13);
        assert_eq!((depths[at], slopes[at]), (law.depth(point), law.slope(point)));
    }
}

/// At a point of the table a place that falls as the pressure grows takes the slope before it.
#[test]
fn slopes_at_points_are_those_towards_more_pressure() {
    let tables = [("k.csv", over_pressure())];
    let constants = [("p0", "400 MPa")];
    let formula = "table('k.csv', max(p0 - p, 0))*p*s";
    let law = Expression::with_tables(formula, &constants, &tables, Per::Increment).unwrap();
    // At p = 100 MPa the place is 300 MPa and falls: the coefficient rises by 1e-22 1/Pa^2.
    let slope = law.slope(Rubbing::new(1e8, 1.0));
    assert_relative_eq!(1e13 * slope, 0.8 + 0.1, max_relative = 1e-12);
    // At p = 300 MPa the place is 100 MPa, below which the table is held.
    assert_relative_eq!(1e13 * law.slope(Rubbing::new(3e8, 1.0)), 1.0, max_relative = 1e-12);
}

#[test]
fn tables_that_do_not_fit_are_pointed_at() {
    for (formula, at, message) in [
        ("table('k.csv', s)*p*s", "s", "`k.csv` is over a pressure, and this is a length"),
        ("table('mu.csv', p)*p*s", "'mu.csv'", "there is no table `mu.csv`"),
        ("table('k.csv')*p*s", "table", "`table` takes a file and a value"),
        ("table(p, 'k.csv')*p*s", "table", "`table` takes a file and a value"),
        ("table*p*s", "table", "`table` takes a file and a value"),
        ("'k.csv'*p*s", "'k.csv'", "the name of a file stands in `table` only"),
        ("table('k.csv, p)*p*s", "'k.csv, p)*p*s", "this name of a file is not closed"),
        ("table('k.csv', p)*s", "table('k.csv', p)*s", "a depth is a length, and this gives"),
    ] {
        let error = tabulated(formula).unwrap_err();
        assert!(error.message.contains(message), "{formula}: {error}");
        let within = error.within.unwrap();
        assert_eq!(&formula[within], at, "{formula}");
    }
    let constant = Expression::new("table*p*s", &[("table", "1 1/Pa")], Per::Increment);
    assert!(constant.unwrap_err().message.contains("has a meaning in formulas"));
}
