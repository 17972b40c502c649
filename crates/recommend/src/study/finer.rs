//! Whether a candidate keeps its metrics with half its step, and with the next finer mesh of the study.

use super::candidate::{Choice, all_of, worst};
use super::judge::Judge;
use crate::calibrate::Stopped;
use crate::with_finer_step;
use slipgap_solver::problem::cases::Cases;
use slipgap_solver::problem::parameter::Value;

/// The largest quotients of error and tolerance with half the step, and with the next finer meshes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Finer {
    /// With half the step.
    pub step: f64,
    /// With the next finer mesh.
    pub mesh: Mesh,
}

/// What a finer mesh shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Mesh {
    /// The study does not choose a number of elements.
    NotChosen,
    /// No candidate has a finer one.
    Finest,
    /// The largest quotient with the next larger number of elements among the candidates.
    Next(f64),
}

impl Finer {
    /// Whether the metrics are kept there, too.
    pub fn holds(&self) -> bool {
        let mesh = match self.mesh {
            Mesh::NotChosen => true,
            Mesh::Finest => false,
            Mesh::Next(mesh) => mesh <= 1.0,
        };
        self.step <= 1.0 && mesh
    }
}

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
    let mut mesh = Mesh::NotChosen;
    for (row, n) in choice.counts() {
        let larger = |other: &&Choice| is_finer(choice, other, row, n) && other.is_whole(judge);
        let next = choices
            .iter()
            .filter(larger)
            .min_by_key(|other| other.counts());
        let Some(next) = next else {
            mesh = Mesh::Finest;
            break;
        };
        let judged = judge.judged(&next.cases(judge, free, &values))?;
        let own = worst(judge, &judged);
        mesh = match mesh {
            Mesh::Next(known) => Mesh::Next(known.max(own)),
            _ => Mesh::Next(own),
        };
    }
    Ok(Finer { step, mesh })
}

/// Whether candidates differ only in this whole number, of which the other has a larger one.
fn is_finer(choice: &Choice, other: &Choice, row: usize, n: u64) -> bool {
    let others = |of: &Choice| -> Vec<(usize, Value)> {
        let free = of
            .free()
            .0
            .iter()
            .map(|free| free.parameter)
            .collect::<Vec<_>>();
        let own = of
            .values
            .iter()
            .filter(|(own, _)| *own != row && !free.contains(own));
        own.copied().collect()
    };
    let larger = |(own, m): &(usize, u64)| *own == row && *m > n;
    others(choice) == others(other) && other.counts().iter().any(larger)
}
