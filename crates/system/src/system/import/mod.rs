//! Structures of other programs: matrices in Matrix Market files, and the names of their rows.

mod contact_pairs;
mod dofs;
mod forces;
mod matrix_market;
#[cfg(test)]
mod tests;
mod ties;

pub use contact_pairs::{Pair, pairs};
pub use dofs::{Dof, Dofs};
pub use forces::{ForceKind, MemberForce};
pub use matrix_market::Matrix;
pub use ties::Tie;

use crate::system::structure::Symmetric;
use std::fmt;
use std::sync::Arc;

/// M, K and C of another program, with a name for each row.
#[derive(Debug, Clone)]
pub struct Imported {
    /// M.
    pub mass: Arc<Symmetric>,
    /// K.
    pub stiffness: Arc<Symmetric>,
    /// Whether K has a negative pivot: it pulls something away, which contacts have to hold.
    pub is_negative: bool,
    /// C, if there is one.
    pub damping: Option<Arc<Symmetric>>,
    /// The rows.
    pub dofs: Arc<Dofs>,
}

impl Imported {
    /// Number of rows.
    pub fn len(&self) -> usize {
        self.dofs.len()
    }

    /// Number of rows of M without an entry other than 0.
    pub fn massless_rows(&self) -> usize {
        let rows = self.mass.nonzero_rows().into_iter();
        rows.filter(|has_mass| !has_mass).count()
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// What is wrong with a line of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ImportFault {
    /// Line, from 1.
    pub line: usize,
    /// What is wrong; what is allowed.
    pub message: String,
}

impl fmt::Display for ImportFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.message)
    }
}

impl std::error::Error for ImportFault {}

/// A fault at a line with this index, from 0.
fn fault(index: usize, message: impl Into<String>) -> ImportFault {
    ImportFault {
        line: index + 1,
        message: message.into(),
    }
}

/// The text of a file without its byte order mark.
fn text(bytes: &[u8]) -> Result<&str, ImportFault> {
    let text = std::str::from_utf8(bytes).map_err(|why| {
        let line = bytes[..why.valid_up_to()].iter().filter(|b| **b == b'\n');
        fault(line.count(), "must be text in UTF-8")
    })?;
    Ok(text.trim_start_matches('\u{feff}'))
}

/// The lines of a file.
fn lines(bytes: &[u8]) -> Result<Vec<&str>, ImportFault> {
    Ok(text(bytes)?.lines().collect())
}

/// The cells of a line of a CSV file without quotes.
fn cells(line: &str) -> impl Iterator<Item = &str> {
    line.split(',').map(str::trim)
}

/// Whether a text is letters, digits and _ only.
fn is_plain(text: &str) -> bool {
    text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// A finite number, or why not.
fn number(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(x) if x.is_finite() => Ok(x),
        Ok(_) => Err(format!("must be a finite number, got {}", shown(text))),
        Err(_) => Err(format!("must be a number, got {}", shown(text))),
    }
}

/// A text of a file for a message.
fn shown(text: &str) -> String {
    let short: String = text.chars().take(40).collect();
    match short.len() < text.len() {
        true => format!("{short:?}..."),
        false => format!("{short:?}"),
    }
}
