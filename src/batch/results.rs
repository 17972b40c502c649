//! Tables for people and programs: results.csv and the histories.

use super::Outcome;
use crate::error::Error;
use crate::problem::parameter::shortest;
use crate::problem::{Problem, Solution};
use crate::study::Study;
use std::io::{self, Write};

/// results.csv: one row a case in case order; `case`, the parameters in the table's order, then the metrics.
pub fn table(study: &Study, outcomes: &[Outcome]) -> Result<Vec<u8>, Error> {
    let metrics = study.problem.metrics();
    let parameters = study.problem.parameters();
    let mut writer = csv::Writer::from_writer(Vec::new());
    let header = ["case"]
        .into_iter()
        .chain(parameters.iter().map(|p| p.name))
        .chain(study.metrics.iter().map(|&m| metrics[m].name));
    writer.write_record(header).map_err(internal)?;
    for (index, outcome) in outcomes.iter().enumerate() {
        let row = [index.to_string()]
            .into_iter()
            .chain(outcome.case.values.iter().map(|value| match value {
                Some(value) => value.to_string(),
                None => String::new(),
            }))
            .chain(study.metrics.iter().map(|&m| cell(outcome.metrics[m])));
        writer.write_record(row).map_err(internal)?;
    }
    writer.into_inner().map_err(internal)
}

/// Writes a case's history: the problem's six columns, one row a step.
pub fn history(problem: &dyn Problem, solution: &Solution, out: impl Write) -> io::Result<()> {
    let (c, e) = (&solution.computed, &solution.exact);
    let mut writer = csv::Writer::from_writer(out);
    writer.write_record(problem.history_columns())?;
    for i in 0..c.len() {
        let row = [
            c.time[i],
            c.displacement[i],
            c.velocity[i],
            c.force[i],
            e.displacement[i],
            e.velocity[i],
        ];
        writer.write_record(row.map(shortest))?;
    }
    writer.flush()
}

fn cell(value: Option<f64>) -> String {
    value.map(shortest).unwrap_or_default()
}

/// Writing to memory fails for no reason a user could mend.
fn internal(error: impl std::fmt::Display) -> Error {
    Error::Internal(error.to_string())
}
