//! How long elements may be where a body can bend.
//!
//! Elements longer than the body is thick lose the balance of moments, and what is lost acts on the whole beam
//! or plate. A thickness counts where supports leave a free span: where neither side of it is held, and the
//! body reaches further from what holds it than it is thick. The errors are those of a cantilever of 10 x 1 x 1
//! under end shear: 3 % with elements as long as it is thick, 1 % with two thirds of that.

/// Longest element against the local thickness.
const LONGEST: f64 = 2.0 / 3.0;
/// Elements across a thickness that bends, at least.
const ACROSS: f64 = 2.0;
/// A span of fewer thicknesses is stocky: it does not bend enough to matter.
const STOCKY: f64 = 2.0;

/// Length of elements around a wall relative to its thickness: shells under pressure were 0.9 % off with 1.9 and 28 % with 3.9, tubes
/// that bend 0.6 % with 2 and 1.4 % with 3.
pub(super) const BESIDE_WALL: f64 = 2.0;
/// Elements are not asked to be shorter than this share of a side: no memory would hold them.
pub(super) const LEAST: f64 = 1e-4;

/// The surfaces where displacements are known, each with the axes along which they are.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct SupportedSurfaces(Vec<(String, [bool; 3])>);

impl SupportedSurfaces {
    /// Whether displacements are known on a surface.
    pub(super) fn at(&self, surface: &str) -> bool {
        self.0.iter().any(|(name, _)| name == surface)
    }

    /// Whether displacements along an axis are known on a surface.
    pub(super) fn along(&self, surface: &str, axis: usize) -> bool {
        self.0.iter().any(|(name, along)| name == surface && along[axis])
    }
}

impl FromIterator<(String, [bool; 3])> for SupportedSurfaces {
    fn from_iter<T: IntoIterator<Item = (String, [bool; 3])>>(surfaces: T) -> Self {
        Self(surfaces.into_iter().filter(|(_, along)| along.contains(&true)).collect())
    }
}

/// Whether a thickness (m) bends over a span (m), which is nothing where nothing is held.
pub(super) fn bends(thickness: f64, span: f64) -> bool {
    span > STOCKY * thickness * (1.0 + 1e-9)
}

/// The longest element (m) along a span of that thickness (m).
pub(super) fn longest(thickness: f64) -> f64 {
    LONGEST * thickness
}

/// The longest element (m) across a thickness (m) that bends.
pub(super) fn across(thickness: f64) -> f64 {
    thickness / ACROSS
}
