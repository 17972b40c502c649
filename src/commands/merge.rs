//! `slipgap merge`: tables, figures and manifest of studies whose cases shards have computed.

use super::sources::Source;
use super::terminal::{Terminal, print, report_error};
use super::{NOT_MET, UNSOLVED};
use slipgap::batch::output::Folder;
use slipgap::batch::store::{STORE, Store};
use slipgap::error::Error;
use slipgap::run::{OutputOptions, merge_study};
use std::fs;
use std::path::{Path, PathBuf};

/// Merges every study into its folder in `out`; returns the exit code, that of a warning only if warnings are denied. `shards` is the number of shards, if it is known. Of a
/// study with missing parts nothing is written; the others are merged.
pub fn merge(
    sources: &[Source],
    out: &Path,
    shards: Option<u64>,
    output: &OutputOptions,
    deny_warnings: bool,
) -> Result<u8, Error> {
    let (mut unsolved, mut warned, mut missing) = (None, None, None);
    for source in sources {
        let path = out.join(&source.name);
        let made = not_there(&path.join(STORE));
        let (folder, store) = (Folder::of_study(&path)?, Store::open(&path)?);
        match merge_study(source, folder, store, shards, output, &mut Terminal) {
            Ok(written) => {
                print(&written.list())?;
                if !written.solved {
                    unsolved = Some(UNSOLVED);
                }
                if deny_warnings && !written.warnings.is_empty() {
                    warned = Some(NOT_MET);
                }
            }
            Err(error @ Error::PartsMissing(_)) => {
                // Folders that are not empty remain.
                made.iter().for_each(|folder| drop(fs::remove_dir(folder)));
                report_error(&error);
                missing = Some(error.exit_code());
            }
            Err(other) => return Err(other),
        }
    }
    Ok(missing.or(unsolved).or(warned).unwrap_or(0))
}

/// The folders that are made to make this one, itself first.
fn not_there(folder: &Path) -> Vec<PathBuf> {
    let folders = folder.ancestors();
    let absent = folders.take_while(|folder| !folder.as_os_str().is_empty() && !folder.exists());
    absent.map(Path::to_owned).collect()
}
