//! Results in the units of the study, worked out from the scaled ones: the store never has them.

use crate::problem::cases::Cases;
use crate::solve::MetricTable;
use crate::study::Study;

/// What was found, with the metrics in the units of the study, if it has any.
pub fn added(study: &Study, cases: &Cases, found: MetricTable) -> MetricTable {
    if study.units.is_none() {
        return found;
    }
    let mut wide = MetricTable::new(found.len(), study.measures.len());
    let mut shown = cases.shown();
    for place in 0..found.len() {
        wide.copy(place, &found, place);
        let mut row: Vec<f64> = wide.row(place).map(|x| x.unwrap_or(f64::NAN)).collect();
        let case = shown.at(place);
        for (column, measure) in study.measures.iter().enumerate() {
            if let Some(dimension) = measure.dimension {
                let size = study.problem.size(case, dimension);
                row[column] = row[measure.metric] * size.unwrap_or(f64::NAN);
            }
        }
        wide.set(place, row.into_iter());
    }
    wide
}
