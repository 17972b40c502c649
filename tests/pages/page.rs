//! The pieces of a page in its order: fenced blocks, commands and JSON inside the text, and notes for this test.

use std::fs;

/// Where a piece begins, as `docs/guide.md:12`.
pub(crate) type Place = String;

/// A piece of a page that is more than words.
#[derive(Debug)]
pub(crate) enum Piece {
    /// `<!-- test: ... -->`, which readers do not see, with what it says. It belongs to the next piece.
    Note(String),
    /// A fenced block with its language.
    Block {
        language: String,
        text: String,
        /// The last file `NAME.json` that the words before it name.
        named: Option<String>,
    },
    /// A span of code inside the text.
    Span(String),
}

/// Programs whose commands belong into fenced blocks.
const PROGRAMS: [&str; 12] = [
    "slipgap ",
    "make ",
    "cargo ",
    "pip ",
    "bash ",
    "srun ",
    "seq ",
    "sbatch ",
    "hq ",
    "snakemake ",
    "nextflow ",
    "python ",
];

/// The pieces of a page, each with its place.
pub(crate) fn pieces(name: &str) -> Vec<(Place, Piece)> {
    let path = format!("{}/{name}", env!("SLIPGAP_ROOT"));
    let page = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
    let mut reader = Reader::default();
    let mut lines = page.lines().enumerate();
    while let Some((i, line)) = lines.next() {
        let at_line = format!("{name}:{}", i + 1);
        let trimmed = line.trim_start();
        if let Some(language) = trimmed.strip_prefix("```") {
            reader.end_paragraph();
            let indent = line.len() - trimmed.len();
            let mut text = String::new();
            for (_, line) in lines.by_ref() {
                if line.trim_start().starts_with("```") {
                    break;
                }
                text += line.get(indent..).unwrap_or_default();
                text.push('\n');
            }
            let named = reader.named.take();
            let language = language.trim().to_owned();
            let block = Piece::Block {
                language,
                text,
                named,
            };
            reader.pieces.push((at_line, block));
        } else if let Some(rest) = trimmed.strip_prefix("<!-- test: ") {
            reader.end_paragraph();
            let ended = rest.strip_suffix(" -->");
            let note = ended.unwrap_or_else(|| panic!("{at_line}: a note ends with -->"));
            reader.pieces.push((at_line, Piece::Note(note.to_owned())));
        } else if trimmed.is_empty() {
            reader.end_paragraph();
        } else {
            let program = PROGRAMS.iter().any(|program| trimmed.starts_with(program));
            assert!(
                !(line.starts_with("    ") && program),
                "{at_line}: put the command into a block with ```sh"
            );
            if reader.paragraph.is_empty() {
                reader.begins = at_line;
            }
            reader.paragraph += trimmed;
            reader.paragraph.push('\n');
        }
    }
    reader.end_paragraph();
    reader.pieces
}

#[derive(Default)]
struct Reader {
    pieces: Vec<(Place, Piece)>,
    paragraph: String,
    begins: Place,
    named: Option<String>,
}

impl Reader {
    /// Takes the spans of code out of the paragraph.
    fn end_paragraph(&mut self) {
        let paragraph = std::mem::take(&mut self.paragraph);
        let mut spans = paragraph.split('`').skip(1).step_by(2);
        for span in spans.by_ref() {
            let span = span.replace('\n', " ").replace("\\|", "|");
            if span.ends_with(".json") && !span.contains(' ') {
                self.named = Some(span.clone());
            }
            self.pieces.push((self.begins.clone(), Piece::Span(span)));
        }
    }
}
