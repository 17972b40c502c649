//! Sobol' indices on the page: the table of sobol.csv, rounded.

use crate::report::Detail;
use crate::report::packed::write_part;
use crate::report::text::escape;
use std::io::{self, Write};

/// The indices of the saltelli designs of a study.
#[derive(Debug, Default)]
pub struct Indices {
    rows: Vec<csv::StringRecord>,
}

impl Indices {
    /// From the content of sobol.csv, or from nothing.
    pub fn new(table: &[u8]) -> Indices {
        let mut reader = csv::Reader::from_reader(table);
        Indices {
            rows: reader.records().flatten().collect(),
        }
    }

    /// Writes the table.
    pub fn write(&self, out: &mut impl Write, detail: Detail) -> io::Result<()> {
        if self.rows.is_empty() {
            return Ok(());
        }
        let mut html = Vec::new();
        self.write_table(&mut html)?;
        write_part(out, "Sobol' indices", detail == Detail::Whole, &html)
    }

    fn write_table(&self, out: &mut impl Write) -> io::Result<()> {
        out.write_all(
            b"<p>An index is the share of the variance of a metric that a parameter causes: alone (first order), \
              or together with all others (total). The brackets show the middle 95 % of bootstrap samples. Cells are empty \
              if the metric is the same in all cases of the design, or undefined in one.</p>\n\
              <div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Sobol' indices\"><table>\n\
              <thead><tr><th>block</th><th class=\"words\">metric</th><th class=\"words\">parameter</th><th>first order</th>\
              <th>total</th></tr></thead>\n<tbody>\n",
        )?;
        for row in &self.rows {
            let cell = |column: usize| escape(row.get(column).unwrap_or_default());
            writeln!(
                out,
                "<tr><td>{}</td><td class=\"words\">{}</td><td class=\"words\">{}</td><td>{}</td><td>{}</td></tr>",
                cell(0),
                cell(1),
                cell(2),
                index(row, 3),
                index(row, 6)
            )?;
        }
        out.write_all(b"</tbody></table></div>\n")
    }
}

/// An index and its interval, in three columns from `column` on; nothing if the cells are empty.
fn index(row: &csv::StringRecord, column: usize) -> String {
    let number = |offset: usize| row.get(column + offset)?.parse::<f64>().ok();
    match (number(0), number(1), number(2)) {
        (Some(value), Some(low), Some(high)) => format!("{value:.3} ({low:.3} to {high:.3})"),
        _ => String::new(),
    }
}
