//! A search as a user asks for it, and the name of its folder.

use super::{Request, Variants};
use sha2::{Digest, Sha256};
use slipgap_problem::problem::Problem;
use slipgap_study::error::Error;

/// A search: its candidates and its targets.
pub struct Search {
    /// The candidates.
    pub space: Box<dyn Variants>,
    /// The targets.
    pub request: Request,
    /// Name of the folder of its files, different for every request.
    pub folder: String,
}

/// The name in the list that the user gave.
///
/// # Errors
/// The list has no such name.
pub(super) fn choice(
    names: &[&'static str],
    key: &str,
    given: Option<&String>,
) -> Result<Option<&'static str>, Error> {
    let Some(given) = given else {
        return Ok(None);
    };
    let known = names.iter().find(|name| **name == given.as_str());
    match known {
        Some(name) => Ok(Some(name)),
        None => Err(Error::Usage(format!(
            "{key}: unknown {given:?}; allowed: {}",
            names.join(", ")
        ))),
    }
}

/// Whether a number may be a target.
pub fn is_target(x: f64) -> bool {
    x.is_finite() && x > 0.0
}

/// Refuses a target that is no number > 0.
pub(super) fn check_target(key: &str, x: f64) -> Result<(), Error> {
    match is_target(x) {
        true => Ok(()),
        false => Err(Error::Usage(format!(
            "{key}: must be a number > 0, got {x}"
        ))),
    }
}

/// Largest length of the name of a folder before the digest, in bytes. File systems allow 255.
const LONGEST_NAME: usize = 120;

/// The name of the folder of a request. The end of a long name is replaced by a digest.
pub(super) fn folder_name(
    problem: &dyn Problem,
    words: impl IntoIterator<Item = Option<String>>,
) -> String {
    let mut all = vec!["recommend".to_owned(), problem.name().to_owned()];
    all.extend(words.into_iter().flatten());
    let name = all.join("-");
    if name.len() <= LONGEST_NAME {
        return name;
    }
    let digest = Sha256::digest(name.as_bytes());
    let digest: String = digest
        .iter()
        .take(8)
        .map(|byte| format!("{byte:02x}"))
        .collect();
    // All words are ASCII.
    format!("{}-{digest}", &name[..LONGEST_NAME])
}
