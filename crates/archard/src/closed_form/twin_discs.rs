//! Simple models of the wear of twin discs that slide all over: depth over revolutions.
//!
//! V. Hegadekatte, S. Kurzenhäuser, N. Huber and O. Kraft, *Tribol. Int.* 41 (2008) 1020, for the
//! incremental model. Both take the load as uniform across the worn track, of half width
//! b = sqrt(2 R h) on a crown of radius R worn to the depth h.

/// Two discs that slide all over each other as they roll.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwinDiscs {
    /// Wear coefficient k of both together (1/Pa).
    pub coefficient: f64,
    /// Magnitude of the creepage c.
    pub creepage: f64,
    /// Combined radius R across the direction of rolling (m).
    pub crown: f64,
    /// Half width b_0 of the unworn contact across it (m), after Hertz.
    pub half_width: f64,
}

impl TwinDiscs {
    /// Depth (m) by the uniform line load alone, h = (3 k c F n / (4 sqrt(2 R)))^(2/3), after a load integrated over the
    /// revolutions, F n (N).
    pub fn line_load_depth(&self, load_revolutions: f64) -> f64 {
        self.rise(load_revolutions).powf(2.0 / 3.0)
    }

    /// Depth (m) by the incremental model, its track never narrower than the contact of Hertz: dh = k c F / (2 b) a
    /// revolution, b = max(b_0, sqrt(2 R h)), after a load integrated over the revolutions, F n (N).
    ///
    /// Integrated exactly: linear in the revolutions until the worn track is as wide as the contact, then
    /// h^(3/2) grows linearly.
    pub fn incremental_depth(&self, load_revolutions: f64) -> f64 {
        let turn = self.half_width * self.half_width / (2.0 * self.crown);
        let rate = self.coefficient * self.creepage / (2.0 * self.half_width);
        let beyond = load_revolutions - turn / rate;
        if beyond <= 0.0 {
            return rate * load_revolutions;
        }
        (turn.powf(1.5) + self.rise(beyond)).powf(2.0 / 3.0)
    }

    /// Half width (m) of the track worn to a depth (m).
    pub fn track(&self, depth: f64) -> f64 {
        (2.0 * self.crown * depth).sqrt()
    }

    /// By how much h^(3/2) grows on a track as wide as it is worn.
    fn rise(&self, load_revolutions: f64) -> f64 {
        3.0 * self.coefficient * self.creepage * load_revolutions
            / (4.0 * (2.0 * self.crown).sqrt())
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::TwinDiscs;

    /// The twin discs of the paper's section 6.3: k = 2e-6 1/MPa, crown 125 mm, half width after Hertz 0.8265901 mm;
    /// 0.5 %.
    const DISCS: TwinDiscs =
        TwinDiscs { coefficient: 2e-12, creepage: 0.005, crown: 0.125, half_width: 0.8265901e-3 };
    /// The load there (N).
    const LOAD: f64 = 300.0;

    /// Independent half-space solution at 0.5 %: 26.13 um after 30,000 revolutions; the incremental
    /// model is known to agree within 0.5 %.
    #[test]
    fn the_incremental_model_ends_where_the_half_space_does() {
        assert_relative_eq!(
            DISCS.incremental_depth(LOAD * 30_000.0),
            26.13e-6,
            max_relative = 5e-3
        );
    }

    /// dh/dn = k c F / (2 b), on both sides of the turn, by a central difference.
    #[test]
    fn the_incremental_model_obeys_its_law() {
        let depth = |n: f64| DISCS.incremental_depth(LOAD * n);
        for revolutions in [200.0, 1500.0, 20_000.0] {
            let rate = (depth(revolutions + 1.0) - depth(revolutions - 1.0)) / 2.0;
            let track = DISCS.half_width.max(DISCS.track(depth(revolutions)));
            assert_relative_eq!(rate, 2e-12 * 0.005 * LOAD / (2.0 * track), max_relative = 1e-6);
        }
    }

    /// Far beyond the turn both models are the same.
    #[test]
    fn the_line_load_is_the_limit() {
        let (line, incremental) = (DISCS.line_load_depth(3e11), DISCS.incremental_depth(3e11));
        assert_relative_eq!(line, incremental, max_relative = 1e-4);
    }
}
