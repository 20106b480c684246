//! `archard laws`: lists the laws of wear and friction with what they take.

use archard::friction::FRICTION;
use archard::parameters::{Choice, Parameter};
use archard::wear::WEAR_LAWS;

use crate::failure::Failure;
use crate::say::say;

/// Lists all laws.
pub fn laws() -> Result<(), Failure> {
    say("Wear laws, each in the table of a body as `wear.NAME`\n")?;
    list(WEAR_LAWS)?;
    say("Friction laws, one in a case as `[friction.NAME]`\n")?;
    list(FRICTION)
}

fn list<T>(choices: &[Choice<T>]) -> Result<(), Failure> {
    for choice in choices {
        say(&format!("{}: {}", choice.name, choice.meaning))?;
        let names = choice.parameters.iter().map(|parameter| parameter.name.len());
        let units = choice.parameters.iter().map(|parameter| unit(parameter).len());
        let widths = [names.max().unwrap_or(0), units.max().unwrap_or(0)];
        for parameter in choice.parameters {
            say(&line(parameter, widths))?;
        }
        say("")?;
    }
    Ok(())
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
