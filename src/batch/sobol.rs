//! sobol.csv: the indices of every metric of every saltelli design.

use super::Done;
use crate::error::Error;
use crate::indices::{Index, indices};
use crate::problem::parameter::shortest;
use crate::study::{Block, Sampling, Study};

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

/// Gathers the metrics of saltelli designs, part by part.
#[derive(Debug)]
pub struct Gathered<'a> {
    study: &'a Study,
    designs: Vec<Columns>,
}

/// sobol.csv.
#[derive(Debug)]
pub struct Table {
    /// The file.
    pub bytes: Vec<u8>,
    /// Each metric that has no indices, and why.
    pub without: Vec<String>,
}

/// First case of a design, its block, and the values of each of the study's metrics: not a number where one is undefined,
/// half the memory of an option.
type Columns = (u64, usize, Vec<Vec<f64>>);

impl<'a> Gathered<'a> {
    /// Nothing yet.
    pub fn new(study: &'a Study) -> Gathered<'a> {
        let saltelli = |block: &Block| {
            let design = block.design.as_ref();
            design.is_some_and(|d| d.sampling == Sampling::Saltelli)
        };
        let blocks = study.blocks.iter().enumerate();
        let chosen = blocks.filter(|(_, block)| saltelli(block));
        let begun = |(i, block): (usize, &Block)| {
            let column = |_| Vec::with_capacity(block.raw_len() as usize);
            let columns = study.columns.iter().map(column).collect();
            (study.first_of(i), i, columns)
        };
        Gathered {
            study,
            designs: chosen.map(begun).collect(),
        }
    }

    /// Takes note of a part.
    pub fn add(&mut self, done: &Done) {
        for (first, block, columns) in &mut self.designs {
            let end = *first + self.study.blocks[*block].raw_len();
            let of_design = (done.first..).take(done.len());
            let of_design = of_design.map(|number| (*first..end).contains(&number));
            for (column, metric) in columns.iter_mut().zip(&self.study.columns) {
                let rows = done.found.column(*metric).zip(of_design.clone());
                let rows = rows.filter(|(_, of_design)| *of_design);
                column.extend(rows.map(|(value, _)| value.unwrap_or(f64::NAN)));
            }
        }
    }

    /// How many times a metric's indices are estimated.
    pub fn estimates(&self) -> usize {
        self.designs
            .iter()
            .map(|(_, _, columns)| columns.len())
            .sum()
    }

    /// The table, if there is any saltelli design, and the metrics without indices. Those have empty cells. `estimated`
    /// is called after each metric: with many cases they take long.
    pub fn table(&self, estimated: impl Fn()) -> Result<Option<Table>, Error> {
        if self.designs.is_empty() {
            return Ok(None);
        }
        let mut without = Vec::new();
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
                let found = indices(&values, design.parameters.len(), design.seed);
                estimated();
                if let Err(lack) = &found {
                    let name = &self.study.measures[*metric].name;
                    without.push(format!("{name} of block {block} is {lack}"));
                }
                let empty = found.as_ref().err().map_or(0, |lack| lack.empty_cases());
                for (place, parameter) in design.parameters.iter().enumerate() {
                    let row = [
                        block.to_string(),
                        self.study.measures[*metric].name.clone(),
                        problem.parameters()[*parameter].name.to_string(),
                    ];
                    let of = found.as_ref().ok().map(|found| found[place]);
                    let cells = |index: Option<Index>| match index {
                        Some(Index { value, interval }) => {
                            [value, interval[0], interval[1]].map(shortest)
                        }
                        None => Default::default(),
                    };
                    let first = cells(of.map(|of| of.first));
                    let total = cells(of.map(|of| of.total));
                    let row = row.into_iter().chain(first).chain(total);
                    let row = row.chain([empty.to_string()]);
                    writer.write_record(row).map_err(failed)?;
                }
            }
        }
        let bytes = writer.into_inner();
        let bytes = bytes.map_err(|e| Error::Internal(e.to_string()))?;
        Ok(Some(Table { bytes, without }))
    }
}
