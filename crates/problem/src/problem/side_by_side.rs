//! Cases side by side in lanes.

use super::Problem;
use crate::problem::table::case::Case;
use crate::problem::table::cases::Cases;
use crate::solve::sweep::{LONGEST, LaneCase};
use crate::solve::{MetricTable, Unsolvable};
use std::ops::Range;

/// The default metrics of the cases in these rows, in their order, L at a time where their runs are not too long; to the bit
/// what each has by itself.
pub(super) fn sweep_cases<const L: usize, A: LaneCase<L>, B: LaneCase<L>>(
    problem: &impl Problem,
    cases: &Cases,
    rows: &[u32],
    lane_case: impl Fn(&Case) -> Result<Form<A, B>, Unsolvable>,
) -> MetricTable {
    let mut table = MetricTable::new(rows.len(), problem.schema().default_metrics());
    let (mut plain, mut others) = (Vec::with_capacity(rows.len()), Vec::new());
    let mut shown = cases.shown();
    for (index, row) in rows.iter().enumerate() {
        let case = shown.at(*row as usize);
        match lane_case(case) {
            Ok(Form::Plain(plain_case)) if plain_case.system().last <= LONGEST => {
                plain.push((index, plain_case))
            }
            Ok(Form::Other(other)) if other.system().last <= LONGEST => others.push((index, other)),
            Ok(_) => {
                let solution = problem.solve(case, &[]);
                let warnings = solution.as_ref().map(|solution| solution.warnings);
                table.warn(index, warnings.unwrap_or_default());
                table.put(index, solution.map(|solution| solution.metrics));
            }
            Err(why) => table.fail(index, why),
        }
    }
    crate::solve::sweep::sweep(&plain, &mut table);
    crate::solve::sweep::sweep(&others, &mut table);
    table
}

/// A case in one of two forms for lanes: a small one for the usual laws and the usual method, so that less is copied, and one for all.
pub(super) enum Form<A, B> {
    Plain(A),
    Other(B),
}

/// Metrics in these rows, those that are not wanted without a value.
pub(super) fn selected<const N: usize>(
    rows: Range<usize>,
    values: [Option<f64>; N],
    wanted: &[usize],
) -> Vec<Option<f64>> {
    let in_rows = rows.zip(values);
    in_rows
        .map(|(row, value)| value.filter(|x| x.is_finite() && wanted.contains(&row)))
        .collect()
}
