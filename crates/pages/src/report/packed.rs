//! Compressed parts of the page: DEFLATE (RFC 1951) as base64 in a script element, which the page unpacks when it shows them.

use flate2::Compression;
use flate2::write::DeflateEncoder;
use slipgap_figures::base64;
use std::io::{self, Write};

/// Writes bytes as a script element that no browser runs.
pub fn write(out: &mut impl Write, bytes: &[u8]) -> io::Result<()> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes)?;
    let text = base64::text(&encoder.finish()?);
    writeln!(out, "<script type=\"text/plain\">{text}</script>")
}

/// Writes a part of a study that a reader opens: its heading, and its HTML, packed.
pub fn write_part(out: &mut impl Write, heading: &str, open: bool, html: &[u8]) -> io::Result<()> {
    let open = if open { " open" } else { "" };
    writeln!(
        out,
        "<details class=\"part\"{open}><summary>{heading}</summary>\n<div class=\"packed\">"
    )?;
    write(out, html)?;
    out.write_all(b"</div></details>\n")
}
