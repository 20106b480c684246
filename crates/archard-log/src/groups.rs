//! Several logs: those of one name and load, and those of one set-up, with the scatter of their wear coefficients.

use statrs::distribution::{ChiSquared, ContinuousCDF};

use crate::steps::{near, range};
use crate::{Log, Step};

/// Logs that can be held against each other.
#[derive(Debug, Clone)]
pub struct Group {
    /// The name without its number, or the load, radius and speed that they share.
    pub name: String,
    /// Whether they share the name; otherwise the set-up alone.
    pub named: bool,
    /// Which logs.
    pub logs: Vec<usize>,
    /// Load (N).
    pub load: f64,
    /// Smallest and largest radius (m).
    pub radius: Option<[f64; 2]>,
    /// Wear coefficient over worn area (1/N) of each.
    pub k: Vec<f64>,
    /// Median (the exponential of the mean logarithm) of the coefficients (1/N).
    pub median: f64,
    /// Standard deviation of their logarithms.
    pub scatter: f64,
    /// Whether their intervals explain that they differ (Cochran's test, Biometrics 10 (1954) 101, at 5 %).
    pub agree: bool,
}

/// A log with a coefficient.
struct Told<'a> {
    log: usize,
    stem: String,
    step: &'a Step,
    load: f64,
    k: f64,
}

/// The name without a number at its end that counts tests: `PPS_60N_1` is one of `PPS_60N`.
fn stem(name: &str) -> String {
    let bare = name.trim_end_matches(|letter: char| letter.is_ascii_digit());
    let counts = bare.len() < name.len() && bare.ends_with(['_', '-', ' ', '.', '#']);
    let bare = if counts { bare.trim_end_matches(['_', '-', ' ', '.', '#']) } else { name };
    if bare.is_empty() { name.to_owned() } else { bare.to_owned() }
}

/// The groups of two and more: by name and load, then those of the same load, radius and speed under several names.
pub fn groups<'a>(logs: &'a [Log]) -> Vec<Group> {
    let told = |(log, own): (usize, &'a Log)| {
        let step = own.main_step()?;
        Some(Told { log, stem: stem(&own.name()), step, load: step.load?, k: step.k_over_area()? })
    };
    let all: Vec<Told<'_>> = logs.iter().enumerate().filter_map(told).collect();
    let by_name = gathered(&all, |one, other| one.stem == other.stem && near(one.load, other.load));
    let by_setup = gathered(&all, |one, other| {
        let same = |one: Option<f64>, other: Option<f64>| match (one, other) {
            (Some(one), Some(other)) => near(one, other),
            (one, other) => one.is_none() && other.is_none(),
        };
        near(one.load, other.load)
            && same(one.step.radius, other.step.radius)
            && same(one.step.speed, other.step.speed)
    });
    let named = by_name.iter().map(|own| group(own, true));
    let several = by_setup.iter().filter(|own| own.iter().any(|one| one.stem != own[0].stem));
    named.chain(several.map(|own| group(own, false))).collect()
}

fn gathered<'a>(
    all: &'a [Told<'a>],
    same: impl Fn(&Told<'a>, &Told<'a>) -> bool,
) -> Vec<Vec<&'a Told<'a>>> {
    let mut groups: Vec<Vec<&Told<'_>>> = vec![];
    for own in all {
        match groups.iter_mut().find(|group| same(group[0], own)) {
            Some(group) => group.push(own),
            None => groups.push(vec![own]),
        }
    }
    groups.retain(|group| group.len() > 1);
    groups
}

fn group(own: &[&Told<'_>], named: bool) -> Group {
    let logarithms: Vec<f64> = own.iter().map(|one| one.k.ln()).collect();
    let n = logarithms.len() as f64;
    let mean = logarithms.iter().sum::<f64>() / n;
    let squares: f64 = logarithms.iter().map(|one| (one - mean).powi(2)).sum();
    let radii: Vec<f64> = own.iter().filter_map(|one| one.step.radius).collect();
    let [first, load] = [&own[0].stem, &format!("{:.4} N", own[0].load)];
    let of_setup = || {
        let radius =
            own[0].step.radius.map_or(String::new(), |r| format!(", radius {:.3} mm", 1e3 * r));
        let speed = own[0].step.speed.map_or(String::new(), |v| format!(", {v:.3} m/s"));
        format!("{load}{radius}{speed}")
    };
    Group {
        name: if named { first.clone() } else { of_setup() },
        named,
        logs: own.iter().map(|one| one.log).collect(),
        load: own[0].load,
        radius: (radii.len() == own.len()).then(|| range(&radii)),
        k: own.iter().map(|one| one.k).collect(),
        median: mean.exp(),
        scatter: (squares / (n - 1.0)).sqrt(),
        agree: agree(own),
    }
}

/// Whether the weighted squares of the differences are below what chance makes in 95 of a hundred.
fn agree(own: &[&Told<'_>]) -> bool {
    let each: Vec<(f64, f64)> = own
        .iter()
        .filter_map(|one| {
            let error = one.step.steady?.deviation() / one.load;
            Some((one.k, error.max(f64::MIN_POSITIVE).powi(-2)))
        })
        .collect();
    let weights: f64 = each.iter().map(|one| one.1).sum();
    let mean = each.iter().map(|(k, weight)| k * weight).sum::<f64>() / weights;
    let squares: f64 = each.iter().map(|(k, weight)| weight * (k - mean).powi(2)).sum();
    let chance = ChiSquared::new(each.len() as f64 - 1.0).expect("two logs at least");
    squares <= chance.inverse_cdf(0.95)
}
