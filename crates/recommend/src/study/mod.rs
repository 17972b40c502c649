//! Recommends among the candidates that a study lists: the cheapest one that keeps metrics within tolerances in every physical case.

mod candidate;
mod errors;
mod finer;
mod judge;
mod reference;
mod sweep;
pub mod usage;

pub use candidate::{Choice, Finer, Mesh, State};
pub use errors::is_error;
pub use reference::{From, Reference};
pub use sweep::sweep;

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
    /// cheapest of these; `None` if no candidate keeps them.
    pub chosen: Option<usize>,
    /// What the metrics are compared with; `None` if no candidate has all physical cases.
    pub reference: Option<Reference>,
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
        for choice in &mut choices {
            candidate::decide(choice, &mut judge)?;
        }
        choices.sort_by_key(|choice| choice.cost);
        let chosen = finer::choose(&mut choices, &mut judge)?;
        Ok((choices, chosen, reference))
    };
    let (choices, chosen, reference) = compare().map_err(|_| Error::Interrupted)?;
    let (energy, conditions, solved) = (judge.limits, judge.conditions.len(), judge.solved);
    Ok(Advice {
        choices,
        chosen,
        reference,
        energy,
        conditions,
        solved,
        study,
    })
}
