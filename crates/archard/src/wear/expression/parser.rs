//! Formulas as text: `k*max(p - p0, 0)*s`, read into a tree whose nodes know where they stand.
//!
//! Operators from the loosest to the tightest: `or`, `and`, `not`, comparisons, `+ -`, `* /`, the sign, `^`. All but `^`
//! go from left to right. The parser is that of V. R. Pratt, *Top down operator precedence*, POPL 1973.

use std::ops::Range;

/// What is wrong with a formula, and where.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Mistake {
    /// The bytes of the formula it is about.
    pub at: Range<usize>,
    /// What is wrong.
    pub message: String,
    /// What to do about it.
    pub help: Option<String>,
}

impl Mistake {
    pub fn new(at: Range<usize>, message: impl Into<String>) -> Self {
        Self { at, message: message.into(), help: None }
    }

    pub fn help(self, help: impl Into<String>) -> Self {
        Self { help: Some(help.into()), ..self }
    }
}

/// A part of a formula.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Node {
    /// The bytes of the formula it takes up.
    pub at: Range<usize>,
    pub term: Term,
}

impl Node {
    /// Whether the formula has that name in it.
    pub fn names(&self, name: &str) -> bool {
        match &self.term {
            Term::Number(_) => false,
            Term::Name(known) => known == name,
            Term::Negative(of) | Term::Not(of) => of.names(name),
            Term::Pair(_, parts) => parts.iter().any(|part| part.names(name)),
            Term::Call(_, arguments) => arguments.iter().any(|part| part.names(name)),
            Term::LookUp(_, of) => of.names(name),
        }
    }
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Term {
    Number(f64),
    /// A variable or a constant.
    Name(String),
    Negative(Box<Node>),
    Not(Box<Node>),
    Pair(Sign, Box<[Node; 2]>),
    Call(Function, Vec<Node>),
    /// A value looked up in a file at that place.
    LookUp(File, Box<Node>),
}

/// The name of a file in quotes, and where it stands with them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct File {
    pub name: String,
    pub at: Range<usize>,
}

/// An operator between two parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sign {
    Or,
    And,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    Plus,
    Minus,
    Times,
    Over,
    Power,
}

impl Sign {
    /// How it is written.
    pub const ALL: &[(&str, Self)] = &[
        ("or", Self::Or),
        ("and", Self::And),
        ("<=", Self::LessOrEqual),
        ("<", Self::Less),
        (">=", Self::GreaterOrEqual),
        (">", Self::Greater),
        ("+", Self::Plus),
        ("-", Self::Minus),
        ("*", Self::Times),
        ("/", Self::Over),
        ("^", Self::Power),
    ];

    /// How tightly it binds.
    fn strength(self) -> u8 {
        match self {
            Self::Or => 1,
            Self::And => 2,
            Self::Less | Self::LessOrEqual | Self::Greater | Self::GreaterOrEqual => COMPARISON,
            Self::Plus | Self::Minus => 5,
            Self::Times | Self::Over => SIGN - 1,
            Self::Power => SIGN + 1,
        }
    }
}

/// How tightly comparisons bind, `not` just less.
const COMPARISON: u8 = 4;
/// How tightly a leading sign binds: less than a power, -x^2 = -(x^2).
const SIGN: u8 = 7;

/// A function.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Function {
    Min,
    Max,
    Exp,
    Ln,
    Sqrt,
    Abs,
    Sin,
    Cos,
    Tanh,
    If,
}

impl Function {
    /// How it is called.
    pub const ALL: &[(&str, Self)] = &[
        ("min", Self::Min),
        ("max", Self::Max),
        ("exp", Self::Exp),
        ("ln", Self::Ln),
        ("sqrt", Self::Sqrt),
        ("abs", Self::Abs),
        ("sin", Self::Sin),
        ("cos", Self::Cos),
        ("tanh", Self::Tanh),
        ("if", Self::If),
    ];

    /// The name of it.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, function)| *function == self).map_or("", |(name, _)| name)
    }

    /// What is wrong with that number of arguments.
    fn refuses(self, found: usize) -> Option<String> {
        let (taken, expected) = match self {
            Self::Min | Self::Max => (found >= 2, "two values or more"),
            Self::If => (found == 3, "a condition and two values"),
            _ => (found == 1, "one value"),
        };
        (!taken).then(|| format!("`{}` takes {expected}, found {found}", self.name()))
    }
}

/// The function that looks values up in a file.
const TABLE: &str = "table";
const TABLE_HELP: &str = "write `table(\'k.csv\', p)`: the file in quotes, and what to look up";

/// Whether a name means something in every formula, variables apart.
pub(super) fn is_reserved(name: &str) -> bool {
    matches!(name, "and" | "or" | "not" | TABLE)
        || Function::ALL.iter().any(|(known, _)| *known == name)
}

/// Bytes of the longest formula, and parts within parts that are still read.
const LONGEST: usize = 2000;
const DEEPEST: usize = 64;

/// Reads a formula.
pub(super) fn parse(text: &str) -> Result<Node, Mistake> {
    if text.len() > LONGEST {
        let message = format!("is longer than {LONGEST} characters");
        return Err(Mistake::new(0..text.len(), message));
    }
    let mut parser = Parser { text, tokens: tokens(text)?, next: 0, depth: 0 };
    let node = parser.part(0)?;
    match parser.peek() {
        None => Ok(node),
        Some((at, Token::Close)) => {
            Err(Mistake::new(at, "a parenthesis is closed that was not opened"))
        }
        Some((at, _)) => Err(Mistake::new(at, "an operator like + or * should stand before this")),
    }
}

#[derive(Debug, Clone, PartialEq)]
enum Token {
    Number(f64),
    Name(String),
    File(String),
    Sign(Sign),
    Open,
    Close,
    Comma,
}

/// The words and signs of a formula.
fn tokens(text: &str) -> Result<Vec<(Range<usize>, Token)>, Mistake> {
    let mut tokens = vec![];
    let mut start = 0;
    while let Some(first) = text[start..].chars().next() {
        let rest = &text[start..];
        let length = |of: fn(char) -> bool| rest.find(|c| !of(c)).unwrap_or(rest.len());
        let (length, token) = match first {
            c if c.is_whitespace() => {
                start += c.len_utf8();
                continue;
            }
            '(' => (1, Token::Open),
            ')' => (1, Token::Close),
            ',' => (1, Token::Comma),
            quote @ ('"' | '\'') => {
                let Some(length) = rest[1..].find(quote) else {
                    let message = "this name of a file is not closed";
                    return Err(Mistake::new(start..text.len(), message));
                };
                (length + 2, Token::File(rest[1..=length].to_owned()))
            }
            '0'..='9' | '.' => {
                let length = number_length(rest);
                let at = start..start + length;
                let value = rest[..length].parse().ok().filter(|value: &f64| value.is_finite());
                let wrong = || format!("`{}` is not a finite number", &rest[..length]);
                (length, Token::Number(value.ok_or_else(|| Mistake::new(at, wrong()))?))
            }
            c if is_letter(c) => {
                let length = length(|c| is_letter(c) || c.is_ascii_digit());
                let name = &rest[..length];
                let sign = Sign::ALL.iter().find(|(known, _)| *known == name);
                let word =
                    sign.map_or(Token::Name(name.to_owned()), |(_, sign)| Token::Sign(*sign));
                (length, word)
            }
            c => {
                let known = Sign::ALL.iter().find(|(known, _)| rest.starts_with(known));
                let at = start..start + c.len_utf8();
                let (known, sign) =
                    known.ok_or_else(|| Mistake::new(at, format!("`{c}` has no meaning here")))?;
                (known.len(), Token::Sign(*sign))
            }
        };
        tokens.push((start..start + length, token));
        start += length;
    }
    Ok(tokens)
}

fn is_letter(c: char) -> bool {
    c.is_ascii_alphabetic() || c == '_'
}

/// Bytes of the number a text begins with; one at least.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |from: usize| bytes[from..].iter().take_while(|b| b.is_ascii_digit()).count();
    let mut end = digits(0);
    if bytes.get(end) == Some(&b'.') {
        end += 1 + digits(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let from = end + 1 + sign;
        let exponent = if from < bytes.len() { digits(from) } else { 0 };
        if exponent > 0 {
            end = from + exponent;
        }
    }
    end
}

struct Parser<'a> {
    text: &'a str,
    tokens: Vec<(Range<usize>, Token)>,
    next: usize,
    depth: usize,
}

impl Parser<'_> {
    fn peek(&self) -> Option<(Range<usize>, &Token)> {
        self.tokens.get(self.next).map(|(at, token)| (at.clone(), token))
    }

    fn take(&mut self) -> Option<(Range<usize>, Token)> {
        let token = self.tokens.get(self.next).cloned();
        self.next += 1;
        token
    }

    /// Takes that token, if it is next.
    fn take_if(&mut self, token: &Token) -> Option<Range<usize>> {
        let at = self.peek().filter(|(_, next)| *next == token).map(|(at, _)| at)?;
        self.next += 1;
        Some(at)
    }

    /// A part whose operators bind more tightly than that.
    fn part(&mut self, strength: u8) -> Result<Node, Mistake> {
        self.depth += 1;
        if self.depth > DEEPEST {
            let at = self.peek().map_or(0..self.text.len(), |(at, _)| at);
            return Err(Mistake::new(at, format!("parts stand in parts more than {DEEPEST} deep")));
        }
        let mut left = self.operand()?;
        while let Some((_, &Token::Sign(sign))) = self.peek()
            && sign.strength() > strength
        {
            self.next += 1;
            // What stands right of a power belongs to its exponent.
            let right = sign.strength() - u8::from(sign == Sign::Power);
            let right = self.part(right)?;
            let at = left.at.start..right.at.end;
            left = Node { at, term: Term::Pair(sign, Box::new([left, right])) };
        }
        self.depth -= 1;
        Ok(left)
    }

    /// A number, a name, a function with its arguments, a parenthesis, or any of them with a sign.
    fn operand(&mut self) -> Result<Node, Mistake> {
        let end = self.text.len()..self.text.len();
        let expected = "a number, a name or a parenthesis should stand here";
        let Some((at, token)) = self.take() else { return Err(Mistake::new(end, expected)) };
        match token {
            Token::Number(number) => Ok(Node { at, term: Term::Number(number) }),
            Token::Sign(Sign::Minus) => {
                let of = self.part(SIGN)?;
                Ok(Node { at: at.start..of.at.end, term: Term::Negative(Box::new(of)) })
            }
            Token::Sign(Sign::Plus) => self.part(SIGN),
            Token::Name(name) if name == "not" => {
                let of = self.part(COMPARISON - 1)?;
                Ok(Node { at: at.start..of.at.end, term: Term::Not(Box::new(of)) })
            }
            Token::Name(name) => self.named(name, at),
            Token::Open => {
                let inside = self.part(0)?;
                let close = self.close(&at)?;
                Ok(Node { at: at.start..close.end, ..inside })
            }
            Token::File(_) => {
                let message = "the name of a file stands in `table` only";
                Err(Mistake::new(at, message).help(TABLE_HELP))
            }
            Token::Sign(_) | Token::Close | Token::Comma => Err(Mistake::new(at, expected)),
        }
    }

    /// A name, or a call of the function of that name.
    fn named(&mut self, name: String, at: Range<usize>) -> Result<Node, Mistake> {
        if name == TABLE {
            return self.look_up(at);
        }
        let function = Function::ALL.iter().find(|(known, _)| *known == name);
        let open = self.take_if(&Token::Open);
        match (function, open) {
            (None, None) => Ok(Node { at, term: Term::Name(name) }),
            (Some(_), None) => {
                let message = format!("`{name}` is a function: its values follow in parentheses");
                Err(Mistake::new(at, message))
            }
            (None, Some(_)) => {
                let functions = Function::ALL.iter().map(|(name, _)| *name);
                let names: Vec<&str> = functions.chain([TABLE]).collect();
                Err(Mistake::new(at, format!("`{name}` is not a known function"))
                    .help(format!("known here: {}", names.join(", "))))
            }
            (Some(&(_, function)), Some(open)) => {
                let mut arguments = vec![self.part(0)?];
                while self.take_if(&Token::Comma).is_some() {
                    arguments.push(self.part(0)?);
                }
                let at = at.start..self.close(&open)?.end;
                match function.refuses(arguments.len()) {
                    None => Ok(Node { at, term: Term::Call(function, arguments) }),
                    Some(message) => Err(Mistake::new(at, message)),
                }
            }
        }
    }

    /// `table`, the name of a file and what to look up there.
    fn look_up(&mut self, at: Range<usize>) -> Result<Node, Mistake> {
        let wrong = |at| Err(Mistake::new(at, "`table` takes a file and a value").help(TABLE_HELP));
        let Some(open) = self.take_if(&Token::Open) else { return wrong(at) };
        let Some((name_at, Token::File(name))) = self.take() else { return wrong(at) };
        if self.take_if(&Token::Comma).is_none() {
            return wrong(at);
        }
        let of = self.part(0)?;
        let at = at.start..self.close(&open)?.end;
        Ok(Node { at, term: Term::LookUp(File { name, at: name_at }, Box::new(of)) })
    }

    /// The end of what was opened there.
    fn close(&mut self, open: &Range<usize>) -> Result<Range<usize>, Mistake> {
        match self.peek() {
            Some((at, Token::Close)) => {
                self.next += 1;
                Ok(at)
            }
            Some((at, Token::Number(_) | Token::Name(_) | Token::File(_) | Token::Open)) => {
                Err(Mistake::new(at, "an operator like + or * should stand before this"))
            }
            _ => Err(Mistake::new(open.clone(), "this parenthesis is not closed")),
        }
    }
}
