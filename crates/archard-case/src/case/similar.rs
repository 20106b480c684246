//! Cases that differ in the size of their wear coefficients alone, and wear by k s.

use std::fmt::Write;

use super::Case;

/// What a case has in common with all that differ from it in the size of its wear coefficients alone.
#[derive(Debug, Clone, PartialEq)]
pub struct WearByKs {
    /// The case with its coefficients relative to the largest; equal of cases that are equal in all else.
    pub kind: String,
    /// The largest coefficient (1/Pa).
    pub coefficient: f64,
}

impl Case {
    /// What it shares with cases that one run answers together with it; `None` where the worn state does not follow from
    /// k s alone.
    ///
    /// The load is constant, surfaces slide or roll steadily, steps are implicit, every body that wears has Holm-Archard's
    /// law, each of its layers too, and nothing is put out at points inside, which only the end of a run has. Cases with an
    /// accuracy have grids of their own, and frames that become wider do so at a place of their own.
    pub fn wears_by_k_s(&self) -> Option<WearByKs> {
        let (motion, schedule) = self.motion.build().ok()?;
        let steady = motion.is_steady() && schedule.is_steady() && !self.seeks_inside();
        let plain = self.accuracy.is_none() && self.until.is_empty() && self.doubles.is_empty();
        if !(steady && plain) {
            return None;
        }
        let mut unworn = self.clone();
        let mut coefficients = vec![];
        for body in &mut unworn.bodies {
            let layers = body.layers.iter_mut().map(|layer| &mut layer.wear);
            for law in [&mut body.wear].into_iter().chain(layers) {
                let Some(wear) = law.take() else {
                    coefficients.push(None);
                    continue;
                };
                let number = |name: &str| wear.values.number(name);
                if wear.choice.name != "archard" {
                    return None;
                }
                let by_hardness = || Some(number("k_ad")? / number("hardness")?);
                coefficients.push(Some(number("coefficient").or_else(by_hardness)?));
            }
        }
        let coefficient = coefficients.iter().flatten().copied().fold(0.0, f64::max);
        if coefficient <= 0.0 {
            return None;
        }
        let mut kind = unworn.to_string();
        for part in coefficients {
            // Twelve digits: coefficients that were scaled equally are rounded unlike.
            let part = part.map(|part| format!("{:.11e}", part / coefficient));
            let _ = writeln!(kind, "{part:?}");
        }
        Some(WearByKs { kind, coefficient })
    }
}
