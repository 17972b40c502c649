//! Recommends among the candidates that a study lists: the cheapest one that keeps metrics within tolerances in every physical case.

mod answer_text;
mod candidate;
mod converged;
mod errors;
mod finer;
mod fresh;
mod judge;
mod levels;
mod reference_motion;
mod search;
mod sweep;
mod trial;
pub mod usage;
mod verdict;

pub use answer_text::shown;
pub use candidate::Choice;
pub use converged::NotConverged;
pub use errors::{From, is_error};
pub use reference_motion::Reference;
pub use sweep::sweep;
pub use verdict::{Mesh, State, Trial};

use crate::calibrate::Stopped;
use crate::{EnergyChange, Stop};
use judge::Judge;
use levels::{Levels, Place};
use search::{Found, Search};
use slipgap_problem::problem::structure::metrics::metric::OF_ALL;
use slipgap_study::error::Error;
use slipgap_study::{Block, Input, MOST_CASES, Study};

/// Most candidates that are all solved and listed. More of them are searched in the order of their costs.
const LISTED: u64 = 1000;

/// How often the step of one of many candidates is halved in its tests.
const HALVINGS: u32 = 4;

/// Most combinations of a study whose candidates are all solved.
const MOST_LISTED: u64 = 1_000_000;

/// The candidates of a study, and the recommended one.
#[derive(Debug)]
pub struct Advice {
    /// The study with the metrics to keep as its only ones.
    pub study: Study,
    /// All candidates, the cheapest first; of more than a thousand those that were better than all cheaper ones.
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
    /// Of many candidates, how many were compared, and how many there are: the others cost more.
    pub searched: Option<[u64; 2]>,
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
    let mut levels = Levels::of(&study);
    let count = levels.count();
    let is_searched = count > LISTED && recommend.free.is_empty() && judge.has_quotients();
    let cases = study.blocks.iter().map(Block::raw_len).sum::<u64>();
    if !is_searched && cases > MOST_LISTED {
        let searched = format!(
            "more only without free parameters, for default metrics, and for more than {LISTED} candidates"
        );
        return Err(Error::Usage(format!(
            "{}: recommend: {cases} combinations; at most {MOST_LISTED}, {searched}",
            input.file
        )));
    }
    let found = match is_searched {
        true => searched(&mut levels, &mut judge),
        false => compared(&levels, &mut judge),
    };
    let (found, reference, not_converged) = found.map_err(|_| Error::Interrupted)?;
    let (energy, conditions, solved) = (judge.limits, judge.conditions.len(), judge.solved);
    let chosen = found.chosen.filter(|_| not_converged.is_empty());
    Ok(Advice {
        choices: found.choices,
        chosen,
        reference,
        not_converged,
        energy,
        conditions,
        solved,
        searched: is_searched.then_some([found.compared, count]),
        study,
    })
}

/// What is recommended, what the metrics are compared with, and the lists that end too early.
type Compared = (Found, Option<Reference>, Vec<NotConverged>);

/// Compares all candidates.
fn compared(levels: &Levels, judge: &mut Judge) -> Result<Compared, Stopped> {
    let listed = levels.listed();
    let mut choices: Vec<Choice> = listed
        .map(|alternative| candidate::choice(alternative, judge))
        .collect();
    let reference = reference_motion::refer(&choices, judge)?;
    let not_converged = converged::not_converged(&choices, judge)?;
    for choice in &mut choices {
        candidate::decide(choice, judge)?;
    }
    choices.sort_by_key(|choice| choice.cost);
    let found = Found {
        chosen: trial::choose(&mut choices, judge)?,
        compared: choices.len() as u64,
        choices,
    };
    Ok((found, reference, not_converged))
}

/// Compares candidates in the order of their costs, up to the recommended one.
fn searched<'a>(levels: &mut Levels<'a>, judge: &mut Judge<'a>) -> Result<Compared, Stopped> {
    levels.sort();
    judge.halvings = HALVINGS;
    // The judge must know the physical cases of every block.
    for first in levels.firsts() {
        levels.choice(&first, judge);
    }
    let finest = levels.finest();
    let before = finest.iter().flat_map(|candidate| levels.before(candidate));
    let places: Vec<Place> = before.chain(finest.clone()).collect();
    let choices: Vec<Choice> = places
        .iter()
        .filter_map(|candidate| levels.choice(candidate, judge))
        .collect();
    let reference = reference_motion::refer(&choices, judge)?;
    let not_converged = converged::not_converged(&choices, judge)?;
    let found = Search::new(levels, judge).run()?;
    Ok((found, reference, not_converged))
}
