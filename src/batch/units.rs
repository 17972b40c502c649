//! Metrics in the units of the study, computed from the scaled ones. The store never contains them.

use slipgap_solver::problem::cases::Cases;
use slipgap_solver::solve::MetricTable;
use slipgap_study::Study;

/// The metrics, followed by the same in the units of the study, if it has units.
pub fn with_unit_columns(study: &Study, cases: &Cases, metrics: MetricTable) -> MetricTable {
    if study.units.is_none() {
        return metrics;
    }
    let mut extended = metrics.widened(study.measures.len());
    for (column, measure) in study.measures.iter().enumerate() {
        if let (Some(dimension), None) = (measure.dimension, &measure.reduction) {
            let scaled: Vec<Option<f64>> = extended.column(measure.metric).collect();
            let mut shown = cases.shown();
            let in_units = scaled.iter().enumerate().map(|(row, scaled)| {
                let size = study.problem.size(shown.at(row), dimension);
                scaled.zip(size).map_or(f64::NAN, |(x, size)| x * size)
            });
            extended.set_column(column, in_units);
        }
    }
    extended
}
