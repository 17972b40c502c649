//! Recommends among the candidates that a study lists: the cheapest one that keeps metrics within tolerances in every physical case.

mod candidate;
mod converged;
mod errors;
mod finer;
mod fresh;
mod judge;
mod reference;
mod sweep;
mod trial;
pub mod usage;
mod verdict;
mod words;

pub use candidate::Choice;
pub use converged::NotConverged;
pub use errors::{From, is_error};
pub use reference::Reference;
pub use sweep::sweep;
pub use verdict::{Mesh, State, Trial};
pub use words::shown;

use crate::calibrate::Stopped;
use crate::{EnergyChange, Stop};
use judge::Judge;
use slipgap_problem::problem::structure::metrics::metric::OF_ALL;
use slipgap_study::error::Error;
use slipgap_study::{Input, MOST_CASES, Study};

/// The candidates of a study, and the recommended one.
#[derive(Debug)]
pub struct Advice {
    /// The study with the metrics to keep as its only ones.
    pub study: Study,
    /// All candidates, the cheapest first.
    pub choices: Vec<Choice>,
    /// The place of the recommended one. If every candidate that keeps all metrics does only with its own step and mesh, it is the
    /// cheapest of these; `None` if no candidate keeps them, and if the list of a chosen number ends too early.
    pub chosen: Option<usize>,
    /// What the metrics are compared with; `None` if no candidate has all physical cases.
    pub reference: Option<Reference>,
    /// The chosen numbers whose list ends before the metrics converge.
    pub not_converged: Vec<NotConverged>,
    /// Largest changes of energy allowed.
    pub energy: EnergyChange,
    /// Number of physical cases.
    pub conditions: usize,
    /// Number of cases solved.
    pub solved: u64,
}

/// Compares the candidates of a study.
///
/// # Errors
/// A study without `recommend`, the faults of the study, and a search that was stopped.
pub fn advise(input: &Input, stop: &Stop) -> Result<Advice, Error> {
    let described = input.study(MOST_CASES)?.problem.schema().described;
    let energies: &[&str] = if described { &OF_ALL } else { &[] };
    let study = input.candidate_study(energies, MOST_CASES)?;
    let Some(recommend) = &study.recommend else {
        return Err(Error::Usage(format!(
            "{}: the study has no key \"recommend\", which names the parameters to choose and the metrics to keep, as in \
             \"recommend\": {{\"over\": [\"dt\"], \"within\": {{\"peak(deck)\": 0.02}}}}",
            input.file
        )));
    };
    let mut judge = Judge::new(&study, recommend, stop);
    let mut compare = || -> Result<_, Stopped> {
        let mut choices = candidate::candidates(&mut judge);
        let reference = reference::refer(&choices, &mut judge)?;
        let not_converged = converged::not_converged(&choices, &mut judge)?;
        for choice in &mut choices {
            candidate::decide(choice, &mut judge)?;
        }
        choices.sort_by_key(|choice| choice.cost);
        let chosen = trial::choose(&mut choices, &mut judge)?;
        let chosen = chosen.filter(|_| not_converged.is_empty());
        Ok((choices, chosen, reference, not_converged))
    };
    let (choices, chosen, reference, not_converged) = compare().map_err(|_| Error::Interrupted)?;
    let (energy, conditions, solved) = (judge.limits, judge.conditions.len(), judge.solved);
    Ok(Advice {
        choices,
        chosen,
        reference,
        not_converged,
        energy,
        conditions,
        solved,
        study,
    })
}
