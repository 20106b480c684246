//! The map of a study over two numbers.

use archard_case::verdict::four;

use super::Study;
use crate::plot::figure::{Curves, Panel, Parts};
use crate::plot::scale::Unit;
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
        let units = values.each_ref().map(|values| Unit::by_powers(size(values)));
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
                notes.push((four(mean * self.unit.factor), place([*x, *y])));
            }
        }
        let edge = |axis: usize| {
            let ends = &ends[axis];
            [ends[0], ends[ends.len() - 1]].map(|end| end * units[axis].factor)
        };
        curves.parts(Parts { edges: [edge(0), edge(1)], parts });
        let few = values.iter().all(|values| values.len() <= WRITTEN);
        let labels =
            [self.unit.label(self.name()), units[0].label(&one.name), units[1].label(&other.name)];
        Some(curves.panel(labels.each_ref().map(String::as_str), |view| {
            let notes = notes.into_iter().filter(|_| few);
            notes.fold(view, |view, (words, place)| view.note(words, place))
        }))
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
