//! The results of a study whose cases shards have computed.

use super::{Observer, OutputOptions, Source, Written, run_study};
use crate::batch::missing_parts;
use crate::batch::output::Folder;
use crate::batch::store::Store;
use slipgap_study::error::Error;

/// Writes what [`run_study`] writes, with the same bytes, if the store has every part of the study. No case is computed, except
/// that the histories in figures are solved again, as after any run from the store. `shards` is the number of shards, if it is
/// known.
///
/// # Errors
/// [`Error::PartsMissing`] before anything is written; and the errors of [`run_study`].
pub fn merge_study(
    source: &Source,
    folder: Folder,
    mut store: Store,
    shards: Option<u64>,
    output: &OutputOptions,
    observer: &mut dyn Observer,
) -> Result<Written, Error> {
    match missing_parts(&source.study, &mut store, shards)? {
        None => run_study(source, folder, store, output, observer),
        Some(missing) => {
            store.leave();
            Err(Error::PartsMissing(source.line(&missing.to_string())))
        }
    }
}
