//! The Sobol' indices of the metrics of saltelli designs.

use super::GroupResults;
#[cfg(test)]
use crate::DrawnCase;
use slipgap_motion::solve::MetricTable;
use slipgap_problem::problem::table::cases::Cases;
use slipgap_statistics::sobol::{Indices, Lack, indices};
use slipgap_study::{Block, Figure, Sampling, Study};
use std::ops::Range;
use std::sync::OnceLock;

/// The indices of a metric, or why it has none.
pub type Estimates = Result<Vec<Indices>, Lack>;

/// The metrics of saltelli designs, collected part by part. The indices of a metric are estimated once, when they are first
/// asked for.
#[derive(Debug)]
pub struct DesignMetrics {
    /// In the order of the blocks.
    pub designs: Vec<DesignColumns>,
}

/// The metrics of a design.
#[derive(Debug)]
pub struct DesignColumns {
    /// Its block.
    pub block: usize,
    /// Number of its first case, and of the first one after it.
    cases: Range<u64>,
    parameters: usize,
    seed: u64,
    /// One for each column of the study.
    pub columns: Vec<MetricColumn>,
}

/// A metric of a design.
#[derive(Debug)]
pub struct MetricColumn {
    /// Row of the study's measures.
    pub metric: usize,
    /// An undefined value is NaN, which takes half the memory of an option.
    values: Vec<f64>,
    estimates: OnceLock<Estimates>,
}

impl DesignMetrics {
    /// No metrics yet.
    pub fn new(study: &Study) -> DesignMetrics {
        let blocks = study.blocks.iter().enumerate();
        let design = |(block, of): (usize, &Block)| {
            let design = of.design.as_ref()?;
            let first = study.enumeration().first_of(block);
            let column = |metric: &usize| MetricColumn {
                metric: *metric,
                values: Vec::with_capacity(of.raw_len() as usize),
                estimates: OnceLock::new(),
            };
            (design.sampling == Sampling::Saltelli).then(|| DesignColumns {
                block,
                cases: first..first + of.raw_len(),
                parameters: design.parameters.len(),
                seed: design.seed,
                columns: study.columns.iter().map(column).collect(),
            })
        };
        DesignMetrics {
            designs: blocks.filter_map(design).collect(),
        }
    }

    /// The designs with as many cases, which are these.
    #[cfg(test)]
    pub fn of_cases(study: &Study, cases: &[DrawnCase]) -> DesignMetrics {
        let mut metrics = DesignMetrics::new(study);
        let count = cases.len() as u64;
        let is_complete = |design: &DesignColumns| design.cases.end - design.cases.start == count;
        metrics.designs.retain(is_complete);
        for column in metrics
            .designs
            .iter_mut()
            .flat_map(|design| &mut design.columns)
        {
            let values = cases.iter().map(|shown| shown.metric(column.metric));
            column.values.extend(values.map(|x| x.unwrap_or(f64::NAN)));
        }
        metrics
    }

    /// Adds the metrics of cases, which are numbered from `first` on.
    pub fn add(&mut self, first: u64, added: &Cases, metrics: &MetricTable) {
        for design in &mut self.designs {
            let cases = &design.cases;
            let number = |row| first + added.offset(row);
            let of_design = (0..added.len()).map(|row| cases.contains(&number(row)));
            for column in &mut design.columns {
                let pairs = metrics.column(column.metric).zip(of_design.clone());
                let rows = pairs.filter(|(_, of_design)| *of_design);
                let values = rows.map(|(value, _)| value.unwrap_or(f64::NAN));
                column.values.extend(values);
            }
        }
    }

    /// The indices of these metrics from the design whose cases a figure shows, which are `count`.
    pub(super) fn indices(
        &self,
        study: &Study,
        figure: &Figure,
        count: usize,
        metrics: &[usize],
    ) -> GroupResults<'_> {
        let is_complete = |design: &&DesignColumns| {
            let cases = &design.cases;
            let first = study.case(cases.start);
            cases.end - cases.start == count as u64
                && first.is_some_and(|first| figure.filter.matches(&first))
        };
        let Some(design) = self.designs.iter().find(is_complete) else {
            return GroupResults::None;
        };
        let column = |metric: &usize| {
            let mut columns = design.columns.iter();
            columns.find(|column| column.metric == *metric)
        };
        let columns = metrics.iter().filter_map(column);
        GroupResults::Indices {
            block: design.block,
            estimates: columns.map(|column| design.estimates(column)).collect(),
        }
    }

    /// Number of estimates: one for each metric of each design.
    pub fn estimates(&self) -> usize {
        self.designs.iter().map(|design| design.columns.len()).sum()
    }
}

impl DesignColumns {
    /// The indices of a metric.
    pub fn estimates<'a>(&self, column: &'a MetricColumn) -> &'a Estimates {
        column.estimates.get_or_init(|| {
            let value = |x: &f64| (!x.is_nan()).then_some(*x);
            let values: Vec<Option<f64>> = column.values.iter().map(value).collect();
            indices(&values, self.parameters, self.seed)
        })
    }
}
