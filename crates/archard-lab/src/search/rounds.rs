//! Rounds of runs: each with coefficients, lengths and steps by what the last one found.
//!
//! Where the worn state follows from k s, one run that goes as far as the readings gives one coefficient. Where both are sought,
//! their ratio is the unknown: readings tell a ratio of their own at each that is run, and the one is sought at which both
//! agree.

use super::super::{Error, Estimate};
use super::root::Root;
use super::{Search, of_load};

/// Rounds of runs at most: four halve a bracket, so that this is one of a factor of 40 narrowed to 4 %.
pub(super) const ROUNDS: usize = 25;
/// How closely the ratio of both coefficients is sought: relative to their standard uncertainty, to which a tenth adds half a
/// per cent; where nothing says that one, as closely as coefficients are printed.
const OF_UNCERTAINTY: f64 = 0.1;
const PRINTED: f64 = 1e-3;
/// Part of a run beyond its end that readings may reach into before the run is made longer.
pub(super) const BEYOND: f64 = 1.02;

/// What rounds of runs found, and by how much (the logarithm of) the ratio of both coefficients is off where they did not
/// settle.
pub(super) type Settled = (Vec<Estimate>, Option<f64>);

impl Search<'_> {
    /// Rounds of runs until they reach as far as the readings, with the ratio of coefficients that the readings ask for.
    pub(super) fn settle(&mut self) -> Result<Settled, Error> {
        let mut root = Root::default();
        let mut round = 0;
        loop {
            round += 1;
            let found = self.estimates(&[])?;
            let off = self.ratio_off(&found);
            let last = round == ROUNDS;
            let reaches = !self.by_k_s || self.reaches(&found);
            if !reaches && !last {
                self.reach(&found, 0.0);
                continue;
            }
            let next = root.next(self.log_ratio(), off, tolerance(&found));
            match next {
                None if reaches => {
                    self.guess = found.iter().map(|own| own.median).collect();
                    return Ok((found, None));
                }
                _ if last => return Ok((found, Some(off))),
                Some(next) => self.reach(&found, next - self.log_ratio()),
                None => self.reach(&found, 0.0),
            }
        }
    }

    /// How far the logarithm of the ratio of both coefficients is from that of the runs: zero where there is one coefficient.
    fn ratio_off(&self, found: &[Estimate]) -> f64 {
        match found {
            [one, other] => (other.median / one.median).ln() - self.log_ratio(),
            _ => 0.0,
        }
    }

    /// The logarithm of the ratio of both coefficients in the runs.
    fn log_ratio(&self) -> f64 {
        match self.reference[..] {
            [one, other] => other.ln() - one.ln(),
            _ => 0.0,
        }
    }

    /// Whether the runs go as far as the readings, and not much farther.
    fn reaches(&self, found: &[Estimate]) -> bool {
        self.loads().into_iter().all(|load| {
            let needed = self.needed(found, load);
            let share = needed / self.scale.get(&of_load(load)).copied().unwrap_or(1.0);
            (0.5..=BEYOND).contains(&share)
        })
    }

    /// The scale of a run that ends where the last reading of a load asks for.
    fn needed(&self, found: &[Estimate], load: Option<f64>) -> f64 {
        let far = self.places_in(found, load).into_iter().flatten();
        far.fold(0.0, f64::max)
    }

    /// How far the readings of each test of a load are, relative to the run at a scale of one.
    fn places_in(&self, found: &[Estimate], load: Option<f64>) -> Vec<Vec<f64>> {
        let end = self.end();
        let mut places = vec![];
        for ((target, own), reference) in self.targets.iter().zip(found).zip(&self.reference) {
            let tests = target.tests.iter().zip(&own.tests);
            for (test, (_, k, _)) in tests.filter(|(test, _)| test.load == load) {
                let far = test.readings.iter().map(|reading| reading.progress);
                places.push(far.map(|far| k / reference * far / end).collect());
            }
        }
        places
    }

    /// Runs of the next round: how far they go, where their steps end, and by how much the logarithm of the ratio of both
    /// coefficients changes.
    fn reach(&mut self, found: &[Estimate], change: f64) {
        self.reference = match (found, &self.reference[..]) {
            ([one, other], [first, second]) => {
                let middle = 0.5 * (one.median.ln() + other.median.ln());
                let half = 0.5 * (second.ln() - first.ln() + change);
                vec![(middle - half).exp(), (middle + half).exp()]
            }
            (all, _) => all.iter().map(|own| own.median).collect(),
        };
        self.guess = found.iter().map(|own| own.median).collect();
        if self.by_k_s {
            for load in self.loads() {
                let scale = 1.001 * self.needed(found, load);
                let places = self.places_in(found, load).into_iter().flatten();
                let shares = places.map(|place| place / scale).collect();
                self.scale.insert(of_load(load), scale);
                self.shares.insert(of_load(load), shares);
            }
        }
        self.known.clear();
    }
}

/// How closely the ratio of both coefficients has to be found.
fn tolerance(found: &[Estimate]) -> f64 {
    let width = |own: &Estimate| own.interval.map(|[low, high]| (high / low).ln() / 4.0);
    let known: Option<Vec<f64>> = found.iter().map(width).collect();
    let least = known.and_then(|all| all.into_iter().reduce(f64::min));
    least.map_or(PRINTED, |least| (OF_UNCERTAINTY * least).max(PRINTED))
}
