//! A law written as a formula.
//!
//! The depth is a formula of what a point goes through, with constants that carry their units. It is read into a tree
//! (`parser`), held against the dimensions (`dimension`) and computed on columns (`tape`) with its derivative (`dual`). What a law
//! owes is [tried](try_out) at many points before it is taken.
//!
//! Limits: a formula that keeps to all that at the points tried may break it elsewhere.

mod dimension;
mod dual;
mod look_up;
mod parser;
mod tape;
#[cfg(test)]
mod tests;

use std::ops::Range;

use super::{Columns, Input, Per, Rubbing, WearLaw, try_out};
use crate::parameters::{About, Choice, Invalid, Parameter, Quantity};
use crate::units::{self, Dimension};
pub use look_up::LookUp;
use parser::{File, Mistake};
use tape::{Tape, Variable};

pub(super) const CHOICE: Choice<Box<dyn WearLaw>> = Choice {
    name: "expression",
    meaning: "by a formula: depth = \"k*p*s\" in the variables p, s, work, mu, v, temperature, distance, worn, rolled and cs; any motion that supplies what it names",
    parameters: &[
        Parameter::required("depth", Quantity::Formula, "formula of the depth, a length"),
        Parameter::optional(
            "per",
            Quantity::Word(&["increment", "cycle"]),
            "what it takes at once: \"increment\", any part of a motion, if not given, or \"cycle\", a whole cycle",
        ),
        Parameter::optional(
            "NAME",
            Quantity::Constants,
            "any other key is a constant of the formula: a number, or text with a unit",
        ),
    ],
    build: |values| {
        let (formula, files) = values.formula("depth").unwrap_or_default();
        let per = match values.word("per") {
            Some("cycle") => Per::Cycle,
            _ => Per::Increment,
        };
        let constants = values.constants("NAME").iter().map(|(name, text)| (&**name, &**text));
        let tables = files.iter().map(|file| (&*file.file, LookUp::of(file))).collect();
        Ok(Box::new(Expression::built(formula, &constants.collect::<Vec<_>>(), tables, per)?))
    },
};

pub(super) const ABOUT: About = About::new(
    CHOICE.name,
    "your own formula",
    "{ depth = \"k*p*s*(v/v0)^0.5\", k = \"1e-15 1/Pa\", v0 = \"1 m/s\" }",
);

/// What a formula may name: how it is called, what it is and its dimension.
const VARIABLES: &[(&str, Variable, Dimension)] = &[
    ("p", Variable::Pressure, Dimension::PRESSURE),
    ("s", Variable::Slip, Dimension::LENGTH),
    ("work", Variable::Work, Dimension::LOAD_PER_LENGTH),
    ("mu", Variable::Coefficient, Dimension::NUMBER),
    ("v", Variable::Given(Input::Speed), Dimension::SPEED),
    ("temperature", Variable::Given(Input::Temperature), Dimension::TEMPERATURE),
    ("distance", Variable::Given(Input::Distance), Dimension::LENGTH),
    ("worn", Variable::Given(Input::Depth), Dimension::LENGTH),
    ("rolled", Variable::Given(Input::Rolled), Dimension::LENGTH),
    ("cs", Variable::Given(Input::CrossShear), Dimension::NUMBER),
];

/// A depth by a formula.
#[derive(Debug, Clone, PartialEq)]
pub struct Expression {
    formula: String,
    tape: Tape,
    inputs: Vec<Input>,
    per: Per,
}

impl Expression {
    /// The law of a formula and its constants, each a name with a number or a value with its unit as text: `("k", "1e-13
    /// 1/Pa")`.
    ///
    /// The formula gives the depth (m) from the pressure `p` (Pa), the distance slid `s` (m), the `work` of friction
    /// (J/m^2), the coefficient of friction `mu` = work / (p s), the speed of sliding `v` (m/s), the `temperature` of the
    /// surfaces (K), the `distance` slid before (m), the depth `worn` before (m), the distance `rolled` (m) and the share `cs`
    /// by which directions of slip [cross](Rubbing::cross_shear). It asks for the [`Input`]s that it names. Where nothing presses or slides, `mu` is the slope of the friction limit.
    ///
    /// # Errors
    /// If the formula cannot be read, its dimensions do not agree or its value is no length; if a constant cannot be read,
    /// is not used or is named like a variable or function; and if the depth at one of many points tried is not finite,
    /// negative, not zero without pressure or slip, or falls as the pressure grows. [Per increment](Per::Increment), if two
    /// halves of a slip do not wear what the whole does.
    pub fn new(formula: &str, constants: &[(&str, &str)], per: Per) -> Result<Self, Invalid> {
        Self::built(formula, constants, vec![], per)
    }

    /// The same with tables, each with the name that `table('NAME', x)` calls it by in the formula: the value at x.
    ///
    /// # Errors
    /// As [`Expression::new`], and if the formula names a table that is not there, or looks up something of another
    /// dimension.
    pub fn with_tables(
        formula: &str,
        constants: &[(&str, &str)],
        tables: &[(&str, LookUp)],
        per: Per,
    ) -> Result<Self, Invalid> {
        let tables = tables.iter().map(|(name, table)| (*name, Ok(table.clone()))).collect();
        Self::built(formula, constants, tables, per)
    }

    /// The law, of tables that may be none.
    fn built(
        formula: &str,
        constants: &[(&str, &str)],
        tables: Vec<(&str, Result<LookUp, String>)>,
        per: Per,
    ) -> Result<Self, Invalid> {
        let tables = tables.into_iter().map(|(name, table)| (name.to_owned(), table)).collect();
        let mut scope = Scope { constants: vec![], tables };
        for (name, text) in constants {
            scope.add(name, text)?;
        }
        let wrong = |Mistake { at, message, help }| Invalid {
            help: help.map(Into::into),
            ..Invalid::new("depth", message).within(at)
        };
        let node = parser::parse(formula).map_err(wrong)?;
        dimension::check(&node, &scope).map_err(wrong)?;
        if let Some(surplus) = scope.constants.iter().find(|constant| !node.names(&constant.name)) {
            let message = "is no key of the law and no constant that the formula names";
            return Err(Invalid::new(surplus.name.clone(), message));
        }
        let tape = Tape::new(&node, &scope);
        let inputs = inputs(&tape);
        if inputs.contains(&Input::CrossShear) && per == Per::Increment {
            let message = "`cs` is of a whole cycle: say `per = \"cycle\"`";
            return Err(Invalid::new("depth", message));
        }
        let law = Self { formula: formula.to_owned(), tape, inputs, per };
        try_out(&law)?;
        Ok(law)
    }
}

/// What a formula asks for.
fn inputs(tape: &Tape) -> Vec<Input> {
    let mut inputs = vec![];
    for input in tape.variables().filter_map(Variable::input) {
        if !inputs.contains(&input) {
            inputs.push(input);
        }
    }
    inputs
}

/// The constants a formula may name besides the variables.
#[derive(Debug, Default)]
struct Scope {
    constants: Vec<Constant>,
    /// Tables by the names of their files; what is wrong with one counts where the formula names it.
    tables: Vec<(String, Result<LookUp, String>)>,
}

#[derive(Debug)]
struct Constant {
    name: String,
    /// In SI.
    value: f64,
    dimension: Dimension,
}

impl Scope {
    /// Adds a constant, a number or a value with its unit.
    fn add(&mut self, name: &str, text: &str) -> Result<(), Invalid> {
        let wrong = |message: String| Err(Invalid::new(name.to_owned(), message));
        if self.variable(name).is_some() || parser::is_reserved(name) {
            return wrong(
                "has a meaning in formulas already: name the constant otherwise".to_owned(),
            );
        }
        match units::measured(text) {
            Ok((value, dimension)) => {
                self.constants.push(Constant { name: name.to_owned(), value, dimension });
                Ok(())
            }
            Err(error) => wrong(error.to_string()),
        }
    }

    fn variable(&self, name: &str) -> Option<Variable> {
        VARIABLES.iter().find(|known| known.0 == name).map(|known| known.1)
    }

    /// The value (SI) of a constant.
    fn constant(&self, name: &str) -> Option<f64> {
        self.constants.iter().find(|known| known.name == name).map(|known| known.value)
    }

    fn dimension(&self, name: &str) -> Option<Dimension> {
        let variable = VARIABLES.iter().find(|known| known.0 == name).map(|known| known.2);
        let constant = self.constants.iter().find(|known| known.name == name);
        variable.or(constant.map(|known| known.dimension))
    }

    /// The table of a file.
    fn table(&self, file: &File) -> Result<&LookUp, Mistake> {
        let known = self.tables.iter().find(|(name, _)| *name == file.name);
        match known {
            Some((_, Ok(table))) => Ok(table),
            Some((_, Err(message))) => {
                Err(Mistake::new(file.at.clone(), format!("`{}`: {message}", file.name)))
            }
            None => {
                Err(Mistake::new(file.at.clone(), format!("there is no table `{}`", file.name)))
            }
        }
    }

    /// A name that is neither.
    fn unknown(&self, name: &str, at: Range<usize>) -> Mistake {
        let names = |names: Vec<&str>| names.join(", ");
        let variables = names(VARIABLES.iter().map(|known| known.0).collect());
        let constants = names(self.constants.iter().map(|known| &*known.name).collect());
        let constants = if constants.is_empty() { "none".to_owned() } else { constants };
        let message = format!("`{name}` is neither a variable nor a constant of the law");
        let help = format!("variables: {variables}; constants: {constants}");
        Mistake::new(at, message).help(help)
    }
}

impl WearLaw for Expression {
    fn inputs(&self) -> &[Input] {
        &self.inputs
    }

    fn per(&self) -> Per {
        self.per
    }

    fn depth(&self, rubbing: Rubbing) -> f64 {
        self.tape.at(&Columns::of([rubbing], &self.inputs)).0
    }

    fn slope(&self, rubbing: Rubbing) -> f64 {
        self.tape.at(&Columns::of([rubbing], &self.inputs)).1
    }

    fn depths(&self, points: &Columns, depths: &mut [f64], slopes: &mut [f64]) {
        self.tape.over(points, depths, slopes);
    }
}
