//! The outlines of glyphs, once for all figures of the page.

use std::collections::BTreeSet;
use std::io::{self, Write};

/// The outlines of the figures so far, as SVG elements with identifiers.
#[derive(Debug, Default)]
pub struct Glyphs(BTreeSet<String>);

impl Glyphs {
    /// Takes the outlines of an SVG file, which stand one a line in its `defs`; returns the rest of it.
    pub fn take(&mut self, svg: &str) -> String {
        let Some((before, rest)) = svg.split_once("<defs>\n") else {
            return svg.to_owned();
        };
        let Some((outlines, after)) = rest.split_once("</defs>\n") else {
            return svg.to_owned();
        };
        self.0.extend(outlines.lines().map(String::from));
        [before, after].concat()
    }

    /// Writes the outlines.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        if self.0.is_empty() {
            return Ok(());
        }
        out.write_all(
            b"<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"glyphs\" width=\"0\" height=\"0\" aria-hidden=\"true\"><defs>\n",
        )?;
        for outline in &self.0 {
            writeln!(out, "{outline}")?;
        }
        out.write_all(b"</defs></svg>\n")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_outline_of_two_figures_is_written_once() {
        let figure = |outlines: &str, body: &str| {
            format!("<svg>\n<defs>\n{outlines}</defs>\n{body}</svg>\n")
        };
        let [a, b, c] = ["r1", "r2", "i1"].map(|id| format!("<path id=\"{id}\" d=\"M0 0\"/>\n"));
        let mut glyphs = Glyphs::default();
        let first = glyphs.take(&figure(&[&*a, &*b].concat(), "<use href=\"#r1\"/>"));
        assert_eq!(first, "<svg>\n<use href=\"#r1\"/></svg>\n");
        glyphs.take(&figure(&[&*b, &*c].concat(), ""));
        assert_eq!(glyphs.take("<svg></svg>"), "<svg></svg>");
        let mut out = Vec::new();
        glyphs.write(&mut out).unwrap();
        let out = String::from_utf8(out).unwrap();
        for outline in [a, b, c] {
            assert_eq!(out.matches(&outline).count(), 1);
        }
    }
}
