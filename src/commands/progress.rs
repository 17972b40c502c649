//! How far a run is, and what it came to.

use super::note;
use indicatif::{ProgressBar, ProgressStyle};
use slipgap::batch::Done;
use std::io::{IsTerminal, stderr};

/// Most reasons that one line gives.
const MOST_REASONS: usize = 3;

/// A progress bar with rate and time left for a terminal, nothing otherwise.
pub fn bar(name: &str, cases: u64) -> ProgressBar {
    if !stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template(
        "{prefix} {wide_bar} {human_pos}/{human_len} cases, {per_sec}, {eta} left",
    )
    .unwrap_or_else(|_| ProgressStyle::default_bar());
    ProgressBar::new(cases)
        .with_style(style)
        .with_prefix(name.to_owned())
}

/// Takes the bar away and says in one plain line what is done.
pub fn finish(bar: &ProgressBar, name: &str, told: &str) {
    bar.finish_and_clear();
    note(&format!("{name}: {told}"));
}

/// So many cases were run.
pub fn run(cases: u64) -> String {
    match cases {
        1 => "1 case run".into(),
        _ => format!("{cases} cases run"),
    }
}

/// How many cases came from the store, and why the others did not.
#[derive(Debug)]
pub struct Tally {
    /// Whether there was no store to find anything in.
    new: bool,
    kept: u64,
    /// Reasons, with the number of chunks that had them.
    reasons: Vec<(String, u64)>,
}

impl Tally {
    /// Nothing yet.
    pub fn new(new: bool) -> Tally {
        Tally {
            new,
            kept: 0,
            reasons: Vec::new(),
        }
    }

    /// Counts a chunk.
    pub fn add(&mut self, done: &Done) {
        let why = match &done.kept {
            Ok(()) => {
                self.kept += done.len() as u64;
                return;
            }
            Err(None) => "not in the store yet".to_owned(),
            Err(Some(why)) => why.clone(),
        };
        match self.reasons.iter_mut().find(|(reason, _)| *reason == why) {
            Some((_, count)) => *count += 1,
            None => self.reasons.push((why, 1)),
        }
    }

    /// In one line.
    pub fn told(&self, cases: u64) -> String {
        if self.kept == cases {
            return format!("{cases} of {cases} cases from the store");
        }
        if self.new {
            return run(cases);
        }
        let told = |(reason, count): &(String, u64)| match count {
            1 => reason.clone(),
            _ => format!("{reason} ({count} chunks)"),
        };
        let mut reasons: Vec<String> = self.reasons.iter().take(MOST_REASONS).map(told).collect();
        if self.reasons.len() > MOST_REASONS {
            reasons.push(format!(
                "{} more reasons",
                self.reasons.len() - MOST_REASONS
            ));
        }
        let run = run(cases - self.kept);
        let kept = match self.kept {
            0 => String::new(),
            kept => format!("{kept} of {cases} cases from the store, "),
        };
        format!("{kept}{run}: {}", reasons.join(", "))
    }
}
