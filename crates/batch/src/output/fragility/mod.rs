//! fragility.csv: the points of every fragility figure, with the function of their curve. fragility_members.csv: what each
//! member of the ensemble adds to the mean annual frequency.

mod curve_columns;

use super::Folder;
use super::failures_and_histories::cell;
use super::names::{FRAGILITY, MEMBERS};
use crate::groups::fragility::FragilityCurve;
use crate::groups::point::FragilityPoint;
use curve_columns::Numbers;
use slipgap_problem::problem::numbers::parameter::{Kind, Value};
use slipgap_study::error::Error;
use slipgap_study::kinds::Fragility;
use slipgap_study::{ColumnRef, Figure, Study};
use std::path::PathBuf;

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

/// The last columns of the members.
const SHARES: [&str; 4] = ["capacity_low", "capacity_high", "frequency", "share"];

/// Both tables, figure by figure.
pub struct FragilityTable<'a> {
    study: &'a Study,
    /// Rows of the measures that are along an axis; each has a column.
    measures: Vec<usize>,
    /// The last columns.
    numbers: Numbers,
    /// Rows of the parameters that are columns: all that vary outside of the ensemble.
    parameters: Vec<usize>,
    writer: csv::Writer<Vec<u8>>,
    /// Of the members; without rows if no figure has a hazard curve.
    members: csv::Writer<Vec<u8>>,
    has_members: bool,
}

impl<'a> FragilityTable<'a> {
    /// The header; `None` for a study without a fragility figure.
    ///
    /// # Errors
    /// A table that cannot be made.
    pub fn new(study: &'a Study) -> Result<Option<FragilityTable<'a>>, Error> {
        let kind = |figure: &'a Figure| figure.kind.fragility();
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
        let numbers = Numbers::new(&figures);
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
        let header = COLUMNS.0.into_iter().chain(names.clone()).chain(places);
        let last = numbers.names(study);
        let header = header
            .chain(COLUMNS.1)
            .chain(last.iter().map(|name| &**name));
        writer.write_record(header).map_err(failed)?;
        let mut members = csv::Writer::from_writer(Vec::new());
        let ensemble_names = study.ensemble.iter().map(|row| table[*row].column_name());
        let header = COLUMNS
            .0
            .into_iter()
            .chain(names)
            .chain(ensemble_names)
            .chain(SHARES);
        members.write_record(header).map_err(failed)?;
        Ok(Some(FragilityTable {
            study,
            measures,
            numbers,
            parameters,
            writer,
            members,
            has_members: figures.iter().any(|figure| !figure.hazard.is_empty()),
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
            let last = self.numbers.of(figure, curve);
            for point in &curve.points {
                let at = self.place(figure, point.at);
                let values = self.values(figure, curve, &at);
                let cell = |row: &usize| match figure.x == ColumnRef::Metric(*row) {
                    true => at.clone(),
                    false => String::new(),
                };
                let row = first
                    .iter()
                    .cloned()
                    .chain(values)
                    .chain(self.measures.iter().map(cell))
                    .chain(cells(curve, point))
                    .chain(last.iter().cloned());
                self.writer.write_record(row).map_err(failed)?;
            }
            for share in curve.annual.iter().flat_map(|annual| &annual.shares) {
                let values = self.values(figure, curve, "");
                let of_member = share.member.iter();
                let member = of_member.map(|value| value.map(|v| v.cell()).unwrap_or_default());
                let [low, high] = share.capacity;
                let numbers = [low, high, share.frequency, share.share]
                    .map(Some)
                    .map(cell);
                let row = first
                    .iter()
                    .cloned()
                    .chain(values)
                    .chain(member)
                    .chain(numbers);
                self.members.write_record(row).map_err(failed)?;
            }
        }
        Ok(())
    }

    /// The place of a point along the axis, with the type of its column.
    fn place(&self, figure: &Fragility, at: f64) -> String {
        let table = self.study.problem.parameters();
        match figure.parameter().map(|row| table[row].kind) {
            Some(Kind::Whole { .. }) if at.fract() == 0.0 => Value::Whole(at as u64).cell(),
            Some(_) | None => cell(Some(at).filter(|at| !at.is_nan())),
        }
    }

    /// The values of the parameters of a curve; `at` is that along the axis.
    fn values(&self, figure: &Fragility, curve: &FragilityCurve, at: &str) -> Vec<String> {
        let value = |row: &usize| match figure.parameter() == Some(*row) {
            true => at.to_owned(),
            false => {
                let value = curve.shared.get(*row).copied().flatten();
                value.map(|value| value.cell()).unwrap_or_default()
            }
        };
        self.parameters.iter().map(value).collect()
    }

    /// Writes the files, and returns their paths.
    ///
    /// # Errors
    /// A table that cannot be made.
    pub fn write(self, folder: &mut Folder) -> Result<Vec<PathBuf>, Error> {
        let tables = [(FRAGILITY, self.writer), (MEMBERS, self.members)]
            .into_iter()
            .take(1 + usize::from(self.has_members));
        let write = |(name, table): (&str, csv::Writer<Vec<u8>>)| {
            let bytes = table.into_inner();
            folder.write(name, &bytes.map_err(|e| Error::Internal(e.to_string()))?)
        };
        tables.map(write).collect()
    }
}

/// The cells after the parameters.
fn cells(curve: &FragilityCurve, point: &FragilityPoint) -> impl Iterator<Item = String> {
    let counts = [point.cases, point.empty, point.exceeded].map(|count| count.to_string());
    let probability = point.probability;
    let part = [
        probability.map(|p| p.value),
        probability.map(|p| p.low),
        probability.map(|p| p.high),
    ];
    let function = curve.function();
    let fit = [
        function.map(|fit| fit.median),
        function.map(|fit| fit.dispersion),
    ];
    let why = curve.fit.as_ref().err();
    let reason = why.map_or(String::new(), |why| why.to_string());
    let numbers = part.into_iter().chain(fit).map(cell);
    counts.into_iter().chain(numbers).chain([reason])
}

fn failed(e: csv::Error) -> Error {
    Error::Internal(e.to_string())
}
