//! Rules and notes about the step and the duration, which every problem has.

use super::numbers::short::short;
use super::{MOST_STEPS, Violation};
use crate::metrics::steps;
use crate::solve::Warning;

/// The note that a motion ends at this time, before its duration.
pub(super) fn ends_early(end: f64) -> (Warning, String) {
    let text = format!("the last step is at {}", short(end));
    (Warning::EndsEarly, text)
}

/// The rules that every problem has for its `step` and duration.
pub(super) fn time_rules(step_name: &'static str, step: f64, duration: f64) -> Vec<Violation> {
    let message = if step > duration {
        format!("must be at most duration = {duration}, got {step}")
    } else if steps(duration, step) > MOST_STEPS {
        format!(
            "gives {:.3e} steps, at most {MOST_STEPS} fit in memory",
            duration / step
        )
    } else {
        return Vec::new();
    };
    vec![Violation {
        parameter: step_name.into(),
        message,
        at: None,
    }]
}
