//! Layers that wear by laws of their own.
//!
//! A point wears by the law of the layer it has reached, by its depth. A step that goes through a layer uses that share of its
//! rubbing for it and the rest for what is below, so that nothing depends on where steps end for laws in proportion to slip. The
//! slope follows the same shares: implicit steps stay stable across an interface.
//!
//! Limits: a law that takes whole cycles is taken in proportion within the cycle that goes through.

use std::fmt::Debug;
use std::sync::Arc;

use super::{Input, Per, Rubbing, WearLaw};
use crate::parameters::Invalid;

/// What lies between the surface, or the layer above, and some depth.
#[derive(Debug, Clone)]
struct Stratum {
    /// Depth of its lower side (m).
    bottom: f64,
    /// `None` if it does not wear.
    law: Option<Arc<dyn WearLaw>>,
}

/// Laws by the depth that is reached.
#[derive(Debug, Clone)]
pub struct LayeredWear {
    strata: Vec<Stratum>,
    inputs: Vec<Input>,
    per: Per,
}

impl LayeredWear {
    /// Layers from the surface down, each with its thickness (m) and its law, `None` where it does not wear, and the law of what is
    /// below them.
    ///
    /// # Errors
    /// If some laws take whole cycles and others do not.
    pub fn new(
        layers: impl IntoIterator<Item = (f64, Option<Arc<dyn WearLaw>>)>,
        below: Option<Arc<dyn WearLaw>>,
    ) -> Result<Self, Invalid> {
        let mut bottom = 0.0;
        let layers = layers.into_iter().chain([(f64::INFINITY, below)]);
        let strata = layers.map(|(thickness, law)| {
            bottom += thickness;
            Stratum { bottom, law }
        });
        let strata: Vec<_> = strata.collect();
        let laws = || strata.iter().filter_map(|stratum| stratum.law.as_ref());
        let per = laws().map(|law| law.per()).next().unwrap_or(Per::Increment);
        if laws().any(|law| law.per() != per) {
            let message = "the laws of all layers must take whole cycles, or none of them";
            return Err(Invalid::new("layers", message));
        }
        let mut inputs = vec![Input::Depth];
        for &input in laws().flat_map(|law| law.inputs()) {
            if !inputs.contains(&input) {
                inputs.push(input);
            }
        }
        Ok(Self { strata, inputs, per })
    }

    /// The depth and its slope.
    fn worn(&self, rubbing: Rubbing) -> [f64; 2] {
        // The share of the rubbing that is left, and how it changes with the pressure (1/Pa).
        let (mut share, mut change) = (1.0, 0.0);
        let mut worn = 0.0;
        for Stratum { bottom, law } in &self.strata {
            let here = rubbing.depth + worn;
            if here >= *bottom {
                continue;
            }
            let Some(law) = law else { break };
            let reached = rubbing.after(rubbing.distance, here);
            let (depth, slope) = (law.depth(reached), law.slope(reached));
            let left = bottom - here;
            if share * depth <= left {
                return [worn + share * depth, (change * depth + share * slope).max(0.0)];
            }
            worn = bottom - rubbing.depth;
            share -= left / depth;
            change += left * slope / (depth * depth);
        }
        // What lies below does not wear.
        [worn, 0.0]
    }
}

impl WearLaw for LayeredWear {
    fn inputs(&self) -> &[Input] {
        &self.inputs
    }

    fn per(&self) -> Per {
        self.per
    }

    fn hardness(&self) -> Option<f64> {
        self.strata.iter().find_map(|stratum| stratum.law.as_ref()).and_then(|law| law.hardness())
    }

    fn depth(&self, rubbing: Rubbing) -> f64 {
        self.worn(rubbing)[0]
    }

    fn slope(&self, rubbing: Rubbing) -> f64 {
        self.worn(rubbing)[1]
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use approx::assert_relative_eq;

    use super::super::{Archard, Input, Rubbing, WearLaw};
    use super::LayeredWear;

    fn archard(coefficient: f64) -> Option<Arc<dyn WearLaw>> {
        Some(Arc::new(Archard::new(coefficient).unwrap()))
    }

    /// A hard layer of 1 um, a soft one of 2 um, and what is below.
    fn law() -> LayeredWear {
        LayeredWear::new([(1e-6, archard(1e-15)), (2e-6, archard(4e-15))], archard(2e-15)).unwrap()
    }

    /// At 1 GPa a metre wears 1 um of the first, 4 um of the second and 2 um of what is below.
    #[test]
    fn a_point_wears_by_the_layer_it_has_reached() {
        let law = law();
        assert_eq!(law.inputs(), [Input::Depth]);
        for (slid, known) in [(0.5, 0.5), (1.0, 1.0), (1.25, 2.0), (1.5, 3.0), (3.5, 7.0)] {
            let depth = law.depth(Rubbing::new(1e9, slid));
            assert_relative_eq!(1e6 * depth, known, max_relative = 1e-12);
            // In two steps.
            let half = law.depth(Rubbing::new(1e9, 0.3 * slid));
            let rest = law.depth(Rubbing::new(1e9, 0.7 * slid).after(0.3 * slid, half));
            assert_relative_eq!(half + rest, depth, max_relative = 1e-12);
        }
    }

    #[test]
    fn the_slope_is_that_of_the_depth() {
        for slid in [0.5, 1.2, 1.4, 2.0, 5.0] {
            let at = |pressure: f64| Rubbing::new(pressure, slid);
            let law = law();
            let change = law.depth(at(1.001e9)) - law.depth(at(0.999e9));
            assert_relative_eq!(law.slope(at(1e9)), change / 2e6, max_relative = 1e-5);
        }
    }

    #[test]
    fn what_does_not_wear_stays() {
        let law = LayeredWear::new([(1e-6, archard(1e-15))], None).unwrap();
        let deep = Rubbing::new(1e9, 5.0);
        assert_relative_eq!(law.depth(deep), 1e-6);
        assert_eq!(law.slope(deep), 0.0);
        assert_eq!(law.depth(deep.after(1.0, 1e-6)), 0.0);
    }
}
