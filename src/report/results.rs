//! The table of results, as columns that the script of the page shows, sorts and filters.

use super::column::Column;
use super::text::{escape, printable};
use crate::batch::Outcome;
use serde_json::{Value as Json, json};
use slipgap_solver::problem::parameter::{Kind, Value};
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
        let parameters = self.parameters.iter();
        let parameters = parameters.map(|row| number(table[*row].kind, outcome.case.values[*row]));
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
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        out.write_all(b"<h3>Results</h3>\n")?;
        if !self.complete {
            writeln!(out, "<p>{}.</p>", escape(&self.limit()))?;
        }
        out.write_all(
            b"<div class=\"results\">\n<div class=\"bar\">\
              <label>Filter <input type=\"search\" spellcheck=\"false\"></label>\
              <label><input type=\"checkbox\"> show columns that do not vary</label>\
              <button type=\"button\" class=\"back\">Back</button><button type=\"button\" class=\"next\">Next</button>\
              <output aria-live=\"polite\"></output></div>\n\
              <div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Results\"><table><thead><tr></tr></thead><tbody></tbody></table></div>\n",
        )?;
        // A script element ends at the first `</`, also in a string.
        let head = self.head().to_string().replace('<', "\\u003c");
        writeln!(out, "<script type=\"application/json\">{head}</script>")?;
        for column in &self.columns {
            out.write_all(b"<script type=\"text/plain\">")?;
            column.write(out)?;
            out.write_all(b"</script>\n")?;
        }
        out.write_all(b"</div>\n")
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

    /// The description of the columns for the script.
    fn head(&self) -> Json {
        let problem = &self.study.problem;
        let parameters = self
            .parameters
            .iter()
            .map(|row| &problem.parameters()[*row]);
        let parameters =
            parameters.map(|p| (p.column_name(), &*p.unit, &*p.meaning, names(p.kind)));
        let metrics = self.study.columns.iter().map(|m| &self.study.measures[*m]);
        let metrics = metrics.map(|m| (&*m.name, &*m.unit, &*m.meaning, Vec::new()));
        let columns = parameters
            .chain(metrics)
            .zip(&self.columns)
            .zip(&self.varies);
        let columns = columns.map(|(((name, unit, meaning, names), column), (_, varies))| {
            json!({
                "name": name, "unit": unit, "meaning": meaning, "names": names, "varies": varies,
                "width": column.width(), "list": column.list(),
            })
        });
        let columns: Vec<Json> = columns.collect();
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
            let place = names(kind).iter().position(|known| *known == name);
            place.map_or(f64::NAN, |place| place as f64)
        }
        Some(value) => value.as_f64().unwrap_or(f64::NAN),
        None => f64::NAN,
    }
}
