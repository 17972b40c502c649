//! Arithmetic and conditions in strings: `"8*pi"`, `"gamma * n * E * A / L"`, `"-2^2"` (which is -4), `"n > 2 and dt < 0.1"`.
//!
//! Text is read once into steps for a stack of numbers; names of parameters get their values when it is evaluated. Own
//! code, because the permissively licensed crates either make -2^2 four or cannot say where a fault is.

mod formula;
mod parser;
#[cfg(test)]
mod tests;
pub(super) mod words;

pub use formula::{ExpressionFault, Formula};
