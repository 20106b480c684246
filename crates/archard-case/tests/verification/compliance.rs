//! The half-space compliance as an operator. Its coefficients are held against independent values
//! next to the code, where they can be reached.

use approx::assert_relative_eq;
use archard::body::Material;
use archard::compliance::{Compliance, HalfSpace};
use archard::frame::VectorField;

use crate::common::{Ball, STEEL};

const ALUMINIUM: Material = Material { young: 70e9, poisson: 0.34 };

fn half_space(elements: [usize; 2]) -> HalfSpace {
    let ball = Ball { elements, size: [1.2e-3, 0.9e-3], ..Ball::pin_on_disc(1) };
    HalfSpace::new([Some(&STEEL), Some(&ALUMINIUM)], &ball.problem().frame)
}

/// Tractions without pattern.
fn scattered(pairs: usize, seed: f64) -> VectorField {
    let values =
        |shift: f64| (0..pairs).map(|i| ((i as f64 + seed) * (1.7 + shift)).sin()).collect();
    VectorField { t1: values(0.1), t2: values(0.2), n: values(0.3) }
}

fn dot(a: &VectorField, b: &VectorField) -> f64 {
    a.components()
        .iter()
        .zip(b.components())
        .flat_map(|(a, b)| a.iter().zip(b))
        .map(|(a, b)| a * b)
        .sum()
}

/// Betti: the work of one load on the displacements of another is the same the other way round.
#[test]
fn unlike_materials_obey_reciprocity() {
    for elements in [[12, 12], [9, 14]] {
        let compliance = half_space(elements);
        let (a, b) =
            (scattered(elements[0] * elements[1], 0.0), scattered(elements[0] * elements[1], 5.0));
        let (there, back) = (dot(&a, &compliance.apply(&b)), dot(&b, &compliance.apply(&a)));
        let scale = (dot(&a, &compliance.apply(&a)) * dot(&b, &compliance.apply(&b))).sqrt();
        assert!((there - back).abs() < 1e-14 * scale, "{there} and {back}");
        assert!(dot(&a, &compliance.apply(&a)) > 0.0);
    }
}

/// Each coefficient as a reader of Johnson's section 3.6 would place it: the response to a unit
/// traction on one element, taken at two pairs in turn.
#[test]
fn coefficients_are_symmetric_pair_by_pair() {
    let compliance = half_space([5, 4]);
    let unit = |pair: usize, component: usize| {
        let mut tractions = VectorField::zeros(20);
        [&mut tractions.t1, &mut tractions.t2, &mut tractions.n][component][pair] = 1.0;
        compliance.apply(&tractions)
    };
    let largest = unit(7, 0).t1[7];
    for (p, q) in [(0, 13), (7, 8), (3, 19), (6, 6)] {
        for i in 0..3 {
            for j in 0..3 {
                let there = unit(p, i).components()[j][q];
                let back = unit(q, j).components()[i][p];
                assert!((there - back).abs() < 1e-14 * largest, "{there} and {back}");
            }
        }
    }
}

#[test]
fn the_normal_part_alone_is_the_same() {
    let compliance = half_space([11, 8]);
    let tractions = VectorField { t1: vec![0.0; 88], t2: vec![0.0; 88], ..scattered(88, 2.0) };
    let mut alone = vec![0.0; 88];
    compliance.apply_normal(&tractions.n, &mut alone);
    for (a, b) in alone.iter().zip(&compliance.apply(&tractions).n) {
        assert_relative_eq!(a, b, max_relative = 1e-12);
    }
}

/// Like materials: a normal pressure moves no pair sideways against its partner.
#[test]
fn like_materials_do_not_couple() {
    let frame = Ball::pin_on_disc(6).problem().frame;
    let compliance = HalfSpace::new([Some(&STEEL), Some(&STEEL)], &frame);
    let tractions = VectorField { t1: vec![0.0; 36], t2: vec![0.0; 36], n: vec![-1.0; 36] };
    let displacements = compliance.apply(&tractions);
    assert!(displacements.t1.iter().chain(&displacements.t2).all(|&u| u.abs() < 1e-30));
}
