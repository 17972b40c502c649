//! Cases that could not be solved: the first are named on stderr, the others counted.

use super::note;
use super::sources::Source;

/// Most cases that are named.
const MOST_NAMED: usize = 20;

/// What became of them, in lines for a user.
pub struct Unsolved<'a> {
    source: &'a Source,
    count: u64,
    named: Vec<String>,
}

impl<'a> Unsolved<'a> {
    /// None yet.
    pub fn new(source: &'a Source) -> Unsolved<'a> {
        Unsolved {
            source,
            count: 0,
            named: Vec::new(),
        }
    }

    /// Counts one.
    pub fn add(&mut self, number: u64, why: &str) {
        self.count += 1;
        if self.named.len() < MOST_NAMED {
            self.named.push(line(self.source, number, why));
        }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Names them on stderr.
    pub fn tell(&self) {
        self.named.iter().for_each(|line| note(line));
        let more = self.count - self.named.len() as u64;
        if more > 0 {
            note(&format!(
                "{}: {more} more cases could not be solved",
                self.source.file.display()
            ));
        }
    }
}

/// One of them in a line.
pub fn line(source: &Source, number: u64, why: &str) -> String {
    let file = source.file.display();
    format!("{file}: case {number} could not be solved: {why}")
}
