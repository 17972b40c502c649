//! Metrics that are computed from others: in the units of the study, by arithmetic, and over those of a reference case. The store never
//! contains them.

use crate::PartResult;
use slipgap_motion::solve::MetricTable;
use slipgap_problem::problem::Case;
use slipgap_problem::problem::table::cases::Cases;
use slipgap_study::{Computed, Found, Partners, Reference, Rule, Study};

/// The metrics, followed by the same in the units of the study, if it has units, and by those computed by arithmetic. Ratios and
/// what is computed from them have no value yet.
pub fn with_computed_columns(study: &Study, cases: &Cases, metrics: MetricTable) -> MetricTable {
    if study.units.is_none() && study.computed().next().is_none() {
        return metrics;
    }
    let mut extended = metrics.widened(study.measures.len());
    for (column, measure) in study.measures.iter().enumerate() {
        if let (Some(dimension), Some(metric), None) =
            (measure.dimension, measure.metric, &measure.reduction)
        {
            let scaled: Vec<Option<f64>> = extended.column(metric).collect();
            let mut shown = cases.shown();
            let in_units = scaled.iter().enumerate().map(|(row, scaled)| {
                let size = study
                    .problem
                    .as_textbook()
                    .and_then(|textbook| textbook.size(shown.at(row), dimension));
                scaled.zip(size).map_or(f64::NAN, |(x, size)| x * size)
            });
            extended.set_column(column, in_units);
        }
    }
    for (column, _, computed) in study.computed().filter(|(.., computed)| !computed.late) {
        set_arithmetic(cases, &mut extended, column, computed);
    }
    extended
}

/// Sets the values of a formula in all cases.
fn set_arithmetic(cases: &Cases, metrics: &mut MetricTable, column: usize, computed: &Computed) {
    let mut shown = cases.shown();
    let value = |row: usize| {
        let of = |measure| metrics.value(row, measure);
        computed.value(shown.at(row), &of).unwrap_or(f64::NAN)
    };
    let values: Vec<f64> = (0..cases.len()).map(value).collect();
    metrics.set_column(column, values.into_iter());
}

/// Sets the ratios of all cases of a study, and what is computed from them.
pub(crate) fn add_ratios(study: &Study, parts: &mut [PartResult]) {
    for (column, _, computed) in study.computed().filter(|(.., computed)| computed.late) {
        match &computed.rule {
            Rule::Formula(_) => {
                for part in &mut *parts {
                    set_arithmetic(&part.cases, &mut part.metrics, column, computed);
                }
            }
            Rule::Ratio(of, reference) => set_ratio(parts, column, *of, reference),
        }
    }
}

/// Sets a metric over that of the reference case in all cases. It is undefined where there is no such case or several, and
/// where the other value is 0 or undefined.
fn set_ratio(parts: &mut [PartResult], column: usize, of: usize, reference: &Reference) {
    let mut references: Vec<(Case, Option<f64>)> = Vec::new();
    for part in &*parts {
        let mut shown = part.cases.shown();
        for row in 0..part.len() {
            let case = shown.at(row);
            if reference.filter.matches(case) {
                references.push((case.clone(), part.metrics.value(row, of)));
            }
        }
    }
    let cases: Vec<&Case> = references.iter().map(|(case, _)| case).collect();
    let mut partners = Partners::new(&reference.shared, &cases);
    for part in parts {
        let mut shown = part.cases.shown();
        let ratio = |row: usize| {
            let Found::One(partner) = partners.find(shown.at(row)) else {
                return f64::NAN;
            };
            let pair = part.metrics.value(row, of).zip(references[partner].1);
            pair.map_or(f64::NAN, |(value, other)| value / other)
        };
        let ratios: Vec<f64> = (0..part.len()).map(ratio).collect();
        part.metrics.set_column(column, ratios.into_iter());
    }
}
