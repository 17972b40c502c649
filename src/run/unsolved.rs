//! Cases that could not be solved: lines about the first ones, and the number of the others.

use super::Source;
use slipgap_motion::solve::Unsolvable;

/// Largest number of cases with a line each.
const MOST_LISTED: usize = 20;

/// The cases of a study that could not be solved.
pub struct UnsolvedCases<'a> {
    source: &'a Source,
    count: u64,
    lines: Vec<String>,
}

impl<'a> UnsolvedCases<'a> {
    /// None yet.
    pub fn new(source: &'a Source) -> UnsolvedCases<'a> {
        UnsolvedCases {
            source,
            count: 0,
            lines: Vec::new(),
        }
    }

    /// Adds a case.
    pub fn add(&mut self, number: u64, why: &Unsolvable) {
        self.count += 1;
        if self.lines.len() < MOST_LISTED {
            self.lines.push(line(self.source, number, why));
        }
    }

    /// Whether every case was solved.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// A line about each of the first cases, and one about the number of the others.
    pub fn lines(&self) -> impl Iterator<Item = String> {
        let more = self.count - self.lines.len() as u64;
        let line = || {
            let what = format!("{more} more cases could not be solved");
            self.source.line(&what)
        };
        let others = (more > 0).then(line);
        self.lines.iter().cloned().chain(others)
    }
}

/// The line about one case.
pub fn line(source: &Source, number: u64, why: &Unsolvable) -> String {
    source.line(&format!("case {number} could not be solved: {why}"))
}
