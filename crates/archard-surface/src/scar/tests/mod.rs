//! Profiles with a known scar: found where it is, within the intervals, or refused.

mod made;

use super::{Estimate, NoScar, Scar, Shape, depth_and_width};
use made::{KINDS, Kind, Made, computed, made, nominal, ring};

fn found(own: &Made) -> Result<Scar, NoScar> {
    Scar::find(&own.readings, &nominal(own.kind), &computed())
}

/// How often intervals held, of so many that were accepted.
#[derive(Debug, Default, Clone, Copy)]
struct Covered {
    accepted: usize,
    refused: usize,
    place: usize,
    grown: usize,
    section: usize,
    depth: usize,
    /// Sums of squares of the errors over standard uncertainties, and of relative errors, of the section.
    squares: [f64; 2],
    worst: f64,
}

fn covered(kind: Kind, seeds: std::ops::Range<u64>) -> Covered {
    let mut all = Covered::default();
    let holds = |own: Estimate, truth: f64| usize::from((own.value - truth).abs() <= own.expanded);
    for seed in seeds {
        let own = made(kind, seed);
        let scar = match found(&own) {
            Ok(scar) => scar,
            Err(why) => {
                println!("{kind:?} {seed}: {why}");
                all.refused += 1;
                continue;
            }
        };
        all.accepted += 1;
        all.place += holds(scar.place, own.shift);
        all.grown += holds(scar.grown, own.grown);
        all.section += holds(scar.section, own.section);
        let error = scar.section.value - own.section;
        all.squares[0] += (error / scar.section.standard).powi(2);
        all.squares[1] += (error / own.section).powi(2);
        all.worst = all.worst.max((error / own.section).abs());
        all.depth += usize::from(scar.depth.is_some());
    }
    all
}

fn table(seeds: u64) -> Vec<(Kind, Covered)> {
    println!("kind         refused  place  grown  section  rms z  rms %  worst %");
    KINDS
        .map(|kind| {
            let own = covered(kind, 0..seeds);
            let share = |count: usize| 100.0 * count as f64 / own.accepted.max(1) as f64;
            let rms = own.squares.map(|sum| (sum / own.accepted.max(1) as f64).sqrt());
            println!(
                "{:<12} {:>7} {:>5.0}% {:>5.0}% {:>7.0}% {:>6.2} {:>6.2} {:>8.2}",
                format!("{kind:?}"),
                own.refused,
                share(own.place),
                share(own.grown),
                share(own.section),
                rms[0],
                100.0 * rms[1],
                100.0 * own.worst
            );
            (kind, own)
        })
        .to_vec()
}

/// Of five profiles a kind nearly all are accepted, and 95 % intervals hold: four in 30 do not once in 16 times.
#[test]
fn sections_lie_within_their_intervals() {
    let all = table(5);
    let sum = |of: &dyn Fn(&Covered) -> usize| all.iter().map(|own| of(&own.1)).sum::<usize>();
    let accepted = sum(&|own| own.accepted);
    assert!(accepted >= 25 && sum(&|own| own.section) + 3 >= accepted, "{all:?}");
    assert!(sum(&|own| own.place) + 4 >= accepted && sum(&|own| own.depth) == accepted, "{all:?}");
}

/// `ARCHARD_SEEDS` says how many profiles of each kind, 100 if it does not.
#[test]
#[ignore = "takes minutes: 100 profiles of each kind"]
fn sections_of_each_kind_lie_within_their_intervals() {
    let seeds = std::env::var("ARCHARD_SEEDS").ok().and_then(|seeds| seeds.parse().ok());
    for (kind, own) in table(seeds.unwrap_or(100)) {
        assert!(own.section as f64 > 0.85 * own.accepted as f64, "{kind:?}: {own:?}");
        assert!(own.accepted > 2 * own.refused, "{kind:?}: {own:?}");
    }
}

/// Where nothing lies next to the scar, or on one side of it alone, its level is not told: most are refused.
#[test]
fn what_has_no_flat_is_refused() {
    for kind in [Kind::NoFlat, Kind::OneSide] {
        let refused = (0..5).filter(|&seed| found(&made(kind, seed)).is_err()).count();
        assert!(refused >= 4, "{kind:?}: {refused} of 5");
    }
}

/// A profile upside down, a plane, places in another unit, a few readings: no scar.
#[test]
fn what_is_no_scar_is_refused() {
    let changed = |change: &dyn Fn(&mut [f64; 2])| {
        let mut own = made(Kind::Plain, 1);
        own.readings.iter_mut().for_each(change);
        found(&own).unwrap_err()
    };
    let upside_down = changed(&|own| own[1] *= -1.0);
    assert!(!matches!(upside_down, NoScar::Few { .. }), "{upside_down}");
    assert_eq!(changed(&|own| own[1] = 1e-7 * (1e5 * own[0]).sin()), NoScar::Nothing);
    assert_eq!(changed(&|own| own[0] *= 1e-3), NoScar::Nothing);
    let mut few = made(Kind::Plain, 1);
    few.readings.truncate(12);
    assert_eq!(found(&few).unwrap_err(), NoScar::Few { readings: 12, least: 18 });
}

/// Five to thirty blocks across, and next to no noise and misfit: the model fills what lies between them.
#[test]
fn few_readings_across_a_scar_tell_its_section() {
    let width = (12.0 * 20e-3 * made::SECTION).cbrt();
    for across in [5.0, 8.0, 30.0] {
        let step = width / across;
        let count = (2.2 * across) as i32;
        for phase in 0..5 {
            let shift = 0.2 * step * f64::from(phase);
            let place = |i: i32| step * f64::from(i);
            let wave = |i: i32| 1e-8 * f64::from(i * 7 % 5);
            let readings: Vec<[f64; 2]> = (-count..=count)
                .map(|i| {
                    [place(i), 3e-3 * place(i) - ring(place(i) - shift, made::SECTION) + wave(i)]
                })
                .collect();
            let scar = Scar::find(&readings, &|_| 0.0, &computed()).unwrap();
            let off = scar.section.value - made::SECTION;
            assert!(
                off.abs() < scar.section.expanded.max(2e-3 * made::SECTION),
                "{across} {phase}: {scar:?}"
            );
            assert!(scar.section.standard < 0.02 * made::SECTION, "{across} {phase}: {scar:?}");
        }
    }
}

/// Holes in the scar are filled by the model, as far as they are a fifth of it, and make it uncertain.
#[test]
fn holes_in_a_scar_make_its_section_uncertain() {
    for (from, to, least) in [(-0.2, 0.0, 0.004), (0.6, 0.8, 0.001)] {
        let mut own = made(Kind::Plain, 4);
        let whole = found(&own).unwrap();
        let half = 0.5 * (whole.extent[1] - whole.extent[0]);
        let within = |reading: &[f64; 2]| {
            let place = (reading[0] - own.shift) / half;
            from < place && place < to
        };
        own.readings.retain(|reading| !within(reading));
        let scar = found(&own).unwrap();
        assert!((scar.section.value - own.section).abs() < scar.section.expanded, "{scar:?}");
        assert!(scar.section.standard > least * own.section && scar.unseen > 0.0, "{scar:?}");
    }
    let mut own = made(Kind::Plain, 4);
    own.readings.retain(|reading| (reading[0] - own.shift).abs() > 0.3e-3);
    assert!(matches!(found(&own), Err(NoScar::Unseen { .. })), "{:?}", found(&own));
}

/// Heights in steps and no noise: all of them may be rounded together.
#[test]
fn rounded_heights_are_as_uncertain_as_their_step() {
    let width = (12.0 * 20e-3 * made::SECTION).cbrt();
    for (at, step) in [0.5e-6, 1e-6, 2e-6].into_iter().enumerate() {
        let height = |x: f64| 0.3e-6 * at as f64 - ring(x - 0.1e-3, made::SECTION);
        let readings: Vec<[f64; 2]> = (-400..=400)
            .map(|i| 5e-6 * f64::from(i))
            .map(|x| [x, step * (height(x) / step).round()])
            .collect();
        let scar = Scar::find(&readings, &|_| 0.0, &computed()).unwrap();
        let off = scar.section.value - made::SECTION;
        assert!(off.abs() < scar.section.expanded, "{step}: {off} {scar:?}");
        assert!(scar.section.standard < step * width, "{step}: {scar:?}");
    }
}

/// Heights in steps as large as the scar is deep, and larger, show none; in those of half of it the section lies in its interval.
#[test]
fn heights_coarser_than_the_scar_are_refused() {
    for step in [20e-6, 60e-6, 100e-6, 1e-3] {
        let mut own = made(Kind::Plain, 2);
        own.readings.iter_mut().for_each(|reading| reading[1] = step * (reading[1] / step).round());
        match found(&own) {
            Ok(scar) => {
                let off = (scar.section.value - own.section).abs();
                assert!(step < 40e-6 && off < scar.section.expanded, "{step}: {scar:?}");
            }
            Err(why) => {
                // Of heights that are all the same the scar lies where nothing was measured.
                let refused =
                    matches!(why, NoScar::Hidden { .. } | NoScar::Nothing | NoScar::Unseen { .. });
                assert!(refused, "{step}: {why}")
            }
        }
    }
    // A contact whose width stays, worn a thousandth as deep as it is computed.
    let places: Vec<f64> = (-100..=100).map(|i| 1e-5 * f64::from(i)).collect();
    let deep: Vec<f64> = places.iter().map(|x| if x.abs() < 0.5e-3 { 1e-4 } else { 0.0 }).collect();
    let shape = Shape::new(places.clone(), deep.clone(), 1.0).unwrap();
    let mut random = fastrand::Rng::with_seed(9);
    let readings = places.iter().zip(&deep).map(|(x, z)| [*x, -1e-4 * z + 1e-9 * random.f64()]);
    let refused = Scar::find(&readings.collect::<Vec<_>>(), &|_| 0.0, &shape);
    assert!(refused.is_err(), "{refused:?}");
}

/// A shape of a run that has gone a thirtieth or thirty times as far says how far it should have gone.
#[test]
fn a_shape_of_another_size_is_refused() {
    let own = made(Kind::Plain, 1);
    for factor in [1.0 / 30.0, 30.0] {
        let places: Vec<f64> = (-400..=400).map(|i| 1e-5 * f64::from(i)).collect();
        let worn = places.iter().map(|x| ring(*x, made::SECTION * factor)).collect();
        let shape = Shape::new(places, worn, 2.0 / 3.0).unwrap();
        let refused = Scar::find(&own.readings, &nominal(own.kind), &shape).unwrap_err();
        let NoScar::OtherSize { grown } = refused else { panic!("{refused}") };
        assert!((grown * factor / own.grown - 1.0).abs() < 0.1, "{grown} {factor}");
    }
}

/// Depth and width of a computed ring: those of its parabola, the width at 95 % of the half squared.
#[test]
fn a_shape_has_the_depth_and_width_of_a_parabola() {
    let [depth, width] = depth_and_width(&computed()).unwrap();
    let chord = (12.0 * 20e-3 * made::SECTION).cbrt();
    assert!((depth / ring(0.0, made::SECTION) - 1.0).abs() < 1e-3, "{depth}");
    assert!((width / (0.95f64.sqrt() * chord) - 1.0).abs() < 3e-3, "{width}");
}

/// The computed section itself, tilted on a ball: exact readings.
#[test]
fn exact_readings_are_the_shape() {
    let half = 0.45e-3;
    let worn = |x: f64| 2.06e-6 * (1.0 - (x / half).powi(2)).max(0.0);
    let ball = |x: f64| -x * x / 0.1;
    let places: Vec<f64> = (-32..=32).map(|i| 0.6e-3 * f64::from(i) / 32.0).collect();
    let shape =
        Shape::new(places.clone(), places.iter().map(|x| worn(*x)).collect(), 2.0 / 3.0).unwrap();
    let readings: Vec<[f64; 2]> = (-150..=150)
        .map(|i| 8e-6 * f64::from(i))
        .map(|x| [x + 0.4e-3, 30e-6 + ball(x) - shape.worn(x, 1.0) + 2e-3 * (x + 0.4e-3)])
        .collect();
    let scar = Scar::find(&readings, &ball, &shape).unwrap();
    assert!((scar.place.value - 0.4e-3).abs() < 1e-6, "{scar:?}");
    let [depth, width] = depth_and_width(&shape).unwrap();
    assert!((scar.depth.unwrap().value / depth - 1.0).abs() < 2e-3, "{scar:?} {depth}");
    assert!((scar.width.unwrap().value / width - 1.0).abs() < 2e-3, "{scar:?} {width}");
    assert!((width / (0.95f64.sqrt() * 2.0 * half) - 1.0).abs() < 5e-3, "{width}");
    assert!((scar.section.value / shape.section(1.0) - 1.0).abs() < 1e-3, "{scar:?}");
}

/// Whatever the readings are, there is a scar whose numbers are finite, or a reason.
#[test]
fn any_readings_have_an_answer() {
    let mut random = fastrand::Rng::with_seed(12);
    for round in 0..60 {
        let count = [3, 19, 60, 300][random.usize(0..4)];
        let scale = 10f64.powi(random.i32(-12..3));
        let step = 10f64.powi(random.i32(-9..0));
        let kind = random.usize(0..6);
        let mut reading = |i: usize| {
            let x = step * i as f64;
            let z = match kind {
                0 => 0.0,
                1 => scale * f64::from(u8::from(i.is_multiple_of(2))),
                2 => scale * random.f64(),
                3 => scale * (i as f64).powi(3),
                4 => -ring(x - 0.5 * step * count as f64, made::SECTION) + scale * random.f64(),
                _ => [f64::NAN, f64::INFINITY, scale, 0.0][random.usize(0..4)],
            };
            [if random.u8(0..9) == 0 { 0.0 } else { x }, z]
        };
        let readings: Vec<[f64; 2]> = (0..count).map(&mut reading).collect();
        if let Ok(scar) = Scar::find(&readings, &|_| 0.0, &computed()) {
            let all = [scar.section, scar.place, scar.grown];
            assert!(
                all.iter().all(|own| own.value.is_finite() && own.expanded > 0.0),
                "{round}: {scar:?}"
            );
        }
    }
}

/// A scar as wide as the computed one and of another depth: the form is not the law's, the section is that of the readings, but for
/// steps of them at the edges.
#[test]
fn scars_of_another_depth_are_found() {
    for deeper in [0.5, 0.7, 0.9, 1.1, 1.4, 1.5, 1.7, 2.0] {
        let readings: Vec<[f64; 2]> = (-150..=150)
            .map(|i| 2e-5 * f64::from(i))
            .map(|x| [x + 4e-4, 3e-5 + 2e-3 * x - deeper * ring(x, made::SECTION)])
            .collect();
        let scar = Scar::find(&readings, &|_| 0.0, &computed()).unwrap();
        let off = scar.section.value - deeper * made::SECTION;
        assert!(off.abs() < scar.section.expanded + 1e-3 * made::SECTION, "{deeper}: {scar:?}");
    }
}
