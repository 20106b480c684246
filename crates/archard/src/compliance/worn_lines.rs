//! The compliance of bodies that wear as they roll: pressures in a line of rolling wear all of it.
//!
//! Over some revolutions a line wears by its slope times the sum of its pressures, and that opens the gap
//! along the whole line: a matrix of rank one next to the elastic compliance, line by line. It is
//! symmetric and positive, so that an implicit step of wear is one normal contact problem. Where lines share
//! pairs, the elastic preconditioner has to do.

use std::ops::Deref;

use super::{Compliance, Preconditioner, normal_displacement};
use crate::frame::{self, Flow, Part, VectorField, extent};
use crate::numerics::dense::Cholesky;
use crate::numerics::vector::Values;

/// Share of the load that has to move from line to line for pressures worth foreseeing. A choice of cost: a start does not change
/// what is found.
const HARDLY: f64 = 0.03;

/// A compliance with the wear of its lines.
#[derive(Debug)]
pub struct WornLines<'a> {
    elastic: Elastic<'a>,
    lines: Vec<Line>,
    /// Elastic displacement (m/Pa) that uniform unit pressure on the contact of a line makes, a pair on the
    /// average, of a line that many lines away.
    between: Vec<f64>,
    /// Whether each line has pairs of its own and some of them touch.
    rows: bool,
    /// Areas of the pairs relative to the mean.
    weight: Values<'a>,
}

/// The elastic compliance of the frame, or of a part of it.
#[derive(Debug)]
enum Elastic<'a> {
    Whole(&'a dyn Compliance),
    Part(Box<dyn Compliance + 'a>),
}

impl<'a> Deref for Elastic<'a> {
    type Target = dyn Compliance + 'a;

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Whole(elastic) => *elastic,
            Self::Part(elastic) => &**elastic,
        }
    }
}

/// A line of rolling.
#[derive(Debug)]
struct Line {
    /// All its pairs, how much of each lies in it, and those in contact.
    pairs: Vec<usize>,
    shares: Vec<f64>,
    contact: Vec<usize>,
    /// Wear (m) of the line under a unit pressure (Pa) on one pair of mean area.
    slope: f64,
}

impl<'a> WornLines<'a> {
    /// Planes of rolling that wear by these slopes (m/Pa) while about the pairs under the given pressure are in
    /// contact.
    pub fn new(
        elastic: &'a dyn Compliance,
        flow: Flow<'a>,
        slopes: &[f64],
        pressure: &[f64],
    ) -> Self {
        let line = |(line, &slope): (&frame::Line, &f64)| {
            let pairs: Vec<usize> = line.passages.iter().map(|one| one.pair).collect();
            Line {
                contact: pairs.iter().copied().filter(|&pair| pressure[pair] > 0.0).collect(),
                pairs,
                shares: line.passages.iter().map(|one| one.share).collect(),
                slope,
            }
        };
        let mut lines: Vec<Line> = flow.lines().iter().zip(slopes).map(line).collect();
        let mut between = vec![];
        if flow.has_rows() {
            spread_contact(&mut lines);
            between = self::between(elastic, &lines, flow.frame().elements());
        }
        // Where nothing touches, nothing is known between rows.
        let rows = !between.is_empty();
        let weight = flow.frame().measure().weight;
        let elastic = Elastic::Whole(elastic);
        Self { elastic, lines, between, rows, weight }
    }

    /// Sum of the pressures (Pa) of a line, weighted by areas.
    fn sum(&self, line: &Line, pressure: &[f64]) -> f64 {
        let parts = line.pairs.iter().zip(&line.shares);
        parts.map(|(&pair, share)| share * self.weight.at(pair) * pressure[pair]).sum()
    }

    /// Pressures (Pa) to start from under a load, given as the sum of all pressures (Pa): in each row those
    /// that were there, or in the nearest line that touched, scaled to what the line takes of the
    /// load as the wear goes on. `None` where they are hardly others, or not found.
    pub fn foresee(&self, gap: &[f64], total: f64, pressure: &[f64]) -> Option<Vec<f64>> {
        if !self.rows {
            return None;
        }
        let mean = |line: &Line| {
            line.contact.iter().map(|&pair| gap[pair]).sum::<f64>() / line.contact.len() as f64
        };
        let before: Vec<f64> = self.lines.iter().map(|line| self.sum(line, pressure)).collect();
        let touching: Vec<bool> = before.iter().map(|&sum| sum > 0.0).collect();
        let first = touching.iter().position(|&touches| touches)?;
        let last = touching.iter().rposition(|&touches| touches)?;
        let gap = self.lines.iter().map(mean).collect();
        let across = Across { lines: &self.lines, between: &self.between, gap };
        let sums = across.share(total, touching)?;
        let change: f64 = sums.iter().zip(&before).map(|(now, then)| (now - then).abs()).sum();
        if change < HARDLY * total {
            return None;
        }
        let mut foreseen = vec![0.0; pressure.len()];
        for (index, (line, sum)) in self.lines.iter().zip(&sums).enumerate() {
            let nearest = index.clamp(first, last);
            let source = &self.lines[nearest];
            if before[nearest] > 0.0 {
                let along: Vec<f64> = source.pairs.iter().map(|&pair| pressure[pair]).collect();
                let scaled = as_a_line(&along, sum / before[nearest]);
                line.pairs.iter().zip(scaled).for_each(|(&pair, value)| foreseen[pair] = value);
            }
        }
        Some(foreseen)
    }

    /// Adds to displacements (m) what pressures (Pa) wear, times a factor.
    pub fn add_wear(&self, pressure: &[f64], factor: f64, displacement: &mut [f64]) {
        for line in &self.lines {
            let sum = self.sum(line, pressure);
            if sum != 0.0 {
                let depth = factor * line.slope * sum;
                let parts = line.pairs.iter().zip(&line.shares);
                parts.for_each(|(&pair, share)| displacement[pair] += share * depth);
            }
        }
    }
}

/// How the sums of the pressures of lines share a load, each line taken as one: the contact problem
/// across the lines.
struct Across<'a> {
    lines: &'a [Line],
    between: &'a [f64],
    /// Mean gap (m) over the contact of each line.
    gap: Vec<f64>,
}

impl Across<'_> {
    /// Mean displacement (m) of a line under a unit sum (Pa) of another's pressures.
    fn element(&self, row: usize, column: usize) -> f64 {
        let own = if row == column { self.lines[row].slope } else { 0.0 };
        self.between[row.abs_diff(column)] + own
    }

    /// The sums (Pa) that add up to a total; `None` if they are not found.
    fn share(&self, total: f64, first: Vec<bool>) -> Option<Vec<f64>> {
        let mut touching = first;
        // A set leaves or takes up a line at least.
        for _ in 0..=self.lines.len() {
            let set: Vec<usize> = (0..self.lines.len()).filter(|&line| touching[line]).collect();
            let factors = Cholesky::new(set.len(), |i, j| self.element(set[i], set[j]))?;
            let ones = factors.solve(&vec![1.0; set.len()]);
            let opposed =
                factors.solve(&set.iter().map(|&line| self.gap[line]).collect::<Vec<_>>());
            let (lift, drop) = (ones.iter().sum::<f64>(), opposed.iter().sum::<f64>());
            let approach = (total + drop) / lift;
            let mut sums = vec![0.0; self.lines.len()];
            for ((&line, one), opposed) in set.iter().zip(&ones).zip(&opposed) {
                sums[line] = approach * one - opposed;
            }
            let mut changed = false;
            for line in 0..self.lines.len() {
                let touches = if touching[line] {
                    sums[line] > 0.0
                } else {
                    let lifted: f64 =
                        set.iter().map(|&other| self.element(line, other) * sums[other]).sum();
                    self.gap[line] + lifted < approach
                };
                changed |= touches != touching[line];
                touching[line] = touches;
            }
            if !changed {
                return Some(sums);
            }
        }
        None
    }
}

/// The pressures along a line when what it bears changes by a factor: as in a line contact of Hertz, peak
/// and width both change with its root.
fn as_a_line(pressure: &[f64], factor: f64) -> Vec<f64> {
    let root = factor.max(0.0).sqrt();
    let total: f64 = pressure.iter().sum();
    let centre = pressure.iter().enumerate().map(|(i, p)| i as f64 * p).sum::<f64>() / total;
    let at = |place: f64| {
        let low = place.floor();
        let value = |index: f64| {
            if index < 0.0 { 0.0 } else { pressure.get(index as usize).copied().unwrap_or(0.0) }
        };
        let share = place - low;
        (1.0 - share) * value(low) + share * value(low + 1.0)
    };
    if root == 0.0 {
        return vec![0.0; pressure.len()];
    }
    (0..pressure.len()).map(|i| root * at(centre + (i as f64 - centre) / root)).collect()
}

/// Gives lines that do not touch yet the contact of the nearest that do: some of them will touch.
fn spread_contact(lines: &mut [Line]) {
    let touching = |line: &Line| !line.contact.is_empty();
    let (Some(first), Some(last)) =
        (lines.iter().position(touching), lines.iter().rposition(touching))
    else {
        return;
    };
    for (from, to) in [(first, 0..first), (last, last + 1..lines.len())] {
        let source = &lines[from];
        let number = |pair: &usize| source.pairs.iter().position(|other| other == pair);
        let numbers: Vec<usize> = source.contact.iter().filter_map(number).collect();
        for line in &mut lines[to] {
            line.contact = numbers.iter().map(|&number| line.pairs[number]).collect();
        }
    }
}

/// See [`WornLines`]: found from the widest contact, on the part of the frame whose lines it crosses.
fn between(elastic: &dyn Compliance, lines: &[Line], elements: [usize; 2]) -> Vec<f64> {
    let widest = lines.iter().max_by_key(|line| line.contact.len());
    let Some(widest) = widest.filter(|line| !line.contact.is_empty()) else { return vec![] };
    let number = |pair: &usize| widest.pairs.iter().position(|other| other == pair);
    let numbers: Vec<usize> = widest.contact.iter().filter_map(number).collect();
    let pairs = elements[0] * elements[1];
    let mut crossed = vec![0.0; pairs];
    for line in lines {
        numbers.iter().for_each(|&number| crossed[line.pairs[number]] = 1.0);
    }
    let mut pressure = vec![0.0; pairs];
    numbers.iter().for_each(|&number| pressure[lines[0].pairs[number]] = 1.0);
    let part = extent(elements, |pair| crossed[pair] > 0.0);
    let part = part.and_then(|extent| Part::around(elements, &extent, [0; 2]));
    let displacement = part
        .and_then(|part| {
            Some(part.put(&normal_displacement(&*elastic.within(&part)?, &part.cut(&pressure))))
        })
        .unwrap_or_else(|| normal_displacement(elastic, &pressure));
    let sum = |line: &Line| numbers.iter().map(|&n| displacement[line.pairs[n]]).sum::<f64>();
    lines.iter().map(|line| sum(line) / (numbers.len() * numbers.len()) as f64).collect()
}

impl Compliance for WornLines<'_> {
    fn apply(&self, tractions: &VectorField) -> VectorField {
        let mut displacement = self.elastic.apply(tractions);
        self.add_wear(&tractions.n, 1.0, &mut displacement.n);
        displacement
    }

    fn apply_normal(&self, pressure: &[f64], displacement: &mut [f64]) {
        self.elastic.apply_normal(pressure, displacement);
        self.add_wear(pressure, 1.0, displacement);
    }

    fn normal_self_term(&self) -> f64 {
        self.elastic.normal_self_term()
    }

    fn couples(&self) -> bool {
        self.elastic.couples()
    }

    /// The mean over the contact of a line and the deviations from it are taken apart: wear does not see
    /// the deviations, and the means are few enough to be solved for.
    fn normal_preconditioner(&self, addition: f64) -> Box<dyn Preconditioner + '_> {
        let elastic = self.elastic.normal_preconditioner(addition);
        if !self.rows {
            return elastic;
        }
        Box::new(ByPlanes { elastic, worn: self, addition, contact: Contact::default() })
    }

    /// Rows of pairs that give way to the pressures, and only to those.
    fn within(&self, part: &Part) -> Option<Box<dyn Compliance + '_>> {
        let gives_way = |line: &Line| line.slope >= 0.0;
        if !self.rows || !self.lines.iter().all(gives_way) {
            return None;
        }
        let elastic = Elastic::Part(self.elastic.within(part)?);
        let lines = self.lines.iter().map(|line| line.within(part));
        let lines = lines.filter(|line| !line.pairs.is_empty()).collect();
        let (between, rows) = (self.between.clone(), self.rows);
        Some(Box::new(WornLines { elastic, lines, between, rows, weight: self.weight }))
    }

    fn least_displacement(&self, away: [usize; 2]) -> f64 {
        self.elastic.least_displacement(away)
    }
}

impl Line {
    /// What of it lies in a part of the frame.
    fn within(&self, part: &Part) -> Self {
        let parts = self.pairs.iter().zip(&self.shares);
        let parts = parts.filter_map(|(&pair, &share)| Some((part.place(pair)?, share)));
        let (pairs, shares) = parts.unzip();
        let contact = self.contact.iter().filter_map(|&pair| part.place(pair)).collect();
        Self { pairs, shares, contact, slope: self.slope }
    }
}

/// Means over the contact of each line by Cholesky's factors, deviations by the elastic preconditioner.
#[derive(Debug)]
struct ByPlanes<'a> {
    elastic: Box<dyn Preconditioner + 'a>,
    worn: &'a WornLines<'a>,
    addition: f64,
    contact: Contact,
}

/// The contact line by line.
#[derive(Debug, Default)]
struct Contact {
    rows: Vec<Row>,
    /// Factors of the matrix between the sums of the rows.
    means: Option<Cholesky>,
}

/// The pairs in contact of a line.
#[derive(Debug, PartialEq)]
struct Row {
    line: usize,
    pairs: Vec<usize>,
}

impl Contact {
    /// The pairs of lines in contact, and the factors of what is between them.
    fn new(contact: &[f64], worn: &WornLines<'_>, addition: f64) -> Self {
        let row = |(line, pairs): (usize, &Line)| Row {
            line,
            pairs: pairs.pairs.iter().copied().filter(|&pair| contact[pair] != 0.0).collect(),
        };
        let rows = worn.lines.iter().enumerate().map(row);
        let rows: Vec<Row> = rows.filter(|row| !row.pairs.is_empty()).collect();
        let element = |i: usize, j: usize| {
            let [one, other] = [&rows[i], &rows[j]];
            let [pairs, others] = [one, other].map(|row| row.pairs.len() as f64);
            let own = if i == j { worn.lines[one.line].slope + addition / pairs } else { 0.0 };
            pairs * others * (worn.between[one.line.abs_diff(other.line)] + own)
        };
        let means = Cholesky::new(rows.len(), element);
        Self { rows, means }
    }

    /// Takes the mean over its contact from each line; returns the sums.
    fn deviate(&self, values: &mut [f64]) -> Vec<f64> {
        let take = |row: &Row| {
            let sum: f64 = row.pairs.iter().map(|&pair| values[pair]).sum();
            let mean = sum / row.pairs.len() as f64;
            row.pairs.iter().for_each(|&pair| values[pair] -= mean);
            sum
        };
        self.rows.iter().map(take).collect()
    }
}

impl Preconditioner for ByPlanes<'_> {
    fn keep_to(&mut self, contact: &[f64]) {
        self.contact = Contact::new(contact, self.worn, self.addition);
    }

    fn apply(&self, displacement: &[f64], pressure: &mut [f64]) {
        let contact = &self.contact;
        let Some(means) = &contact.means else {
            return self.elastic.apply(displacement, pressure);
        };
        let mut deviations = displacement.to_vec();
        let sums = contact.deviate(&mut deviations);
        self.elastic.apply(&deviations, pressure);
        contact.deviate(pressure);
        for (row, mean) in contact.rows.iter().zip(means.solve(&sums)) {
            row.pairs.iter().for_each(|&pair| pressure[pair] += mean);
        }
    }
}
