//! The tables over groups of cases: Sobol' indices, quantiles, two-sample tests, ensembles against tests; and what they leave out.

use super::{Observer, Source};
use crate::batch::groups::sobol::DesignMetrics;
use crate::batch::output::ensemble::EnsembleMetrics;
use crate::batch::output::{Folder, QUANTILES, TESTS, TWO_SAMPLES, sobol};
use slipgap_study::error::Error;
use std::path::PathBuf;

/// The note on a reduction of cases of which some have no value.
pub fn without_value(source: &Source, name: &str, empty: u64, cases: u64) -> String {
    source.line(&format!(
        "\"{name}\" leaves out {empty} of {cases} cases, which have no value"
    ))
}

/// The table of Sobol' indices, if a block has a saltelli design.
///
/// # Errors
/// A table that cannot be made.
pub fn indices(
    source: &Source,
    designs: &DesignMetrics,
    observer: &mut dyn Observer,
) -> Result<Option<Vec<u8>>, Error> {
    let estimates = designs.estimates();
    if estimates == 0 {
        return Ok(None);
    }
    let bar = observer.begin_indices(source, estimates);
    let table = sobol::table(designs, &source.study, || bar.inc(1));
    bar.finish_and_clear();
    let Some(table) = table? else {
        return Ok(None);
    };
    for metric in &table.undefined {
        observer.note(&source.line(&format!("no Sobol' indices: {metric}")));
    }
    Ok(Some(table.bytes))
}

/// Writes the tables of a study with an ensemble, and reports metrics that are empty in some cases.
pub(super) fn write(
    source: &Source,
    ensembles: &EnsembleMetrics,
    folder: &mut Folder,
    paths: &mut Vec<PathBuf>,
    observer: &mut dyn Observer,
) -> Result<(), Error> {
    paths.push(folder.write_with(QUANTILES, |out| ensembles.write_quantiles(out))?);
    if ensembles.has_pairs() {
        paths.push(folder.write_with(TWO_SAMPLES, |out| ensembles.write_two_samples(out))?);
    }
    if ensembles.has_tests() {
        paths.push(folder.write_with(TESTS, |out| ensembles.write_tests(out))?);
    }
    let empty: Vec<String> = ensembles
        .empty()
        .map(|(metric, count)| format!("{metric} in {count}"))
        .collect();
    if !empty.is_empty() {
        let (empty, cases) = (empty.join(", "), ensembles.cases());
        observer.note(&source.line(&format!(
            "{QUANTILES} leaves out empty values: {empty} of {cases} cases"
        )));
    }
    Ok(())
}
