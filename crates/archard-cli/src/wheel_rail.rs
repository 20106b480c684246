//! A wheel on its rail, through to its result folder.

use std::ops::ControlFlow;
use std::time::Instant;

use archard_case::ResolvedWheelRail;
use archard_case::output::{
    Claim, RailContact, RailEconomy, RailHistory, RailLife, RailPlan, RailWear, RouteKeeper,
    write_rail,
};
use archard_rail::wear::{COLUMNS, CONICITY, Kept, Pass, Step};

use crate::arguments::Run;
use crate::failure::Failure;
use crate::interrupt::Watch;
use crate::number::four;
use crate::progress::Follower;
use crate::say::say;
use crate::underway::solved;
use crate::verdict;

/// Finds the contacts, and what wears over the route, and writes them into the folder that is held. A route is kept there on its way.
pub fn run(
    resolved: &ResolvedWheelRail,
    watch: &Watch,
    follower: &mut Follower,
    arguments: &Run,
) -> Result<(), Failure> {
    let ResolvedWheelRail { case, warnings, .. } = resolved;
    let [quiet, verbose] = [arguments.quiet, arguments.verbose];
    let wrong = |error: &dyn std::error::Error| Failure::wrong(error.to_string());
    let start = Instant::now();
    let prepared = case.prepare().map_err(|problem| Failure::wrong(problem.title()))?;
    let mut keeper = RouteKeeper::new(case.to_string(), &prepared.computed_from());
    let mut kept = Kept::default();
    if arguments.resume.is_some() {
        let find = |claim: &mut Claim| keeper.find(claim).map(|found| kept = found);
        watch.within(find).map_err(|error| wrong(&error))?;
    }
    let mut unkept = None;
    let follow = |pass: Pass, step: &Step<'_>| {
        follow(follower, pass, step);
        // Before the first step there is nothing to keep.
        if pass == Pass::Hasty && step.progress == 0.0 {
            return ControlFlow::Continue(());
        }
        match watch.within(|claim| keeper.keep(claim, step.kept)) {
            Ok(()) => ControlFlow::Continue(()),
            Err(error) => {
                unkept = Some(error);
                ControlFlow::Break(())
            }
        }
    };
    let results = prepared.go_on(kept, follow);
    if let Some(error) = unkept {
        return Err(wrong(&error));
    }
    let results = results.map_err(|error| wrong(&error))?;
    let totals = solved(start, warnings);
    let Some(mut claim) = watch.release() else {
        return Err(Failure::wrong("the run has no folder"));
    };
    let judged = write_rail(&mut claim, &case.to_string(), &results, &totals)
        .map_err(|error| wrong(&error))?;
    if !quiet {
        follower.end();
        if let Some(history) = &results.history {
            let points = history.rows.first().map_or(0, |(_, values)| values.len());
            let RailHistory { steps, loss, .. } = history;
            say(&format!(
                "history           {steps} steps, {points} points (gathered.csv) that lose {} %",
                four(100.0 * loss)
            ))?;
        }
        match &results.wear {
            None => results.contacts.iter().try_for_each(summarize)?,
            Some(wear) => summarize_wear(wear)?,
        }
        say(&format!("time              {:.2} s", totals.seconds))?;
        say(&format!("results           {}", claim.dir().display()))?;
        say(&format!("verdict           {}", verdict::headline(&judged)))?;
        verdict::say_lines(&judged, verbose)?;
    }
    verdict::judge(&judged, claim.dir(), quiet)
}

/// Shows how the route gets on. The three times that it is gone through take about as long on a quarter of the elements each, and
/// then on all.
fn follow(follower: &mut Follower, pass: Pass, step: &Step<'_>) {
    let (before, part, what) = match pass {
        Pass::Hasty => (0.0, 1.0, "longer steps on half of the elements"),
        Pass::Coarse => (1.0, 2.0, "half of the elements"),
        Pass::Fine => (3.0, 4.0, "the route"),
    };
    let deepest = step.worn.iter().flat_map(|worn| [&worn.wheel, &worn.rail]);
    let deepest = deepest.flat_map(|profile| profile.depths()).fold(0.0, f64::max);
    let standing = [what.to_owned(), format!("depth {} um", four(1e6 * deepest))];
    follower.show((before + part * step.progress) / 7.0, &standing);
}

/// Says what was worn off.
fn summarize_wear(wear: &RailWear) -> Result<(), Failure> {
    let course = wear.travelled.course();
    let sides = wear.travelled.worn.len();
    for (told, errors) in &course[course.len() - sides..] {
        let [distance, axles] = wear.extent;
        let after = [(1e-3 * distance, "km"), (axles, "axles")].into_iter();
        let after = after.filter(|(extent, _)| *extent > 0.0);
        let after: Vec<_> = after.map(|(extent, unit)| format!("{extent} {unit}")).collect();
        say(&format!("{} side, after {}", told.side.name(), after.join(" and ")))?;
        for (name, (value, error)) in COLUMNS.iter().zip(told.values.iter().zip(errors)) {
            let own = if name.starts_with("rail") { wear.wears[1] } else { wear.wears[0] };
            // The conicity is that of both.
            if !own || value.is_nan() || *name == CONICITY {
                continue;
            }
            // Flanges are judged by hundredths of a millimetre.
            if name.ends_with("damage") {
                let words = name.replace('_', " ");
                say(&format!("  {words:<19}{}  +- {}", four(*value), four(*error)))?;
                continue;
            }
            let (value, unit) = match name.rsplit_once('_') {
                Some((_, "m3")) => (four(1e9 * value), "mm^3"),
                Some((_, "m2")) => (four(1e6 * value), "mm^2"),
                _ => (format!("{:.4}", 1e3 * value), "mm"),
            };
            let factor = match unit {
                "mm^3" => 1e9,
                "mm^2" => 1e6,
                _ => 1e3,
            };
            let words = name.rsplit_once('_').map_or(*name, |(words, _)| words).replace('_', " ");
            let error = four(factor * error);
            say(&format!("  {words:<19}{value} {unit}  +- {error}"))?;
        }
    }
    for RailLife { limit, side, at } in &wear.lives {
        let words = limit.column.strip_suffix("_m").unwrap_or(limit.column).replace('_', " ");
        let bound = if limit.column.ends_with("_m") {
            format!("{} mm", four(1e3 * limit.value))
        } else {
            four(limit.value)
        };
        let what = format!("{} wheel: {words} of {bound}", side.name());
        let km = |share: f64| four(1e-3 * share * wear.extent[0]);
        match at {
            Some([share, error]) => {
                say(&format!(
                    "limit             {what} after {} km  +- {}",
                    km(*share),
                    km(*error)
                ))?;
            }
            None => say(&format!("limit             {what} not within {} km", km(1.0)))?,
        }
    }
    wear.plans.iter().try_for_each(|plan| say_plan(plan, wear.extent[0]))?;
    wear.economies.iter().try_for_each(|economy| say_economy(economy, wear.extent[0]))?;
    if let [Some(new), Some(worn), error] = wear.conicity {
        let error = error.map_or_else(String::new, |error| format!("  +- {}", four(error)));
        say(&format!("conicity          {} new, {} worn{error}", four(new), four(worn)))?;
    }
    Ok(())
}

/// Says how often a wheel is turned over a distance (m), and how far it runs in all.
fn say_plan(RailPlan { side, when, plan }: &RailPlan, distance: f64) -> Result<(), Failure> {
    let km = |share: [f64; 2]| {
        let [value, error] = share.map(|share| four(1e-3 * share * distance));
        format!("{value} km +- {error}")
    };
    let why = match *when {
        "limit" => "at its first limit",
        "end" => "at the end",
        _ => "where it costs least",
    };
    let Some(plan) = plan else {
        let side = side.name();
        return say(&format!("turning           {side} wheel, {why}: it does not last till then"));
    };
    let [depth, error] = plan.depth.map(|depth| four(1e3 * depth));
    say(&format!(
        "turning           {} wheel, {why}: each {}, {depth} mm +- {error} off the radius, {} times, in all {}",
        side.name(),
        km(plan.interval),
        plan.turnings,
        km(plan.life)
    ))
}

/// Says how far a wheel runs over a distance (m) that is turned to thinner flanges.
fn say_economy(RailEconomy { side, economy }: &RailEconomy, distance: f64) -> Result<(), Failure> {
    let side = side.name();
    let Some(economy) = economy else {
        return say(&format!(
            "thinner flanges   {side} wheel: it does not last till it may be turned"
        ));
    };
    let thin = economy.turnings.iter().map(|own| own.thickness).reduce(f64::min);
    let thin = thin.map_or_else(String::new, |thin| format!(" down to {} mm", four(1e3 * thin)));
    let km = |[life, error]: [f64; 2]| {
        let [life, error] = [life, error].map(|share| four(1e-3 * share * distance));
        format!("{life} km +- {error}")
    };
    say(&format!(
        "thinner flanges   {side} wheel{thin}: turned {} times, in all {}; with the whole flange each time {}",
        economy.turnings.len(),
        km(economy.life),
        km(economy.full)
    ))
}

/// Says what came out on a side.
fn summarize(contact: &RailContact) -> Result<(), Failure> {
    for (index, patch) in contact.patches.iter().enumerate() {
        let (one, error) = (&patch.values, &patch.errors);
        let line = |name: &str, value: f64, off: f64, factor: f64, unit: &str| {
            let (value, off) = (four(factor * value), four(factor * off));
            say(&format!("  {name:<16}{value} {unit}  +- {off}"))
        };
        let at = contact.at.map_or_else(String::new, |at| format!("point {}, ", at.point));
        say(&format!("{at}{} wheel, patch {}", contact.side.name(), index + 1))?;
        line("y on the rail", one.y_rail, error.y_rail, 1e3, "mm")?;
        line("y on the wheel", one.y_wheel, error.y_wheel, 1e3, "mm")?;
        line("contact angle", one.contact_angle, error.contact_angle, 1.0, "rad")?;
        line("normal force", one.normal_force, error.normal_force, 1e-3, "kN")?;
        line("force along x", one.force_x, error.force_x, 1e-3, "kN")?;
        line("force across", one.force_s, error.force_s, 1e-3, "kN")?;
        line("peak pressure", one.peak_pressure, error.peak_pressure, 1e-6, "MPa")?;
        line("contact area", one.contact_area, error.contact_area, 1e6, "mm^2")?;
    }
    Ok(())
}
