//! A few points in the place of the many steps of a history.
//!
//! A point stands for steps that lie near each other: it has their weight and their weighted mean. What that loses is seen by halves: the
//! steps of a point are parted at the mean of each of their values in turn, and what the two halves do differs from what the point
//! does. A mean is right to second order: what is lost grows with the variance of a value, and the halves leave a known part of that.
//! Losses by several values add up; each value is freed of what it shares with those before it, which would count twice. The
//! point that loses most is parted until all of them lose less than what is let pass.

use rayon::prelude::*;

/// A point that stands for steps.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// The sum of the weights of its steps.
    pub weight: f64,
    /// The weighted means of their values.
    pub values: Vec<f64>,
}

/// The points of a history.
#[derive(Debug, Clone, PartialEq)]
pub struct HistoryPoints {
    /// The points.
    pub points: Vec<Point>,
    /// What they lose: the sum of all that differs, of amounts and of places, relative to the sum of all that is done.
    pub loss: f64,
}

/// A step: its weight and its values.
pub type Step = (f64, Vec<f64>);

/// Steps that a point stands for, and what it does.
#[derive(Debug, Clone)]
struct Bin {
    steps: Vec<usize>,
    point: Point,
    /// What one weight of it does.
    effect: Vec<f64>,
}

/// A point, what it loses, and its halves; `None` where all steps are the same.
type Examined = (Bin, f64, Option<[Bin; 2]>);

/// Gathers steps to points that lose no more than `within` of all that they do; `effect` is what a weight of 1 with such values does, in
/// places, none of it negative.
///
/// # Errors
/// Those of the effect.
pub fn gather<E: Send>(
    steps: &[Step],
    within: f64,
    effect: impl Fn(&[f64]) -> Result<Vec<f64>, E> + Sync,
) -> Result<HistoryPoints, E> {
    let bin = |chosen: Vec<usize>| {
        let point = mean(steps, &chosen);
        let effect = effect(&point.values)?;
        Ok::<Bin, E>(Bin { steps: chosen, point, effect })
    };
    let examine = |whole: Bin| {
        let parted = deviations(steps, &whole);
        let halves = parted.par_iter().filter_map(|own| {
            let half = |over: bool| -> Vec<usize> {
                let chosen = whole.steps.iter().zip(own).filter(|(_, own)| (**own > 0.0) == over);
                chosen.map(|(step, _)| *step).collect()
            };
            let [low, high] = [false, true].map(half);
            (!low.is_empty() && !high.is_empty())
                .then(|| Ok(([bin(low)?, bin(high)?], all_halves(steps, &whole, own))))
        });
        let halves = halves.collect::<Result<Vec<([Bin; 2], f64)>, E>>()?;
        let losses = halves.iter().map(|(halves, all)| all * lost(&whole, halves));
        let losses: Vec<f64> = losses.collect();
        let worst = (0..losses.len()).max_by(|&one, &other| losses[one].total_cmp(&losses[other]));
        let halves = worst.map(|worst| halves[worst].0.clone());
        Ok::<Examined, E>((whole, losses.iter().sum(), halves))
    };
    let mut bins = vec![examine(bin((0..steps.len()).collect())?)?];
    loop {
        let loss: f64 = bins.iter().map(|(_, loss, _)| loss).sum();
        let all: f64 = bins.iter().map(|(bin, ..)| done(bin).sum::<f64>()).sum();
        let worst = (0..bins.len()).max_by(|&one, &other| bins[one].1.total_cmp(&bins[other].1));
        if loss > within * all
            && let Some(worst) = worst
            && let (_, _, Some([low, high])) = bins.swap_remove(worst)
        {
            bins.push(examine(low)?);
            bins.push(examine(high)?);
            continue;
        }
        let loss = if all > 0.0 { loss / all } else { 0.0 };
        return Ok(HistoryPoints {
            points: bins.into_iter().map(|(bin, ..)| bin.point).collect(),
            loss,
        });
    }
}

/// The point of the chosen steps.
fn mean(steps: &[Step], chosen: &[usize]) -> Point {
    let weight: f64 = chosen.iter().map(|&step| steps[step].0).sum();
    let variables = steps.first().map_or(0, |(_, values)| values.len());
    let mean = |at: usize| {
        // From the first on, so that values that are all the same stay so.
        let first = steps[chosen[0]].1[at];
        let over = chosen.iter().map(|&step| steps[step].0 * (steps[step].1[at] - first));
        first + over.sum::<f64>() / weight
    };
    Point { weight, values: (0..variables).map(mean).collect() }
}

/// How far each of its steps is from a point, value by value, each freed of what it shares with the values before: sums of products,
/// weighted, are zero. Without values that are the same in all steps, or follow from the others to rounding.
fn deviations(steps: &[Step], whole: &Bin) -> Vec<Vec<f64>> {
    let product = |one: &[f64], other: &[f64]| -> f64 {
        let both = whole.steps.iter().zip(one.iter().zip(other));
        both.map(|(&step, (one, other))| steps[step].0 * one * other).sum()
    };
    let mut found: Vec<Vec<f64>> = vec![];
    for (at, mean) in whole.point.values.iter().enumerate() {
        let own = whole.steps.iter().map(|&step| steps[step].1[at] - mean);
        let mut own: Vec<f64> = own.collect();
        let all = product(&own, &own);
        for other in &found {
            let shared = product(&own, other) / product(other, other);
            own.iter_mut().zip(other).for_each(|(own, other)| *own -= shared * other);
        }
        if product(&own, &own) > f64::EPSILON * all {
            found.push(own);
        }
    }
    found
}

/// What all halves of halves lose over what the first two do: the variance of such deviations over what of it lies between the two.
fn all_halves(steps: &[Step], whole: &Bin, own: &[f64]) -> f64 {
    let (mut all, mut between) = (0.0, 0.0);
    for over in [false, true] {
        let (mut weight, mut first) = (0.0, 0.0);
        for (&step, own) in whole.steps.iter().zip(own).filter(|(_, own)| (**own > 0.0) == over) {
            weight += steps[step].0;
            first += steps[step].0 * own;
            all += steps[step].0 * own * own;
        }
        between += first * first / weight;
    }
    all / between
}

/// What a point does.
fn done(bin: &Bin) -> impl Iterator<Item = f64> {
    bin.effect.iter().map(|effect| bin.point.weight * effect)
}

/// How far what a point does differs from what its halves do.
fn lost(whole: &Bin, [low, high]: &[Bin; 2]) -> f64 {
    let halves = done(low).zip(done(high)).map(|(low, high)| low + high);
    done(whole).zip(halves).map(|(whole, halves)| (whole - halves).abs()).sum()
}

#[cfg(test)]
mod tests {
    use super::{Step, gather};

    /// Values spread over the unit square by the golden ratio, of one weight.
    fn spread(count: usize) -> Vec<Step> {
        let at = |step: usize, factor: f64| (step as f64 * factor).fract();
        let step = |step| (1.0 / count as f64, vec![at(step, 0.618_034), at(step, 0.414_214)]);
        (0..count).map(step).collect()
    }

    /// Work that grows with the fourth power and moves over twenty places: the points do what the steps do, to the loss that is stated,
    /// and there are more of them the less is let pass.
    #[test]
    fn points_do_what_their_steps_do() {
        let steps = spread(2000);
        let effect = |values: &[f64]| {
            let place = 19.0 * values[0];
            let hat = |node: usize| (1.0 - (place - node as f64).abs() / 4.0).max(0.0);
            Ok::<_, ()>(
                (0..20).map(|node| hat(node) * (0.1 + values[1].powi(4))).collect::<Vec<_>>(),
            )
        };
        let sum = |points: &mut dyn Iterator<Item = (f64, Vec<f64>)>| {
            points.fold(vec![0.0; 20], |sum, (weight, values)| {
                let effect = effect(&values).unwrap();
                sum.iter().zip(effect).map(|(sum, one)| sum + weight * one).collect()
            })
        };
        let truth = sum(&mut steps.iter().cloned());
        let mut before = 1;
        for within in [0.2, 0.05, 0.0125] {
            let gathered = gather(&steps, within, effect).unwrap();
            let own = sum(&mut gathered.points.iter().map(|one| (one.weight, one.values.clone())));
            let off: f64 = truth.iter().zip(own).map(|(one, other)| (one - other).abs()).sum();
            let off = off / truth.iter().sum::<f64>();
            assert!(off <= gathered.loss && gathered.loss <= within, "{off} {}", gathered.loss);
            let count = gathered.points.len();
            assert!(count > before && count < 400, "{count}");
            before = count;
        }
    }

    /// Work that grows with the squares of three values that have nothing to do with each other: each adds to the loss.
    #[test]
    fn losses_by_several_values_add_up() {
        let at = |step: usize, factor: f64| (step as f64 * factor).fract();
        let step = |step| {
            let values = [0.819_172_5, 0.671_043_6, 0.549_700_5].map(|factor| at(step, factor));
            (1.0 / 4000.0, values.to_vec())
        };
        let steps: Vec<Step> = (0..4000).map(step).collect();
        let work = |values: &[f64]| values.iter().map(|one| one.powi(2)).sum::<f64>();
        let truth: f64 = steps.iter().map(|(weight, values)| weight * work(values)).sum();
        for within in [0.5, 0.2, 0.05, 0.0125] {
            let gathered =
                gather(&steps, within, |values| Ok::<_, ()>(vec![work(values)])).unwrap();
            let own: f64 = gathered.points.iter().map(|one| one.weight * work(&one.values)).sum();
            let off = (own / truth - 1.0).abs();
            eprintln!("{within} {off} {} {}", gathered.loss, gathered.points.len());
            assert!(
                off <= 1.05 * gathered.loss && gathered.loss <= within,
                "{off} {}",
                gathered.loss
            );
        }
    }

    /// A value that does nothing parts no points, and steps that are all the same are one point without loss.
    #[test]
    fn what_does_nothing_is_not_parted() {
        let linear = |values: &[f64]| Ok::<_, ()>(vec![1.0 + values[0].powi(2)]);
        let steps = spread(500);
        let still: Vec<Step> =
            steps.iter().map(|(weight, values)| (*weight, vec![values[0], 0.3])).collect();
        let [both, one] = [steps, still].map(|steps| gather(&steps, 0.01, linear).unwrap());
        assert_eq!(both.points.len(), one.points.len());
        let same = vec![(0.5, vec![1.0, 0.1]), (0.5, vec![1.0, 0.1])];
        let gathered = gather(&same, 0.01, linear).unwrap();
        assert_eq!((gathered.points.len(), gathered.loss), (1, 0.0));
    }
}
