//! Gmsh's kinds of elements.

/// A kind of element.
#[derive(Debug, Clone, Copy)]
pub(super) struct Kind {
    /// 0 for points, 1 for lines, 2 for surfaces, 3 for volumes.
    pub dimension: u64,
    /// How many nodes it has.
    pub nodes: usize,
}

/// Dimension and number of nodes of the kinds from 1 on.
const KINDS: [(u64, usize); 31] = [
    (1, 2),
    (2, 3),
    (2, 4),
    (3, 4),
    (3, 8),
    (3, 6),
    (3, 5),
    (1, 3),
    (2, 6),
    (2, 9),
    (3, 10),
    (3, 27),
    (3, 18),
    (3, 14),
    (0, 1),
    (2, 8),
    (3, 20),
    (3, 15),
    (3, 13),
    (2, 9),
    (2, 10),
    (2, 12),
    (2, 15),
    (2, 15),
    (2, 21),
    (1, 4),
    (1, 5),
    (1, 6),
    (3, 20),
    (3, 35),
    (3, 56),
];

/// The kind of that number, if it is known.
pub(super) fn kind(number: u64) -> Option<Kind> {
    let place = usize::try_from(number).ok()?.checked_sub(1)?;
    KINDS.get(place).map(|&(dimension, nodes)| Kind { dimension, nodes })
}
