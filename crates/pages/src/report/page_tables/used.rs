//! The metrics that a study uses.

use slipgap_study::{ColumnRef, Study};
use std::collections::BTreeSet;

/// The rows of the study's measures that its figures, checks and reductions read. All of a structure, whose study names each; empty if
/// no metric is used.
pub fn metrics(study: &Study) -> BTreeSet<usize> {
    if study.problem.schema().described {
        return study.columns.iter().copied().collect();
    }
    let mut used: BTreeSet<usize> = study.checks.iter().map(|check| check.metric).collect();
    used.extend(study.reductions().map(|(row, ..)| row));
    for figure in &study.figures {
        used.extend(figure.kind.measures(&*study.problem));
        let columns = figure.kind.columns().into_iter().flatten();
        used.extend(columns.filter_map(|column| match column {
            ColumnRef::Metric(row) => Some(row),
            ColumnRef::Parameter(_) => None,
        }));
    }
    let reduced = |row: &usize| {
        let measure = &study.measures[*row];
        let alike = |column: &&usize| {
            let column = &study.measures[**column];
            (column.metric, column.dimension) == (measure.metric, measure.dimension)
        };
        let column = study.columns.iter().find(alike);
        column.copied().unwrap_or(*row)
    };
    used.iter().map(reduced).collect()
}
