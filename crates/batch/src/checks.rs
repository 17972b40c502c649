//! The checks of a study: limits of metrics, tested for every case that they apply to.

use crate::{Outcome, PartResult};
use slipgap_problem::problem::Case;
use slipgap_problem::problem::numbers::parameter::shortest;
use slipgap_study::{Groups, Study};

/// One check on one case.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// The case.
    pub case: u64,
    /// Name of the metric.
    pub metric: String,
    /// Its value; `None` if it is undefined, which fails.
    pub value: Option<f64>,
    /// Smallest value allowed.
    pub min: Option<f64>,
    /// Largest value allowed.
    pub max: Option<f64>,
}

impl Verdict {
    /// Whether the value is within the limits.
    pub fn holds(&self) -> bool {
        is_within(self.value, [self.min, self.max])
    }
}

/// Whether there is a value, and within these limits.
fn is_within(value: Option<f64>, [min, max]: [Option<f64>; 2]) -> bool {
    value.is_some_and(|x| min.is_none_or(|min| x >= min) && max.is_none_or(|max| x <= max))
}

/// Whether a value meets a check of the study, given by its index.
pub fn is_met(study: &Study, check: usize, value: Option<f64>) -> bool {
    let check = &study.checks[check];
    is_within(value, [check.min, check.max])
}

impl Verdict {
    /// The limits as text.
    pub fn limits(&self) -> String {
        match (self.min, self.max) {
            (Some(min), Some(max)) => format!("{} .. {}", shortest(min), shortest(max)),
            (Some(min), None) => format!(">= {}", shortest(min)),
            (None, Some(max)) => format!("<= {}", shortest(max)),
            (None, None) => String::new(),
        }
    }
}

/// The checks of single cases that apply to a case, by their index in the study, each with the value that it tests.
fn applicable(
    study: &Study,
    case: &Case,
    value: impl Fn(usize) -> Option<f64>,
) -> impl Iterator<Item = (usize, Option<f64>)> {
    let checks = study.checks.iter().enumerate();
    let applicable = checks
        .filter(|(_, check)| study.reduction(check.metric).is_none() && check.filter.matches(case));
    applicable.map(move |(i, check)| (i, value(check.metric).filter(|x| !x.is_nan())))
}

/// The verdict of a check of the study on a case.
pub fn verdict(study: &Study, check: usize, case: u64, value: Option<f64>) -> Verdict {
    let check = &study.checks[check];
    Verdict {
        case,
        metric: study.measures[check.metric].name.clone(),
        value,
        min: check.min,
        max: check.max,
    }
}

/// Adds the verdict of every check that applies to a case, with the index of the check in the study.
pub fn judge(study: &Study, number: u64, outcome: &Outcome, verdicts: &mut Vec<(usize, Verdict)>) {
    let values = applicable(study, &outcome.case, |metric| outcome.metrics[metric]);
    verdicts.extend(values.map(|(check, value)| (check, verdict(study, check, number, value))));
}

/// The values that the checks of a study test, check by check, each with its case; NaN if it is undefined. The verdicts are made
/// one by one, because a million of them take half a gigabyte.
#[derive(Debug, Clone, Default)]
pub struct TestedValues(Vec<Vec<(u64, f64)>>);

impl TestedValues {
    /// The verdicts, sorted by check and case.
    pub fn verdicts(&self, study: &Study) -> impl Iterator<Item = Verdict> {
        let checks = self.0.iter().enumerate();
        checks.flat_map(move |(check, values)| {
            let values = values.iter();
            values.map(move |(case, x)| {
                verdict(study, check, *case, Some(*x).filter(|x| !x.is_nan()))
            })
        })
    }
}

/// Collects the values that checks test, part by part.
#[derive(Debug)]
pub struct CheckCollector<'a> {
    values: Vec<Vec<(u64, f64)>>,
    reduced: ReducedChecks<'a>,
}

impl<'a> CheckCollector<'a> {
    /// No cases yet.
    pub fn new(study: &'a Study) -> CheckCollector<'a> {
        CheckCollector {
            values: vec![Vec::new(); study.checks.len()],
            reduced: ReducedChecks::new(study),
        }
    }

    /// Adds a part.
    pub fn add(&mut self, part: &PartResult) {
        let values = &mut self.values;
        self.reduced.add_part(part, &mut |number, check, value| {
            values[check].push((number, value.unwrap_or(f64::NAN)));
        });
    }

    /// The reductions of cases without a value, as [`ReducedChecks::empty`] gives them.
    pub fn empty(&self) -> impl Iterator<Item = (&'a str, u64, u64)> {
        self.reduced.empty()
    }

    /// The values of all checks, after all parts.
    pub fn finish(mut self) -> TestedValues {
        for (check, case, value) in self.reduced.values() {
            self.values[check].push((case, value.unwrap_or(f64::NAN)));
        }
        TestedValues(self.values)
    }
}

/// The values that the checks of reductions test, collected case by case.
#[derive(Debug)]
pub struct ReducedChecks<'a> {
    study: &'a Study,
    /// Each with its index in the study.
    groups: Vec<(usize, Groups<'a>)>,
}

impl<'a> ReducedChecks<'a> {
    /// No cases yet.
    pub fn new(study: &'a Study) -> ReducedChecks<'a> {
        let checks = study.checks.iter().enumerate();
        let reduced = checks
            .filter_map(|(i, check)| Some((i, Groups::new(vec![study.reduction(check.metric)?]))));
        ReducedChecks {
            study,
            groups: reduced.collect(),
        }
    }

    /// Adds a case; `value` gives its metrics by their rows of the measures.
    pub fn add(&mut self, number: u64, case: &Case, value: impl Fn(usize) -> Option<f64>) {
        for (check, groups) in &mut self.groups {
            if self.study.checks[*check].filter.matches(case) {
                groups.add(number, case, &value);
            }
        }
    }

    /// Adds the cases of a part. `take` receives what the checks of single cases test: the number of the case, the index of the
    /// check in the study, and the value.
    pub fn add_part(&mut self, part: &PartResult, take: &mut dyn FnMut(u64, usize, Option<f64>)) {
        if self.study.checks.is_empty() {
            return;
        }
        let mut shown = part.cases.shown();
        for row in 0..part.len() {
            let (number, case) = (part.number(row), shown.at(row));
            let value = |metric| part.metrics.value(row, metric);
            for (check, value) in applicable(self.study, case, value) {
                take(number, check, value);
            }
            self.add(number, case, value);
        }
    }

    /// The reductions of cases without a value, check by check: the name, and how many of how many cases.
    pub fn empty(&self) -> impl Iterator<Item = (&'a str, u64, u64)> {
        let counted = self.groups.iter().map(|(check, groups)| {
            let name = &self.study.measures[self.study.checks[*check].metric].name;
            let counts = groups.values(0);
            let (empty, cases) = counts.fold((0, 0), |(empty, cases), reduced| {
                (empty + reduced.empty, cases + reduced.cases)
            });
            (name.as_str(), empty, cases)
        });
        counted.filter(|(_, empty, _)| *empty > 0)
    }

    /// The values by check and group: the index of the check in the study, the case that has the value, or the first one of
    /// the group, and the value.
    pub fn values(&self) -> impl Iterator<Item = (usize, u64, Option<f64>)> {
        self.groups.iter().flat_map(|(check, groups)| {
            let values = groups.values(0);
            values.map(|reduced| (*check, reduced.at.unwrap_or(reduced.first), reduced.value))
        })
    }
}
