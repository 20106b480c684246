//! A checked case as a case file: every key in full, every value in SI.
//!
//! Each line is what `--set` would take.

use std::fmt::{self, Display, Formatter};
use std::path::PathBuf;

use super::chosen::ChosenPart;
use super::definition::{BodyCase, Case, FrameCase, LayerCase, Output};
use super::elastic::ElasticCase;
use super::finite::FiniteCase;
use super::quantity::measure;
use crate::output::{COMPONENTS, Limit, WantedDamage, WantedFatigue, WantedStresses};
use archard::body::{Elasticity, Interpolation, Support};
use archard::elastic::{Point, Section};
use archard::parameters::{Columns, Parameter, Quantity, Value, Values};
use archard::units::Measure;

impl Display for Case {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if let Some(title) = &self.title {
            writeln!(f, "title = {}\n", quoted(title))?;
        }
        if let Some(accuracy) = self.accuracy {
            writeln!(f, "accuracy = {}\n", number(accuracy))?;
        }
        for body in &self.bodies {
            let key = format!("body.{}", body.name);
            print_material(f, &key, body)?;
            print_chosen(f, &format!("{key}.profile"), &body.profile)?;
            if let Some(finite) = &body.finite {
                print_finite(f, &key, finite)?;
            }
            if let Some(wear) = &body.wear {
                print_chosen(f, &format!("{key}.wear"), wear)?;
            }
            if let Some(depth) = body.depth {
                writeln!(f, "{key}.depth = {}", si(depth, "m"))?;
            }
            if let Some(hardness) = body.hardness {
                writeln!(f, "{key}.hardness = {}", si(hardness, "Pa"))?;
            }
            if let Some(density) = body.density {
                writeln!(f, "{key}.density = {}", si(density, "kg/m^3"))?;
            }
            if let Some(thermal) = &body.thermal {
                print_values(f, &format!("{key}.thermal"), thermal.values())?;
            }
            writeln!(f)?;
        }
        let zone = |body: &BodyCase| body.finite.as_ref().is_some_and(|own| own.zone().is_some());
        if !self.is_meshed() && !self.bodies.iter().any(zone) {
            let FrameCase { centre, size, elements, line, periodic, .. } = self.frame;
            if periodic {
                writeln!(f, "frame.periodic = true")?;
            }
            let [x, y] = size.map(|size| si(size, "m"));
            let [from_x, from_y] = centre.map(|centre| si(centre, "m"));
            match (centre == [0.0; 2], line) {
                (true, _) => {}
                (false, true) => writeln!(f, "frame.centre = {from_x}")?,
                (false, false) => writeln!(f, "frame.centre = [{from_x}, {from_y}]")?,
            }
            if line {
                writeln!(f, "frame.plane_strain = true\nframe.length = {y}")?;
                let [along, strips] = elements;
                let count = if strips == 1 { along.to_string() } else { format!("{elements:?}") };
                writeln!(f, "frame.size = {x}\nframe.elements = {count}\n")?;
            } else {
                writeln!(f, "frame.size = [{x}, {y}]\nframe.elements = {elements:?}")?;
                if !self.doubles.is_empty() {
                    writeln!(f, "frame.doubles = [{}]", self.places(&self.doubles))?;
                }
                writeln!(f)?;
            }
        }
        if let Some(friction) = &self.friction {
            print_chosen(f, "friction", friction)?;
        }
        print_chosen(f, "motion", &self.motion)?;
        print_chosen(f, "solver", &self.solver)?;
        if self.friction.is_some() {
            print_chosen(f, "friction_solver", &self.friction_solver)?;
        }
        self.print_output(f)?;
        let columns = Limit::columns(self.bodies.each_ref().map(|body| &*body.name));
        for Limit { column, value } in &self.until {
            if let Some((key, _, unit)) = columns.iter().find(|(_, known, _)| known == column) {
                writeln!(f, "until.{key} = {}", si(*value, unit))?;
            }
        }
        for (body, points) in self.bodies.iter().zip(&self.points) {
            print_points(f, &format!("output.points.{}", body.name), points)?;
        }
        for (body, sections) in self.bodies.iter().zip(&self.sections) {
            print_sections(f, &format!("output.sections.{}", body.name), sections)?;
        }
        for (body, stresses) in self.bodies.iter().zip(&self.stresses) {
            if let Some(stresses) = stresses {
                print_stresses(f, &format!("output.stress.{}", body.name), stresses)?;
            }
        }
        Ok(())
    }
}

impl Case {
    fn print_output(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match &self.output {
            // What goes nowhere is put out once, whatever the interval.
            Output::Every(0.0) => Ok(()),
            Output::Every(interval) => writeln!(f, "output.every = {}", self.places(&[*interval])),
            Output::At(places) => writeln!(f, "output.at = [{}]", self.places(places)),
        }
    }

    /// Places of the motion, with their unit.
    fn places(&self, places: &[f64]) -> String {
        let quantity =
            self.motion.build().map_or(Quantity::Number, |(motion, _)| motion.progress.quantity);
        let place = |&place: &f64| match measure(quantity, &Values::default()) {
            Some(measure) => si(place, &measure.si),
            None => number(place),
        };
        places.iter().map(place).collect::<Vec<_>>().join(", ")
    }
}

impl Display for ElasticCase {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if let Some(title) = &self.title {
            writeln!(f, "title = {}\n", quoted(title))?;
        }
        let key = format!("body.{}", self.body.name);
        print_material(f, &key, &self.body)?;
        if let Some(finite) = &self.body.finite {
            print_finite(f, &key, finite)?;
        }
        writeln!(f)?;
        print_points(f, "output.points", &self.points)?;
        print_sections(f, "output.sections", &self.sections)
    }
}

fn print_points(f: &mut Formatter<'_>, key: &str, points: &[Point]) -> fmt::Result {
    for Point { name, place } in points {
        let place = place.map(|one| si(one, "m")).join(", ");
        writeln!(f, "{key}.{name} = [{place}]")?;
    }
    Ok(())
}

fn print_sections(f: &mut Formatter<'_>, key: &str, sections: &[Section]) -> fmt::Result {
    for Section { name, through, normal, spacing, size } in sections {
        let [through, normal] =
            [through.map(|one| si(one, "m")), normal.map(number)].map(|three| three.join(", "));
        writeln!(f, "{key}.{name}.through = [{through}]\n{key}.{name}.normal = [{normal}]")?;
        writeln!(f, "{key}.{name}.spacing = {}", si(*spacing, "m"))?;
        if let Some(size) = size {
            writeln!(f, "{key}.{name}.size = [{}]", size.map(|one| si(one, "m")).join(", "))?;
        }
    }
    Ok(())
}

fn print_stresses(f: &mut Formatter<'_>, key: &str, wanted: &WantedStresses) -> fmt::Result {
    let WantedStresses { depths, field, strength, layer_strengths, fatigue, .. } = wanted;
    let WantedFatigue { crossland, dang_van, findley, fatemi_socie, smith_watson_topper } = fatigue;
    if depths.is_empty() {
        writeln!(f, "{key}.depths = \"auto\"")?;
    } else {
        let depths: Vec<String> = depths.iter().map(|depth| si(*depth, "m")).collect();
        writeln!(f, "{key}.depths = [{}]", depths.join(", "))?;
    }
    if *field {
        writeln!(f, "{key}.field = true")?;
    }
    for (added, even) in [("initial", &wanted.initial), ("swinging", &wanted.swinging)] {
        for (name, value) in COMPONENTS.iter().zip(even).filter(|(_, value)| **value != 0.0) {
            writeln!(f, "{key}.{added}.{name} = {}", si(*value, "Pa"))?;
        }
    }
    if let Some(strength) = strength {
        writeln!(f, "{key}.yield_strength = {}", si(*strength, "Pa"))?;
    }
    if !layer_strengths.is_empty() {
        let each: Vec<String> = layer_strengths.iter().map(|own| si(*own, "Pa")).collect();
        writeln!(f, "{key}.layer_strengths = [{}]", each.join(", "))?;
    }
    for (name, factor) in [
        ("crossland", crossland),
        ("dang_van", dang_van),
        ("findley", findley),
        ("fatemi_socie", fatemi_socie),
    ] {
        if let Some(factor) = factor {
            writeln!(f, "{key}.fatigue.{name} = {}", number(*factor))?;
        }
    }
    if let Some(WantedDamage { criterion, endurance }) = &wanted.damage {
        writeln!(f, "{key}.damage.criterion = \"{criterion}\"")?;
        writeln!(f, "{key}.damage.strength = {}", si(endurance.strength, "Pa"))?;
        writeln!(f, "{key}.damage.exponent = {}", number(endurance.exponent))?;
    }
    if *smith_watson_topper {
        writeln!(f, "{key}.fatigue.smith_watson_topper = true")?;
    }
    Ok(())
}

fn print_material(f: &mut Formatter<'_>, key: &str, body: &BodyCase) -> fmt::Result {
    if !body.layers.is_empty() {
        let layers = body.layers.iter().map(|LayerCase { layer, name, hardness, wear }| {
            let [young, thickness] = [(layer.material.young, "Pa"), (layer.thickness, "m")]
                .map(|(value, unit)| si(value, unit));
            let poisson = number(layer.material.poisson);
            let name = name.as_ref().map(|name| format!(", name = {}", quoted(name)));
            let hardness = hardness.map(|hardness| format!(", hardness = {}", si(hardness, "Pa")));
            let [name, hardness] = [name, hardness].map(Option::unwrap_or_default);
            let wear = wear.as_ref().map_or_else(String::new, |wear| {
                let lines = Lines("wear", wear).to_string();
                lines.lines().map(|line| format!(", {line}")).collect()
            });
            format!("{{ thickness = {thickness}{name}, young = {young}, poisson = {poisson}{hardness}{wear} }}")
        });
        writeln!(f, "{key}.layers = [{}]", layers.collect::<Vec<_>>().join(", "))?;
    }
    let Some(material) = &body.material else {
        let rigid = if body.layers.is_empty() { "rigid = true" } else { "substrate = \"rigid\"" };
        return writeln!(f, "{key}.{rigid}");
    };
    if let Some(name) = &material.name {
        writeln!(f, "{key}.material.name = {}", quoted(name))?;
    }
    print_values(f, &format!("{key}.material"), material.values())
}

/// Values by their parameters, a line each.
fn print_values<'a>(
    f: &mut Formatter<'_>,
    key: &str,
    values: impl Iterator<Item = (&'a Parameter, f64)>,
) -> fmt::Result {
    for (parameter, value) in values {
        let value = match parameter.quantity.unit() {
            "" => number(value),
            unit => si(value, unit),
        };
        writeln!(f, "{key}.{} = {value}", parameter.name)?;
    }
    Ok(())
}

fn print_finite(f: &mut Formatter<'_>, key: &str, finite: &FiniteCase) -> fmt::Result {
    print_chosen(f, &format!("{key}.mesh"), &finite.mesh)?;
    let planes = ["x", "y"].into_iter().zip(finite.mirrored).filter(|(_, mirrored)| *mirrored);
    let planes: Vec<String> = planes.map(|(axis, _)| quoted(axis)).collect();
    writeln!(f, "{key}.symmetry = [{}]", planes.join(", "))?;
    for (surface, support) in &finite.supports {
        let three = |values: [String; 3]| format!("[{}]", values.join(", "));
        let value = match support {
            Support::Clamped => quoted("clamped"),
            Support::Roller => quoted("roller"),
            Support::Pressure(pressure) => format!("{{ pressure = {} }}", si(*pressure, "Pa")),
            Support::Traction(traction) => {
                format!("{{ traction = {} }}", three(traction.map(|one| si(one, "Pa"))))
            }
            Support::Displacement(displacement) => {
                let one = |known: Option<f64>| known.map_or(quoted("free"), |one| si(one, "m"));
                format!("{{ displacement = {} }}", three(displacement.map(one)))
            }
        };
        writeln!(f, "{key}.supports.{} = {value}", quoted(surface))?;
    }
    let elasticity = match finite.elasticity {
        Elasticity::HalfSpace => "half_space",
        Elasticity::Image => "image",
        Elasticity::BoundaryElements => "boundary_elements",
        Elasticity::FiniteElements => "finite_elements",
        Elasticity::Reduced => "compliance",
    };
    if finite.why.is_none() {
        writeln!(f, "{key}.elasticity = {}", quoted(elasticity))?;
    }
    let interpolation = match finite.interpolation {
        Interpolation::Continuous => "continuous",
        Interpolation::Discontinuous => "discontinuous",
    };
    writeln!(f, "{key}.boundary_elements.interpolation = {}", quoted(interpolation))?;
    writeln!(f, "{key}.boundary_elements.tolerance = {}", number(finite.tolerance))
}

/// A choice printed below some key.
struct Lines<'a, T: 'static>(&'a str, &'a ChosenPart<T>);

impl<T> Display for Lines<'_, T> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        print_chosen(f, self.0, self.1)
    }
}

pub(super) fn print_chosen<T>(
    f: &mut Formatter<'_>,
    key: &str,
    chosen: &ChosenPart<T>,
) -> fmt::Result {
    let key = format!("{key}.{}", chosen.choice.name);
    let printed = Printed { values: &chosen.values, files: &chosen.files };
    printed.print(f, &key, chosen.choice.parameters)
}

/// The values of one table, and the files they came from.
struct Printed<'a> {
    values: &'a Values,
    files: &'a [(&'static str, PathBuf)],
}

impl Printed<'_> {
    /// A line for every value, those of tables inside the table included.
    fn print(&self, f: &mut Formatter<'_>, key: &str, parameters: &[Parameter]) -> fmt::Result {
        if self.values.iter().next().is_none() {
            return writeln!(f, "{key} = {{}}");
        }
        let table = key;
        for parameter in parameters {
            let key = format!("{table}.{}", parameter.name);
            match (self.values.get(parameter.name), parameter.quantity) {
                (None, _) => {}
                (
                    Some(Value::Section(values)),
                    Quantity::Section(inner) | Quantity::TextOr(inner),
                ) => {
                    Printed { values, ..*self }.print(f, &key, inner)?;
                }
                (Some(Value::Constants(constants)), _) => {
                    for (name, text) in constants {
                        let value = text.parse().map_or_else(|_| quoted(text), number);
                        writeln!(f, "{table}.{name} = {value}")?;
                    }
                }
                (Some(value), _) => writeln!(f, "{key} = {}", self.value(parameter, value))?,
            }
        }
        Ok(())
    }

    fn value(&self, parameter: &Parameter, value: &Value) -> String {
        let one = |value: f64| self.number(parameter.quantity, value);
        match value {
            Value::Truth(said) => said.to_string(),
            Value::Word(word) | Value::Body(_, word) => quoted(word),
            Value::Formula { text, files } => quoted(&formula(text, files)),
            Value::Number(value) => one(*value),
            Value::Pair([x, y]) => format!("[{}, {}]", one(*x), one(*y)),
            Value::Triple([x, y, z]) => format!("[{}, {}, {}]", one(*x), one(*y), one(*z)),
            Value::Table(_) | Value::File { .. } => {
                let file = self.files.iter().find(|(name, _)| *name == parameter.name);
                quoted(&file.map(|(_, file)| file.display().to_string()).unwrap_or_default())
            }
            // Printed by itself, line by line.
            Value::Section(_) | Value::Constants(_) => String::new(),
        }
    }

    fn number(&self, quantity: Quantity, value: f64) -> String {
        match (measure(quantity, self.values), quantity) {
            (Some(measure), _) if measure != Measure::NUMBER => si(value, &measure.si),
            (
                None,
                Quantity::Count
                | Quantity::Pair(Quantity::Count)
                | Quantity::OneOrThree(Quantity::Count),
            ) => format!("{value:.0}"),
            _ => number(value),
        }
    }
}

/// A formula whose files are named by their places.
fn formula(text: &str, files: &[Columns]) -> String {
    files.iter().fold(text.to_owned(), |text, Columns { file, path, .. }| {
        let quote = if path.contains('\'') { '"' } else { '\'' };
        let place = format!("{quote}{path}{quote}");
        text.replace(&format!("'{file}'"), &place).replace(&format!("\"{file}\""), &place)
    })
}

/// A value with its SI unit, in quotes.
pub(super) fn si(value: f64, unit: &str) -> String {
    format!("\"{} {unit}\"", digits(value))
}

/// A number that TOML takes for one with a broken part.
pub(super) fn number(value: f64) -> String {
    let digits = digits(value);
    if digits.contains(['.', 'e']) { digits } else { digits + ".0" }
}

/// The fewest digits that read back to the same bits.
fn digits(value: f64) -> String {
    let plain = value == 0.0 || (1e-4..1e6).contains(&value.abs());
    if plain { value.to_string() } else { format!("{value:e}") }
}

/// A text in quotes, as TOML writes it.
pub(super) fn quoted(text: &str) -> String {
    let mut quoted = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c.is_control() => quoted.push_str(&format!("\\u{:04X}", u32::from(c))),
            c => quoted.push(c),
        }
    }
    quoted + "\""
}
