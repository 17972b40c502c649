//! sobol.csv: the Sobol' indices of every metric of every saltelli design.

use crate::groups::sobol::{DesignColumns, DesignMetrics, MetricColumn};
use slipgap_problem::problem::numbers::parameter::real;
use slipgap_statistics::sobol::Index;
use slipgap_study::Study;
use slipgap_study::error::Error;

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

/// sobol.csv.
#[derive(Debug)]
pub struct IndexTable {
    /// The file.
    pub bytes: Vec<u8>,
    /// Each metric without indices, and the reason.
    pub undefined: Vec<String>,
}

/// The table, if there is a saltelli design. Metrics without indices have empty cells. `tick` is called after each
/// metric, because each takes long if there are many cases.
pub fn table(
    designs: &DesignMetrics,
    study: &Study,
    tick: impl Fn(),
) -> Result<Option<IndexTable>, Error> {
    if designs.designs.is_empty() {
        return Ok(None);
    }
    let mut undefined = Vec::new();
    let failed = |e: csv::Error| Error::Internal(e.to_string());
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(COLUMNS).map_err(failed)?;
    for design in &designs.designs {
        for column in &design.columns {
            let estimates = design.estimates(column);
            tick();
            if let Err(lack) = estimates {
                let name = &study.measures[column.metric].name;
                undefined.push(format!("{name} of block {} is {lack}", design.block));
            }
            for row in rows(study, design, column) {
                writer.write_record(row).map_err(failed)?;
            }
        }
    }
    let bytes = writer
        .into_inner()
        .map_err(|e| Error::Internal(e.to_string()))?;
    Ok(Some(IndexTable { bytes, undefined }))
}

/// The rows of a metric, one for each parameter.
fn rows(study: &Study, design: &DesignColumns, column: &MetricColumn) -> Vec<Vec<String>> {
    let estimates = design.estimates(column);
    let lack = estimates.as_ref().err();
    let empty = lack.map_or(0, |lack| lack.empty_cases());
    let sampled = study.blocks[design.block].design.iter();
    let parameters = sampled.flat_map(|design| design.parameters.iter().enumerate());
    let row = |(index, parameter): (usize, &usize)| {
        let estimate = estimates.as_ref().ok().map(|estimates| estimates[index]);
        let first = [
            design.block.to_string(),
            study.measures[column.metric].name.clone(),
            study.problem.parameters()[*parameter].name.to_string(),
        ];
        let indices = [
            estimate.map(|estimate| estimate.first),
            estimate.map(|estimate| estimate.total),
        ];
        let cells = indices.into_iter().flat_map(cells);
        let row = first.into_iter().chain(cells);
        row.chain([empty.to_string()]).collect()
    };
    parameters.map(row).collect()
}

/// An index with its interval; empty cells for a metric without indices.
fn cells(index: Option<Index>) -> [String; 3] {
    match index {
        Some(Index { value, interval }) => [value, interval[0], interval[1]].map(real),
        None => Default::default(),
    }
}
