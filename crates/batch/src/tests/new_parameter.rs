//! A new parameter with a default: a copy of the friction oscillator with one more parameter.

use crate::output::failures_and_histories::FailureTable;
use crate::output::results::ResultTable;
use crate::store::Store;
use crate::store::key::{CaseHash, Key};
use crate::{RunOptions, run};
use slipgap_motion::history::History;
use slipgap_motion::solve::{MetricTable, Unsolvable, Warning};
use slipgap_problem::problem::friction::FrictionOscillator;
use slipgap_problem::problem::numbers::parameter::{Default, Kind, Parameter, Range, Value};
use slipgap_problem::problem::table::cases::Cases;
use slipgap_problem::problem::{
    Case, Jumps, Problem, ProblemKind, Schema, Solution, Violation, Work,
};
use slipgap_study::{Axis, AxisGroup, Block, Study, parse};
use std::sync::Arc;

/// The friction oscillator with a parameter that has a default and a column only if it is given.
#[derive(Debug)]
struct Extended(Arc<Schema>);

impl Extended {
    fn new() -> Extended {
        let mut schema = Schema::clone(FrictionOscillator.schema());
        let kind = Kind::Number(Range::NotNegative);
        let default = Default::Is(Value::Number(0.0));
        let damping = Parameter::new(["zeta", "*ζ*", "1"], kind, default, "damping ratio");
        let table = schema.parameters.to_mut();
        table.push(damping.with_column_if_given());
        Extended(Arc::new(schema))
    }
}

impl Problem for Extended {
    fn schema(&self) -> &Arc<Schema> {
        &self.0
    }
    fn kind(&self) -> ProblemKind<'_> {
        FrictionOscillator.kind()
    }
    fn complete(&self, case: &mut Case) -> Vec<Violation> {
        FrictionOscillator.complete(case)
    }
    fn solve(&self, case: &Case, wanted: &[usize]) -> Result<Solution, Unsolvable> {
        FrictionOscillator.solve(case, wanted)
    }
    fn sweep(&self, cases: &Cases, rows: &[u32]) -> MetricTable {
        FrictionOscillator.sweep(cases, rows)
    }
    fn exact(&self, case: &Case, times: &[f64], jumps: Jumps) -> Option<History> {
        FrictionOscillator.exact(case, times, jumps)
    }
    fn work(&self, case: &Case, wanted: &[usize]) -> Work {
        FrictionOscillator.work(case, wanted)
    }
    fn doubts(&self, case: &Case) -> Vec<(Warning, String)> {
        FrictionOscillator.doubts(case)
    }
}

fn plain() -> Study {
    let text = r#"{"problem": "friction-oscillator", "parameters": {"law": "displacement-control",
        "alpha": [0.5, 1], "dT": 0.5, "duration": 3}}"#;
    parse("s.json", text).unwrap()
}

/// The same study of the extended problem; `zeta` has these values, if there are any.
fn extended(zeta: &[f64]) -> Study {
    let problem = Arc::new(Extended::new());
    let parameter = problem.schema().parameters.len() - 1;
    let mut study = plain();
    let mut groups = study.blocks[0].groups.clone();
    if !zeta.is_empty() {
        let values = zeta.iter().copied().map(Value::Number).collect();
        let axes = vec![Axis { parameter, values }];
        groups.push(AxisGroup { axes });
    }
    // A new block, because a block keeps what its cases share.
    let mut block = Block::default();
    block.groups = groups;
    study.blocks = vec![block];
    study.problem = problem;
    study
}

/// results.csv and failures.csv of a study, the latter with every case.
fn tables(study: &Study) -> [String; 2] {
    let mut table = ResultTable::new(study, Vec::new()).unwrap();
    let mut failures = FailureTable::new(study, Vec::new()).unwrap();
    for (number, case) in (0..).zip(study.cases()) {
        failures
            .row(
                number,
                &case,
                &slipgap_motion::solve::Unsolvable::OutOfRange,
            )
            .unwrap();
    }
    let bar = indicatif::ProgressBar::hidden();
    let add = |part| {
        table.add(&part).unwrap();
        Ok(())
    };
    run(study, &bar, &RunOptions::METRICS, add).unwrap();
    [table.finish().unwrap(), failures.finish().unwrap()]
        .map(|bytes| String::from_utf8(bytes).unwrap())
}

/// The key of all cases, and the bytes of the part with their results.
fn part(study: &Study) -> (Key, Vec<u8>) {
    let (first, cases) = study.columns(0, study.raw_len());
    let key = Key::new(study, first, &cases);
    let rows: Vec<u32> = (0..cases.len() as u32).collect();
    let found = study.problem.sweep(&cases, &rows);
    let folder = tempfile::tempdir().unwrap();
    let store = Store::open(folder.path()).unwrap();
    store.save(study, 0, &key, (first, &cases), &found).unwrap();
    drop(store);
    let mut parts = walkdir::WalkDir::new(folder.path())
        .into_iter()
        .flatten()
        .filter(|entry| entry.path().extension().is_some_and(|e| e == "parquet"));
    (key, std::fs::read(parts.next().unwrap().path()).unwrap())
}

#[test]
fn a_new_parameter_that_is_not_given_changes_no_table_and_no_part() {
    let (before, after) = (plain(), extended(&[]));
    assert_eq!(tables(&before), tables(&after));
    assert_eq!(part(&before), part(&after));
}

#[test]
fn a_new_parameter_that_is_given_has_its_column() {
    let (before, after) = (plain(), extended(&[0.0, 0.25]));
    let columns = |text: &str| -> Vec<Vec<String>> {
        let cells = |line: &str| line.split(',').map(String::from).collect();
        text.lines().map(cells).collect()
    };
    for (before, after) in tables(&before).into_iter().zip(tables(&after)) {
        let (before, after) = (columns(&before), columns(&after));
        let zeta_column = after[0].iter().position(|name| name == "zeta").unwrap();
        assert!(!before[0].contains(&"zeta".to_owned()));
        let zeta: Vec<&str> = after[1..]
            .iter()
            .map(|row| row[zeta_column].as_str())
            .collect();
        assert_eq!(zeta, ["0.0", "0.25", "0.0", "0.25"]);
        // The rest of a row, without its number, is the row of the study before.
        for (i, row) in after.iter().enumerate().skip(1) {
            let mut rest = row.clone();
            rest.remove(zeta_column);
            assert_eq!(rest[1..], before[1 + (i - 1) / 2][1..]);
        }
    }
    let (key, _) = part(&after);
    assert_ne!(key.cases, part(&plain()).0.cases);
}

#[test]
fn results_stored_without_the_column_serve_at_its_default() {
    let (before, after) = (extended(&[]), extended(&[0.0, 0.25]));
    let (first, cases) = before.columns(0, before.raw_len());
    let key = Key::new(&before, first, &cases);
    let rows: Vec<u32> = (0..cases.len() as u32).collect();
    let found = before.problem.sweep(&cases, &rows);
    let folder = tempfile::tempdir().unwrap();
    let store = Store::open(folder.path()).unwrap();
    store
        .save(&before, 0, &key, (first, &cases), &found)
        .unwrap();
    drop(store);
    let store = Store::open(folder.path()).unwrap();
    let (first, cases) = after.columns(0, after.raw_len());
    let former = store.earlier_cases(&after, 0, &Key::new(&after, first, &cases));
    let mut hash = CaseHash::default();
    let stored = after
        .cases()
        .map(|case| former.get(hash.of(&case.values)).is_some());
    assert_eq!(stored.collect::<Vec<_>>(), [true, false, true, false]);
}
