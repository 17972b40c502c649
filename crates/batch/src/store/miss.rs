//! Why a store does not have a part.

use super::key::Difference;
use slipgap_study::error::Error;
use std::fmt;
use std::io;
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
    /// A server does not give a part that it lists, and why: whether it is damaged is not known.
    Unread(PathBuf, String),
}

impl Miss {
    /// Whether the server has answered: who computes all parts again because of a bad network would never end.
    ///
    /// # Errors
    /// A part that the server does not give.
    pub fn answered(&self) -> Result<(), Error> {
        match self {
            Miss::Unread(path, why) => Err(Error::io("cannot read", path)(io::Error::other(
                why.clone(),
            ))),
            Miss::Absent | Miss::Outdated(_) | Miss::Damaged(_) => Ok(()),
        }
    }
}

impl fmt::Display for Miss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Miss::Absent => f.write_str("not in the store yet"),
            Miss::Outdated(difference) => write!(f, "{difference}"),
            Miss::Damaged(path) => write!(f, "{} is damaged", path.display()),
            Miss::Unread(path, why) => write!(f, "{}: {why}", path.display()),
        }
    }
}
