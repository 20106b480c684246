//! What can be wrong with a surface.

/// Something wrong with a surface.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MeshProblem {
    /// An element names a vertex that is not there.
    #[error(
        "element {face} names the vertex {vertex}, there are only {vertices}: write the mesh anew"
    )]
    NoVertex {
        /// The element.
        face: usize,
        /// The vertex it names.
        vertex: usize,
        /// How many there are.
        vertices: usize,
    },
    /// Places that are not numbers.
    #[error("{count} vertices lie nowhere (not a finite number): write the mesh anew")]
    Nowhere {
        /// How many.
        count: usize,
    },
    /// No elements at all.
    #[error("the surface has no elements: mesh it before it is saved")]
    Empty,
    /// Vertices beyond a plane of symmetry.
    #[error(
        "{count} vertices lie at negative {axis}, the first at {}: keep only the half at positive {axis}, or leave out the symmetry",
        at(.place)
    )]
    Beyond {
        /// The axis across the plane.
        axis: char,
        /// How many.
        count: usize,
        /// The first of them (m).
        place: [f64; 3],
    },
    /// Elements on a plane of symmetry, where the surface has to be open.
    #[error(
        "{count} elements lie on the plane of symmetry {axis} = 0, the first at {}: leave the cut open",
        at(.place)
    )]
    OnPlane {
        /// The axis across the plane.
        axis: char,
        /// How many.
        count: usize,
        /// The centre of the first of them (m).
        place: [f64; 3],
    },
    /// Shells that touch or cross.
    #[error(
        "two closed surfaces touch or cross at {}: make one of the parts (in Gmsh `BooleanUnion`, then `Coherence Mesh;`)",
        at(.place)
    )]
    Crossing {
        /// Where (m).
        place: [f64; 3],
    },
    /// Closed surfaces that are no cavities of one body: next to one another, or a core within a cavity.
    #[error(
        "the surface is that of {pieces} bodies, the second at {}: keep one (in Gmsh `BooleanUnion` makes one of parts that touch)",
        at(.place)
    )]
    Pieces {
        /// How many.
        pieces: usize,
        /// The centre of an element of the second (m).
        place: [f64; 3],
    },
    /// Edges of a single element.
    #[error(
        "the surface is open: {edges} edges belong to one element only, the first from the vertex {}; mesh what is missing, or merge vertices that lie on one another (in Gmsh `Coherence Mesh;`, in Python `gmsh.model.mesh.removeDuplicateNodes()`)",
        vertex(.place)
    )]
    Open {
        /// How many.
        edges: usize,
        /// A vertex at the end of the first (m).
        place: [f64; 3],
    },
    /// Edges of more than two elements.
    #[error(
        "{edges} edges belong to more than two elements, the first from the vertex {}: remove the walls inside the body (in Gmsh put the outer surfaces alone into a `Physical Surface`)",
        vertex(.place)
    )]
    Branching {
        /// How many.
        edges: usize,
        /// A vertex at the end of the first (m).
        place: [f64; 3],
    },
    /// Neighbours, one seen from outside and one from inside.
    #[error(
        "neighbours at {edges} edges are seen from different sides, the first from the vertex {}: orient all elements counter-clockwise seen from outside (in Gmsh `gmsh.model.mesh.setOutwardOrientation(1)` for the volume 1, or `ReverseMesh Surface{{1}};` for the surface 1)",
        vertex(.place)
    )]
    Unlike {
        /// How many.
        edges: usize,
        /// A vertex at the end of the first (m).
        place: [f64; 3],
    },
    /// A surface turned inside out.
    #[error(
        "the surface encloses {volume:.3e} m^3, its inside is out: turn all elements (in Gmsh `gmsh.model.mesh.reverse()`)"
    )]
    Inverted {
        /// The volume (m^3).
        volume: f64,
    },
    /// Elements with the same corners.
    #[error("{count} elements are there twice, the first at {}: keep one of each (in Gmsh `gmsh.model.mesh.removeDuplicateElements()`)", at(.place))]
    Duplicate {
        /// How many.
        count: usize,
        /// The centre of the first (m).
        place: [f64; 3],
    },
    /// Elements without area.
    #[error("{count} elements have no area, the first at {}: remove or merge them", at(.place))]
    Flat {
        /// How many.
        count: usize,
        /// The centre of the first (m).
        place: [f64; 3],
    },
    /// Vertices of no element.
    #[error("{count} vertices belong to no element, the first at {}: remove them", at(.place))]
    Unused {
        /// How many.
        count: usize,
        /// The first of them (m).
        place: [f64; 3],
    },
    /// Quadrilaterals with a corner that points inwards.
    #[error(
        "{count} quadrilaterals have a corner that points inwards, the first at {}: divide them into triangles (in Gmsh without `Mesh.RecombineAll`)",
        at(.place)
    )]
    Concave {
        /// How many.
        count: usize,
        /// The centre of the first (m).
        place: [f64; 3],
    },
    /// Quadrilaterals far from flat.
    #[error(
        "{count} quadrilaterals are far from flat, the worst bent by {angle:.0} degrees at {}: divide them into triangles or refine",
        at(.place)
    )]
    Warped {
        /// How many.
        count: usize,
        /// The largest angle between the normals at their corners (degrees).
        angle: f64,
        /// The centre of the worst (m).
        place: [f64; 3],
    },
    /// Elements much longer than wide.
    #[error(
        "{count} elements are more than 20 times as long as wide, the worst {ratio:.0} times at {}: refine along the longer side (in Gmsh by a smaller `Mesh.MeshSizeMax`)",
        at(.place)
    )]
    Slender {
        /// How many.
        count: usize,
        /// The largest ratio.
        ratio: f64,
        /// The centre of the worst (m).
        place: [f64; 3],
    },
}

impl MeshProblem {
    /// Whether results can be had all the same, if poorer ones.
    pub fn is_warning(&self) -> bool {
        use MeshProblem::{Concave, Slender, Unused, Warped};
        matches!(self, Concave { .. } | Slender { .. } | Unused { .. } | Warped { .. })
    }
}

/// A vertex, with as many digits as single precision has.
fn vertex([x, y, z]: &[f64; 3]) -> String {
    format!("x = {x:.6e} m, y = {y:.6e} m, z = {z:.6e} m")
}

fn at([x, y, z]: &[f64; 3]) -> String {
    format!("x = {x:.4e} m, y = {y:.4e} m, z = {z:.4e} m")
}
