//! Fewer stations in the place of the many of a long table.
//!
//! A table of a program of multibody dynamics has a row a step of time. Rows between two of them are left out where little is lost: the
//! load at each is nearly that between the two, in proportion to the time; the contact moves over neither body by more than a part of its
//! size, so that shapes are known where wear is laid down; and bodies slide nearly straight. Wear is laid down all along the way
//! between stations, so that what is left out is in the path as well.

use super::table::{Row, Table};
use super::{Control, columns::wrong};
use crate::parameters::Invalid;

/// How nearly a table is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Within {
    /// What loads, and the distance slid from a station to the next, may be off, relative to them.
    pub share: f64,
    /// How far (m) the contact may move over a body from a station to the next.
    pub way: f64,
}

/// What a table of fewer stations has lost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StationLoss {
    /// The stations there were.
    pub rows: usize,
    /// Load, or approach, by distance slid that is off at the stations left out, and on their way, relative to all of it.
    pub loss: f64,
    /// How far (m) places on a body are off at most, at the stations left out.
    pub displaced: f64,
    /// How far (m) the contact moves over a body from a station to the next, at most, where stations were left out.
    pub apart: f64,
}

/// The rows of a closed table that stand for all of them, and what is lost.
///
/// # Errors
/// If a tolerance is not one.
pub(super) fn merged(rows: &[Row], within: Within) -> Result<(Vec<Row>, StationLoss), Invalid> {
    if !(within.share > 0.0 && within.share < 1.0) {
        return Err(Invalid::new(
            "within",
            "a part of loads and of the distance slid: between 0 and 1",
        ));
    }
    let whole = Whole::of(rows);
    let mut kept = vec![];
    // Later ones first, so that parts come off in order.
    let mut parts = vec![[0, rows.len()]];
    let (mut lost, mut displaced, mut apart) = (0.0, 0.0_f64, 0.0_f64);
    while let Some([from, to]) = parts.pop() {
        let part = whole.part([from, to]);
        if to - from > 1
            && let Some(middle) = part.parted(within)
        {
            parts.extend([[middle, to], [from, middle]]);
            continue;
        }
        kept.push(Row {
            duration: rows[from..to].iter().map(|row| row.duration).sum(),
            ..rows[from]
        });
        lost += part.lost;
        if to - from > 1 {
            displaced = displaced.max(part.displaced);
            apart = apart.max(part.way.0);
        }
    }
    if kept.len() < 2 {
        return Err(wrong(
            "no body slides on the other: the offsets of both change by the same, or not at all",
        ));
    }
    let loss = if whole.work > 0.0 { lost / whole.work } else { 0.0 };
    Ok((kept, StationLoss { rows: rows.len(), loss, displaced, apart }))
}

/// All stations.
struct Whole<'a> {
    rows: &'a [Row],
    /// When (s) they begin.
    times: Vec<f64>,
    /// Load or approach by the distance slid, all together.
    work: f64,
}

/// The stations between two.
#[derive(Debug, Default)]
struct Part {
    /// Load or approach by distance that is lost.
    lost: f64,
    /// The largest share by which a load is off, and where.
    load: (f64, usize),
    /// How far (m) the contact moves from the first on a body at most, and the station in the middle of the way.
    way: (f64, usize),
    /// The share of the distance slid that is lost, and where the bodies are farthest from sliding straight.
    slid: (f64, usize),
    /// How far (m) places are off.
    displaced: f64,
}

impl Part {
    /// Where to part it, if it loses too much.
    fn parted(&self, within: Within) -> Option<usize> {
        if self.way.0 > within.way {
            return Some(self.way.1);
        }
        let (share, at) = if self.load.0 >= self.slid.0 { self.load } else { self.slid };
        (share > within.share).then_some(at)
    }
}

fn value(control: Control) -> f64 {
    let (Control::Load(value) | Control::Approach(value)) = control;
    value
}

impl<'a> Whole<'a> {
    fn of(rows: &'a [Row]) -> Self {
        let mut times = vec![0.0];
        for (at, row) in rows.iter().enumerate() {
            times.push(times[at] + row.duration);
        }
        let mut whole = Self { rows, times, work: 0.0 };
        whole.work = (0..rows.len()).map(|at| whole.slid(at) * whole.mean(at)).sum();
        whole
    }

    /// The row of a station; the first comes again after the last.
    fn row(&self, at: usize) -> &Row {
        &self.rows[at % self.rows.len()]
    }

    /// Slip (m) of body 2 over body 1 from a station to another.
    fn slip(&self, from: usize, to: usize) -> [f64; 2] {
        Table::slips(self.row(from), self.row(to))
    }

    /// Distance (m) slid to the next station.
    fn slid(&self, at: usize) -> f64 {
        let [x, y] = self.slip(at, at + 1);
        x.hypot(y)
    }

    /// The mean load or approach on the way to the next station.
    fn mean(&self, at: usize) -> f64 {
        0.5 * (value(self.row(at).control) + value(self.row(at + 1).control))
    }

    /// What the stations between two lose.
    fn part(&self, [from, to]: [usize; 2]) -> Part {
        let (first, last) = (self.row(from), self.row(to));
        let [low, high] = [first, last].map(|row| value(row.control));
        let slid: f64 = (from..to).map(|at| self.slid(at)).sum();
        let chord = self.slip(from, to);
        let length = chord[0].hypot(chord[1]);
        let mut part = Part { way: (0.0, from.midpoint(to)), ..Part::default() };
        part.slid = (if slid > 0.0 { 1.0 - length / slid } else { 0.0 }, from.midpoint(to));
        part.lost = 0.5 * (low + high) * (slid - length).max(0.0);
        let (mut gone, mut farthest, mut half) = (0.0, 0.0, false);
        for at in from + 1..=to {
            gone += self.slid(at - 1);
            let row = self.row(at);
            for body in 0..2 {
                let moved = [0, 1].map(|axis| row.offsets[body][axis] - first.offsets[body][axis]);
                part.way.0 = part.way.0.max(moved[0].hypot(moved[1]));
            }
            if at == to {
                break;
            }
            if !half && gone >= 0.5 * slid {
                (half, part.way.1) = (true, at);
            }
            let share = (self.times[at] - self.times[from]) / (self.times[to] - self.times[from]);
            let between = low + share * (high - low);
            let off = (value(row.control) - between).abs();
            if off > part.load.0 * value(row.control) {
                part.load = (off / value(row.control), at);
            }
            part.lost += off * 0.5 * (self.slid(at - 1) + self.slid(at));
            for body in 0..2 {
                let off = [0, 1].map(|axis| {
                    let [start, end] = [first, last].map(|row| row.offsets[body][axis]);
                    row.offsets[body][axis] - start - share * (end - start)
                });
                part.displaced = part.displaced.max(off[0].hypot(off[1]));
            }
            // How far the slip until then is off the straight line.
            let slip = self.slip(from, at);
            let aside = [0, 1].map(|axis| slip[axis] - share * chord[axis]);
            let aside = aside[0].hypot(aside[1]);
            if aside > farthest {
                (farthest, part.slid.1) = (aside, at);
            }
        }
        let work: f64 = (from..to).map(|at| self.slid(at) * self.mean(at)).sum();
        part.lost = part.lost.max((work - 0.5 * (low + high) * length).abs());
        part
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::{Control, Row, Table, Within, merged, value};

    /// Stations in time of a body that is stroked by so much (m) along x and turned in a circle, under a load that waves.
    fn rows(count: usize) -> Vec<Row> {
        let row = |station: usize| {
            let angle = TAU * station as f64 / count as f64;
            Row {
                duration: 1.0 / count as f64,
                control: Control::Load(100.0 + 60.0 * (3.0 * angle).sin()),
                offsets: [
                    [0.5e-3 * (2.0 * angle).sin(), 0.0],
                    [2e-3 * angle.cos(), 2e-3 * angle.sin()],
                ],
            }
        };
        (0..count).map(row).collect()
    }

    /// Load by distance, and the square of the load, over the distance slid.
    fn works(rows: &[Row]) -> [f64; 2] {
        let count = rows.len();
        let work = |power: i32| {
            let at = |at: usize| {
                let [here, next] = [at, (at + 1) % count].map(|at| &rows[at]);
                let [x, y] = Table::slips(here, next);
                let [low, high] = [here, next].map(|row| value(row.control).powi(power));
                0.5 * (low + high) * x.hypot(y)
            };
            (0..count).map(at).sum()
        };
        [work(1), work(2)]
    }

    /// Tables of a thousand to a hundred thousand rows become as few stations as a tolerance takes, however many they were, and these do what
    /// all did, to the loss that is stated.
    #[test]
    fn fewer_stations_do_what_all_do() {
        for share in [0.05, 0.01, 0.002] {
            let within = Within { share, way: 0.4e-3 };
            let mut counts = vec![];
            for count in [1_000, 10_000, 100_000] {
                let rows = rows(count);
                let (kept, lost) = merged(&rows, within).unwrap();
                assert_eq!(lost.rows, count);
                let [all, own] = [works(&rows), works(&kept)];
                let off = [0, 1].map(|power| (own[power] / all[power] - 1.0).abs());
                assert!(off[0] <= lost.loss && lost.loss <= 2.0 * share, "{off:?} {lost:?}");
                assert!(off[1] <= 2.0 * lost.loss, "{off:?} {lost:?}");
                assert!(lost.apart <= within.way && lost.displaced <= lost.apart, "{lost:?}");
                let time: f64 = kept.iter().map(|row| row.duration).sum();
                assert!((time - 1.0).abs() < 1e-9);
                // A station is where one was.
                assert!(
                    kept.iter().all(|row| rows.iter().any(|known| known.offsets == row.offsets))
                );
                counts.push(kept.len());
            }
            assert!(counts[2] < 400 && counts[2] < 2 * counts[0], "{share}: {counts:?}");
        }
    }

    /// A place that rests takes no stations, a load that jumps takes those it jumps between.
    #[test]
    fn rests_and_jumps_are_kept() {
        let row = |station: usize| Row {
            duration: 1e-3,
            control: Control::Load(if station < 500 { 10.0 } else { 20.0 }),
            offsets: [
                [0.0; 2],
                [if station < 200 { 0.0 } else { 1e-3 * (station % 2) as f64 }, 0.0],
            ],
        };
        let rows: Vec<Row> = (0..1000).map(row).collect();
        let (kept, lost) = merged(&rows, Within { share: 0.01, way: 2e-3 }).unwrap();
        // Strokes are as long as a place may move, and turn round in each row.
        assert!(kept.len() >= 800 && kept.len() < 820, "{}", kept.len());
        assert!(lost.loss < 1e-2, "{lost:?}");
        assert!(merged(&rows, Within { share: 0.0, way: 1.0 }).is_err());
    }
}
