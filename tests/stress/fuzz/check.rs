//! The assertions about every text: it has faults with places inside it, or it is a study whose cases can be listed, solved
//! and drawn.

use crate::random_choice::RandomChoice;
use crate::xml;
use indicatif::ProgressBar;
use slipgap::batch::groups::sobol::DesignMetrics;
use slipgap::batch::output::reductions::ReducedMetrics;
use slipgap::batch::{self, RunOptions, ShownCases};
use slipgap::error::{Error, Fault};
use slipgap::figures;
use slipgap::problem::table::cases::Cases;
use slipgap::problem::{Case, Violation};
use slipgap::study::{Figure, Study, parse};
use slipgap::study_figures;

/// Largest number of steps times modes of a case that is solved, and of all cases of a study that is drawn.
const WORK: u64 = 20_000;

/// Largest number of cases of a study that is drawn.
const DRAWN: u64 = 40;

/// Largest number of characters of a message, which quotes the text and the names allowed.
const LONGEST: usize = 3000;

/// The last stage that a text has passed.
#[derive(Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    #[default]
    Refused,
    Read,
    Solved,
    Drawn,
}

/// Makes all assertions about a text; returns its last stage.
pub fn check(text: &str, random: &mut RandomChoice) -> Stage {
    let study = match parse("s.json", text) {
        Ok(study) => study,
        Err(Error::Faults(faults)) => {
            refused(text, &faults);
            return Stage::Refused;
        }
        Err(other) => panic!("another error: {other}"),
    };
    listed(&study, random);
    let mut stage = Stage::Read;
    for _ in 0..3 {
        let number = match study.len() {
            0 => panic!("a study without cases"),
            len => random.below(len.min(1 << 40) as usize) as u64,
        };
        let case = study.case(number).expect("a case");
        if solved(&study, &case, &study.violations(number)) {
            stage = Stage::Solved;
        }
    }
    let small = |study: &Study| {
        study
            .cases()
            .map(|case| study.problem.work(&case, &[]).steps)
            .sum::<u64>()
            <= WORK
    };
    if study.raw_len() <= DRAWN && small(&study) && !study.figures.is_empty() {
        drawn(&study);
        stage = Stage::Drawn;
    }
    stage
}

/// Every fault has a place inside the text, in order, and a message of one printable line.
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

/// Cases by number are the same as cases in order.
fn listed(study: &Study, random: &mut RandomChoice) {
    assert!(study.enumeration().representative_cases().next().is_some());
    assert!(study.case(study.len()).is_none());
    let raw = study.raw_len();
    let from = random.below(raw.min(1 << 40) as usize) as u64;
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

/// Solves a case if it is short. `solve` and `sweep` give the same metrics. It returns whether the case breaks no rule.
fn solved(study: &Study, case: &Case, violations: &[Violation]) -> bool {
    let problem = &study.problem;
    if !violations.is_empty() {
        assert!(violations.iter().all(|v| !v.message.is_empty()));
        return false;
    }
    let steps = case.steps();
    assert!(steps >= 1, "a case without steps");
    if problem.work(case, &[]).steps > WORK {
        return false;
    }
    let Ok(solution) = study.solve(case) else {
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

/// Draws every figure as well-formed SVG.
fn drawn(study: &Study) {
    let needed = study_figures::needed(study);
    let (mut shown, mut cases) = (ShownCases::new(study.problem.schema()), 0);
    let options = RunOptions {
        keep_history: Some(&|_| true),
        ..RunOptions::METRICS
    };
    let mut reductions = ReducedMetrics::new(study);
    let mut designs = DesignMetrics::new(study);
    let run = batch::run(study, &ProgressBar::hidden(), &options, |mut part| {
        reductions.add(&part);
        designs.add(part.first, &part.cases, &part.metrics);
        cases += part.len() as u64;
        study_figures::add(study, &needed, &mut part, &mut shown);
        Ok(())
    });
    run.expect("a run");
    let table = reductions.table().expect("a table");
    assert_eq!(table.is_some(), study.reductions().next().is_some());
    assert_eq!(cases, study.len());
    for figure in &study.figures {
        let svg = svg(study, figure, &shown, &designs);
        assert_eq!(xml::fault(&svg), None, "figure {}: {svg}", figure.name);
    }
}

fn svg(study: &Study, figure: &Figure, shown: &ShownCases, designs: &DesignMetrics) -> String {
    let sheet = study_figures::with_data(study, figure, shown, designs, figures::sheet);
    figures::svg(&sheet, figures::style::DPI).expect("a picture")
}
