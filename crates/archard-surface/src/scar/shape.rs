//! The worn section that a model computes, and how it grows.

use super::worn::deepest;

/// Depths below this share of the greatest are no wear: a profilometer does not see them, and a computed section ends there. Readings
/// are not known better against it.
pub(super) const LEAST: f64 = 1e-3;

/// Parts of a section, in numbers of its own.
const FINE: i32 = 500;

/// A computed worn section: depths along a line, and how they grow with the section.
///
/// Worn twice as much, a section of the same kind is 2^p times as deep and 2^(1-p) times as wide: p is 1 of a contact whose width stays, 2/3
/// of a ring on a block.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    places: Vec<f64>,
    worn: Vec<f64>,
    deepening: f64,
    extent: [f64; 2],
}

impl Shape {
    /// Of depths (m) at rising places (m) from the middle of the contact, and the exponent by which the greatest depth grows with the
    /// section. `None` if nothing is worn, or the numbers are no section.
    pub fn new(places: Vec<f64>, worn: Vec<f64>, deepening: f64) -> Option<Self> {
        let rising = places.windows(2).all(|pair| pair[0] < pair[1]);
        let most = worn.iter().copied().fold(0.0, f64::max);
        let finite = places.iter().chain(&worn).chain([&deepening]).all(|own| own.is_finite());
        if places.len() != worn.len() || !rising || !finite || most <= 0.0 {
            return None;
        }
        let least = LEAST * most;
        let worn: Vec<f64> =
            worn.into_iter().map(|own| if own > least { own } else { 0.0 }).collect();
        let first = worn.iter().position(|own| *own > 0.0)?;
        let last = worn.iter().rposition(|own| *own > 0.0)?;
        // Depths fall to zero over the step beyond the last one.
        let ends = [first.saturating_sub(1), (last + 1).min(places.len() - 1)];
        let extent = ends.map(|at| places[at]);
        (extent[0] < extent[1]).then(|| Self {
            deepening: deepening.clamp(0.0, 1.0),
            places,
            worn,
            extent,
        })
    }

    /// The last of the steps of a run, each depths (m) at rising places (m), and how depths grew from the step that had worn about half of it.
    /// `None` if nothing is worn.
    pub fn of(steps: &[Vec<[f64; 2]>]) -> Option<Self> {
        let last = steps.last()?;
        let [places, worn] = [0, 1].map(|i| last.iter().map(|own| own[i]).collect());
        let grown = steps.iter().filter_map(|step| {
            let trapezium =
                |ends: &[[f64; 2]]| 0.5 * (ends[1][0] - ends[0][0]) * (ends[0][1] + ends[1][1]);
            let section: f64 = step.windows(2).map(trapezium).sum();
            let deepest = step.iter().map(|own| own[1]).fold(0.0, f64::max);
            (section > 0.0 && deepest > 0.0).then_some([section, deepest])
        });
        Self::new(places, worn, deepening(&grown.collect::<Vec<_>>()))
    }

    /// The exponent by which depths grow with the section; widths grow by the rest to one.
    pub fn exponent(&self) -> f64 {
        self.deepening
    }

    /// Factors of widths and depths where the section has grown by a factor.
    fn factors(&self, grown: f64) -> [f64; 2] {
        [grown.powf(1.0 - self.deepening), grown.powf(self.deepening)]
    }

    /// What is worn off (m) at a place (m) where the section has grown by a factor.
    pub fn worn(&self, place: f64, grown: f64) -> f64 {
        let [wide, deep] = self.factors(grown);
        let place = place / wide;
        let next = self.places.partition_point(|known| *known < place);
        if next == 0 || next == self.places.len() {
            return 0.0;
        }
        let [from, to] = [self.places[next - 1], self.places[next]];
        let share = (place - from) / (to - from);
        deep * (self.worn[next - 1] + share * (self.worn[next] - self.worn[next - 1]))
    }

    /// From where to where it is worn (m) where the section has grown by a factor.
    pub fn extent(&self, grown: f64) -> [f64; 2] {
        self.extent.map(|place| place * self.factors(grown)[0])
    }

    /// Its depth (m) by the parabola through its middle half; `None` of too few points.
    pub fn depth(&self) -> Option<f64> {
        let places = self.fine();
        let depths: Vec<f64> = places.iter().map(|place| self.worn(*place, 1.0)).collect();
        let [low, high] = self.extent;
        let [middle, quarter] = [0.5 * (low + high), 0.25 * (high - low)];
        let weights = deepest(&places, &depths, [middle - quarter, middle + quarter])?;
        Some(weights.iter().zip(&depths).map(|(weight, depth)| weight * depth).sum())
    }

    /// Its width (m) at a share of that depth, where the section has grown by a factor; `None` of too few points.
    pub fn width_at(&self, share: f64, grown: f64) -> Option<f64> {
        let level = share * self.depth()?;
        let places = self.fine();
        let worn = |place: &&f64| self.worn(**place, 1.0) > level;
        let first = places.iter().find(worn)?;
        let last = places.iter().rfind(worn)?;
        let step = places[1] - places[0];
        // To where the line between two places comes down to the level.
        let beyond = |place: f64, step: f64| {
            let [inside, outside] = [self.worn(place, 1.0), self.worn(place + step, 1.0)];
            step.abs() * (inside - level) / (inside - outside)
        };
        let width = last - first + beyond(*first, -step) + beyond(*last, step);
        Some(width * self.factors(grown)[0])
    }

    /// Places (m) over the section and some way beyond it, closer than those of any profile.
    fn fine(&self) -> Vec<f64> {
        let [low, high] = self.extent;
        (-FINE..=2 * FINE).map(|i| low + (high - low) * f64::from(i) / f64::from(FINE)).collect()
    }

    /// Its width (m) where the section has grown by a factor.
    pub fn width(&self, grown: f64) -> f64 {
        let [low, high] = self.extent(grown);
        high - low
    }

    /// Its greatest depth (m) where the section has grown by a factor.
    pub fn deepest(&self, grown: f64) -> f64 {
        self.factors(grown)[1] * self.worn.iter().copied().fold(0.0, f64::max)
    }

    /// Its section (m^2), by the trapezoidal rule, where it has grown by a factor.
    pub fn section(&self, grown: f64) -> f64 {
        self.section_within(grown, [f64::NEG_INFINITY, f64::INFINITY])
    }

    /// The section (m^2) between two places (m).
    pub fn section_within(&self, grown: f64, [low, high]: [f64; 2]) -> f64 {
        let wide = self.factors(grown)[0];
        let inner = self.places.iter().map(|place| place * wide);
        let mut places: Vec<f64> = inner.filter(|place| low < *place && *place < high).collect();
        places.splice(0..0, [low].into_iter().filter(|own| own.is_finite()));
        places.extend([high].into_iter().filter(|own| own.is_finite()));
        let piece = |ends: &[f64]| {
            0.5 * (ends[1] - ends[0]) * (self.worn(ends[0], grown) + self.worn(ends[1], grown))
        };
        places.windows(2).map(piece).sum()
    }
}

/// The exponent by which the greatest depth grows with the section, from the one next to half of the last on, of sections and depths; one
/// where there is no other.
fn deepening(grown: &[[f64; 2]]) -> f64 {
    let Some([last, deepest]) = grown.last() else { return 1.0 };
    let from_half = |own: &&[f64; 2]| (own[0] / last - 0.5).abs();
    let earlier = grown.iter().filter(|own| own[0] < *last);
    let half = earlier.min_by(|one, other| from_half(one).total_cmp(&from_half(other)));
    half.map_or(1.0, |[section, depth]| (deepest / depth).ln() / (last / section).ln())
}

#[cfg(test)]
mod tests {
    use super::Shape;

    /// A ring of radius R in a flat: depth c^2 / 8R over a width c, section c^3 / 12R.
    #[test]
    fn a_ring_grows_as_it_does() {
        let radius = 20e-3;
        let depth = |x: f64, c: f64| ((0.25 * c * c - x * x) / (2.0 * radius)).max(0.0);
        let c = 2.6e-3;
        let places: Vec<f64> = (-200..=200).map(|i| 1e-5 * f64::from(i)).collect();
        let step = |share: f64| -> Vec<[f64; 2]> {
            let chord = c * share.cbrt();
            places.iter().map(|x| [*x, depth(*x, chord)]).collect()
        };
        let shape = Shape::of(&[0.0, 0.2, 0.45, 0.8, 1.0].map(step)).unwrap();
        assert!((shape.exponent() - 2.0 / 3.0).abs() < 1e-3, "{shape:?}");
        let section = c.powi(3) / (12.0 * radius);
        assert!((shape.section(1.0) / section - 1.0).abs() < 1e-4);
        assert!((shape.section(1.7) / section - 1.7).abs() < 2e-4);
        let wide = c * 1.7f64.cbrt();
        for x in [0.0, 0.4e-3, -1.1e-3] {
            assert!((shape.worn(x, 1.7) / depth(x, wide) - 1.0).abs() < 3e-3, "{x}");
        }
        assert!((shape.section_within(1.0, [0.0, 1.0]) / section - 0.5).abs() < 1e-3);
    }

    #[test]
    fn what_is_no_section_is_refused() {
        let none =
            |places: [f64; 2], worn: [f64; 2]| Shape::new(places.to_vec(), worn.to_vec(), 1.0);
        assert!(none([0.0, 1.0], [0.0, 0.0]).is_none());
        assert!(none([1.0, 0.0], [0.0, 1.0]).is_none());
        assert!(none([0.0, 1.0], [0.0, f64::NAN]).is_none());
    }
}
