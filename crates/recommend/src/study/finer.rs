//! Whether a candidate keeps its metrics with half its step, and with the next finer mesh of the study.

use super::candidate::{Choice, Finer, Mesh, worst};
use super::judge::{Judge, all_of};
use crate::calibrate::Stopped;
use crate::with_finer_step;
use slipgap_problem::problem::table::cases::Cases;
use std::collections::BTreeMap;

/// The first candidate that keeps all metrics, also with half its step and with the next finer mesh; else the first that keeps them at
/// all. The candidates are in the order of their costs.
pub(super) fn choose(choices: &mut [Choice], judge: &mut Judge) -> Result<Option<usize>, Stopped> {
    let mut first = None;
    for at in 0..choices.len() {
        if choices[at].worst > 1.0 {
            continue;
        }
        let finer = look(&choices[at], choices, judge)?;
        choices[at].finer = Some(finer);
        if finer.holds() {
            return Ok(Some(at));
        }
        first = first.or(Some(at));
    }
    Ok(first)
}

fn look(choice: &Choice, choices: &[Choice], judge: &mut Judge) -> Result<Finer, Stopped> {
    let (free, values) = choice.free();
    let problem = &*judge.study.problem;
    let mut halves = Cases::new(problem.schema());
    for case in all_of(&choice.cases(judge, free, &values)) {
        halves.push(&with_finer_step(problem, &case, 2));
    }
    let judged = judge.judged(&halves)?;
    let step = worst(judge, &judged);
    let meshes = choices
        .iter()
        .filter(|other| other.size != choice.size && other.is_whole(judge));
    let meshes = meshes.filter_map(|other| Some((choice.differing(other)?, other)));
    let mut mesh = Mesh::NotChosen;
    // By the number that chooses the mesh: the next finer one.
    let mut next: BTreeMap<usize, &Choice> = BTreeMap::new();
    for (row, other) in meshes {
        mesh = Mesh::Finest;
        if other.size > choice.size {
            let known = next.entry(row).or_insert(other);
            if other.size < known.size {
                *known = other;
            }
        }
    }
    for other in next.into_values() {
        let judged = judge.judged(&other.cases(judge, free, &values))?;
        let own = worst(judge, &judged);
        mesh = match mesh {
            Mesh::Next(known) => Mesh::Next(known.max(own)),
            _ => Mesh::Next(own),
        };
    }
    Ok(Finer { step, mesh })
}
