//! Damage of rolling contact fatigue by what friction works.
//!
//! The work of friction on each metre of rolling (T gamma, N), without that of the spin, decides whether a passage opens cracks
//! or wears them off: the whole-life rail model of M. Burstow (*Whole life rail model application and development for RSSB*, 2004). Damage
//! rises from a threshold to a peak, falls to nothing where wear is as fast as cracks, and beyond is worn off. At a damage of 1 a crack
//! is expected. Its values are of rails of grade R260.

/// What a passage of a patch does by its work.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cracks {
    /// Work (N) below which nothing cracks.
    pub threshold: f64,
    /// Work (N) at which a passage does most.
    pub peak: f64,
    /// Work (N) at which wear is as fast as cracks.
    pub balance: f64,
    /// Damage of a passage at the peak.
    pub most: f64,
    /// Whether more work wears cracks off again.
    pub heals: bool,
}

impl Cracks {
    /// The model for rails of grade R260 (Burstow 2004).
    pub const R260: Self =
        Self { threshold: 15.0, peak: 65.0, balance: 175.0, most: 1e-5, heals: true };

    /// The damage of a passage with that work (N) on each metre; negative where cracks are worn off.
    pub fn of_passage(&self, work: f64) -> f64 {
        let Self { threshold, peak, balance, most, heals } = *self;
        let rising = (work - threshold) / (peak - threshold);
        let falling = (balance - work) / (balance - peak);
        let least = if heals { f64::NEG_INFINITY } else { 0.0 };
        most * if work <= peak { rising.max(0.0) } else { falling.max(least) }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::Cracks;

    /// The model by its published points, in millionths: 0 at 10 N, 5 at 40 N, 10 at 65 N, 5 at 120 N, 0 at 175 N, and as much
    /// worn off beyond as the line goes down.
    #[test]
    fn damage_is_that_of_the_model() {
        for (work, damage) in [(10.0, 0.0), (40.0, 5.0), (65.0, 10.0), (120.0, 5.0), (230.0, -5.0)]
        {
            assert_relative_eq!(Cracks::R260.of_passage(work), 1e-6 * damage, epsilon = 1e-18);
        }
        assert!(Cracks::R260.of_passage(175.0).abs() < 1e-18);
        assert_eq!(Cracks { heals: false, ..Cracks::R260 }.of_passage(230.0), 0.0);
    }
}
