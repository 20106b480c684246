//! A sphere worn flat: the geometric model of the pin on a disc.
//!
//! Without elasticity the wear removes a spherical cap of height w, whose volume
//! W = pi/3 (3 R - w) w^2 equals k F s (the paper's eq. 55). The model is late at the start, where
//! its rate of wear is infinite, and good to a percent once the scar is several times as wide as
//! the elastic contact.

use std::f64::consts::PI;

/// Volume (m^3) worn off a sphere of that radius (m) at a wear depth (m).
pub fn volume(radius: f64, depth: f64) -> f64 {
    PI / 3.0 * (3.0 * radius - depth) * depth * depth
}

/// Wear depth (m) of a sphere of that radius (m) that has lost a volume (m^3): the inverse of
/// [`volume`]; the whole diameter once nothing is left.
pub fn depth(radius: f64, volume: f64) -> f64 {
    let target = (3.0 * volume / (PI * radius.powi(3))).sqrt();
    if target >= 2.0 {
        return 2.0 * radius;
    }
    // Newton on h sqrt(3 - h) = target: concave and started below the root, so it rises to the root
    // without passing it, and products only, so it keeps its digits for tiny volumes.
    let mut h = target / 3.0_f64.sqrt();
    for _ in 0..60 {
        let root = (3.0 - h).sqrt();
        let correction = (target - h * root) * 2.0 * root / (3.0 * (2.0 - h));
        h += correction;
        if correction.abs() <= 1e-16 * h {
            break;
        }
    }
    h * radius
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{depth, volume};

    /// Independent values of eq. 55 for the pin on disc: distance (mm) and depth (um).
    const EQ_55: [[f64; 2]; 8] = [
        [5.0, 0.207803],
        [20.0, 0.415606],
        [50.0, 0.657131],
        [100.0, 0.929324],
        [200.0, 1.314265],
        [300.0, 1.609641],
        [400.0, 1.858654],
        [500.0, 2.078040],
    ];

    #[test]
    fn depths_of_the_paper() {
        for [distance, micrometres] in EQ_55 {
            let worn = 1.33e-13 * 10.2 * distance * 1e-3;
            assert_relative_eq!(depth(50e-3, worn) * 1e6, micrometres, epsilon = 5.1e-7);
        }
    }

    #[test]
    fn depth_inverts_volume() {
        for h in [1e-150, 1e-12, 1e-4, 0.3, 1.0, 1.7, 1.99] {
            let radius = 0.05;
            assert_relative_eq!(
                depth(radius, volume(radius, h * radius)),
                h * radius,
                max_relative = 1e-12
            );
        }
    }

    #[test]
    fn nothing_and_everything() {
        assert_eq!(depth(1.0, 0.0), 0.0);
        assert_eq!(depth(1.0, 10.0), 2.0);
    }
}
