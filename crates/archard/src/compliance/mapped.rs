//! A compliance between tractions whose admissible set is a disc and the slips that belong to them.
//!
//! With the [`Map`] A of a friction law, tractions t = A t^ and slips s^ = A s, a compliance B becomes A B A, which is
//! symmetric or monotone where B is. Pressures and normal displacements stay as they are.

use std::fmt::Debug;
use std::ops::Deref;

use super::slip::precondition_by_share;
use super::{Coarser, Compliance, PairStatus, Preconditioner, SlipMap};
use crate::frame::{ContactFrame, Flow, Part, VectorField};
use crate::friction::Map;

/// A compliance or a slip map, seen through the map of a friction law.
#[derive(Debug)]
pub struct MappedCompliance<P> {
    inner: P,
    map: Map,
}

impl<P> MappedCompliance<P> {
    /// What a reference points at, seen through a map.
    pub fn new(inner: P, map: Map) -> Self {
        Self { inner, map }
    }
}

impl<P: Deref<Target: SlipMap> + Debug + Send + Sync> SlipMap for MappedCompliance<P> {
    fn apply(&self, tractions: [&[f64]; 2], slip: [&mut [f64]; 2]) {
        let [one, two] = self.map.images(tractions);
        let [x, y] = slip;
        self.inner.apply([&one, &two], [&mut *x, &mut *y]);
        self.map.apply_to([x, y]);
    }

    fn own(&self) -> f64 {
        self.inner.own() * self.map.largest().powi(2)
    }

    /// The inverse of what is mapped, where the compliance governs: pairs that stick, and slip as far as its diagonal
    /// outweighs their own, which is the same in all directions of a mapped traction only.
    fn precondition(&self, slip: [&[f64]; 2], status: &[PairStatus], tractions: [&mut [f64]; 2]) {
        let inverse = self.map.inverse();
        let compliant = |status: &PairStatus| match status {
            PairStatus::Slip { .. } => PairStatus::Slip { diagonal: 0.0 },
            PairStatus::Open | PairStatus::Stick => *status,
        };
        let compliant: Vec<PairStatus> = status.iter().map(compliant).collect();
        precondition_by_share(self.own(), slip, status, tractions, |slip, [one, two]| {
            let [x, y] = inverse.images(slip);
            self.inner.precondition([&x, &y], &compliant, [&mut *one, &mut *two]);
            inverse.apply_to([one, two]);
        });
    }

    fn within(&self, part: &Part) -> Option<Box<dyn SlipMap + '_>> {
        let inner = self.inner.within(part)?;
        Some(Box::new(MappedCompliance::new(inner, self.map)))
    }

    fn coarser(&self) -> Option<Coarser<'_>> {
        let coarser = self.inner.coarser()?;
        Some(Coarser { map: Box::new(MappedCompliance::new(coarser.map, self.map)), ..coarser })
    }
}

impl<P: Deref<Target: Compliance> + Debug + Send + Sync> Compliance for MappedCompliance<P> {
    fn apply(&self, tractions: &VectorField) -> VectorField {
        let VectorField { t1, t2, n } = tractions;
        let [t1, t2] = self.map.images([t1, t2]);
        let mut displacement = self.inner.apply(&VectorField { t1, t2, n: n.clone() });
        self.map.apply_to([&mut displacement.t1, &mut displacement.t2]);
        displacement
    }

    fn apply_normal(&self, pressure: &[f64], displacement: &mut [f64]) {
        self.inner.apply_normal(pressure, displacement);
    }

    fn matrix(&self, pairs: &[usize]) -> Option<Vec<f64>> {
        let mut matrix = self.inner.matrix(pairs)?;
        let count = pairs.len();
        for column in matrix.chunks_exact_mut(3 * count) {
            let (one, rest) = column.split_at_mut(count);
            self.map.apply_to([one, &mut rest[..count]]);
        }
        let (along_t1, rest) = matrix.split_at_mut(3 * count * count);
        self.map.apply_to([along_t1, &mut rest[..3 * count * count]]);
        Some(matrix)
    }

    fn normal_self_term(&self) -> f64 {
        self.inner.normal_self_term()
    }

    fn couples(&self) -> bool {
        self.inner.couples()
    }

    fn balance(&self) -> Vec<(usize, f64, f64)> {
        self.inner.balance()
    }

    fn missed(&self, tractions: &VectorField) -> Option<f64> {
        let VectorField { t1, t2, n } = tractions;
        let [t1, t2] = self.map.images([t1, t2]);
        self.inner.missed(&VectorField { t1, t2, n: n.clone() })
    }

    fn rolling<'a>(&'a self, flow: Flow<'a>) -> Box<dyn SlipMap + 'a> {
        Box::new(MappedCompliance::new(self.inner.rolling(flow), self.map))
    }

    fn shifting<'a>(&'a self, frame: &'a ContactFrame) -> Box<dyn SlipMap + 'a> {
        Box::new(MappedCompliance::new(self.inner.shifting(frame), self.map))
    }

    fn normal_preconditioner(&self, addition: f64) -> Box<dyn Preconditioner + '_> {
        self.inner.normal_preconditioner(addition)
    }
}
