//! Tolerances: each check of a study held against every case it names.

use crate::batch::Outcome;
use crate::problem::Case;
use crate::problem::parameter::shortest;
use crate::study::Study;

/// One check on one case.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// The case.
    pub case: u64,
    /// Name of the metric.
    pub metric: String,
    /// Its value; `None` where it is undefined, which fails.
    pub value: Option<f64>,
    /// Smallest value allowed.
    pub min: Option<f64>,
    /// Largest value allowed.
    pub max: Option<f64>,
}

impl Verdict {
    /// Whether the value lies within the limits.
    pub fn holds(&self) -> bool {
        self.value.is_some_and(|x| {
            self.min.is_none_or(|min| x >= min) && self.max.is_none_or(|max| x <= max)
        })
    }
}

impl Verdict {
    /// The limits in words.
    pub fn limits(&self) -> String {
        match (self.min, self.max) {
            (Some(min), Some(max)) => format!("{} .. {}", shortest(min), shortest(max)),
            (Some(min), None) => format!(">= {}", shortest(min)),
            (None, Some(max)) => format!("<= {}", shortest(max)),
            (None, None) => String::new(),
        }
    }
}

/// The checks of the study that name a case, by their place in the file, each with the value that it judges.
pub fn judged(
    study: &Study,
    case: &Case,
    value: impl Fn(usize) -> Option<f64>,
) -> impl Iterator<Item = (usize, Option<f64>)> {
    let named = study.checks.iter().enumerate();
    let named = named.filter(|(_, check)| check.filter.matches(case));
    named.map(move |(i, check)| (i, value(check.metric).filter(|x| !x.is_nan())))
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

/// Holds every check of the study that names a case against it, each with its place in the file.
pub fn judge(study: &Study, number: u64, outcome: &Outcome, verdicts: &mut Vec<(usize, Verdict)>) {
    let values = judged(study, &outcome.case, |metric| outcome.metrics[metric]);
    verdicts.extend(values.map(|(check, value)| (check, verdict(study, check, number, value))));
}
