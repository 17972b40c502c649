//! What metrics are compared with: the exact motion where it is known, else the finest motion of the study.

use super::candidate::{Choice, all_of};
use super::judge::Judge;
use crate::calibrate::Stopped;
use crate::with_finer_step;
use slipgap_solver::problem::Case;
use slipgap_solver::problem::cases::Cases;
use slipgap_solver::problem::parameter::Value;

/// Metrics that are 0 for the exact motion, besides those with the word error in their names.
const ZERO: [&str; 4] = [
    "numerical_dissipation",
    "max_overlap",
    "residual_motion",
    "rdot_oscillation",
];

/// Whether a metric is an error itself, which is 0 for the exact motion: its tolerance is its largest value.
pub fn is_error(name: &str) -> bool {
    let base = name.split('(').next().unwrap_or_default().trim();
    let starts = ["energy_drift", "sprague_geers"];
    let ends = base.ends_with("_error") || base.contains("_error_");
    ends || ZERO.contains(&base) || starts.iter().any(|start| base.starts_with(start))
}

/// Where the value comes from that a metric is compared with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum From {
    /// The metric is an error: 0.
    Zero,
    /// The exact motion of the finest candidate.
    Exact,
    /// The motion of the finest candidate with half its step.
    Finest,
}

/// What the metrics of a study are compared with.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// The finest candidate: its chosen parameters with their values.
    pub finest: Vec<(usize, Value)>,
    /// By metric: where its values come from; the finest motion if it is needed in any physical case.
    pub from: Vec<From>,
}

impl Reference {
    /// The error of each metric of a case: itself, or its relative difference from the reference.
    pub fn errors(
        judge: &Judge,
        case: &Case,
        metrics: &[Option<f64>],
        reference: &[Option<f64>],
    ) -> Vec<f64> {
        let within = judge.recommend.within.iter().zip(reference);
        let error = |((row, _), reference): (&(usize, f64), &Option<f64>)| {
            let own = judge.study.measure_value(*row, case, &|at| metrics[at]);
            match is_error(&judge.study.measures[*row].name) {
                true => own.map_or(f64::INFINITY, f64::abs),
                false => difference(own, *reference),
            }
        };
        within.map(error).collect()
    }
}

/// The relative difference of a value from its reference; 0 if both are undefined.
fn difference(own: Option<f64>, reference: Option<f64>) -> f64 {
    match (own, reference) {
        (None, None) => 0.0,
        (Some(own), Some(reference)) if own == reference => 0.0,
        (Some(own), Some(reference)) => ((own - reference) / reference).abs(),
        _ => f64::INFINITY,
    }
}

impl Judge<'_> {
    /// Finds the references of all physical cases, from the finest candidate that has all of them: the one with most elements, then
    /// with the smallest step, then the last one.
    pub fn refer(&mut self, choices: &[Choice]) -> Result<Option<Reference>, Stopped> {
        let whole = choices.iter().filter(|choice| choice.is_whole(self));
        let Some(finest) = whole.max_by(|a, b| a.compare_fineness(b)) else {
            return Ok(None);
        };
        let (study, recommend) = (self.study, self.recommend);
        let problem = &*study.problem;
        let cases = all_of(&finest.cases(self, &[], &[]));
        let rows = || recommend.within.iter().map(|own| own.0);
        let mut references = vec![Vec::new(); self.conditions.len()];
        let mut from: Vec<From> = rows()
            .map(|row| match is_error(&study.measures[row].name) {
                true => From::Zero,
                false => From::Exact,
            })
            .collect();
        let metrics: Vec<usize> = (0..problem.metrics().len()).collect();
        for case in &cases {
            let exact = match from.iter().all(|own| *own == From::Zero) {
                true => vec![None; metrics.len()],
                false => problem.exact_metrics(case, &metrics),
            };
            let value = |row: usize| study.measure_value(row, case, &|at| exact[at]);
            let mut values: Vec<Option<f64>> = rows().map(value).collect();
            let unknown =
                |(value, from): (&Option<f64>, &From)| value.is_none() && *from != From::Zero;
            if values.iter().zip(&from).any(unknown) {
                let mut half = Cases::new(problem.schema());
                half.push(&with_finer_step(problem, case, 2));
                let solved = self.solve(&half)?;
                let found = solved.first().and_then(|own| own.as_ref().ok());
                for ((value, from), row) in values.iter_mut().zip(&mut from).zip(rows()) {
                    if value.is_none() && *from != From::Zero {
                        *from = From::Finest;
                        *value = found.and_then(|(metrics, _)| {
                            study.measure_value(row, case, &|at| metrics[at])
                        });
                    }
                }
            }
            let condition = self.condition(case);
            if let Some(at) = self.conditions.iter().position(|own| *own == condition) {
                references[at] = values;
            }
        }
        self.references = references;
        Ok(Some(Reference {
            finest: finest.values.clone(),
            from,
        }))
    }
}
