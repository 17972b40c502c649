//! Warnings and notes: of one study as they come, of several once, after the last.

use super::{input_note, message, note, warn};
use crate::batch::WarnedCases;
use crate::run::Source;
use slipgap_motion::solve::WARNINGS;

/// The warnings of the studies so far.
#[derive(Debug)]
pub struct Summary {
    /// Number of the studies of the command.
    studies: usize,
    /// Those with warnings, by name.
    warned: Vec<(String, Vec<WarnedCases>)>,
    /// Those with notes on their input.
    noted: Vec<String>,
}

impl Summary {
    /// Of a command with so many studies.
    pub fn new(studies: usize) -> Summary {
        Summary {
            studies,
            warned: Vec::new(),
            noted: Vec::new(),
        }
    }

    /// Adds the warnings of a study, and the notes on its input; writes them if it is the only study.
    pub fn add(&mut self, source: &Source, warnings: &[WarnedCases]) {
        let notes = source.study.notes();
        if self.studies == 1 {
            notes.iter().for_each(|text| input_note(&source.line(text)));
            let begin = |text: &str| source.line(text);
            warnings.iter().for_each(|warned| warn(begin, warned));
            return;
        }
        if !notes.is_empty() {
            self.noted.push(source.name.clone());
        }
        if !warnings.is_empty() {
            self.warned.push((source.name.clone(), warnings.to_vec()));
        }
    }

    /// Writes the warnings of several studies: a line for each kind, with the studies and their numbers of cases, then the notes.
    pub fn print(&self) {
        let lines = self.lines();
        for (word, text) in &lines {
            message::labelled(word, text, || message::line(&format!("{word}: {text}")));
        }
        if !lines.is_empty() {
            note(
                "manifest.json of each study has an example of every kind, and `slipgap run STUDY` shows it; the remark // of a study may say why",
            );
        }
    }

    /// Each line with its word, the warnings first.
    fn lines(&self) -> Vec<(&'static str, String)> {
        let of_word = |word: &'static str| {
            let kinds = WARNINGS.into_iter().filter_map(move |kind| {
                let is_of_kind =
                    |warned: &&WarnedCases| warned.kind == kind && warned.word() == word;
                let with_kind = self
                    .warned
                    .iter()
                    .filter_map(|(name, warnings)| Some((name, warnings.iter().find(is_of_kind)?)));
                let found: Vec<(&String, &WarnedCases)> = with_kind.collect();
                let (cases, of) = found.iter().fold((0, 0), |(cases, of), (_, warned)| {
                    (cases + warned.cases, of + warned.of)
                });
                let names: Vec<String> = found
                    .iter()
                    .map(|(name, warned)| format!("{name} ({})", warned.cases))
                    .collect();
                let message = kind.message_of_some();
                let studies = studies(names.len(), self.studies);
                let kind = kind.name();
                let names = names.join(", ");
                let text = format!("{kind}: {cases} of {of} cases in {studies} {message}: {names}");
                (!found.is_empty()).then_some((word, text))
            });
            kinds.collect::<Vec<_>>()
        };
        let mut lines = of_word("warning");
        lines.extend(of_word("note"));
        if !self.noted.is_empty() {
            let studies = studies(self.noted.len(), self.studies);
            let names = self.noted.join(", ");
            lines.push((
                "note",
                format!("input: there are notes on the files of {studies}: {names}"),
            ));
        }
        lines
    }
}

fn studies(count: usize, of: usize) -> String {
    format!("{count} of {of} studies")
}
