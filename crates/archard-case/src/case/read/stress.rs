//! What is wanted of the largest stresses in bodies.

use crate::case::definition::BodyCase;
use crate::case::key::Key;
use crate::case::problem::Problem;
use crate::case::reader::{Reader, Section};
use crate::case::tree::{Item, Node};
use crate::output::{COMPONENTS, WantedDamage, WantedFatigue, WantedStresses};
use archard::elastic::Endurance;
use archard::parameters::{Bound, Parameter, Quantity};

/// An even stress.
const INITIAL: &[Parameter] = &[
    component("xx"),
    component("yy"),
    component("zz"),
    component("xy"),
    component("zx"),
    component("yz"),
];

const fn component(name: &'static str) -> Parameter {
    Parameter::optional(name, Quantity::Pressure, "component of the stress, positive in tension")
        .bound(Bound::Any)
}

/// Criteria of fatigue.
const FATIGUE: &[Parameter] = &[
    Parameter::optional(
        "crossland",
        Quantity::Number,
        "factor on the largest hydrostatic stress, next to the amplitude of shear",
    ),
    Parameter::optional(
        "dang_van",
        Quantity::Number,
        "factor on the hydrostatic stress, next to the shear at the same moment",
    ),
    Parameter::optional(
        "findley",
        Quantity::Number,
        "factor on the largest normal stress, next to the amplitude of shear on the same plane",
    ),
    Parameter::optional(
        "fatemi_socie",
        Quantity::Number,
        "factor on the largest normal stress over the yield strength, for the amplitude of shear strain on the same plane",
    ),
    Parameter::optional(
        "smith_watson_topper",
        Quantity::Truth,
        "whether the largest normal stress times the amplitude of normal strain is sought",
    ),
];

/// The damage by a criterion.
const DAMAGE: &[Parameter] = &[
    Parameter::required(
        "criterion",
        Quantity::Word(&["crossland", "dang_van", "findley", "smith_watson_topper"]),
        "one of those of `fatigue`",
    ),
    Parameter::required(
        "strength",
        Quantity::Pressure,
        "the value of the criterion that breaks in half a cycle, of Basquin's line: value = strength (2 N)^exponent",
    ),
    Parameter::required("exponent", Quantity::Number, "that of the same line, negative")
        .bound(Bound::Between(-1.0, 0.0)),
];

const PARAMETERS: &[Parameter] = &[
    Parameter::optional(
        "field",
        Quantity::Truth,
        "whether the stresses at all elements and depths are put out, as `stress_BODY.vtr`",
    ),
    Parameter::optional(
        "initial",
        Quantity::Section(INITIAL),
        "an even stress that is added: residual, or what the whole body bears",
    ),
    Parameter::optional(
        "swinging",
        Quantity::Section(INITIAL),
        "an even stress that swings in phase with friction over a cycle, added for `fatigue`: as it is where friction pushes the body forward by most",
    ),
    Parameter::optional(
        "fatigue",
        Quantity::Section(FATIGUE),
        "criteria of fatigue of points that pass through the contact, with their factors",
    ),
    Parameter::optional(
        "damage",
        Quantity::Section(DAMAGE),
        "the sum, over all cycles of fretting, of their shares of the life that a criterion lets",
    ),
    Parameter::optional(
        "yield_strength",
        Quantity::Pressure,
        "yield stress in tension; without it the hardness over 2.8, where that is known",
    ),
];

/// A list of depths by how they grow.
const RANGE: &[Parameter] = &[
    Parameter::required("first", Quantity::Length, "the least depth"),
    Parameter::required("last", Quantity::Length, "the largest depth"),
    Parameter::required("count", Quantity::Count, "how many depths, in a constant ratio"),
];

/// Most depths that are looked at, each at the cost of a field: a budget.
const MOST: usize = 200;

impl Reader<'_> {
    /// The stresses of each body that are wanted.
    pub(super) fn stresses_of_bodies(
        &mut self,
        root: &Section<'_>,
        bodies: &[BodyCase; 2],
    ) -> Option<[Option<WantedStresses>; 2]> {
        let of_a_body =
            "stresses are those of a body: `output.stress.BODY = { depths = \"auto\" }`";
        let found = self.of_bodies(root, bodies, ("stress", of_a_body), |reader, section| {
            reader.stresses(section).map(|wanted| vec![wanted])
        });
        let mut found = found?.map(|wanted| wanted.into_iter().next());
        for (wanted, body) in found.iter_mut().zip(bodies) {
            let layers = body.layers.iter().map(|layer| layer.hardness);
            let below = body.material.as_ref().and_then(|material| material.hardness);
            let hardness = layers.chain([below]).collect();
            wanted.iter_mut().for_each(|wanted| wanted.hardness = Vec::clone(&hardness));
        }
        Some(found)
    }

    fn stresses(&mut self, section: &Section<'_>) -> Option<WantedStresses> {
        let before = self.problems.len();
        let (values, _) = self.values_among(section, PARAMETERS, &["depths", "layer_strengths"]);
        let depths = match section.get("depths") {
            None => vec![],
            Some((key, entry)) => self.depths(key, &entry.node)?,
        };
        let layer_strengths = match section.get("layer_strengths") {
            None => vec![],
            Some((key, entry)) => self.strengths(key, &entry.node)?,
        };
        let even = |added: &str| {
            let own = values.section(added);
            COMPONENTS.map(|name| own.and_then(|own| own.number(name)).unwrap_or_default())
        };
        let (initial, swinging) = (even("initial"), even("swinging"));
        let fatigue = values.section("fatigue");
        let factor = |name: &str| fatigue.and_then(|own| own.number(name));
        let fatigue = WantedFatigue {
            crossland: factor("crossland"),
            dang_van: factor("dang_van"),
            findley: factor("findley"),
            fatemi_socie: factor("fatemi_socie"),
            smith_watson_topper: fatigue.is_some_and(|own| own.is_true("smith_watson_topper")),
        };
        let damage = values.section("damage").and_then(|own| {
            let [strength, exponent] =
                ["strength", "exponent"].map(|name| own.number(name).unwrap_or_default());
            let endurance = Endurance { strength, exponent };
            Some(WantedDamage { criterion: own.word("criterion")?.to_owned(), endurance })
        });
        let (field, strength) = (values.is_true("field"), values.number("yield_strength"));
        (self.problems.len() == before).then_some(WantedStresses {
            depths,
            field,
            initial,
            swinging,
            strength,
            layer_strengths,
            hardness: vec![],
            fatigue,
            damage,
        })
    }

    /// Yield stresses (Pa) of layers.
    fn strengths(&mut self, key: Key, node: &Node) -> Option<Vec<f64>> {
        let Item::Array(nodes) = &node.item else {
            let message = format!(
                "expected the yield stress of each layer from the surface down, [\"5 GPa\", \"900 MPa\"], found {}",
                node.item.kind()
            );
            self.push(Problem::error(key, message));
            return None;
        };
        let each = nodes.iter().enumerate();
        let each = each.map(|(i, node)| self.number(key.index(i), node, Quantity::Pressure));
        each.collect()
    }

    /// Depths (m), rising; none where the contact decides.
    fn depths(&mut self, key: Key, node: &Node) -> Option<Vec<f64>> {
        let mut depths = match &node.item {
            Item::Text(text) if text == "auto" => return Some(vec![]),
            Item::Array(nodes) => {
                let each = nodes.iter().enumerate();
                let each = each.map(|(i, node)| self.number(key.index(i), node, Quantity::Length));
                each.collect::<Option<Vec<_>>>()?
            }
            Item::Table(table) => {
                let before = self.problems.len();
                let section = Section { key: key.clone(), table };
                let (values, _) = self.values(&section, RANGE);
                if self.problems.len() > before {
                    return None;
                }
                let [first, last, count] =
                    ["first", "last", "count"].map(|name| values.number(name).unwrap_or_default());
                if last <= first {
                    self.push(Problem::error(key.child("last"), "is not deeper than `first`"));
                    return None;
                }
                let ratio = |i: f64| (last / first).powf(i / (count - 1.0).max(1.0));
                (0..count.min(MOST as f64 + 1.0) as usize)
                    .map(|i| first * ratio(i as f64))
                    .collect()
            }
            other => {
                let message = format!(
                    "expected \"auto\", a list like [\"5 um\", \"20 um\"], or {{ first = \"2 um\", last = \"1 mm\", count = 24 }}, found {}",
                    other.kind()
                );
                self.push(Problem::error(key, message));
                return None;
            }
        };
        if depths.is_empty() || depths.len() > MOST {
            let message = format!("give between one and {MOST} depths");
            self.push(Problem::error(key, message));
            return None;
        }
        depths.sort_by(f64::total_cmp);
        depths.dedup();
        Some(depths)
    }
}
