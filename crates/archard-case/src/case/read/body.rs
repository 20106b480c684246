//! The bodies of a case.

use crate::case::chosen::ChosenPart;
use crate::case::definition::{BodyCase, LayerCase};
use crate::case::key::Key;
use crate::case::material::MaterialCase;
use crate::case::nearest::nearest;
use crate::case::problem::Problem;
use crate::case::reader::{Reader, Section};
use crate::case::surface::profiles;
use crate::case::told::PROBLEMS;
use crate::case::tree::{Entry, Item};
use archard::body::{Body, Elasticity, Layer, Material};
use archard::compliance::HalfSpace;
use archard::parameters::Quantity;
use archard::wear::{WEAR_LAWS, WearLaw};

/// What a body may have.
const KEYS: &[&str] = &[
    "material",
    "rigid",
    "layers",
    "substrate",
    "profile",
    "mesh",
    "symmetry",
    "supports",
    "elasticity",
    "boundary_elements",
    "wear",
    "depth",
    "density",
    "hardness",
    "thermal",
];

impl Reader<'_> {
    /// Both bodies, in the order in which they are written.
    pub(super) fn bodies(&mut self, root: &Section<'_>) -> Option<[BodyCase; 2]> {
        let section = self.table(root, "body", "two bodies, `[body.NAME]` each")?;
        self.bodies = section.table.0.iter().map(|entry| entry.name.clone()).collect();
        let bodies: Vec<Option<BodyCase>> =
            section.table.0.iter().map(|entry| self.body(&section.key, entry)).collect();
        self.count_bodies(&section);
        let [Some(first), Some(second)] = <[_; 2]>::try_from(bodies).ok()? else { return None };
        let [first, second] = self.images([first, second])?;
        let rigid = |body: &BodyCase| body.material.is_none() && body.layers.is_empty();
        if rigid(&first) && rigid(&second) {
            let key = section.key.child(&second.name).child("rigid");
            self.push(
                Problem::error(key, "both bodies are rigid: one has to be elastic").at_name(),
            );
            return None;
        }
        let touching = [&first, &second].map(|body| self.touches(&section.key, body));
        (touching == [true; 2]).then_some([first, second])
    }

    fn count_bodies(&mut self, section: &Section<'_>) {
        let entries = &section.table.0;
        if let [.., last] = &entries[..]
            && entries.len() == 1
        {
            let message = format!("the second body is missing: only `{}` is given", last.name);
            self.push(Problem::missing(section.key.child(&last.name), message));
        }
        // One more than are told: each is compared with all before it.
        for (place, surplus) in entries.iter().enumerate().skip(2).take(PROBLEMS + 1) {
            let others: Vec<&str> = entries[..place].iter().map(|other| &*other.name).collect();
            let meant = nearest(&surplus.name, &others);
            let meant = meant.map_or_else(String::new, |name| format!("; did you mean `{name}`?"));
            let message = format!("a third body: a contact has two{meant}");
            self.push(Problem::error(section.key.child(&surplus.name), message).at_name());
        }
        if entries.is_empty() {
            self.push(Problem::error(section.key.clone(), "no body is given, a contact has two"));
        }
    }

    /// A body.
    pub(super) fn body(&mut self, bodies: &Key, entry: &Entry) -> Option<BodyCase> {
        let key = bodies.child(&entry.name);
        let named = Body::is_name(&entry.name);
        if !named {
            let message = format!("a body's name becomes part of column names: {}", Body::NAMES);
            self.push(Problem::error(key.clone(), message).at_name());
        }
        let section = self.as_table(key, &entry.node)?;
        self.unknown(&section, "key", KEYS);
        let material = self.material(&section);
        let layers = self.layers(&section);
        let finite = self.finite(&section);
        let profile = match (section.get("profile"), section.get("mesh")) {
            (None, Some(_)) => ChosenPart::named("flat", profiles()),
            _ => self
                .table(
                    &section,
                    "profile",
                    "the shape of the body, for example `profile.flat = {}`",
                )
                .and_then(|section| self.required(&section, "profile", profiles())),
        };
        let wear = self.wear(&section);
        let depth = match section.get("depth") {
            None => Some(None),
            Some((key, entry)) => self.number(key, &entry.node, Quantity::Length).map(Some),
        };
        let density = match section.get("density") {
            None => Some(None),
            Some((key, entry)) => self.number(key, &entry.node, Body::DENSITY.quantity).map(Some),
        };
        let hardness = match section.get("hardness") {
            None => Some(None),
            Some((key, entry)) => self.number(key, &entry.node, Body::HARDNESS.quantity).map(Some),
        };
        let thermal = self.thermal(&section, material.as_ref().and_then(Option::as_ref));
        if let (Some(material), Some(layers), Some(depth)) = (&material, &layers, &depth) {
            let below = material.as_ref().map(|one| &one.elastic);
            self.stacked(&section, below, layers, *depth)?;
        }
        if let (Some(None), Some(Some(_))) = (&material, &finite) {
            let message = "a rigid body does not deform: give its shape as a `profile` instead";
            self.push(Problem::error(section.key.child("mesh"), message).at_name());
            return None;
        }
        if let (Some(Some(material)), Some(Some(finite))) = (&material, &finite)
            && material.elastic.poisson == 0.5
            && finite.elasticity != Elasticity::HalfSpace
        {
            let message =
                "a body of finite shape must be compressible: below 0.5, for example 0.499";
            self.push(Problem::error(section.key.child("material").child("poisson"), message));
            return None;
        }
        let case = BodyCase {
            name: entry.name.clone(),
            material: material?,
            layers: layers?,
            profile: profile?,
            finite: finite?,
            wear: wear?,
            depth: depth?,
            density: density?,
            hardness: hardness?,
            thermal: thermal?,
        };
        if let Err(invalid) = case.law() {
            self.invalid(&section, invalid);
            return None;
        }
        Some(case).filter(|_| named)
    }

    /// The layers of a body from its surface down; `None` if one is wrong.
    fn layers(&mut self, body: &Section<'_>) -> Option<Vec<LayerCase>> {
        let Some((key, entry)) = body.get("layers") else { return Some(vec![]) };
        let example = "`[{ thickness = \"3 um\", young = \"300 GPa\", poisson = 0.2 }]`, from the surface down";
        let Item::Array(nodes) = &entry.node.item else {
            self.push(Problem::error(key, format!("expected layers: {example}")));
            return None;
        };
        if nodes.is_empty() {
            self.push(Problem::error(key, format!("expected one layer at least: {example}")));
            return None;
        }
        for other in ["rigid", "mesh"].into_iter().filter(|other| body.get(other).is_some()) {
            let message = format!("a body with `{other}` has no layers");
            self.push(Problem::error(key.clone(), message).at_name());
        }
        let before = self.problems.len();
        let layers = nodes.iter().enumerate().map(|(place, node)| {
            let section = self.as_table(key.index(place), node)?;
            let wear = self.wear(&section);
            let named = self.named_in(&section)?;
            let parameters = MaterialCase::layer_parameters(named.is_some());
            let (values, _) = self.values_among(&section, parameters, &["wear"]);
            let thickness = values.number("thickness")?;
            // What is missing was complained about.
            let MaterialCase { name, elastic, hardness, .. } =
                MaterialCase::read(&values, named).ok()?;
            let layer = Layer { material: elastic, thickness };
            Some(LayerCase { layer, name, hardness, wear: wear? })
        });
        let layers: Vec<_> = layers.collect();
        layers.into_iter().collect::<Option<_>>().filter(|_| self.problems.len() == before)
    }

    /// Whether layers can be computed on what is below them.
    fn stacked(
        &mut self,
        body: &Section<'_>,
        material: Option<&Material>,
        layers: &[LayerCase],
        depth: Option<f64>,
    ) -> Option<()> {
        let layers: Vec<Layer> = layers.iter().map(|one| one.layer).collect();
        let thickness: f64 = layers.iter().map(|layer| layer.thickness).sum();
        if let Some(why) = HalfSpace::refuses(material, &layers) {
            self.push(Problem::error(body.key.child("layers"), why).at_name());
            return None;
        }
        if !layers.is_empty() && depth.is_some_and(|depth| depth <= thickness) {
            let message =
                format!("the layers are {:.4} mm thick, as much or more", 1e3 * thickness);
            self.push(Problem::error(body.key.child("depth"), message));
            return None;
        }
        Some(())
    }

    /// The wear law, `Some(None)` where none exists; `None` if it is wrong.
    pub(super) fn wear(
        &mut self,
        body: &Section<'_>,
    ) -> Option<Option<ChosenPart<Box<dyn WearLaw>>>> {
        self.wear_of(body, "wear")
    }

    /// The same under another name.
    pub(super) fn wear_of(
        &mut self,
        body: &Section<'_>,
        name: &str,
    ) -> Option<Option<ChosenPart<Box<dyn WearLaw>>>> {
        let Some((key, entry)) = body.get(name) else { return Some(None) };
        let section = self.as_table(key, &entry.node)?;
        self.required(&section, "wear law", WEAR_LAWS).map(Some)
    }
}
