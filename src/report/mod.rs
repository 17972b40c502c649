//! One page about studies that needs nothing beside it: figures, tables to sort and filter, checks, claims, and the
//! studies as given.

use std::fmt::Write;

use crate::batch::Outcome;
use crate::checks::Verdict;
use crate::problem::parameter::Value;
use crate::study::Study;
use serde_json::{Value as Json, json};

const STYLE: &str = include_str!("report.css");
const SCRIPT: &str = include_str!("report.js");

/// Most rows of a table on the page.
pub const MOST_ROWS: usize = 20_000;

/// What the page says of one study.
pub struct Section<'a> {
    /// Its name, as in `claims/impact-once`.
    pub name: &'a str,
    /// Its file.
    pub file: String,
    /// The file's text.
    pub text: String,
    /// The study.
    pub study: &'a Study,
    /// Name and SVG of every figure.
    pub figures: Vec<(String, String)>,
    /// Its first cases, at most [`MOST_ROWS`].
    pub outcomes: Vec<(u64, Outcome)>,
    /// Number of all cases.
    pub cases: u64,
    /// Its checks.
    pub verdicts: Vec<Verdict>,
    /// The claims that it settles.
    pub claims: Vec<Settled>,
}

/// A reading of a claim that a study settles.
pub struct Settled {
    /// The claim's short name.
    pub id: String,
    /// The sentence.
    pub says: String,
    /// What is assumed.
    pub reading: String,
    /// What was found.
    pub found: String,
    /// Whether it holds.
    pub holds: bool,
}

/// The page.
pub fn page(sections: &[Section]) -> String {
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>slipgap report</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<header>\n\
         <h1>slipgap report</h1>\n<p class=\"facts\">slipgap {}, {} {}</p>\n</header>\n",
        env!("CARGO_PKG_VERSION"),
        sections.len(),
        if sections.len() == 1 {
            "study"
        } else {
            "studies"
        },
    );
    page += "<nav aria-label=\"Studies\"><ul>\n";
    for (i, section) in sections.iter().enumerate() {
        let title = escape(title(section));
        let _ = writeln!(page, "<li><a href=\"#study-{i}\">{title}</a></li>");
    }
    page += "</ul></nav>\n<main>\n";
    for (i, section) in sections.iter().enumerate() {
        one(&mut page, i, section);
    }
    let _ = write!(
        page,
        "</main>\n<script>\n{SCRIPT}</script>\n</body>\n</html>\n"
    );
    page
}

fn title<'a>(section: &'a Section) -> &'a str {
    match section.study.title.as_str() {
        "" => section.name,
        title => title,
    }
}

fn one(page: &mut String, i: usize, section: &Section) {
    let study = section.study;
    let _ = write!(
        page,
        "<section id=\"study-{i}\" aria-labelledby=\"title-{i}\">\n<h2 id=\"title-{i}\">{}</h2>\n\
         <p class=\"facts\">{} · {} · {} cases · SHA-256 {}</p>\n",
        escape(title(section)),
        escape(&section.file),
        study.problem.name(),
        section.cases,
        study.sha256,
    );
    for (name, svg) in &section.figures {
        let name = escape(name);
        let _ = write!(
            page,
            "<figure>\n{svg}<figcaption>{name}</figcaption>\n</figure>\n"
        );
    }
    checks(page, &section.verdicts);
    claims(page, &section.claims);
    results(page, section);
    let _ = write!(
        page,
        "<details><summary>The study as given</summary><pre>{}</pre></details>\n</section>\n",
        escape(&section.text)
    );
}

fn checks(page: &mut String, verdicts: &[Verdict]) {
    if verdicts.is_empty() {
        return;
    }
    let met = verdicts.iter().filter(|verdict| verdict.holds()).count();
    let _ = write!(
        page,
        "<h3>Checks: {met} of {} met</h3>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Checks\"><table>\n\
         <thead><tr><th>case</th><th class=\"words\">metric</th><th>value</th><th class=\"words\">limits</th><th class=\"words\">verdict</th></tr></thead>\n<tbody>\n",
        verdicts.len()
    );
    for verdict in verdicts {
        let value = verdict.value.map_or("undefined".into(), |x| x.to_string());
        let (class, word) = said(verdict.holds(), "met", "not met");
        let _ = writeln!(
            page,
            "<tr><td>{}</td><td class=\"words\">{}</td><td>{value}</td><td class=\"words\">{}</td><td class=\"words {class}\">{word}</td></tr>",
            verdict.case,
            verdict.metric,
            escape(&verdict.limits())
        );
    }
    *page += "</tbody></table></div>\n";
}

fn claims(page: &mut String, claims: &[Settled]) {
    if claims.is_empty() {
        return;
    }
    *page += "<h3>Sentences of the papers that it settles</h3>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Claims\"><table>\n\
              <thead><tr><th class=\"words\">claim</th><th class=\"words\">sentence</th><th class=\"words\">reading</th>\
              <th class=\"words\">found</th><th class=\"words\">verdict</th></tr></thead>\n<tbody>\n";
    for claim in claims {
        let (class, word) = said(claim.holds, "holds", "fails");
        let cells = [&claim.id, &claim.says, &claim.reading, &claim.found];
        let cells: String = cells
            .iter()
            .map(|cell| {
                format!(
                    "<td class=\"words\">{}</td>",
                    escape(&cell.replace('`', ""))
                )
            })
            .collect();
        let _ = writeln!(
            page,
            "<tr>{cells}<td class=\"words {class}\">{word}</td></tr>"
        );
    }
    *page += "</tbody></table></div>\n";
}

/// Class and word of a verdict; it is told by the word, not by colour alone.
fn said(holds: bool, yes: &'static str, no: &'static str) -> (&'static str, &'static str) {
    if holds { ("holds", yes) } else { ("fails", no) }
}

/// The table of results, as data that the script draws.
fn results(page: &mut String, section: &Section) {
    let study = section.study;
    let parameters = study.problem.parameters().iter();
    let parameters = parameters.map(|p| (p.name, p.unit, p.meaning));
    let metrics = study.metrics.iter().map(|m| &study.problem.metrics()[*m]);
    let metrics = metrics.map(|m| (m.name, m.unit, m.meaning));
    let all = [("case", "1", "number of the case, from 0")].into_iter();
    let columns: Vec<Json> = all
        .chain(parameters)
        .chain(metrics)
        .map(|(name, unit, meaning)| json!({ "name": name, "unit": unit, "meaning": meaning }))
        .collect();
    let row = |(number, outcome): &(u64, Outcome)| -> Json {
        let value = |value: &Option<Value>| match value {
            Some(Value::Number(x)) => json!(x),
            Some(Value::Whole(n)) => json!(n),
            Some(Value::Name(name)) => json!(name),
            None => Json::Null,
        };
        let metric = |m: &usize| outcome.metrics[*m].map_or(Json::Null, |x| json!(x));
        let cells = [json!(number)].into_iter();
        let cells = cells.chain(outcome.case.values.iter().map(value));
        cells.chain(study.metrics.iter().map(metric)).collect()
    };
    let rows: Vec<Json> = section.outcomes.iter().map(row).collect();
    // A script ends at the first `</`, wherever it stands.
    let data = json!({ "columns": columns, "rows": rows })
        .to_string()
        .replace('<', "\\u003c");
    let more = match section.cases as usize > section.outcomes.len() {
        true => format!(
            " <span>(the first {}; all are in the store)</span>",
            section.outcomes.len()
        ),
        false => String::new(),
    };
    let _ = write!(
        page,
        "<h3>Results{more}</h3>\n<div class=\"results\">\n<div class=\"bar\">\
         <label>Filter <input type=\"search\" placeholder=\"gamma&gt;0.5 n=10 lumped\"></label>\
         <label><input type=\"checkbox\"> columns that do not vary, too</label>\
         <button type=\"button\" class=\"back\">Back</button><button type=\"button\" class=\"next\">Next</button>\
         <output aria-live=\"polite\"></output></div>\n\
         <div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Results\"><table><thead><tr></tr></thead><tbody></tbody></table></div>\n\
         <script type=\"application/json\">{data}</script>\n</div>\n"
    );
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}
