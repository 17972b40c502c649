//! Metrics in the units of the study, computed from the scaled ones. The store never contains them.

use slipgap_solver::problem::cases::Cases;
use slipgap_solver::solve::MetricTable;
use slipgap_study::Study;

/// The metrics, followed by the same in the units of the study, if it has units.
pub fn with_unit_columns(study: &Study, cases: &Cases, metrics: MetricTable) -> MetricTable {
    if study.units.is_none() {
        return metrics;
    }
    let mut extended = MetricTable::new(metrics.len(), study.measures.len());
    let mut shown = cases.shown();
    for row in 0..metrics.len() {
        extended.copy(row, &metrics, row);
        let cells = extended.row(row);
        let mut cells: Vec<f64> = cells.map(|x| x.unwrap_or(f64::NAN)).collect();
        let case = shown.at(row);
        for (column, measure) in study.measures.iter().enumerate() {
            if let (Some(dimension), None) = (measure.dimension, &measure.reduction) {
                let size = study.problem.size(case, dimension);
                cells[column] = cells[measure.metric] * size.unwrap_or(f64::NAN);
            }
        }
        extended.set(row, cells.into_iter());
    }
    extended
}
