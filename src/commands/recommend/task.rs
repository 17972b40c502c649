//! A search with the arguments of every search.

use crate::commands::arguments::{Expected, JobsArgs};
use crate::recommend::task::{Search, is_target};
use clap::Args;
use std::path::PathBuf;

#[derive(Args)]
pub struct CommonArgs {
    /// Folder for the table and picture of cost and error; each request has its own folder in it
    #[arg(long, value_name = "DIR", default_value = "figures")]
    pub out: PathBuf,
    #[command(flatten)]
    pub jobs: JobsArgs,
}

/// A search, its folder and its threads.
pub struct SearchTask {
    pub search: Search,
    pub common: CommonArgs,
}

/// Parses a target: a finite number > 0.
pub fn parse_target(text: &str) -> Result<f64, Expected> {
    let number = text.parse::<f64>().ok().filter(|x| is_target(*x));
    number.ok_or(Expected("a number > 0".into()))
}
