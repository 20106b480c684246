//! A measured profile laid on a worn one: what each zone wore, relative to what was computed.
//!
//! The depth at each point is a share of the computed one, a share for each zone, and how far the measured profile as a whole is moved and
//! turned, which no file of a worn wheel says: its unworn parts do. Least squares find all of it together. What is left of
//! neighbouring points is correlated, so that points count as fewer. It may be more where the wheel is worn, as a computed shape differs
//! from the measured one there: variances are those of White (Econometrica 48 (1980) 817).

use archard_rail::curve::Curve;
use archard_rail::wear::{ProfilePoint, WornProfile};
use statrs::distribution::{ContinuousCDF, FisherSnedecor};

use super::super::effects::{factor, known_factor};
use super::super::joint::matrix::{Matrix, add_square, dot, power, times, zeros};
use super::super::shape::REJECTED;

/// The motions of a rigid profile: a turn, and shifts along y and z.
const POSE: usize = 3;
/// Rounds in which a profile is laid, at most, a choice of effort; and the change of its place (m) at which it has settled, a thousandth
/// of what instruments resolve.
const ROUNDS: usize = 30;
const SETTLED: f64 = 1e-9;
/// No point of a wheel's profile lies farther (m) from its origin, which is in the middle of 135 to 140 mm.
const LEVER: f64 = 0.1;

/// A measured profile, laid on a worn one.
#[derive(Debug, Clone)]
pub(super) struct Laid {
    /// What zones wore, relative to what was computed, and the covariance of that.
    pub shares: Vec<f64>,
    pub covariance: Matrix,
    /// By how much (rad, and m along y and z) it was moved.
    pub pose: [f64; POSE],
    /// Standard deviation (m) of what is left of all points, and of those that wear.
    pub left: [f64; 2],
    /// Whether what is left of points that wear is more than that of the others, by more than chance.
    pub differs: bool,
}

/// Why a profile cannot be laid.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(super) enum NotLaid {
    #[error(
        "it has no place on the new profile: units, axes or the origin of its file may be others than those of the new one"
    )]
    Elsewhere,
    #[error("too few points of it lie where the wheel does not wear to lay it on the new profile")]
    Short,
    #[error("the {0} shows no wear beyond what is left of its points")]
    Unworn(&'static str),
}

/// The zones of a wheel: the tread, and the flange from a y (m) on where it has a coefficient of its own.
#[derive(Debug, Clone, Copy)]
pub(super) struct Zones(pub Option<f64>);

impl Zones {
    /// Their names.
    pub fn names(self) -> &'static [&'static str] {
        if self.0.is_some() { &["tread", "flange"] } else { &["wheel"] }
    }

    /// The zone of a place (m).
    pub fn of(self, y: f64) -> usize {
        usize::from(self.0.is_some_and(|from| y <= from))
    }

    /// Computed areas (m^2) of a worn profile.
    pub fn areas(self, worn: &WornProfile) -> Vec<f64> {
        let mut areas = vec![0.0; self.names().len()];
        for ([y, _], area) in worn.unworn().points.into_iter().zip(worn.areas()) {
            areas[self.of(y)] += area;
        }
        areas
    }
}

/// A point in the sums: its columns, and what was measured.
struct Row {
    columns: Vec<f64>,
    measured: f64,
}

impl Laid {
    /// Lays a measured profile on a worn one.
    pub fn of(worn: &WornProfile, measured: &Curve, zones: Zones) -> Result<Self, NotLaid> {
        let mut moved = measured.clone();
        let mut pose = [0.0; POSE];
        for _ in 0..ROUNDS {
            let held = worn.against(&moved);
            let rows = rows(&held, zones);
            let size = zones.names().len() + POSE;
            if rows.len() <= size {
                return Err(NotLaid::Elsewhere);
            }
            let (found, inverse) = least_squares(&rows);
            let [turn, y, z] = [0, 1, 2].map(|part| found[size - POSE + part]);
            if turn.abs() * LEVER + y.hypot(z) <= SETTLED {
                return Self::conclude(&rows, (&found, &inverse), pose, zones);
            }
            moved = moved.moved(turn, [y, z]);
            let (sin, cos) = turn.sin_cos();
            pose = [
                pose[0] + turn,
                pose[1] * cos - pose[2] * sin + y,
                pose[1] * sin + pose[2] * cos + z,
            ];
        }
        Err(NotLaid::Elsewhere)
    }

    fn conclude(
        rows: &[Row],
        (found, inverse): (&[f64], &Matrix),
        pose: [f64; POSE],
        zones: Zones,
    ) -> Result<Self, NotLaid> {
        let (count, size) = (rows.len() as f64, found.len());
        let left: Vec<f64> =
            rows.iter().map(|row| row.measured - dot(&row.columns, found)).collect();
        let square = |values: &[f64]| values.iter().map(|value| value * value).sum::<f64>();
        let series = together(&left);
        let degrees = count / series - size as f64;
        if degrees < 1.0 {
            return Err(NotLaid::Short);
        }
        let mut spread = zeros(size);
        for (row, left) in rows.iter().zip(&left) {
            add_square(&mut spread, &row.columns, left * left);
        }
        let widened = factor(degrees) / known_factor();
        let scale = series * widened * widened * count / (count - size as f64);
        let shares = found[..size - POSE].to_vec();
        let covariance: Matrix = (0..shares.len())
            .map(|i| {
                let across = times(&spread, &inverse[i]);
                (0..shares.len()).map(|j| scale * dot(&inverse[j], &across)).collect()
            })
            .collect();
        for (zone, name) in zones.names().iter().enumerate() {
            if shares[zone] <= covariance[zone][zone].sqrt() {
                return Err(NotLaid::Unworn(name));
            }
        }
        let mean = |values: &[f64]| square(values) / (values.len() as f64).max(1.0);
        // Smoothed wear ends nowhere: what is less than what is left cannot be told from none.
        let seen = mean(&left).sqrt();
        let wears = |row: &Row| dot(&row.columns[..shares.len()], &shares) > seen;
        let part = |worn: bool| -> Vec<f64> {
            let own = rows.iter().zip(&left).filter(|(row, _)| wears(row) == worn);
            own.map(|(_, left)| *left).collect()
        };
        let [unworn, worn] = [part(false), part(true)];
        let [few, many] = [&worn, &unworn].map(|own| (own.len() as f64 / series).max(1.0));
        let ratio = mean(&worn) / mean(&unworn).max(f64::MIN_POSITIVE);
        let chance = FisherSnedecor::new(few, many).map_or(1.0, |law| 1.0 - law.cdf(ratio));
        Ok(Self {
            shares,
            covariance,
            pose,
            left: [seen, mean(&worn).sqrt()],
            differs: chance < REJECTED,
        })
    }
}

/// So many values of a series count as one: the sum of its correlations up to the first that is not positive (C. J. Geyer, *Stat. Sci.* 7
/// (1992) 473).
fn together(values: &[f64]) -> f64 {
    let product = |lag: usize| values.iter().zip(&values[lag..]).map(|(a, b)| a * b).sum::<f64>();
    let all = product(0).max(f64::MIN_POSITIVE);
    let correlations = (1..values.len()).map(|lag| product(lag) / all);
    1.0 + 2.0 * correlations.take_while(|own| *own > 0.0).sum::<f64>()
}

/// The points that a profile reaches.
fn rows(held: &[ProfilePoint], zones: Zones) -> Vec<Row> {
    let row = |held: &ProfilePoint| {
        let [y, z] = held.at;
        let [ny, nz] = held.normal;
        let mut columns = vec![0.0; zones.names().len()];
        columns[zones.of(y)] = held.depth;
        columns.extend([z * -ny + y * nz, ny, nz]);
        Some(Row { columns, measured: held.measured? })
    };
    held.iter().filter_map(row).collect()
}

/// The unknowns, and the inverse of the sums of squares.
fn least_squares(rows: &[Row]) -> (Vec<f64>, Matrix) {
    let size = rows[0].columns.len();
    // Columns of length one, so that depths of micrometres count as much as shifts do.
    let length = |at: usize| rows.iter().map(|row| row.columns[at].powi(2)).sum::<f64>().sqrt();
    let lengths: Vec<f64> = (0..size).map(|at| length(at).max(f64::MIN_POSITIVE.sqrt())).collect();
    let (mut squares, mut sums) = (zeros(size), vec![0.0; size]);
    for row in rows {
        let scaled: Vec<f64> = row.columns.iter().zip(&lengths).map(|(a, b)| a / b).collect();
        add_square(&mut squares, &scaled, 1.0);
        sums.iter_mut().zip(&scaled).for_each(|(sum, column)| *sum += column * row.measured);
    }
    let mut inverse = power(&squares, -1.0, 1e-12);
    for (i, row) in inverse.iter_mut().enumerate() {
        row.iter_mut().zip(&lengths).for_each(|(cell, length)| *cell /= lengths[i] * length);
    }
    let sums: Vec<f64> = sums.iter().zip(&lengths).map(|(sum, length)| sum * length).collect();
    (times(&inverse, &sums), inverse)
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;
    use std::sync::Arc;

    use archard::friction::Coulomb;
    use archard::wear::Archard;
    use archard_rail::contact::{Bodies, Resolution};
    use archard_rail::curve::{Curve, Smoothing};
    use archard_rail::setup::{Attitude, Setup, Side, Track, Velocity, Wheelset};
    use archard_rail::standard::{rail_60e1, wheel_s1002};
    use archard_rail::wear::{Journey, OperatingPoint, Route, WornProfile};

    use super::{Laid, Zones, together};

    const RADIUS: f64 = 0.46;

    /// A wheel that touches with its tread and with the root of its flange, worn by a tenth of a millimetre.
    fn worn() -> WornProfile {
        let rail = rail_60e1(0.2e-3).unwrap().curve(Smoothing::NONE).unwrap();
        let wheel = wheel_s1002(0.2e-3).unwrap().curve(Smoothing::NONE).unwrap();
        let wheelset = Wheelset {
            flange_back_distance: 1.36,
            flange_back_position: -0.07,
            nominal_radius: RADIUS,
        };
        let setup = Setup::new(Track::standard(), &rail, wheelset, &wheel).unwrap();
        let steel = archard::Material::new(210e9, 0.28).unwrap();
        let friction = Arc::new(Coulomb::new(0.3).unwrap());
        let point = |shift, share| OperatingPoint {
            attitude: Attitude { shift, roll: 0.0, yaw: 1e-3 },
            rolls: false,
            velocity: Velocity { forward: 20.0, pitch: -20.0 / RADIUS, ..Velocity::default() },
            moment: None,
            load: 60e3,
            transfer: 0.0,
            creepages: Default::default(),
            friction: friction.clone(),
            flange: None,
            share,
        };
        let journey = Journey {
            setup,
            sides: vec![Side::Right],
            bodies: Bodies {
                wheel: steel,
                rail: steel,
                thermal: [None, None],
                friction: friction.clone(),
                flange: None,
                wear: [Some(Arc::new(Archard::new(3e-15).unwrap())), None],
                flange_wear: None,
                shear_yield: 800e6,
            },
            cracks: [None; 2],
            route: Route {
                points: vec![point(0.0, 0.9), point(6e-3, 0.1)],
                distance: 2e7,
                axles: 0.0,
            },
            resolution: Resolution { elements: 16, ..Resolution::default() },
            tolerance: 0.2,
            smoothing: 4e-3,
            thinnings: vec![],
            amplitude: None,
        };
        let done = journey.travel(|_, _| ControlFlow::Continue(())).unwrap();
        done.worn.into_iter().next().unwrap().wheel
    }

    /// A profile that lies elsewhere and has noise gives the wear of each zone within errors as large as they are said to be.
    #[test]
    fn errors_of_shares_are_true() {
        let worn = worn();
        let zones = Zones(Some(-20e-3));
        let points = worn.profile().points;
        let (noise, studies) = (4e-6, 60);
        let mut squares = [0.0; 2];
        let mut differ = 0;
        for seed in 0..studies {
            let mut random = fastrand::Rng::with_seed(seed);
            let mut draw = || {
                let radius = (-2.0 * (1.0 - random.f64()).ln()).sqrt();
                noise * radius * (std::f64::consts::TAU * random.f64()).cos()
            };
            let points: Vec<[f64; 2]> =
                points.iter().map(|[y, z]| [y + draw(), z + draw()]).collect();
            let measured = Curve::new(&points, Smoothing::NONE).unwrap();
            let laid = Laid::of(&worn, &measured.moved(-1e-3, [0.2e-3, 0.5e-3]), zones).unwrap();
            assert!((laid.left[0] / noise - 1.0).abs() < 0.2, "{:?}", laid.left);
            assert!((laid.pose[0] - 1e-3).abs() < 1e-4, "{:?}", laid.pose);
            differ += usize::from(laid.differs);
            for (zone, sum) in squares.iter_mut().enumerate() {
                *sum += (laid.shares[zone] - 1.0).powi(2) / laid.covariance[zone][zone];
            }
        }
        // The mean of squares has a deviation of (2 / 60)^(1/2) by chance.
        for sum in squares {
            let mean = sum / studies as f64;
            eprintln!("{mean:.3}, {differ} of {studies} differ");
            assert!((0.4..1.6).contains(&mean), "{mean}");
        }
        assert!(differ <= 9, "{differ}");
    }

    /// Of a series that follows its last value by a share r, (1 + r) / (1 - r) values count as one; of waves about as many as their length.
    #[test]
    fn values_that_follow_each_other_count_as_one() {
        let mut random = fastrand::Rng::with_seed(5);
        let mut normal = move || {
            let (a, b) = (1.0 - random.f64(), random.f64());
            (-2.0 * a.ln()).sqrt() * (std::f64::consts::TAU * b).cos()
        };
        for share in [0.0, 0.5, 0.9] {
            let mut last = 0.0;
            let series: Vec<f64> = (0..20_000)
                .map(|_| {
                    last = share * last + normal();
                    last
                })
                .collect();
            let expected = (1.0 + share) / (1.0 - share);
            assert!((together(&series) / expected - 1.0).abs() < 0.15, "{share}");
        }
        let white: Vec<f64> = (0..20_000).map(|_| normal()).collect();
        // The mean of forty: correlations fall linearly, and add up to forty.
        let smooth: Vec<f64> = white.windows(40).map(|own| own.iter().sum()).collect();
        assert!((together(&smooth) / 40.0 - 1.0).abs() < 0.4, "{}", together(&smooth));
    }
}
