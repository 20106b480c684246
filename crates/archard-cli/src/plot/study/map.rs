//! The map of a study over two numbers.

use super::{Row, Study};
use crate::plot::figure::{COLOURS, Curves, Panel, Parts, Pen, View};
use crate::plot::parts;
use crate::plot::scale::plain;
use crate::plot::tables::size;

/// Most values along an axis for cells to be as wide as each other, with their values named and their results written.
const WRITTEN: usize = 8;

/// An axis of the map: its values (SI), where each stands, and where its cells end.
struct Axis {
    values: Vec<f64>,
    places: Vec<f64>,
    ends: Vec<f64>,
    /// What stands at the places 1, 2, 3, of few values.
    named: Vec<String>,
}

impl Axis {
    /// Of few values, which may lie decades apart, each takes as much room; many stand where they are, by a factor from SI.
    fn of(values: Vec<f64>, factor: f64, few: bool) -> Self {
        if few {
            let places: Vec<f64> = (1..=values.len()).map(|place| place as f64).collect();
            let named = values.iter().map(|value| plain(value * factor)).collect();
            return Self { ends: bounds(&places), values, places, named };
        }
        let places: Vec<f64> = values.iter().map(|value| value * factor).collect();
        Self { ends: bounds(&places), values, places, named: vec![] }
    }

    fn edges(&self) -> [f64; 2] {
        [self.ends[0], self.ends[self.ends.len() - 1]]
    }
}

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
        let labels = [(one, 0), (other, 1)].map(|(key, axis)| key.axis(size(&values[axis])));
        let few = values.iter().all(|values| values.len() <= WRITTEN);
        let [x, y] = values;
        let axes = [Axis::of(x, labels[0].1.factor, few), Axis::of(y, labels[1].1.factor, few)];
        let most = self.rows.iter().filter_map(|row| row.result).fold(0.0, f64::max);
        let mut curves = Curves::new();
        let (mut parts, mut notes) = (vec![], vec![]);
        for (i, x) in axes[0].values.iter().enumerate() {
            for (j, y) in axes[1].values.iter().enumerate() {
                let Some(mean) = self.mean_at([*x, *y]) else { continue };
                let [left, right] = [axes[0].ends[i], axes[0].ends[i + 1]];
                let [low, high] = [axes[1].ends[j], axes[1].ends[j + 1]];
                let corners = vec![[left, low], [right, low], [right, high], [left, high]];
                parts.push((corners, mean * self.unit.factor));
                let place = [axes[0].places[i], axes[1].places[j]];
                let doubtful = self.rows_at([*x, *y]).any(|row| row.doubt.is_some());
                let mark = if doubtful { " ?" } else { "" };
                let words = format!("{}{mark}", plain(mean * self.unit.factor));
                notes.push((words, place, parts::ink(mean / most)));
            }
        }
        curves.parts(Parts { edges: axes.each_ref().map(Axis::edges), parts });
        for (from, to) in self.borders(&axes) {
            let line = [from, to].map(|[x, y]| (x, y));
            curves.add(line, Pen::under("#ffffff"), None);
            curves.add(line, Pen::line(COLOURS[2]), None);
        }
        notes.extend(self.regions(&axes, most));
        let [x, y] = labels.each_ref().map(|(words, unit)| unit.label(words));
        let labels = [self.unit.label(self.name()), x, y];
        Some(curves.panel(labels.each_ref().map(String::as_str), |view| {
            let ends = axes.each_ref().map(|axis| axis.edges().map(Some));
            let view = View { ends, steps: axes.map(|axis| axis.named), ..view };
            let notes = notes.into_iter().filter(|_| few);
            notes.fold(view, |view, (words, place, colour)| view.note_in(words, place, colour))
        }))
    }

    /// What fretting was at values of both keys, if all rows agree.
    fn regime_at(&self, values: [f64; 2]) -> Option<&str> {
        let mut at = self.rows_at(values);
        let first = at.next()?.regime.as_deref()?;
        at.all(|row| row.regime.as_deref() == Some(first)).then_some(first)
    }

    /// The edges between cells of different regimes.
    fn borders(&self, [x, y]: &[Axis; 2]) -> Vec<([f64; 2], [f64; 2])> {
        let regime = |i: usize, j: usize| self.regime_at([*x.values.get(i)?, *y.values.get(j)?]);
        let differ = |one: [usize; 2], other: [usize; 2]| {
            let pair = [one, other].map(|[i, j]| regime(i, j));
            matches!(pair, [Some(one), Some(other)] if one != other)
        };
        let mut lines = vec![];
        for i in 0..x.values.len() {
            for j in 0..y.values.len() {
                let corner = |across: usize, up: usize| [x.ends[i + across], y.ends[j + up]];
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

    /// The name of each regime, below the number of the cell nearest to the middle of its region, with its place and colour.
    fn regions(&self, [x, y]: &[Axis; 2], most: f64) -> Vec<(String, [f64; 2], &'static str)> {
        let mut regions: Vec<(&str, Vec<[usize; 2]>)> = vec![];
        for i in 0..x.values.len() {
            for j in 0..y.values.len() {
                let Some(regime) = self.regime_at([x.values[i], y.values[j]]) else { continue };
                match regions.iter_mut().find(|known| known.0 == regime) {
                    Some((_, cells)) => cells.push([i, j]),
                    None => regions.push((regime, vec![[i, j]])),
                }
            }
        }
        let name = |(regime, cells): (&str, Vec<[usize; 2]>)| {
            let mean = |axis: usize| {
                cells.iter().map(|cell| cell[axis] as f64).sum::<f64>() / cells.len() as f64
            };
            let middle = [mean(0), mean(1)];
            let off =
                |cell: &[usize; 2]| (cell[0] as f64 - middle[0]).hypot(cell[1] as f64 - middle[1]);
            let [i, j] = cells.iter().copied().min_by(|a, b| off(a).total_cmp(&off(b)))?;
            let ink = parts::ink(self.mean_at([x.values[i], y.values[j]])? / most);
            let below = y.places[j] - 0.6 * (y.places[j] - y.ends[j]);
            Some((regime.to_owned(), [x.places[i], below], ink))
        };
        regions.into_iter().filter_map(name).collect()
    }

    /// The values of a key, each once, rising.
    fn values_of(&self, key: usize) -> Vec<f64> {
        let mut values: Vec<f64> = self.rows.iter().map(|row| row.values[key]).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values
    }

    /// The rows at values of both keys.
    fn rows_at(&self, values: [f64; 2]) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(move |row| row.values[..2] == values)
    }

    /// The mean of the results at values of both keys.
    fn mean_at(&self, values: [f64; 2]) -> Option<f64> {
        let results: Vec<f64> = self.rows_at(values).filter_map(|row| row.result).collect();
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
    use super::{Axis, bounds};

    /// Values decades apart have cells of one width, and their names.
    #[test]
    fn few_values_take_the_same_room() {
        let axis = Axis::of(vec![1e-7, 1e-6, 1e-4], 1e6, true);
        assert_eq!(axis.ends, [0.5, 1.5, 2.5, 3.5]);
        assert_eq!(axis.named, ["0.1", "1", "100"]);
        let many = Axis::of(vec![1e-6, 2e-6], 1e6, false);
        assert!(many.named.is_empty() && (many.places[1] - 2.0).abs() < 1e-12);
    }

    #[test]
    fn cells_reach_half_way() {
        assert_eq!(bounds(&[1.0, 2.0, 4.0]), [0.5, 1.5, 3.0, 5.0]);
    }
}
