//! fragility.csv: the points of every fragility figure, with the function of their curve.

use super::tables::cell;
use crate::batch::groups::fragility::{FragilityCurve, FragilityPoint};
use slipgap_study::error::Error;
use slipgap_study::kinds::{FigureKind, Fragility};
use slipgap_study::{Figure, Study};

/// The columns before the parameters, and after them.
const COLUMNS: ([&str; 3], [&str; 9]) = (
    ["figure", "metric", "limit"],
    [
        "cases",
        "empty",
        "exceeded",
        "probability",
        "probability_low",
        "probability_high",
        "median",
        "dispersion",
        "no_fit",
    ],
);

/// fragility.csv, figure by figure.
pub struct FragilityTable<'a> {
    study: &'a Study,
    /// Rows of the parameters that are columns: all that vary outside of the ensemble.
    parameters: Vec<usize>,
    writer: csv::Writer<Vec<u8>>,
}

impl<'a> FragilityTable<'a> {
    /// The header; `None` for a study without a fragility figure.
    ///
    /// # Errors
    /// A table that cannot be made.
    pub fn new(study: &'a Study) -> Result<Option<FragilityTable<'a>>, Error> {
        let along = |figure: &Figure| match &figure.kind {
            FigureKind::Fragility(fragility) => Some(fragility.x),
            _ => None,
        };
        let along: Vec<usize> = study.figures.iter().filter_map(along).collect();
        if along.is_empty() {
            return Ok(None);
        }
        let outside = study.outside_ensemble(&[]);
        let mut parameters = study.varying_columns();
        parameters.retain(|row| outside.contains(row));
        // The place of a point has a column even if it is the only one.
        parameters.extend(along);
        parameters.sort_unstable();
        parameters.dedup();
        let table = study.problem.parameters();
        let names = parameters.iter().map(|row| table[*row].column_name());
        let mut writer = csv::Writer::from_writer(Vec::new());
        let header = COLUMNS.0.into_iter().chain(names).chain(COLUMNS.1);
        writer.write_record(header).map_err(failed)?;
        Ok(Some(FragilityTable {
            study,
            parameters,
            writer,
        }))
    }

    /// Adds the points of a figure, curve by curve.
    ///
    /// # Errors
    /// A row that cannot be made.
    pub fn add(
        &mut self,
        name: &str,
        figure: &Fragility,
        curves: &[FragilityCurve],
    ) -> Result<(), Error> {
        let metric = &self.study.measures[figure.y].name;
        let first = [name.to_owned(), metric.clone(), cell(Some(figure.limit))];
        for curve in curves {
            for point in &curve.points {
                let value = |row: &usize| match *row == figure.x {
                    true => cell(Some(point.at)),
                    false => {
                        let value = curve.shared.get(*row).copied().flatten();
                        value.map(|value| value.to_string()).unwrap_or_default()
                    }
                };
                let values = self.parameters.iter().map(value);
                let row = first
                    .iter()
                    .cloned()
                    .chain(values)
                    .chain(cells(curve, point));
                self.writer.write_record(row).map_err(failed)?;
            }
        }
        Ok(())
    }

    /// The file.
    ///
    /// # Errors
    /// A table that cannot be made.
    pub fn bytes(self) -> Result<Vec<u8>, Error> {
        let bytes = self.writer.into_inner();
        bytes.map_err(|e| Error::Internal(e.to_string()))
    }
}

/// The cells after the parameters.
fn cells(curve: &FragilityCurve, point: &FragilityPoint) -> impl Iterator<Item = String> {
    let counts = [point.cases, point.empty, point.exceeded].map(|count| count.to_string());
    let part = point.probability;
    let part = [
        part.map(|p| p.value),
        part.map(|p| p.low),
        part.map(|p| p.high),
    ];
    let fit = curve.fit.ok();
    let fit = [fit.map(|fit| fit.median), fit.map(|fit| fit.dispersion)];
    let reason = curve.fit.err().map_or(String::new(), |why| why.to_string());
    let numbers = part.into_iter().chain(fit).map(cell);
    counts.into_iter().chain(numbers).chain([reason])
}

fn failed(e: csv::Error) -> Error {
    Error::Internal(e.to_string())
}
