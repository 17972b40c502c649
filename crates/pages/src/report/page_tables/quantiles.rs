//! Distributions over ensembles on the page: the table of quantiles.csv, rounded.

use crate::report::Detail;
use crate::report::packed::write_part;
use crate::report::text::escape;
use slipgap_batch::output::ensemble::{Distribution, EnsembleMetrics};
use std::io::{self, Write};

/// Largest number of rows that a page about one study shows.
const MOST: usize = 1000;

/// The same for a page about several.
const MOST_OF_SEVERAL: usize = 200;

/// The distributions of the metrics of a study over its ensembles.
#[derive(Debug)]
pub struct Quantiles {
    /// The names of metric and parameters.
    names: Vec<String>,
    /// Metric and values of the parameters, with the distribution; the first ones.
    rows: Vec<(Vec<String>, Distribution)>,
    /// Number of all rows.
    all: usize,
}

impl Quantiles {
    /// From the collected metrics.
    pub fn new(ensembles: &EnsembleMetrics) -> Quantiles {
        let mut rows = Vec::new();
        // The rows end early, which is no error.
        let _ = ensembles.quantiles(|names, of| {
            rows.push((names, of));
            if rows.len() < MOST { Ok(()) } else { Err(()) }
        });
        Quantiles {
            names: ensembles.name_columns(),
            rows,
            all: ensembles.quantile_rows(),
        }
    }

    /// Writes the table.
    pub fn write(&self, out: &mut impl Write, detail: Detail) -> io::Result<()> {
        let mut html = Vec::new();
        self.write_table(&mut html, detail)?;
        let heading = "Distributions over the ensemble";
        write_part(out, heading, detail == Detail::Whole, &html)
    }

    fn write_table(&self, out: &mut impl Write, detail: Detail) -> io::Result<()> {
        let rows = match detail {
            Detail::Whole => &self.rows[..],
            Detail::Overview => &self.rows[..self.rows.len().min(MOST_OF_SEVERAL)],
        };
        out.write_all(
            b"<p>Of every metric over the cases of an ensemble: the median with its 95 % \
              interval, quantiles, the smallest and the largest value. Empty values are counted and left out.</p>\n",
        )?;
        if self.all > rows.len() {
            let shown = rows.len();
            writeln!(
                out,
                "<p>The first {shown} of {} rows; quantiles.csv has all.</p>",
                self.all
            )?;
        }
        out.write_all(
            b"<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Distributions over the ensemble\"><table>\n<thead><tr>",
        )?;
        for name in &self.names {
            write!(out, "<th class=\"words\">{}</th>", escape(name))?;
        }
        out.write_all(
            b"<th>cases</th><th>empty</th><th>median</th><th>16 % to 84 %</th><th>5 % to 95 %</th><th>all</th></tr></thead>\n<tbody>\n",
        )?;
        for (names, of) in rows {
            let names: String = names
                .iter()
                .map(|name| format!("<td class=\"words\">{}</td>", escape(name)))
                .collect();
            let [min, q05, q16, _, median, _, q84, q95, max] = of.quantiles;
            let [cases, empty] = of.counts;
            let ends = range(of.moments[2], of.moments[3]);
            let interval = match ends.as_str() {
                "" => ends,
                ends => format!(" ({ends})"),
            };
            writeln!(
                out,
                "<tr>{names}<td>{cases}</td><td>{empty}</td><td>{}{interval}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
                median.map(rounded).unwrap_or_default(),
                range(q16, q84),
                range(q05, q95),
                range(min, max)
            )?;
        }
        out.write_all(b"</tbody></table></div>\n")
    }
}

/// Two numbers; nothing if there are none.
fn range(low: Option<f64>, high: Option<f64>) -> String {
    match (low, high) {
        (Some(low), Some(high)) => format!("{} to {}", rounded(low), rounded(high)),
        _ => String::new(),
    }
}

/// A number with four digits.
fn rounded(x: f64) -> String {
    let rounded: f64 = format!("{x:.3e}").parse().unwrap_or(x);
    slipgap_problem::problem::numbers::parameter::shortest(rounded)
}
