//! A body whose equations are solved.

use faer::Mat;
use glam::DVec3;

use super::assemble::{Assembly, System};
use super::balance::Balance;
use super::conditions::{AxisCondition, Condition, Conditions};
use super::kelvin::{Evaluations, Kelvin};
use super::loads::{LoadResponse, Loads};
use super::making::{Listener, Stage};
use super::surface::{Surface, TractionNode};
use crate::body::Material;
use crate::numerics::dense::{Lu, SolveError};
use crate::numerics::large::{Large, NoMemory};

/// A body with its factorised equations.
pub struct Solid<'a> {
    surface: &'a Surface,
    conditions: &'a Conditions,
    factors: Lu,
    contact: Large<f64>,
    fixed: Mat<f64>,
    unit: f64,
}

/// What every traction of contact, and the loads elsewhere, make of a body: what is sought at its nodes, in columns.
#[derive(Debug, Clone, PartialEq)]
pub struct Responses {
    /// A column for each component of the traction of each contact node, and one for the loads elsewhere.
    pub sought: Mat<f64>,
}

/// A body whose equations are assembled.
pub struct AssembledBody<'a> {
    surface: &'a Surface,
    conditions: &'a Conditions,
    system: System,
    unit: f64,
}

/// Displacements and tractions on the surface of a body, along x, y and z.
#[derive(Debug, Clone, PartialEq)]
pub struct Boundary {
    /// Displacement (m), a value a node of displacements.
    pub displacement: Vec<DVec3>,
    /// Traction (Pa), a value a node of tractions.
    pub traction: Vec<DVec3>,
}

/// How a body answers to the tractions of its contact nodes.
#[derive(Debug, Clone)]
pub struct CondensedBody {
    /// Displacement (m) of contact node i along direction d of its basis under a unit traction (Pa) at node
    /// j along direction e: row 3 i + d, column 3 j + e.
    pub compliance: Mat<f64>,
    /// Displacement (m) without any traction of contact, three values a contact node.
    pub free: Vec<f64>,
    /// What is left of the balance under even loads of the zone, the worst of them.
    pub balance: Balance,
}

/// What to do about equations without a solution.
pub fn advice(cause: &SolveError) -> &'static str {
    match cause {
        SolveError::Singular { .. } => "are elements degenerate?",
        SolveError::NoMemory(_) => "take fewer elements",
    }
}

impl<'a> AssembledBody<'a> {
    /// Assembles the equations, integrals to that relative tolerance.
    ///
    /// # Errors
    /// If there is no memory for them.
    pub fn new(
        surface: &'a Surface,
        material: &Material,
        conditions: &'a Conditions,
        tolerance: f64,
    ) -> Result<Self, NoMemory> {
        Self::telling((surface, conditions), material, tolerance, Listener::default())
    }

    /// The same, somebody told how far it is.
    ///
    /// # Errors
    /// If there is no memory for them.
    pub fn telling(
        (surface, conditions): (&'a Surface, &'a Conditions),
        material: &Material,
        tolerance: f64,
        told: Listener<'_>,
    ) -> Result<Self, NoMemory> {
        let length = length_of(surface);
        let unit = length / material.shear_modulus();
        let kelvin = Kelvin::new(material.poisson, length);
        let system = Assembly::new(surface, conditions, (kelvin, unit), tolerance).system(told)?;
        Ok(Self { surface, conditions, system, unit })
    }

    /// Assembles the equations with other loads, each by itself, besides what is known.
    ///
    /// # Errors
    /// If there is no memory for them.
    pub fn under(
        (surface, conditions): (&'a Surface, &'a Conditions),
        material: &Material,
        tolerance: f64,
        loads: &Loads,
    ) -> Result<Self, NoMemory> {
        let length = length_of(surface);
        let unit = length / material.shear_modulus();
        let kelvin = Kelvin::new(material.poisson, length);
        let assembly = Assembly::new(surface, conditions, (kelvin, unit), tolerance);
        let system = assembly.under(loads).system(Listener::default())?;
        Ok(Self { surface, conditions, system, unit })
    }

    /// How often Kelvin's solution was evaluated.
    pub fn evaluations(&self) -> Evaluations {
        self.system.evaluations
    }

    /// Factorises the equations.
    ///
    /// # Errors
    /// If they have no unique solution.
    pub fn factorise(self) -> Result<Solid<'a>, SolveError> {
        let Self { surface, conditions, system, unit } = self;
        let factors = Lu::new(system.matrix)?;
        let (contact, fixed) = (system.contact, system.fixed);
        Ok(Solid { surface, conditions, factors, contact, fixed, unit })
    }
}

/// The length (m) that lengths are divided by: half of the extent of a body.
fn length_of(surface: &Surface) -> f64 {
    let low = surface.nodes.iter().fold(DVec3::INFINITY, |low, node| low.min(*node));
    let high = surface.nodes.iter().fold(DVec3::NEG_INFINITY, |high, node| high.max(*node));
    0.5 * (high - low).max_element()
}

impl<'a> Solid<'a> {
    /// Assembles and factorises the equations, integrals to that relative tolerance.
    ///
    /// # Errors
    /// If the equations have no unique solution.
    pub fn new(
        surface: &'a Surface,
        material: &Material,
        conditions: &'a Conditions,
        tolerance: f64,
    ) -> Result<Self, SolveError> {
        AssembledBody::new(surface, material, conditions, tolerance)?.factorise()
    }

    /// The compliance of the contact nodes.
    pub fn condense(self) -> CondensedBody {
        self.condense_telling(Listener::default())
    }

    /// The same, somebody told how far it is.
    pub fn condense_telling(self, told: Listener<'_>) -> CondensedBody {
        /// Columns that are solved for at once: enough for products of matrices to be as quick as with all of them.
        const COLUMNS: usize = 512;
        let balance = self.balance();
        let Self { conditions, factors, mut contact, mut fixed, unit, .. } = self;
        let nodes: Vec<usize> = conditions
            .contact
            .iter()
            .map(|&traction| self.surface.tractions[traction].node)
            .collect();
        // Columns of nodes in contact come last.
        let sought = nodes.iter().map(|&node| conditions.columns[node]).min();
        let count = sought.map_or(0, |first| factors.size() - first);
        let columns = contact.as_ref().ncols();
        for first in (0..columns).step_by(COLUMNS) {
            told.tell(factors.size(), Stage::Condensing, first as f64 / columns as f64);
            let some = contact.as_mut().subcols_mut(first, COLUMNS.min(columns - first));
            factors.solve_last(some, count);
        }
        factors.solve_last(fixed.as_mut(), count);
        let contact = contact.as_ref();
        // Displacements are sought along the axes or, at nodes that are held, along their basis.
        let row = |index: usize, column: &dyn Fn(usize) -> f64| -> f64 {
            let (contact, direction) = (index / 3, index % 3);
            let basis = &conditions.nodes[nodes[contact]].basis;
            let along = conditions.tractions[conditions.contact[contact]].basis[direction];
            let first = conditions.columns[nodes[contact]];
            (0..3).map(|own| basis[own].dot(along) * column(first + own)).sum()
        };
        let size = 3 * nodes.len();
        // Across a plane of symmetry nothing moves, and no traction acts.
        let across = |index: usize| {
            let along = conditions.tractions[conditions.contact[index / 3]].basis[index % 3];
            self.surface.across_plane(nodes[index / 3], along)
        };
        let across: Vec<bool> = (0..size).map(across).collect();
        let compliance = Mat::from_fn(size, size, |index, column| {
            if across[index] || across[column] {
                return 0.0;
            }
            unit * row(index, &|place| contact[(place, column)])
        });
        let free = (0..size).map(|index| row(index, &|place| fixed[(place, 0)])).collect();
        CondensedBody { compliance, free, balance }
    }

    /// The worst balance under even loads of the zone: a traction along each direction, a pressure that grows
    /// along x or y; and under the loads elsewhere.
    ///
    /// Even loads are what bends a body. Under single columns, loads of one node, what is left of the balance is
    /// that of the node's own element.
    fn balance(&self) -> Balance {
        let loads = self.even_loads();
        let columns = loads.iter().map(|load| {
            let sought = self.sought(load, false);
            let tractions = self.tractions(&sought, load, false);
            self.balance_of(&tractions)
        });
        let mut worst = columns.fold(Balance::default(), Balance::worst);
        let given = |condition: &Condition| {
            condition.given.iter().any(|given| match given {
                AxisCondition::Traction(value) | AxisCondition::Displacement(value) => {
                    *value != 0.0
                }
                AxisCondition::Contact => false,
            })
        };
        if self.conditions.tractions.iter().any(given) {
            let sought = self.sought(&[], true);
            worst = worst.worst(self.balance_of(&self.tractions(&sought, &[], true)));
        }
        worst
    }

    fn balance_of(&self, tractions: &[DVec3]) -> Balance {
        Balance::of(self.surface, self.conditions, tractions)
    }

    /// Tractions (Pa) of contact in their bases, three values a contact node.
    fn even_loads(&self) -> Vec<Vec<f64>> {
        let contact = &self.conditions.contact;
        if contact.is_empty() {
            return vec![];
        }
        let node = |index: usize| &self.surface.tractions[contact[index]];
        let count = contact.len() as f64;
        let middle = (0..contact.len()).map(|index| node(index).place).sum::<DVec3>() / count;
        let reach = (0..contact.len()).map(|index| node(index).place.distance(middle));
        let reach = reach.fold(0.0, f64::max);
        let load = |along: usize, share: &dyn Fn(DVec3) -> f64| -> Vec<f64> {
            let value = |index: usize| {
                let (contact, direction) = (index / 3, index % 3);
                let unit =
                    self.conditions.tractions[self.conditions.contact[contact]].basis[direction];
                if direction != along || self.surface.across_plane(node(contact).node, unit) {
                    return 0.0;
                }
                share((node(contact).place - middle) / reach)
            };
            (0..3 * contact.len()).map(value).collect()
        };
        let [first, second, _] = self.conditions.tractions[contact[0]].basis;
        let mut loads: Vec<_> = (0..3).map(|along| load(along, &|_| 1.0)).collect();
        if reach > 0.0 {
            loads.extend([first, second].map(|axis| load(2, &|place| place.dot(axis))));
        }
        loads
    }

    /// What loads besides what is known make of the body, each by itself.
    pub fn loaded(self) -> LoadResponse {
        let Self { factors, mut fixed, unit, .. } = self;
        factors.solve_in_place(fixed.as_mut());
        LoadResponse { sought: fixed, unit }
    }

    /// What every traction of contact makes of the body.
    pub fn responses(&self) -> Responses {
        let (contact, fixed) = (self.contact.as_ref(), self.fixed.as_ref());
        let (rows, columns) = (fixed.nrows(), contact.ncols() + 1);
        let mut sought = Mat::from_fn(rows, columns, |row, column| match column + 1 == columns {
            true => fixed[(row, 0)],
            false => contact[(row, column)],
        });
        self.factors.solve_in_place(sought.as_mut());
        Responses { sought }
    }

    /// Displacements and tractions everywhere, under given tractions of contact (Pa) in their bases, three
    /// values a contact node.
    pub fn boundary(&self, tractions: &[f64]) -> Boundary {
        let known = Known { surface: self.surface, conditions: self.conditions, unit: self.unit };
        known.boundary(&self.sought(tractions, true), tractions)
    }

    /// What is sought at the nodes under tractions of contact, with the loads elsewhere or without.
    fn sought(&self, tractions: &[f64], loaded: bool) -> Mat<f64> {
        let contact = self.contact.as_ref();
        let mut sought =
            if loaded { self.fixed.clone() } else { Mat::zeros(self.fixed.nrows(), 1) };
        for (column, &traction) in tractions.iter().enumerate().filter(|(_, one)| **one != 0.0) {
            for row in 0..sought.nrows() {
                sought[(row, 0)] += self.unit * traction * contact[(row, column)];
            }
        }
        self.factors.solve_in_place(sought.as_mut());
        sought
    }

    fn tractions(&self, sought: &Mat<f64>, contact: &[f64], loaded: bool) -> Vec<DVec3> {
        let known = Known { surface: self.surface, conditions: self.conditions, unit: self.unit };
        known.tractions(sought, contact, loaded)
    }
}

impl Responses {
    /// The size of the columns, and how many there are.
    pub fn size(surface: &Surface, conditions: &Conditions) -> [usize; 2] {
        [surface.unknowns(), 3 * conditions.contact.len() + 1]
    }

    /// Displacements and tractions everywhere, as of [`Solid::boundary`] and without equations.
    pub fn boundary(
        &self,
        (surface, conditions): (&Surface, &Conditions),
        material: &Material,
        tractions: &[f64],
    ) -> Boundary {
        let unit = length_of(surface) / material.shear_modulus();
        let last = self.sought.ncols() - 1;
        let sought = Mat::from_fn(self.sought.nrows(), 1, |row, _| {
            let loads = tractions.iter().enumerate().filter(|(_, one)| **one != 0.0);
            let of = |(column, traction): (usize, &f64)| traction * self.sought[(row, column)];
            self.sought[(row, last)] + unit * loads.map(of).sum::<f64>()
        });
        Known { surface, conditions, unit }.boundary(&sought, tractions)
    }
}

/// What is known of a body besides its equations.
struct Known<'a> {
    surface: &'a Surface,
    conditions: &'a Conditions,
    /// What tractions are multiplied by in the equations (m/Pa).
    unit: f64,
}

impl Known<'_> {
    /// Displacements and tractions everywhere, from what was sought under tractions of contact (Pa).
    fn boundary(&self, sought: &Mat<f64>, tractions: &[f64]) -> Boundary {
        let conditions = self.conditions;
        let displacement = conditions.nodes.iter().enumerate().map(|(node, condition)| {
            let along = |own: usize| match condition.known[own] {
                Some(known) => known.displacement,
                None => sought[(conditions.columns[node] + own, 0)],
            };
            (0..3).map(|own| along(own) * condition.basis[own]).sum()
        });
        Boundary {
            displacement: displacement.collect(),
            traction: self.tractions(sought, tractions, true),
        }
    }

    /// Tractions (Pa) at their nodes, from what was sought.
    fn tractions(&self, sought: &Mat<f64>, contact: &[f64], loaded: bool) -> Vec<DVec3> {
        let conditions = self.conditions;
        let traction = |(index, traction): (usize, &TractionNode)| {
            let condition = &conditions.tractions[index];
            let node = &conditions.nodes[traction.node];
            let value = |direction: usize| match condition.given[direction] {
                AxisCondition::Traction(traction) if loaded => {
                    traction * condition.basis[direction]
                }
                AxisCondition::Contact => {
                    let column = conditions.contact_column[index].unwrap_or_default();
                    let value = contact.get(3 * column + direction).copied().unwrap_or_default();
                    value * condition.basis[direction]
                }
                AxisCondition::Traction(_) | AxisCondition::Displacement(_) => DVec3::ZERO,
            };
            let given: DVec3 = (0..3).map(value).sum();
            let held = (0..3).filter(|&own| node.known[own].is_some_and(|k| k.traction == index));
            let found: DVec3 = held
                .map(|own| {
                    let value = sought[(conditions.columns[traction.node] + own, 0)];
                    value / self.unit * node.basis[own]
                })
                .sum();
            given + found
        };
        self.surface.tractions.iter().enumerate().map(traction).collect()
    }
}
