//! `archard laws`: lists the laws of wear and friction with what they take, or shows one in full.

use archard::friction::{ABOUT_FRICTION, FRICTION};
use archard::parameters::{About, Choice, Parameter, Quantity};
use archard::wear::{ABOUT_WEAR_LAWS, WEAR_LAWS};
use archard_case::nearest;

use crate::failure::Failure;
use crate::say::say;

/// The page of the book with the laws.
const PAGE: &str = "Laws of wear and friction";

/// A law of either kind.
struct Law {
    /// How a case names it: `wear.energy`.
    key: String,
    /// Where that stands in a case.
    place: &'static str,
    name: &'static str,
    meaning: &'static str,
    parameters: &'static [Parameter],
    about: Option<&'static About>,
}

/// Lists all laws, or shows those of a name.
pub fn laws(name: Option<&str>) -> Result<(), Failure> {
    let Some(name) = name else {
        say("Wear laws, each in the table of a body as `wear.NAME`\n")?;
        list(WEAR_LAWS)?;
        say("Friction laws, one in a case as `[friction.NAME]`\n")?;
        list(FRICTION)?;
        return say("archard laws NAME shows one in full");
    };
    let wear = all("wear", "the table of a body", WEAR_LAWS, ABOUT_WEAR_LAWS);
    let friction = all("friction", "the top of a case", FRICTION, ABOUT_FRICTION);
    let known: Vec<Law> = wear.chain(friction).collect();
    let plain = name.trim().to_lowercase().replace([' ', '-'], "_");
    let asked = known.iter().filter(|law| law.name == plain || law.key == plain);
    let pages: Vec<String> = asked.map(Law::page).collect();
    if pages.is_empty() {
        let names: Vec<&str> = known.iter().map(|law| law.name).collect();
        let next = nearest(&plain, &names).map_or_else(
            || "`archard laws` lists them".to_owned(),
            |near| format!("did you mean `{near}`?"),
        );
        return Err(Failure::wrong(format!("there is no law `{name}`; {next}")));
    }
    say(&pages.join("\n\n"))
}

/// The laws of a kind.
fn all<T>(
    kind: &'static str,
    place: &'static str,
    choices: &'static [Choice<T>],
    about: &'static [About],
) -> impl Iterator<Item = Law> {
    choices.iter().map(move |&Choice { name, meaning, parameters, .. }| {
        let about = about.iter().find(|about| about.name == name);
        Law { key: format!("{kind}.{name}"), place, name, meaning, parameters, about }
    })
}

impl Law {
    /// All there is to read of it.
    fn page(&self) -> String {
        let Self { key, place, meaning, parameters, about, .. } = self;
        let mut page = format!("{key}\n\n  {meaning}\n");
        if !parameters.is_empty() {
            page += "\nTakes\n\n";
        }
        let widths = widths(parameters);
        for parameter in *parameters {
            page += &line(parameter, widths);
            if is_bounded(parameter.quantity) {
                page += &format!("; {}", parameter.bound);
            }
            page.push('\n');
        }
        if let Some(About { source, example, files, .. }) = about {
            page += &format!("\nExample, in {place}\n\n    {key} = {example}\n");
            for (name, content) in *files {
                page += &format!("\n  with the file {name}\n\n");
                content.lines().for_each(|line| page += &format!("    {line}\n"));
            }
            page += &format!("\nSource: {source}\n");
        }
        page + &format!("In the book: {PAGE}")
    }
}

/// Whether values of a quantity are numbers within a bound.
fn is_bounded(quantity: Quantity) -> bool {
    match quantity {
        Quantity::Pair(inner) | Quantity::Triple(inner) | Quantity::OneOrThree(inner) => {
            is_bounded(*inner)
        }
        Quantity::Number | Quantity::Count => true,
        other => !other.unit().is_empty(),
    }
}

fn list<T>(choices: &[Choice<T>]) -> Result<(), Failure> {
    for choice in choices {
        say(&format!("{}: {}", choice.name, choice.meaning))?;
        let widths = widths(choice.parameters);
        for parameter in choice.parameters {
            say(&line(parameter, widths))?;
        }
        say("")?;
    }
    Ok(())
}

/// The widest name and the widest unit of parameters.
fn widths(parameters: &[Parameter]) -> [usize; 2] {
    let names = parameters.iter().map(|parameter| parameter.name.len());
    let units = parameters.iter().map(|parameter| unit(parameter).len());
    [names.max().unwrap_or(0), units.max().unwrap_or(0)]
}

/// The unit of a parameter; a dash where it has none.
fn unit(parameter: &Parameter) -> &'static str {
    match parameter.quantity.unit() {
        "" => "-",
        unit => unit,
    }
}

/// A parameter in a line.
fn line(parameter: &Parameter, [name, unit_width]: [usize; 2]) -> String {
    let optional = if parameter.required { "" } else { " (optional)" };
    format!(
        "    {:name$}  {:unit_width$}  {}{optional}",
        parameter.name,
        unit(parameter),
        parameter.meaning
    )
}
