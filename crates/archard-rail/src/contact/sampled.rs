//! What the points of measured profiles leave open about a contact.
//!
//! A jackknife: the contact is found again with profiles from which one point in every [`GROUPS`] is left out, each of them once. What
//! differs from one to the next is what the noise from point to point does to a value: its variance is (n - 1)/n times the sum of
//! the squares about the mean (M. H. Quenouille, *Biometrika* 43 (1956) 353; J. W. Tukey 1958). Noise that lasts over many
//! points, as a datum that is off, does not show.

use super::{Bodies, ContactError, Loaded, Operation, Patch, Quantities, Resolution};
use crate::profile::Profile;
use crate::setup::Setup;

/// Groups of points, each left out once. A choice: more take longer, and leave their spread surer.
pub const GROUPS: usize = 4;
/// Student's t that 95 % of all means of as many groups lie within, with one degree of freedom less than groups.
const STUDENT: f64 = 3.182;

impl Profile {
    /// The profile without the points of each group in turn; its ends stay.
    pub fn without_groups(&self) -> [Self; GROUPS] {
        let last = self.points.len() - 1;
        std::array::from_fn(|group| {
            let kept = |at: usize| at == 0 || at == last || at % GROUPS != group;
            let points = self.points.iter().enumerate().filter(|(at, _)| kept(*at));
            Self { points: points.map(|(_, point)| *point).collect() }
        })
    }
}

/// The same patches, their errors with what the profiles of [`Profile::without_groups`] leave open. Each patch is held against the one
/// next to it.
///
/// # Errors
/// As [`contact`](super::contact()).
pub fn sampled(
    mut patches: Vec<Patch>,
    setups: &[Setup],
    bodies: &Bodies,
    operation: &Operation,
    resolution: &Resolution,
) -> Result<Vec<Patch>, ContactError> {
    let found = setups.iter().map(|setup| {
        let loaded = Loaded::new(setup, bodies, operation, resolution)?;
        let (_, pressed) = loaded.on(resolution.elements / 2, loaded.guess())?;
        let borne = pressed.iter().filter(|patch| patch.normal > 0.0);
        Ok(borne.map(|patch| loaded.tell(patch)).collect())
    });
    let found = found.collect::<Result<Vec<Vec<Quantities>>, ContactError>>()?;
    for patch in &mut patches {
        let from = |one: &Quantities| (one.y_rail - patch.values.y_rail).abs();
        let near = found.iter().filter_map(|all| {
            all.iter().min_by(|one, other| from(one).total_cmp(&from(other))).copied()
        });
        let near: Vec<Quantities> = near.collect();
        let Some(zero) = near.first().map(|one| one.with(one, |_, _| 0.0)) else { continue };
        let count = near.len() as f64;
        let sum = |all: Vec<Quantities>| {
            all.iter().fold(zero, |sum, one| sum.with(one, |sum, one| sum + one))
        };
        let mean = sum(near.clone());
        let squares =
            near.iter().map(|one| one.with(&mean, |one, sum| (one - sum / count).powi(2)));
        let squares = sum(squares.collect());
        let open = |squares: f64| STUDENT * ((count - 1.0) / count * squares).sqrt();
        patch.errors = patch.errors.with(&squares, |error, squares| error + open(squares));
    }
    Ok(patches)
}
