//! Arithmetic and conditions in strings: `"8*pi"`, `"gamma * n * E * A / L"`, `"-2^2"` (which is -4), `"n > 2 and dt < 0.1"`.
//!
//! A text is parsed once into steps for a stack of numbers. Parameters get their values when the steps are evaluated. The
//! permissively licensed crates either evaluate -2^2 to 4 or do not give the place of a fault.

mod formula;
mod number_length;
mod parser;
mod plain;
#[cfg(test)]
mod tests;
mod tokens;

pub use formula::{ExpressionFault, Formula, UnknownName};
pub use number_length::length_of_number;
pub use plain::{is_plain, printable, quoted, shortened, unprintable};
pub use tokens::{CONSTANTS, FUNCTIONS, Function};
