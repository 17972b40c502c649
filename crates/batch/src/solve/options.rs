//! How the cases of a study are run.

use super::work_progress::WorkProgress;
use crate::store::Store;
use slipgap_problem::problem::{Case, Solution};
use slipgap_study::error::Error;

/// Called with the number and the solution of each computed case.
pub type OnSolution<'a> = dyn Fn(u64, &Solution) -> Result<(), Error> + Sync + 'a;

/// How the cases of a study are run.
pub struct RunOptions<'a> {
    /// The store from which results are read and to which they are written, if any.
    pub store: Option<&'a Store>,
    /// Whether every case is computed, also those in the store.
    pub recompute: bool,
    /// Selects the computed cases whose histories are kept, if some may be.
    pub keep_history: Option<&'a (dyn Fn(&Case) -> bool + Sync)>,
    /// Called with every computed solution, if any.
    pub on_solution: Option<&'a OnSolution<'a>>,
    /// Counts the work of finished cases and can stop the run, if any.
    pub progress: Option<&'a WorkProgress>,
}

impl RunOptions<'_> {
    /// Only metrics, without a store.
    pub const METRICS: RunOptions<'static> = RunOptions {
        store: None,
        recompute: false,
        keep_history: None,
        on_solution: None,
        progress: None,
    };

    /// [`Error::Interrupted`] if the run is stopped.
    pub(crate) fn go_on(&self) -> Result<(), Error> {
        self.progress.map_or(Ok(()), WorkProgress::go_on)
    }
}
