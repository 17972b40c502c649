//! Keys: what decides the results of a part, so that kept results serve again only where nothing has changed.

use crate::problem::cases::{Cases, Column};
use crate::problem::parameter::{ColumnRule, Value};
use crate::study::Study;
use twox_hash::XxHash3_128;

/// Version of everything that decides a number; it changes when any result may change.
pub const SOLVER_VERSION: u32 = 2;

/// Sum of the sources that decide results: a change there makes stores stale, noted in the version or not.
const SOLVER_SOURCES: &str = env!("SLIPGAP_SOLVER");

/// What decides a part's results, in pieces so that a change can be named.
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
        let table = study.problem.parameters();
        for row in study.parameter_columns() {
            if table[row].column == ColumnRule::IfGiven {
                bytes.extend(table[row].name.as_bytes());
            }
            match &cases.columns()[row] {
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
        let names: Vec<&str> = study.metrics.iter().map(|m| &*metrics[*m].name).collect();
        let once = if study.once { "once" } else { "converged" };
        Key {
            solver: format!("{SOLVER_VERSION} {SOLVER_SOURCES}"),
            columns: format!("{} {once} {}", study.problem.name(), names.join(" ")),
            cases: format!("{:032x}", hasher.finish_128()),
        }
    }

    /// Whether cases of another part were solved in the same way, for the same columns.
    pub fn same_way(&self, other: &Key) -> bool {
        self.solver == other.solver && self.columns == other.columns
    }

    /// What differs from the key of a part that was kept.
    pub fn change(&self, kept: &Key) -> Option<&'static str> {
        if self.solver != kept.solver {
            Some("computed by another version of the solver")
        } else if self.columns != kept.columns {
            Some("different columns")
        } else if self.cases != kept.cases {
            Some("different parameters")
        } else {
            None
        }
    }
}

/// What tells the parameters of a case from those of others: a sum of all their bits.
pub fn identity(case: &[Option<Value>]) -> u128 {
    let mut bytes = Vec::new();
    case.iter().for_each(|value| note(&mut bytes, *value));
    XxHash3_128::oneshot(&bytes)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::parse;

    fn key(more: &str) -> Key {
        let text = format!(
            r#"{{"problem": "friction-oscillator", "parameters": {{"law": "displacement-control", "alpha": [1, 2],
            "dT": 0.5, "duration": 3}}{more}}}"#
        );
        let study = parse("s.json", &text).unwrap();
        let (first, cases) = study.columns(0, 2);
        Key::new(&study, first, &cases)
    }

    #[test]
    fn a_key_names_the_solver_by_version_and_sources() {
        // What build.rs sums up; without it results of other sources would serve.
        let sources = env!("SLIPGAP_SOLVER");
        assert_eq!(sources.len(), 16);
        assert_eq!(key("").solver, format!("{SOLVER_VERSION} {sources}"));
    }

    #[test]
    fn every_piece_of_a_key_counts() {
        let (own, changed) = (key(""), |change: fn(&mut Key)| {
            let mut other = key("");
            change(&mut other);
            other
        });
        assert_eq!(own.change(&key("")), None);
        let other = changed(|key| key.solver.push('0'));
        assert_eq!(
            own.change(&other),
            Some("computed by another version of the solver")
        );
        let other = changed(|key| key.columns.push('0'));
        assert_eq!(own.change(&other), Some("different columns"));
        let other = changed(|key| key.cases.push('0'));
        assert_eq!(own.change(&other), Some("different parameters"));
        // Another way of solving has other results in the same columns.
        let once = key(r#", "iteration": "once""#);
        assert_eq!(own.change(&once), Some("different columns"));
    }
}
