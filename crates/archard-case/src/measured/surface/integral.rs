//! Integrals over a part of a measured surface, by the trapezoidal rule from reading to reading.

use super::{NoScar, Surface};

/// Most of a scar that may be without readings, and the widest step across it.
const GAPS: f64 = 0.2;
/// Steps so many times the mean one are gaps.
const UNEVEN: f64 = 1.5;

/// An integral as a sum over readings.
pub(super) struct Integral {
    /// Cells and their shares: lengths (m) of a profile, areas (m^2) of a map.
    pub shares: Vec<(usize, f64)>,
    /// Places in the zone without a reading.
    pub gaps: usize,
    /// What lies between readings, chords being straight: along each axis the integral of a parabola of curvature 2 over
    /// its chords (m^3 of a profile, m^4 of a map).
    pub between: [f64; 2],
}

/// Where an integral goes, along one axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Zone {
    /// From where to where the scar reaches (m), and the integral.
    pub scar: [f64; 2],
    pub all: [f64; 2],
    /// Whether the scar runs through along that axis, equally all the way.
    pub through: bool,
}

impl Surface {
    /// The integral over a zone of what has readings there; `depths` are not a number in gaps.
    pub(super) fn integral(&self, depths: &[f64], zone: [Zone; 2]) -> Result<Integral, NoScar> {
        let columns = self.places[0].len();
        let inside = [0, 1].map(|axis| {
            let [low, high] = zone[axis].all;
            let places = self.places[axis].iter().enumerate();
            let inside = places.filter(|(_, place)| (low..=high).contains(*place));
            inside.map(|(index, _)| index).collect::<Vec<usize>>()
        });
        let line = |axis: usize| self.axis.is_some_and(|own| own != axis);
        let lines = [0, 1].map(|axis| Line {
            zone: zone[axis],
            ends: [inside[axis].first(), inside[axis].last()]
                .map(|index| index.map_or(0.0, |&index| self.places[axis][index])),
            point: line(axis),
        });
        let (mut rows, mut gaps) = (vec![], 0);
        for &row in &inside[1] {
            let known: Vec<usize> = (inside[0].iter().copied())
                .filter(|column| depths[row * columns + column].is_finite())
                .collect();
            gaps += inside[0].len() - known.len();
            if !known.is_empty() {
                let places: Vec<f64> = known.iter().map(|&index| self.places[0][index]).collect();
                rows.push((row, known, places));
            }
        }
        let share = gaps as f64 / (inside[0].len() * inside[1].len()).max(1) as f64;
        if share > GAPS || rows.is_empty() {
            return Err(NoScar::Gaps { share });
        }
        for axis in (0..2).filter(|&axis| !line(axis) && !zone[axis].through) {
            self.dense(axis, &inside[axis], zone[axis])?;
        }
        let places: Vec<f64> = rows.iter().map(|(row, ..)| self.places[1][*row]).collect();
        let across = lines[1].shares(&places);
        let width = if line(0) { 1.0 } else { zone[0].scar[1] - zone[0].scar[0] };
        let mut between = [0.0, lines[1].between(&places) * width];
        let mut shares = vec![];
        for ((row, known, places), across) in rows.iter().zip(&across) {
            let own = lines[0].shares(places);
            shares.extend(
                known.iter().zip(own).map(|(column, own)| (row * columns + column, own * across)),
            );
            let [low, high] = zone[1].scar;
            if (low..=high).contains(&self.places[1][*row]) {
                between[0] += lines[0].between(places) * across;
            }
        }
        Ok(Integral { shares, gaps, between })
    }

    /// Refuses steps along an axis that are wide against the zone: a profile has no place where it has no reading.
    fn dense(&self, axis: usize, inside: &[usize], zone: Zone) -> Result<(), NoScar> {
        let places: Vec<f64> = inside.iter().map(|&index| self.places[axis][index]).collect();
        let widest = places.windows(2).map(|ends| ends[1] - ends[0]).fold(0.0, f64::max);
        let share = widest / (zone.all[1] - zone.all[0]);
        let mean = (zone.all[1] - zone.all[0]) / (places.len().max(2) - 1) as f64;
        let width = zone.scar[1] - zone.scar[0];
        match share > GAPS {
            true if widest > UNEVEN * mean => Err(NoScar::Gaps { share }),
            true => Err(NoScar::Coarse { axis: ["x", "y"][axis], step: widest, width }),
            false => Ok(()),
        }
    }
}

/// The trapezoidal rule along one axis.
struct Line {
    zone: Zone,
    /// The first and last place within the zone (m).
    ends: [f64; 2],
    /// Whether it is the only place across a profile.
    point: bool,
}

impl Line {
    /// The lengths that rising places stand for; one for the only place across a profile. From the last reading to the end of
    /// the zone a scar goes on where it runs through, and ends else.
    fn shares(&self, places: &[f64]) -> Vec<f64> {
        if self.point {
            return vec![1.0; places.len()];
        }
        let (ends, beyond) =
            if self.zone.through { (self.zone.all, 1.0) } else { (self.ends, 0.5) };
        let last = places.len() - 1;
        let share = |index: usize| {
            let before = match index {
                0 => beyond * (places[0] - ends[0]),
                _ => 0.5 * (places[index] - places[index - 1]),
            };
            let behind = match index == last {
                true => beyond * (ends[1] - places[last]),
                false => 0.5 * (places[index + 1] - places[index]),
            };
            before + behind
        };
        (0..places.len()).map(share).collect()
    }

    /// The integral of a parabola of curvature 2 over the chords between places that the scar lies over (m^3).
    fn between(&self, places: &[f64]) -> f64 {
        if self.point || self.zone.through {
            return 0.0;
        }
        let [low, high] = self.zone.scar;
        let ends = [&[self.ends[0]], places, &[self.ends[1]]].concat();
        let over = ends.windows(2).filter(|ends| ends[1] > low && ends[0] < high);
        over.map(|ends| (ends[1] - ends[0]).powi(3) / 6.0).sum()
    }
}
