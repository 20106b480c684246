//! Materials by their names: what handbooks and standards say of them.
//!
//! The values are typical ones, rounded, at room temperature. Those of a batch are measured.

mod table;

pub use table::MATERIALS;

use super::nearest::nearest;

/// A material as handbooks have it, in SI. What is not known of it is `None`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HandbookMaterial {
    /// What it is called here.
    pub name: &'static str,
    /// What else it is called.
    pub also: &'static [&'static str],
    /// What it is, in the state that its hardness belongs to.
    pub state: &'static str,
    /// Young's modulus (Pa).
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
    /// Density (kg/m^3).
    pub density: f64,
    /// Indentation hardness (Pa), Vickers or Brinell.
    pub hardness: Option<f64>,
    /// Thermal conductivity (W/(m K)).
    pub conductivity: Option<f64>,
    /// Specific heat (J/(kg K)).
    pub heat: Option<f64>,
    /// Where the values are from.
    pub source: &'static str,
}

/// There is no material of that name.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("there is no material `{name}`")]
pub struct UnknownMaterial {
    /// The name, as written.
    pub name: String,
    /// A name that may have been meant.
    pub meant: Option<&'static str>,
}

impl UnknownMaterial {
    /// What to do: the name that may have been meant, or where they all are.
    pub fn help(&self) -> String {
        match self.meant {
            Some(meant) => format!("did you mean `{meant}`?"),
            None => "`archard materials` lists those there are; or give its `young` and `poisson`"
                .to_owned(),
        }
    }
}

impl HandbookMaterial {
    /// The material of a name, or of another that it is known by; capitals and what is neither letter nor digit do not count.
    ///
    /// # Errors
    /// If none exists, with the name nearest to it.
    pub fn find(name: &str) -> Result<&'static Self, UnknownMaterial> {
        let written = plain(name);
        let known: Vec<(String, &'static str, &'static Self)> =
            MATERIALS.iter().flat_map(Self::names).collect();
        if let Some((.., one)) = known.iter().find(|(plain, ..)| *plain == written) {
            return Ok(one);
        }
        let plains: Vec<&str> = known.iter().map(|(plain, ..)| plain.as_str()).collect();
        let near = nearest(&written, &plains);
        let meant = known.iter().find(|(plain, ..)| Some(plain.as_str()) == near);
        Err(UnknownMaterial { name: name.to_owned(), meant: meant.map(|(_, name, _)| *name) })
    }

    /// Its names, plain and as they are written, each with itself.
    fn names(&'static self) -> impl Iterator<Item = (String, &'static str, &'static Self)> {
        let names = std::iter::once(self.name).chain(self.also.iter().copied());
        names.map(move |name| (plain(name), name, self))
    }

    /// Thermal diffusivity (m^2/s), where conductivity and specific heat are known.
    pub fn diffusivity(&self) -> Option<f64> {
        Some(self.conductivity? / (self.density * self.heat?))
    }
}

/// A name without what is often left out.
fn plain(name: &str) -> String {
    name.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::{HandbookMaterial, MATERIALS, plain};
    use archard::body::{Body, Material, Thermal};

    #[test]
    fn names_are_found_as_people_write_them_and_belong_to_one_material() {
        let found = ["100Cr6", "100 cr 6", "AISI-52100", "ti6al4v", "Al2O3", "316 L"];
        let found = found.map(|name| HandbookMaterial::find(name).unwrap().name);
        assert_eq!(found, ["100Cr6", "100Cr6", "100Cr6", "Ti-6Al-4V", "Al2O3", "316L"]);
        let mut known = HashSet::new();
        for (plain, name, _) in MATERIALS.iter().flat_map(HandbookMaterial::names) {
            assert!(known.insert(plain), "{name}");
        }
    }

    #[test]
    fn names_nearly_right_are_answered_with_the_right_one() {
        let meant = |name: &str| HandbookMaterial::find(name).unwrap_err().meant;
        let written = ["100Cr5", "alumnia", "Inconell 718", "PEAK", "cheese of the moon"];
        assert_eq!(
            written.map(meant),
            [Some("100Cr6"), Some("alumina"), Some("Inconel 718"), Some("PEEK"), None]
        );
    }

    /// Each is one that bodies are made of, and no value has slipped by a power of ten: moduli of solids lie below diamond's, the
    /// hardness of metals and ceramics between E/500 and E/8, and the heat that a mole of atoms takes up, at most 25 J/K
    /// (Dulong and Petit), makes rho c no more than about 4 MJ/(m^3 K).
    #[test]
    fn values_are_those_of_solids() {
        for one in MATERIALS {
            let HandbookMaterial { name, young, poisson, density, hardness, conductivity, .. } =
                *one;
            assert!(Material::new(young, poisson).is_ok() && young <= 1.2e12, "{name}");
            assert!(Body::DENSITY.admit(density).is_ok() && (900.0..20e3).contains(&density));
            assert!(hardness.is_none_or(|one| (1.0 / 500.0..1.0 / 8.0).contains(&(one / young))));
            let heat = one.heat.map(|heat| density * heat);
            assert!(heat.is_none_or(|heat| (1e6..4.1e6).contains(&heat)), "{name}");
            if let (Some(conductivity), Some(diffusivity)) = (conductivity, one.diffusivity()) {
                assert!(Thermal::new(conductivity, diffusivity).is_ok(), "{name}");
            }
            assert!(!one.source.is_empty() && !one.state.is_empty() && !plain(name).is_empty());
        }
    }
}
