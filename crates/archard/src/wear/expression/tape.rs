//! Formulas as a list of operations, each done on a chunk of points before the next one.
//!
//! Every value carries its derivative with respect to the pressure (`dual`). The friction follows the pressure as its
//! limit does, the work by d work / d p = friction s, all that was before stays.

use super::Scope;
use super::dual::{Binary, Dual, Unary, looked_up, one, two};
use super::parser::{Function, Node, Sign, Term};
use crate::numerics::piecewise::Piecewise;
use crate::wear::{Columns, Input};

/// What a point goes through, as formulas may name it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Variable {
    Pressure,
    Slip,
    Work,
    Coefficient,
    /// What does not change with the pressure.
    Given(Input),
}

impl Variable {
    /// Whether it changes with the pressure.
    fn varies(self) -> bool {
        matches!(self, Self::Pressure | Self::Work | Self::Coefficient)
    }

    /// What a law with it asks for.
    pub fn input(self) -> Option<Input> {
        match self {
            Self::Pressure | Self::Slip => None,
            Self::Work | Self::Coefficient => Some(Input::Friction),
            Self::Given(input) => Some(input),
        }
    }
}

/// Operands are places of earlier operations.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Operation {
    Constant(f64),
    Variable(Variable),
    Unary(Unary, usize),
    Binary(Binary, usize, usize),
    /// The value of a table at a place.
    LookUp(usize, usize),
    /// The second where the first is not zero, else the third.
    Select(usize, usize, usize),
}

/// A formula as a list of operations; the last is its value.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tape {
    operations: Vec<Operation>,
    /// Whether each changes with the pressure.
    varies: Vec<bool>,
    tables: Vec<Piecewise>,
    result: usize,
}

/// Points that an operation goes through at once.
const CHUNK: usize = 64;

impl Tape {
    /// The operations of a formula. What does not depend on any variable is computed here, what stands twice is computed
    /// once.
    pub fn new(node: &Node, scope: &Scope) -> Self {
        let mut tape = Self { operations: vec![], varies: vec![], tables: vec![], result: 0 };
        tape.result = tape.lay(node, scope);
        tape
    }

    /// The variables it names.
    pub fn variables(&self) -> impl Iterator<Item = Variable> {
        self.operations.iter().filter_map(|operation| match operation {
            Operation::Variable(variable) => Some(*variable),
            _ => None,
        })
    }

    /// The value of a formula without variables.
    pub fn constant(&self) -> Option<f64> {
        self.constant_at(self.result)
    }

    fn constant_at(&self, place: usize) -> Option<f64> {
        match self.operations[place] {
            Operation::Constant(value) => Some(value),
            _ => None,
        }
    }

    fn lay(&mut self, node: &Node, scope: &Scope) -> usize {
        match &node.term {
            Term::Number(number) => self.push(Operation::Constant(*number)),
            Term::Name(name) => match (scope.variable(name), scope.constant(name)) {
                (Some(variable), _) => self.push(Operation::Variable(variable)),
                (None, value) => self.push(Operation::Constant(value.unwrap_or(f64::NAN))),
            },
            Term::Negative(of) => self.unary(Unary::Negative, of, scope),
            Term::Not(of) => self.unary(Unary::Not, of, scope),
            Term::Pair(sign, parts) => {
                let [a, b] = parts.each_ref().map(|part| self.lay(part, scope));
                match (sign, self.constant_at(b)) {
                    (Sign::Power, Some(exponent)) => {
                        self.push(Operation::Unary(Unary::Power(exponent), a))
                    }
                    _ => self.pair(*sign, a, b),
                }
            }
            Term::Call(function, arguments) => self.call(*function, arguments, scope),
            Term::LookUp(file, of) => {
                let place = self.lay(of, scope);
                // One that is not there was refused before.
                let Ok(table) = scope.table(file) else {
                    return self.push(Operation::Constant(f64::NAN));
                };
                let known = self.tables.iter().position(|known| *known == table.function);
                let table = known.unwrap_or_else(|| {
                    self.tables.push(table.function.clone());
                    self.tables.len() - 1
                });
                self.push(Operation::LookUp(table, place))
            }
        }
    }

    fn unary(&mut self, unary: Unary, of: &Node, scope: &Scope) -> usize {
        let of = self.lay(of, scope);
        self.push(Operation::Unary(unary, of))
    }

    fn pair(&mut self, sign: Sign, a: usize, b: usize) -> usize {
        let (binary, a, b) = match sign {
            Sign::Or => (Binary::Or, a, b),
            Sign::And => (Binary::And, a, b),
            Sign::Less => (Binary::Less, a, b),
            Sign::LessOrEqual => (Binary::LessOrEqual, a, b),
            Sign::Greater => (Binary::Less, b, a),
            Sign::GreaterOrEqual => (Binary::LessOrEqual, b, a),
            Sign::Plus => (Binary::Plus, a, b),
            Sign::Minus => (Binary::Minus, a, b),
            Sign::Times => (Binary::Times, a, b),
            Sign::Over => (Binary::Over, a, b),
            Sign::Power => (Binary::Power, a, b),
        };
        self.push(Operation::Binary(binary, a, b))
    }

    fn call(&mut self, function: Function, arguments: &[Node], scope: &Scope) -> usize {
        let places: Vec<usize> = arguments.iter().map(|part| self.lay(part, scope)).collect();
        let first = places[0];
        let mut all = |binary| {
            let rest = places[1..].iter();
            rest.fold(first, |so_far, &next| self.push(Operation::Binary(binary, so_far, next)))
        };
        let unary = match function {
            Function::Min => return all(Binary::Min),
            Function::Max => return all(Binary::Max),
            Function::If => return self.push(Operation::Select(first, places[1], places[2])),
            Function::Exp => Unary::Exp,
            Function::Ln => Unary::Ln,
            Function::Sqrt => Unary::Sqrt,
            Function::Abs => Unary::Abs,
            Function::Sin => Unary::Sin,
            Function::Cos => Unary::Cos,
            Function::Tanh => Unary::Tanh,
        };
        self.push(Operation::Unary(unary, first))
    }

    /// The place of an operation: where it already stands, or a new one at the end.
    fn push(&mut self, operation: Operation) -> usize {
        let operation = self.folded(operation);
        if let Some(place) = self.operations.iter().position(|known| *known == operation) {
            return place;
        }
        self.varies.push(match operation {
            Operation::Constant(_) => false,
            Operation::Variable(variable) => variable.varies(),
            Operation::Unary(_, a) | Operation::LookUp(_, a) => self.varies[a],
            Operation::Binary(_, a, b) => self.varies[a] || self.varies[b],
            Operation::Select(_, a, b) => self.varies[a] || self.varies[b],
        });
        self.operations.push(operation);
        self.operations.len() - 1
    }

    /// An operation on constants as its value.
    fn folded(&self, operation: Operation) -> Operation {
        let dual = |place| self.constant_at(place).map(|value| Dual { value, slope: 0.0 });
        let value = match operation {
            Operation::Unary(unary, a) => dual(a).map(|a| one(unary, a)),
            Operation::Binary(binary, a, b) => dual(a).zip(dual(b)).map(|(a, b)| two(binary, a, b)),
            Operation::LookUp(table, a) => dual(a).map(|a| looked_up(&self.tables[table], a)),
            Operation::Select(condition, a, b) => {
                dual(condition).and_then(|c| dual(if c.value != 0.0 { a } else { b }))
            }
            _ => None,
        };
        value.map_or(operation, |dual| Operation::Constant(dual.value))
    }

    /// Value and slope at a point.
    pub fn at(&self, inputs: &Columns) -> (f64, f64) {
        let (mut value, mut slope) = ([0.0], [0.0]);
        self.run::<1>(inputs, &mut value, &mut slope);
        (value[0], slope[0])
    }

    /// Values and slopes at many points, one value each.
    pub fn over(&self, inputs: &Columns, values: &mut [f64], slopes: &mut [f64]) {
        self.run::<CHUNK>(inputs, values, slopes);
    }

    fn run<const N: usize>(&self, inputs: &Columns, values: &mut [f64], slopes: &mut [f64]) {
        let mut lanes = vec![Lane::<N> { value: [0.0; N], slope: [0.0; N] }; self.operations.len()];
        for (lane, operation) in lanes.iter_mut().zip(&self.operations) {
            if let Operation::Constant(value) = operation {
                lane.value.fill(*value);
            }
        }
        let chunks = values.chunks_mut(N).zip(slopes.chunks_mut(N));
        for (chunk, (values, slopes)) in chunks.enumerate() {
            let (first, count) = (chunk * N, values.len());
            for place in 0..self.operations.len() {
                let (before, rest) = lanes.split_at_mut(place);
                rest[0].set(
                    &self.tables,
                    self.operations[place],
                    self.varies[place],
                    before,
                    inputs,
                    (first, count),
                );
            }
            let result = &lanes[self.result];
            values.copy_from_slice(&result.value[..count]);
            slopes.copy_from_slice(&result.slope[..count]);
        }
    }
}

/// Values of one operation at a chunk of points; slopes of what does not change with the pressure stay zero.
#[derive(Debug, Clone)]
struct Lane<const N: usize> {
    value: [f64; N],
    slope: [f64; N],
}

impl<const N: usize> Lane<N> {
    /// Does an operation on `count` points from `first` on.
    #[inline]
    fn set(
        &mut self,
        tables: &[Piecewise],
        operation: Operation,
        varies: bool,
        before: &[Self],
        inputs: &Columns,
        (first, count): (usize, usize),
    ) {
        match operation {
            Operation::Constant(_) => {}
            Operation::Variable(variable) => self.load(variable, inputs, first, count),
            Operation::Unary(unary, a) => {
                let a = &before[a];
                // The operation is known inside each loop.
                macro_rules! each {
                    ($($known:pat => $unary:expr),*) => {
                        match unary {
                            $($known => for i in 0..count.min(N) {
                                let dual = one($unary, a.at(i));
                                self.value[i] = dual.value;
                                if varies {
                                    self.slope[i] = dual.slope;
                                }
                            }),*
                        }
                    };
                }
                each!(
                    Unary::Negative => Unary::Negative, Unary::Not => Unary::Not,
                    Unary::Exp => Unary::Exp, Unary::Ln => Unary::Ln, Unary::Sqrt => Unary::Sqrt,
                    Unary::Abs => Unary::Abs, Unary::Sin => Unary::Sin, Unary::Cos => Unary::Cos,
                    Unary::Tanh => Unary::Tanh, Unary::Power(n) => Unary::Power(n)
                );
            }
            Operation::Binary(binary, a, b) => {
                let (a, b) = (&before[a], &before[b]);
                macro_rules! each {
                    ($($known:ident),*) => {
                        match binary {
                            $(Binary::$known => for i in 0..count.min(N) {
                                let dual = two(Binary::$known, a.at(i), b.at(i));
                                self.value[i] = dual.value;
                                if varies {
                                    self.slope[i] = dual.slope;
                                }
                            }),*
                        }
                    };
                }
                each!(Plus, Minus, Times, Over, Power, Min, Max, Less, LessOrEqual, And, Or);
            }
            Operation::LookUp(table, a) => {
                for i in 0..count.min(N) {
                    let dual = looked_up(&tables[table], before[a].at(i));
                    (self.value[i], self.slope[i]) = (dual.value, dual.slope);
                }
            }
            Operation::Select(condition, a, b) => {
                let (condition, a, b) = (&before[condition], &before[a], &before[b]);
                for i in 0..count.min(N) {
                    let dual = if condition.value[i] != 0.0 { a.at(i) } else { b.at(i) };
                    (self.value[i], self.slope[i]) = (dual.value, dual.slope);
                }
            }
        }
    }

    #[inline]
    fn at(&self, i: usize) -> Dual {
        Dual { value: self.value[i], slope: self.slope[i] }
    }

    /// A variable at `count` points from `first` on.
    fn load(&mut self, variable: Variable, inputs: &Columns, first: usize, count: usize) {
        let part = |column: &[f64]| -> [f64; N] {
            let mut part = [0.0; N];
            part[..count].copy_from_slice(&column[first..first + count]);
            part
        };
        match variable {
            Variable::Pressure => {
                self.value = part(&inputs.pressure);
                self.slope = [1.0; N];
            }
            Variable::Work => {
                self.value = part(&inputs.work);
                let (friction, slip) = (part(&inputs.friction), part(&inputs.slip));
                self.slope = std::array::from_fn(|i| friction[i] * slip[i]);
            }
            Variable::Coefficient => {
                let (pressure, slip) = (part(&inputs.pressure), part(&inputs.slip));
                let (work, friction) = (part(&inputs.work), part(&inputs.friction));
                for i in 0..count {
                    let rubbed = pressure[i] * slip[i];
                    (self.value[i], self.slope[i]) = if rubbed > 0.0 {
                        let coefficient = work[i] / rubbed;
                        (coefficient, (friction[i] - coefficient) / pressure[i])
                    } else {
                        (friction[i], 0.0)
                    };
                }
            }
            Variable::Slip => self.value = part(&inputs.slip),
            Variable::Given(input) => self.value = part(inputs.numbers(input)),
        }
    }
}
