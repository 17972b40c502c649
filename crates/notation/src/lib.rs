//! How numbers and symbols are written, in tables and along axes. Problems and drawings both use it, and neither the other.
//!
//! A part of slipgap, whose names may change.

mod digits;

pub use digits::{push_shortest, push_whole, shortest};

/// Hash of the code of this crate and of the crates of others that it computes with.
pub const CODE_KEY: &str = env!("SLIPGAP_CODE");

/// How numbers are laid along an axis, of a figure or of a design.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// By their logarithm; only positive numbers.
    Log,
}

/// Plain text in the markup of titles and symbols that shows it unchanged.
pub fn escape(plain: &str) -> String {
    let mut markup = String::new();
    for c in plain.chars() {
        if ['\\', '*', '_', '^'].contains(&c) {
            markup.push('\\');
        }
        markup.push(c);
    }
    markup
}
