//! Nodes in blocks of neighbours: what is far from a block is far from all of its nodes.

use glam::DVec3;

/// Nodes of a block; a multiple of the lanes of the widest vectors. A choice of cost.
pub(super) const BLOCK: usize = 64;

/// Divides nodes at those places into blocks, all of them full but the last.
pub(super) fn blocks(places: &[DVec3]) -> Vec<Vec<usize>> {
    let mut nodes: Vec<usize> = (0..places.len()).collect();
    divide(&mut nodes, places);
    nodes.chunks(BLOCK).map(<[usize]>::to_vec).collect()
}

/// Sorts nodes so that each run of a block's length is close together: in halves across the longest extent.
fn divide(nodes: &mut [usize], places: &[DVec3]) {
    let count = nodes.len().div_ceil(BLOCK);
    if count < 2 {
        return;
    }
    let low = nodes.iter().fold(DVec3::INFINITY, |low, &node| low.min(places[node]));
    let high = nodes.iter().fold(DVec3::NEG_INFINITY, |high, &node| high.max(places[node]));
    let extent = high - low;
    let axis = (0..3).max_by(|&a, &b| extent[a].total_cmp(&extent[b])).unwrap_or(0);
    nodes.sort_by(|&a, &b| places[a][axis].total_cmp(&places[b][axis]).then(a.cmp(&b)));
    let (left, right) = nodes.split_at_mut(count / 2 * BLOCK);
    divide(left, places);
    divide(right, places);
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::{BLOCK, blocks};

    #[test]
    fn every_node_is_in_one_block_among_its_neighbours() {
        let places: Vec<DVec3> =
            (0..40 * 40).map(|i| DVec3::new(f64::from(i % 40), f64::from(i / 40), 0.0)).collect();
        let blocks = blocks(&places);
        let mut seen: Vec<usize> = blocks.iter().flatten().copied().collect();
        seen.sort_unstable();
        assert_eq!(seen, (0..places.len()).collect::<Vec<_>>());
        for block in &blocks {
            assert!(block.len() <= BLOCK);
            let apart = |axis: usize| {
                let values = block.iter().map(|&node| places[node][axis]);
                values.clone().fold(f64::MIN, f64::max) - values.fold(f64::MAX, f64::min)
            };
            assert!(apart(0) <= 16.0 && apart(1) <= 16.0, "{} {}", apart(0), apart(1));
        }
    }
}
