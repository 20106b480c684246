//! Logs of made up tests, with known rates, in the ways that tribometers write.

use archard_log::{Error, Log, Options, Step};

fn read(bytes: &[u8]) -> Result<Log, Error> {
    Log::read("a.txt", bytes, &Options::default())
}

fn main_step(text: &str) -> Step {
    read(text.as_bytes()).expect("a log").main_step().expect("a step").clone()
}

/// A generic log: 0.5 m a reading, wear of `rate` um/m with noise of first order, at 10 N.
fn made(rate: f64, rho: f64, seed: u64) -> String {
    let mut random = fastrand::Rng::with_seed(seed);
    // A sum of twelve uniform numbers has a variance of one.
    let mut normal = || (0..12).map(|_| random.f64()).sum::<f64>() - 6.0;
    let mut noise = normal() / (1.0 - rho * rho).sqrt();
    let mut text = "Load [N]; Sliding distance (m); Wear depth / \u{b5}m\n".to_owned();
    for row in 0..1200 {
        let far = 0.5 * f64::from(row);
        text += &format!("10,0;{far:.1};{:.6}\n", 50.0 + rate * far + noise).replace('.', ",");
        noise = rho * noise + normal();
    }
    text
}

/// The nominal 95 % within what 300 draws scatter and what choosing the steady part takes.
#[test]
fn intervals_hold_the_slope_under_correlated_noise() {
    for rho in [0.0, 0.9, 0.98] {
        let held = (0..300).filter(|seed| {
            let [low, high] = main_step(&made(0.1, rho, *seed)).steady.expect("a rate").interval;
            (low..=high).contains(&0.1e-6)
        });
        let held = held.count();
        assert!((276..=294).contains(&held), "{held} of 300 at {rho}");
    }
}

#[test]
fn text_may_be_latin_or_utf_16() {
    let text = made(0.3, 0.0, 1);
    let latin: Vec<u8> = text.chars().map(|letter| u32::from(letter) as u8).collect();
    let wide: Vec<u8> =
        [0xff, 0xfe].into_iter().chain(text.encode_utf16().flat_map(u16::to_le_bytes)).collect();
    for bytes in [latin, wide] {
        let log = read(&bytes).expect("a log");
        let rate = log.main_step().and_then(|step| step.steady).expect("a rate").rate;
        assert!((rate / 0.3e-6 - 1.0).abs() < 0.01, "{rate}");
    }
}

#[test]
fn load_and_radius_of_a_csm_log_follow() {
    let mut text = "Sample\tx\nTime \tDistance\t Laps\t mu\tFrictionForce\n".to_owned();
    for row in 0..200 {
        let (laps, mu) = (f64::from(row), 0.2 + 0.001 * f64::from(row % 7));
        let line = format!("{row}\t{:.5}\t{laps}\t{mu}\t{:.6}\n", 0.0314159 * laps, 3.0 * mu);
        text += &line.replace('.', ",");
    }
    let log = read(text.as_bytes()).expect("a log");
    let step = log.main_step().expect("a step");
    assert!((step.load.expect("a load") - 3.0).abs() < 1e-3);
    assert!(log.lines().iter().any(|line| line.contains("5.000 mm")), "{:?}", log.lines());
    assert!(step.refused.as_deref().is_some_and(|why| why.contains("--column wear")));
}

#[test]
fn a_jump_of_the_transducer_is_a_step_and_no_wear() {
    let text: String = made(0.1, 0.0, 3)
        .lines()
        .enumerate()
        .map(|(row, line)| match line.rsplit_once(';').filter(|_| row > 700) {
            Some((rest, depth)) => {
                let depth: f64 = depth.replace(',', ".").parse().expect("a depth");
                format!("{rest};{:.6}\n", depth + 20.0).replace('.', ",")
            }
            None => format!("{line}\n"),
        })
        .collect();
    let step = main_step(&text);
    assert_eq!(step.jumps.len(), 1);
    assert!((step.jumps[0].1 / 20e-6 - 1.0).abs() < 0.1);
    assert!((step.steady.expect("a rate").rate / 0.1e-6 - 1.0).abs() < 0.05);
}

#[test]
fn what_cannot_be_told_is_refused_with_a_remedy() {
    let drift = main_step(&made(0.0, 0.98, 4));
    assert!(drift.k_over_area().is_none() && drift.refused.expect("why").contains("drift"));
    let falls = main_step(&made(-0.3, 0.0, 5));
    assert!(falls.refused.expect("why").contains("--column wear=\"-Wear depth"));
    let unloaded = main_step(&made(0.3, 0.0, 6).replace("Load [N]", "Nothing [N]"));
    assert!(unloaded.steady.is_some() && unloaded.refused.expect("why").contains("--set load"));
    let profile = read(b"\"Distance\",\"Profile\"\n\"0,00050\",\"0,03\"\n\"0,00100\",\"0,05\"\n");
    assert!(matches!(profile, Err(Error::Profile { line: 1, .. })), "{profile:?}");
    assert!(matches!(read(b"1;2\n2;3\n"), Err(Error::NoHeading { line: 1, .. })));
    assert!(matches!(read(b"no\nnumbers\n"), Err(Error::NoRows { .. })));
}

/// A transducer that reads the same all the time read no wear, however small its steps are.
#[test]
fn readings_that_stay_the_same_are_no_rate() {
    let mut text = "Load [N];Distance (m);Wear [um]\n".to_owned();
    (0..200).for_each(|row| text += &format!("10;{};3\n", 0.5 * f64::from(row)));
    let step = main_step(&text);
    assert!(step.steady.is_none() && step.second_half.is_none());
    assert!(step.refused.expect("a reason").contains("`Wear [um]` are the same"));
}

/// Where places go back a new step begins, and each has the rate of its own.
#[test]
fn places_that_jump_back_begin_a_step() {
    let lines = |from: i32, to: i32| -> String {
        let line = |row: i32| format!("10;{:.1};{:.4}\n", 0.5 * f64::from(row), f64::from(row));
        (from..to).map(line).collect()
    };
    let text = format!("Load [N];Distance (m);Wear [um]\n{}{}", lines(0, 100), lines(40, 300));
    let log = read(text.as_bytes()).expect("a log");
    let long: Vec<&Step> = log.steps.iter().filter(|step| step.readings > 20).collect();
    assert_eq!(long.len(), 2);
    for step in long {
        assert!((step.steady.expect("a rate").rate / 2e-6 - 1.0).abs() < 1e-3);
    }
}
