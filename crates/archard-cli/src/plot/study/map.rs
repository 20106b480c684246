//! The map of a study over two numbers.

use super::Study;
use crate::plot::figure::{COLOURS, Curves, Panel, Parts, Pen};
use crate::plot::parts;
use crate::plot::scale::plain;
use crate::plot::tables::size;

/// Most values along an axis for each cell to have its value written in it.
const WRITTEN: usize = 8;

impl Study {
    /// The results over the two keys that a study goes over, where both are numbers; over samples their mean.
    pub(super) fn map(&self) -> Option<Panel> {
        let [one, other] = &self.over[..] else { return None };
        if !(one.levels.is_empty() && other.levels.is_empty()) {
            return None;
        }
        let values = [0, 1].map(|key| self.values_of(key));
        if values.iter().any(|values| values.len() < 2) {
            return None;
        }
        let axes = [(one, 0), (other, 1)].map(|(key, axis)| key.axis(size(&values[axis])));
        let units = axes.each_ref().map(|(_, unit)| unit.clone());
        let most = self.rows.iter().filter_map(|row| row.result).fold(0.0, f64::max);
        let ends = values.each_ref().map(|values| bounds(values));
        let mut curves = Curves::new();
        let (mut parts, mut notes) = (vec![], vec![]);
        for (i, x) in values[0].iter().enumerate() {
            for (j, y) in values[1].iter().enumerate() {
                let Some(mean) = self.mean_at([*x, *y]) else { continue };
                let place = |[x, y]: [f64; 2]| [x * units[0].factor, y * units[1].factor];
                let [left, right] = [ends[0][i], ends[0][i + 1]];
                let [low, high] = [ends[1][j], ends[1][j + 1]];
                let corners = [[left, low], [right, low], [right, high], [left, high]].map(place);
                parts.push((corners.to_vec(), mean * self.unit.factor));
                notes.push((
                    plain(mean * self.unit.factor),
                    place([*x, *y]),
                    parts::ink(mean / most),
                ));
            }
        }
        let edge = |axis: usize| {
            let ends = &ends[axis];
            [ends[0], ends[ends.len() - 1]].map(|end| end * units[axis].factor)
        };
        curves.parts(Parts { edges: [edge(0), edge(1)], parts });
        let factors = units.each_ref().map(|unit| unit.factor);
        for (from, to) in self.borders(&values, &ends) {
            let line = [from, to].map(|[x, y]| (x * factors[0], y * factors[1]));
            curves.add(line, Pen::under("#ffffff"), None);
            curves.add(line, Pen::line(COLOURS[2]), None);
        }
        for (words, place, colour) in self.regions(&values, &ends, most) {
            notes.push((words, [0, 1].map(|axis| place[axis] * factors[axis]), colour));
        }
        let few = values.iter().all(|values| values.len() <= WRITTEN);
        let [x, y] = axes.each_ref().map(|(words, unit)| unit.label(words));
        let labels = [self.unit.label(self.name()), x, y];
        Some(curves.panel(labels.each_ref().map(String::as_str), |view| {
            let notes = notes.into_iter().filter(|_| few);
            notes.fold(view, |view, (words, place, colour)| view.note_in(words, place, colour))
        }))
    }

    /// What fretting was at values of both keys, if all rows agree.
    fn regime_at(&self, values: [f64; 2]) -> Option<&str> {
        let mut at = self.rows.iter().filter(|row| row.values[..2] == values);
        let first = at.next()?.regime.as_deref()?;
        at.all(|row| row.regime.as_deref() == Some(first)).then_some(first)
    }

    /// The edges (SI) between cells of different regimes.
    fn borders(&self, values: &[Vec<f64>; 2], ends: &[Vec<f64>; 2]) -> Vec<([f64; 2], [f64; 2])> {
        let regime = |i: usize, j: usize| self.regime_at([*values[0].get(i)?, *values[1].get(j)?]);
        let differ = |one: [usize; 2], other: [usize; 2]| {
            let pair = [one, other].map(|[i, j]| regime(i, j));
            matches!(pair, [Some(one), Some(other)] if one != other)
        };
        let mut lines = vec![];
        for i in 0..values[0].len() {
            for j in 0..values[1].len() {
                let corner = |across: usize, up: usize| [ends[0][i + across], ends[1][j + up]];
                if differ([i, j], [i + 1, j]) {
                    lines.push((corner(1, 0), corner(1, 1)));
                }
                if differ([i, j], [i, j + 1]) {
                    lines.push((corner(0, 1), corner(1, 1)));
                }
            }
        }
        lines
    }

    /// The name of each regime below the number of its largest cell, with its place (SI) and colour.
    fn regions(
        &self,
        values: &[Vec<f64>; 2],
        ends: &[Vec<f64>; 2],
        most: f64,
    ) -> Vec<(String, [f64; 2], &'static str)> {
        let mut largest: Vec<(&str, f64, [f64; 2], &'static str)> = vec![];
        for (i, &x) in values[0].iter().enumerate() {
            for (j, &y) in values[1].iter().enumerate() {
                let (Some(regime), Some(mean)) = (self.regime_at([x, y]), self.mean_at([x, y]))
                else {
                    continue;
                };
                let [wide, high] =
                    [(0, i), (1, j)].map(|(axis, at)| ends[axis][at + 1] - ends[axis][at]);
                let below = [x, y - 0.6 * (y - ends[1][j])];
                let cell = (regime, wide * high, below, parts::ink(mean / most));
                match largest.iter_mut().find(|known| known.0 == regime) {
                    Some(known) if known.1 < cell.1 => *known = cell,
                    Some(_) => {}
                    None => largest.push(cell),
                }
            }
        }
        largest.into_iter().map(|(regime, _, place, ink)| (regime.to_owned(), place, ink)).collect()
    }

    /// The values of a key, each once, rising.
    fn values_of(&self, key: usize) -> Vec<f64> {
        let mut values: Vec<f64> = self.rows.iter().map(|row| row.values[key]).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values
    }

    /// The mean of the results at values of both keys.
    fn mean_at(&self, values: [f64; 2]) -> Option<f64> {
        let at = self.rows.iter().filter(|row| row.values[..2] == values);
        let results: Vec<f64> = at.filter_map(|row| row.result).collect();
        (!results.is_empty()).then(|| super::statistics::mean(&results))
    }
}

/// Where cells around values end: half way to the next.
fn bounds(values: &[f64]) -> Vec<f64> {
    let between = values.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    let (first, last) = (values[0], values[values.len() - 1]);
    let (second, before) = (values[1], values[values.len() - 2]);
    let low = first - 0.5 * (second - first);
    let high = last + 0.5 * (last - before);
    [low].into_iter().chain(between).chain([high]).collect()
}

#[cfg(test)]
mod tests {
    use super::bounds;

    #[test]
    fn cells_reach_half_way() {
        assert_eq!(bounds(&[1.0, 2.0, 4.0]), [0.5, 1.5, 3.0, 5.0]);
    }
}
