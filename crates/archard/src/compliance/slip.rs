//! How tangential tractions change the slip of the pairs, seen by the solvers of friction.

use std::fmt::Debug;

use serde::{Deserialize, Serialize};

use super::Compliance;
use crate::frame::{ContactFrame, Flow, Part, VectorField};
use crate::numerics::vector::{map, update};

/// A linear map from tangential tractions (Pa) to the slip (m) they take away.
///
/// In steady rolling the slip is that of a particle on its passage to a pair: what it gains of the elastic
/// displacements, in rows their difference from the pair ahead, where the map is monotone, t . B t >= 0, but nearly
/// skew.
pub trait SlipMap: Debug + Send + Sync {
    /// The slip (m) that tractions (Pa) take away, along t1 and t2, one value a pair.
    fn apply(&self, tractions: [&[f64]; 2], slip: [&mut [f64]; 2]);

    /// Slip (m) of a pair under a unit traction (Pa) on it alone; the larger of both directions.
    fn own(&self) -> f64;

    /// Tractions (Pa) that nearly take a slip (m) away where the pairs of the frame have this status. By default a
    /// division by the diagonal.
    fn precondition(&self, slip: [&[f64]; 2], status: &[PairStatus], tractions: [&mut [f64]; 2]) {
        for (pair, status) in status.iter().enumerate() {
            let factor = match status {
                PairStatus::Open => 0.0,
                PairStatus::Stick => 1.0 / self.own(),
                PairStatus::Slip { diagonal } => 1.0 / (diagonal + self.own()),
            };
            (0..2).for_each(|axis| tractions[axis][pair] = slip[axis][pair] * factor);
        }
    }

    /// The same map on a part of the frame; `None` where that is not possible.
    fn within(&self, _part: &Part) -> Option<Box<dyn SlipMap + '_>> {
        None
    }

    /// The same map on elements of twice the size that begin where these do; `None` where
    /// that is not possible.
    fn coarser(&self) -> Option<Coarser<'_>> {
        None
    }
}

/// A map on elements of twice the size.
#[derive(Debug)]
pub struct Coarser<'a> {
    /// The map.
    pub map: Box<dyn SlipMap + 'a>,
    /// Number of elements along x and y.
    pub elements: [usize; 2],
    /// Slip of a pair there relative to that of the pairs it stands for.
    pub slip: f64,
}

/// What a pair does.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum PairStatus {
    /// It is not in contact, or bears no tangential traction.
    Open,
    /// It sticks: what is unknown is its traction.
    Stick,
    /// It slips: what is unknown is the direction of its traction.
    Slip {
        /// What the linear system has besides the map on the diagonal (m/Pa).
        diagonal: f64,
    },
}

/// [`SlipMap::precondition`] with what undoes the map of all pairs, for maps that are symmetric. It governs pairs that
/// stick, and pairs that slip as far as their diagonal in the map, `own` (m/Pa), outweighs the one next to it.
pub(super) fn precondition_by_share(
    own: f64,
    slip: [&[f64]; 2],
    status: &[PairStatus],
    [one, two]: [&mut [f64]; 2],
    undo: impl FnOnce([&[f64]; 2], [&mut [f64]; 2]),
) {
    let share = |status: &PairStatus| match status {
        PairStatus::Open => 0.0,
        PairStatus::Stick => 1.0,
        PairStatus::Slip { diagonal } => own / (own + diagonal),
    };
    let roots: Vec<f64> = status.iter().map(|status| share(status).sqrt()).collect();
    let weighed = slip.map(|slip| map([slip, &roots], |[slip, root]| slip * root));
    undo([&weighed[0], &weighed[1]], [&mut *one, &mut *two]);
    for (tractions, slip) in [one, two].into_iter().zip(slip) {
        update(tractions, [&roots], |traction, [root]| root * traction);
        for (pair, status) in status.iter().enumerate() {
            if let PairStatus::Slip { diagonal } = status {
                let rest = 1.0 - roots[pair] * roots[pair];
                tractions[pair] += rest * slip[pair] / (diagonal + own);
            }
        }
    }
}

/// Steady rolling on any compliance.
#[derive(Debug)]
pub(super) struct Differenced<'a, C: ?Sized> {
    compliance: &'a C,
    flow: Flow<'a>,
    /// The mean length of passages relative to that of each; none where all are the same.
    rate: Option<Vec<f64>>,
    own: f64,
}

impl<'a, C: Compliance + ?Sized> Differenced<'a, C> {
    pub fn new(compliance: &'a C, flow: Flow<'a>) -> Self {
        let mean = flow.advance();
        let rate =
            flow.advances().map(|advances| advances.iter().map(|advance| mean / advance).collect());
        let mut map = Self { compliance, flow, rate, own: 0.0 };
        map.own = own(flow.frame().len(), flow.middle(), |tractions| map.taken(tractions));
        map
    }

    /// The slip that tractions take away.
    fn taken(&self, tractions: &VectorField) -> [Vec<f64>; 2] {
        let displacement = self.compliance.apply(tractions);
        let mut gained = self.flow.gained([&displacement.t1, &displacement.t2]);
        if let Some(rate) = &self.rate {
            for gained in &mut gained {
                gained.iter_mut().zip(rate).for_each(|(gained, rate)| *gained *= rate);
            }
        }
        gained
    }
}

/// Bodies shifted against each other on any compliance.
#[derive(Debug)]
pub(super) struct Direct<'a, C: ?Sized> {
    compliance: &'a C,
    own: f64,
}

impl<'a, C: Compliance + ?Sized> Direct<'a, C> {
    pub fn new(compliance: &'a C, frame: &ContactFrame) -> Self {
        Self { compliance, own: compliance.tangential_self_term(frame) }
    }
}

impl<C: Compliance + ?Sized> SlipMap for Direct<'_, C> {
    fn apply(&self, tractions: [&[f64]; 2], slip: [&mut [f64]; 2]) {
        let displacement = self.compliance.apply(&tangential(tractions));
        for (slip, displacement) in slip.into_iter().zip([&displacement.t1, &displacement.t2]) {
            slip.copy_from_slice(displacement);
        }
    }

    fn own(&self) -> f64 {
        self.own
    }
}

impl<C: Compliance + ?Sized> SlipMap for Differenced<'_, C> {
    fn apply(&self, tractions: [&[f64]; 2], slip: [&mut [f64]; 2]) {
        for (slip, taken) in slip.into_iter().zip(self.taken(&tangential(tractions))) {
            slip.copy_from_slice(&taken);
        }
    }

    fn own(&self) -> f64 {
        self.own
    }
}

fn tangential(tractions: [&[f64]; 2]) -> VectorField {
    let [t1, t2] = tractions.map(<[f64]>::to_vec);
    let n = vec![0.0; t1.len()];
    VectorField { t1, t2, n }
}

/// Tangential displacement (m) of one of the largest pairs under a unit traction (Pa) on it alone; the larger of
/// both directions.
pub(super) fn self_term(apply: impl Fn(&VectorField) -> VectorField, frame: &ContactFrame) -> f64 {
    own(frame.len(), frame.largest(), |tractions| {
        let VectorField { t1, t2, .. } = apply(tractions);
        [t1, t2]
    })
}

/// Slip (m) of a pair under a unit traction (Pa) on it alone; the larger of both directions.
fn own(pairs: usize, pair: usize, taken: impl Fn(&VectorField) -> [Vec<f64>; 2]) -> f64 {
    let along = |axis: usize| {
        let mut unit = [vec![0.0; pairs], vec![0.0; pairs]];
        unit[axis][pair] = 1.0;
        taken(&tangential([&unit[0], &unit[1]]))[axis][pair]
    };
    along(0).max(along(1))
}
