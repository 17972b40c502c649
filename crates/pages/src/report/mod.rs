//! One page about studies that needs no other file: checks and warnings first, an index with search, and for each study its figures,
//! tables to sort and filter, claims and text.
//!
//! Figures and tables are compressed in the page and unpacked when they are shown. A page about several studies is an
//! overview: its tables of results have the metrics that each study uses, to six digits.

mod checks;
mod counts;
mod decimal;
mod drawing;
mod index;
mod packed;
mod page_tables;
mod section;
mod summary;
pub(crate) mod text;

pub use checks::Checks;
pub use counts::Counts;
pub use drawing::Drawing;
pub use page_tables::indices::Indices;
pub use page_tables::quantiles::Quantiles;
pub use page_tables::results::{MOST_BYTES, Results};
pub use section::{Section, TestedReading};

use drawing::glyphs::Glyphs;
use index::Index;
use slipgap_batch::store::key::SOLVER_VERSION;
use std::io::{self, Write};
use text::POLICY;

const STYLE: &str = include_str!("page/report.css");

/// In the order of their dependencies.
const SCRIPTS: [&str; 6] = [
    include_str!("page/packed.js"),
    include_str!("page/columns.js"),
    include_str!("page/filter.js"),
    include_str!("page/table.js"),
    include_str!("page/index.js"),
    include_str!("page/report.js"),
];

/// How much of its studies a page has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Detail {
    /// All metrics with all digits: a page about one study.
    Whole,
    /// The metrics that each study uses, to six digits: a page about several.
    Overview,
}

/// Writes the page.
///
/// # Errors
/// Those of `out`.
pub fn write(out: &mut impl Write, sections: &mut [Section]) -> io::Result<()> {
    let mut glyphs = Glyphs::default();
    let drawings = sections.iter_mut().flat_map(|section| &mut section.figures);
    drawings.for_each(|drawing| drawing.take_glyphs(&mut glyphs));
    let sections = &*sections;
    let (studies, detail) = match sections.len() {
        1 => ("1 study".to_owned(), Detail::Whole),
        count => (format!("{count} studies"), Detail::Overview),
    };
    write!(
        out,
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n{POLICY}\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>slipgap report</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<header>\n\
         <h1>slipgap report</h1>\n<p class=\"facts\">slipgap {}, solver {SOLVER_VERSION}, {studies} \
         <button type=\"button\" class=\"print\">Print with all figures</button></p>\n\
         <noscript><p class=\"fails\">Figures and tables need JavaScript.</p></noscript>\n</header>\n",
        env!("CARGO_PKG_VERSION"),
    )?;
    glyphs.write(out)?;
    let index = Index::new(sections);
    if detail == Detail::Overview {
        summary::write(out, sections)?;
        index.write(out)?;
    }
    out.write_all(b"<main>\n")?;
    for group in index.groups() {
        group.begin(out, detail)?;
        for index in group.places() {
            section::write(out, index, &sections[index], detail)?;
        }
        out.write_all(b"</div>\n")?;
    }
    let scripts = SCRIPTS.concat();
    write!(
        out,
        "</main>\n<script>\n\"use strict\";\n{scripts}</script>\n</body>\n</html>\n"
    )
}
