//! Rising numbers in which a value is found at once, however many they are.

/// Numbers that do not fall, in as many buckets of one width as there are numbers.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Sorted {
    values: Vec<f64>,
    /// How many of them lie in buckets before each.
    before: Vec<u32>,
    /// Buckets per unit.
    density: f64,
}

impl Sorted {
    /// Numbers that do not fall.
    pub fn new(values: Vec<f64>) -> Self {
        let width = match (values.first(), values.last()) {
            (Some(first), Some(last)) => last - first,
            _ => 0.0,
        };
        let density = if width > 0.0 { values.len() as f64 / width } else { 0.0 };
        let mut sorted = Self { before: vec![0; values.len() + 2], values, density };
        for at in 0..sorted.values.len() {
            let bucket = sorted.bucket(sorted.values[at]);
            sorted.before[bucket + 1] += 1;
        }
        for bucket in 1..sorted.before.len() {
            sorted.before[bucket] += sorted.before[bucket - 1];
        }
        sorted
    }

    /// All of them.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// How many are not greater than a value.
    pub fn up_to(&self, value: f64) -> usize {
        // A bucket does not fall where its value rises, so that the others lie on one side as a whole.
        let bucket = self.bucket(value);
        let [first, last] = [bucket, bucket + 1].map(|at| self.before[at] as usize);
        first + self.values[first..last].partition_point(|own| *own <= value)
    }

    fn bucket(&self, value: f64) -> usize {
        let first = self.values.first().copied().unwrap_or_default();
        // A cast takes what lies before the first as 0, as it does what is no number.
        (((value - first) * self.density) as usize).min(self.values.len())
    }
}

#[cfg(test)]
mod tests {
    use super::Sorted;

    #[test]
    fn a_value_is_found_as_by_halving() {
        let even = (0..50).map(f64::from).collect();
        let uneven = (0..50).map(|at| (f64::from(at) / 7.0).exp()).collect();
        let lists: [Vec<f64>; 6] =
            [even, uneven, vec![], vec![2.0], vec![1.0, 1.0, 1.0], vec![-1.0, 0.0, 0.0, 1e6]];
        for values in lists {
            let sorted = Sorted::new(values.clone());
            let near = values.iter().flat_map(|one| [one.next_down(), *one, one.next_up()]);
            for value in near.chain([f64::NEG_INFINITY, -3.0, 0.3, 49.5, 2e6, f64::INFINITY]) {
                let expected = values.partition_point(|own| *own <= value);
                assert_eq!(sorted.up_to(value), expected, "{values:?} {value}");
            }
        }
    }
}
