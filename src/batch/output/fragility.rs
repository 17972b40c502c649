//! fragility.csv: the points of every fragility figure, with the function of their curve.

use super::tables::cell;
use crate::batch::groups::fragility::FragilityCurve;
use crate::batch::groups::point::FragilityPoint;
use slipgap_study::error::Error;
use slipgap_study::kinds::{FigureKind, Fit, Fragility};
use slipgap_study::{ColumnRef, Figure, Study};

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

/// The last columns, if a figure has curves with intervals.
const INTERVALS: [&str; 4] = [
    "median_low",
    "median_high",
    "dispersion_low",
    "dispersion_high",
];

/// fragility.csv, figure by figure.
pub struct FragilityTable<'a> {
    study: &'a Study,
    /// Rows of the measures that are along an axis; each has a column.
    measures: Vec<usize>,
    /// Whether a curve may have intervals of its function.
    intervals: bool,
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
        let kind = |figure: &'a Figure| match &figure.kind {
            FigureKind::Fragility(fragility) => Some(fragility),
            _ => None,
        };
        let figures: Vec<&Fragility> = study.figures.iter().filter_map(kind).collect();
        if figures.is_empty() {
            return Ok(None);
        }
        let along = figures.iter().filter_map(|figure| figure.parameter());
        let measure = |figure: &&Fragility| match figure.x {
            ColumnRef::Metric(row) => Some(row),
            ColumnRef::Parameter(_) => None,
        };
        let mut measures: Vec<usize> = figures.iter().filter_map(measure).collect();
        measures.sort_unstable();
        measures.dedup();
        let intervals = figures.iter().any(|figure| figure.fit != Fit::Likelihood);
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
        let places = measures.iter().map(|row| &*study.measures[*row].name);
        let header = COLUMNS.0.into_iter().chain(names).chain(places);
        let more = INTERVALS.into_iter().filter(|_| intervals);
        let header = header.chain(COLUMNS.1).chain(more);
        writer.write_record(header).map_err(failed)?;
        Ok(Some(FragilityTable {
            study,
            measures,
            intervals,
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
                let at = cell(Some(point.at).filter(|at| !at.is_nan()));
                let value = |row: &usize| match figure.parameter() == Some(*row) {
                    true => at.clone(),
                    false => {
                        let value = curve.shared.get(*row).copied().flatten();
                        value.map(|value| value.to_string()).unwrap_or_default()
                    }
                };
                let values = self.parameters.iter().map(value);
                let place = |row: &usize| match figure.x == ColumnRef::Metric(*row) {
                    true => at.clone(),
                    false => String::new(),
                };
                let ends = curve
                    .intervals
                    .unwrap_or([[f64::NAN; 2]; 2])
                    .into_iter()
                    .flatten();
                let ends = ends.filter(|_| self.intervals);
                let ends = ends.map(|end| cell(Some(end).filter(|end| !end.is_nan())));
                let row = first
                    .iter()
                    .cloned()
                    .chain(values)
                    .chain(self.measures.iter().map(place))
                    .chain(cells(curve, point))
                    .chain(ends);
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
