//! Rounds of runs: each with coefficients, lengths and steps by what the last one found.

use super::super::{Error, Estimate};
use super::{Search, of_load};

/// Rounds of runs at most, and the relative change of k that ends them: where one run tells all k, and where it does not.
const ROUNDS: usize = 10;
const SETTLED: [f64; 2] = [1e-3, 5e-3];
/// Part of a run beyond its end that readings may reach into before the run is made longer.
const BEYOND: f64 = 1.02;
impl Search<'_> {
    /// Rounds of runs until the coefficients settle.
    pub(super) fn settle(&mut self) -> Result<Vec<Estimate>, Error> {
        let mut last: Option<Vec<Estimate>> = None;
        let mut change = f64::INFINITY;
        for _ in 0..ROUNDS {
            let found = self.estimates(&[])?;
            let logs = |all: &[Estimate]| -> Vec<f64> {
                all.iter().flat_map(|own| own.tests.iter().map(|test| test.1.ln())).collect()
            };
            let last_logs = last.as_deref().map(logs);
            change = last_logs.map_or(f64::INFINITY, |last| {
                let changes =
                    logs(&found).into_iter().zip(last).map(|(new, old)| (new - old).abs());
                changes.fold(0.0, f64::max)
            });
            let off = self.ratio_off(&found);
            let settled = SETTLED[usize::from(!self.by_k_s)];
            let reaches = !self.by_k_s || self.reaches(&found);
            let alone = !self.by_k_s && self.targets.len() == 1;
            if alone || change <= settled && off.abs() <= settled && reaches {
                return Ok(found);
            }
            self.adapt(&found, off);
            last = Some(found);
        }
        Err(Error::Unsettled { rounds: ROUNDS, change })
    }

    /// How far the logarithm of the ratio of both coefficients is from that of the runs: zero where there is one coefficient.
    fn ratio_off(&self, found: &[Estimate]) -> f64 {
        let change = |place: usize| (found[place].median / self.reference[place]).ln();
        match found.len() {
            2 => change(1) - change(0),
            _ if self.by_k_s && !self.others.is_empty() => -change(0),
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
        let end = self.end();
        let mut needed = 0.0_f64;
        for ((target, own), reference) in self.targets.iter().zip(found).zip(&self.reference) {
            for (test, (_, k, _)) in
                target.tests.iter().zip(&own.tests).filter(|(test, _)| test.load == load)
            {
                let far = test.readings.last().map_or(0.0, |reading| reading.progress);
                needed = needed.max(k / reference * far / end);
            }
        }
        needed
    }

    /// Runs of the next round: their coefficients, how far they go, and where their steps end. The ratio of both coefficients
    /// goes by secants: each may change what the readings of the other ask for.
    fn adapt(&mut self, found: &[Estimate], off: f64) {
        let change = match self.ratio {
            Some((moved, last)) if moved != 0.0 && (off - last).abs() > 0.2 * moved.abs() => {
                (-off * moved / (off - last)).clamp(-2.0, 2.0)
            }
            _ => off.clamp(-2.0, 2.0),
        };
        self.ratio = Some((change, off));
        let logs: Vec<f64> = self.reference.iter().map(|known| known.ln()).collect();
        self.reference = match found {
            [one, other] => {
                let middle = 0.5 * (one.median.ln() + other.median.ln());
                let half = 0.5 * (logs[1] - logs[0] + change);
                vec![(middle - half).exp(), (middle + half).exp()]
            }
            // The other coefficient keeps its value.
            [_] if self.by_k_s && !self.others.is_empty() => vec![(logs[0] - change).exp()],
            all => all.iter().map(|own| own.median).collect(),
        };
        if !self.by_k_s {
            return;
        }
        let end = self.end();
        for load in self.loads() {
            let scale = 1.001 * self.needed(found, load);
            let mut shares = vec![];
            for ((target, own), reference) in self.targets.iter().zip(found).zip(&self.reference) {
                for (test, (_, k, _)) in
                    target.tests.iter().zip(&own.tests).filter(|(test, _)| test.load == load)
                {
                    let far = test.readings.iter().map(|reading| reading.progress);
                    shares.extend(far.map(|far| k / reference * far / end / scale));
                }
            }
            self.scale.insert(of_load(load), scale);
            self.shares.insert(of_load(load), shares);
        }
        self.known.clear();
    }
}
