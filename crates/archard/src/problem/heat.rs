//! How the heat of friction warms surfaces that stream through the contact.
//!
//! The heat of each pair, traction times speed of slip, flows into the surfaces and is carried on with them. Along each
//! row the rise of temperature is the one-sided integral of [`flash_temperature`](crate::closed_form::flash_temperature),
//! exact for heat that is uniform on the way from pair to pair. Where both bodies stream, as in rolling, they share the
//! heat by their effusivities times the roots of their speeds, so that both surfaces are equally warm everywhere
//! (K. Knothe and S. Liebelt, *Wear* 189 (1995) 91). If they were not equally warm before, they are at once after they
//! touch, at the mean by those shares (M. Ertz and K. Knothe, *Wear* 253 (2002) 498). Where one body streams, its share of
//! the heat is given: that of the other follows from how this one is cooled, which is not known.
//!
//! Limits: fast surfaces, by the Peclet number. No row warms its neighbours. What the body keeps from earlier passages is
//! its temperature away from the contact, which is given.

use rayon::prelude::*;

use super::{ContactProblem, ContactState, Tangential};
use crate::body::{Body, Thermal};
use crate::closed_form::flash_temperature::{behind, peclet};
use crate::frame::{Direction, Flow, Line};
use crate::friction::Grip;
use crate::motion::{Motion, Stream};

/// Why no temperature is known at the contact.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum NoTemperature {
    /// No body says how it conducts heat.
    #[error("no body has a `thermal` table")]
    NoBody,
    /// Nothing passes at one speed.
    #[error(
        "only surfaces that pass the contact fast and at one speed have a flash temperature: those that roll, and the one with a `track_radius` or `track`"
    )]
    NoStream,
    /// The speed is missing.
    #[error("the motion does not tell the speed")]
    NoSpeed,
    /// Of the body that streams it is not known how it conducts heat.
    #[error("the body that passes the contact has no `thermal` table")]
    Stays {
        /// The body that streams: 0 for body 1, 1 for body 2.
        body: usize,
    },
    /// How much heat flows into a body is not known.
    #[error("which share of the heat flows into the body is not known")]
    NoShare {
        /// The body.
        body: usize,
    },
    /// A share that follows from the bodies is given, too.
    #[error("the share of the heat follows from both bodies, and is given, too")]
    TwoShares {
        /// The body with the share.
        body: usize,
    },
    /// Nothing makes heat.
    #[error("there is no `friction` table: nothing makes heat")]
    NoFriction,
    /// A temperature away from the contact is missing.
    #[error("the `temperature` in a `thermal` table is missing")]
    NoBulk {
        /// The body without.
        body: usize,
    },
    /// The pairs form no rows along the motion.
    #[error("the pairs do not form rows along the motion")]
    NoRows,
}

/// Which surfaces take up the heat of friction, and how fast they stream through the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Heating {
    direction: Direction,
    speed: f64,
    surfaces: [Option<Thermal>; 2],
    /// The share of the heat that flows into them.
    share: f64,
}

/// The warmed contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Flash {
    /// Rise of the temperature of the surfaces above that of the bodies (K), one value a pair.
    pub rise: Vec<f64>,
    /// Temperature (K) that the surfaces would have in the contact without friction; `None` where none is given.
    pub bulk: Option<f64>,
    /// Peclet number of the longest row in contact, of the body that is warmed deepest; `None` without contact.
    pub peclet: Option<f64>,
}

impl Heating {
    /// Of two bodies in a motion.
    ///
    /// # Errors
    /// If no surface is known to stream through the contact, or not how much of the heat it takes.
    pub fn of(bodies: &[Body; 2], motion: &Motion) -> Result<Self, NoTemperature> {
        let thermal = bodies.each_ref().map(|body| body.thermal);
        if thermal == [None, None] {
            return Err(NoTemperature::NoBody);
        }
        let Stream { direction, bodies, speed } = motion.stream().ok_or(NoTemperature::NoStream)?;
        let surfaces = [0, 1].map(|body| thermal[body].filter(|_| bodies[body]));
        let share = match surfaces {
            [Some(one), Some(two)] => match [one.share, two.share] {
                [None, None] => 1.0,
                [Some(_), _] => return Err(NoTemperature::TwoShares { body: 0 }),
                [None, Some(_)] => return Err(NoTemperature::TwoShares { body: 1 }),
            },
            [Some(one), None] => one.share.ok_or(NoTemperature::NoShare { body: 0 })?,
            [None, Some(two)] => two.share.ok_or(NoTemperature::NoShare { body: 1 })?,
            [None, None] => return Err(NoTemperature::Stays { body: usize::from(bodies[1]) }),
        };
        let speed = speed.ok_or(NoTemperature::NoSpeed)?;
        Ok(Self { direction, speed, surfaces, share })
    }

    /// Where the contact moves over the surfaces.
    pub fn direction(&self) -> Direction {
        self.direction
    }

    /// Speed of the contact over the surfaces (m/s), the mean of both where both stream.
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// Whether a body takes up heat here.
    pub fn warms(&self, body: usize) -> bool {
        self.surfaces[body].is_some()
    }

    /// The surfaces that are warmed, with their speeds (m/s) at a creepage.
    fn streaming(&self, creepage: f64) -> impl Iterator<Item = (usize, Thermal, f64)> {
        let speeds = [1.0 + 0.5 * creepage, 1.0 - 0.5 * creepage];
        // A surface that stands still, or runs backwards, is passed by nothing that this theory gives.
        let speeds = speeds.map(|relative| self.speed * relative.max(0.0));
        let surfaces = self.surfaces.into_iter().enumerate();
        surfaces.filter_map(move |(body, thermal)| Some((body, thermal?, speeds[body])))
    }

    /// Rise of temperature (K) per heat (W/m^2) and root of a length (m^(1/2)) at a creepage: 1 / sum(e sqrt(V)) for the share
    /// of the heat that flows there.
    pub fn rise(&self, creepage: f64) -> f64 {
        let taken = self.streaming(creepage).map(|(_, one, speed)| one.effusivity() * speed.sqrt());
        self.share / taken.sum::<f64>()
    }

    /// Peclet number of a contact of that half length (m) along the motion at a creepage; of both bodies the smaller one.
    pub fn peclet(&self, half_length: f64, creepage: f64) -> f64 {
        let numbers = self
            .streaming(creepage)
            .map(|(_, one, speed)| peclet(speed, half_length, one.diffusivity));
        numbers.fold(f64::INFINITY, f64::min)
    }

    /// Temperature (K) of the surfaces where they touch without friction, at a creepage.
    ///
    /// # Errors
    /// With a body whose temperature is not given.
    pub fn bulk(&self, creepage: f64) -> Result<f64, NoTemperature> {
        let (mut sum, mut whole) = (0.0, 0.0);
        for (body, one, speed) in self.streaming(creepage) {
            let temperature = one.temperature.ok_or(NoTemperature::NoBulk { body })?;
            let taken = one.effusivity() * speed.sqrt();
            (sum, whole) = (sum + taken * temperature, whole + taken);
        }
        Ok(sum / whole)
    }

    /// Of bodies and a motion whose temperatures laws may go by.
    ///
    /// # Errors
    /// As [`Heating::of`], and if there is no friction or no temperature is given.
    pub fn for_laws(
        bodies: &[Body; 2],
        motion: &Motion,
        friction: bool,
    ) -> Result<Self, NoTemperature> {
        let heating = Self::of(bodies, motion)?;
        heating.bulk(0.0)?;
        if friction { Ok(heating) } else { Err(NoTemperature::NoFriction) }
    }
}

impl Flash {
    /// Temperatures of the surfaces (K), one value a pair; `None` where that of the bodies is not given.
    pub fn temperatures(&self) -> Option<Vec<f64>> {
        let bulk = self.bulk?;
        Some(self.rise.iter().map(|rise| bulk + rise).collect())
    }
}

impl ContactProblem {
    /// Whether the temperatures of the surfaces are known, for laws that go by them.
    ///
    /// # Errors
    /// As [`Heating::for_laws`], and if the pairs form no rows along the motion.
    pub fn tells_temperature(&self) -> Result<(), NoTemperature> {
        let heating = Heating::for_laws(&self.bodies, &self.motion, self.friction.is_some())?;
        let flow = self.frame.flow(heating.direction).ok().filter(Flow::has_rows);
        flow.map(|_| ()).ok_or(NoTemperature::NoRows)
    }

    /// The same as [`flash`](Self::flash), where a law depends on the temperature.
    pub fn flash_for_laws(&self, state: &ContactState) -> Option<Flash> {
        if self.goes_by_temperature() { self.flash(state) } else { None }
    }

    /// How the heat of friction warms the surfaces in a state; `None` where that is not known, or nothing rubs.
    pub fn flash(&self, state: &ContactState) -> Option<Flash> {
        self.flash_with(state, &self.grip(state, |_| 0.0).unwrap_or_else(|last| last))
    }

    /// The same with that grip on bodies that slide.
    pub(super) fn flash_with(&self, state: &ContactState, grip: &Grip) -> Option<Flash> {
        // First, since most problems say nothing of heat.
        let heating = Heating::of(&self.bodies, &self.motion).ok()?;
        self.friction.as_ref()?;
        let flow = self.frame.flow(heating.direction).ok().filter(Flow::has_rows)?;
        let creepage = state.tangential.as_ref().map_or(0.0, |tangential| tangential.creepage[0]);
        let heat = match &state.tangential {
            Some(tangential) => heat_of_passages(tangential, flow, heating.speed),
            None => self.heat_of_sliding(state, heating.speed, grip),
        };
        let scale = heating.rise(creepage);
        let lines = flow.lines();
        let rows: Vec<Row> = lines.iter().map(|line| Row::of(line, flow, state)).collect();
        let uniform = self.frame.is_uniform();
        let rises: Vec<Vec<f64>> = rows.par_iter().map(|row| row.rise(&heat, uniform)).collect();
        let mut rise = vec![0.0; self.frame.len()];
        for (row, rises) in rows.iter().zip(rises) {
            row.pairs.iter().zip(rises).for_each(|(&pair, one)| rise[pair] = scale * one);
        }
        let longest = rows.iter().map(|row| row.touching(&state.pressure)).fold(0.0, f64::max);
        let peclet = (longest > 0.0).then(|| heating.peclet(0.5 * longest, creepage));
        Some(Flash { rise, bulk: heating.bulk(creepage).ok(), peclet })
    }

    /// Heat (W/m^2) of pairs that all slide at a speed (m/s), one value a pair.
    fn heat_of_sliding(&self, state: &ContactState, speed: f64, grip: &Grip) -> Vec<f64> {
        let heading = self.motion.heading([0.0; 2]);
        // The work over a metre.
        let heat = |(pair, &pressure): (usize, &f64)| {
            speed * grip.at(pair) * self.rubbing(pressure, 1.0, heading).work
        };
        state.pressure.iter().enumerate().map(heat).collect()
    }
}

/// Heat (W/m^2) of particles on the passage to each pair of bodies that roll at a speed (m/s), one value a pair.
fn heat_of_passages(tangential: &Tangential, flow: Flow<'_>, speed: f64) -> Vec<f64> {
    let traction = tangential.traction.each_ref().map(|traction| flow.on_the_way(traction));
    let advances = flow.advances();
    let heat = |pair: usize| {
        let work = (0..2).map(|axis| traction[axis][pair] * tangential.slip[axis][pair]);
        let advance = advances.as_ref().map_or_else(|| flow.advance(), |own| own[pair]);
        // What sticks slips by its residual, one way or the other.
        (work.sum::<f64>() * speed / advance).max(0.0)
    };
    (0..traction[0].len()).map(heat).collect()
}

/// A row of pairs in the order in which they are passed.
struct Row {
    pairs: Vec<usize>,
    /// How far behind some place before the row each of them lies (m).
    places: Vec<f64>,
    /// Where the heat of each begins, and where that of the last one ends (m).
    bounds: Vec<f64>,
}

impl Row {
    fn of(line: &Line, flow: Flow<'_>, state: &ContactState) -> Self {
        let axis = flow.direction().axis;
        let sense = -flow.direction().forward()[axis];
        let pairs: Vec<usize> = line.passages.iter().map(|one| one.pair).collect();
        let place = |&pair: &usize| sense * flow.frame().place(pair)[axis];
        let places: Vec<f64> = pairs.iter().map(place).collect();
        let side = |two: Option<&[f64]>| two.map_or(flow.advance(), |two| two[1] - two[0]);
        let (first, last) = (side(places.windows(2).next()), side(places.windows(2).last()));
        let begin = places.first().map(|place| place - first);
        let end = places.last().map(|place| place + last);
        // In rolling heat comes about on the way from pair to pair, in sliding on the element around a pair.
        let ends: Vec<f64> = begin.into_iter().chain(places.iter().copied()).chain(end).collect();
        let bounds = match state.tangential {
            Some(_) => ends[..ends.len() - 1].to_vec(),
            None => ends.windows(2).map(|two| 0.5 * (two[0] + two[1])).collect(),
        };
        Self { pairs, places, bounds }
    }

    /// Integral of the heat (W/m^2, one value a pair of the frame) over the roots of the distances behind it, at each pair of
    /// the row (W/m^(3/2)).
    fn rise(&self, heat: &[f64], uniform: bool) -> Vec<f64> {
        let heated: Vec<usize> =
            (0..self.pairs.len()).filter(|&one| heat[self.pairs[one]] > 0.0).collect();
        let weight = |from: usize, to: usize| {
            behind([self.bounds[from], self.bounds[from + 1]], self.places[to])
        };
        // Between equal elements a weight is that of their distance.
        let by_distance: Vec<f64> =
            if uniform { (0..self.pairs.len()).map(|to| weight(0, to)).collect() } else { vec![] };
        let at = |to: usize| {
            let before = heated.iter().take_while(|&&from| from <= to);
            let part = |&from: &usize| {
                let weight = if uniform { by_distance[to - from] } else { weight(from, to) };
                weight * heat[self.pairs[from]]
            };
            before.map(part).sum()
        };
        (0..self.pairs.len()).map(at).collect()
    }

    /// Length (m) of its pairs under pressure.
    fn touching(&self, pressure: &[f64]) -> f64 {
        let lengths = self.bounds.windows(2).map(|two| two[1] - two[0]);
        let pairs = self.pairs.iter().zip(lengths);
        pairs.filter(|(pair, _)| pressure[**pair] > 0.0).map(|(_, length)| length).sum()
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{Heating, NoTemperature, Row};
    use crate::body::profile::Flat;
    use crate::body::{Body, Thermal};
    use crate::closed_form::flash_temperature::uniform_band;
    use crate::frame::Direction;
    use crate::motion::{Control, Motion, Rolling, Sliding, Stepping, Track};

    /// A band of uniform heat, cut into equal and unequal elements: the closed form at every place, to rounding.
    #[test]
    fn bands_are_integrated_exactly() {
        let equal: Vec<f64> = (0..=20).map(|i| 0.1 * f64::from(i)).collect();
        let unequal: Vec<f64> = (0..=20).map(|i| 0.005 * f64::from(i * i)).collect();
        for (bounds, uniform) in [(equal.clone(), true), (equal, false), (unequal, false)] {
            let middle = |two: &[f64]| 0.5 * (two[0] + two[1]);
            let (middles, ends) = (bounds.windows(2).map(middle).collect(), bounds[1..].to_vec());
            for places in [middles, ends] {
                let row = Row { pairs: (0..20).collect(), places, bounds: bounds.clone() };
                let found = row.rise(&[3.0; 20], uniform);
                for (place, found) in row.places.iter().zip(found) {
                    // Up to a place the band is as long as that.
                    let [largest, _] = uniform_band(3.0, 0.5 * place, 1.0, 1.0);
                    assert_relative_eq!(found, largest, max_relative = 1e-12);
                }
            }
        }
    }

    fn bodies(shares: [Option<Option<f64>>; 2]) -> [Body; 2] {
        let mut names = ["one", "two"].into_iter();
        shares.map(|given| {
            let body = Body::new(names.next().unwrap(), Flat);
            let Some(share) = given else { return body };
            let steel = Thermal::new(50.0, 13e-6).unwrap().at(300.0).unwrap();
            body.thermal(share.map_or(steel, |share| steel.with_share(share).unwrap()))
        })
    }

    fn rolls(speed: Option<f64>) -> Motion {
        let rolling = Rolling::along(Direction::X);
        let rolling = speed.map_or(rolling, |speed| rolling.at_speed(speed));
        rolling.over(0.0, Control::Load(1.0), Stepping::Implicit(1.0)).unwrap().0
    }

    fn slides(track: Track) -> Motion {
        let sliding = Sliding::new().on(track).at_speed(2.0);
        sliding.over(1.0, Control::Load(1.0), Stepping::Implicit(1.0)).unwrap().0
    }

    /// Two of steel share the heat by halves; a creepage of 20 % drives the one by 1.1 and the other by 0.9.
    #[test]
    fn bodies_share_by_their_effusivities_and_speeds() {
        let e = 50.0 / 13e-6f64.sqrt();
        let both = Heating::of(&bodies([Some(None), Some(None)]), &rolls(Some(4.0))).unwrap();
        assert_relative_eq!(both.rise(0.0), 1.0 / (4.0 * e), max_relative = 1e-14);
        let driven = 1.0 / (e * (4.4f64.sqrt() + 3.6f64.sqrt()));
        assert_relative_eq!(both.rise(0.2), driven, max_relative = 1e-14);
        // The slower body counts: 3.6 m/s 1 mm / (2 chi).
        assert_relative_eq!(both.peclet(1e-3, 0.2), 3.6e-3 / 26e-6, max_relative = 1e-12);
        assert_eq!(both.peclet(1e-3, 2.5), 0.0);
        let half = Heating::of(&bodies([Some(Some(0.5)), None]), &rolls(Some(4.0))).unwrap();
        assert_relative_eq!(half.rise(0.0), both.rise(0.0), max_relative = 1e-14);
    }

    /// Steel of 600 K on a body that takes up three times as much at 300 K: 375 K.
    #[test]
    fn unlike_temperatures_meet_at_the_mean_of_their_effusivities() {
        let [one, two] = bodies([None, None]);
        let hot = Thermal::new(50.0, 13e-6).unwrap().at(600.0).unwrap();
        let cold = Thermal::new(150.0, 13e-6).unwrap().at(300.0).unwrap();
        let heating = Heating::of(&[one.thermal(hot), two.thermal(cold)], &rolls(Some(4.0)));
        assert_relative_eq!(heating.unwrap().bulk(0.0).unwrap(), 375.0, max_relative = 1e-14);
    }

    #[test]
    fn what_is_missing_is_named() {
        let error = |shares, motion: &Motion| Heating::of(&bodies(shares), motion).unwrap_err();
        let [disc, stroke] = [Track::around(1, 0.1), Track::to_and_fro(1, 0.1)].map(Result::unwrap);
        assert_eq!(error([None, None], &rolls(None)), NoTemperature::NoBody);
        assert_eq!(error([Some(None), Some(None)], &rolls(None)), NoTemperature::NoSpeed);
        let fast = rolls(Some(1.0));
        assert_eq!(error([Some(None), None], &fast), NoTemperature::NoShare { body: 0 });
        let share = Some(Some(0.5));
        assert_eq!(error([Some(None), share], &fast), NoTemperature::TwoShares { body: 1 });
        assert_eq!(error([share, None], &slides(disc)), NoTemperature::Stays { body: 1 });
        assert_eq!(error([None, Some(None)], &slides(disc)), NoTemperature::NoShare { body: 1 });
        assert_eq!(error([None, share], &slides(stroke)), NoTemperature::NoStream);
        let passes = Heating::of(&bodies([None, share]), &slides(disc)).unwrap();
        assert!(passes.warms(1) && !passes.warms(0) && passes.direction() == Direction::X.back());
        let bodies = bodies([None, share]);
        assert!(Heating::for_laws(&bodies, &slides(disc), true).is_ok());
        let dry = Heating::for_laws(&bodies, &slides(disc), false);
        assert_eq!(dry.unwrap_err(), NoTemperature::NoFriction);
    }
}
