//! A search, and the arguments of every search.

use crate::commands::Jobs;
use clap::Args;
use sha2::{Digest, Sha256};
use slipgap::problem::Problem;
use slipgap::recommend::{Request, Variants};
use std::path::PathBuf;

/// The name in the list that the user gave.
pub fn choice(names: &[&'static str], given: Option<&String>) -> Option<&'static str> {
    let given = given?;
    names.iter().find(|name| **name == given.as_str()).copied()
}

#[derive(Args)]
pub struct CommonArgs {
    /// Folder for the table and picture of cost and error; each request has its own folder in it
    #[arg(long, value_name = "DIR", default_value = "figures")]
    pub out: PathBuf,
    #[command(flatten)]
    pub jobs: Jobs,
}

/// A search: its candidates and its targets.
pub struct SearchTask {
    pub space: Box<dyn Variants>,
    pub request: Request,
    /// Name of the folder, different for every request.
    pub folder: String,
    pub common: CommonArgs,
}

/// Parses a target: a finite number > 0.
pub fn parse_target(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(x) if x.is_finite() && x > 0.0 => Ok(x),
        Ok(_) | Err(_) => Err("must be a number > 0".into()),
    }
}

/// Largest length of the name of a folder before the digest, in bytes. File systems allow 255.
const LONGEST_NAME: usize = 120;

/// The name of the folder of a request. The end of a long name is replaced by a digest.
pub fn folder_name(
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
