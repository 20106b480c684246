//! Involute spur gears, and the path along which two of them touch (ISO 21771).

use std::f64::consts::PI;

use archard::parameters::Invalid;

use crate::laws::Misfit;

/// By how much shifts may differ from those of teeth without backlash: drawings give four decimals of the two.
const ROUNDED: f64 = 1e-4;

/// A spur gear with involute flanks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gear {
    /// Module (m).
    pub module: f64,
    /// Number of teeth.
    pub teeth: f64,
    /// Profile shift over the module.
    pub shift: f64,
    /// Diameter (m) of the tips.
    pub tip_diameter: f64,
    /// Pressure angle (rad) of the reference profile.
    pub pressure_angle: f64,
}

/// The involute of an angle (rad).
fn involute(angle: f64) -> f64 {
    angle.tan() - angle
}

impl Gear {
    /// Radius (m) of the base circle.
    pub fn base_radius(&self) -> f64 {
        0.5 * self.module * self.teeth * self.pressure_angle.cos()
    }

    /// The gear, if it has flanks.
    ///
    /// # Errors
    /// If it has no teeth, its tips lie below the base circle, or the teeth end in a point before.
    pub fn checked(&self) -> Result<(), Invalid> {
        if !(self.teeth >= 3.0 && self.teeth.fract() == 0.0) {
            let message = "a gear has three teeth or more, outside; internal gears are not known";
            return Err(Invalid::new("teeth", message));
        }
        let (base, tip) = (2.0 * self.base_radius(), self.tip_diameter);
        if tip <= base {
            let message = format!(
                "the tips lie below the base circle, whose diameter is {:.4} mm: the teeth have no involute",
                1e3 * base
            );
            return Err(Invalid::new("tip_diameter", message));
        }
        let at_tip = (base / tip).acos();
        let angle = self.pressure_angle;
        let half = (0.5 * PI + 2.0 * self.shift * angle.tan()) / self.teeth + involute(angle)
            - involute(at_tip);
        if half <= 0.0 {
            let message = "the teeth end in a point before they reach this diameter";
            return Err(Invalid::new("tip_diameter", message));
        }
        Ok(())
    }
}

/// Two gears in mesh, and the path along which their flanks touch: distances (m) from T1, where the line of action touches the base circle
/// of gear 1, towards T2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// The gears; the first drives.
    pub gears: [Gear; 2],
    /// Working pressure angle (rad).
    pub working_angle: f64,
    /// Distance from T1 to T2.
    pub length: f64,
    /// Distance from a tooth to the next along the path.
    pub pitch: f64,
    /// Where teeth begin to touch: A.
    pub start: f64,
    /// Where they end to: E.
    pub end: f64,
    /// Where they roll without sliding: C.
    pub pitch_point: f64,
    /// Clearance (m) between flanks that do not touch, along the pitch circles.
    pub backlash: f64,
}

impl Pair {
    /// Gears whose axes are so far (m) apart.
    ///
    /// # Errors
    /// If the gears do not fit each other at this distance: other teeth, flanks that jam, tips that reach below the base circle of the other
    /// gear, or a tooth that lets go before the next one touches.
    pub fn new(gears: [Gear; 2], centre_distance: f64) -> Result<Self, Misfit> {
        for (which, gear) in gears.iter().enumerate() {
            gear.checked().map_err(|invalid| Misfit::of(which, invalid))?;
        }
        let [one, two] = gears;
        if one.module != two.module || one.pressure_angle != two.pressure_angle {
            let message = "both gears need the same module and pressure angle";
            return Err(Misfit::of(1, Invalid::new("module", message)));
        }
        let wrong = |message: String| Misfit::from(Invalid::new("centre_distance", message));
        let base = [one.base_radius(), two.base_radius()];
        let cosine = (base[0] + base[1]) / centre_distance;
        if cosine >= 1.0 {
            let least = 1e3 * (base[0] + base[1]);
            return Err(wrong(format!(
                "the base circles overlap: more than {least:.4} mm are needed"
            )));
        }
        let working_angle = cosine.acos();
        let angle = one.pressure_angle;
        let teeth = one.teeth + two.teeth;
        // Two flanks and two gears: the backlash is the pitch less the thickness of both teeth, on the pitch circles.
        let open = involute(working_angle)
            - involute(angle)
            - 2.0 * (one.shift + two.shift) / teeth * angle.tan();
        let pitch_diameter = 2.0 * base[0] / cosine;
        let backlash = open * teeth * pitch_diameter / one.teeth;
        if open * teeth < -2.0 * ROUNDED * angle.tan() {
            let message = format!(
                "the flanks jam: teeth are {:.4} mm thicker than the gaps; larger, or smaller shifts",
                -1e3 * backlash
            );
            return Err(wrong(message));
        }
        let length = centre_distance * working_angle.sin();
        let reach = |at: usize| {
            let tip = 0.5 * gears[at].tip_diameter;
            (tip * tip - base[at] * base[at]).sqrt()
        };
        let (start, end) = (length - reach(1), reach(0));
        for (which, beyond) in [(1, start <= 0.0), (0, end >= length)] {
            if beyond {
                let most = 2e3 * base[which].hypot(length);
                let message = format!(
                    "the tips reach below the base circle of the other gear and interfere there: {most:.4} mm at the most"
                );
                return Err(Misfit::of(which, Invalid::new("tip_diameter", message)));
            }
        }
        let pitch = PI * one.module * angle.cos();
        if end - start < pitch {
            let ratio = ((end - start) / pitch).max(0.0);
            let message = format!(
                "the contact ratio is {ratio:.3}: a pair of teeth lets go before the next one touches; smaller, or larger tips"
            );
            return Err(wrong(message));
        }
        let pitch_point = base[0] * working_angle.tan();
        Ok(Self { gears, working_angle, length, pitch, start, end, pitch_point, backlash })
    }

    /// How many pairs of teeth touch on the mean.
    pub fn contact_ratio(&self) -> f64 {
        (self.end - self.start) / self.pitch
    }

    /// Radii of curvature (m) of both flanks at a place of the path.
    pub fn radii(&self, place: f64) -> [f64; 2] {
        [place, self.length - place]
    }

    /// Speeds of the line of contact over both flanks at a place (m), over the angular speed of gear 1.
    pub fn speeds(&self, place: f64) -> [f64; 2] {
        let [one, two] = self.radii(place);
        [one, two * self.gears[0].teeth / self.gears[1].teeth]
    }

    /// Diameters (m) of both gears at a place of the path.
    pub fn diameters(&self, place: f64) -> [f64; 2] {
        let radii = self.radii(place);
        [0, 1].map(|at| 2.0 * self.gears[at].base_radius().hypot(radii[at]))
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use approx::assert_relative_eq;

    use super::{Gear, Pair};

    /// The test gears of type C of the FZG: module 4.5 mm, 16 and 24 teeth.
    pub(crate) fn type_c() -> [Gear; 2] {
        let gear = |teeth, shift, tip_diameter| Gear {
            module: 4.5e-3,
            teeth,
            shift,
            tip_diameter,
            pressure_angle: 20f64.to_radians(),
        };
        [gear(16.0, 0.1817, 82.46e-3), gear(24.0, 0.1715, 118.36e-3)]
    }

    pub(crate) fn pair() -> Pair {
        Pair::new(type_c(), 91.5e-3).unwrap()
    }

    #[test]
    fn the_path_is_that_of_the_test_gears() {
        let pair = pair();
        assert_relative_eq!(pair.length, 34.925206e-3, max_relative = 1e-7);
        assert_relative_eq!(pair.pitch, 13.284591e-3, max_relative = 1e-7);
        assert_relative_eq!(pair.start, 4.472298e-3, max_relative = 1e-6);
        assert_relative_eq!(pair.pitch_point, 13.970082e-3, max_relative = 1e-7);
        assert_relative_eq!(pair.end, 23.569389e-3, max_relative = 1e-7);
        assert_relative_eq!(pair.contact_ratio(), 1.4375, max_relative = 1e-4);
        // Both flanks pass the pitch point at one speed, on the pitch circles.
        let [one, two] = pair.speeds(pair.pitch_point);
        assert_relative_eq!(one, two, max_relative = 1e-12);
        let [one, two] = pair.diameters(pair.pitch_point);
        assert_relative_eq!(one + two, 2.0 * 91.5e-3, max_relative = 1e-12);
        assert_relative_eq!(one / two, 16.0 / 24.0, max_relative = 1e-12);
        assert!(pair.backlash.abs() < 1e-6, "{}", pair.backlash);
    }

    #[test]
    fn gears_that_do_not_fit_are_refused() {
        let refused = |change: &dyn Fn(&mut [Gear; 2]), distance: f64| {
            let mut gears = type_c();
            change(&mut gears);
            let invalid = Pair::new(gears, distance).expect_err("gears that do not fit");
            (invalid.cause.parameter.to_string(), invalid.cause.message.clone())
        };
        let none = |_: &mut [Gear; 2]| ();
        let because = |(_, message): (String, String), part: &str| {
            assert!(message.contains(part), "{message}");
        };
        because(refused(&none, 80e-3), "base circles overlap");
        because(refused(&none, 91.3e-3), "jam");
        because(refused(&none, 95e-3), "contact ratio");
        because(refused(&|gears| gears[1].module = 5e-3, 91.5e-3), "same module");
        let few = |gears: &mut [Gear; 2]| {
            let [one, two] = type_c();
            let gear = |teeth, tip_diameter, from| Gear { teeth, shift: 0.0, tip_diameter, ..from };
            *gears = [gear(10.0, 54e-3, one), gear(60.0, 279e-3, two)];
        };
        because(refused(&few, 157.5e-3), "interfere");
        because(refused(&|gears| gears[0].tip_diameter = 67e-3, 91.5e-3), "below the base circle");
        because(refused(&|gears| gears[0].tip_diameter = 95e-3, 91.5e-3), "end in a point");
        because(refused(&|gears| gears[0].teeth = -16.0, 91.5e-3), "internal gears");
    }
}
