//! What must hold of every text: it is refused with places inside it, or it is a study whose cases can be listed,
//! explained, solved and drawn.

use crate::chance::Chance;
use crate::xml;
use indicatif::ProgressBar;
use slipgap::batch::{self, Outcome, Wishes};
use slipgap::error::{Error, Fault};
use slipgap::figures::{self, DrawnCase};
use slipgap::problem::cases::Cases;
use slipgap::problem::{Case, Violation};
use slipgap::study::{Figure, Study, parse};

/// Steps times modes of a case that is solved, and of all cases whose figures are drawn.
const WORK: u64 = 20_000;

/// Most cases of a study whose figures are drawn.
const DRAWN: u64 = 40;

/// Most characters of a message: a quoted piece of the text and the names allowed.
const LONGEST: usize = 3000;

/// How far a text came.
#[derive(Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Came {
    #[default]
    Refused,
    Read,
    Solved,
    Drawn,
}

/// Puts a text to all tests; panics where one fails.
pub fn hold(text: &str, chance: &mut Chance) -> Came {
    let study = match parse("s.json", text) {
        Ok(study) => study,
        Err(Error::Faults(faults)) => {
            refused(text, &faults);
            return Came::Refused;
        }
        Err(other) => panic!("another error: {other}"),
    };
    listed(&study, chance);
    let mut came = Came::Read;
    for _ in 0..3 {
        let number = match study.len() {
            0 => panic!("a study without cases"),
            len => chance.below(len.min(1 << 40) as usize) as u64,
        };
        let case = study.case(number).expect("a case");
        if solved(&study, &case, &study.violations(number)) {
            came = Came::Solved;
        }
    }
    let small = |study: &Study| {
        study
            .cases()
            .map(|case| study.problem.work(&case))
            .sum::<u64>()
            <= WORK
    };
    if study.raw_len() <= DRAWN && small(&study) && !study.figures.is_empty() {
        drawn(&study);
        came = Came::Drawn;
    }
    came
}

/// Every fault stands inside the text, in order, with a message of one line that a terminal can show.
fn refused(text: &str, faults: &[Fault]) {
    assert!(!faults.is_empty(), "refused without a fault");
    let lines: Vec<usize> = text.split('\n').map(|line| line.chars().count()).collect();
    for fault in faults {
        let line = fault.to_string();
        let columns = lines.get(fault.line - 1).map_or(0, |count| count + 1);
        assert!((1..=columns).contains(&fault.column), "{line}");
        assert!(line.chars().count() <= LONGEST, "{line}");
        assert_eq!(slipgap::study::unprintable(&line), None, "{line}");
        let shown = fault.shown.replace('\n', "");
        assert_eq!(slipgap::study::unprintable(&shown), None, "{shown}");
    }
    assert!(faults.is_sorted_by_key(|fault| (fault.line, fault.column)));
}

/// Cases are found by their numbers as they are found one after the other.
fn listed(study: &Study, chance: &mut Chance) {
    assert!(study.standing_for().next().is_some());
    assert!(study.case(study.len()).is_none());
    let raw = study.raw_len();
    let from = chance.below(raw.min(1 << 40) as usize) as u64;
    let (first, columns) = study.columns(from, raw.min(from + 50));
    let range: Vec<(u64, Case)> = study.range(from, raw.min(from + 50)).collect();
    assert_eq!(columns.len(), range.len());
    let mut shown = columns.shown();
    for (i, (number, case)) in range.iter().enumerate() {
        assert_eq!(*number, first + i as u64);
        let found = study.case(*number).expect("a case");
        assert_eq!(format!("{:?}", found.values), format!("{:?}", case.values));
        assert_eq!(
            format!("{:?}", found.values),
            format!("{:?}", shown.at(i).values)
        );
        let broken = Violation::all(&study.violations(*number)).is_some();
        assert_eq!(columns.may_be_solved(i), !broken);
    }
}

/// Solves a case if it is short; `solve` and `sweep` give it the same metrics.
fn solved(study: &Study, case: &Case, violations: &[Violation]) -> bool {
    let problem = &study.problem;
    if !violations.is_empty() {
        assert!(violations.iter().all(|v| !v.message.is_empty()));
        return false;
    }
    let steps = problem.steps(case);
    assert!(steps >= 1, "a case without steps");
    if problem.work(case) > WORK {
        return false;
    }
    let Ok(solution) = batch::solution(study, case) else {
        return true;
    };
    assert_eq!(solution.computed.time.len() as u64, steps + 1);
    assert!(solution.computed.is_finite(), "a history is not finite");
    let finite = |metric: &Option<f64>| metric.is_none_or(f64::is_finite);
    assert!(
        solution.metrics.iter().all(finite),
        "{:?}",
        solution.metrics
    );
    if !study.once {
        let mut cases = Cases::new(problem.schema());
        cases.push(case);
        let found = problem.sweep(&cases, &[0]);
        for (swept, solved) in found.row(0).zip(&solution.metrics) {
            assert_eq!(swept.map(f64::to_bits), solved.map(f64::to_bits));
        }
    }
    true
}

/// Draws every figure; each is well-formed.
fn drawn(study: &Study) {
    let mut outcomes = Vec::new();
    let wishes = Wishes {
        keep: &|_| true,
        ..Wishes::METRICS
    };
    let run = batch::run(study, &ProgressBar::hidden(), &wishes, |done| {
        let found = done.outcomes(study).into_iter();
        outcomes.extend(found.map(|(_, outcome)| outcome));
        Ok(())
    });
    run.expect("a run");
    assert_eq!(outcomes.len() as u64, study.len());
    for figure in &study.figures {
        let svg = svg(study, figure, &outcomes);
        assert_eq!(xml::fault(&svg), None, "figure {}: {svg}", figure.name);
    }
}

fn svg(study: &Study, figure: &Figure, outcomes: &[Outcome]) -> String {
    let chosen = outcomes.iter().filter(|o| figure.filter.matches(&o.case));
    let chosen: Vec<&Outcome> = chosen.collect();
    let snapshots = |outcome: &&Outcome| {
        let (problem, case) = (&study.problem, &outcome.case);
        let times = figure.kind.snapshot_times(&**problem, case);
        match outcome.failure {
            None if !times.is_empty() => problem.snapshots(case, &times),
            _ => Vec::new(),
        }
    };
    let snapshots: Vec<_> = chosen.iter().map(snapshots).collect();
    let shown = chosen
        .iter()
        .zip(&snapshots)
        .map(|(outcome, snapshots)| DrawnCase {
            case: &outcome.case,
            metrics: &outcome.metrics,
            solution: outcome.solution.as_deref(),
            snapshots,
        });
    let shown: Vec<DrawnCase> = shown.collect();
    let sheet = figures::sheet(study, figure, &shown);
    figures::svg(&sheet, figures::style::DPI).expect("a picture")
}
