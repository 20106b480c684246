//! The numbers that small made-up runs leave, against what they were made to.

mod limits;
mod places;
mod work;

use approx::assert_relative_eq;

use super::{Evidence, worst};
use crate::output::fixture::{CREEPAGE, DISSIPATED, FRICTION, LOAD, Run};
use crate::verdict::{Verdict, Word};
use archard::frame::Direction;
use archard::motion::{Control, Stepping};
use archard::problem::ContactState;
use archard::simulation::{Effort, Report, row};

#[test]
fn the_worst_is_kept_and_no_number_is_the_worst() {
    let mut known = None;
    for (found, expected) in [(None, None), (Some(1.0), Some(1.0)), (Some(0.5), Some(1.0))] {
        worst(&mut known, found);
        assert_eq!(known, expected);
    }
    worst(&mut known, Some(f64::NAN));
    worst(&mut known, Some(2.0));
    assert!(known.is_some_and(f64::is_nan));
}

/// A report of a state, due for output, that asks for the load it carries.
fn report<'a>(run: &'a Run, state: &'a ContactState) -> Report<'a> {
    let effort = Effort { load_distance: run.load_distance(state.progress), ..Effort::default() };
    let (prescribed, stepping) = (Control::Load(LOAD), Stepping::Implicit(1.0));
    Report {
        problem: &run.problem,
        state,
        effort,
        output: true,
        extent: 1.0,
        prescribed,
        stepping,
        companions: None,
        again: false,
        march: None,
    }
}

/// What reports leave.
fn judge<'a>(reports: impl IntoIterator<Item = Report<'a>>) -> Verdict {
    let mut evidence = Evidence::default();
    reports.into_iter().for_each(|report| evidence.take(&report, &row(&report)));
    evidence.verdict()
}

/// The number on a line; `None` where there is no such line.
fn value(verdict: &Verdict, subject: &str) -> Option<f64> {
    verdict.lines.iter().find(|line| line.subject == subject).map(|line| line.value)
}

#[test]
fn a_load_that_is_off_either_way_counts_and_the_worst_stays() {
    let run = Run::pin_on_disc([9, 8]);
    let state = run.state(0.0);
    for (found, off) in [(0.9 * LOAD, 0.1), (1.1 * LOAD, 0.1), (0.0, 1.0)] {
        let other = ContactState { load: found, ..state.clone() };
        let verdict = judge([report(&run, &other), report(&run, &state)]);
        assert_relative_eq!(value(&verdict, "load").unwrap(), off, max_relative = 1e-12);
    }
    let lifted = |load| Report { prescribed: Control::Load(load), ..report(&run, &state) };
    assert_eq!(value(&judge([lifted(0.0)]), "load"), Some(f64::INFINITY));
    let at = Control::Approach(2.0 * state.approach);
    let verdict = judge([Report { prescribed: at, ..report(&run, &state) }]);
    assert_relative_eq!(value(&verdict, "load").unwrap(), 0.5, max_relative = 1e-12);
}

/// Made-up sliding closes; half of the wear, or twice the load, is missing by a half, half of the load by one.
#[test]
fn volumes_are_held_against_the_load_over_the_distance() {
    let run = Run::pin_on_disc([9, 8]);
    let state = run.state(0.5);
    for (factor, off) in [(1.0, 0.0), (2.0, 0.5), (0.5, 1.0)] {
        let mut report = report(&run, &state);
        report.effort.load_distance *= factor;
        let found = value(&judge([report]), "volume").unwrap();
        assert_relative_eq!(found, off, epsilon = 1e-12);
    }
    let unworn = run.state(0.0);
    assert_eq!(value(&judge([report(&run, &unworn)]), "volume"), None);
}

/// In cycles it is what was dissipated in whole cycles over mu, and only at their ends.
#[test]
fn volumes_of_cycles_are_held_against_what_was_dissipated() {
    let (run, slid) = (Run::fretting([9, 8]), Run::pin_on_disc([9, 8]).state(0.5));
    let volume = |progress: f64, cycles: f64, worn_by: f64| {
        let surfaces = slid.surfaces.clone();
        let state = ContactState { surfaces, ..run.state(progress) };
        let mut report = report(&run, &state);
        // k F s = k W / mu.
        report.effort.dissipated = [DISSIPATED, FRICTION * worn_by * LOAD];
        report.effort.true_cycles = cycles as usize;
        value(&judge([report]), "volume")
    };
    assert_relative_eq!(volume(3.0, 3.0, 0.5).unwrap(), 0.0, epsilon = 1e-12);
    assert_relative_eq!(volume(3.0, 3.0, 1.0).unwrap(), 0.5, epsilon = 1e-12);
    assert_eq!(volume(2.5, 2.0, 0.5), None);
}

/// Half of the pin sticks; all of it, which is no zone; and twin discs, where nothing is asked.
#[test]
fn a_stick_zone_is_one_beside_slip() {
    let pin = Run::fretting([48, 48]);
    let mut state = pin.state(0.25);
    assert_eq!(value(&judge([report(&pin, &state)]), "stick zone"), None);
    let limits = state.pressure.iter().map(|pressure| FRICTION * pressure);
    let tractions = &mut state.tangential.as_mut().unwrap().traction[0];
    for (pair, (traction, limit)) in tractions.iter_mut().zip(limits).enumerate() {
        if pin.problem.frame.place(pair)[0] > 0.0 {
            *traction = limit;
        }
    }
    let verdict = judge([report(&pin, &state)]);
    // The contact is 0.3 mm wide on elements of 0.025 mm.
    assert_eq!(value(&verdict, "contact"), Some(12.0));
    assert_eq!(value(&verdict, "stick zone"), Some(6.0));
    let discs = Run::twin_discs([40, 20], Direction { axis: 0, reversed: false });
    let state = discs.state(100.0);
    let verdict = judge([report(&discs, &state)]);
    // The contact is 0.3 mm by 1.2 mm on elements of 0.0125 mm by 0.1 mm.
    assert_eq!(value(&verdict, "contact"), Some(12.0));
    assert_eq!(value(&verdict, "stick zone"), None);
    let volume = value(&verdict, "volume").unwrap();
    assert_relative_eq!(volume, 0.0, epsilon = 1e-12);
    assert!(state.tangential.as_ref().unwrap().creepage[0] == CREEPAGE);
}

/// An error in time is judged where a tolerance was asked for.
#[test]
fn errors_in_time_are_held_against_a_tolerance() {
    let run = Run::pin_on_disc([9, 8]);
    let state = run.state(0.5);
    let verdict = |stepping| {
        let mut report = Report { stepping, ..report(&run, &state) };
        report.effort.time_error = Some(0.02);
        judge([report])
    };
    let word = |tolerance| {
        let verdict = verdict(Stepping::Tolerance(tolerance));
        verdict.lines.into_iter().find(|line| line.subject == "time").unwrap().word().text()
    };
    assert_eq!([word(0.02), word(0.009), word(1e-3)], ["good", "doubtful", "doubtful"]);
    assert_eq!(value(&verdict(Stepping::Implicit(0.1)), "time"), None);
}

/// The largest share that edges ever bore stays.
#[test]
fn edges_once_pressed_stay_pressed() {
    let run = Run::pressed([5, 4], 0.3);
    let with = |pressure: &dyn Fn(usize) -> f64| {
        let pressure = (0..20).map(pressure).collect();
        ContactState { pressure, ..run.state(0.0) }
    };
    let half = with(&|pair| if pair == 0 || pair == 7 { 1e8 } else { 0.0 });
    let free = with(&|pair| if pair == 7 { 1e8 } else { 0.0 });
    for states in [[&half, &free], [&free, &half]] {
        let verdict = judge(states.map(|state| report(&run, state)));
        assert_relative_eq!(value(&verdict, "edges").unwrap(), 0.5, max_relative = 1e-12);
    }
}

/// The elements across the contact at its first output, and at its widest.
#[test]
fn contacts_are_counted_at_first_and_at_their_largest() {
    let run = Run::pin_on_disc([24, 24]);
    let [first, last] = [run.state(0.0), run.state(0.5)];
    let across = |state: &ContactState| {
        let row = (0..24).map(|x| x + 24 * 11);
        row.filter(|&pair| state.pressure[pair] > 0.0).count() as f64
    };
    assert!(across(&first) < across(&last));
    let verdict = judge([&first, &last, &first].map(|state| report(&run, state)));
    assert_eq!(value(&verdict, "elements"), Some(across(&first)));
    assert_eq!(value(&verdict, "contact"), Some(across(&last)));
    let verdict = judge([&first, &last].map(|state| report(&run, state)));
    assert_eq!(value(&verdict, "elements"), Some(across(&first)));
    let hidden = Report { output: false, ..report(&run, &first) };
    let verdict = judge([hidden, report(&run, &last)]);
    assert_eq!(value(&verdict, "elements"), Some(across(&last)));
}

/// Pressures that alternate along either axis, or stand out, by a given part of the largest.
#[test]
fn pressures_are_rough_along_both_axes() {
    let run = Run::pressed([9, 9], 0.3);
    let smooth = run.state(0.0);
    let found = |at: &dyn Fn(usize, usize) -> f64| {
        let pressure = (0..81).map(|pair| at(pair % 9, pair / 9)).collect();
        let state = ContactState { pressure, ..smooth.clone() };
        value(&judge([report(&run, &state)]), "pressures")
    };
    for alternates in [|x: usize, _: usize| x % 2, |_: usize, y: usize| y % 2] {
        let off = found(&|x, y| if alternates(x, y) == 1 { 1.0 } else { 0.8 });
        assert_relative_eq!(off.unwrap(), 0.1, max_relative = 1e-12);
    }
    let spike = found(&|x, y| if (x, y) == (4, 4) { 1.0 } else { 0.75 });
    assert_relative_eq!(spike.unwrap(), 0.25, max_relative = 1e-12);
    // A ridge that rises evenly towards its middle is not an edge.
    assert_eq!(found(&|x, _| 1.0 - 0.1 * x.abs_diff(4) as f64), Some(0.0));
    assert_eq!(found(&|_, _| 1.0), Some(0.0));
}

#[test]
fn increments_that_do_not_settle_count_beside_all_solves() {
    let run = Run::fretting([9, 8]);
    let state = run.state(0.25);
    let touch = |unsettled: usize| {
        let mut report = report(&run, &state);
        (report.effort.unsettled, report.effort.solves) = (unsettled, 40);
        let verdict = judge([report]);
        let line = verdict.lines.into_iter().find(|line| line.subject == "touch");
        line.map(|line| (line.value, line.word()))
    };
    assert_eq!(touch(0), None);
    assert_eq!(touch(1), Some((0.025, Word::Doubtful)));
}
