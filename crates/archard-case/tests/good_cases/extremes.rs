//! Published cases with one number replaced by an extreme one: a case or an error, soon.

use std::time::{Duration, Instant};

use archard_case::CaseFile;

/// Beyond all that can be computed with, at its border, and odd.
const EXTREMES: [&str; 8] = ["0", "-0", "5e-324", "1e-14", "1e300", "1e14", "1000000000", "-1"];
/// What any check may take.
const LONG: Duration = Duration::from_secs(10);

/// The value with each of its numbers replaced in turn.
fn replaced(value: &str, extreme: &str) -> Vec<String> {
    let parts: Vec<&str> = value.split_inclusive(['[', '"', ' ', ',', ']']).collect();
    let number = |part: &str| part.trim_end_matches(['"', ' ', ',', ']']).to_owned();
    let places = (0..parts.len()).filter(|&place| number(parts[place]).parse::<f64>().is_ok());
    let with = |place: usize| {
        let mut parts: Vec<String> = parts.iter().map(|part| (*part).to_owned()).collect();
        parts[place] = parts[place].replacen(&number(&parts[place]), extreme, 1);
        parts.concat()
    };
    places.map(with).collect()
}

/// Checks a case with an option; what is wrong with the way it went.
fn odd(case: &CaseFile, option: &str) -> Option<String> {
    let start = Instant::now();
    let checked = case.clone().set(option).resolve();
    if start.elapsed() > LONG {
        return Some(format!("{option} took {:?}", start.elapsed()));
    }
    let shown = checked.ok()?.forecast.to_string();
    let garbled = ["NaN", "inf"].iter().any(|word| shown.contains(word));
    garbled.then(|| format!("{option}: {shown}"))
}

#[test]
fn one_extreme_number_makes_a_case_or_an_error() {
    let (mut tried, mut wrong) = (0, vec![]);
    for name in
        ["hertz", "pin_on_disc", "twin_disc", "kalker_creepage", "fretting_sphere", "roller_finite"]
    {
        let file = CaseFile::read(&crate::framed::folder(name)).unwrap();
        let text = file.resolve().unwrap_or_else(|_| panic!("{name}")).case.to_string();
        for (key, value) in text.lines().filter_map(|line| line.split_once(" = ")) {
            for option in EXTREMES.iter().flat_map(|extreme| replaced(value, extreme)) {
                tried += 1;
                wrong.extend(odd(&file, &format!("{key}={option}")));
            }
        }
    }
    assert!(tried > 500, "only {tried} tried");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
