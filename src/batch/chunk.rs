//! Chunks: fixed ranges of raw combinations, the unit that is computed, kept and found again.

use super::Outcome;
use crate::problem::parameter::Value;
use crate::problem::{Case, Problem};
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
        let first = study.range(0, study.raw_len()).next();
        let work = first.map_or(1, |(_, case)| study.problem.work(&case).max(1));
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

    /// The cases of chunk `index`, with their numbers.
    pub fn cases(&self, study: &Study, index: u64) -> Vec<(u64, Case)> {
        let from = index * self.size;
        study
            .range(from, (from + self.size).min(self.raw))
            .collect()
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
    /// The key of these cases.
    pub fn new(study: &Study, cases: &[(u64, Case)]) -> Key {
        let mut hasher = XxHash3_128::new();
        // A case at a time: the hasher takes long pieces much faster than short ones.
        let mut bytes = Vec::new();
        for (number, case) in cases {
            bytes.clear();
            bytes.extend(number.to_le_bytes());
            for value in &case.values {
                let (tag, bits): (u8, u64) = match value {
                    None => (0, 0),
                    Some(Value::Number(x)) => (1, x.to_bits()),
                    Some(Value::Whole(n)) => (2, *n),
                    Some(Value::Name(name)) => {
                        bytes.extend(name.as_bytes());
                        (3, name.len() as u64)
                    }
                };
                bytes.push(tag);
                bytes.extend(bits.to_le_bytes());
            }
            hasher.write(&bytes);
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

/// The checksum of some bytes, as 32 hexadecimal digits.
pub fn checksum(bytes: &[u8]) -> String {
    format!("{:032x}", XxHash3_128::oneshot(bytes))
}

/// A row of a table by the problem's table: metrics that the study does not have are `None`.
pub(super) fn by_table(
    problem: &dyn Problem,
    columns: &[usize],
    row: impl Iterator<Item = Option<f64>>,
) -> Vec<Option<f64>> {
    let mut metrics = vec![None; problem.metrics().len()];
    for (column, value) in columns.iter().zip(row) {
        metrics[*column] = value;
    }
    metrics
}

/// Outcomes of a chunk and where they came from.
#[derive(Debug)]
pub struct Done {
    /// In case order.
    pub outcomes: Vec<Outcome>,
    /// Number of the first.
    pub first: u64,
    /// Whether they were kept from a former run; if not, and something was there, why it could not serve.
    pub kept: Result<(), Option<String>>,
}
