//! Wheels in service: limits, turning, and cracks that compete with wear.

use std::ops::ControlFlow;

use super::routes::{WEARS, with_route};
use super::{MANCHESTER, resolve};

/// A wheel that is sent over the distance of its life has just the depth of its limit, to the errors that are stated; limits that are not
/// reached say so, and those of a standard follow from the diameter.
#[test]
#[ignore = "long: in .ci/long"]
fn a_wheel_sent_over_its_life_is_at_its_limit() {
    let route = "share,shift [mm]\n0.6,3\n0.4,0\n";
    let worn = |distance: f64, until: &[&str]| {
        let distance = format!("motion.wheel_rail.distance={distance} m");
        let case = with_route(route, &[&[WEARS, &*distance], until].concat()).expect("a case").case;
        case.solve(|_, _| ControlFlow::Continue(())).expect("wear").wear.expect("wear")
    };
    let depth = |wear: &archard_case::output::RailWear| {
        let (_, last) = wear.rows().pop().unwrap();
        let of = |name: &str| last.iter().find(|(own, _)| own == name).unwrap().1;
        [of("tread_depth_m"), of("error_of_tread_depth_m")]
    };
    let options = [
        WEARS,
        "motion.wheel_rail.distance=1 m",
        "until.standard=EN 15313",
        "until.tread_depth=3 mm",
    ];
    let case = resolve(MANCHESTER, &options).expect("a case").case;
    let again = resolve(&case.to_string(), &[]).expect("what was printed").case;
    assert_eq!(again, case);
    let far = 4e6;
    let [whole, _] = depth(&worn(far, &[]));
    assert!(whole > 1e-6, "{whole}");
    let until = format!("until.tread_depth={} m", 0.5 * whole);
    let wear = worn(far, &[&until, "until.standard=EN 15313"]);
    let [first, others @ ..] = &wear.lives[..] else { panic!("no lives") };
    assert_eq!((first.limit.column, others.len()), ("tread_depth_m", 3));
    assert!(others.iter().all(|life| life.at.is_none()));
    let [share, error] = first.at.expect("a life");
    assert!(error < 0.1 * share, "{share} {error}");
    let there = worn(share * far, &[]);
    let [depth, off] = depth(&there);
    let slope = whole / far;
    assert!(
        (depth - 0.5 * whole).abs() <= off + slope * error * far,
        "{depth} {whole} {off} {error}"
    );
    let sd = |diameter: f64| archard_rail::wear::Limit::in_service(diameter).map(|one| one.value);
    assert_eq!((sd(0.92), sd(0.76)), ([22e-3, 36e-3, 6.5e-3], [27.5e-3, 36e-3, 6.5e-3]));
}

/// The conicity is told after each step where it has a limit: at first it is that of new wheels.
#[test]
fn a_conicity_may_have_a_limit() {
    let options = [WEARS, "motion.wheel_rail.distance=1 m", "frame.elements=16"];
    let rows = |until: &[&str]| {
        let case = resolve(MANCHESTER, &[&options[..], until].concat()).expect("a case").case;
        let wear = case.solve(|_, _| ControlFlow::Continue(())).expect("wear").wear.expect("wear");
        let told = |row: &[(String, f64)]| {
            row.iter().find(|(own, _)| own == "equivalent_conicity").map(|(_, value)| *value)
        };
        let told: Vec<_> = wear.rows().iter().map(|(_, row)| told(row)).collect();
        (told, wear.conicity[0].unwrap(), wear.lives)
    };
    assert!(rows(&[]).0.iter().all(Option::is_none));
    let (told, new, lives) = rows(&["until.equivalent_conicity=0.01"]);
    assert!(told.iter().all(|one| (one.unwrap() / new - 1.0).abs() < 1e-3), "{told:?} {new}");
    assert_eq!(lives[0].at.map(|[share, _]| share), Some(0.0));
}

#[test]
fn wrong_limits_are_refused_in_words() {
    let far = "motion.wheel_rail.distance=10 m";
    for (options, expected) in [
        (vec!["until.standard=EN 15313"], "no wear law"),
        (vec![WEARS, far, "until.flange_thickness=33 mm"], "the new wheel has 32.50 mm"),
        (vec![WEARS, far, "until.flange_height=20"], "unit"),
        (vec![WEARS, far, "until.flange=20 mm"], "is not a known key"),
        (vec![WEARS, far, "until.standard=UIC 1"], "EN 15313"),
    ] {
        let said = resolve(MANCHESTER, &options).err();
        let said = said.unwrap_or_else(|| panic!("{options:?} passes"));
        assert!(said.contains(expected) && said.contains("until"), "{options:?}: {said}");
    }
}

/// A wheel is turned at its first limit: what that costs of the radius is that of the wheel which runs so far, and all runs together are
/// those of its radii. A wheel without limits is turned at the end.
#[test]
#[ignore = "long: in .ci/long"]
fn a_wheel_is_turned_again() {
    let route = "share,shift [mm]\n0.6,3\n0.4,0\n";
    let worn = |distance: f64, options: &[&str]| {
        let distance = format!("motion.wheel_rail.distance={distance} m");
        let turned = [WEARS, &*distance, "reprofiling.last_radius=459 mm"];
        let case = with_route(route, &[&turned[..], options].concat()).expect("a case").case;
        let again = resolve(&case.to_string(), &["motion.wheel_rail.route="]);
        assert_eq!(again.expect("what was printed").case.reprofiling, case.reprofiling);
        case.solve(|_, _| ControlFlow::Continue(())).expect("wear").wear.expect("wear")
    };
    let depth = |wear: &archard_case::output::RailWear| {
        let (_, last) = wear.rows().pop().unwrap();
        let of = |name: &str| last.iter().find(|(own, _)| own == name).unwrap().1;
        [of("turning_depth_m"), of("error_of_turning_depth_m"), of("wheel_depth_m")]
    };
    let far = 4e6;
    let whole = worn(far, &[]);
    let [cut, _, deepest] = depth(&whole);
    // The new profile lies below the deepest wear, and no flank of this wear is steep.
    assert!((deepest..3.0 * deepest).contains(&cut), "{cut} {deepest}");
    let [end, cheapest] = &whole.plans[..] else { panic!("{:?}", whole.plans) };
    let plan = end.plan.expect("a plan");
    assert_eq!((end.when, cheapest.when, plan.interval), ("end", "cheapest", [1.0, 0.0]));
    assert_eq!(plan.depth[0], cut);
    assert!((1e-3 / cut - plan.turnings as f64) < 1.5, "{plan:?}");
    assert!(worn(far, &["reprofiling.last_radius=459.9999 mm"]).plans[0].plan.is_none());
    let until = format!("until.turning_depth={} m", 0.5 * cut);
    let limited = worn(far, &[&until, "reprofiling.allowance=0.1 mm"]);
    let [limit, cheapest] = &limited.plans[..] else { panic!("{:?}", limited.plans) };
    assert_eq!(limit.when, "limit");
    let [limit, cheapest] = [limit, cheapest].map(|one| one.plan.expect("a plan"));
    assert_eq!(cheapest.interval[1], 0.0);
    assert!((limit.depth[0] - 0.5 * cut - 1e-4).abs() < 1e-12, "{:?}", limit);
    let runs = (0..=limit.turnings).map(|turned| 1.0 - turned as f64 * limit.depth[0] / 0.46);
    let all = limit.interval[0] * runs.sum::<f64>();
    assert!((limit.life[0] / all - 1.0).abs() < 1e-12);
    assert!(
        cheapest.depth[0] / cheapest.interval[0]
            <= limit.depth[0] / limit.interval[0] * (1.0 + 1e-12)
    );
    let share = limit.interval[0];
    let [there, off, _] = depth(&worn(share * far, &[]));
    assert!((there - 0.5 * cut).abs() <= off + cut * limit.interval[1], "{there} {cut} {off}");
}

/// Damage by cracks is a limit like any other, and has its columns along the profile and over the route.
#[test]
#[ignore = "long: in .ci/long"]
fn a_wheel_may_crack_before_it_is_worn() {
    let options = [
        WEARS,
        "motion.wheel_rail.distance=2000 km",
        "frame.elements=16",
        "body.wheel.cracks.t_gamma.threshold=0.001 N",
        "until.crack_damage=0.05",
        "until.tread_depth=10 mm",
    ];
    let case = resolve(MANCHESTER, &options).expect("a case").case;
    let again = resolve(&case.to_string(), &[]).expect("what was printed").case;
    assert_eq!(again, case);
    let results = case.solve(|_, _| ControlFlow::Continue(())).expect("wear");
    let work = results.contacts[0].patches[0].values.t_gamma;
    let wear = results.wear.expect("wear");
    let [first, _] = &wear.lives[..] else { panic!("{:?}", wear.lives) };
    let [share, error] = first.at.expect("it cracks");
    assert_eq!(first.limit.column, "wheel_crack_damage");
    // One passage a turn of the wheel, on new profiles.
    let passages = 0.05 / (1e-5 * (work - 0.001) / (65.0 - 0.001));
    let metres = passages * std::f64::consts::TAU * 0.46;
    assert!((share * 2e6 / metres - 1.0).abs() < 0.05 + error / share, "{share} {error} {metres}");
    let profile = &wear.profile_wear()[0];
    let column = |name: &str| &profile.columns.iter().find(|(own, _)| *own == name).unwrap().1;
    let most = column("crack_damage").iter().copied().fold(0.0, f64::max);
    let (_, last) = wear.rows().pop().unwrap();
    let told = last.iter().find(|(own, _)| own == "wheel_crack_damage").unwrap().1;
    assert_eq!(most, told);
}

#[test]
fn wrong_cracks_and_turnings_are_refused_in_words() {
    let far = "motion.wheel_rail.distance=10 m";
    let peak = "body.wheel.cracks.t_gamma.peak=10 N";
    for (options, expected) in [
        (vec!["body.rail.cracks.t_gamma={}"], ["body.rail.cracks", "give the body a wear law"]),
        (
            vec![WEARS, far, peak],
            ["cracks.t_gamma.peak", "the work rises from the threshold, 15 N"],
        ),
        (vec![WEARS, far, "body.wheel.cracks={}"], ["body.wheel.cracks", "names no model"]),
        (
            vec![WEARS, far, "until.crack_damage=1"],
            ["until.crack_damage", "has no model of cracks"],
        ),
        (vec!["reprofiling.last_radius=430 mm"], ["reprofiling", "nothing is turned"]),
        (vec![WEARS, far, "reprofiling.last_radius=460 mm"], ["last_radius", "is not below"]),
        (vec![WEARS, far, "reprofiling.allowance=1 mm"], ["last_radius", "is missing"]),
        (vec![WEARS, far, "reprofiling.last_radius=430"], ["last_radius", "unit"]),
    ] {
        let said = resolve(MANCHESTER, &options).err();
        let said = said.unwrap_or_else(|| panic!("{options:?} passes"));
        assert!(expected.iter().all(|one| said.contains(one)), "{options:?}: {said}");
    }
}

/// A flange has a wear law of its own where it is said where it begins; laws that ask for temperature need to know of the heat of
/// both bodies.
#[test]
fn a_flange_may_wear_by_its_own_law() {
    let far = "motion.wheel_rail.distance=10 m";
    let own = "body.wheel.flange_wear.archard.coefficient=2e-13 1/Pa";
    let from = "motion.wheel_rail.flange_from=-26 mm";
    let case = resolve(MANCHESTER, &[WEARS, far, own, from]).expect("a case").case;
    let again = resolve(&case.to_string(), &[]).expect("what was printed").case;
    assert_eq!(again, case);
    let remembers = [
        "body.wheel.wear.running_in.initial_coefficient=1e-13 1/Pa",
        "body.wheel.wear.running_in.final_coefficient=1e-14 1/Pa",
        "body.wheel.wear.running_in.running_in_distance=1 m",
        far,
    ];
    resolve(MANCHESTER, &remembers).expect("a law of the distance slid");
    let warm = [
        "body.wheel.wear.expression.depth=k * p * s * temperature / t",
        "body.wheel.wear.expression.k=1e-13 1/Pa",
        "body.wheel.wear.expression.t=300 K",
        far,
    ];
    let heats = [
        "body.wheel.thermal.conductivity=50 W/(m K)",
        "body.wheel.thermal.diffusivity=13 mm^2/s",
        "body.wheel.thermal.temperature=20 degC",
        "body.rail.thermal.conductivity=50 W/(m K)",
        "body.rail.thermal.diffusivity=13 mm^2/s",
        "body.rail.thermal.temperature=20 degC",
    ];
    let case = resolve(MANCHESTER, &[&warm[..], &heats[..]].concat()).expect("a warm case").case;
    assert_eq!(resolve(&case.to_string(), &[]).expect("what was printed").case, case);
    let rail = "body.rail.flange_wear.archard.coefficient=2e-13 1/Pa";
    for (options, expected) in [
        (vec![WEARS, far, own], ["motion.wheel_rail.flange_from", "where the flange begins"]),
        (vec![WEARS, far, from], ["motion.wheel_rail.flange_from", "counts for nothing"]),
        (vec![own, from], ["body.wheel.flange_wear", "has no `wear`"]),
        (vec![WEARS, far, rail, from], ["body.rail.flange_wear", "has no `wear`"]),
        (warm.to_vec(), ["body.wheel.thermal", "share that of friction"]),
        ([&warm[..], &heats[..3]].concat(), ["body.rail.thermal", "share that of friction"]),
        (
            [&warm[..], &heats[..], &["body.rail.thermal.share=0.5"]].concat(),
            ["body.rail.thermal.share", "follows from"],
        ),
        (
            [&warm[..], &heats[..2], &heats[3..5]].concat(),
            ["body.wheel.thermal.temperature", "away from the contact"],
        ),
    ] {
        let said = resolve(MANCHESTER, &options).err();
        let said = said.unwrap_or_else(|| panic!("{options:?} passes"));
        assert!(expected.iter().all(|one| said.contains(one)), "{options:?}: {said}");
    }
}

/// A wheel that may be turned to thinner flanges runs as far as one that may not, or farther, on the radius that it has.
#[test]
#[ignore = "long: in .ci/long"]
fn a_wheel_may_be_turned_to_thinner_flanges() {
    let route = "share,shift [mm]\n0.6,0\n0.4,4.6\n";
    let usual = [
        WEARS,
        "motion.wheel_rail.distance=4000 km",
        "reprofiling.last_radius=455 mm",
        "reprofiling.allowance=0.1 mm",
        "reprofiling.thinnest_flange=31 mm",
        "until.standard=EN 15313",
    ];
    let case = with_route(route, &usual).expect("a case").case;
    let again = resolve(&case.to_string(), &["motion.wheel_rail.route="]);
    assert_eq!(again.expect("what was printed").case.reprofiling, case.reprofiling);
    let results = case.solve(|_, _| ControlFlow::Continue(())).expect("wear");
    let wear = results.wear.expect("wear");
    let economy = wear.economies[0].economy.as_ref().expect("a life");
    eprintln!("{economy:?}");
    assert!(economy.life[0] >= economy.full[0] && economy.full[0] > 0.0, "{economy:?}");
    let cut: f64 = economy.turnings.iter().map(|own| own.depth).sum();
    assert!(!economy.turnings.is_empty() && cut < 5e-3, "{economy:?}");
    assert!(economy.turnings.iter().all(|own| (31e-3..33e-3).contains(&own.thickness)));
    // Runs by themselves, on radii as they are left, and a last one that is no longer than the whole distance.
    let (mut radius, mut runs) = (0.46, 0.0);
    for turned in &economy.turnings {
        runs += turned.interval * radius / 0.46;
        radius -= turned.depth;
    }
    assert!((runs..=runs + 1.0).contains(&economy.life[0]), "{runs} {economy:?}");
    for (options, expected) in [
        (vec!["reprofiling.thinnest_flange=34 mm"], "has to lie between"),
        (vec!["reprofiling.thinnest_flange=20 mm"], "has to lie between"),
        (vec!["reprofiling.flange_step=1 um"], "thicknesses"),
    ] {
        let said = with_route(route, &[&usual[..], &options].concat()).err();
        let said = said.unwrap_or_else(|| panic!("{options:?} passes"));
        assert!(said.contains(expected) && said.contains("reprofiling"), "{options:?}: {said}");
    }
}
