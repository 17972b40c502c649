//! One page about studies that needs no other file: figures, tables to sort and filter, checks, claims, and the text of the
//! studies.

mod checks;
mod column;
mod counts;
mod drawing;
mod indices;
mod quantiles;
mod results;
pub(crate) mod text;

pub use checks::Checks;
pub use counts::Counts;
pub use drawing::Drawing;
pub use indices::Indices;
pub use quantiles::Quantiles;
pub use results::{MOST_BYTES, Results};

use crate::batch::key::SOLVER_VERSION;
use slipgap_solver::problem::Problem;
use slipgap_study::Study;
use std::io::{self, Write};
use text::{escape, verdict};

const STYLE: &str = include_str!("report.css");

/// In the order of their dependencies.
const SCRIPTS: [&str; 4] = [
    include_str!("columns.js"),
    include_str!("filter.js"),
    include_str!("table.js"),
    include_str!("report.js"),
];

/// The part of the page about one study.
pub struct Section<'a> {
    /// Its name, as in `claims/impact-once`.
    pub name: &'a str,
    /// Its file.
    pub file: String,
    /// The file's text.
    pub text: String,
    /// The study.
    pub study: &'a Study,
    /// Its figures.
    pub figures: Vec<Drawing>,
    /// Its cases.
    pub results: Results<'a>,
    /// Numbers of cases without results.
    pub counts: Counts,
    /// The indices of its saltelli designs.
    pub indices: Indices,
    /// The distributions of its metrics over ensembles, if it has some.
    pub quantiles: Option<Quantiles>,
    /// Its checks.
    pub checks: Checks,
    /// The readings that it tests.
    pub claims: Vec<TestedReading>,
}

/// A reading of a claim, tested by a study.
pub struct TestedReading {
    /// The claim's short name.
    pub id: String,
    /// The statement of the paper.
    pub statement: String,
    /// The name of the reading.
    pub reading: String,
    /// The values that were computed.
    pub computed: String,
    /// Whether it holds.
    pub holds: bool,
}

/// Writes the page.
///
/// # Errors
/// Those of `out`.
pub fn write(out: &mut impl Write, sections: &[Section]) -> io::Result<()> {
    write!(
        out,
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>slipgap report</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<header>\n\
         <h1>slipgap report</h1>\n<p class=\"facts\">slipgap {}, solver {SOLVER_VERSION}, {} {}</p>\n</header>\n",
        env!("CARGO_PKG_VERSION"),
        sections.len(),
        if sections.len() == 1 {
            "study"
        } else {
            "studies"
        },
    )?;
    out.write_all(b"<nav aria-label=\"Studies\"><ul>\n")?;
    for (i, section) in sections.iter().enumerate() {
        let title = escape(title(section));
        writeln!(out, "<li><a href=\"#study-{i}\">{title}</a></li>")?;
    }
    out.write_all(b"</ul></nav>\n<main>\n")?;
    for (i, section) in sections.iter().enumerate() {
        write_section(out, i, section)?;
    }
    let scripts = SCRIPTS.concat();
    write!(
        out,
        "</main>\n<script>\n\"use strict\";\n{scripts}</script>\n</body>\n</html>\n"
    )
}

fn title<'a>(section: &'a Section) -> &'a str {
    match section.study.title.as_str() {
        "" => section.name,
        title => title,
    }
}

fn write_section(out: &mut impl Write, i: usize, section: &Section) -> io::Result<()> {
    let study = section.study;
    write!(
        out,
        "<section id=\"study-{i}\" aria-labelledby=\"title-{i}\">\n<h2 id=\"title-{i}\">{}</h2>\n\
         <p class=\"facts\">{} · {} · {} cases · SHA-256 of the study {}</p>\n",
        escape(title(section)),
        escape(&section.file),
        study.problem.name(),
        section.results.cases(),
        study.sha256,
    )?;
    write_scales(out, &*study.problem)?;
    section.counts.write(out)?;
    for figure in &section.figures {
        figure.write(out)?;
    }
    section.indices.write(out)?;
    if let Some(quantiles) = &section.quantiles {
        quantiles.write(out)?;
    }
    section.checks.write(out)?;
    write_claims(out, &section.claims)?;
    section.results.write(out)?;
    write!(
        out,
        "<details><summary>The study as given</summary><pre>{}</pre></details>\n</section>\n",
        escape(&section.text)
    )
}

/// The scales of numbers and axes.
fn write_scales(out: &mut impl Write, problem: &dyn Problem) -> io::Result<()> {
    out.write_all(b"<dl class=\"scales\">\n")?;
    for [symbol, meaning] in problem.schema().scales.iter() {
        writeln!(
            out,
            "<dt>{}</dt><dd>{}</dd>",
            escape(symbol),
            escape(meaning)
        )?;
    }
    out.write_all(b"</dl>\n")
}

fn write_claims(out: &mut impl Write, claims: &[TestedReading]) -> io::Result<()> {
    if claims.is_empty() {
        return Ok(());
    }
    out.write_all(
        b"<h3>Statements of the papers that this study tests</h3>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Claims\"><table>\n\
          <thead><tr><th class=\"words\">claim</th><th class=\"words\">statement</th><th class=\"words\">reading</th>\
          <th class=\"words\">computed</th><th class=\"words\">verdict</th></tr></thead>\n<tbody>\n",
    )?;
    for claim in claims {
        let (class, word) = verdict(claim.holds, "holds", "fails");
        let cells = [&claim.id, &claim.statement, &claim.reading, &claim.computed];
        let cells: String = cells
            .iter()
            .map(|cell| {
                format!(
                    "<td class=\"words\">{}</td>",
                    escape(&cell.replace('`', ""))
                )
            })
            .collect();
        writeln!(
            out,
            "<tr>{cells}<td class=\"words {class}\">{word}</td></tr>"
        )?;
    }
    out.write_all(b"</tbody></table></div>\n")
}
