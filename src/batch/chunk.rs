//! Chunks: fixed ranges of raw combinations, the unit that is computed, kept and found again.

use crate::problem::cases::{Cases, Column};
use crate::problem::parameter::Value;
use crate::study::Study;
use twox_hash::XxHash3_128;

/// Version of everything that decides a number; it changes when any result may change.
pub const SOLVER_VERSION: u32 = 1;

/// Sum of the sources that decide results: a change there makes stores stale, noted in the version or not.
const SOLVER_SOURCES: &str = env!("SLIPGAP_SOLVER");

/// Most combinations of a chunk.
const LARGEST: u64 = 16_384;

/// Steps times modes of a chunk: some seconds, the most that a killed run loses for each thread.
const WORK: u64 = 1 << 32;

/// How a study is cut into chunks.
#[derive(Debug, Clone, Copy)]
pub struct Cut {
    size: u64,
    raw: u64,
}

impl Cut {
    /// Chunks of a power of two, by what the first case costs: an extended study keeps its first case.
    pub fn new(study: &Study) -> Cut {
        let first = study.case(0);
        let work = first.map_or(1, |case| study.problem.work(&case).max(1));
        let fitting = (WORK / work).clamp(1, LARGEST);
        Cut {
            size: 1 << fitting.ilog2(),
            raw: study.raw_len(),
        }
    }

    /// Number of chunks.
    pub fn count(&self) -> u64 {
        self.raw.div_ceil(self.size)
    }

    /// The cases of chunk `index`, with the number of the first.
    pub fn cases(&self, study: &Study, index: u64) -> (u64, Cases) {
        let from = index * self.size;
        study.columns(from, (from + self.size).min(self.raw))
    }
}

/// What decides a chunk's results, taken apart so that a change can be named.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Key {
    /// Version of the solver.
    pub solver: String,
    /// Problem, way of solving and columns.
    pub columns: String,
    /// Numbers and parameters of all cases, bit by bit.
    pub cases: String,
}

impl Key {
    /// The key of these cases, the first of which has the number `first`.
    pub fn new(study: &Study, first: u64, cases: &Cases) -> Key {
        let mut hasher = XxHash3_128::new();
        // A column at a time: the hasher takes long pieces much faster than short ones.
        let mut bytes = Vec::new();
        bytes.extend(first.to_le_bytes());
        bytes.extend(cases.len().to_le_bytes());
        for column in cases.columns() {
            match column {
                Column::Same(value) => {
                    bytes.push(0);
                    note(&mut bytes, *value);
                }
                Column::Each(values) => {
                    bytes.push(1);
                    values.iter().for_each(|value| note(&mut bytes, *value));
                }
            }
            hasher.write(&bytes);
            bytes.clear();
        }
        for (row, why) in cases.refused() {
            hasher.write(&row.to_le_bytes());
            hasher.write(why.as_bytes());
        }
        let metrics = study.problem.metrics();
        let names: Vec<&str> = study.metrics.iter().map(|m| metrics[*m].name).collect();
        let once = if study.once { "once" } else { "converged" };
        Key {
            solver: format!("{SOLVER_VERSION} {SOLVER_SOURCES}"),
            columns: format!("{} {once} {}", study.problem.name(), names.join(" ")),
            cases: format!("{:032x}", hasher.finish_128()),
        }
    }

    /// What differs from the key of a chunk that was kept.
    pub fn change(&self, kept: &Key) -> Option<&'static str> {
        if self.solver != kept.solver {
            Some("made by another version of the solver")
        } else if self.columns != kept.columns {
            Some("other columns")
        } else if self.cases != kept.cases {
            Some("other parameters")
        } else {
            None
        }
    }
}

/// Adds what tells a value from all others.
fn note(bytes: &mut Vec<u8>, value: Option<Value>) {
    let tag: u8 = match value {
        None => 0,
        Some(Value::Number(_)) => 1,
        Some(Value::Whole(_)) => 2,
        Some(Value::Name(_)) => 3,
    };
    bytes.push(tag);
    if let Some((bits, name)) = value.map(Value::identity) {
        bytes.extend((bits ^ name.len() as u64).to_le_bytes());
        bytes.extend(name.as_bytes());
    }
}

/// The checksum of some bytes, as 32 hexadecimal digits.
pub fn checksum(bytes: &[u8]) -> String {
    format!("{:032x}", XxHash3_128::oneshot(bytes))
}
