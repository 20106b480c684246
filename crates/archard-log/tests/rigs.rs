//! Logs as other rigs write them, made up with known rates: their columns, heads, steps, units and mistakes.

use archard_log::{Error, Log, Options, Step, groups, rows, with_profile};

fn options(columns: &[(&str, &str)], values: &[(&str, &str)]) -> Options {
    let owned = |all: &[(&str, &str)]| {
        all.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect()
    };
    Options { columns: owned(columns), values: owned(values), profile: false }
}

fn read(text: &str, options: &Options) -> Result<Log, Error> {
    Log::read("a.csv", text.as_bytes(), options)
}

fn told(text: &str) -> Log {
    read(text, &Options::default()).expect("a log")
}

/// Holds the rate (um/m) of a step against that of the log as it was made, within a hundredth.
fn has_rate(step: &Step, rate: f64) {
    let found = 1e6 * step.steady.expect("a rate").rate;
    assert!((found / rate - 1.0).abs() < 0.01, "{found} in the place of {rate}");
}

/// Noise without a trend, between 0 and 1.
fn noise(row: u32) -> f64 {
    f64::from(row * 7919 % 101) / 101.0
}

/// A log of three steps of a recipe: brought near, then 60 rpm on 5 mm, then 120 rpm on 8 mm, with 0.4 um/m in each; the time starts
/// again in each step, carriage returns alone end the head, and the whole time stands below.
fn recipe(radius_in_head: &str) -> String {
    let mut text = format!(
        "Recipe, UpperSample, LogFrequency, Radius,\rball, steel, 1,{radius_in_head},\r\nStep, Timestamp, RecipeStep, DAQ.Fz (N),DAQ.Fx (N),\
         DAQ.COF (Fx),Rotary.Velocity (rpm),XYZ.X Position (mm),XYZ.Z Depth (mm),XYZ.Z Position (mm),\r\n"
    );
    let mut far = 0.0;
    for (step, rpm, radius) in [(1, 0.0, 5.0), (2, 60.0, 5.0), (3, 120.0, 8.0)] {
        for row in 0..400u32 {
            let passed = std::f64::consts::TAU * 1e-3 * radius * rpm / 60.0;
            far += if row == 0 { 0.0 } else { passed };
            let load = if step == 1 { 0.01 } else { -5.0 };
            let depth = 1e-3 * (0.4 * far + 0.02 * noise(row));
            text += &format!(
                "{step},{row},{step},{load},1.0,0.2,{rpm},{radius},{depth:.6},{:.6},\n",
                30.0 - depth
            );
        }
    }
    text + "TotalTime,\n00:20:00,\n"
}

#[test]
fn steps_of_a_recipe_have_speeds_and_radii_of_their_own() {
    for options in [
        options(&[], &[("radius", "5 mm; 5 mm; 8 mm")]),
        options(&[("radius", "XYZ.X Position (mm)")], &[]),
    ] {
        let log = read(&recipe(""), &options).expect("a log");
        assert_eq!(log.steps.len(), 3);
        assert!(log.steps[0].refused.as_deref().is_some_and(|why| why.contains("did not slide")));
        for step in &log.steps[1..] {
            has_rate(step, 0.4);
            assert_eq!(step.load, Some(5.0));
        }
        let radii: Vec<f64> = log.steps.iter().skip(1).filter_map(|step| step.radius).collect();
        assert_eq!(radii, [5e-3, 8e-3]);
        assert_eq!(rows([&log]).len(), 2);
    }
}

#[test]
fn a_radius_that_is_missing_can_be_answered() {
    let error = read(&recipe("5"), &Options::default()).expect_err("no radius").to_string();
    for words in ["a.csv:3", "--set radius", "`radius 5` in line 1", "XYZ.X Position (mm)"] {
        assert!(error.contains(words), "{words}: {error}");
    }
    let error = read(&recipe(""), &options(&[], &[("radius", "5 mm; 8 mm")]));
    assert!(error.expect_err("too few").to_string().contains("3 steps"));
    // The whole time below the readings is that of the time in seconds.
    let short = recipe("5 mm").replace("00:20:00", "00:00:01.20");
    let error = read(&short, &Options::default()).expect_err("milliseconds").to_string();
    assert!(error.contains("line 1205") && error.contains("units"), "{error}");
}

/// Loads in millinewton, a coefficient called by a Greek letter, sequences, and a head with units behind its values.
#[test]
fn columns_have_the_names_of_common_software() {
    let mut text = "Tribometer\tNano\nSingle-way mode\nRadius :\t5.00\t[mm]\n\nTime [s]\tDistance [m]\tLaps\tSequence ID\tCycle ID\t\
                    Max linear speed [m/s]\tNominal Load [mN]\t\u{b5}\tAngle [\u{b0}]\tNormal force [mN]\tFriction force [mN]\t\
                    Penetration depth [\u{b5}m]\n"
        .to_owned();
    for row in 0..600u32 {
        let far = 0.0314159 * f64::from(row);
        let depth = 0.3 * far + 0.01 * noise(row);
        text += &format!(
            "{row}\t{far:.6}\t{row}\t1\t1\t0.03\t500\t0.2\t{}\t500\t100\t{depth:.5}\n",
            row % 360
        );
    }
    let log = told(&text);
    has_rate(&log.steps[0], 0.3);
    assert_eq!(log.steps[0].load, Some(0.5));
    assert!((log.steps[0].radius.expect("a radius") - 5e-3).abs() < 1e-9);
    assert!((log.steps[0].friction.expect("friction").0 - 0.2).abs() < 1e-9);
}

/// Revolutions and no radius, no load: both are asked for, and the head may hold them.
#[test]
fn what_a_log_does_not_hold_may_stand_in_its_head() {
    let mut text =
        "Time [s];Friction force [N];Displacement [um];Temperature1 [C];Rotational speed [rpm];\
                    Number of revolutions\n"
            .to_owned();
    for row in 0..600u32 {
        let turns = 2.0 * f64::from(row);
        let depth = 0.2 * std::f64::consts::TAU * 0.01 * turns + 0.05 * noise(row);
        text += &format!("{row};2.0;{depth:.4};21;120;{turns}\n");
    }
    let error = read(&text, &Options::default()).expect_err("no radius").to_string();
    assert!(error.contains("--set radius"), "{error}");
    let given = read(&text, &options(&[], &[("radius", "10 mm"), ("load", "10 N")]));
    for log in [
        given.expect("a log"),
        told(&format!("Load: 10 N\nTrack radius = 10 mm\n{text}")),
        told(&format!("Applied Load;10;N;\nRadius [mm];10;\n{text}")),
        told(&format!("Load : 10 N\nSpeed : 120 RPM\nWear Track Diameter : 20 mm\n{text}")),
    ] {
        has_rate(&log.steps[0], 0.2);
        assert_eq!(log.steps[0].load, Some(10.0));
        assert!((log.steps[0].friction.expect("friction").0 - 0.2).abs() < 1e-9);
    }
}

/// `heading` over rows of a distance of half a metre each, 10 N, and 0.5 um/m in these units of the two lengths.
fn plain(heading: &str, [load, distance, depth]: [f64; 3]) -> String {
    let mut text = format!("{heading}\n");
    for row in 0..500u32 {
        let far = 0.5 * f64::from(row);
        let worn = 0.5e-6 * far + 2e-8 * noise(row);
        text += &format!("{load},{},{}\n", far / distance, worn / depth);
    }
    text
}

#[test]
fn units_stand_as_people_write_them() {
    for (heading, units) in [
        ("Load N,Distance m,Wear um", [10.0, 1.0, 1e-6]),
        ("Load_N,Sliding distance_m,Wear depth_um", [10.0, 1.0, 1e-6]),
        ("Normal Force / N,Distance / km,Wear / mm", [10.0, 1e3, 1e-3]),
        ("Applied load (Newton),Distance (meters),Wear (microns)", [10.0, 1.0, 1e-6]),
        ("Load,Distance,Wear\nN,m,um", [10.0, 1.0, 1e-6]),
        ("Load (N)   Sliding distance (m)   Wear (um)", [10.0, 1.0, 1e-6]),
        ("Load (N) Distance (m) Wear (um)", [10.0, 1.0, 1e-6]),
        ("Load [kg],Distance [m],Wear [um]", [10.0 / 9.80665, 1.0, 1e-6]),
        ("Dead weight (kg),Distance [m],Wear [um]", [10.0 / 9.80665, 1.0, 1e-6]),
    ] {
        let text = plain(heading, units);
        let text = if heading.contains(',') { text } else { text.replace(',', "   ") };
        let log = told(&text);
        has_rate(&log.steps[0], 0.5);
        let load = log.steps[0].load.expect("a load");
        assert!((load - 10.0).abs() < 1e-6, "{heading}: {load}");
        let weighed = log.said.iter().any(|(_, words)| words.contains("weight"));
        assert_eq!(weighed, heading.contains("kg"), "{heading}: {:?}", log.said);
    }
}

/// A factor that only a unit makes is refused, where other columns tell it, with both ways.
#[test]
fn units_that_contradict_one_another_are_refused() {
    let mut text = "time [s],speed [m/s],distance [mm],load [N],wear [um]\n".to_owned();
    (0..300).for_each(|row| text += &format!("{row},0.5,{},10,{}\n", 0.5 * f64::from(row), row));
    let error = read(&text, &Options::default()).expect_err("mm and m").to_string();
    assert!(error.contains("speed and time") && error.contains("units"), "{error}");
    told(&text.replace("[mm]", "[m]"));
    let text = "Radius [mm],Load [N],Distance [m],Wear [mm]\n".to_owned()
        + &(0..300).map(|row| format!("14,10,{row},{}\n", 5 * row)).collect::<String>();
    let log = told(&text);
    let why = log.steps[0].refused.as_deref().expect("why");
    assert!(why.contains("radius of the track") && why.contains("Wear [mm]"), "{why}");
    let stated = read(&text, &options(&[("wear", "Wear [um]")], &[]));
    assert!(matches!(stated, Err(Error::TwoUnits { .. })), "{stated:?}");
}

/// Readings that are off alone are counted, and change no rate; a stretch that stays is a jump.
#[test]
fn spikes_are_counted_and_not_in_the_rate() {
    let text = plain("Load [N],Distance [m],Wear [um]", [10.0, 1.0, 1e-6]);
    let clean = told(&text).steps[0].clone();
    let spoilt: String = text
        .lines()
        .enumerate()
        .map(|(row, line)| match line.rsplit_once(',') {
            Some((rest, _)) if row > 0 && row % 37 == 3 => format!("{rest},9999\n"),
            _ => format!("{line}\n"),
        })
        .collect();
    let step = told(&spoilt).steps[0].clone();
    assert_eq!((clean.spikes.len(), step.spikes.len()), (0, 14));
    assert_eq!(step.spikes[0].0, 4);
    has_rate(&step, 0.5);
    let widths = [clean, step].map(|step| {
        let [low, high] = step.steady.expect("a rate").interval;
        high - low
    });
    assert!(widths[1] < 1.5 * widths[0], "{widths:?}");
}

/// Time that starts again begins a step; one reading that is earlier is said, with its line, and passes no distance.
#[test]
fn times_that_jump_back_are_said() {
    let lines = |from: u32, to: u32| -> String {
        (from..to).map(|row| format!("{row},0.5,10,{}\n", 0.25 * f64::from(row))).collect()
    };
    let heading = "time [s],speed [m/s],load [N],wear [um]\n";
    let again = told(&format!("{heading}{}{}", lines(0, 200), lines(0, 300)));
    assert_eq!(again.steps.len(), 2);
    again.steps.iter().for_each(|step| has_rate(step, 0.5));
    assert!(again.said.iter().any(|(_, words)| words.contains("starts again at line 202")));
    let swapped = lines(0, 300).replace("\n150,", "\n149.2,").replace("\n149,", "\n149.6,");
    let late = told(&format!("{heading}{swapped}"));
    assert_eq!(late.steps.len(), 1);
    assert!(late.said.iter().any(|(_, words)| words.contains("jumps back at line 152")));
    has_rate(&late.steps[0], 0.5);
}

/// A transducer that drifts at rest may do so in motion: the interval holds the rate with and without it.
#[test]
fn drift_at_rest_widens_the_interval() {
    let mut text = "time [s],distance [m],load [N],wear [um]\n".to_owned();
    for row in 0..400u32 {
        let (time, far) = (f64::from(row), f64::from(row.saturating_sub(100)));
        let depth = 0.02 * time + 0.1 * far + 0.01 * noise(row);
        text += &format!("{time},{far},10,{depth:.5}\n");
    }
    let step = told(&text).steps[0].clone();
    assert!((step.drift.expect("a drift") / 0.02e-6 - 1.0).abs() < 0.02, "{:?}", step.drift);
    let [low, high] = step.steady.expect("a rate").interval;
    assert!(low < 0.1e-6 && high > 0.12e-6, "{low} {high}");
}

#[test]
fn a_profile_is_no_log_and_stands_beside_one() {
    for text in [
        "\"Distance\",\"Profile\"\n\"0,00050\",\"0,03\"\n\"0,00100\",\"0,05\"\n",
        "x [mm];z [um]\n0,1;2\n0,2;3\n",
        "Instrument: P7\n\nPosition (mm)\tHeight (\u{b5}m)\n0.1\t2\n0.2\t3\n",
    ] {
        assert!(matches!(read(text, &Options::default()), Err(Error::Profile { .. })), "{text}");
    }
    let friction = "Load [N],Distance [m],mu\n".to_owned()
        + &(0..50).map(|row| format!("5,{row},0.2\n")).collect::<String>();
    let row = with_profile(&told(&friction), "p.csv").expect("a row");
    assert_eq!(row, "a,4.900000e1,5.000000e0,\"p.csv\"");
    let unloaded = friction.replace("Load [N]", "Nothing [N]");
    assert!(with_profile(&told(&unloaded), "p.csv").is_err());
}

/// Logs of one name agree within their intervals or their scatter is said; those of another name share the set-up.
#[test]
fn logs_of_one_name_are_held_against_each_other() {
    let log = |name: &str, rate: f64| {
        let text = plain("Load [N],Distance [m],Wear [um]", [10.0, 1.0, 0.5e-6 / rate]);
        Log::read(name, text.as_bytes(), &Options::default()).expect("a log")
    };
    let same = [log("PPS_60N_1.tsv.gz", 1e-6), log("d/PPS_60N_2.tsv", 1.0001e-6)];
    let found = groups(&same);
    assert_eq!((found.len(), &*found[0].name, found[0].agree), (1, "PPS_60N", true));
    let names = rows(&[same[0].clone(), same[0].clone()]);
    assert!(names[1].starts_with("PPS_60N_1_2,"), "{names:?}");
    let other = [log("PPS_60N_1.tsv", 1e-6), log("PPS_60N_2.tsv", 2e-6), log("PEEK.tsv", 4e-6)];
    let found = groups(&other);
    assert_eq!(found.iter().map(|group| group.named).collect::<Vec<_>>(), [true, false]);
    assert!(!found[0].agree);
    // Of a factor of two the standard deviation of the logarithm is its own over the square root of two.
    assert!((found[0].scatter - 2f64.ln() / 2f64.sqrt()).abs() < 0.01, "{}", found[0].scatter);
    assert_eq!(found[1].logs, [0, 1, 2]);
}

/// What has no number is left out, and the others keep their place: speeds that are read now and then, ends of a distance, and the
/// number of a step.
#[test]
fn cells_without_a_number_change_no_rate() {
    let log = |heading: &str, line: &dyn Fn(u32) -> String| {
        told(&format!("{heading}\n{}", (0..600).map(line).collect::<String>()))
    };
    let worn = |row: u32| 0.25 * f64::from(row) + 0.02 * noise(row);
    for log in [
        log("time [s],speed [m/s],load [N],wear [um]", &|row| {
            let speed = if noise(row) < 0.3 { "NaN" } else { "0.5" };
            format!("{row},{speed},10,{}\n", worn(row))
        }),
        log("time [s],distance [m],load [N],wear [um]", &|row| {
            let far = 0.5 * f64::from(row);
            let far = if row % 599 == 0 { String::new() } else { far.to_string() };
            format!("{row},{far},10,{}\n", worn(row))
        }),
        log("step,distance [m],load [N],wear [um]", &|row| {
            let step = if row % 50 == 7 { "NaN" } else { "1" };
            format!("{step},{},10,{}\n", 0.5 * f64::from(row), worn(row))
        }),
    ] {
        assert_eq!(log.steps.len(), 1);
        has_rate(&log.steps[0], 0.5);
    }
}

/// A clock that is set back again and again passes no time twice.
#[test]
fn a_time_that_is_passed_twice_counts_once() {
    let lines = (0..600u32).map(|row| {
        let time = if row % 10 == 9 { row - 5 } else { row };
        format!("{time},0.5,10,{}\n", 0.25 * f64::from(row) + 0.02 * noise(row))
    });
    let text = format!("time [s],speed [m/s],load [N],wear [um]\n{}", lines.collect::<String>());
    has_rate(&told(&text).steps[0], 0.5);
}

/// Of stairs and ramps of the load no coefficient is told, for no load is that of the rate; noise of a load is neither.
#[test]
fn a_load_that_changes_is_refused() {
    let log = |load: &dyn Fn(u32) -> f64| {
        let mut worn = 0.0;
        let lines = (0..600u32).map(|row| {
            worn += 2.5e-3 * load(row);
            format!("{},{},{}\n", 0.5 * f64::from(row), load(row), worn + 0.02 * noise(row))
        });
        told(&format!("distance [m],load [N],wear [um]\n{}", lines.collect::<String>()))
    };
    for log in [
        log(&|row| if row < 300 { 6.0 } else { 10.0 }),
        log(&|row| if (200..400).contains(&row) { 10.0 } else { 7.0 }),
        log(&|row| 6.0 + f64::from(row) / 150.0),
    ] {
        let why = log.steps[0].refused.as_deref().expect("why");
        assert!(why.contains("the load goes from"), "{why}");
        assert!(rows([&log]).is_empty() && with_profile(&log, "p.csv").is_err());
    }
    let noisy = log(&|row| 8.0 + 4.0 * noise(row));
    let k = noisy.steps[0].k_over_area().expect("a coefficient");
    assert!((k / 5e-9 - 1.0).abs() < 0.01, "{k}");
}

/// A head has the decimal sign of the readings.
#[test]
fn thousands_in_the_head_are_told_by_the_readings() {
    let text = plain("Nothing;Distance [m];Wear [um]", [10.0, 1.0, 1e-6]).replace(',', ";");
    let with = |head: &str, text: &str| told(&format!("{head}\n{text}")).steps[0].load;
    assert_eq!(with("Load : 5,000 N", &text.replace('.', ",")), Some(5.0));
    assert_eq!(with("Load : 5,000 N", &text), Some(5000.0));
}

/// Values that stand under no name may be those of any column.
#[test]
fn rows_of_another_width_than_their_names_are_refused() {
    let commas =
        plain("Load [N];Distance [m];Wear [um]", [10.5, 1.0, 1e-6]).replace(['.', ';'], ",");
    let blanks = plain("Load(N) Sliding distance(m) Wear(um)", [10.0, 1.0, 1e-6]).replace(',', " ");
    let more =
        plain("Load [N],Distance [m],Wear [um]", [10.0, 1.0, 1e-6]).replace("\n10,", "\n1,10,");
    for text in [commas, blanks, more] {
        let wrong = read(&text, &Options::default());
        assert!(matches!(wrong, Err(Error::Width { line: 2, .. })), "{wrong:?}");
    }
}

/// Times of day go on past midnight, which is said with its line.
#[test]
fn midnight_is_passed() {
    let lines = (0..600u32).map(|row| {
        let time = (86_100 + row) % 86_400;
        let [hours, minutes, seconds] = [time / 3600, time / 60 % 60, time % 60];
        let worn = 0.25 * f64::from(row) + 0.02 * noise(row);
        format!("{hours:02}:{minutes:02}:{seconds:02},0.5,10,{worn}\n")
    });
    let log = told(&format!("time,speed [m/s],load [N],wear [um]\n{}", lines.collect::<String>()));
    assert_eq!(log.steps.len(), 1);
    has_rate(&log.steps[0], 0.5);
    let said = |words: &str| log.said.iter().any(|(_, own)| own.contains(words));
    assert!(said("passes midnight before line 302"), "{:?}", log.said);
}

/// Where each reading would be a step, as of a distance that counts down, a few lines say so.
#[test]
fn a_distance_that_falls_is_said_in_few_lines() {
    let lines = (0..600).map(|row| format!("10,{},{row}\n", 600 - row));
    let log = told(&format!("Load [N],Distance [m],Wear [um]\n{}", lines.collect::<String>()));
    assert!(log.steps.iter().all(|step| step.k_over_area().is_none()));
    assert!(log.lines().len() < 20, "{:#?}", log.lines());
}
