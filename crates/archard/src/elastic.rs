//! An elastic body: how loads and supports deform it, without contact or under the tractions of one.
//!
//! An [`ElasticBody`] is solved by boundary elements. What comes out is a [`Deformed`]: displacements,
//! tractions and stresses on the surface, and displacements and stresses at the points asked for. A body
//! in contact is one too, once its tractions are known: [`Deformed::in_contact`].

use glam::DMat3;

use crate::body::{Body, Finite, Material};
use crate::compliance::bem::contact::{ContactError, Job, Meeting, supported};
use crate::compliance::bem::{
    Balance, Boundary, Conditions, Interior, Response, Solid, Surface, Undetermined, advice, forces,
};
use crate::frame::VectorField;
use crate::numerics::dense::Unsolved;
use crate::verdict::{self, Verdict};

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
    /// The longest element along a free span beside the thickness there; `None` where nothing bends.
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
#[derive(Debug, Clone)]
pub struct Deformed {
    /// The elements.
    pub surface: Surface,
    /// Displacements and tractions on the surface.
    pub boundary: Boundary,
    /// Stress (Pa) on the surface, a value a node of tractions.
    pub stress: Vec<DMat3>,
    /// Displacement and stress at each point.
    pub points: Vec<Response>,
    /// What is left of the balance of forces and moments.
    pub balance: Balance,
    forces: Vec<[f64; 3]>,
}

/// Why a body cannot be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ElasticError {
    /// Its supports do not hold it.
    #[error(transparent)]
    Undetermined(#[from] Undetermined),
    /// A point is not in the body.
    #[error(
        "the point `{}` at ({}, {}, {}) m lies outside of the body",
        .point.name, .point.place[0], .point.place[1], .point.place[2]
    )]
    Outside {
        /// The point.
        point: Point,
    },
    /// Its equations have no solution.
    #[error("{cause}; {}", advice(.cause))]
    Singular {
        /// What is wrong.
        #[from]
        cause: Unsolved,
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

    /// What is known at the nodes.
    ///
    /// # Errors
    /// If the supports do not hold the body.
    pub fn conditions(&self, surface: &Surface) -> Result<Conditions, Undetermined> {
        Conditions::new(surface, |node| supported(&self.finite, node), &[])
    }

    /// All that can be known to be wrong before the equations are made.
    pub fn check(&self, surface: &Surface) -> Vec<ElasticError> {
        let undetermined = self.conditions(surface).err().map(ElasticError::from);
        let outside =
            self.points.iter().filter(|point| surface.depth(point.place.into()).is_none());
        let outside = outside.map(|point| ElasticError::Outside { point: point.clone() });
        undetermined.into_iter().chain(outside).collect()
    }

    /// What can be believed of a result.
    pub fn verdict(&self, deformed: &Deformed) -> Verdict {
        let Balance { force, moment } = deformed.balance;
        let mut lines = verdict::balance(force, moment).to_vec();
        lines.extend(self.slenderness.map(verdict::slenderness));
        Verdict { lines }
    }

    /// Displacements, tractions and stresses.
    ///
    /// # Errors
    /// If the body is not held, a point lies outside of it, or its equations have no solution.
    pub fn solve(&self) -> Result<Deformed, ElasticError> {
        let Self { material, finite, .. } = self;
        let surface = self.surface();
        let conditions = self.conditions(&surface)?;
        let job = Job { surface: &surface, conditions: &conditions };
        Deformed::of((material, finite.tolerance), &job, &[], &self.points)
    }
}

impl Deformed {
    /// A meshed body in contact, under tractions of the pairs (Pa) on body 1 and its own loads; `None` where
    /// something else than boundary elements tells how it deforms. `which` is its index, 0 or 1.
    ///
    /// # Errors
    /// If the bodies cannot touch, a point lies outside of the body, or its equations have no solution.
    pub fn in_contact(
        bodies: [&Body; 2],
        which: usize,
        tractions: &VectorField,
        points: &[Point],
    ) -> Result<Option<Self>, ElasticError> {
        let meeting = Meeting::of(bodies)?;
        let Body { material: Some(material), finite: Some(finite), .. } = bodies[which] else {
            return Ok(None);
        };
        let Some((job, acting)) = meeting.acting_on(which, tractions) else { return Ok(None) };
        Self::of((material, finite.tolerance), &job, &acting, points).map(Some)
    }

    /// Solves equations, integrals to that relative tolerance, under tractions of contact.
    fn of(
        (material, tolerance): (&Material, f64),
        job: &Job<'_>,
        acting: &[f64],
        points: &[Point],
    ) -> Result<Self, ElasticError> {
        let surface = job.surface;
        let solid = Solid::new(surface, material, job.conditions, tolerance)?;
        let boundary = solid.boundary(acting);
        drop(solid);
        let interior = Interior::new(surface, material, &boundary, tolerance);
        let stress = interior.surface_stress();
        let outside = |point: &Point| ElasticError::Outside { point: point.clone() };
        let at = |point: &Point| interior.at(point.place.into()).ok_or_else(|| outside(point));
        let points = points.iter().map(at).collect::<Result<_, _>>()?;
        let balance = Balance::of(surface, job.conditions, &boundary.traction);
        let forces = forces(surface, job.conditions, &boundary);
        Ok(Self { surface: surface.clone(), boundary, stress, points, balance, forces })
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

/// The equivalent stress of von Mises (Pa).
pub fn von_mises(stress: &DMat3) -> f64 {
    let mean = (stress.x_axis.x + stress.y_axis.y + stress.z_axis.z) / 3.0;
    let deviator = *stress - mean * DMat3::IDENTITY;
    let square: f64 = deviator.to_cols_array().iter().map(|value| value * value).sum();
    (1.5 * square).sqrt()
}

/// The columns of a response: displacements (m), stresses and the equivalent stress (Pa).
pub fn row(response: &Response) -> Vec<(String, f64)> {
    let displacement = response.displacement.to_array().into_iter();
    let displacement = ["x", "y", "z"]
        .into_iter()
        .zip(displacement)
        .map(|(axis, value)| (format!("displacement_{axis}_m"), value));
    let stress = STRESSES
        .iter()
        .map(|(name, [i, j])| (format!("stress_{name}_Pa"), response.stress.col(*j)[*i]));
    let equivalent = ("von_mises_Pa".to_owned(), von_mises(&response.stress));
    displacement.chain(stress).chain([equivalent]).collect()
}

#[cfg(test)]
mod tests {
    use glam::{DMat3, DVec3};

    use super::von_mises;

    #[test]
    fn von_mises_knows_tension_shear_and_pressure() {
        let tension = DMat3::from_diagonal(DVec3::new(0.0, -3.0, 0.0));
        let shear = DMat3::from_cols(DVec3::Y, DVec3::X, DVec3::ZERO);
        assert!((von_mises(&tension) - 3.0).abs() < 1e-14);
        assert!((von_mises(&shear) - 3f64.sqrt()).abs() < 1e-14);
        assert!(von_mises(&(5.0 * DMat3::IDENTITY)) < 1e-14);
    }
}
