//! One page without other files that shows cases in motion: the scheme magnified, contacts lit, forces and ground motion below.
//!
//! A film is one motion: the drawing of a scene with the displacements of its parts, thinned, and its contacts.
//! The page draws films; it computes nothing but the places of lines between two steps.

mod bars_film;
mod film;
mod label;
mod oscillator;
mod page;
mod structure_film;

pub use page::MOST_BYTES;

use film::Film;
use slipgap_problem::problem::Case;
use slipgap_problem::problem::numbers::unit::Dimension;
use slipgap_problem::problem::{Solution, Violation};
use slipgap_study::{Study, error::Error};

/// What an animation shows.
#[derive(Debug, Clone, Default)]
pub struct Shown {
    /// Numbers of one case or of two; of none, the first case that a history figure shows, or else the first case.
    pub cases: Vec<u64>,
    /// Whether the exact motion of the one case is shown, too.
    pub exact: bool,
}

/// The page of a study: its bytes depend on the study and on `shown` only.
///
/// # Errors
/// A case that the study does not have, that cannot be solved, or that has no exact motion.
pub fn animate(study: &Study, name: &str, shown: &Shown) -> Result<String, Error> {
    let numbers = match shown.cases.as_slice() {
        [] => vec![usual_case(study)],
        given => given.to_vec(),
    };
    if numbers.len() > 2 || numbers.len() == 2 && shown.exact {
        let what = "an animation shows one case, two cases, or one case and its exact motion";
        return Err(Error::Usage(what.into()));
    }
    // A film shows all nodes.
    if let Some(programs) = study.programs() {
        programs.ask_for_all();
    }
    let mut solved: Vec<(u64, Case, Solution)> = Vec::new();
    for number in numbers {
        let case = case(study, number)?;
        let unsolved = |why: String| Error::Usage(format!("case {number} cannot be solved: {why}"));
        if let Some(broken) = Violation::all(&study.violations(number)) {
            return Err(unsolved(broken));
        }
        if let Some(fault) = study
            .problem
            .as_structure()
            .and_then(|structure| structure.history_fault(&case))
        {
            return Err(unsolved(format!("{} {}", fault.parameter, fault.message)));
        }
        let solution = study
            .solve(&case)
            .map_err(|why| unsolved(why.to_string()))?;
        solved.push((number, case, solution));
    }
    let cases: Vec<&Case> = solved.iter().map(|(_, case, _)| case).collect();
    let labels = label::labels(study, &cases);
    let mut films = Vec::new();
    for ((number, case, solution), label) in solved.iter().zip(&labels) {
        let label = match shown.exact {
            true => "computed".to_owned(),
            false => format!("case {number}: {label}"),
        };
        films.push(film(study, case, (solution, false), label)?);
    }
    if let (true, Some((number, case, solution))) = (shown.exact, solved.first()) {
        films.push(film(study, case, (solution, true), "exact".into()).map_err(
            |error| match error {
                Error::Usage(why) => Error::Usage(format!("case {number}: {why}")),
                other @ (Error::Faults(_)
                | Error::Io { .. }
                | Error::Unsolved(_)
                | Error::PartsMissing(_)
                | Error::Busy(_)
                | Error::Interrupted
                | Error::Internal(_)) => other,
            },
        )?);
    }
    let head = match (shown.exact, solved.first()) {
        (true, Some((number, ..))) => format!("case {number}: {}", labels[0]),
        _ => String::new(),
    };
    let ground = solved.first().and_then(|(_, case, _)| {
        study
            .problem
            .as_structure()
            .and_then(|structure| structure.ground_motion(case))
    });
    page::page(study, (name, &head), &films, ground.as_ref())
}

/// The first case that a history figure shows, or else the first case.
fn usual_case(study: &Study) -> u64 {
    /// Cases that are looked at.
    const MOST: u64 = 100_000;
    let last = study.raw_len().min(MOST);
    let mut figures = study.figures.iter();
    let figure = figures.find(|figure| figure.kind.draws_histories());
    let mut cases = study.range(0, last);
    let of_figure = figure.and_then(|figure| cases.find(|(_, case)| figure.filter.matches(case)));
    of_figure.map_or(0, |(number, _)| number)
}

fn case(study: &Study, number: u64) -> Result<Case, Error> {
    study.case(number).ok_or_else(|| {
        let last = study.len().saturating_sub(1);
        let allowed = match number > last {
            true => format!("the study has cases 0 to {last}"),
            false => "this combination does not meet the condition".into(),
        };
        Error::Usage(format!("case {number}: {allowed}"))
    })
}

/// The film of a case: its computed motion, or the exact one.
fn film<'a>(
    study: &Study,
    case: &Case,
    (solution, exact): (&'a Solution, bool),
    label: String,
) -> Result<Film<'a>, Error> {
    let history = match exact {
        true => &solution.exact,
        false => &solution.computed,
    };
    if history.is_empty() || history.channels.is_empty() {
        let what = "there is no exact motion to show; a study of structures asks for it by \"contacts_reference\"";
        return Err(Error::Usage(what.into()));
    }
    let problem = &*study.problem;
    let film = match (
        problem
            .as_structure()
            .and_then(|structure| structure.scheme(case)),
        problem
            .as_textbook()
            .map_or(Vec::new(), |textbook| textbook.snapshots(case, &[0.0]))
            .is_empty(),
    ) {
        (Some(scheme), _) => structure_film::film(problem, case, &scheme, history),
        (None, false) => bars_film::film(problem, case, history, exact),
        (None, true) => oscillator::film(history),
    };
    let dt = case.at(problem.schema().step).unwrap_or(1.0);
    Ok(Film { label, dt, ..film })
}

/// The unit of a dimension in words of the page; empty for a number without.
fn unit(study: &Study, dimension: Dimension) -> String {
    let schema = study.problem.schema();
    let known = schema.units.iter().find(|unit| unit.dimension == dimension);
    match schema.described {
        true => study
            .problem
            .as_structure()
            .and_then(|structure| structure.unit_name(dimension))
            .unwrap_or_default(),
        false => known.map_or_else(String::new, |unit| unit.name.to_string()),
    }
}
