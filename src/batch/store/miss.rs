//! Why a store does not have a part.

use super::key::Difference;
use std::fmt;
use std::path::PathBuf;

/// Why the store does not have a part.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Miss {
    /// No part has its start.
    Absent,
    /// A part has other results.
    Outdated(Difference),
    /// A part is damaged.
    Damaged(PathBuf),
}

impl fmt::Display for Miss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Miss::Absent => f.write_str("not in the store yet"),
            Miss::Outdated(difference) => write!(f, "{difference}"),
            Miss::Damaged(path) => write!(f, "{} is damaged", path.display()),
        }
    }
}
