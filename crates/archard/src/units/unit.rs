//! Products of symbols: "mm^3/(N m)".

use std::iter::Peekable;
use std::str::Chars;

use super::dimension::Dimension;
use super::symbol;

/// A unit: its dimension, its size in SI as a power of ten times a factor, and where it begins to count.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Unit {
    /// What it measures.
    pub dimension: Dimension,
    /// The power of ten.
    pub tens: f64,
    /// The rest, one for decimal units.
    pub factor: f64,
    /// The value in SI of its zero: of degrees Celsius by themselves, which count from the melting point of ice. In a product
    /// they measure differences, which count from zero.
    pub zero: f64,
}

impl Unit {
    /// The unit of pure numbers.
    const ONE: Self = Self { dimension: Dimension::NUMBER, tens: 0.0, factor: 1.0, zero: 0.0 };

    fn times(self, other: Self) -> Self {
        // A one next to a unit makes no product of it.
        if other == Self::ONE {
            return self;
        }
        if self == Self::ONE {
            return other;
        }
        Self {
            dimension: self.dimension.times(other.dimension),
            tens: self.tens + other.tens,
            factor: self.factor * other.factor,
            zero: 0.0,
        }
    }

    fn to_the(self, power: f64) -> Self {
        Self {
            dimension: self.dimension.to_the(power),
            tens: self.tens * power,
            factor: self.factor.powf(power),
            zero: if power == 1.0 { self.zero } else { 0.0 },
        }
    }
}

/// Why a text is not a unit.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Error {
    /// This symbol is unknown.
    Unknown(String),
    /// The notation is wrong.
    Malformed(&'static str),
}

/// Reads a unit.
pub(super) fn parse(text: &str) -> Result<Unit, Error> {
    let mut rest = text.chars().peekable();
    let unit = product(&mut rest, 0)?;
    match rest.next() {
        None => Ok(unit),
        Some(_) => Err(Error::Malformed("a parenthesis is closed that was not opened")),
    }
}

/// Parentheses within parentheses that are still read; no unit needs more.
const DEEPEST: usize = 8;

/// A product up to the end or a closing parenthesis. A leading `/` divides one.
fn product(rest: &mut Peekable<Chars>, depth: usize) -> Result<Unit, Error> {
    skip_spaces(rest);
    let mut unit = if rest.peek() == Some(&'/') { Unit::ONE } else { factor(rest, depth)? };
    loop {
        skip_spaces(rest);
        let power = match rest.peek() {
            None | Some(')') => return Ok(unit),
            Some('/') => -1.0,
            _ => 1.0,
        };
        if matches!(rest.peek(), Some('/' | '*' | '·' | '⋅' | '×')) {
            rest.next();
            skip_spaces(rest);
        }
        unit = unit.times(factor(rest, depth)?.to_the(power));
    }
}

/// A symbol, a one or a parenthesis, with its power.
fn factor(rest: &mut Peekable<Chars>, depth: usize) -> Result<Unit, Error> {
    let unit = match rest.peek() {
        Some('1') => {
            rest.next();
            Unit::ONE
        }
        Some('(') if depth < DEEPEST => {
            rest.next();
            let unit = product(rest, depth + 1)?;
            match rest.next() {
                Some(')') => unit,
                _ => return Err(Error::Malformed("a parenthesis is not closed")),
            }
        }
        Some(&c) if is_letter(c) => {
            let name = take_while(rest, is_letter);
            symbol::find(&name).ok_or(Error::Unknown(name))?
        }
        None => return Err(Error::Malformed("it ends where a unit should follow")),
        Some(_) => return Err(Error::Malformed("a symbol like mm or Pa should stand here")),
    };
    Ok(unit.to_the(power(rest)?))
}

/// The power behind a factor, one where none exists.
fn power(rest: &mut Peekable<Chars>) -> Result<f64, Error> {
    const MISSING: Error = Error::Malformed("`^` needs a number behind it");
    let raised = take_while(rest, |c| superscript(c).is_some());
    if !raised.is_empty() {
        let plain: String = raised.chars().filter_map(superscript).collect();
        return plain.parse().map_err(|_| Error::Malformed("a power is not a number"));
    }
    let caret = rest.next_if_eq(&'^').is_some();
    let open = caret && rest.next_if_eq(&'(').is_some();
    let digits = take_while(rest, |c| c.is_ascii_digit() || matches!(c, '-' | '\u{2212}' | '.'));
    if open && rest.next() != Some(')') {
        return Err(Error::Malformed("a parenthesis is not closed"));
    }
    match digits.replace('\u{2212}', "-") {
        digits if digits.is_empty() && !caret => Ok(1.0),
        digits => digits.parse().map_err(|_| MISSING),
    }
}

/// The plain character of a raised one.
fn superscript(c: char) -> Option<char> {
    const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻";
    RAISED.chars().position(|raised| raised == c).and_then(|i| "0123456789-".chars().nth(i))
}

fn is_letter(c: char) -> bool {
    c.is_alphabetic() || matches!(c, '°' | '%' | '\u{b5}')
}

fn skip_spaces(rest: &mut Peekable<Chars>) {
    while rest.next_if(|c| c.is_whitespace()).is_some() {}
}

fn take_while(rest: &mut Peekable<Chars>, keep: impl Fn(char) -> bool) -> String {
    let mut taken = String::new();
    while let Some(c) = rest.next_if(|&c| keep(c)) {
        taken.push(c);
    }
    taken
}
