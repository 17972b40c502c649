//! Finer steps: whether a case still reaches its targets when its step is halved until the metrics stop changing.

use super::Target;
use slipgap_problem::problem::Case;
use slipgap_problem::problem::Problem;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::table::cases::Cases;

/// Halvings that are always made. Half the step alone is not enough: it may still be too long for the contact mode.
pub const LEAST_HALVINGS: u32 = 4;

/// Most halvings.
pub const MOST_HALVINGS: u32 = 10;

/// A metric is settled when two halvings in a row change it by at most this part of its limit.
pub const SETTLED: f64 = 0.02;

/// A case whose next halving costs more, in steps times modes, is not refined beyond the halvings that are always made.
const MOST_WORK: u64 = 1_000_000_000;

/// What finer steps show of a case that reaches its targets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// It reaches them at every finer step, and the metrics are settled.
    Holds,
    /// It misses one.
    Misses,
    /// The metrics still change at the last step.
    Unsettled,
}

/// The outcome, and by what the step was divided at last.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Refined {
    /// The outcome.
    pub outcome: Outcome,
    /// A power of two.
    pub factor: u32,
}

impl Refined {
    /// Whether the case reaches its targets at every step.
    pub fn holds(&self) -> bool {
        self.outcome == Outcome::Holds
    }
}

/// The case with a part of its step.
pub fn with_finer_step(problem: &dyn Problem, case: &Case, factor: u32) -> Case {
    let step = problem.schema().step;
    let mut finer = case.clone();
    let divided = |step: f64| Value::Number(step / f64::from(factor));
    finer.values[step] = case.at(step).map(divided);
    finer
}

/// A case that is still refined.
struct Open {
    at: usize,
    /// The values of the metrics at the last step, over their limits.
    last: Vec<f64>,
    /// Halvings in a row that changed little.
    quiet: u32,
}

/// Halves the steps of cases, all together, until each is decided. Adds the number of cases solved.
pub fn refine(
    problem: &dyn Problem,
    targets: &[Target],
    cases: &[Case],
    solved: &mut u64,
) -> Vec<Refined> {
    let undecided = Refined {
        outcome: Outcome::Unsettled,
        factor: 1 << MOST_HALVINGS,
    };
    let mut refined = vec![undecided; cases.len()];
    let open = |at| Open {
        at,
        last: vec![f64::INFINITY; targets.len()],
        quiet: 0,
    };
    let mut all: Vec<Open> = (0..cases.len()).map(open).collect();
    for halving in 1..=MOST_HALVINGS {
        let factor = 1 << halving;
        let mut finer = Cases::new(problem.schema());
        all.retain(|open| {
            let case = with_finer_step(problem, &cases[open.at], factor);
            let affordable = halving <= LEAST_HALVINGS || problem.work(&case) <= MOST_WORK;
            match affordable {
                true => finer.push(&case),
                false => refined[open.at].factor = factor / 2,
            }
            affordable
        });
        let rows: Vec<u32> = (0..all.len() as u32).collect();
        let table = problem.sweep(&finer, &rows);
        *solved += rows.len() as u64;
        let mut place = 0;
        all.retain_mut(|open| {
            let metrics: Vec<Option<f64>> = table.row(place).collect();
            place += 1;
            let outcome = open.next(targets, &metrics, halving);
            if let Some(outcome) = outcome {
                refined[open.at] = Refined { outcome, factor };
            }
            outcome.is_none()
        });
        if all.is_empty() {
            break;
        }
    }
    refined
}

impl Open {
    /// The outcome, if the metrics of the next step decide it. What a method of first order still changes after a halving is as much
    /// as that halving changed, so the sum of error and change must be within the limit.
    fn next(
        &mut self,
        targets: &[Target],
        metrics: &[Option<f64>],
        halving: u32,
    ) -> Option<Outcome> {
        let errors: Vec<f64> = targets.iter().map(|t| t.error(metrics) / t.limit).collect();
        if !errors.iter().all(|error| *error <= 1.0) {
            return Some(Outcome::Misses);
        }
        let values: Vec<f64> = targets.iter().map(|t| t.signed_error(metrics)).collect();
        let values: Vec<f64> = values
            .iter()
            .zip(targets)
            .map(|(x, t)| x / t.limit)
            .collect();
        let changes = values
            .iter()
            .zip(&self.last)
            .map(|(x, last)| (x - last).abs());
        let changes: Vec<f64> = changes.collect();
        self.last = values;
        self.quiet = match changes.iter().all(|change| *change <= SETTLED) {
            true => self.quiet + 1,
            false => 0,
        };
        let mut ends = errors
            .iter()
            .zip(&changes)
            .map(|(error, change)| error + change);
        let settled = halving >= LEAST_HALVINGS && self.quiet >= 2 && ends.all(|end| end <= 1.0);
        settled.then_some(Outcome::Holds)
    }
}
