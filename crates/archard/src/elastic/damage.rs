//! Damage of the material below a contact that wears, by the cycles that it goes through.
//!
//! A cycle whose criterion alone would give a life of N cycles takes an N-th of it, and shares add up (M. A. Miner, *J. Appl.
//! Mech.* 12 (1945) A159). A point keeps its place in the material and comes nearer to the surface as that wears; its damage so far
//! counts, until it is worn off with the surface (J. J. Madge, S. B. Leen & P. H. Shipway, *Wear* 263 (2007) 542).

use super::fatigue::{Added, Criterion, Cycle};
use crate::stress::Components;

/// Places of the material between two depths at which values are known. A choice of effort, whose error is measured.
const BETWEEN: usize = 4;

/// How many cycles a value of a criterion lets live: a line in logarithms (O. H. Basquin, *Proc. ASTM* 10 (1910) 625).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Endurance {
    /// The criterion (Pa) at a life of half a cycle, 2N = 1.
    pub strength: f64,
    /// The power of the number of half cycles that the value is in proportion to; negative.
    pub exponent: f64,
}

impl Endurance {
    /// The share of a life that a cycle of a value (Pa) takes; none without tension or shear.
    pub fn share(&self, value: f64) -> f64 {
        if value > 0.0 { 2.0 * (value / self.strength).powf(-1.0 / self.exponent) } else { 0.0 }
    }
}

/// What the damage of a body depends on.
#[derive(Debug, Clone, PartialEq)]
pub struct DamageModel {
    /// The criterion.
    pub criterion: Criterion,
    /// The life that its values let.
    pub endurance: Endurance,
    /// Depths (m) below the present surface that values are found at, rising. Nearer to the surface that of the first counts.
    pub depths: Vec<f64>,
    /// Even stresses (Pa) to add: one at all instants, one in phase with friction.
    pub added: [Components; 2],
}

/// Sums of the damage of a body, cycle by cycle.
#[derive(Debug, Clone)]
pub struct Damage {
    tiring: DamageModel,
    /// From all data; from elements of twice the size; from half of the depths; from half of the computed cycles.
    sums: [Sum; 4],
}

/// A value with its error.
type WithError = [f64; 2];

/// What became of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct DamageOfBody {
    /// The largest damage of all points, also of those worn off; 1 is the end of a life.
    pub largest: WithError,
    /// Where that is: along x and y, and up from the unworn surface (m).
    pub place: [f64; 3],
    /// The largest damage of the points that are there at the end.
    pub left: WithError,
    /// The cycles that went by until the first point was at the end of its life, if one was.
    pub life: Option<WithError>,
    /// Depth (m) below the unworn surface, and the largest damage of all points there and of those left.
    pub rows: Vec<[f64; 3]>,
    /// Whether some place is worn down to below all points.
    pub through: bool,
}

/// A cycle that was seen.
#[derive(Debug, Clone)]
struct Station {
    /// Cycles that went by.
    cycles: f64,
    /// The share of a life that it takes, column by column from the surface down; no number where stresses are not known.
    shares: Vec<f64>,
    /// Depth (m) worn off each column.
    worn: Vec<f64>,
}

/// A sum over a part of the data.
#[derive(Debug, Clone)]
struct Sum {
    /// Elements of the size times two to this power.
    level: usize,
    /// Every so many-th of the depths, and of the cycles.
    every: [usize; 2],
    /// Places in the material: depths (m) below the unworn surface.
    points: Vec<f64>,
    /// Where along x and y (m) columns are.
    columns: Vec<[f64; 2]>,
    damage: Vec<f64>,
    seen: usize,
    last: Option<Station>,
    /// A cycle that counts if it stays the last.
    waiting: Option<Station>,
    life: Option<f64>,
}

impl Damage {
    /// Before the first cycle.
    pub fn new(tiring: DamageModel) -> Self {
        let sum = |level: usize, every: [usize; 2]| {
            let depths = some(&tiring.depths, every[0]);
            Sum {
                level,
                every,
                points: between(&depths),
                columns: vec![],
                damage: vec![],
                seen: 0,
                last: None,
                waiting: None,
                life: None,
            }
        };
        let sums = [sum(0, [1, 1]), sum(1, [1, 1]), sum(0, [2, 1]), sum(0, [1, 2])];
        Self { tiring, sums }
    }

    /// Adds the cycles up to and with one, whose number is that of all cycles so far, with the depth (m) then worn off each pair. Between
    /// the cycles that are given shares go evenly.
    pub fn pass(&mut self, cycle: &Cycle, cycles: f64, worn: &[f64]) {
        let DamageModel { criterion, endurance, depths, added: [initial, swinging] } = &self.tiring;
        let added: Added<'_> = (initial, swinging);
        let values = [0, 1].map(|level| -> Vec<Vec<f64>> {
            depths.iter().map(|depth| cycle.values(criterion, (level, *depth), added)).collect()
        });
        for sum in &mut self.sums {
            let worn = if sum.level == 0 { worn.to_vec() } else { cycle.halved(worn) };
            let depths = some(depths, sum.every[0]);
            let values = some(&values[sum.level], sum.every[0]);
            if sum.columns.is_empty() {
                sum.columns = cycle.columns(sum.level);
                sum.damage = vec![0.0; sum.columns.len() * sum.points.len()];
            }
            let share = |column: usize, point: f64| {
                let at = |own: usize| values[own][column];
                endurance.share(on_line(&depths, at, point - worn[column]))
            };
            let shares = (0..worn.len())
                .flat_map(|column| sum.points.iter().map(move |point| (column, *point)))
                .map(|(column, point)| share(column, point))
                .collect();
            sum.take(Station { cycles, shares, worn });
        }
    }

    /// What became of the body by now; `None` before the first cycle, and where no stress is known.
    pub fn so_far(&self) -> Option<DamageOfBody> {
        let [all, parts @ ..] = self.sums.each_ref().map(|sum| sum.clone().at_end());
        let station = all.last.as_ref()?;
        let (largest, at) = all.largest()?;
        let (left, cycles) = (all.left(), station.cycles);
        let apart = |value: f64, of: &dyn Fn(&Sum) -> f64| -> WithError {
            [value, parts.iter().map(|part| (of(part) - value).abs()).sum()]
        };
        // What a sum makes of a life that it does not see the end of.
        let life = |sum: &Sum| {
            sum.life.unwrap_or_else(|| cycles / sum.largest().map_or(0.0, |(largest, _)| largest))
        };
        let count = all.points.len();
        let [x, y] = all.columns[at / count];
        let row = |point: usize| {
            let of = |left: bool| {
                let known = (0..all.columns.len()).filter(|own| !left || all.is_left(*own, point));
                known.map(|column| all.damage[column * count + point]).fold(0.0, f64::max)
            };
            [all.points[point], of(false), of(true)]
        };
        let deepest = all.points.last().copied()?;
        Some(DamageOfBody {
            largest: apart(largest, &|sum| sum.largest().map_or(f64::NAN, |own| own.0)),
            place: [x, y, -all.points[at % count]],
            left: apart(left, &Sum::left),
            life: all.life.map(|own| apart(own, &life)),
            rows: (0..count).map(row).collect(),
            through: station.worn.iter().any(|worn| *worn >= deepest),
        })
    }
}

impl Sum {
    /// Takes a cycle, at once or if it stays the last.
    fn take(&mut self, station: Station) {
        let counts = self.seen.is_multiple_of(self.every[1]);
        self.seen += 1;
        self.waiting = None;
        if counts { self.add(station) } else { self.waiting = Some(station) }
    }

    /// With the last cycle.
    fn at_end(mut self) -> Self {
        if let Some(waiting) = self.waiting.take() {
            self.add(waiting);
        }
        self
    }

    /// Adds the cycles up to one.
    fn add(&mut self, now: Station) {
        let before = self.largest().map_or(0.0, |(largest, _)| largest);
        let start = self.last.as_ref().map_or(0.0, |last| last.cycles);
        let cycles = now.cycles - start;
        for (index, damage) in self.damage.iter_mut().enumerate() {
            let (column, point) =
                (index / self.points.len(), self.points[index % self.points.len()]);
            let share = now.shares[index];
            let Some(last) = &self.last else {
                *damage += if point > now.worn[column] { cycles * share } else { 0.0 };
                continue;
            };
            let [was, is] = [last, &now].map(|own| own.worn[column]);
            // Worn off on the way, by an even rate; what is over the surface has no share.
            let there = if point > is { 1.0 } else { ((point - was) / (is - was)).max(0.0) };
            if there > 0.0 {
                *damage += 0.5 * cycles * there * (last.shares[index] + share);
            }
        }
        let after = self.largest().map_or(0.0, |(largest, _)| largest);
        if self.life.is_none() && after >= 1.0 {
            self.life = Some(start + cycles * (1.0 - before) / (after - before));
        }
        self.last = Some(now);
    }

    /// The largest damage of all points, and its index.
    fn largest(&self) -> Option<(f64, usize)> {
        let known = self.damage.iter().copied().enumerate().filter(|(_, own)| !own.is_nan());
        known.map(|(index, own)| (own, index)).max_by(|a, b| a.0.total_cmp(&b.0))
    }

    fn is_left(&self, column: usize, point: usize) -> bool {
        self.last.as_ref().is_none_or(|last| self.points[point] > last.worn[column])
    }

    /// The largest damage of the points that are left.
    fn left(&self) -> f64 {
        let count = self.points.len();
        let left = (0..self.damage.len()).filter(|own| self.is_left(own / count, own % count));
        left.map(|index| self.damage[index]).fold(0.0, f64::max)
    }
}

/// Every so many-th of some, from the first on.
fn some<T: Clone>(all: &[T], every: usize) -> Vec<T> {
    all.iter().step_by(every).cloned().collect()
}

/// Depths with parts between them.
fn between(depths: &[f64]) -> Vec<f64> {
    let parts = depths.windows(2).flat_map(|ends| {
        let part = |part: usize| ends[0] + (ends[1] - ends[0]) * part as f64 / BETWEEN as f64;
        (0..BETWEEN).map(part)
    });
    parts.chain(depths.last().copied()).collect()
}

/// A value at a place on a line through some at rising places; beyond these that of the next.
fn on_line(places: &[f64], value: impl Fn(usize) -> f64, place: f64) -> f64 {
    let above = places.partition_point(|own| *own <= place);
    if above == 0 || above == places.len() {
        return value(above.saturating_sub(1));
    }
    let share = (place - places[above - 1]) / (places[above] - places[above - 1]);
    (1.0 - share) * value(above - 1) + share * value(above)
}
