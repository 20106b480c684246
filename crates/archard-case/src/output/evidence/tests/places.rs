//! Edges of frames and elements across them.

use super::super::{edges, extent};
use crate::output::fixture::{Run, build};
use archard::body::profile::PROFILES;
use archard::frame::{ContactFrame, Pairs};
use archard::problem::ContactProblem;

/// A cylinder along y on a flat, on a frame of that many elements.
fn line_contact(elements: [usize; 2]) -> ContactProblem {
    let mut problem = Run::pressed([4, 4], 0.3).problem;
    problem.bodies[0].profile = build(PROFILES, "cylinder", &[("radius", 50e-3)]).into();
    let profiles = problem.bodies.each_ref().map(|body| &*body.profile);
    problem.frame = ContactFrame::uniform([1e-3, 5e-3], elements, profiles).unwrap();
    problem
}

/// Share and number of the pairs at the edge, where one pair bears twice what another does.
fn pressed(problem: &ContactProblem, [twice, once]: [usize; 2]) -> (f64, usize) {
    let mut pressure = vec![0.0; problem.frame.len()];
    (pressure[twice], pressure[once]) = (2e8, 1e8);
    let border = edges::border(problem);
    let edges = edges::of(&problem.frame, &border, &pressure).unwrap();
    (edges.share, edges.pairs)
}

/// A pair in the middle of each of the four sides of a frame of 5 by 4, against one within.
#[test]
fn every_edge_of_a_frame_counts() {
    let problem = Run::pin_on_disc([5, 4]).problem;
    let within = 7;
    for side in [5, 9, 2, 17] {
        let (share, pairs) = pressed(&problem, [side, within]);
        assert!((share - 2.0 / 3.0).abs() < 1e-12 && pairs == 1, "{side}: {share}, {pairs}");
    }
    assert_eq!(pressed(&problem, [within, 12]), (0.0, 0));
    assert_eq!(pressed(&problem, [0, 19]), (1.0, 2));
    let border = edges::border(&problem);
    assert_eq!(border.len(), 14);
    assert_eq!(edges::of(&problem.frame, &border, &[0.0; 20]), None);
}

/// An infinitely long line contact is cut off anywhere along it, but not across it; a crown ends it.
#[test]
fn line_contacts_may_be_cut_off_along_them() {
    let mut problem = line_contact([5, 4]);
    assert_eq!(edges::border(&problem), [0, 4, 5, 9, 10, 14, 15, 19]);
    assert_eq!(edges::border(&line_contact([5, 1])), [0, 4]);
    let crowned = [("radius", 50e-3), ("crown", 1.0)];
    problem.bodies[0].profile = build(PROFILES, "disc", &crowned).into();
    assert_eq!(edges::border(&problem).len(), 14);
    // A contact that only looks like a line: the crown is on the other body.
    problem = line_contact([5, 4]);
    problem.bodies[1].profile = build(PROFILES, "disc", &[("radius", 1.0), ("crown", 0.5)]).into();
    assert_eq!(edges::border(&problem).len(), 14);
}

/// Squares of 1 mm in three rows of three, as meshes have them, with the gaps of profiles.
fn described(profile: &str, mirrored: [bool; 2], closed: bool) -> ContactProblem {
    let mut problem = line_contact([5, 4]);
    problem.bodies[0].profile = build(PROFILES, profile, &[("radius", 50e-3)]).into();
    let corner = |index: usize, axis: usize, count: f64| {
        let middle = if mirrored[axis] { 0.0 } else { 0.5 * count };
        1e-3 * (index as f64 - middle)
    };
    let square = |pair: usize| {
        let [x, y] = [corner(pair % 3, 0, 3.0), corner(pair / 3, 1, 3.0)];
        [[0.0, 0.0], [1e-3, 0.0], [1e-3, 1e-3], [0.0, 1e-3]].map(|[u, v]| [x + u, y + v, 0.0])
    };
    let place = |pair: usize| {
        let [low, _, high, _] = square(pair);
        [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.0]
    };
    let gap = |pair: usize| {
        let [x, y, _] = place(pair);
        problem.bodies[0].profile.recess(x, y)
    };
    let frame = ContactFrame::described(Pairs {
        places: (0..9).map(place).collect(),
        areas: vec![1e-6; 9],
        gap: (0..9).map(gap).collect(),
        outlines: (0..9).map(|pair| square(pair).to_vec()).collect(),
        mirrored,
        closed,
        ..Pairs::default()
    });
    problem.frame = frame.unwrap();
    problem
}

/// A plane of symmetry is no edge, nor is the end of a body, nor that towards which the gaps do not change.
#[test]
fn edges_of_meshes_are_those_that_a_contact_can_outgrow() {
    let border = |profile, mirrored, closed| edges::border(&described(profile, mirrored, closed));
    assert_eq!(border("sphere", [true, true], false), [2, 5, 6, 7, 8]);
    assert_eq!(border("sphere", [true, false], false), [0, 1, 2, 5, 6, 7, 8]);
    assert_eq!(border("sphere", [false, true], false), [0, 2, 3, 5, 6, 7, 8]);
    assert_eq!(border("cylinder", [true, true], false), [2, 5, 8]);
    assert_eq!(border("cylinder", [false, true], false), [0, 2, 3, 5, 6, 8]);
    assert_eq!(border("sphere", [true, true], true), [0; 0]);
}

/// Two columns of three: along the axis with fewer, unless it has one element only.
#[test]
fn elements_are_counted_along_the_axis_with_the_fewest() {
    let across = |problem: &ContactProblem, pairs: &[usize]| {
        extent::across(problem, |pair| pairs.contains(&pair))
    };
    let problem = Run::pin_on_disc([5, 4]).problem;
    assert_eq!(across(&problem, &[6, 7, 11, 12, 16, 17]), Some(2.0));
    assert_eq!(across(&problem, &[6, 9]), Some(1.0));
    assert_eq!(across(&problem, &[0, 19]), Some(4.0));
    assert_eq!(across(&problem, &[]), None);
    assert_eq!(across(&line_contact([5, 1]), &[1, 2, 3]), Some(3.0));
    // A quarter with its images has four times as many; a half twice.
    assert_eq!(across(&described("sphere", [true, true], false), &[0, 1, 3, 4]), Some(4.0));
    assert_eq!(across(&described("sphere", [true, false], false), &[0, 3]), Some(2.0));
}

/// A fan of 24 triangles around the first point of contact is one element to either side, not five across.
#[test]
fn a_ring_of_narrow_elements_resolves_nothing() {
    let corner = |step: usize| {
        let angle = std::f64::consts::TAU * step as f64 / 24.0;
        [1e-3 * angle.cos(), 1e-3 * angle.sin(), 0.0]
    };
    let outline = |step: usize| vec![[0.0; 3], corner(step), corner(step + 1)];
    let place = |step: usize| {
        let outline = outline(step);
        [0, 1, 2].map(|axis| outline.iter().map(|corner| corner[axis]).sum::<f64>() / 3.0)
    };
    let mut problem = line_contact([5, 4]);
    let pairs = Pairs {
        places: (0..24).map(place).collect(),
        areas: vec![1e-7; 24],
        gap: vec![0.0; 24],
        outlines: (0..24).map(outline).collect(),
        ..Pairs::default()
    };
    problem.frame = ContactFrame::described(pairs).unwrap();
    let across = extent::across(&problem, |_| true).unwrap();
    assert!((across - 2.8).abs() < 0.1, "{across}");
}
