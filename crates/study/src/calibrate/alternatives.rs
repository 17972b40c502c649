//! The alternatives that a calibration compares, and the tests that each is fitted to.

use crate::Study;
use slipgap_cases::alike::{Identity, grouped, identity};
use slipgap_cases::axis::group::AxisGroup;
use slipgap_problem::problem::Case;
use slipgap_problem::problem::numbers::parameter::{Kind, Value};

/// Most characters of the name of a file: file systems allow 255 bytes, also for the temporary name.
const LONGEST_NAME: usize = 100;

/// Values of the axes that are no tests; each alternative has a search of its own.
#[derive(Debug, Clone)]
pub struct Alternative {
    /// Its name, as in `hertz`: the values by which it differs from the others; empty if there is one alternative.
    pub name: String,
    /// The parameters by which it differs from others, each with its value.
    pub values: Vec<(usize, Option<Value>)>,
    /// The block of its cases.
    pub(super) block: usize,
    /// The combination of the block of each test.
    pub(super) raws: Vec<u64>,
    /// The measured files, if they are an axis; empty otherwise.
    pub tests: Vec<String>,
}

/// A case of the study with its block, its combination and its group among those of one alternative.
struct Member {
    block: usize,
    raw: u64,
    /// The positions on the axes of its alternative.
    own: Vec<u64>,
    case: Case,
}

impl Study {
    /// The alternatives in the order of the cases; none without `calibrate`.
    pub fn alternatives(&self) -> Vec<Alternative> {
        let tests = self.calibrate.as_ref().map(|calibrate| calibrate.tests);
        tests.map_or(Vec::new(), |tests| {
            self.grouped(tests, |group| !tests.is_some_and(|row| group.has(row)))
        })
    }

    /// The cases with the same positions on these groups of axes, as an alternative each.
    fn grouped(
        &self,
        tests: Option<usize>,
        is_own: impl Fn(&AxisGroup) -> bool,
    ) -> Vec<Alternative> {
        let groups = grouped(self.members(is_own), |member| {
            (member.block, member.own.clone())
        });
        let firsts: Vec<&Case> = groups.iter().map(|group| &group[0].case).collect();
        let names = self.names(&firsts, tests);
        let test = |member: &Member| {
            let value = tests.and_then(|row| member.case.values[row]);
            value.map(|value| value.to_string())
        };
        let alternative = |(group, (name, values)): (&Vec<Member>, Named)| Alternative {
            name,
            values,
            block: group[0].block,
            raws: group.iter().map(|member| member.raw).collect(),
            tests: group.iter().filter_map(test).collect(),
        };
        groups.iter().zip(names).map(alternative).collect()
    }

    /// The cases of the study.
    fn members(&self, is_own: impl Fn(&AxisGroup) -> bool) -> Vec<Member> {
        let problem = &*self.problem;
        let mut members = Vec::new();
        for (number, block) in self.blocks.iter().enumerate() {
            for raw in (0..block.raw_len()).filter(|raw| block.is_case(problem, *raw)) {
                let positions = block.positions(raw).into_iter().enumerate();
                let of_alternative = positions.filter(|(group, _)| is_own(&block.groups[*group]));
                members.push(Member {
                    block: number,
                    raw,
                    own: of_alternative.map(|(_, position)| position).collect(),
                    case: block.completed(problem, raw),
                });
            }
        }
        members
    }

    /// The names of alternatives by their first cases, each once.
    fn names(&self, firsts: &[&Case], tests: Option<usize>) -> Vec<Named> {
        let table = self.problem.parameters();
        let derived = |row: usize| {
            let mut derived_parameters = self.blocks.iter().flat_map(|block| &block.derived);
            derived_parameters.any(|derived| derived.parameter == row)
        };
        let differs = |row: &usize| {
            let mut cases = firsts.iter();
            cases.any(|case| !Value::identical(case.values[*row], firsts[0].values[*row]))
        };
        let differing = (0..table.len()).filter(differs);
        let rows: Vec<usize> = differing
            .filter(|row| Some(*row) != tests && !derived(*row))
            .collect();
        let names_only = |row: &&usize| matches!(table[**row].kind, Kind::Choice(_));
        let names: Vec<usize> = rows.iter().filter(names_only).copied().collect();
        let distinct = |rows: &[usize]| {
            let mut known: Vec<Identity> = Vec::new();
            firsts.iter().all(|case| {
                let key = identity(case, rows);
                let is_new = !known.contains(&key);
                known.push(key);
                is_new
            })
        };
        // Laws say enough if no two alternatives have the same.
        let shown = match distinct(&names) {
            true => &names,
            false => &rows,
        };
        let repeated = !distinct(shown);
        let name = |(i, case): (usize, &&Case)| {
            let value = |row: &usize| match (table[*row].kind, case.values[*row]) {
                (_, None) => None,
                (Kind::Choice(_), Some(value)) => Some(value.to_string()),
                (_, Some(value)) => Some(format!("{} = {value}", table[*row].name)),
            };
            let values = shown.iter().filter_map(value);
            let number = repeated.then(|| (i + 1).to_string());
            let words: Vec<String> = values.chain(number).collect();
            let of = |row: &usize| (*row, case.values[*row]);
            (words.join(", "), shown.iter().map(of).collect())
        };
        firsts.iter().enumerate().map(name).collect()
    }
}

/// The name of an alternative, and the values in it.
type Named = (String, Vec<(usize, Option<Value>)>);

impl Alternative {
    /// One for each test alone; none without an axis of tests.
    pub fn each_test(&self) -> impl Iterator<Item = Alternative> {
        let tests = self.raws.iter().zip(&self.tests);
        tests.map(|(raw, test)| Alternative {
            raws: vec![*raw],
            tests: vec![test.clone()],
            ..self.clone()
        })
    }

    /// Its name as a part of a file's name; empty if there is one alternative.
    pub fn file_name(&self) -> String {
        let plain = |c: char| match c {
            c if c.is_ascii_alphanumeric() || "_.+".contains(c) => c,
            _ => '-',
        };
        let name: String = self.name.replace(" = ", "=").chars().map(plain).collect();
        let parts = name.split('-').filter(|part| !part.is_empty());
        let mut name = parts.collect::<Vec<_>>().join("-");
        name.truncate(LONGEST_NAME);
        name
    }

    /// Number of cases at a point: one for each test.
    pub fn cases(&self) -> usize {
        self.raws.len()
    }
}
