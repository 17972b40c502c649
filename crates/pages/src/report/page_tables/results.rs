//! The table of results, as columns that the script of the page shows, sorts and filters.

use super::compressed_column::Column;
use crate::report::text::{escape, printable};
use crate::report::{Detail, packed};
use serde_json::{Value as Json, json};
use slipgap_batch::Outcome;
use slipgap_problem::problem::numbers::parameter::{Kind, Value};
use slipgap_study::Study;
use std::io::{self, Write};
use std::path::PathBuf;

/// Largest size of the results of a page in bytes, before they are encoded as text, which is a third longer: half a million
/// cases with ten metrics.
pub const MOST_BYTES: usize = 40 << 20;

/// Largest number of rows of a table; browsers sort as many in a few seconds.
const MOST_ROWS: u64 = 1_000_000;

/// Number of rows of a shortened table.
const SHORTENED: u64 = 1000;

/// The results of a study: every case, or the first of too many.
#[derive(Debug)]
pub struct Results<'a> {
    study: &'a Study,
    /// The folder with all cases.
    store: PathBuf,
    /// Rows of the parameters that are columns.
    parameters: Vec<usize>,
    /// Parameters, then the metrics of the study.
    columns: Vec<Column>,
    /// The first value of each column, and whether a different one follows.
    varies: Vec<(f64, bool)>,
    cases: u64,
    largest: usize,
    complete: bool,
}

impl<'a> Results<'a> {
    /// No case yet, and a limit of the size in bytes.
    pub fn new(study: &'a Study, store: PathBuf, largest: usize) -> Results<'a> {
        let parameters = study.parameter_columns();
        let count = parameters.len() + study.columns.len();
        Results {
            study,
            store,
            parameters,
            columns: (0..count).map(|_| Column::new()).collect(),
            varies: vec![(f64::NAN, false); count],
            cases: 0,
            largest,
            complete: true,
        }
    }

    /// Adds the next case.
    pub fn add(&mut self, outcome: &Outcome) {
        let study = self.study;
        let table = study.problem.parameters();
        let rows = self.parameters.iter();
        let parameters = rows.map(|row| number(table[*row].kind, outcome.case.values[*row]));
        let metrics = study
            .columns
            .iter()
            .map(|m| outcome.metrics[*m].unwrap_or(f64::NAN));
        let in_table = self.complete || self.cases < SHORTENED;
        let columns = self.columns.iter_mut().zip(&mut self.varies);
        for (x, (column, (first, varies))) in parameters.chain(metrics).zip(columns) {
            if self.cases == 0 {
                *first = x;
            }
            *varies |= first.to_bits() != x.to_bits();
            if in_table {
                column.push(x);
            }
        }
        self.cases += 1;
        if self.complete && (self.cases > MOST_ROWS || self.bytes() > self.largest) {
            self.complete = false;
            self.columns
                .iter_mut()
                .for_each(|column| column.truncate(SHORTENED as usize));
        }
    }

    /// Size on the page in bytes, before the columns are encoded as text.
    pub fn bytes(&self) -> usize {
        self.columns.iter().map(Column::bytes).sum()
    }

    /// Number of all cases.
    pub fn cases(&self) -> u64 {
        self.cases
    }

    /// Writes the table and its data.
    pub fn write(&self, out: &mut impl Write, detail: Detail) -> io::Result<()> {
        let open = if detail == Detail::Whole { " open" } else { "" };
        let cases = match self.cases {
            1 => "1 case".to_owned(),
            cases => format!("{cases} cases"),
        };
        writeln!(
            out,
            "<details class=\"part\"{open}><summary>Results: {cases}</summary>"
        )?;
        if !self.complete {
            writeln!(out, "<p>{}.</p>", escape(&self.limit()))?;
        }
        let shown = self.shown(detail);
        if detail == Detail::Overview {
            let left_out = self.columns.len() - shown.len();
            let words = match left_out {
                0 => String::new(),
                1 => " and one metric more".to_owned(),
                more => format!(" and {more} metrics more"),
            };
            writeln!(
                out,
                "<p class=\"facts\">Metrics have six significant digits here; results.csv of the study has all digits{words}.</p>"
            )?;
        }
        out.write_all(
            b"<div class=\"results\">\n<div class=\"bar\">\
              <label>Filter <input type=\"search\" spellcheck=\"false\"></label>\
              <label><input type=\"checkbox\"> show columns that do not vary</label>\
              <button type=\"button\" class=\"back\">Back</button><button type=\"button\" class=\"next\">Next</button>\
              <output aria-live=\"polite\"></output></div>\n\
              <div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Results\"><table><thead><tr></tr></thead><tbody></tbody></table></div>\n",
        )?;
        let mut columns = Vec::new();
        let mut bytes = Vec::new();
        for index in shown {
            let rounded = detail == Detail::Overview && index >= self.parameters.len();
            let rounded_column = rounded.then(|| self.columns[index].rounded());
            let column = rounded_column.as_ref().unwrap_or(&self.columns[index]);
            column.encode(rounded, &mut bytes);
            columns.push(self.description(index, column, rounded));
        }
        packed::write(out, self.head(columns).to_string().as_bytes())?;
        packed::write(out, &bytes)?;
        out.write_all(b"</div></details>\n")
    }

    /// The columns on the page: of an overview those of parameters and of metrics that the study uses.
    fn shown(&self, detail: Detail) -> Vec<usize> {
        let columns = 0..self.columns.len();
        let first = self.parameters.len();
        let used = super::used::metrics(self.study);
        let is_shown =
            |index: &usize| *index < first || used.contains(&self.study.columns[*index - first]);
        match detail {
            Detail::Overview if !used.is_empty() => columns.filter(is_shown).collect(),
            Detail::Whole | Detail::Overview => columns.collect(),
        }
    }

    /// A sentence about a shortened table.
    fn limit(&self) -> String {
        format!(
            "This page has only the first {} of {} cases, so it cannot filter or sort; all cases are in {}",
            self.cases.min(SHORTENED),
            self.cases,
            printable(&self.store.display().to_string())
        )
    }

    /// The description of a column for the script.
    fn description(&self, index: usize, column: &Column, rounded: bool) -> Json {
        let (name, unit, meaning, names) = match self.parameters.get(index) {
            Some(row) => {
                let parameter = &self.study.problem.parameters()[*row];
                let name = parameter.column_name();
                (
                    name,
                    &*parameter.unit,
                    &*parameter.meaning,
                    names(parameter.kind),
                )
            }
            None => {
                let row = self.study.columns[index - self.parameters.len()];
                let metric = &self.study.measures[row];
                (&*metric.name, &*metric.unit, &*metric.meaning, Vec::new())
            }
        };
        json!({
            "name": name, "unit": unit, "meaning": meaning, "names": names, "varies": self.varies[index].1,
            "width": column.width(), "listed": column.listed(), "rounded": rounded,
        })
    }

    /// The description of the table for the script.
    fn head(&self, columns: Vec<Json>) -> Json {
        let rows = if self.complete {
            self.cases
        } else {
            self.cases.min(SHORTENED)
        };
        let limit = (!self.complete).then(|| self.limit());
        json!({ "cases": self.cases, "rows": rows, "limit": limit, "columns": columns })
    }
}

/// The names of a choice; none for numbers.
fn names(kind: Kind) -> Vec<&'static str> {
    match kind {
        Kind::Choice(choices) => choices.iter().map(|choice| choice.0).collect(),
        Kind::Number(_) | Kind::Whole { .. } => Vec::new(),
    }
}

/// A value as a number: the index in [`names`] of a name; NaN if the parameter does not apply.
fn number(kind: Kind, value: Option<Value>) -> f64 {
    match value {
        Some(Value::Name(name)) => {
            let index = names(kind).iter().position(|known| *known == name);
            index.map_or(f64::NAN, |index| index as f64)
        }
        Some(value) => value.as_f64().unwrap_or(f64::NAN),
        None => f64::NAN,
    }
}
