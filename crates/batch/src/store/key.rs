//! Keys: everything that determines the results of a part. Stored results are used again only if their key is the same.

use crate::programs;
use slipgap_problem::problem::numbers::parameter::{ColumnRule, Value};
use slipgap_problem::problem::table::cases::{Cases, Cells, Column, NO_NAME, NO_WHOLE, applies};
use slipgap_study::Study;
use std::fmt;
use twox_hash::XxHash3_128;

/// Version of all code that determines results. It changes when any result may change.
pub const SOLVER_VERSION: u32 = 2;

/// Version of the encoding of parts. Parts of another one have the same numbers, but not the same bytes.
const ENCODING_VERSION: u32 = 2;

/// Hashes of the code that determines results. A change there makes stores outdated, also without a new version. The numbers of a
/// structure are not in a key, so that their reader counts.
const CODE: [&[&str]; 2] = [
    &slipgap_solver::VERSION_KEYS,
    &[slipgap_problem::CODE_KEY, slipgap_study::READER_KEY],
];

/// Everything that determines the results of a part. It has several fields so that a message can name the difference.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Key {
    /// Version of the solver.
    pub solver: String,
    /// Problem, with or without iteration, and columns.
    pub columns: String,
    /// Hash of the numbers and parameters of all cases.
    pub cases: String,
}

impl Key {
    /// The key of these cases, the first of which has the number `first`.
    pub fn new(study: &Study, first: u64, cases: &Cases) -> Key {
        let mut hasher = XxHash3_128::new();
        // A column at a time: the hasher is much faster for long inputs.
        let mut bytes = Vec::new();
        bytes.extend(first.to_le_bytes());
        bytes.extend(cases.len().to_le_bytes());
        let table = study.problem.parameters();
        for row in study.parameter_columns() {
            let free_names = !study
                .problem
                .as_structure()
                .map_or("", |structure| structure.identity())
                .is_empty();
            if free_names || table[row].column == ColumnRule::IfGiven {
                bytes.extend(table[row].name.as_bytes());
            }
            if free_names {
                bytes.push(0);
            }
            match &cases.columns()[row] {
                Column::Same(value) => {
                    bytes.push(0);
                    push_value(&mut bytes, *value);
                }
                Column::Each(cells) => {
                    bytes.push(1);
                    push_cells(&mut bytes, cells);
                }
            }
            hasher.write(&bytes);
            bytes.clear();
        }
        for offset in cases.offsets().into_iter().flatten() {
            hasher.write(&offset.to_le_bytes());
        }
        for (row, why) in cases.refused() {
            hasher.write(&row.to_le_bytes());
            hasher.write(why.as_bytes());
        }
        let metrics = study.problem.metrics();
        let names: Vec<&str> = study.metrics.iter().map(|m| &*metrics[*m].name).collect();
        let once = if study.once { "once" } else { "converged" };
        Key {
            solver: format!(
                "{SOLVER_VERSION}.{ENCODING_VERSION} {}{}",
                CODE.concat().join(" "),
                match programs::versions(study) {
                    None => String::new(),
                    Some(versions) => format!("{BEFORE_PROGRAMS}{versions}"),
                }
            ),
            columns: format!(
                "{}{} {once} {}",
                study.problem.name(),
                study.problem.identity(),
                names.join(" ")
            ),
            cases: format!("{:032x}", hasher.finish_128()),
        }
    }

    /// Whether the results of another part have the same columns and come from the same solver.
    pub fn same_solver_and_columns(&self, other: &Key) -> bool {
        self.solver == other.solver && self.columns == other.columns
    }

    /// The first difference from the key of a stored part; `None` if they are equal.
    pub fn difference(&self, stored: &Key) -> Option<Difference> {
        if !self.has_solver(stored) {
            Some(Difference::Solver)
        } else if self.columns != stored.columns {
            Some(self.difference_of_columns(stored))
        } else if self.cases != stored.cases {
            Some(Difference::Parameters)
        } else {
            None
        }
    }
}

/// What is between the versions of the solver and those of programs.
const BEFORE_PROGRAMS: &str = " with ";

impl Key {
    /// Whether the same versions computed the results. Where the versions of programs are not known, any will do: only a verb that
    /// computes nothing does not know them.
    fn has_solver(&self, stored: &Key) -> bool {
        match self.solver.split_once(BEFORE_PROGRAMS) {
            Some((solver, programs::UNKNOWN)) => {
                let of_stored = stored.solver.split_once(BEFORE_PROGRAMS);
                of_stored.is_some_and(|(of_stored, _)| of_stored == solver)
            }
            _ => self.solver == stored.solver,
        }
    }

    /// The difference of two `columns`, which begin with the identity of the problem: that of a structure ends with a hash of its
    /// records behind a point.
    fn difference_of_columns(&self, stored: &Key) -> Difference {
        let [this_columns, other] = [self, stored].map(|key| {
            let (problem, rest) = key.columns.split_once(' ').unwrap_or((&key.columns, ""));
            (problem.rsplit_once('.'), rest)
        });
        match (this_columns, other) {
            ((Some((one, _)), rest), (Some((two, _)), of_other)) if rest == of_other => {
                match one == two {
                    true => Difference::Records,
                    false => Difference::Structure,
                }
            }
            _ => Difference::Columns,
        }
    }
}

/// Why the results of a stored part are not those of the study.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Difference {
    /// Another solver computed them.
    Solver,
    /// They have other columns.
    Columns,
    /// They are of a structure with other numbers or parts.
    Structure,
    /// They are of other records, or of records with another content.
    Records,
    /// Their cases have other numbers or parameters.
    Parameters,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Difference::Solver => "computed by another version of the solver",
            Difference::Columns => "different columns",
            Difference::Structure => "the structure has changed",
            Difference::Records => "the records have changed",
            Difference::Parameters => "different parameters",
        })
    }
}

/// Hashes of the parameters of cases, bit by bit, in the same memory.
#[derive(Debug, Default)]
pub struct CaseHash(Vec<u8>);

impl CaseHash {
    /// The hash of a case.
    pub fn of(&mut self, case: &[Option<Value>]) -> u128 {
        self.0.clear();
        case.iter()
            .for_each(|value| push_value(&mut self.0, *value));
        XxHash3_128::oneshot(&self.0)
    }
}

/// Appends bytes that are different for every value.
fn push_value(bytes: &mut Vec<u8>, value: Option<Value>) {
    match value {
        None => bytes.push(ABSENT),
        Some(Value::Number(x)) => push_bits(bytes, NUMBER, x.to_bits()),
        Some(Value::Whole(n)) => push_bits(bytes, WHOLE, n),
        Some(Value::Name(name)) => {
            push_bits(bytes, NAME, name.len() as u64);
            bytes.extend_from_slice(name.as_bytes());
        }
    }
}

/// Appends the bytes of [`push_value`] for each value.
fn push_cells(bytes: &mut Vec<u8>, cells: &Cells) {
    match cells {
        Cells::Numbers(numbers) => {
            bytes.reserve(9 * numbers.len());
            for x in numbers {
                match applies(*x) {
                    true => push_bits(bytes, NUMBER, x.to_bits()),
                    false => bytes.push(ABSENT),
                }
            }
        }
        Cells::Whole(numbers) => {
            bytes.reserve(9 * numbers.len());
            for n in numbers {
                match *n {
                    NO_WHOLE => bytes.push(ABSENT),
                    n => push_bits(bytes, WHOLE, n),
                }
            }
        }
        Cells::Names { names, places } => {
            for index in places {
                let known = (*index != NO_NAME).then(|| names[*index as usize]);
                push_value(bytes, known.map(Value::Name));
            }
        }
    }
}

/// The first byte of a value, by its kind.
const ABSENT: u8 = 0;
const NUMBER: u8 = 1;
const WHOLE: u8 = 2;
const NAME: u8 = 3;

fn push_bits(bytes: &mut Vec<u8>, kind: u8, bits: u64) {
    let mut with_kind = [kind; 9];
    with_kind[1..].copy_from_slice(&bits.to_le_bytes());
    bytes.extend_from_slice(&with_kind);
}

/// The checksum of bytes in pieces, as 32 hexadecimal digits.
pub fn checksum(pieces: &[impl AsRef<[u8]>]) -> String {
    let mut hasher = XxHash3_128::new();
    for piece in pieces {
        hasher.write(piece.as_ref());
    }
    format!("{:032x}", hasher.finish_128())
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipgap_study::parse;

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
    fn a_key_contains_the_version_and_the_sources_of_the_solver() {
        // From the build scripts. Without them, results of other code would be used again.
        assert!(CODE.concat().iter().all(|hash| hash.len() == 16));
        let solver = key("").solver;
        let mut hashes = solver.split(' ').skip(1);
        assert!(
            CODE.concat()
                .into_iter()
                .all(|hash| hashes.next() == Some(hash))
        );
    }

    #[test]
    fn every_field_of_a_key_makes_a_difference() {
        let (given, changed) = (key(""), |change: fn(&mut Key)| {
            let mut other = key("");
            change(&mut other);
            other
        });
        assert_eq!(given.difference(&key("")), None);
        let other = changed(|key| key.solver.push('0'));
        assert_eq!(given.difference(&other), Some(Difference::Solver));
        let other = changed(|key| key.columns.push('0'));
        assert_eq!(given.difference(&other), Some(Difference::Columns));
        let other = changed(|key| key.cases.push('0'));
        assert_eq!(given.difference(&other), Some(Difference::Parameters));
        // Without iteration the same columns have other results.
        let once = key(r#", "iteration": "once""#);
        assert_eq!(given.difference(&once), Some(Difference::Columns));
    }

    #[test]
    fn other_labels_are_other_cases() {
        let of = |labels: &str| {
            let text = format!(
                r#"{{"problem": "structure", "parameters": {{"bridge": [{labels}], "k": [1, 2], "dt": 0.1, "duration": 5}},
                "zip": [["bridge", "k"]], "metrics": ["peak(m.v)"], "structure": {{"masses": {{"m": 1}},
                "springs": [{{"between": ["ground", "m"], "k": "k"}}]}}}}"#
            );
            let study = parse("s.json", &text).unwrap();
            let (first, cases) = study.columns(0, 2);
            Key::new(&study, first, &cases)
        };
        let key = of(r#""short", "long""#);
        assert_eq!(key, of(r#""short", "long""#));
        assert_ne!(key, of(r#""stiff", "long""#));
    }
}
