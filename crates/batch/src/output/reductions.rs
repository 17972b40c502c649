//! reductions.csv: the value of every reduction for every group of cases.

use super::failures_and_histories::cell;
use crate::PartResult;
use slipgap_study::error::Error;
use slipgap_study::{Groups, Reduced, Reduction, Study};

/// The columns before the parameters, and after them.
const COLUMNS: ([&str; 1], [&str; 3]) = (["reduction"], ["cases", "empty", "value"]);

/// The values of reductions, collected part by part.
#[derive(Debug)]
pub struct ReducedMetrics<'a> {
    study: &'a Study,
    /// Reductions of the same parameters, each with its row of the measures.
    groups: Vec<(Vec<usize>, Groups<'a>)>,
}

/// reductions.csv.
#[derive(Debug)]
pub struct ReductionTable {
    /// The file.
    pub bytes: Vec<u8>,
    /// Each reduction of cases without a value: its name, and how many of how many cases.
    pub empty: Vec<(String, u64, u64)>,
}

impl<'a> ReducedMetrics<'a> {
    /// No cases yet.
    pub fn new(study: &'a Study) -> ReducedMetrics<'a> {
        let mut alike: Vec<(Vec<usize>, Vec<&Reduction>)> = Vec::new();
        for (row, _, reduction) in study.reductions() {
            let same =
                |(_, others): &&mut (Vec<usize>, Vec<&Reduction>)| others[0].groups_like(reduction);
            match alike.iter_mut().find(same) {
                Some((rows, reductions)) => {
                    rows.push(row);
                    reductions.push(reduction);
                }
                None => alike.push((vec![row], vec![reduction])),
            }
        }
        let groups = alike.into_iter();
        ReducedMetrics {
            study,
            groups: groups
                .map(|(rows, alike)| (rows, Groups::new(alike)))
                .collect(),
        }
    }

    /// Adds a part.
    pub fn add(&mut self, part: &PartResult) {
        for (_, groups) in &mut self.groups {
            let mut of: Vec<usize> = groups.reductions().iter().map(|r| r.of).collect();
            of.dedup();
            let of_rows = of.iter().map(|row| part.metrics.column(*row).collect());
            let columns: Vec<Vec<Option<f64>>> = of_rows.collect();
            let mut shown = part.cases.shown();
            for (index, number) in (0..part.len()).map(|row| (row, part.number(row))) {
                groups.add(number, shown.at(index), |row| {
                    let column = of.iter().position(|of| *of == row)?;
                    columns[column][index]
                });
            }
        }
    }

    /// The table, if the study has reductions: one row for each reduction and group, in the order of the file and of the
    /// cases.
    pub fn table(&self) -> Result<Option<ReductionTable>, Error> {
        if self.groups.is_empty() {
            return Ok(None);
        }
        let study = self.study;
        let failed = |e: csv::Error| Error::Internal(e.to_string());
        let mut writer = csv::Writer::from_writer(Vec::new());
        let parameters = study.varying_columns();
        let table = study.problem.parameters();
        let names = parameters.iter().map(|row| table[*row].column_name());
        let header = COLUMNS.0.into_iter().chain(names).chain(COLUMNS.1);
        writer.write_record(header).map_err(failed)?;
        let mut empty = Vec::new();
        for (row, measure, reduction) in study.reductions() {
            let (mut lacking, mut cases) = (0, 0);
            for reduced in self.values(row) {
                (lacking, cases) = (lacking + reduced.empty, cases + reduced.cases);
                let shown = self.parameters(&parameters, reduction, &reduced);
                let numbers = [reduced.cases, reduced.empty].map(|n| n.to_string());
                let name = std::iter::once(measure.name.clone());
                let cells = name
                    .chain(shown)
                    .chain(numbers)
                    .chain([cell(reduced.value)]);
                writer.write_record(cells).map_err(failed)?;
            }
            if lacking > 0 {
                empty.push((measure.name.clone(), lacking, cases));
            }
        }
        let bytes = writer
            .into_inner()
            .map_err(|e| Error::Internal(e.to_string()))?;
        Ok(Some(ReductionTable { bytes, empty }))
    }

    /// The values of the reduction in a row of the measures.
    fn values(&self, row: usize) -> impl Iterator<Item = Reduced> {
        self.groups.iter().flat_map(move |(rows, groups)| {
            let which = rows.iter().position(|other| *other == row);
            which.into_iter().flat_map(|which| groups.values(which))
        })
    }

    /// The cells of the parameters: those that all cases of the group share, and the others of the case that has the value.
    fn parameters(
        &self,
        parameters: &[usize],
        reduction: &Reduction,
        reduced: &Reduced,
    ) -> Vec<String> {
        let case = self.study.case(reduced.at.unwrap_or(reduced.first));
        let shown = |row: &usize| {
            let known = reduced.at.is_some() || reduction.kept.contains(row);
            let value = case.as_ref().filter(|_| known)?.values[*row];
            value.map(|value| value.cell())
        };
        let cells = parameters.iter().map(|row| shown(row).unwrap_or_default());
        cells.collect()
    }
}
