//! What a reader of a page about several studies needs first: checks that are not met, cases without a solution, and warnings.

use super::Section;
use super::text::{code, escape, verdict};
use slipgap_motion::solve::WARNINGS;
use std::io::{self, Write};

/// Writes the summary.
pub fn write(out: &mut impl Write, sections: &[Section]) -> io::Result<()> {
    out.write_all(
        b"<section id=\"summary\" aria-label=\"Summary\">\n<h2>Checks and warnings</h2>\n",
    )?;
    let total: u64 = sections.iter().map(|section| section.checks.total()).sum();
    let failed: u64 = sections.iter().map(|section| section.checks.failed()).sum();
    let (class, sign) = verdict(failed == 0, "✓", "✗");
    let met = total - failed;
    match total {
        0 => writeln!(out, "<p>No study has checks.</p>")?,
        _ => writeln!(
            out,
            "<p class=\"{class}\">{sign} {met} of {total} checks are met.</p>"
        )?,
    }
    write_list(out, sections, |section| match section.checks.failed() {
        0 => None,
        failed => Some(format!("{failed} of {} not met", section.checks.total())),
    })?;
    let unsolved: u64 = sections
        .iter()
        .map(|section| section.counts.unsolved())
        .sum();
    let cases: u64 = sections.iter().map(|section| section.results.cases()).sum();
    let (class, sign) = verdict(unsolved == 0, "✓", "✗");
    let solved = cases - unsolved;
    writeln!(
        out,
        "<p class=\"{class}\">{sign} {solved} of {cases} cases are solved.</p>"
    )?;
    write_list(out, sections, |section| match section.counts.unsolved() {
        0 => None,
        unsolved => Some(format!(
            "{unsolved} of {} without a solution",
            section.results.cases()
        )),
    })?;
    write_warnings(out, sections)?;
    let readings = || sections.iter().flat_map(|section| &section.claims);
    if readings().count() > 0 {
        let hold = readings().filter(|reading| reading.holds).count();
        let count = readings().count();
        writeln!(
            out,
            "<p>{hold} of {count} readings of statements of the papers and of the literature hold; claims.md has the reason for each that \
             fails.</p>"
        )?;
    }
    out.write_all(b"</section>\n")
}

/// The warnings by kind, each with its studies.
fn write_warnings(out: &mut impl Write, sections: &[Section]) -> io::Result<()> {
    if sections
        .iter()
        .all(|section| section.counts.warnings.is_empty())
    {
        return writeln!(out, "<p class=\"holds\">✓ No study has a warning.</p>");
    }
    for kind in &WARNINGS {
        let of = |section: &Section| {
            let warnings = section.counts.warnings.iter();
            let of_kind = warnings.clone().find(|warning| warning.kind == *kind);
            of_kind.map(|warning| format!("{} of {} cases", warning.cases, warning.of))
        };
        let mut warnings = sections.iter().flat_map(|section| &section.counts.warnings);
        let is_note = warnings.all(|warning| warning.kind != *kind || warning.is_note);
        let studies = match sections.iter().filter_map(of).count() {
            0 => continue,
            1 => "1 study".to_owned(),
            count => format!("{count} studies"),
        };
        writeln!(
            out,
            "<details><summary>! {} {} in {studies}: cases {}.</summary>",
            if is_note { "Note" } else { "Warning" },
            kind.name(),
            code(&escape(kind.message()))
        )?;
        write_list(out, sections, of)?;
        out.write_all(b"</details>\n")?;
    }
    Ok(())
}

/// Links to the studies of which there is something to say.
fn write_list(
    out: &mut impl Write,
    sections: &[Section],
    say: impl Fn(&Section) -> Option<String>,
) -> io::Result<()> {
    let sentences = sections.iter().map(say).enumerate();
    let said: Vec<(usize, String)> = sentences.filter_map(|(i, text)| Some((i, text?))).collect();
    if said.is_empty() {
        return Ok(());
    }
    out.write_all(b"<ul>\n")?;
    for (i, text) in said {
        let title = escape(sections[i].title());
        writeln!(out, "<li><a href=\"#study-{i}\">{title}</a>: {text}</li>")?;
    }
    out.write_all(b"</ul>\n")
}
