//! Names of files in a folder of results, and of the program that writes them.

/// The program, as manifests name it.
pub(super) const PROGRAM: &str = "slipgap";

/// Name of the table of results.
pub const RESULTS: &str = "results.csv";

/// Name of the table of cases that could not be solved.
pub const FAILURES: &str = "failures.csv";

/// Name of the table of the indices of saltelli designs.
pub const INDICES: &str = "sobol.csv";

/// Name of the table of reductions.
pub const REDUCTIONS: &str = "reductions.csv";

/// Name of the table of the distributions of metrics over ensembles.
pub const QUANTILES: &str = "quantiles.csv";

/// Name of the table of tests between ensembles.
pub const TWO_SAMPLES: &str = "two_samples.csv";

/// Name of the table of ensembles against tests.
pub const TESTS: &str = "tests.csv";

/// Name of the table of fragility figures.
pub const FRAGILITY: &str = "fragility.csv";

/// Name of the table of the members of their ensembles.
pub const MEMBERS: &str = "fragility_members.csv";

/// Name of the file with the origin of the results.
pub const MANIFEST: &str = "manifest.json";

/// Folder of the histories, each `CASE.csv`.
pub const HISTORIES: &str = "histories";

/// Name of the history of a case.
pub fn history_name(case: u64) -> String {
    format!("{HISTORIES}/{case}.csv")
}
