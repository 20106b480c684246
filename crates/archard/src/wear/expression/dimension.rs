//! What the parts of a formula measure.

use super::Scope;
use super::parser::{File, Function, Mistake, Node, Sign, Term};
use super::tape::Tape;
use crate::units::Dimension;

/// What a part of a formula is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Kind {
    /// True or false.
    Condition,
    /// A zero written without unit, which is one of any dimension.
    Zero,
    /// A value of that dimension.
    Value(Dimension),
}

impl std::fmt::Display for Kind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Condition => f.write_str("a condition"),
            Self::Zero => f.write_str("zero"),
            Self::Value(dimension) => dimension.fmt(f),
        }
    }
}

const NUMBER: Kind = Kind::Value(Dimension::NUMBER);

/// A formula whose value must be a length.
pub(super) fn check(node: &Node, scope: &Scope) -> Result<(), Mistake> {
    match kind(node, scope)? {
        Kind::Zero => Ok(()),
        Kind::Value(found) if found.agrees_with(Dimension::LENGTH) => Ok(()),
        found => {
            let message = format!("a depth is a length, and this gives {found}");
            Err(Mistake::new(node.at.clone(), message))
        }
    }
}

/// What a part is.
fn kind(node: &Node, scope: &Scope) -> Result<Kind, Mistake> {
    match &node.term {
        Term::Number(0.0) => Ok(Kind::Zero),
        Term::Number(_) => Ok(NUMBER),
        Term::Name(name) => match scope.dimension(name) {
            Some(dimension) => Ok(Kind::Value(dimension)),
            None => Err(scope.unknown(name, node.at.clone())),
        },
        Term::Negative(of) => match kind(of, scope)? {
            Kind::Condition => Err(not_a_value(of)),
            kind => Ok(kind),
        },
        Term::Not(of) => condition(of, scope),
        Term::Pair(sign, parts) => pair(node, *sign, parts, scope),
        Term::Call(function, arguments) => call(node, *function, arguments, scope),
        Term::LookUp(file, of) => look_up(file, of, scope),
    }
}

fn pair(node: &Node, sign: Sign, [a, b]: &[Node; 2], scope: &Scope) -> Result<Kind, Mistake> {
    match sign {
        Sign::Or | Sign::And => condition(a, scope).and_then(|_| condition(b, scope)),
        Sign::Plus => alike(node, "cannot add", [a, b], scope),
        Sign::Minus => alike(node, "cannot subtract", [a, b], scope),
        Sign::Less | Sign::LessOrEqual | Sign::Greater | Sign::GreaterOrEqual => {
            alike(node, "cannot compare", [a, b], scope).map(|_| Kind::Condition)
        }
        Sign::Times => Ok(Kind::Value(value(a, scope)?.times(value(b, scope)?))),
        Sign::Over => Ok(Kind::Value(value(a, scope)?.times(value(b, scope)?.to_the(-1.0)))),
        Sign::Power => power(value(a, scope)?, [a, b], scope),
    }
}

/// A value with a dimension can be raised to a constant only.
fn power(base: Dimension, [a, b]: [&Node; 2], scope: &Scope) -> Result<Kind, Mistake> {
    let exponent = value(b, scope)?;
    if !exponent.agrees_with(Dimension::NUMBER) {
        let message = format!("an exponent is a pure number, and this is {exponent}");
        return Err(Mistake::new(b.at.clone(), message));
    }
    if base.agrees_with(Dimension::NUMBER) {
        return Ok(NUMBER);
    }
    match Tape::new(b, scope).constant() {
        Some(exponent) if exponent.is_finite() => Ok(Kind::Value(base.to_the(exponent))),
        _ => {
            let message = format!("this is {base}: only a pure number has an exponent that varies");
            Err(Mistake::new(a.at.clone(), message)
                .help("divide it by a constant of its own dimension first: (p/p0)^n"))
        }
    }
}

fn call(
    node: &Node,
    function: Function,
    arguments: &[Node],
    scope: &Scope,
) -> Result<Kind, Mistake> {
    match (function, arguments) {
        (Function::If, [asked, branches @ ..]) => {
            condition(asked, scope)?;
            alike(node, "cannot choose between", branches, scope)
        }
        (Function::Min | Function::Max, _) => {
            let doing = format!("`{}` cannot compare", function.name());
            alike(node, &doing, arguments, scope)
        }
        (Function::Abs, [of]) => kind(of, scope).and_then(|found| match found {
            Kind::Condition => Err(not_a_value(of)),
            kind => Ok(kind),
        }),
        (Function::Sqrt, [of]) => Ok(Kind::Value(value(of, scope)?.to_the(0.5))),
        (_, arguments) => {
            let angle = matches!(function, Function::Sin | Function::Cos);
            for of in arguments {
                let found = value(of, scope)?;
                let right = found.agrees_with(Dimension::NUMBER)
                    || angle && found.agrees_with(Dimension::ANGLE);
                if !right {
                    let name = function.name();
                    let message = format!("`{name}` takes a pure number, and this is {found}");
                    return Err(Mistake::new(of.at.clone(), message));
                }
            }
            Ok(NUMBER)
        }
    }
}

/// What is looked up in a file, where the place is one of its own.
fn look_up(file: &File, of: &Node, scope: &Scope) -> Result<Kind, Mistake> {
    let table = scope.table(file)?;
    let [places, values] = table.dimensions;
    let found = value(of, scope)?;
    if !found.agrees_with(places) {
        let message = format!("`{}` is over {places}, and this is {found}", file.name);
        return Err(Mistake::new(of.at.clone(), message));
    }
    let temperature = |name: &str| scope.dimension(name) == Some(Dimension::TEMPERATURE);
    let itself = matches!(&of.term, Term::Name(name) if temperature(name));
    if table.absolute && !itself {
        let message = format!(
            "`{}` is over temperatures in degrees Celsius, and this may be a difference",
            file.name
        );
        return Err(Mistake::new(of.at.clone(), message)
            .help("look up `temperature` itself, or write the column in K"));
    }
    Ok(Kind::Value(values))
}

/// What parts are that must be of one dimension.
fn alike<'a>(
    node: &Node,
    doing: &str,
    parts: impl IntoIterator<Item = &'a Node>,
    scope: &Scope,
) -> Result<Kind, Mistake> {
    let mut all = Kind::Zero;
    for part in parts {
        match (all, kind(part, scope)?) {
            (_, Kind::Condition) => return Err(not_a_value(part)),
            (_, Kind::Zero) => {}
            (Kind::Value(one), Kind::Value(other)) if !one.agrees_with(other) => {
                let message = format!("{doing} {one} and {other}");
                return Err(Mistake::new(node.at.clone(), message));
            }
            (_, kind) => all = kind,
        }
    }
    Ok(all)
}

/// The dimension of a value; a zero that is multiplied or raised is a number.
fn value(node: &Node, scope: &Scope) -> Result<Dimension, Mistake> {
    match kind(node, scope)? {
        Kind::Value(dimension) => Ok(dimension),
        Kind::Zero => Ok(Dimension::NUMBER),
        Kind::Condition => Err(not_a_value(node)),
    }
}

fn condition(node: &Node, scope: &Scope) -> Result<Kind, Mistake> {
    match kind(node, scope)? {
        Kind::Condition => Ok(Kind::Condition),
        found => {
            let message =
                format!("a condition like `p > p0` should stand here, and this is {found}");
            Err(Mistake::new(node.at.clone(), message))
        }
    }
}

fn not_a_value(node: &Node) -> Mistake {
    Mistake::new(node.at.clone(), "a value should stand here, and this is a condition")
        .help("`if(condition, one, other)` makes a value of it")
}
