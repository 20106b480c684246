//! The wear coefficients of a railway wheel, of its tread and of its flange, from profiles measured after it ran.
//!
//! A run of the route says how deep each zone wears; the measured profile says how many times as much it did. As the contacts move
//! while profiles wear, both zones depend on both coefficients a little: by how much follows from runs with each of them
//! changed. Rounds of runs end where the coefficients stay. What tests scatter is the business of [`joint`](super::joint).

mod laid;
mod runs;
mod table;
mod whitened;

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use archard_case::measured::Table;
use archard_case::{CaseFile, Task, WheelRailCase};

use super::estimate::UNTOLD;
use super::joint::Joint;
use super::joint::matrix::{Matrix, zeros};
use super::{Coefficient, Common, Error, Fit, Request};
use laid::{Laid, Zones};
use runs::{Run, Runs};
use table::{Measured, measured};
use whitened::Whitened;

/// The factor by which a coefficient is changed to see what it does: runs jump by some per cent with it, as their contacts do, and
/// are a tenth of what they change then.
const TRIED: f64 = 1.5;
/// Rounds of runs.
const ROUNDS: usize = 10;
/// Largest change of the logarithms of coefficients from one round to the next.
const FARTHEST: f64 = 2.0;
/// Rounds that change the coefficients freely.
const FREE: f64 = 3.0;
/// Change of the logarithms at which they have settled: in standard uncertainties, those of the runs included, to which a quarter
/// adds 3 %.
const SETTLED: f64 = 0.25;

/// A coefficient that is sought: its key, its value in the case.
struct Target {
    key: String,
    value: f64,
}

/// What all profiles say at coefficients: each laid on its run.
struct Round {
    laid: Vec<Laid>,
    /// Computed areas (m^2) of the zones.
    areas: Vec<Vec<f64>>,
    /// Errors of the logarithms of the areas by elements and steps.
    errors: Vec<Vec<f64>>,
}

/// The coefficients of a wheel.
pub(super) fn fit(
    (file, case): (&CaseFile, &WheelRailCase),
    table: &Table,
    request: Request<'_>,
) -> Result<Fit, Error> {
    if !request.parameters.is_empty() || !request.uncertain.is_empty() {
        return Err(Error::Mismatch(
            "of a wheel on its rail the coefficients of the tread and of the flange are fitted, without further uncertainties: leave \
             --parameter and --uncertain out"
                .to_owned(),
        ));
    }
    let targets = targets(case)?;
    rail_is_told(case, request.assumed)?;
    let measured = measured(case, table, &request)?;
    let mut runs = Runs::of(file, case, &mut *request.following)?;
    let zones = Zones(if targets.len() > 1 { runs.flange_from() } else { None });
    let mut logs: Vec<f64> = targets.iter().map(|own| own.value.ln()).collect();
    let mut slopes: Option<Vec<Matrix>> = None;
    for round in 0..ROUNDS {
        let at = at(&mut runs, (&targets, &logs), (&measured, zones), table)?;
        // At first each zone has its own coefficient.
        if round == 1 {
            slopes = Some(sensitivities(
                &mut runs,
                (&targets, &logs),
                (&measured, zones),
                (table, &at),
            )?);
        }
        let unit: Vec<Matrix> = measured.iter().map(|_| identity(targets.len())).collect();
        let whitened = Whitened::of((&measured, &at), slopes.as_ref().unwrap_or(&unit), &logs)?;
        let joint = whitened.joint(&targets)?;
        let change: Vec<f64> = joint.logs.iter().zip(&logs).map(|(new, old)| new - old).collect();
        let by_runs = whitened.response(&joint, &at.errors);
        let estimates = joint.estimates(&whitened.tests, &[]);
        let small = |((change, estimate), by_runs): ((&f64, &super::Estimate), &f64)| {
            let readings = estimate.budget.iter().map(|(_, own)| own * own).sum::<f64>();
            *by_runs <= UNTOLD && change.abs() <= SETTLED * (readings + by_runs * by_runs).sqrt()
        };
        let settled = change.iter().zip(&estimates).zip(&by_runs).all(small);
        if slopes.is_some() && settled {
            let doubts = runs.doubts(&settings(&targets, &logs))?;
            let found = (&joint, &whitened);
            return Ok(conclude((targets, measured, zones), &at, found, (&runs, doubts)));
        }
        // Runs jump a little with the coefficients, as contacts do: by less and less (H. Robbins and S. Monro, Ann. Math. Stat.
        // 22 (1951) 400).
        let share = (FREE / (round as f64 + 1.0)).min(1.0);
        for (log, change) in logs.iter_mut().zip(change) {
            *log += share * change.clamp(-FARTHEST, FARTHEST);
        }
    }
    Err(Error::Mismatch(
        "the coefficients did not settle: runs jump with them by more than the profiles tell; more points of the route, more \
         `frame.elements` or a longer `wear_smoothing` make them jump less"
            .to_owned(),
    ))
}

/// The case of a file.
fn wheel_of(file: &CaseFile) -> Result<WheelRailCase, Error> {
    match file.task() {
        Ok(Task::WheelRail(resolved)) => Ok(resolved.case),
        Ok(_) => Err(Error::Mismatch("the case is none of a wheel on its rail".to_owned())),
        Err(problems) => Err(Error::of_case(file, &problems)),
    }
}

/// The coefficients of the wheel.
fn targets(case: &WheelRailCase) -> Result<Vec<Target>, Error> {
    let wheel = &case.wheel;
    let laws = [("wear", &wheel.wear), ("flange_wear", &wheel.flange_wear)];
    let laws = laws.into_iter().filter_map(|(table, law)| Some((table, law.as_ref()?)));
    let target = |(table, law): (&str, &archard_case::ChosenPart<_>)| {
        let law: &archard_case::ChosenPart<Box<dyn archard::wear::WearLaw>> = law;
        let table = format!("body.{}.{table}.{}", wheel.name, law.choice.name);
        let value = law.values.number("coefficient").filter(|value| *value > 0.0);
        let value = value.ok_or_else(|| {
            Error::Mismatch(format!(
                "`{table}` has no single coefficient that a worn profile could tell: fit a law with a `coefficient`, as `archard`"
            ))
        })?;
        Ok(Target { key: format!("{table}.coefficient"), value })
    };
    let found: Vec<Target> = laws.map(target).collect::<Result<_, Error>>()?;
    if found.is_empty() {
        return Err(Error::Mismatch(format!(
            "`{}` has no wear law: nothing is fitted",
            wheel.name
        )));
    }
    Ok(found)
}

/// Refuses a rail that wears by a law which nobody has told: contacts go by it.
fn rail_is_told(case: &WheelRailCase, assumed: &[String]) -> Result<(), Error> {
    let key = format!("body.{}.wear", case.rail.name);
    if case.rail.wear.is_none() || assumed.iter().any(|own| own.starts_with(&key)) {
        return Ok(());
    }
    Err(Error::Mismatch(format!(
        "the rail wears by `{key}`, which no profile of a wheel tells, and contacts go by it: add --assume {key} to take it from the \
         case, or leave it out"
    )))
}

/// Keys with the coefficients of those logarithms.
fn settings<'t>(targets: &'t [Target], logs: &[f64]) -> Vec<(&'t str, f64)> {
    targets.iter().zip(logs).map(|(target, log)| (&*target.key, log.exp())).collect()
}

/// What the profiles say at logarithms of the coefficients.
fn at(
    runs: &mut Runs<'_>,
    (targets, logs): (&[Target], &[f64]),
    (measured, zones): (&[Measured], Zones),
    table: &Table,
) -> Result<Round, Error> {
    let settings = settings(targets, logs);
    let mut known: HashMap<u64, Run> = HashMap::new();
    let mut round = Round { laid: vec![], areas: vec![], errors: vec![] };
    for own in measured {
        let of_run = match known.entry(own.distance.to_bits()) {
            Entry::Occupied(run) => run.into_mut(),
            Entry::Vacant(none) => none.insert(runs.run(&settings, own.distance)?),
        };
        let lay = |worn: &archard_rail::wear::WornSide| {
            Laid::of(&worn.wheel, &own.curve, zones).map_err(|why| Error::Reading {
                table: table.source().to_owned(),
                line: own.line,
                why: format!("`{}`: {why}", own.file),
            })
        };
        // By areas: another grid wears elsewhere by a little, and no share of one shape is the other.
        let areas = [0, 1, 2].map(|pass| zones.areas(&of_run[pass][own.side].wheel));
        let error = |zone: usize| {
            archard_rail::wear::error_of([0, 1, 2].map(|pass| areas[pass][zone].ln()))
        };
        round.errors.push((0..areas[0].len()).map(error).collect());
        round.laid.push(lay(&of_run[0][own.side])?);
        round.areas.extend(areas.into_iter().next());
    }
    Ok(round)
}

/// By how much the logarithms of what zones wear grow with those of the coefficients, for each profile: zones in rows.
fn sensitivities(
    runs: &mut Runs<'_>,
    (targets, logs): (&[Target], &[f64]),
    profiles: (&[Measured], Zones),
    (table, plain): (&Table, &Round),
) -> Result<Vec<Matrix>, Error> {
    let mut all: Vec<Matrix> = plain.laid.iter().map(|_| zeros(targets.len())).collect();
    for place in 0..targets.len() {
        let mut tried = logs.to_vec();
        tried[place] += TRIED.ln();
        let other = at(runs, (targets, &tried), profiles, table)?;
        for ((slopes, plain), other) in all.iter_mut().zip(&plain.laid).zip(&other.laid) {
            for (zone, row) in slopes.iter_mut().enumerate() {
                // What a run wears more leaves a smaller share of it.
                row[place] = (plain.shares[zone] / other.shares[zone]).ln() / TRIED.ln();
            }
        }
    }
    Ok(all)
}

fn identity(size: usize) -> Matrix {
    (0..size).map(|i| (0..size).map(|j| f64::from(u8::from(i == j))).collect()).collect()
}

/// What was found.
fn conclude(
    (targets, measured, zones): (Vec<Target>, Vec<Measured>, Zones),
    round: &Round,
    (joint, whitened): (&Joint, &Whitened),
    (runs, doubts): (&Runs<'_>, Vec<String>),
) -> Fit {
    let by_runs = whitened.response(joint, &round.errors);
    let lost: Vec<Vec<f64>> =
        measured.iter().map(|_| vec![runs.lost; zones.names().len()]).collect();
    let by_history = whitened.response(joint, &lost);
    let commons: Vec<Vec<Common>> = (0..targets.len())
        .map(|place| {
            let history = ("steps of the history".to_owned(), by_history[place]);
            let elements = ("elements and steps of the runs".to_owned(), by_runs[place]);
            [elements].into_iter().chain((runs.lost > 0.0).then_some(history)).collect()
        })
        .collect();
    let mut tests = whitened.tests.clone();
    let mut residuals: Vec<Vec<f64>> = vec![vec![]; tests.len()];
    let mut places = vec![0; tests.len()];
    for ((laid, areas), &test) in round.laid.iter().zip(&round.areas).zip(&whitened.of_test) {
        for (zone, share) in laid.shares.iter().enumerate() {
            let reading = &mut tests[test].readings[places[test]];
            reading.value = share * areas[zone];
            reading.uncertainty = Some(laid.covariance[zone][zone].sqrt() / share);
            residuals[test].push(share.ln());
            places[test] += 1;
        }
    }
    let estimates = joint.estimates(&whitened.tests, &commons);
    let coefficients = targets.iter().zip(estimates).map(|(target, mut estimate)| {
        for (fitted, residuals) in estimate.fitted.iter_mut().zip(&residuals) {
            fitted.residuals.clone_from(residuals);
        }
        Coefficient {
            key: target.key.clone(),
            unit: "1/Pa".to_owned(),
            before: target.value,
            tests: tests.clone(),
            estimate,
            assumed: false,
            curves: vec![],
        }
    });
    let coefficients = coefficients.collect();
    let remark = |(own, laid): (&Measured, &Laid)| {
        let [turn, y, z] = laid.pose;
        format!(
            "line {}, `{}`: laid on the new profile by {:.2} mrad, {:.3} mm along y, {:.3} mm along z; {:.1} um are left of its points",
            own.line,
            own.file,
            1e3 * turn,
            1e3 * y,
            1e3 * z,
            1e6 * laid.left[0]
        )
    };
    let doubt = |(own, laid): (&Measured, &Laid)| {
        laid.differs.then(|| {
            format!(
                "line {}, `{}`: the wheel is worn in another shape than the route wears it: {:.1} um are left where it wears, by more than \
                 chance; look at the route, and at `flange_from`",
                own.line, own.file, 1e6 * laid.left[1]
            )
        })
    };
    let pairs = || measured.iter().zip(&round.laid);
    Fit {
        progress: "distance",
        quantities: zones
            .names()
            .iter()
            .map(|name| (format!("area of the {name}"), 1e6, "mm2"))
            .collect(),
        coefficients,
        together: if targets.len() > 1 { joint.correlation.clone() } else { vec![] },
        surfaces: vec![],
        remarks: pairs().map(remark).collect(),
        doubts: pairs().filter_map(doubt).chain(doubts).collect(),
        runs: runs.count,
        by_k_s: false,
        unsettled: None,
    }
}
