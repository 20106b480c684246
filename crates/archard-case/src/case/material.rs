//! What the bodies of a case are made of.

use archard::body::{Body, Layer, Material, Thermal};
use archard::parameters::{Invalid, Parameter, Quantity, Value, Values};

use super::materials::HandbookMaterial;

const NAME: Parameter = Parameter::optional(
    "name",
    Quantity::Text,
    "name in the table of materials, `archard materials`, whose values count where none are given",
);
const HARDNESS: Parameter = Parameter::optional(
    "hardness",
    Quantity::Pressure,
    "indentation hardness: elastic pressures above it are doubted",
);
const OWN: [Parameter; 8] = {
    let (&[young, shear, poisson], &[conductivity, diffusivity, ..]) =
        (Material::PARAMETERS, Thermal::PARAMETERS)
    else {
        panic!("a material has two moduli and a ratio, a conductor conductivity and diffusivity")
    };
    let [conductivity, diffusivity] = optional([conductivity, diffusivity]);
    [NAME, young, shear, poisson, HARDNESS, Body::DENSITY, conductivity, diffusivity]
};
const OF_NAMED: [Parameter; 8] = optional(OWN);
const OF_LAYER: [Parameter; 5] = {
    let &[thickness, young, poisson] = Layer::PARAMETERS else {
        panic!("a layer has a thickness, a modulus and a ratio")
    };
    [thickness, NAME, young, poisson, HARDNESS]
};
const OF_NAMED_LAYER: [Parameter; 5] = {
    let [thickness, others @ ..] = OF_LAYER;
    let [name, young, poisson, hardness] = optional(others);
    [thickness, name, young, poisson, hardness]
};
const OF_CONDUCTOR: [Parameter; 4] = {
    let &[conductivity, diffusivity, share, temperature] = Thermal::PARAMETERS else {
        panic!("conductivity, diffusivity, share and temperature")
    };
    optional([conductivity, diffusivity, share, temperature])
};

/// The same parameters, all of them optional.
const fn optional<const N: usize>(mut parameters: [Parameter; N]) -> [Parameter; N] {
    let mut place = 0;
    while place < N {
        parameters[place].required = false;
        place += 1;
    }
    parameters
}

/// A material, its values in SI.
#[derive(Debug, Clone, PartialEq)]
pub struct MaterialCase {
    /// Its name in the table of materials; `None` for one of the user's.
    pub name: Option<String>,
    /// How it deforms.
    pub elastic: Material,
    /// Its indentation hardness (Pa); `None` where it is not known.
    pub hardness: Option<f64>,
    /// Its density (kg/m^3); `None` where it is not known.
    pub density: Option<f64>,
    /// Its thermal conductivity (W/(m K)); `None` where it is not known.
    pub conductivity: Option<f64>,
    /// Its thermal diffusivity (m^2/s); `None` where it is not known.
    pub diffusivity: Option<f64>,
}

impl MaterialCase {
    /// What a material takes in a case, one that is named or one of the user's.
    pub(super) fn parameters(named: bool) -> &'static [Parameter] {
        if named { &OF_NAMED } else { &OWN }
    }

    /// What a layer takes, of a material that is named or one of the user's.
    pub(super) fn layer_parameters(named: bool) -> &'static [Parameter] {
        if named { &OF_NAMED_LAYER } else { &OF_LAYER }
    }

    /// From values that passed the declaration, and the material whose values count where none are given.
    ///
    /// # Errors
    /// If a value is missing, or both moduli are given.
    pub(super) fn read(values: &Values, named: Option<&HandbookMaterial>) -> Result<Self, Invalid> {
        let or = |given: Parameter, known: fn(&HandbookMaterial) -> Option<f64>| {
            values.number(given.name).or_else(|| named.and_then(known))
        };
        let [_, young, shear, poisson, _, _, k, diffusivity] = OWN;
        let mut elastic = values.clone();
        let mut complete = |given: Parameter, known: fn(&HandbookMaterial) -> f64| {
            if let Some(named) = named.filter(|_| values.get(given.name).is_none()) {
                elastic.insert(given.name, Value::Number(known(named)));
            }
        };
        complete(poisson, |one| one.poisson);
        if values.get(shear.name).is_none() {
            complete(young, |one| one.young);
        }
        let density = or(Body::DENSITY, |one| Some(one.density));
        let conductivity = or(k, |one| one.conductivity);
        let heat = named.and_then(|one| one.heat);
        let follows = conductivity.zip(density).zip(heat).map(|((k, rho), c)| k / (rho * c));
        Ok(Self {
            name: named.map(|one| one.name.to_owned()),
            elastic: Material::read(&elastic)?,
            hardness: or(HARDNESS, |one| one.hardness),
            density,
            conductivity,
            diffusivity: values.number(diffusivity.name).or(follows),
        })
    }

    /// What the `thermal` table of a body takes, one of this material or of one that nothing is known of.
    pub(super) fn thermal_parameters(material: Option<&Self>) -> &'static [Parameter] {
        match material.and_then(Self::thermal) {
            Some(_) => &OF_CONDUCTOR,
            None => Thermal::PARAMETERS,
        }
    }

    /// What a `thermal` table says of heat, and of a material what it leaves out.
    ///
    /// # Errors
    /// As [`Thermal::read`].
    pub(super) fn heat(material: Option<&Self>, values: &Values) -> Result<Thermal, Invalid> {
        let known = material.and_then(Self::thermal);
        let known = known.iter().flat_map(Thermal::values);
        let missing = known.filter(|(parameter, _)| values.get(parameter.name).is_none());
        let mut values = values.clone();
        missing.for_each(|(one, value)| values.insert(one.name, Value::Number(value)));
        Thermal::read(&values)
    }

    /// How a body of it conducts heat, where that is known.
    pub fn thermal(&self) -> Option<Thermal> {
        Thermal::new(self.conductivity?, self.diffusivity?).ok()
    }

    /// Its values by the names of its parameters, those that are known.
    pub fn values(&self) -> impl Iterator<Item = (&'static Parameter, f64)> {
        let Self { elastic, hardness, density, conductivity, diffusivity, .. } = *self;
        let (young, poisson) = (Some(elastic.young), Some(elastic.poisson));
        let values = [None, young, None, poisson, hardness, density, conductivity, diffusivity];
        Self::parameters(true)
            .iter()
            .zip(values)
            .filter_map(|(parameter, value)| Some((parameter, value?)))
    }
}
