//! Cases solved side by side on all cores, until the user ends the search.

use crate::Stop;
use crate::calibrate::Stopped;
use rayon::prelude::*;
use slipgap_motion::solve::MetricTable;
use slipgap_problem::problem::Problem;
use slipgap_problem::problem::table::cases::Cases;

/// Cases of one sweep: those that are stepped side by side. The bits of a case do not depend on it.
const TOGETHER: usize = 16;

/// The rows of the cases that may be solved, and their default metrics in this order. `tick` receives numbers of solved cases.
///
/// # Errors
/// The user ended the search.
pub fn sweep(
    problem: &dyn Problem,
    cases: &Cases,
    stop: &Stop,
    tick: &(dyn Fn(u64) + Sync),
) -> Result<(Vec<u32>, MetricTable), Stopped> {
    let rows: Vec<u32> = (0..cases.len() as u32)
        .filter(|row| cases.may_be_solved(*row as usize))
        .collect();
    let some = |rows: &[u32]| {
        if stop.is_stopped() {
            return Err(Stopped);
        }
        let table = problem.sweep(cases, rows);
        tick(rows.len() as u64);
        Ok(table)
    };
    let solved = rows.par_chunks(TOGETHER).map(some);
    let tables: Vec<MetricTable> = solved.collect::<Result<_, Stopped>>()?;
    Ok((rows, MetricTable::joined(tables)))
}
