//! The motion of the oscillator with the law of a case in continuous time.

use super::case::OscillatorCase;
use super::coulomb;
use super::law_of_case::PlainLaw;
use crate::contact::ContactLaw;
use crate::exact::regularised::{self, Regularised};
use crate::history::History;
use crate::problem::preset::Between;

/// Whether the motion with a law has a closed form.
pub fn in_closed_form(law: &ContactLaw) -> bool {
    PlainLaw::of(law).is_some()
}

/// The motion at these times, alone between the exact and the computed one; `None` outside the range of [`regularised::holds`], and
/// where the integration does not get to its end.
pub fn between(case: &OscillatorCase, times: &[f64], with_error: bool) -> Option<Between> {
    let (x0, force, end) = (case.x0, case.force, *times.last()?);
    let Some(law) = PlainLaw::of(&case.law) else {
        return Between::integrated(times, with_error, |times, tolerance| {
            Some(vec![case.preset().integrated(times, tolerance)?])
        });
    };
    let mut solution = match law {
        PlainLaw::Velocity(law) if law.compliance == 0.0 => {
            return Some(Between::in_closed_form([coulomb(x0, times)]));
        }
        PlainLaw::Displacement(law) => regularised::holds(x0, law.compliance, force, end)
            .then(|| Regularised::displacement(x0, law.compliance, force))?,
        PlainLaw::Velocity(law) => regularised::holds(x0, law.compliance, 0.0, end)
            .then(|| Regularised::velocity(x0, law.compliance))?,
    };
    let motion = History::sample(times, |time| solution.at(time).values());
    Some(Between::in_closed_form([motion]))
}

#[cfg(test)]
mod tests;
