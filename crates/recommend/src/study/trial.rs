//! What further tests of a candidate that keeps all metrics show, and the choice by them.

use super::candidate::Choice;
use super::finer::{finer_steps, next_mesh};
use super::fresh::Fresh;
use super::judge::Judge;
use super::verdict::Trial;
use crate::calibrate::Stopped;

/// The first candidate that keeps all metrics, also in all further tests; else the first that does with its own step or mesh only. The
/// candidates are in the order of their costs.
pub(super) fn choose(choices: &mut [Choice], judge: &mut Judge) -> Result<Option<usize>, Stopped> {
    let mut first = None;
    let mut fresh = Fresh::of(judge);
    for at in 0..choices.len() {
        if choices[at].worst > 1.0 {
            continue;
        }
        let others = [&*choices; 2];
        let trial = trial(&choices[at], others, first.is_none(), &mut fresh, judge)?;
        choices[at].trial = Some(trial);
        if trial.holds() {
            return Ok(Some(at));
        }
        first = first.or(trial.is_robust().then_some(at));
    }
    Ok(first)
}

/// What further tests show of a candidate that keeps all metrics: with others that may be its neighbours, and others that may have finer
/// meshes. If it is not converged, `is_first` says whether it may be the answer.
pub(super) fn trial(
    choice: &Choice,
    [near, meshes]: [&[Choice]; 2],
    is_first: bool,
    fresh: &mut Option<Fresh>,
    judge: &mut Judge,
) -> Result<Trial, Stopped> {
    let mut trial = Trial {
        step: finer_steps(choice, judge)?,
        mesh: next_mesh(choice, meshes, judge)?,
        neighbours: neighbours(choice, near, judge),
        fresh: None,
    };
    let matters = trial.is_robust() && (trial.is_converged() || is_first);
    if let Some(fresh) = fresh.as_mut().filter(|_| matters) {
        trial.fresh = Some(fresh.quotient(choice, judge)?);
    }
    Ok(trial)
}

/// The largest quotient of the candidates that have the next smaller or the next larger value of a parameter in `neighbours`, and
/// are else the same.
fn neighbours(choice: &Choice, choices: &[Choice], judge: &Judge) -> f64 {
    let rows = judge.recommend.neighbours.iter();
    let next = rows.flat_map(|row| {
        let value = choice.number(*row).unwrap_or(f64::NAN);
        let others: Vec<(f64, &Choice)> = choices
            .iter()
            .filter(|other| choice.differing(other) == Some(*row))
            .filter_map(|other| Some((other.number(*row)?, other)))
            .collect();
        let smaller = others.iter().filter(|other| other.0 < value);
        let larger = others.iter().filter(|other| other.0 > value);
        let smaller = smaller.max_by(|a, b| a.0.total_cmp(&b.0));
        let larger = larger.min_by(|a, b| a.0.total_cmp(&b.0));
        [smaller, larger].map(|other| other.map_or(0.0, |other| other.1.worst))
    });
    next.fold(0.0, f64::max)
}
