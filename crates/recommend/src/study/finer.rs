//! Whether a candidate keeps its metrics with finer steps, and with the next finer mesh of the study.

use super::candidate::Choice;
use super::judge::{Judge, all_of};
use super::verdict::Mesh;
use crate::calibrate::Stopped;
use crate::with_finer_step;
use slipgap_problem::problem::table::cases::Cases;
use std::collections::BTreeMap;

/// The largest quotient of error and tolerance of a candidate with 1/2, 1/4 .. of its step, up to the first one above 1. Of many candidates
/// some keep the metrics with half their step by chance.
pub(super) fn finer_steps(choice: &Choice, judge: &mut Judge) -> Result<f64, Stopped> {
    let (free, values) = choice.free();
    let problem = &*judge.study.problem;
    let cases = all_of(&choice.cases(judge, free, &values));
    let mut largest: f64 = 0.0;
    for halving in 1..=judge.halvings {
        let mut finer = Cases::new(problem.schema());
        for case in &cases {
            finer.push(&with_finer_step(problem, case, 1 << halving));
        }
        let judged = judge.judged(&finer)?;
        largest = largest.max(judge.worst(&judged));
        if largest > 1.0 {
            break;
        }
    }
    Ok(largest)
}

/// The same with the next finer meshes.
pub(super) fn next_mesh(
    choice: &Choice,
    choices: &[Choice],
    judge: &mut Judge,
) -> Result<Mesh, Stopped> {
    let (free, values) = choice.free();
    let meshes = choices
        .iter()
        .filter(|other| other.size != choice.size && other.is_whole(judge))
        .filter_map(|other| Some((choice.differing(other)?, other)));
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
        let quotient = judge.worst(&judged);
        mesh = match mesh {
            Mesh::Next(known) => Mesh::Next(known.max(quotient)),
            Mesh::NotChosen | Mesh::Finest => Mesh::Next(quotient),
        };
    }
    Ok(mesh)
}
