//! What is known at the nodes of a body, and what is sought.

use glam::DVec3;

use super::surface::{Surface, TractionNode};
use crate::numerics::SAME;

/// What is known at a node along one direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum AxisCondition {
    /// The traction (Pa).
    Traction(f64),
    /// The displacement (m).
    Displacement(f64),
    /// Neither: tractions there come from contact, and displacements are sought as their multiples.
    Contact,
}

/// What is known at a node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Condition {
    /// Unit vectors, at right angles to each other.
    pub basis: [DVec3; 3],
    /// What is known along each.
    pub given: [AxisCondition; 3],
}

impl Condition {
    /// The same kind along x, y and z.
    pub fn along_axes(given: [AxisCondition; 3]) -> Self {
        Self { basis: DVec3::AXES, given }
    }

    /// No traction.
    pub fn free() -> Self {
        Self::along_axes([AxisCondition::Traction(0.0); 3])
    }

    /// No displacement.
    pub fn clamped() -> Self {
        Self::along_axes([AxisCondition::Displacement(0.0); 3])
    }

    /// No displacement along a normal and no traction across it.
    pub fn roller(normal: DVec3) -> Self {
        let given = [
            AxisCondition::Traction(0.0),
            AxisCondition::Traction(0.0),
            AxisCondition::Displacement(0.0),
        ];
        Self { basis: basis_of(normal), given }
    }

    /// A pressure (Pa) against a surface of that outward normal.
    pub fn pressed(normal: DVec3, pressure: f64) -> Self {
        Self::along_axes((-pressure * normal).to_array().map(AxisCondition::Traction))
    }
}

/// Two unit vectors across a normal and the normal, which along an axis is not turned.
pub fn basis_of(normal: DVec3) -> [DVec3; 3] {
    let axis = if normal.x.abs() > 0.9 { DVec3::Y } else { DVec3::X };
    let first = (axis - axis.dot(normal) * normal).normalize();
    [first, normal.cross(first), normal]
}

/// Why what is known does not determine what is sought.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Indeterminacy {
    /// Displacements given on several surfaces meet at a node of continuous elements.
    #[error(
        "displacements are given on two surfaces that meet at ({:e}, {:e}, {:e}) m, where continuous elements know only one traction: use discontinuous elements",
        .place[0], .place[1], .place[2]
    )]
    TwoSupports {
        /// Where (m).
        place: [f64; 3],
        /// The surfaces, by their index.
        surfaces: [usize; 2],
    },
    /// The body can move without deforming.
    #[error("nothing holds the body against {}: support it there", list(.modes))]
    Free {
        /// The motions left free.
        modes: Vec<&'static str>,
    },
}

fn list(modes: &[&str]) -> String {
    modes.join(", ")
}

/// The condition of every node of tractions, and what follows for the columns of the system.
#[derive(Debug, Clone)]
pub struct Conditions {
    pub(super) tractions: Vec<Condition>,
    /// For every node of displacements: its basis, and along each direction a displacement that is known or
    /// the node of tractions whose traction is sought there.
    pub(super) nodes: Vec<NodeCondition>,
    /// Nodes of tractions in contact, in the order of their columns.
    pub(super) contact: Vec<usize>,
    /// Place of a node of tractions among those in contact.
    pub(super) contact_column: Vec<Option<usize>>,
    /// First of the three columns of what is sought at each node of displacements; those of nodes in contact
    /// come last, so that they can be found without the others.
    pub(super) columns: Vec<usize>,
}

/// Displacements at a node.
#[derive(Debug, Clone, Copy)]
pub(super) struct NodeCondition {
    pub basis: [DVec3; 3],
    pub known: [Option<Known>; 3],
}

/// A displacement that is known.
#[derive(Debug, Clone, Copy)]
pub(super) struct Known {
    /// (m)
    pub displacement: f64,
    /// Whose traction it is that is sought.
    pub traction: usize,
}

impl Conditions {
    /// The conditions that `of` gives for every node of tractions; those in contact, in the order in which
    /// their columns are to be, with their bases, stand in `contact`.
    ///
    /// # Errors
    /// If continuous elements cannot hold them, or if the body is left free to move.
    pub fn new(
        surface: &Surface,
        of: impl Fn(&TractionNode) -> Condition,
        contact: &[(usize, [DVec3; 3])],
    ) -> Result<Self, Indeterminacy> {
        Self::of(surface, surface.tractions.iter().map(of).collect(), contact)
    }

    /// The same of conditions in the order of the nodes of tractions.
    ///
    /// # Errors
    /// As [`Conditions::new`].
    pub(super) fn of(
        surface: &Surface,
        mut tractions: Vec<Condition>,
        contact: &[(usize, [DVec3; 3])],
    ) -> Result<Self, Indeterminacy> {
        let mut contact_column = vec![None; tractions.len()];
        for (column, &(traction, basis)) in contact.iter().enumerate() {
            tractions[traction] = Condition { basis, given: [AxisCondition::Contact; 3] };
            contact_column[traction] = Some(column);
        }
        let contact: Vec<usize> = contact.iter().map(|&(traction, _)| traction).collect();
        let nodes = nodes_of(surface, &tractions)?;
        let columns = columns(surface, &contact);
        let conditions = Self { tractions, nodes, contact, contact_column, columns };
        let modes = super::rigid::free_modes(surface, &conditions);
        if modes.is_empty() { Ok(conditions) } else { Err(Indeterminacy::Free { modes }) }
    }
}

/// Nothing but the contact of a body that is held somewhere else than on these elements.
impl Conditions {
    pub(super) fn of_contact(surface: &Surface, contact: &[(usize, [DVec3; 3])]) -> Self {
        let mut tractions = vec![Condition::free(); surface.tractions.len()];
        let mut contact_column = vec![None; tractions.len()];
        for (column, &(traction, basis)) in contact.iter().enumerate() {
            tractions[traction] = Condition { basis, given: [AxisCondition::Contact; 3] };
            contact_column[traction] = Some(column);
        }
        let contact: Vec<usize> = contact.iter().map(|&(traction, _)| traction).collect();
        let nodes =
            vec![NodeCondition { basis: DVec3::AXES, known: [None; 3] }; surface.nodes.len()];
        let columns = columns(surface, &contact);
        Self { tractions, nodes, contact, contact_column, columns }
    }
}

fn columns(surface: &Surface, contact: &[usize]) -> Vec<usize> {
    let mut touching = vec![false; surface.nodes.len()];
    contact.iter().for_each(|&traction| touching[surface.tractions[traction].node] = true);
    let mut columns = vec![0; touching.len()];
    let order = (0..touching.len())
        .filter(|&node| !touching[node])
        .chain((0..touching.len()).filter(|&node| touching[node]));
    for (place, node) in order.enumerate() {
        columns[node] = 3 * place;
    }
    columns
}

fn nodes_of(
    surface: &Surface,
    tractions: &[Condition],
) -> Result<Vec<NodeCondition>, Indeterminacy> {
    let free = NodeCondition { basis: DVec3::AXES, known: [None; 3] };
    let mut nodes = vec![free; surface.nodes.len()];
    let supports = |condition: &Condition| {
        condition.given.iter().any(|given| matches!(given, AxisCondition::Displacement(_)))
    };
    for (traction, condition) in tractions.iter().enumerate() {
        if !supports(condition) {
            continue;
        }
        let TractionNode { node, place, .. } = surface.tractions[traction];
        let at = &mut nodes[node];
        let surface_of = |traction: usize| surface.tractions[traction].surface;
        let other = at.known.iter().flatten().next().map_or(traction, |known| known.traction);
        let surfaces = [other, traction].map(surface_of);
        let two = || Indeterminacy::TwoSupports { place: place.to_array(), surfaces };
        if at.known.iter().all(Option::is_none) {
            at.basis = condition.basis;
        }
        for (direction, given) in condition.basis.iter().zip(condition.given) {
            let AxisCondition::Displacement(displacement) = given else { continue };
            let index = at.basis.iter().position(|own| own.dot(*direction).abs() > 1.0 - SAME);
            let index = index.ok_or_else(two)?;
            if at.known[index].is_some() {
                return Err(two());
            }
            let displacement = displacement * at.basis[index].dot(*direction).signum();
            at.known[index] = Some(Known { displacement, traction });
        }
    }
    Ok(nodes)
}
