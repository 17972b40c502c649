//! The operators, constants and functions of expressions.

use crate::problem::numbers::parameter::Value;

/// A function by its number of arguments.
#[derive(Clone, Copy)]
pub enum Function {
    /// Of one number.
    One(fn(f64) -> f64),
    /// Of two numbers.
    Two(fn(f64, f64) -> f64),
}

/// The constants.
pub const CONSTANTS: [&str; 2] = ["pi", "e"];

/// The functions by name.
pub const FUNCTIONS: [(&str, Function); 13] = [
    ("sqrt", Function::One(f64::sqrt)),
    ("sin", Function::One(libm::sin)),
    ("cos", Function::One(libm::cos)),
    ("tan", Function::One(libm::tan)),
    ("exp", Function::One(libm::exp)),
    ("ln", Function::One(libm::log)),
    ("log10", Function::One(libm::log10)),
    ("abs", Function::One(f64::abs)),
    ("round", Function::One(f64::round)),
    ("floor", Function::One(f64::floor)),
    ("ceil", Function::One(f64::ceil)),
    ("min", Function::Two(f64::min)),
    ("max", Function::Two(f64::max)),
];

/// An operator between two operands.
pub(super) struct Operator {
    pub token: &'static str,
    /// Binding power on the left.
    pub binds: u8,
    /// Binding power on the right: for a power one less, because 2^3^2 is 2^9.
    pub right: u8,
    pub function: fn(f64, f64) -> f64,
}

/// Binding power of comparisons.
const COMPARISON: u8 = 4;

impl Operator {
    /// Whether it compares numbers.
    pub fn compares(&self) -> bool {
        self.binds == COMPARISON
    }

    /// Whether it joins conditions.
    pub fn joins(&self) -> bool {
        self.binds < COMPARISON
    }
}

const fn operator_of(
    token: &'static str,
    binds: u8,
    right: u8,
    function: fn(f64, f64) -> f64,
) -> Operator {
    Operator {
        token,
        binds,
        right,
        function,
    }
}

fn truth(value: bool) -> f64 {
    f64::from(u8::from(value))
}

pub(super) fn not(x: f64) -> f64 {
    1.0 - x
}

/// Longer tokens come before those with which they begin.
static OPERATORS: [Operator; 16] = [
    operator_of("or", 1, 1, f64::max),
    operator_of("||", 1, 1, f64::max),
    operator_of("and", 2, 2, f64::min),
    operator_of("&&", 2, 2, f64::min),
    operator_of("<=", COMPARISON, COMPARISON, |a, b| truth(a <= b)),
    operator_of(">=", COMPARISON, COMPARISON, |a, b| truth(a >= b)),
    operator_of("==", COMPARISON, COMPARISON, |a, b| truth(same(a, b))),
    operator_of("!=", COMPARISON, COMPARISON, |a, b| truth(!same(a, b))),
    operator_of("<", COMPARISON, COMPARISON, |a, b| truth(a < b)),
    operator_of(">", COMPARISON, COMPARISON, |a, b| truth(a > b)),
    operator_of("+", 11, 11, |a, b| a + b),
    operator_of("-", 11, 11, |a, b| a - b),
    operator_of("**", 14, 13, libm::pow),
    operator_of("*", 12, 12, |a, b| a * b),
    operator_of("/", 12, 12, |a, b| a / b),
    operator_of("^", 14, 13, libm::pow),
];

/// Whether two numbers are equal, as in a `where`.
fn same(a: f64, b: f64) -> bool {
    Value::Number(a).matches(Value::Number(b))
}

/// The operator that `rest` begins with.
pub(super) fn operator(rest: &str) -> Option<&'static Operator> {
    OPERATORS.iter().find(|operator| {
        let word = operator.token.starts_with(char::is_alphabetic);
        rest.strip_prefix(operator.token).is_some_and(|after| {
            !(word && after.starts_with(|c: char| c.is_alphanumeric() || c == '_'))
        })
    })
}
