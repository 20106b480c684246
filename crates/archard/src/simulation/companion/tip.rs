//! A tip or an edge: until it is worn, pressures converge slowly there, or have no bound.

use crate::simulation::history::{PEAK_PRESSURE, is_depth};

/// The least order: pressures without bound have none.
const LEAST: f64 = 0.05;

/// Where a body is sharp.
#[derive(Debug, Clone, PartialEq)]
pub struct Tip {
    /// The power n of the distance by which the body recedes from there: 1 < n < 2 where the pressure has a cusp, 1 at the tip
    /// of a cone, 0 at an edge.
    pub exponent: f64,
    /// The columns of the depths of points that stay in the contact, so that they wear as the pressure is.
    pub stay: Vec<String>,
    /// The column of the depth that wears the tip away.
    pub depth: String,
    /// Whether it lies alike among the elements of all grids: at the middle of the frame.
    pub centred: bool,
    /// From which depth (m) on it is blunt as far as the elements see.
    pub blunt: f64,
}

impl Tip {
    /// The same on so many times as many elements along each axis.
    pub(super) fn on_finer(&self, finer: f64) -> Self {
        Self { blunt: self.blunt * finer.powf(-self.exponent), ..self.clone() }
    }

    /// Whether elements do not see that it has worn so deep (m).
    pub(super) fn is_sharp(&self, worn: f64) -> bool {
        worn <= self.blunt
    }

    /// The order by which a column converges where the tip has worn so deep (m); `None` for one that it does not slow down.
    /// Depths remember what was worn while elements did not see the blunt tip, and pressures follow from depths. Half of the
    /// exponent is below what depths showed: 0.8 to 0.9 for 1 and 1.5.
    pub fn order(&self, column: &str, worn: f64) -> Option<f64> {
        let [has_edge, is_sharp] = [self.exponent == 0.0, self.is_sharp(worn)];
        let of_depth = is_depth(column);
        let stays = self.stay.iter().any(|name| name == column);
        let of_pressure = column.ends_with("_Pa");
        let order = match column {
            PEAK_PRESSURE if has_edge && is_sharp => 0.0,
            _ if has_edge => return None,
            _ if !of_depth && !of_pressure => return None,
            _ if is_sharp && (of_pressure || stays) => self.exponent - 1.0,
            _ if stays => 0.5 * self.exponent,
            _ => self.exponent,
        };
        Some(order.max(LEAST))
    }
}

#[cfg(test)]
mod tests {
    use super::Tip;

    #[test]
    fn what_a_tip_slows_down() {
        let tip = |exponent: f64, stays: bool| Tip {
            exponent,
            stay: ["wear_depth_m", "wear_depth_pin_m"]
                .into_iter()
                .filter(|_| stays)
                .map(str::to_owned)
                .collect(),
            depth: "wear_depth_m".to_owned(),
            centred: true,
            blunt: 1e-6,
        };
        for (exponent, stays, column, worn, expected) in [
            (1.5, false, "centre_pressure_Pa", 0.0, Some(0.5)),
            (1.5, true, "wear_depth_pin_m", 1e-7, Some(0.5)),
            (1.5, false, "wear_depth_m", 1e-7, Some(1.5)),
            (1.5, true, "wear_depth_m", 2e-6, Some(0.75)),
            (1.5, true, "wear_depth_disc_m", 1e-7, Some(1.5)),
            (1.5, false, "centre_pressure_Pa", 2e-6, Some(1.5)),
            (1.5, false, "approach_m", 0.0, None),
            (1.0, false, "peak_pressure_Pa", 0.0, Some(0.05)),
            (0.0, true, "peak_pressure_Pa", 0.0, Some(0.05)),
            (0.0, true, "centre_pressure_Pa", 0.0, None),
        ] {
            let found = tip(exponent, stays).order(column, worn);
            assert_eq!(found, expected, "{exponent} {column} {worn}");
        }
        // Elements of a quarter see an eighth of the depth.
        assert!((8.0 * tip(1.5, true).on_finer(4.0).blunt / 1e-6 - 1.0).abs() < 1e-12);
    }
}
