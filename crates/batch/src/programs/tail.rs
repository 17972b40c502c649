//! The last lines of a program, which messages quote.

use std::collections::VecDeque;

/// Lines that are quoted, and characters of each.
const QUOTED: usize = 5;
const WIDTH: usize = 300;

/// The last lines that were no answers.
#[derive(Debug, Default)]
pub(super) struct Tail(VecDeque<String>);

impl Tail {
    /// Adds a line, if it has something to read.
    pub(super) fn push(&mut self, line: &str) {
        let plain = |c: char| if c.is_control() { ' ' } else { c };
        let shown: String = line.trim().chars().map(plain).take(WIDTH).collect();
        if shown.is_empty() {
            return;
        }
        self.0.push_back(shown);
        if self.0.len() > QUOTED {
            self.0.pop_front();
        }
    }

    /// A message with these lines.
    pub(super) fn after(&self, why: &str) -> String {
        let lines: Vec<&str> = self.0.iter().map(String::as_str).collect();
        match lines.is_empty() {
            true => why.to_owned(),
            false => format!("{why}; its last lines: {}", lines.join(" | ")),
        }
    }
}
