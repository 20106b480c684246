//! Where the fretting of a sphere ends: worn in the annulus of slip until the stick zone alone
//! carries the load.
//!
//! I. G. Goryacheva, P. T. Rajeev and T. N. Farris, *J. Tribol.* 123 (2001) 848; M. Ciavarella and
//! D. A. Hills, *Eur. J. Mech. A* 18 (1999) 491; V. L. Popov, *Sci. Rep.* 4 (2014) 3749, whose
//! argument it is: with the stick zone, of radius c, nothing wears inside, so that the shape there
//! and with it the pressures are those of a sphere cut off at c,
//!
//! ```text
//! p(r) = (2 E*/(pi R)) sqrt(c^2 - r^2) + (E* d/pi) / sqrt(c^2 - r^2),  r < c,
//! d = approach - c^2/R,  approach = F/(2 E* c) + c^2/(3 R).
//! ```
//!
//! Outside nothing presses any more; the depth is what it takes to hold the surfaces just apart,
//! w(r) = approach - r^2/(2 R) - u(r), with u the displacement under those pressures.
//!
//! Under constant load and a tangential force of constant amplitude the stick zone does keep its
//! radius while the annulus wears, if the bodies are elastically similar: it is
//! [`super::cattaneo_mindlin::PartialSlip::stick_radius`] at that amplitude. At a constant amplitude
//! of the shift it would widen a little as the bodies come closer.

use std::f64::consts::{FRAC_2_PI, PI};

use super::Hertz;

/// The final state of a sphere that frets around a stick zone under constant load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WornOut {
    /// Radius of the stick zone, all that is left of the contact (m).
    pub stick_radius: f64,
    /// Approach of the bodies from first touch (m).
    pub approach: f64,
    /// Radius of the worn annulus (m).
    pub scar_radius: f64,
    /// Distance from the centre where the wear is deepest (m).
    pub deepest_place: f64,
    radius: f64,
    contact_modulus: f64,
    /// How far the sphere is pressed in beyond the approach at which it would just touch at the edge
    /// of the stick zone (m).
    excess: f64,
}

impl WornOut {
    /// The end of fretting with a combined radius (m), contact modulus E* (Pa), load (N) and radius
    /// of the stick zone (m).
    ///
    /// `None` unless all are positive and finite and the stick zone no wider than the contact of Hertz.
    pub fn new(radius: f64, contact_modulus: f64, load: f64, stick_radius: f64) -> Option<Self> {
        let hertz = Hertz::from_load([1.0 / radius; 2], contact_modulus, load)?;
        let unworn = hertz.semi_axes[0];
        if !(stick_radius > 0.0 && stick_radius <= unworn) {
            return None;
        }
        // F/(2 E* c) = 2 a^3/(3 R c): exactly none is left over when all sticks.
        let ratio = unworn / stick_radius;
        let unit = stick_radius * stick_radius / radius;
        let excess = unit * 2.0 / 3.0 * (ratio - 1.0) * (ratio * ratio + ratio + 1.0);
        let mut state = Self {
            stick_radius,
            approach: excess + unit,
            scar_radius: stick_radius,
            deepest_place: stick_radius,
            radius,
            contact_modulus,
            excess,
        };
        if excess > 0.0 {
            // The depth is a concave function of the distance and negative where the sphere, not
            // pressed anywhere, would be clear of the other body.
            let clear = (2.0 * radius * state.approach).sqrt();
            state.deepest_place = last_positive(stick_radius, clear, |r| state.slope(r));
            state.scar_radius = last_positive(state.deepest_place, clear, |r| state.height(r));
        }
        Some(state)
    }

    /// Pressure (Pa) at a distance (m) from the centre; none outside the stick zone, unbounded towards
    /// its edge.
    pub fn pressure(&self, distance: f64) -> f64 {
        if distance >= self.stick_radius {
            return 0.0;
        }
        let root = (self.stick_radius.powi(2) - distance * distance).sqrt();
        self.contact_modulus / PI * (2.0 * root / self.radius + self.excess / root)
    }

    /// Displacement (m) of the surfaces into both bodies, together, at a distance (m) from the centre.
    ///
    /// Those of Hertz and of a flat punch added (Johnson, *Contact Mechanics*, section 3.4).
    pub fn displacement(&self, distance: f64) -> f64 {
        let (c, r) = (self.stick_radius, distance);
        if r <= c {
            return self.approach - r * r / (2.0 * self.radius);
        }
        let inside = FRAC_2_PI * (c / r).asin();
        let root = (r * r - c * c).sqrt();
        let bulge = (2.0 * c * c - r * r) * inside + FRAC_2_PI * c * root;
        self.excess * inside + bulge / (2.0 * self.radius)
    }

    /// Wear depth (m) at a distance (m) from the centre.
    pub fn depth(&self, distance: f64) -> f64 {
        if distance <= self.stick_radius || distance >= self.scar_radius {
            return 0.0;
        }
        self.height(distance).max(0.0)
    }

    /// Largest wear depth (m).
    pub fn greatest_depth(&self) -> f64 {
        self.depth(self.deepest_place)
    }

    /// Worn volume (m^3).
    pub fn volume(&self) -> f64 {
        let (c, b) = (self.stick_radius, self.scar_radius);
        let outside = FRAC_2_PI * (c / b).acos();
        let root = ((b - c) * (b + c)).sqrt();
        let sphere =
            0.25 * b.powi(4) * outside + 0.25 * FRAC_2_PI * c * root * (root * root - c * c);
        (PI * (sphere / self.radius - FRAC_2_PI * self.excess * c * root)).max(0.0)
    }

    /// The approach less the sphere and the displacement (m), outside the stick zone.
    fn height(&self, r: f64) -> f64 {
        let c = self.stick_radius;
        let outside = FRAC_2_PI * (c / r).acos();
        let root = ((r - c) * (r + c)).sqrt();
        let sphere = (r * r - 2.0 * c * c) * outside + FRAC_2_PI * c * root;
        self.excess * outside - sphere / (2.0 * self.radius)
    }

    /// The slope of [`Self::height`], times the distance from the edge of the stick zone: it starts
    /// from a positive number and falls.
    fn slope(&self, r: f64) -> f64 {
        let c = self.stick_radius;
        let outside = FRAC_2_PI * (c / r).acos();
        let root = ((r - c) * (r + c)).sqrt();
        let sphere = r * outside + FRAC_2_PI * c * root / r;
        FRAC_2_PI * self.excess * c / r - root * sphere / self.radius
    }
}

/// The end of the stretch from `low` on where a function that falls through zero once before `high`
/// is positive, by bisection.
fn last_positive(mut low: f64, mut high: f64, function: impl Fn(f64) -> f64) -> f64 {
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return low;
        }
        if function(middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use approx::assert_relative_eq;

    use super::WornOut;
    use crate::body::{Material, contact_modulus};
    use crate::closed_form::Hertz;
    use crate::closed_form::cattaneo_mindlin::PartialSlip;

    const RADIUS: f64 = 0.01;
    const LOAD: f64 = 50.0;

    /// Steel on steel.
    fn modulus() -> f64 {
        let steel = Material { young: 210e9, poisson: 0.3 };
        contact_modulus([Some(&steel); 2])
    }

    fn hertz() -> Hertz {
        Hertz::from_load([1.0 / RADIUS; 2], modulus(), LOAD).unwrap()
    }

    /// The end with a stick zone of that share of the contact of Hertz.
    fn worn_out(share: f64) -> WornOut {
        WornOut::new(RADIUS, modulus(), LOAD, share * hertz().semi_axes[0]).unwrap()
    }

    /// Midpoint sum of a function from 0 to 1.
    fn integral(function: impl Fn(f64) -> f64) -> f64 {
        let count = 20_000;
        let place = |i: i32| (f64::from(i) + 0.5) / f64::from(count);
        (0..count).map(|i| function(place(i))).sum::<f64>() / f64::from(count)
    }

    /// With r = c sin t; the edge is left out by the sum.
    #[test]
    fn pressures_carry_the_load() {
        for share in [0.2, 0.6, 0.95] {
            let state = worn_out(share);
            let c = state.stick_radius;
            let sum = integral(|s| {
                let (sine, cosine) = (FRAC_PI_2 * s).sin_cos();
                state.pressure(c * sine) * sine * cosine
            });
            assert_relative_eq!(PI * PI * c * c * sum, LOAD, max_relative = 1e-7);
        }
    }

    /// The displacement under the pressures by its definition, u = (1/(pi E*)) times the integral of
    /// p over the directions from the place and the distances along them. The chord, of half length h
    /// about its middle, is run through as h sin s, which takes away the singularity at its ends.
    fn summed_displacement(state: &WornOut, place: f64) -> f64 {
        let c = state.stick_radius;
        let widest = if place > c { (c / place).asin() } else { FRAC_PI_2 };
        let (count, step) = (400, 1.0 / 400.0);
        let mut sum = 0.0;
        for i in 0..count {
            // Directions about that of the centre; from outside they end where chords shrink to none.
            let angle = widest * (PI * (f64::from(i) + 0.5) * step - FRAC_PI_2).sin();
            let weight = widest * (PI * (f64::from(i) + 0.5) * step - FRAC_PI_2).cos() * PI * step;
            let off = place * angle.sin();
            let half = (c * c - off * off).sqrt();
            for j in 0..count {
                let (sine, cosine) = (PI * (f64::from(j) + 0.5) * step - FRAC_PI_2).sin_cos();
                let distance = off.hypot(half * sine);
                sum += weight * state.pressure(distance) * half * cosine * PI * step;
            }
        }
        sum / (PI * state.contact_modulus)
    }

    #[test]
    fn surfaces_touch_inside_and_are_just_apart_in_the_scar() {
        let state = worn_out(0.6);
        let gap = |r: f64| r * r / (2.0 * RADIUS) - state.approach;
        for share in [0.0, 0.35, 0.8, 1.2, 1.6] {
            let r = share * state.stick_radius;
            let summed = summed_displacement(&state, r);
            assert_relative_eq!(summed, state.displacement(r), max_relative = 1e-4);
            assert_relative_eq!(summed, -gap(r) - state.depth(r), max_relative = 1e-4);
        }
        let beyond = 1.3 * state.scar_radius;
        assert!(gap(beyond) + state.displacement(beyond) > 0.0);
        assert_eq!(state.depth(beyond), 0.0);
    }

    #[test]
    fn the_annulus_is_worn_from_the_stick_zone_to_its_edge() {
        let state = worn_out(0.6);
        let (c, b) = (state.stick_radius, state.scar_radius);
        let greatest = state.greatest_depth();
        assert!(hertz().semi_axes[0] < b);
        assert!(state.depth(c * (1.0 + 1e-10)) < 1e-4 * greatest);
        assert!(state.depth(b * (1.0 - 1e-10)) < 1e-4 * greatest);
        let depths = (1..2000).map(|i| state.depth(c + (b - c) * f64::from(i) / 2000.0));
        assert_relative_eq!(depths.fold(0.0, f64::max), greatest, max_relative = 1e-6);
        for step in [-1e-4, 1e-4] {
            assert!(state.depth(state.deepest_place * (1.0 + step)) < greatest);
        }
    }

    /// With r^2 = c^2 + (b^2 - c^2) s^2, in which the steep start of the depth is smooth.
    #[test]
    fn depths_sum_to_the_volume() {
        for share in [0.1, 0.6, 0.99] {
            let state = worn_out(share);
            let [inner, outer] = [state.stick_radius, state.scar_radius].map(|r| r * r);
            let sum = integral(|s| s * state.depth((inner + (outer - inner) * s * s).sqrt()));
            let volume = 2.0 * PI * (outer - inner) * sum;
            assert_relative_eq!(state.volume(), volume, max_relative = 1e-6);
        }
    }

    /// The formulas of the approach as they stand, and the limit of a contact that sticks all over.
    #[test]
    fn between_a_flat_punch_and_hertz() {
        let state = worn_out(0.3);
        let c = state.stick_radius;
        let approach = LOAD / (2.0 * modulus() * c) + c * c / (3.0 * RADIUS);
        assert_relative_eq!(state.approach, approach, max_relative = 1e-12);

        let (stuck, hertz) = (worn_out(1.0), hertz());
        assert_relative_eq!(stuck.approach, hertz.approach, max_relative = 1e-12);
        for r in [0.0, 0.5, 0.9].map(|share| share * hertz.semi_axes[0]) {
            assert_relative_eq!(stuck.pressure(r), hertz.pressure([r, 0.0]), max_relative = 1e-12);
        }
        assert_eq!((stuck.volume(), stuck.greatest_depth()), (0.0, 0.0));
        assert_eq!(stuck.scar_radius, stuck.stick_radius);
        let nearly = worn_out(1.0 - 1e-6);
        assert_relative_eq!(nearly.scar_radius, hertz.semi_axes[0], max_relative = 1e-5);
    }

    /// The stick zone at a constant amplitude of the force carries mu P less that amplitude at the
    /// limit of friction, on the worn bodies as on new ones: the rim of the pressures of Hertz over it.
    #[test]
    fn the_stick_zone_is_that_of_partial_slip() {
        let steel = Material { young: 210e9, poisson: 0.3 };
        let contact = PartialSlip::new(RADIUS, [Some(&steel); 2], LOAD, 0.6).unwrap();
        let state = WornOut::new(RADIUS, modulus(), LOAD, contact.stick_radius(20.0)).unwrap();
        let inside =
            Hertz::from_approach([1.0 / RADIUS; 2], modulus(), state.stick_radius.powi(2) / RADIUS);
        assert_relative_eq!(0.6 * (LOAD - inside.unwrap().load), 20.0, max_relative = 1e-10);
    }

    #[test]
    fn nothing_without_load_or_with_a_stick_zone_beyond_hertz() {
        let a = hertz().semi_axes[0];
        for (load, stick_radius) in [(0.0, a), (LOAD, 0.0), (LOAD, 1.01 * a), (LOAD, f64::NAN)] {
            assert_eq!(WornOut::new(RADIUS, modulus(), load, stick_radius), None);
        }
    }
}
