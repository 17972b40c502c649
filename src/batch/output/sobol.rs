//! sobol.csv: the Sobol' indices of every metric of every saltelli design.

use crate::batch::PartResult;
use slipgap_solver::problem::parameter::shortest;
use slipgap_statistics::sobol::{Index, indices};
use slipgap_study::error::Error;
use slipgap_study::{Block, Sampling, Study};

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

/// The metrics of saltelli designs, collected part by part.
#[derive(Debug)]
pub struct DesignMetrics<'a> {
    study: &'a Study,
    designs: Vec<DesignColumns>,
}

/// sobol.csv.
#[derive(Debug)]
pub struct IndexTable {
    /// The file.
    pub bytes: Vec<u8>,
    /// Each metric without indices, and the reason.
    pub undefined: Vec<String>,
}

/// First case of a design, its block, and the values of each column of the study. An undefined value is NaN, which takes
/// half the memory of an option.
type DesignColumns = (u64, usize, Vec<Vec<f64>>);

impl<'a> DesignMetrics<'a> {
    /// No metrics yet.
    pub fn new(study: &'a Study) -> DesignMetrics<'a> {
        let saltelli = |block: &Block| {
            let design = block.design.as_ref();
            design.is_some_and(|d| d.sampling == Sampling::Saltelli)
        };
        let blocks = study.blocks.iter().enumerate();
        let saltelli = blocks.filter(|(_, block)| saltelli(block));
        let empty = |(i, block): (usize, &Block)| {
            let column = |_| Vec::with_capacity(block.raw_len() as usize);
            let columns = study.columns.iter().map(column).collect();
            (study.first_of(i), i, columns)
        };
        DesignMetrics {
            study,
            designs: saltelli.map(empty).collect(),
        }
    }

    /// Adds a part.
    pub fn add(&mut self, part: &PartResult) {
        for (first, block, columns) in &mut self.designs {
            let end = *first + self.study.blocks[*block].raw_len();
            let of_design = (0..part.len()).map(|row| (*first..end).contains(&part.number(row)));
            for (column, metric) in columns.iter_mut().zip(&self.study.columns) {
                let rows = part.metrics.column(*metric).zip(of_design.clone());
                let rows = rows.filter(|(_, of_design)| *of_design);
                column.extend(rows.map(|(value, _)| value.unwrap_or(f64::NAN)));
            }
        }
    }

    /// Number of estimates: one for each metric of each design.
    pub fn estimates(&self) -> usize {
        self.designs
            .iter()
            .map(|(_, _, columns)| columns.len())
            .sum()
    }

    /// The table, if there is a saltelli design. Metrics without indices have empty cells. `tick` is called after each
    /// metric, because each takes long if there are many cases.
    pub fn table(&self, tick: impl Fn()) -> Result<Option<IndexTable>, Error> {
        if self.designs.is_empty() {
            return Ok(None);
        }
        let mut undefined = Vec::new();
        let failed = |e: csv::Error| Error::Internal(e.to_string());
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(COLUMNS).map_err(failed)?;
        let problem = &self.study.problem;
        for (_, block, columns) in &self.designs {
            let Some(design) = &self.study.blocks[*block].design else {
                continue;
            };
            for (values, metric) in columns.iter().zip(&self.study.columns) {
                let values: Vec<Option<f64>> =
                    values.iter().map(|x| (!x.is_nan()).then_some(*x)).collect();
                let estimates = indices(&values, design.parameters.len(), design.seed);
                tick();
                if let Err(lack) = &estimates {
                    let name = &self.study.measures[*metric].name;
                    undefined.push(format!("{name} of block {block} is {lack}"));
                }
                let empty = estimates
                    .as_ref()
                    .err()
                    .map_or(0, |lack| lack.empty_cases());
                for (place, parameter) in design.parameters.iter().enumerate() {
                    let row = [
                        block.to_string(),
                        self.study.measures[*metric].name.clone(),
                        problem.parameters()[*parameter].name.to_string(),
                    ];
                    let own = estimates.as_ref().ok().map(|estimates| estimates[place]);
                    let cells = |index: Option<Index>| match index {
                        Some(Index { value, interval }) => {
                            [value, interval[0], interval[1]].map(shortest)
                        }
                        None => Default::default(),
                    };
                    let first = cells(own.map(|own| own.first));
                    let total = cells(own.map(|own| own.total));
                    let row = row.into_iter().chain(first).chain(total);
                    let row = row.chain([empty.to_string()]);
                    writer.write_record(row).map_err(failed)?;
                }
            }
        }
        let bytes = writer.into_inner();
        let bytes = bytes.map_err(|e| Error::Internal(e.to_string()))?;
        Ok(Some(IndexTable { bytes, undefined }))
    }
}
