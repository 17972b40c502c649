//! sobol.csv: the Sobol' indices of every metric of every saltelli design.

#[cfg(test)]
use crate::batch::DrawnCase;
use crate::batch::{GroupResults, PartResult};
use slipgap_solver::problem::numbers::parameter::shortest;
use slipgap_statistics::sobol::{Index, Indices, Lack, indices};
use slipgap_study::error::Error;
use slipgap_study::{Block, Figure, Sampling, Study};
use std::ops::Range;
use std::sync::OnceLock;

/// The table's columns.
const COLUMNS: [&str; 10] = [
    "block",
    "metric",
    "parameter",
    "first_order",
    "first_order_low",
    "first_order_high",
    "total",
    "total_low",
    "total_high",
    "empty_cases",
];

/// The indices of a metric, or why it has none.
pub type Estimates = Result<Vec<Indices>, Lack>;

/// The metrics of saltelli designs, collected part by part. The indices of a metric are estimated once, when they are first
/// asked for.
#[derive(Debug)]
pub struct DesignMetrics {
    designs: Vec<DesignColumns>,
}

/// The metrics of a design.
#[derive(Debug)]
struct DesignColumns {
    block: usize,
    /// Number of its first case, and of the first one after it.
    cases: Range<u64>,
    parameters: usize,
    seed: u64,
    columns: Vec<MetricColumn>,
}

/// A metric of a design.
#[derive(Debug)]
struct MetricColumn {
    /// Row of the study's measures.
    metric: usize,
    /// An undefined value is NaN, which takes half the memory of an option.
    values: Vec<f64>,
    estimates: OnceLock<Estimates>,
}

/// sobol.csv.
#[derive(Debug)]
pub struct IndexTable {
    /// The file.
    pub bytes: Vec<u8>,
    /// Each metric without indices, and the reason.
    pub undefined: Vec<String>,
}

impl DesignMetrics {
    /// No metrics yet.
    pub fn new(study: &Study) -> DesignMetrics {
        let blocks = study.blocks.iter().enumerate();
        let design = |(block, of): (usize, &Block)| {
            let design = of.design.as_ref()?;
            let first = study.first_of(block);
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
        let mut all = DesignMetrics::new(study);
        let count = cases.len() as u64;
        let own = |design: &DesignColumns| design.cases.end - design.cases.start == count;
        all.designs.retain(own);
        for column in all
            .designs
            .iter_mut()
            .flat_map(|design| &mut design.columns)
        {
            let values = cases.iter().map(|shown| shown.metric(column.metric));
            column.values.extend(values.map(|x| x.unwrap_or(f64::NAN)));
        }
        all
    }

    /// Adds a part.
    pub fn add(&mut self, part: &PartResult) {
        for design in &mut self.designs {
            let cases = &design.cases;
            let of_design = (0..part.len()).map(|row| cases.contains(&part.number(row)));
            for column in &mut design.columns {
                let rows = part.metrics.column(column.metric).zip(of_design.clone());
                let rows = rows.filter(|(_, of_design)| *of_design);
                let values = rows.map(|(value, _)| value.unwrap_or(f64::NAN));
                column.values.extend(values);
            }
        }
    }

    /// The indices of these metrics from the design whose cases a figure shows, which are `count`.
    pub(in crate::batch) fn indices(
        &self,
        study: &Study,
        figure: &Figure,
        count: usize,
        metrics: &[usize],
    ) -> GroupResults<'_> {
        let own = |design: &&DesignColumns| {
            let cases = &design.cases;
            let first = study.case(cases.start);
            cases.end - cases.start == count as u64
                && first.is_some_and(|first| figure.filter.matches(&first))
        };
        let Some(design) = self.designs.iter().find(own) else {
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

    /// The table, if there is a saltelli design. Metrics without indices have empty cells. `tick` is called after each
    /// metric, because each takes long if there are many cases.
    pub fn table(&self, study: &Study, tick: impl Fn()) -> Result<Option<IndexTable>, Error> {
        if self.designs.is_empty() {
            return Ok(None);
        }
        let mut undefined = Vec::new();
        let failed = |e: csv::Error| Error::Internal(e.to_string());
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(COLUMNS).map_err(failed)?;
        for design in &self.designs {
            for column in &design.columns {
                let estimates = design.estimates(column);
                tick();
                if let Err(lack) = estimates {
                    let name = &study.measures[column.metric].name;
                    undefined.push(format!("{name} of block {} is {lack}", design.block));
                }
                for row in design.rows(study, column) {
                    writer.write_record(row).map_err(failed)?;
                }
            }
        }
        let bytes = writer.into_inner();
        let bytes = bytes.map_err(|e| Error::Internal(e.to_string()))?;
        Ok(Some(IndexTable { bytes, undefined }))
    }
}

impl DesignColumns {
    /// The indices of a metric.
    fn estimates<'a>(&self, column: &'a MetricColumn) -> &'a Estimates {
        column.estimates.get_or_init(|| {
            let value = |x: &f64| (!x.is_nan()).then_some(*x);
            let values: Vec<Option<f64>> = column.values.iter().map(value).collect();
            indices(&values, self.parameters, self.seed)
        })
    }

    /// The rows of a metric, one for each parameter.
    fn rows(&self, study: &Study, column: &MetricColumn) -> Vec<Vec<String>> {
        let estimates = self.estimates(column);
        let lack = estimates.as_ref().err();
        let empty = lack.map_or(0, |lack| lack.empty_cases());
        let design = study.blocks[self.block].design.iter();
        let parameters = design.flat_map(|design| design.parameters.iter().enumerate());
        let row = |(place, parameter): (usize, &usize)| {
            let own = estimates.as_ref().ok().map(|estimates| estimates[place]);
            let first = [
                self.block.to_string(),
                study.measures[column.metric].name.clone(),
                study.problem.parameters()[*parameter].name.to_string(),
            ];
            let indices = [own.map(|own| own.first), own.map(|own| own.total)];
            let cells = indices.into_iter().flat_map(cells);
            let row = first.into_iter().chain(cells);
            row.chain([empty.to_string()]).collect()
        };
        parameters.map(row).collect()
    }
}

/// An index with its interval; empty cells for a metric without indices.
fn cells(index: Option<Index>) -> [String; 3] {
    match index {
        Some(Index { value, interval }) => [value, interval[0], interval[1]].map(shortest),
        None => Default::default(),
    }
}
