//! The friction oscillator of [F (19)], dimensionless (reference: X'' + X + S = 0, X(0) = x0, X'(0) = 0).

mod once;
mod tables;

use super::parameter::Parameter;
use super::{Budget, Case, Metric, Problem, Quantity, Solution, Violation, time_rules};
use crate::exact::coulomb::Coulomb;
use crate::exact::regularised::{self, Regularised};
use crate::history::History;
use crate::lane::Lane;
use crate::law::{DisplacementControl, Law, VelocityControl};
use crate::metrics::{self, steps};
use crate::stepper::{Start, Stepper};
use crate::structure::Mode;
use tables::{BUDGETS, METRICS, PARAMETERS, QUANTITIES};

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
        let (Some(step), Some(duration)) = (case.number("dT"), case.number("duration")) else {
            return Vec::new();
        };
        time_rules("dT", step, duration)
    }

    fn steps(&self, case: &Case) -> u64 {
        let number = |name| case.number(name).unwrap_or(f64::NAN);
        steps(number("duration"), number("dT"))
    }

    fn solve(&self, case: &Case, wanted: &[usize]) -> Result<Solution, String> {
        let number = |name: &str| {
            case.number(name)
                .ok_or_else(|| format!("{name} is not given"))
        };
        let (step, x0) = (number("dT")?, number("x0")?);
        let last = self.steps(case);
        let computed = if case.choice("law") == "velocity-control" {
            let law = VelocityControl {
                compliance: Lane([number("beta")?]),
                limit: Lane([1.0]),
            };
            run(law, 0.0, x0, step, last)
        } else {
            let (slip, force) = release(case.choice("initial_slip"), x0, number("alpha")?);
            let law = DisplacementControl {
                compliance: Lane([number("alpha")?]),
                limit: Lane([1.0]),
                slip: Lane([slip]),
            };
            run(law, force, x0, step, last)
        };
        self.judged(case, computed, wanted)
    }

    fn solve_once(&self, case: &Case, wanted: &[usize]) -> Result<Solution, String> {
        let given = case.number("dT").zip(case.number("x0"));
        let (step, x0) = given.ok_or("dT or x0 is not given")?;
        let computed =
            once::run(case, step, x0, self.steps(case)).ok_or("a step has no solution")?;
        self.judged(case, computed, wanted)
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
    /// A computed history beside the exact one, with its metrics.
    fn judged(&self, case: &Case, computed: History, wanted: &[usize]) -> Result<Solution, String> {
        let number = |name: &str| {
            case.number(name)
                .ok_or_else(|| format!("{name} is not given"))
        };
        let x0 = number("x0")?;
        if !computed.is_finite() {
            return Err("the motion leaves the range of double precision".into());
        }
        let exact = self.exact(case, &computed.time).ok_or("x0 is not given")?;
        let mut metrics = metrics::friction::evaluate(x0, number("duration")?, &computed, &exact);
        let budget = wanted
            .iter()
            .any(|&row| !METRICS[row].default)
            .then(|| between(case, &computed.time))
            .flatten()
            .map(|between| metrics::friction::budget(x0, &computed, &exact, &between));
        metrics.extend(budget.unwrap_or([None; 4]));
        Ok(Solution {
            computed,
            exact,
            metrics,
        })
    }
}

/// The case's own model in continuous time, between the exact solution and the computed one; `None` where the run is
/// too long for it.
fn between(case: &Case, times: &[f64]) -> Option<History> {
    if *times.last()? > regularised::LATEST {
        return None;
    }
    let x0 = case.number("x0")?;
    let mut motion = match case.number("alpha") {
        Some(alpha) => {
            let (_, force) = release(case.choice("initial_slip"), x0, alpha);
            Regularised::displacement(x0, alpha, force)
        }
        None => Regularised::velocity(x0, case.number("beta")?),
    };
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

/// `last` steps of X'' + X + S = 0 from rest at `x0` with S(0) = `force`.
fn run(mut law: impl Law<1>, force: f64, x0: f64, step: f64, last: u64) -> History {
    let start = Start {
        mode: [Mode {
            omega2: 1.0,
            phi2: 1.0,
        }],
        displacement: Lane([x0]),
        velocity: Lane([0.0]),
    };
    let mut stepper = Stepper::new(Lane([step]), &[start], Lane([0.0]), Lane([force]));
    let mut history = History::with_capacity(last as usize + 1);
    let mut contact = stepper.contact();
    for i in 0..=last {
        if i > 0 {
            contact = stepper.step(&mut law);
        }
        let [Lane([r]), Lane([rdot]), Lane([s])] =
            [contact.displacement, contact.velocity, contact.force];
        history.push(i as f64 * step, r, rdot, s);
    }
    history
}
