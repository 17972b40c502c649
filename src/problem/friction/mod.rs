//! The friction oscillator of [F (19)], dimensionless (reference: X'' + X + S = 0, X(0) = x0, X'(0) = 0).

mod once;
mod run;
mod sweep;
mod tables;

use super::parameter::Parameter;
use super::sweep::sweep;
use super::{
    Budget, Case, Cases, Found, Metric, NOT_GIVEN, OUT_OF_RANGE, Problem, Quantity, Solution,
    Violation, time_rules,
};
use crate::exact::coulomb::Coulomb;
use crate::exact::regularised::{self, Regularised};
use crate::history::History;
use crate::lane::Lane;
use crate::metrics::{self, cells, steps};
use crate::stepper::Contact;
use run::Given;
use tables::{BUDGETS, METRICS, PARAMETERS, QUANTITIES, SCALES, rows};

/// A mass on a spring that slides on a surface with Coulomb friction, released at rest from x0 [F Fig. 4].
#[derive(Debug)]
pub struct FrictionOscillator;

impl Problem for FrictionOscillator {
    fn name(&self) -> &'static str {
        "friction-oscillator"
    }

    fn meaning(&self) -> &'static str {
        "free vibration of a mass on a spring with Coulomb friction, released at rest from x0 [F]"
    }

    fn parameters(&self) -> &'static [Parameter] {
        &PARAMETERS
    }

    fn metrics(&self) -> &'static [Metric] {
        &METRICS
    }

    fn quantities(&self) -> &'static [Quantity] {
        &QUANTITIES
    }

    fn budgets(&self) -> &'static [Budget] {
        &BUDGETS
    }

    fn step(&self) -> &'static str {
        "dT"
    }

    fn scales(&self) -> &'static [[&'static str; 2]] {
        &SCALES
    }

    fn time_title(&self) -> &'static str {
        "Dimensionless time *T* = *ω*_n_*t*"
    }

    fn time_in_pi(&self) -> bool {
        true
    }

    fn history_columns(&self) -> [&'static str; 6] {
        ["T", "X", "V", "S", "X_exact", "V_exact"]
    }

    fn complete(&self, case: &mut Case) -> Vec<Violation> {
        let (Some(step), Some(duration)) = (case.at(rows::DT), case.at(rows::DURATION)) else {
            return Vec::new();
        };
        time_rules("dT", step, duration)
    }

    fn steps(&self, case: &Case) -> u64 {
        let number = |row| case.at(row).unwrap_or(f64::NAN);
        steps(number(rows::DURATION), number(rows::DT))
    }

    fn solve(&self, case: &Case, wanted: &[usize]) -> Result<Solution, String> {
        let given = Given::of(case, self.steps(case)).ok_or(NOT_GIVEN)?;
        let mut computed = History::with_capacity(given.last as usize + 1);
        let (mut stepper, law) = run::start(&[given]);
        for i in 0..=given.last {
            if i > 0 {
                stepper.step(&law);
            }
            let Contact {
                displacement: Lane([x]),
                velocity: Lane([v]),
                force: Lane([s]),
                ..
            } = stepper.contact();
            computed.push(i as f64 * given.step, x, v, s);
        }
        let end = stepper.contact();
        self.judged(case, &given, computed, run::work(&[given], &end), wanted)
    }

    fn sweep(&self, cases: &Cases, rows: &[u32]) -> Found {
        sweep(self, cases, rows, |case| Given::of(case, self.steps(case)))
    }

    fn solve_once(&self, case: &Case, wanted: &[usize]) -> Result<Solution, String> {
        let given = Given::of(case, self.steps(case)).ok_or(NOT_GIVEN)?;
        let computed = once::run(case, &given).ok_or("a step has no solution")?;
        let work = metrics::friction::work(&computed, given.x0.abs());
        self.judged(case, &given, computed, Lane([work]), wanted)
    }

    fn exact(&self, case: &Case, times: &[f64]) -> Option<History> {
        let coulomb = Coulomb::new(case.number("x0")?);
        let mut exact = History::with_capacity(times.len());
        for &time in times {
            let state = coulomb.at(time);
            exact.push(time, state.displacement, state.velocity, state.force);
        }
        Some(exact)
    }
}

impl FrictionOscillator {
    /// A computed history beside the exact one, with its metrics; `work` over |x0|.
    fn judged(
        &self,
        case: &Case,
        given: &Given,
        computed: History,
        work: Lane<1>,
        wanted: &[usize],
    ) -> Result<Solution, String> {
        if !computed.is_finite() {
            return Err(OUT_OF_RANGE.into());
        }
        let x: Vec<_> = computed.displacement.iter().map(|x| Lane([*x])).collect();
        let own = metrics::friction::evaluate(&x, work, &given.exact_at_steps());
        let exact = self.exact(case, &computed.time).ok_or(NOT_GIVEN)?;
        let budget = wanted
            .iter()
            .any(|&row| !METRICS[row].default)
            .then(|| between(case, &computed.time))
            .flatten()
            .map(|between| metrics::friction::budget(given.x0, &computed, &exact, &between));
        let metrics = cells(own)
            .into_iter()
            .chain(budget.unwrap_or([None; 4]))
            .collect();
        Ok(Solution {
            computed,
            exact,
            metrics,
        })
    }
}

/// The case's own model in continuous time, between the exact solution and the computed one; `None` where that is not
/// known, see [`regularised::holds`].
fn between(case: &Case, times: &[f64]) -> Option<History> {
    let (x0, end) = (case.number("x0")?, *times.last()?);
    let mut motion = match case.number("alpha") {
        Some(alpha) => {
            let (_, force) = release(case.choice("initial_slip"), x0, alpha);
            regularised::holds(x0, alpha, force, end)
                .then(|| Regularised::displacement(x0, alpha, force))
        }
        None => {
            let beta = case.number("beta")?;
            regularised::holds(x0, beta, 0.0, end).then(|| Regularised::velocity(x0, beta))
        }
    }?;
    let mut history = History::with_capacity(times.len());
    for &time in times {
        let state = motion.at(time);
        history.push(time, state.displacement, state.velocity, state.force);
    }
    Some(history)
}

/// Slip r^S(0) and force S(0) at release ([F] does not say which).
fn release(initial_slip: &str, x0: f64, alpha: f64) -> (f64, f64) {
    let sign = x0.signum();
    match initial_slip {
        "pulled" => (x0 - sign * alpha, sign),
        "sliding" => (x0 + sign * alpha, -sign),
        _ => (x0, 0.0),
    }
}
