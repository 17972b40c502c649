//! The part of the page about one study.

use super::packed::write_part;
use super::text::{escape, verdict};
use super::{Checks, Counts, Detail, Drawing, Indices, Quantiles, Results};
use slipgap_problem::problem::Problem;
use slipgap_study::Study;
use std::io::{self, Write};

/// What the page shows of a study.
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

impl Section<'_> {
    /// The title of the study, or its name without one.
    pub fn title(&self) -> &str {
        match self.study.title.as_str() {
            "" => self.name,
            title => title,
        }
    }
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

/// Writes the part of the `i`-th study.
pub fn write(out: &mut impl Write, i: usize, section: &Section, detail: Detail) -> io::Result<()> {
    let study = section.study;
    write!(
        out,
        "<section class=\"study\" id=\"study-{i}\" aria-labelledby=\"title-{i}\">\n<h3 id=\"title-{i}\">{}</h3>\n\
         <p class=\"facts\">{} · {} · {} cases · SHA-256 of the study {}</p>\n",
        escape(section.title()),
        escape(&section.file),
        study.problem.name(),
        section.results.cases(),
        study.sha256,
    )?;
    section.checks.write(out, detail)?;
    section.counts.write(out)?;
    write_scales(out, &*study.problem)?;
    if !section.figures.is_empty() {
        out.write_all(b"<div class=\"figures\">\n")?;
        for figure in &section.figures {
            figure.write(out)?;
        }
        out.write_all(b"</div>\n")?;
    }
    section.indices.write(out, detail)?;
    if let Some(quantiles) = &section.quantiles {
        quantiles.write(out, detail)?;
    }
    write_claims(out, &section.claims, detail)?;
    section.results.write(out, detail)?;
    let text = format!("<pre>{}</pre>\n", escape(&section.text));
    write_part(out, "The study as given", false, text.as_bytes())?;
    out.write_all(b"</section>\n")
}

/// The scales of numbers and axes.
fn write_scales(out: &mut impl Write, problem: &dyn Problem) -> io::Result<()> {
    if problem.schema().scales.is_empty() {
        return Ok(());
    }
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

fn write_claims(out: &mut impl Write, claims: &[TestedReading], detail: Detail) -> io::Result<()> {
    if claims.is_empty() {
        return Ok(());
    }
    let mut html = String::from(
        "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Claims\"><table>\n\
          <thead><tr><th class=\"words\">claim</th><th class=\"words\">statement</th><th class=\"words\">reading</th>\
          <th class=\"words\">computed</th><th class=\"words\">verdict</th></tr></thead>\n<tbody>\n",
    );
    for claim in claims {
        let (class, word) = verdict(claim.holds, "holds", "fails");
        let cells: String = [&claim.id, &claim.statement, &claim.reading, &claim.computed]
            .iter()
            .map(|cell| {
                format!(
                    "<td class=\"words\">{}</td>",
                    escape(&cell.replace('`', ""))
                )
            })
            .collect();
        html += &format!("<tr>{cells}<td class=\"words {class}\">{word}</td></tr>\n");
    }
    html += "</tbody></table></div>\n";
    let hold = claims.iter().filter(|claim| claim.holds).count();
    let heading = format!(
        "Statements of the papers that this study tests: {hold} of {} hold",
        claims.len()
    );
    write_part(out, &heading, detail == Detail::Whole, html.as_bytes())
}
