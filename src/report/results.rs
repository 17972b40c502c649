//! The table of results, as columns that the script of the page draws, sorts and filters.

use super::column::Column;
use super::text::{escape, printable};
use crate::batch::Outcome;
use crate::problem::parameter::{Kind, Value};
use crate::study::Study;
use serde_json::{Value as Json, json};
use std::io::{self, Write};
use std::path::PathBuf;

/// Bytes that the results of a page take before they are written as text, which takes a third more: half a million cases
/// with ten metrics.
pub const MOST_BYTES: usize = 40 << 20;

/// Most rows of a table that browsers sort in a few seconds.
const MOST_ROWS: u64 = 1_000_000;

/// Rows of a table that is too large for the page.
const FIRST: u64 = 1000;

/// The results of a study: every case, or the first of too many.
#[derive(Debug)]
pub struct Results<'a> {
    study: &'a Study,
    /// Where all cases are kept.
    store: PathBuf,
    /// Rows of the parameters that are columns.
    parameters: Vec<usize>,
    /// Parameters, then the study's metrics.
    columns: Vec<Column>,
    /// Of each column the first value, and whether another one followed.
    varies: Vec<(f64, bool)>,
    cases: u64,
    most: usize,
    whole: bool,
}

impl<'a> Results<'a> {
    /// No case yet; at most `most` bytes of a page.
    pub fn new(study: &'a Study, store: PathBuf, most: usize) -> Results<'a> {
        let parameters = study.parameter_columns();
        let count = parameters.len() + study.columns.len();
        Results {
            study,
            store,
            parameters,
            columns: (0..count).map(|_| Column::new()).collect(),
            varies: vec![(f64::NAN, false); count],
            cases: 0,
            most,
            whole: true,
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
        let kept = self.whole || self.cases < FIRST;
        let columns = self.columns.iter_mut().zip(&mut self.varies);
        for (x, (column, (first, varies))) in parameters.chain(metrics).zip(columns) {
            if self.cases == 0 {
                *first = x;
            }
            *varies |= first.to_bits() != x.to_bits();
            if kept {
                column.push(x);
            }
        }
        self.cases += 1;
        if self.whole && (self.cases > MOST_ROWS || self.bytes() > self.most) {
            self.whole = false;
            self.columns
                .iter_mut()
                .for_each(|column| column.truncate(FIRST as usize));
        }
    }

    /// Bytes that they take on the page, before they are written as text.
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
        if !self.whole {
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
        // A script ends at the first `</`, wherever it stands.
        let head = self.head().to_string().replace('<', "\\u003c");
        writeln!(out, "<script type=\"application/json\">{head}</script>")?;
        for column in &self.columns {
            out.write_all(b"<script type=\"text/plain\">")?;
            column.write(out)?;
            out.write_all(b"</script>\n")?;
        }
        out.write_all(b"</div>\n")
    }

    /// What the page holds where it does not hold all.
    fn limit(&self) -> String {
        format!(
            "This page has only the first {} of {} cases, so it cannot filter or sort; all cases are in {}",
            self.cases.min(FIRST),
            self.cases,
            printable(&self.store.display().to_string())
        )
    }

    /// What the script has to know of the columns.
    fn head(&self) -> Json {
        let problem = &self.study.problem;
        let parameters = self
            .parameters
            .iter()
            .map(|row| &problem.parameters()[*row]);
        let parameters = parameters.map(|p| (&*p.name, &*p.unit, &*p.meaning, names(p.kind)));
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
        let rows = if self.whole {
            self.cases
        } else {
            self.cases.min(FIRST)
        };
        let limit = (!self.whole).then(|| self.limit());
        json!({ "cases": self.cases, "rows": rows, "limit": limit, "columns": columns })
    }
}

/// The names that a parameter takes; none for numbers.
fn names(kind: Kind) -> Vec<&'static str> {
    match kind {
        Kind::Choice(choices) => choices.iter().map(|choice| choice.0).collect(),
        Kind::Number(_) | Kind::Whole { .. } => Vec::new(),
    }
}

/// A value as a number: of a name, its place in [`names`]; NaN where the parameter does not apply.
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
