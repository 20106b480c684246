//! What a case can name: materials, and laws of wear and friction.

use archard::friction::{ABOUT_FRICTION, FRICTION};
use archard::parameters::{About, Choice};
use archard::wear::{ABOUT_WEAR_LAWS, WEAR_LAWS};
use archard_case::materials::MATERIALS;
use pyo3::prelude::*;

/// Name, state and source of a material, and its values in SI: Young's modulus, Poisson's ratio and density; hardness, conductivity and heat
/// where they are known.
type Material = (&'static str, &'static str, &'static str, (f64, f64, f64), Perhaps);

type Perhaps = (Option<f64>, Option<f64>, Option<f64>);

/// A key that a law takes: name, unit, meaning, and whether it must be given.
type Key = (&'static str, &'static str, &'static str, bool);

/// Where a law stands in a case, its meaning, its keys, its source and an example.
type Law = (String, &'static str, Vec<Key>, &'static str, &'static str);

/// All materials.
#[pyfunction]
pub fn materials() -> Vec<Material> {
    let of = |one: &archard_case::materials::HandbookMaterial| {
        let known = (one.young, one.poisson, one.density);
        (one.name, one.state, one.source, known, (one.hardness, one.conductivity, one.heat))
    };
    MATERIALS.iter().map(of).collect()
}

/// All laws of wear, then those of friction.
#[pyfunction]
pub fn laws() -> Vec<Law> {
    let wear = all("wear", WEAR_LAWS, ABOUT_WEAR_LAWS);
    wear.chain(all("friction", FRICTION, ABOUT_FRICTION)).collect()
}

fn all<T>(
    kind: &'static str,
    choices: &'static [Choice<T>],
    about: &'static [About],
) -> impl Iterator<Item = Law> {
    choices.iter().map(move |choice| {
        let keys = choice.parameters.iter();
        let keys = keys.map(|key| (key.name, key.quantity.unit(), key.meaning, key.required));
        let about = about.iter().find(|about| about.name == choice.name);
        let (source, example) = about.map_or(("", ""), |about| (about.source, about.example));
        (format!("{kind}.{}", choice.name), choice.meaning, keys.collect(), source, example)
    })
}
