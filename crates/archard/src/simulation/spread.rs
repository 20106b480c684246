//! Fields carried on to pairs that nothing is known of.
//!
//! Pairs that the contact has just reached, or will reach, go through what their neighbours do. They are given the
//! mean of the neighbours that are known, and so on outwards.

use crate::frame::ContactFrame;

/// A field with values everywhere.
pub(super) fn spread(field: Vec<f64>, known: &[bool], frame: &ContactFrame) -> Vec<f64> {
    if frame.is_grid() {
        outwards(field, known.to_vec(), frame.elements())
    } else {
        from_the_nearest(field, known, frame)
    }
}

/// From neighbour to neighbour.
fn outwards(mut field: Vec<f64>, mut known: Vec<bool>, [nx, ny]: [usize; 2]) -> Vec<f64> {
    let mut rim: Vec<usize> = (0..known.len()).filter(|&pair| known[pair]).collect();
    let neighbours = |pair: usize| {
        let (x, y) = (pair % nx, pair / nx);
        let left = (x > 0).then(|| pair - 1);
        let right = (x + 1 < nx).then(|| pair + 1);
        let below = (y > 0).then(|| pair - nx);
        let above = (y + 1 < ny).then(|| pair + nx);
        [left, right, below, above].into_iter().flatten()
    };
    while !rim.is_empty() {
        let open = rim.iter().flat_map(|&pair| neighbours(pair)).filter(|&pair| !known[pair]);
        let mut next: Vec<usize> = open.collect();
        next.sort_unstable();
        next.dedup();
        let mean = |&pair: &usize| {
            let values = neighbours(pair).filter(|&pair| known[pair]).map(|pair| field[pair]);
            values.clone().sum::<f64>() / values.count() as f64
        };
        let values: Vec<f64> = next.iter().map(mean).collect();
        for (&pair, value) in next.iter().zip(values) {
            (field[pair], known[pair]) = (value, true);
        }
        rim = next;
    }
    field
}

/// Where pairs have no rows, from the nearest that something is known of.
fn from_the_nearest(mut field: Vec<f64>, is_known: &[bool], frame: &ContactFrame) -> Vec<f64> {
    let known: Vec<usize> = (0..is_known.len()).filter(|&pair| is_known[pair]).collect();
    let distance = |pair: usize, other: usize| {
        let ([x, y], [u, v]) = (frame.place(pair), frame.place(other));
        (x - u).hypot(y - v).hypot(frame.height(pair) - frame.height(other))
    };
    for pair in (0..is_known.len()).filter(|&pair| !is_known[pair]) {
        let nearest =
            known.iter().min_by(|&&a, &&b| distance(pair, a).total_cmp(&distance(pair, b)));
        if let Some(&nearest) = nearest {
            field[pair] = field[nearest];
        }
    }
    field
}

#[cfg(test)]
mod tests {
    use super::outwards;

    #[test]
    fn the_rim_goes_outwards() {
        let field = vec![0.0, 2.0, 4.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let known = [0, 1, 1, 0, 0, 0, 0, 0].map(|known| known == 1).to_vec();
        assert_eq!(outwards(field, known, [4, 2]), [2.0, 2.0, 4.0, 4.0, 2.0, 2.0, 4.0, 4.0]);
        assert_eq!(outwards(vec![0.0; 4], vec![false; 4], [2, 2]), [0.0; 4]);
    }
}
