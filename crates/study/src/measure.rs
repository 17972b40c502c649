//! The metrics of a study: those of its problem, the same in the units of the study, and their reductions.

use super::units::Units;
use crate::computed::Computed;
use crate::reduction::Reduction;
use slipgap_problem::problem::numbers::unit::Dimension;
use slipgap_problem::problem::{Problem, escape, set_unit};

/// A column of results beyond the parameters, or a reduction of one.
#[derive(Debug, Clone)]
pub struct Measure {
    /// Column name.
    pub name: String,
    /// How figures write it, with its scale or unit, in markup.
    pub symbol: String,
    /// Unit, or `1`.
    pub unit: String,
    /// The formula as text.
    pub meaning: String,
    /// Row of `problem.metrics()`: the metric itself, or the one that is reduced; `None` for one that is computed from others.
    pub metric: Option<usize>,
    /// The dimension of a metric in the units of the study; `None` for the scaled metric.
    pub dimension: Option<Dimension>,
    /// How it is reduced; `None` for a metric, which each case has.
    pub reduction: Option<Reduction>,
    /// How it is computed from others; `None` for a metric of the problem and for a reduction.
    pub computed: Option<Computed>,
}

impl Measure {
    /// The symbol without its unit, for a number that has none, such as an index.
    pub fn bare_symbol(&self) -> &str {
        let units = [
            format!(", {}", set_unit(&self.unit)),
            format!(" ({})", escape(&self.unit)),
        ];
        let mut bare = units
            .iter()
            .filter_map(|unit| self.symbol.strip_suffix(unit));
        bare.next().unwrap_or(&self.symbol)
    }

    /// That the metric is above a limit, in markup: `symbol > limit unit`.
    pub fn above(&self, limit: &str) -> String {
        let symbol = self.bare_symbol();
        let unit = match symbol.len() < self.symbol.len() {
            true => format!(" {}", set_unit(&self.unit)),
            false => String::new(),
        };
        format!("{symbol} > {limit}{unit}")
    }
}

/// The metrics of a problem, row by row, and then those with a dimension in the units of the study, if it has any.
pub fn measures(problem: &dyn Problem, units: Option<&Units>) -> Vec<Measure> {
    let metrics = || problem.metrics().iter().enumerate();
    let scaled = metrics().map(|(row, metric)| Measure {
        name: metric.name.to_string(),
        symbol: metric.symbol.to_string(),
        unit: metric.unit.to_string(),
        meaning: metric.meaning.to_string(),
        metric: Some(row),
        dimension: None,
        reduction: None,
        computed: None,
    });
    let in_units = units.into_iter().flat_map(|units| {
        metrics().filter_map(move |(row, metric)| {
            let mut known = problem.schema().units.iter();
            let scale = known.find(|unit| unit.name == metric.unit)?;
            Some(Measure {
                name: units.column(&metric.name, scale.dimension),
                symbol: units.title(problem, &metric.symbol, scale.dimension),
                unit: units.of(scale.dimension),
                meaning: format!("{} times {}", metric.name, scale.name),
                metric: Some(row),
                dimension: Some(scale.dimension),
                reduction: None,
                computed: None,
            })
        })
    });
    scaled.chain(in_units).collect()
}

/// The rows of these metrics, each followed by the same in units, if there is one.
pub(crate) fn columns(measures: &[Measure], metrics: &[usize]) -> Vec<usize> {
    let of = |metric: &usize| {
        let metric = *metric;
        let rows = measures.iter().enumerate();
        rows.filter(move |(_, measure)| {
            measure.metric == Some(metric) && measure.reduction.is_none()
        })
        .map(|(row, _)| row)
    };
    metrics.iter().flat_map(of).collect()
}
