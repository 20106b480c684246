//! An elastic body: how loads and supports deform it, without contact or under the tractions of one.
//!
//! An [`ElasticBody`] is solved by boundary elements. What comes out is a [`DeformedBody`]: displacements,
//! tractions and stresses on the surface, and displacements and stresses at the points asked for. A body
//! in contact is one too, once its tractions are known: [`DeformedBody::in_contact`]; of a half-space they say all: [`PressedHalfSpace`].

mod damage;
mod edge;
mod fatigue;
mod half_space;
mod interfaces;
mod maxima;
mod section;
mod surface;

#[doc(hidden)]
pub use damage::{Damage, DamageModel, DamageOfBody, Endurance};
#[doc(hidden)]
pub use fatigue::Added;
pub use fatigue::{Criterion, Cycle};
pub use half_space::{PressedHalfSpace, tensor};
pub use interfaces::{Interface, Side};
pub use maxima::{Layer, Maxima, Maximum, Piece};
#[doc(hidden)]
pub use section::SectionResponse;
pub use section::{Section, SectionError};

use glam::{DMat3, DVec3};
use rayon::prelude::*;

use crate::body::{Body, Finite, Material};
use crate::compliance::bem::contact::{BodiesInContact, ContactError, Job, supported};
use crate::compliance::bem::{
    self, Boundary, Conditions, Interior, Listener, Solid, Surface, advice, forces,
};
use crate::compliance::fem::Inside;
use crate::compliance::{Balance, Indeterminacy, SolveError};
use crate::frame::VectorField;

/// A body with its loads and supports.
#[derive(Debug, Clone, PartialEq)]
pub struct ElasticBody {
    /// The user's name for it.
    pub name: String,
    /// What it is made of.
    pub material: Material,
    /// Its surface and what is known there.
    pub finite: Finite,
    /// Points where displacement and stress are wanted.
    pub points: Vec<Point>,
    /// Plane sections on which they are wanted.
    pub sections: Vec<Section>,
    /// The longest element along a free span over the thickness there; `None` where nothing bends.
    pub slenderness: Option<f64>,
}

/// A point of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// The user's name for it.
    pub name: String,
    /// Where it is (m).
    pub place: [f64; 3],
}

/// What loads and supports make of a body.
#[non_exhaustive]
#[derive(Debug, Clone)]
pub struct DeformedBody {
    /// The elements.
    pub surface: Surface,
    /// Displacement (m) of the surface along x, y and z, a value a node of displacements.
    pub displacement: Vec<[f64; 3]>,
    /// Traction (Pa) on the surface along x, y and z, a value a node of tractions.
    pub traction: Vec<[f64; 3]>,
    /// Stress (Pa) on the surface as of [`Response::stress`], a value a node of tractions.
    pub stress: Vec<[[f64; 3]; 3]>,
    /// Displacement and stress at each point.
    pub points: Vec<Response>,
    /// Displacement and stress on each section.
    pub sections: Vec<SectionResponse>,
    /// Depth of wear (m), a value a node of tractions; empty where nothing touches the body.
    pub worn: Vec<f64>,
    /// What is left of the balance of forces and moments.
    pub balance: Balance,
    forces: Vec<[f64; 3]>,
}

/// Displacement and stress at a point of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Response {
    /// Displacement along x, y and z (m).
    pub displacement: [f64; 3],
    /// Stress along x, y and z (Pa), positive in tension; symmetric.
    pub stress: [[f64; 3]; 3],
}

impl From<bem::Response> for Response {
    fn from(bem::Response { displacement, stress }: bem::Response) -> Self {
        Self { displacement: displacement.to_array(), stress: stress.to_cols_array_2d() }
    }
}

/// Why a body cannot be computed.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ElasticError {
    /// Its supports do not hold it.
    #[error(transparent)]
    Undetermined(#[from] Indeterminacy),
    /// A point is not in the body.
    #[error(
        "the point `{}` at ({}, {}, {}) m lies outside of the body",
        .point.name, .point.place[0], .point.place[1], .point.place[2]
    )]
    Outside {
        /// The point.
        point: Point,
    },
    /// A point is in what does not deform.
    #[error(
        "the point `{}` at ({}, {}, {}) m lies below the layers, in rigid ground that has no stress",
        .point.name, .point.place[0], .point.place[1], .point.place[2]
    )]
    Ground {
        /// The point.
        point: Point,
    },
    /// Pressures are cut, and layers carry their stresses farther than is known.
    #[error(
        "pressures go on beyond the frame, and layers carry stresses along: take a larger frame, so that the contact lies within it"
    )]
    Reach,
    /// The stress at a point depends on pressures beyond the frame.
    #[error(
        "the point `{}` at ({}, {}, {}) m lies too deep, or too near to a side of the frame, where pressures go on: take a larger frame, or points at most a quarter as deep as they are far from that side",
        .point.name, .point.place[0], .point.place[1], .point.place[2]
    )]
    Cut {
        /// The point.
        point: Point,
    },
    /// The stresses at a depth depend on pressures beyond the frame.
    #[error(
        "{depth} m below the surface they are not known, which they are down to {known} m: to rigid ground, or, where pressures go on beyond the frame, to a quarter of the way to its nearest side; take lesser depths, or a larger frame"
    )]
    Deep {
        /// The depth (m).
        depth: f64,
        /// How deep (m) stresses are known.
        known: f64,
    },
    /// A section has no places.
    #[error("the section `{name}` {cause}")]
    Section {
        /// Its name.
        name: String,
        /// What is wrong.
        cause: SectionError,
    },
    /// The stresses of a body in contact do not follow from its tractions alone.
    #[error("body {} {why}", .body + 1)]
    Unknown {
        /// The body's index, 0 or 1.
        body: usize,
        /// Why.
        why: &'static str,
    },
    /// Its equations have no solution.
    #[error("{cause}; {}", advice(.cause))]
    Singular {
        /// What is wrong.
        #[from]
        cause: SolveError,
    },
    /// It cannot touch the other body.
    #[error(transparent)]
    Contact(#[from] ContactError),
}

impl ElasticBody {
    /// Its elements.
    pub fn surface(&self) -> Surface {
        Surface::new(&self.finite.meshed.mesh, self.finite.interpolation, self.finite.mirrored)
    }

    /// What is known at the nodes, if the supports hold the body.
    fn conditions(&self, surface: &Surface) -> Result<Conditions, Indeterminacy> {
        Conditions::new(surface, |node| supported(&self.finite, node), &[])
    }

    /// All that can be known to be wrong before the equations are made.
    pub fn check(&self, surface: &Surface) -> Vec<ElasticError> {
        let undetermined = self.conditions(surface).err().map(ElasticError::from);
        let outside =
            self.points.iter().filter(|point| surface.depth(point.place.into()).is_none());
        let outside = outside.map(|point| ElasticError::Outside { point: point.clone() });
        let sections = self.sections.iter().filter_map(|section| {
            let cause = section.check(surface).err()?;
            Some(ElasticError::Section { name: section.name.clone(), cause })
        });
        undetermined.into_iter().chain(outside).chain(sections).collect()
    }

    /// Displacements, tractions and stresses.
    ///
    /// # Errors
    /// If the body is not held, a point lies outside of it, or its equations have no solution.
    pub fn solve(&self) -> Result<DeformedBody, ElasticError> {
        let Self { material, finite, .. } = self;
        let surface = self.surface();
        let conditions = self.conditions(&surface)?;
        let told = Listener::default();
        let job = Job { surface: &surface, conditions: &conditions, told };
        let boundary = solve(finite, material, &job, &[])?;
        let wanted = (&self.points[..], &self.sections[..]);
        DeformedBody::of((material, finite.tolerance), &job, &boundary, wanted)
    }
}

/// Points and sections where displacement and stress are wanted.
pub type Wanted<'a> = (&'a [Point], &'a [Section]);

/// What finds displacements and tractions all over a body under tractions of contact (Pa), three a contact node.
pub type Solve<'a> =
    &'a dyn Fn(&Finite, &Material, &Job<'_>, &[f64]) -> Result<Boundary, SolveError>;

/// Solves the equations of a body.
pub fn solve(
    finite: &Finite,
    material: &Material,
    job: &Job<'_>,
    acting: &[f64],
) -> Result<Boundary, SolveError> {
    Ok(Solid::new(job.surface, material, job.conditions, finite.tolerance)?.boundary(acting))
}

impl DeformedBody {
    /// A meshed body in contact, under tractions of the pairs (Pa) on body 1 and its own loads; `None` where
    /// something else than boundary elements says how it deforms. `which` is its index, 0 or 1.
    ///
    /// # Errors
    /// If the bodies cannot touch, a point lies outside of the body, or its equations have no solution.
    pub fn in_contact(
        bodies: [&Body; 2],
        which: usize,
        tractions: &VectorField,
        points: &[Point],
    ) -> Result<Option<Self>, ElasticError> {
        Self::in_contact_by(bodies, which, (tractions, &[]), (points, &[]), &solve)
    }

    /// The same with depths of wear (m, a value a pair), sections, and something that solves the equations or knows that
    /// they were.
    ///
    /// # Errors
    /// As [`DeformedBody::in_contact`].
    pub fn in_contact_by(
        bodies: [&Body; 2],
        which: usize,
        (tractions, worn): (&VectorField, &[f64]),
        wanted: Wanted<'_>,
        solve: Solve<'_>,
    ) -> Result<Option<Self>, ElasticError> {
        let meeting = BodiesInContact::of(bodies)?;
        let Body { material: Some(material), finite: Some(finite), .. } = bodies[which] else {
            return Ok(None);
        };
        if let Some((surface, inside)) = meeting.inside(which, tractions)? {
            let mut deformed = Self::inside(surface, &inside, wanted)?;
            deformed.worn = meeting.on_nodes(which, worn);
            return Ok(Some(deformed));
        }
        let Some((job, acting)) = meeting.acting_on(which, tractions) else { return Ok(None) };
        let boundary = solve(finite, material, &job, &acting)?;
        let mut deformed = Self::of((material, finite.tolerance), &job, &boundary, wanted)?;
        deformed.worn = meeting.on_nodes(which, worn);
        Ok(Some(deformed))
    }

    /// Stresses, integrals to that relative tolerance, from what is known all over the surface.
    fn of(
        (material, tolerance): (&Material, f64),
        job: &Job<'_>,
        boundary: &Boundary,
        (points, sections): Wanted<'_>,
    ) -> Result<Self, ElasticError> {
        let surface = job.surface;
        let interior = Interior::new(surface, material, boundary, tolerance);
        let stress = interior.surface_stress().iter().map(DMat3::to_cols_array_2d).collect();
        let outside = |point: &Point| ElasticError::Outside { point: point.clone() };
        let at = |point: &Point| {
            let response = interior.at(point.place.into()).ok_or_else(|| outside(point))?;
            Ok(response.into())
        };
        let points = points.iter().map(at).collect::<Result<_, ElasticError>>()?;
        let sections = sections.iter().map(|one| one.sample(surface, &interior)).collect();
        let balance = Balance::of(surface, job.conditions, &boundary.traction);
        let forces = forces(surface, job.conditions, boundary);
        let [displacement, traction] = [&boundary.displacement, &boundary.traction]
            .map(|vectors| vectors.iter().map(DVec3::to_array).collect());
        let surface = surface.clone();
        let worn = vec![];
        Ok(Self {
            surface,
            displacement,
            traction,
            stress,
            points,
            sections,
            worn,
            balance,
            forces,
        })
    }

    /// The same from what finite elements say of the inside.
    fn inside(
        surface: &Surface,
        inside: &Inside,
        (points, sections): Wanted<'_>,
    ) -> Result<Self, ElasticError> {
        let (displacement, stress) = inside.on(surface);
        let nodes = surface.traction_nodes();
        let traction: Vec<DVec3> =
            stress.iter().zip(nodes).map(|(stress, node)| *stress * node.normal).collect();
        let at = |place: DVec3| inside.at(place).map(Response::from);
        let outside = |point: &Point| ElasticError::Outside { point: point.clone() };
        let point = |point: &Point| at(point.place.into()).ok_or_else(|| outside(point));
        let mut forces = vec![[0.0; 3]; surface.names().len()];
        for (traction, node) in traction.iter().zip(nodes) {
            for axis in 0..3 {
                forces[node.surface][axis] += node.area * traction[axis];
            }
        }
        let corners = surface.corners();
        let all = |places: &[DVec3]| places.par_iter().map(|place| at(*place)).collect();
        Ok(Self {
            points: points.iter().map(point).collect::<Result<_, _>>()?,
            sections: sections.iter().map(|one| one.responses(Some(&corners), all)).collect(),
            surface: surface.clone(),
            displacement: displacement.iter().map(DVec3::to_array).collect(),
            traction: traction.iter().map(DVec3::to_array).collect(),
            stress: stress.iter().map(DMat3::to_cols_array_2d).collect(),
            worn: vec![],
            balance: Balance::default(),
            forces,
        })
    }

    /// The number of unknowns of its equations.
    pub fn unknowns(&self) -> usize {
        self.surface.unknowns()
    }

    /// The largest displacement of a node of the surface (m).
    pub fn largest_displacement(&self) -> f64 {
        let lengths = self.displacement.iter().map(|&u| DVec3::from_array(u).length());
        lengths.fold(0.0, f64::max)
    }

    /// Force (N) on each surface, mirror images left out. Those of supports balance the loads: what the tractions
    /// leave of the balance, most of it next to the edges of clamps, is shared out among them in proportion to
    /// what they bear, so that one that stands alone bears exactly the loads.
    pub fn forces(&self) -> &[[f64; 3]] {
        &self.forces
    }
}

/// Components of the stress by their names, with their places in the matrix.
pub const STRESSES: [(&str, [usize; 2]); 6] = [
    ("xx", [0, 0]),
    ("yy", [1, 1]),
    ("zz", [2, 2]),
    ("xy", [0, 1]),
    ("yz", [1, 2]),
    ("zx", [2, 0]),
];

/// The equivalent stress of von Mises (Pa) of a stress along x, y and z (Pa).
pub fn von_mises(stress: &[[f64; 3]; 3]) -> f64 {
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = *stress;
    crate::stress::von_mises(&[xx, yy, zz, xy, xz, yz])
}

/// The columns of a response: displacements (m), stresses and the equivalent stress (Pa).
pub fn row(response: &Response) -> Vec<(String, f64)> {
    let displacement = response.displacement.into_iter();
    let displacement = ["x", "y", "z"]
        .into_iter()
        .zip(displacement)
        .map(|(axis, value)| (format!("displacement_{axis}_m"), value));
    let stress = STRESSES
        .iter()
        .map(|(name, [i, j])| (format!("stress_{name}_Pa"), response.stress[*j][*i]));
    let equivalent = ("von_mises_Pa".to_owned(), von_mises(&response.stress));
    displacement.chain(stress).chain([equivalent]).collect()
}

#[cfg(test)]
mod tests {
    use super::von_mises;

    #[test]
    fn von_mises_knows_tension_shear_and_pressure() {
        let tension = [[0.0; 3], [0.0, -3.0, 0.0], [0.0; 3]];
        let shear = [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0; 3]];
        let pressure = [[5.0, 0.0, 0.0], [0.0, 5.0, 0.0], [0.0, 0.0, 5.0]];
        assert!((von_mises(&tension) - 3.0).abs() < 1e-14);
        assert!((von_mises(&shear) - 3f64.sqrt()).abs() < 1e-14);
        assert!(von_mises(&pressure) < 1e-14);
    }
}
