//! Recommends parameters: compares the candidates of a study (`study`), with free parameters by the search of `calibrate`.

pub mod calibrate;
mod energy_change;
pub mod format;
mod shipped;
pub mod study;

pub use energy_change::{EnergyChange, energy_change, energy_gain};
pub use shipped::shipped;

use slipgap_problem::problem::friction::FrictionOscillator;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::{Case, Problem};
use slipgap_system::methods::Description;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Cost of a case: steps times modes or nodes, times the sub-steps of its method.
pub fn cost(problem: &dyn Problem, case: &Case) -> u64 {
    // The work of the other problems has them.
    let has_own = problem.name() == FrictionOscillator.schema().name;
    problem.work(case, &[]).steps * if has_own { sub_steps(case) } else { 1 }
}

/// Number of sub-steps of the method of a case.
fn sub_steps(case: &Case) -> u64 {
    let method = Description::named(case.choice("method")).and_then(Description::with_defaults);
    method.map_or(1, |method| method.count_of_sub_steps())
}

/// The case with a part of its step.
pub fn with_finer_step(problem: &dyn Problem, case: &Case, factor: u32) -> Case {
    let step = problem.schema().step;
    let mut finer = case.clone();
    let divided = |step: f64| Value::Number(step / f64::from(factor));
    finer.values[step] = case.at(step).map(divided);
    finer
}

/// Ends a search from another thread; clones end the same one.
#[derive(Debug, Clone, Default)]
pub struct Stop(Arc<AtomicBool>);

impl Stop {
    /// Ends the search.
    pub fn stop(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether the search ends.
    pub fn is_stopped(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}
