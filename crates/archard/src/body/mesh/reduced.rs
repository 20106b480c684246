//! How nodes of a body give way, as a matrix that another program made.

/// What a matrix holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Holds {
    /// Forces (N) by displacements (m).
    Stiffness,
    /// Displacements (m) by forces (N).
    Flexibility,
}

/// The stiffness or flexibility of a body reduced to some of its nodes, symmetric.
#[derive(Debug, Clone, PartialEq)]
pub struct ReducedMatrix {
    /// What the matrix holds.
    pub holds: Holds,
    /// Of each row the node, as the file numbers it, and the direction: 0 to 2 for x, y and z; others are rotations or shapes of
    /// their own.
    pub labels: Vec<(i64, usize)>,
    /// The rows of a node of the [`Volume`](super::Volume) along x, y and z, for the nodes of the zone and all others that both know.
    pub rows: Vec<(usize, [Option<usize>; 3])>,
    /// Row, column and value (N/m or m/N), on and below the diagonal.
    pub entries: Vec<(usize, usize, f64)>,
    /// How far a value may be off in the file, relative to it: half of the last digit.
    pub rounding: f64,
}

impl ReducedMatrix {
    /// Number of rows.
    pub fn size(&self) -> usize {
        self.labels.len()
    }

    /// The values on the diagonal (N/m or m/N).
    pub fn diagonal(&self) -> Vec<f64> {
        let mut diagonal = vec![0.0; self.size()];
        let own = self.entries.iter().filter(|(row, column, _)| row == column);
        own.for_each(|(row, _, value)| diagonal[*row] = *value);
        diagonal
    }
}
