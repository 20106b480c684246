//! Simple models of the wear of twin discs that slide all over: depth over revolutions.
//!
//! V. Hegadekatte, S. Kurzenhäuser, N. Huber and O. Kraft, *Tribol. Int.* 41 (2008) 1020, for the
//! incremental model. Both take the load as uniform across the worn track, of half width
//! b = sqrt(2 R h) on a crown of radius R worn to the depth h.

/// Depth (m) by the uniform line load alone: h = (3 k c F n / (4 sqrt(2 R)))^(2/3) with the wear
/// coefficient k (1/Pa), creepage c, load F (N) and n revolutions; R is the radius of the crown (m).
pub fn depth_of_line_load(
    coefficient: f64,
    creepage: f64,
    load: f64,
    crown: f64,
    revolutions: f64,
) -> f64 {
    (3.0 * coefficient * creepage * load * revolutions / (4.0 * (2.0 * crown).sqrt()))
        .powf(2.0 / 3.0)
}

/// Depth (m) by the incremental model, its track never narrower than the contact of Hertz of half
/// width b_0 (m): dh = k c F / (2 b) a revolution, b = max(b_0, sqrt(2 R h)).
///
/// Integrated exactly: linear in the revolutions until the worn track is as wide as the contact, then
/// h^(3/2) grows linearly.
pub fn depth_of_incremental_model(
    coefficient: f64,
    creepage: f64,
    load: f64,
    crown: f64,
    half_width: f64,
    revolutions: f64,
) -> f64 {
    let section = coefficient * creepage * load;
    let turn = half_width * half_width / (2.0 * crown);
    let revolutions_to_turn = turn * 2.0 * half_width / section;
    if revolutions <= revolutions_to_turn {
        return section * revolutions / (2.0 * half_width);
    }
    let beyond = revolutions - revolutions_to_turn;
    let rise = 3.0 * section * beyond / (4.0 * (2.0 * crown).sqrt());
    (turn.powf(1.5) + rise).powf(2.0 / 3.0)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{depth_of_incremental_model, depth_of_line_load};

    /// The twin discs of the paper's section 6.3: k = 2e-6 1/MPa, 300 N, crown 125 mm, half width after
    /// Hertz 0.8265901 mm.
    const DISCS: (f64, f64, f64, f64) = (2e-12, 300.0, 0.125, 0.8265901e-3);

    /// Independent half-space solution at 0.5 %: 26.13 um after 30,000 revolutions; the incremental
    /// model is known to agree within 0.5 %.
    #[test]
    fn the_incremental_model_ends_where_the_half_space_does() {
        let (k, load, crown, half_width) = DISCS;
        let depth = depth_of_incremental_model(k, 0.005, load, crown, half_width, 30_000.0);
        assert_relative_eq!(depth, 26.13e-6, max_relative = 5e-3);
    }

    /// dh/dn = k c F / (2 b), on both sides of the turn, by a central difference.
    #[test]
    fn the_incremental_model_obeys_its_law() {
        let (k, load, crown, half_width) = DISCS;
        let depth = |n: f64| depth_of_incremental_model(k, 0.005, load, crown, half_width, n);
        for revolutions in [200.0, 1500.0, 20_000.0] {
            let rate = (depth(revolutions + 1.0) - depth(revolutions - 1.0)) / 2.0;
            let track = half_width.max((2.0 * crown * depth(revolutions)).sqrt());
            assert_relative_eq!(rate, k * 0.005 * load / (2.0 * track), max_relative = 1e-6);
        }
    }

    /// Far beyond the turn both models are the same.
    #[test]
    fn the_line_load_is_the_limit() {
        let (k, load, crown, half_width) = DISCS;
        let n = 1e9;
        let line = depth_of_line_load(k, 0.005, load, crown, n);
        let incremental = depth_of_incremental_model(k, 0.005, load, crown, half_width, n);
        assert_relative_eq!(line, incremental, max_relative = 1e-4);
    }
}
