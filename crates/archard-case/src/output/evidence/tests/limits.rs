//! How near made-up runs come to the limits of the theory.

use std::sync::Arc;

use approx::assert_relative_eq;

use super::{judge, report, value};
use crate::output::fixture::{CREEPAGE, Run};
use crate::verdict::{Line, Verdict, Word};
use archard::frame::Direction;
use archard::problem::ContactState;
use archard::wear::Archard;

/// The word on a line; `None` where there is no such line.
fn word(verdict: &Verdict, subject: &str) -> Option<Word> {
    verdict.lines.iter().find(|line| line.subject == subject).map(Line::word)
}

/// The state with its largest pressure changed to that (Pa).
fn under(run: &Run, pressure: f64) -> ContactState {
    let mut state = run.state(0.5);
    let peak = state.pressure.iter().copied().fold(0.0, f64::max);
    state.pressure.iter_mut().for_each(|one| *one *= pressure / peak);
    state
}

/// Hardness of the pin, which the law of the disc does not give: beyond it doubtful, beyond three times it wrong; the
/// modulus of 210 GPa is left for the disc. The worst state counts.
#[test]
fn pressures_are_held_against_what_bodies_bear() {
    let mut run = Run::pin_on_disc([9, 8]);
    run.problem.bodies[0].wear = Some(Arc::new(Archard::with_hardness(1e-4, 2e9).unwrap()));
    for (pressure, hardness, strain) in [
        (1.9e9, Word::Good, Word::Good),
        (2.1e9, Word::Doubtful, Word::Good),
        (6.1e9, Word::Wrong, Word::Good),
        (10.6e9, Word::Wrong, Word::Doubtful),
    ] {
        let states = [run.state(0.0), under(&run, pressure)];
        for states in [[&states[0], &states[1]], [&states[1], &states[0]]] {
            let verdict = judge(states.map(|state| report(&run, state)));
            let found = value(&verdict, "hardness").unwrap();
            assert_relative_eq!(found, pressure / 2e9, max_relative = 1e-12);
            assert_eq!(word(&verdict, "hardness"), Some(hardness), "{pressure}");
            assert_eq!(word(&verdict, "strain"), Some(strain), "{pressure}");
        }
    }
    // What a material bears counts where the law gives no hardness of its own.
    run.problem.bodies[0].indentation_hardness = Some(1e9);
    run.problem.bodies[1].indentation_hardness = Some(1.5e9);
    let verdict = judge([report(&run, &under(&run, 1.8e9))]);
    assert_relative_eq!(value(&verdict, "hardness").unwrap(), 1.2, max_relative = 1e-12);
    assert_eq!(word(&verdict, "hardness"), Some(Word::Doubtful));
    let rigid = Run::pressed([9, 8], 0.3);
    let verdict = judge([report(&rigid, &under(&rigid, 1e8))]);
    assert_relative_eq!(value(&verdict, "strain").unwrap(), 1e8 / 210e9, max_relative = 1e-12);
}

/// A sphere of 50 mm, and the discs of 30 mm, which the contact of 1.2 mm along the crown of 125 mm reaches too.
#[test]
fn contacts_reach_shares_of_the_smallest_radius() {
    let run = Run::pin_on_disc([24, 24]);
    let state = run.state(0.5);
    let across = value(&judge([report(&run, &state)]), "contact").unwrap();
    let found = value(&judge([report(&run, &state)]), "half-space").unwrap();
    assert_relative_eq!(found, 0.5 * across * 0.05e-3 / 50e-3, max_relative = 1e-12);
    let discs = Run::twin_discs([40, 20], Direction { axis: 0, reversed: false });
    let verdict = judge([report(&discs, &discs.state(100.0))]);
    assert_relative_eq!(
        value(&verdict, "half-space").unwrap(),
        0.6e-3 / 30e-3,
        max_relative = 1e-9
    );
    assert_eq!(word(&verdict, "half-space"), Some(Word::Good));
    assert_eq!(value(&verdict, "creepage"), Some(CREEPAGE));
    assert_relative_eq!(value(&verdict, "friction").unwrap(), 0.6, max_relative = 1e-12);
    assert_eq!(value(&verdict, "line"), None);
}

/// Slow, and dry: what is beyond is doubtful.
#[test]
fn creepages_and_coefficients_beyond_measure_are_doubtful() {
    let discs = Run::twin_discs([40, 20], Direction { axis: 0, reversed: false });
    let mut state = discs.state(100.0);
    state.tangential.as_mut().unwrap().creepage = [0.08, -0.08];
    let verdict = judge([report(&discs, &state)]);
    assert_relative_eq!(value(&verdict, "creepage").unwrap(), 0.08 * 2f64.sqrt());
    assert_eq!(word(&verdict, "creepage"), Some(Word::Doubtful));
    let welded = Run::pressed([9, 8], 3.0);
    let verdict = judge([report(&welded, &welded.state(0.0))]);
    assert_eq!(word(&verdict, "friction"), Some(Word::Doubtful));
    assert_eq!(value(&verdict, "creepage"), None);
}
