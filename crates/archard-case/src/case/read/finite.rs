//! The mesh of a body and what holds it.

use glam::DVec3;

use crate::case::check::memory;
use crate::case::definition::{BodyCase, BuildError, FrameCase};
use crate::case::finite::FiniteCase;
use crate::case::key::Key;
use crate::case::nearest::nearest;
use crate::case::problem::Problem;
use crate::case::read::image;
use crate::case::reader::{Reader, Section};
use crate::case::tree::{Entry, Item, Node};
use archard::body::mesh::{ContactMesh, MESHES, MeshError, MeshProblem, Zone};
use archard::body::{Elasticity, Interpolation, Support};
use archard::compliance::bem::Size;
use archard::parameters::{Bound, Parameter, Quantity};

/// What boundary elements take.
const BOUNDARY_ELEMENTS: &[Parameter] = &[
    Parameter::optional(
        "interpolation",
        Quantity::Word(&["discontinuous", "continuous"]),
        "how tractions and displacements vary over elements",
    ),
    Parameter::optional("tolerance", Quantity::Number, "relative error of the integrals")
        .bound(Bound::Between(0.0, 0.1)),
];

/// Relative error of the integrals where a case says nothing.
const TOLERANCE: f64 = 1e-6;

/// Length (m) beyond which the unit of a file is in doubt.
const LARGE: f64 = 10.0;

impl Reader<'_> {
    /// The mesh of a body, `Some(None)` where it has none; `None` if it is wrong.
    pub(super) fn finite(&mut self, body: &Section<'_>) -> Option<Option<FiniteCase>> {
        let Some((key, entry)) = body.get("mesh") else {
            for name in ["symmetry", "supports", "elasticity", "boundary_elements"] {
                if let Some((key, _)) = body.get(name) {
                    let message = "has no effect without a `mesh`";
                    self.push(Problem::warning(key, message).at_name());
                }
            }
            return Some(None);
        };
        let section = self.as_table(key, &entry.node)?;
        let mesh = self.required(&section, "mesh", MESHES);
        let mirrored = self.symmetry(body);
        let elasticity = mesh.as_ref().and_then(|mesh| self.elasticity(body, mesh));
        let elements = match body.get("boundary_elements") {
            None => Some((Interpolation::default(), TOLERANCE)),
            Some((key, entry)) => self.as_table(key, &entry.node).map(|section| {
                let (values, _) = self.values(&section, BOUNDARY_ELEMENTS);
                let interpolation = match values.word("interpolation") {
                    Some("continuous") => Interpolation::Continuous,
                    _ => Interpolation::Discontinuous,
                };
                (interpolation, values.number("tolerance").unwrap_or(TOLERANCE))
            }),
        };
        let (mesh, mirrored, (interpolation, tolerance)) = (mesh?, mirrored?, elements?);
        let (elasticity, says, why) = elasticity?;
        // Generators ask what is held; whether the mesh has these surfaces is seen once it is there.
        let read = self.supports(body, elasticity);
        let supports = read.clone().unwrap_or_default();
        let finite =
            FiniteCase { mesh, supports, mirrored, interpolation, tolerance, elasticity, why };
        let finite = if says { finite } else { image::chosen(finite, self.framed) };
        let finite = match finite.elasticity {
            // Nodes at the corners are those of the tetrahedra.
            own if own.bears() => FiniteCase { interpolation: Interpolation::Continuous, ..finite },
            _ => finite,
        };
        let meshed = self.meshed(&section, &finite)?;
        let named = self.named(body, &finite, &meshed);
        (read.is_some() && named).then_some(Some(finite))
    }

    /// The mesh, if it is sound.
    fn meshed(&mut self, section: &Section<'_>, finite: &FiniteCase) -> Option<ContactMesh> {
        let key = section.key.child(finite.mesh.choice.name);
        if finite.elasticity == Elasticity::Image || finite.elasticity.bears() {
            return self.imaged(&key, finite);
        }
        let shape = finite.mesh.build().ok()?;
        let held = finite.held();
        // A mesh that no memory holds is not even made.
        let least = Size::at_least(shape.at_least(finite.mirrored, &held), finite.interpolation);
        if let Some(problem) = memory::too_large(least.memory(), memory::free_memory()) {
            let problem = match finite.mesh.values.get("path") {
                Some(_) => problem.help(memory::COARSER),
                None => problem,
            };
            self.push(Problem { key: memory::key(section.key.clone(), &finite.mesh), ..problem });
            return None;
        }
        let meshed = match shape.mesh(finite.mirrored, &held) {
            Ok(meshed) => meshed,
            Err(error) => {
                let place = error.parameter().split('.').fold(key, |key, name| key.child(name));
                self.push(Problem::error(place, error.to_string()));
                return None;
            }
        };
        self.sound(&key, finite, &meshed).then_some(meshed)
    }

    /// The coarse mesh of an image field, or that of finite elements, if it is sound.
    fn imaged(&mut self, key: &Key, finite: &FiniteCase) -> Option<ContactMesh> {
        match finite.meshed() {
            // What generators make is sound.
            Ok(meshed) if meshed.volume.is_none() => Some(meshed),
            Ok(meshed) => self.sound(key, finite, &meshed).then_some(meshed),
            Err(error) => {
                let own = || key.child("compliance");
                let (key, message) = match &error {
                    BuildError::Mesh(cause @ MeshError::Matrix { .. }) => {
                        (own(), cause.to_string())
                    }
                    BuildError::Invalid(cause)
                        if ["compliance", "places"].contains(&&*cause.parameter) =>
                    {
                        (key.child(&cause.parameter), cause.message.clone())
                    }
                    _ => (key.clone(), error.to_string()),
                };
                self.push(Problem::error(key, message));
                None
            }
        }
    }

    /// Whether a mesh is the surface of one body.
    fn sound(&mut self, key: &Key, finite: &FiniteCase, meshed: &ContactMesh) -> bool {
        self.unit(key, finite, meshed);
        let mut sound = true;
        // Generators draw elements out on purpose, away from the zone; what is inside has elements of its own.
        let slender = |problem: &MeshProblem| {
            matches!(problem, MeshProblem::Slender { .. })
                && (!meshed.placed || meshed.volume.is_some())
        };
        let mirrored = if meshed.volume.is_some() { [false; 2] } else { finite.mirrored };
        let problems = meshed.mesh.check(mirrored).into_iter();
        for problem in problems.filter(|problem| !slender(problem)) {
            let message = problem.to_string();
            if problem.is_warning() {
                self.push(Problem::warning(key.clone(), message));
            } else {
                sound = false;
                self.push(Problem::error(key.clone(), message));
            }
        }
        sound
    }

    /// A warning where a file of no unit makes a body larger than most.
    fn unit(&mut self, key: &Key, finite: &FiniteCase, meshed: &ContactMesh) {
        let [low, high] = meshed.mesh.bounds(0..meshed.mesh.faces.len());
        let longest = (high - low).max_element();
        if finite.mesh.values.get("path").is_some()
            && finite.mesh.values.get("unit").is_none()
            && longest > LARGE
        {
            let message =
                format!("the body is {longest:.4} m long: its file says nothing of the unit");
            let help = "give `unit = \"mm\"` if its coordinates are in mm, `unit = \"m\"` if it is that large";
            self.push(Problem::warning(key.child("path"), message).help(help));
        }
    }

    /// Whether a body says where it may touch, if it is meshed.
    pub(super) fn touches(&mut self, bodies: &Key, body: &BodyCase) -> bool {
        let Some(finite) = &body.finite else { return true };
        let framed = body.has_image() && (self.framed || finite.zone().is_some());
        if framed || finite.meshed().is_ok_and(|meshed| !meshed.zone.faces.is_empty()) {
            return true;
        }
        let key = bodies.child(&body.name).child("mesh").child(finite.mesh.choice.name);
        let message = "is missing: the part of the surface that may touch";
        self.push(Problem::missing(key.child("contact"), message));
        false
    }

    /// The planes of symmetry.
    fn symmetry(&mut self, body: &Section<'_>) -> Option<[bool; 2]> {
        let Some((key, entry)) = body.get("symmetry") else { return Some([false; 2]) };
        let mut mirrored = [false; 2];
        let Item::Array(axes) = &entry.node.item else {
            let message = format!("expected a list like [\"x\"], found {}", entry.node.item.kind());
            self.push(Problem::error(key, message));
            return None;
        };
        for (index, axis) in axes.iter().enumerate() {
            match &axis.item {
                Item::Text(name) if name == "x" => mirrored[0] = true,
                Item::Text(name) if name == "y" => mirrored[1] = true,
                _ => {
                    let message = "expected \"x\" or \"y\", for the plane x = 0 or y = 0";
                    self.push(Problem::error(key.index(index), message));
                    return None;
                }
            }
        }
        Some(mirrored)
    }

    /// What is known on surfaces.
    fn supports(
        &mut self,
        body: &Section<'_>,
        elasticity: Elasticity,
    ) -> Option<Vec<(String, Support)>> {
        let Some((key, entry)) = body.get("supports") else {
            if matches!(elasticity, Elasticity::HalfSpace | Elasticity::Reduced) {
                return Some(vec![]);
            }
            let message = "is missing: what holds the body, for example `{ bottom = \"clamped\" }`";
            self.push(Problem::missing(body.key.child("supports"), message));
            return None;
        };
        let section = self.as_table(key, &entry.node)?;
        let mut supports = vec![];
        for entry in &section.table.0 {
            let key = section.key.child(&entry.name);
            if let Some(support) = self.support(key.clone(), entry) {
                if elasticity == Elasticity::HalfSpace && support.loads() {
                    let message = "has no effect: a half-space knows of no other surface";
                    self.push(Problem::warning(key, message).at_name());
                }
                supports.push((entry.name.clone(), support));
            }
        }
        (supports.len() == section.table.0.len()).then_some(supports)
    }

    /// Whether the mesh has the surfaces that supports name.
    fn named(&mut self, body: &Section<'_>, finite: &FiniteCase, meshed: &ContactMesh) -> bool {
        let Some((key, entry)) = body.get("supports") else { return true };
        let Item::Table(table) = &entry.node.item else { return true };
        let known: Vec<&str> = meshed.mesh.surfaces.iter().map(String::as_str).collect();
        let strange = table.0.iter().filter(|entry| !known.contains(&entry.name.as_str()));
        let mut all = true;
        for entry in strange {
            let meant = nearest(&entry.name, &known);
            let message = meant.map_or_else(
                || "is no surface of the mesh".to_owned(),
                |meant| format!("is no surface of the mesh; did you mean `{meant}`?"),
            );
            // Numbers of a file say little: where they lie says more.
            let help = match finite.listed() {
                Some(listed) => {
                    let places = listed.iter().map(|one| format!("\n  {one}"));
                    format!("there are{}", places.collect::<String>())
                }
                None => format!("there are {}", known.join(", ")),
            };
            self.push(Problem::error(key.child(&entry.name), message).at_name().help(help));
            all = false;
        }
        all
    }

    fn support(&mut self, key: Key, entry: &Entry) -> Option<Support> {
        const EXPECTED: &str = "expected \"clamped\", \"roller\", or a table with `displacement`, `traction` or `pressure`";
        match &entry.node.item {
            Item::Text(word) if word == "clamped" => Some(Support::Clamped),
            Item::Text(word) if word == "roller" => Some(Support::Roller),
            Item::Table(table) => {
                let section = Section { key: key.clone(), table };
                self.unknown(&section, "key", &["displacement", "traction", "pressure"]);
                let [entry] = &table.0[..] else {
                    self.push(Problem::error(key, EXPECTED));
                    return None;
                };
                let inner = section.key.child(&entry.name);
                match entry.name.as_str() {
                    "pressure" => self
                        .any_number(inner, &entry.node, Quantity::Pressure)
                        .map(Support::Pressure),
                    "traction" => self
                        .three(inner, &entry.node, |reader, key, node| {
                            reader.any_number(key, node, Quantity::Pressure)
                        })
                        .map(Support::Traction),
                    "displacement" => self
                        .three(inner, &entry.node, |reader, key, node| match &node.item {
                            Item::Text(word) if word == "free" => Some(None),
                            _ => reader.any_number(key, node, Quantity::Length).map(Some),
                        })
                        .map(Support::Displacement),
                    _ => None,
                }
            }
            _ => {
                self.push(Problem::error(key, EXPECTED));
                None
            }
        }
    }

    /// Three values in a list, along x, y and z.
    pub(super) fn three<T>(
        &mut self,
        key: Key,
        node: &Node,
        read: impl Fn(&mut Self, Key, &Node) -> Option<T>,
    ) -> Option<[T; 3]> {
        let Item::Array(values) = &node.item else {
            let message =
                format!("expected three values, along x, y and z, found {}", node.item.kind());
            self.push(Problem::error(key, message));
            return None;
        };
        let [x, y, z] = &values[..] else {
            let message =
                format!("expected three values, along x, y and z, found {}", values.len());
            self.push(Problem::error(key, message));
            return None;
        };
        let [x, y, z] =
            [(0, x), (1, y), (2, z)].map(|(axis, node)| read(self, key.index(axis), node));
        Some([x?, y?, z?])
    }
}

/// What the contact zone of the body that bears the pairs amounts to as a frame: its extent along x and y, and as many
/// elements as there are pairs.
pub(super) fn zone(bodies: &[BodyCase; 2]) -> Option<FrameCase> {
    if let Some(body) = bodies.iter().find(|body| body.has_image()) {
        let (size, elements) = body.finite.as_ref()?.zone()?;
        return Some(FrameCase { size, elements, ..FrameCase::to_be_chosen() });
    }
    let mut meshed = bodies.iter().filter_map(|body| {
        let finite = body.finite.as_ref()?;
        Some((finite, finite.meshed().ok()?))
    });
    let first = meshed.next()?;
    let (finite, meshed) = match first.1.has_plane_zone() {
        true => first,
        false => meshed.find(|(_, other)| other.has_plane_zone()).unwrap_or(first),
    };
    let ContactMesh { mesh, zone: Zone { faces, grid }, .. } = &meshed;
    let axes = match meshed.placed {
        true => meshed.axes(finite.mirrored)?,
        false => DVec3::AXES,
    };
    let corners = faces.iter().flat_map(|&face| mesh.faces[face].corners.as_slice());
    let places: Vec<[f64; 3]> =
        corners.map(|&corner| axes.map(|axis| axis.dot(mesh.vertices[corner].into()))).collect();
    let images = finite.mirrored.map(|mirrored| if mirrored { 2 } else { 1 });
    let size = [0, 1].map(|axis| {
        let values = places.iter().map(|place| place[axis]);
        let (low, high) = values
            .fold((f64::MAX, f64::MIN), |(low, high), value| (low.min(value), high.max(value)));
        images[axis] as f64 * (high - low)
    });
    let pairs = |elements: usize| match finite.interpolation {
        Interpolation::Discontinuous => 2 * elements,
        Interpolation::Continuous => elements + 1,
    };
    let elements = grid.map(|grid| [0, 1].map(|axis| images[axis] * pairs(grid[axis])));
    let elements = elements.unwrap_or_else(|| {
        // As many as there are, of about one width.
        let count = Size::of(&meshed, finite.interpolation).contact / 3 * images[0] * images[1];
        let across = |axis: usize| (count as f64 * size[axis] / size[1 - axis]).sqrt();
        [0, 1].map(|axis| across(axis).round().clamp(1.0, count as f64) as usize)
    });
    Some(FrameCase { size, elements, ..FrameCase::to_be_chosen() })
}
