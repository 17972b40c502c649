//! The search: levels in the order of their costs, somewhat beyond the first candidate that reaches all targets.

use super::level::{Found, LevelSearch};
use super::{Answer, Request, SearchSpace};
use rayon::prelude::*;

/// Largest cost of alternatives, relative to the recommended case.
const BEYOND: u64 = 2;

/// Largest cost of a case that also reaches the target with a finer step, relative to the first one that does only with its own.
const BEYOND_OWN_STEP: u64 = 4;

/// Cost up to which such a case is always searched; it takes some seconds.
const OWN_STEP: u64 = 40_000;

/// Levels searched at once. It does not depend on the number of threads, because the number of solved cases is printed.
const BATCH: usize = 16;

/// Searches a space.
pub fn search(space: &dyn SearchSpace, request: &Request) -> Answer {
    let mut order: Vec<(u64, usize)> = space.costs().into_iter().zip(0..).collect();
    order.sort_unstable();
    let mut answer = Answer::default();
    for batch in order.chunks(BATCH) {
        if answer.is_complete(batch[0].0) || request.stop.is_stopped() {
            break;
        }
        let smallest = answer.smallest();
        let results: Vec<(Found, u64)> = batch
            .par_iter()
            .map(|(cost, index)| {
                if request.stop.is_stopped() {
                    return (Found::default(), 0);
                }
                let mut level = LevelSearch::new(space, request, space.level(*index));
                (level.best(*cost, smallest), level.solved)
            })
            .collect();
        for (found, solved) in results {
            answer.solved += solved;
            answer.add(found);
        }
    }
    answer.settle();
    answer
}

/// Whether candidates of this cost are too expensive, because there is one that costs less: `chosen` reaches the target, `own_step`
/// only with its own step.
pub fn too_expensive(cost: u64, chosen: Option<u64>, own_step: Option<u64>) -> bool {
    match (chosen, own_step) {
        (Some(chosen), _) => cost > BEYOND * chosen,
        (None, Some(own)) => cost > OWN_STEP.max(BEYOND_OWN_STEP * own),
        (None, None) => false,
    }
}

impl Answer {
    /// The smallest `worst` so far.
    fn smallest(&self) -> f64 {
        self.front.last().map_or(f64::INFINITY, |last| last.worst)
    }

    /// Whether no candidate of this cost is needed: there is an answer, and there are two clearly better alternatives, or
    /// the cost is too high for one.
    fn is_complete(&self, cost: u64) -> bool {
        let chosen = self.chosen();
        let better = |at: usize| self.better(at);
        if chosen.and_then(better).and_then(better).is_some() {
            return true;
        }
        let own_step = self.own_step.as_ref().map(|own| own.cost);
        too_expensive(cost, chosen.map(|at| self.front[at].cost), own_step)
    }

    /// Adds a level that is not cheaper than the others, if it has something better.
    fn add(&mut self, found: Found) {
        if self.own_step.is_none() {
            self.own_step = found.own_step;
        }
        if let Some(candidate) = found.best.filter(|c| c.worst < self.smallest()) {
            self.front.pop_if(|last| last.cost == candidate.cost);
            self.front.push(candidate);
        }
    }

    /// If no candidate reaches the target with a finer step, one that does only with its own is chosen. A candidate that costs more than
    /// the chosen one is not worth a mention.
    fn settle(&mut self) {
        let Some(own) = &self.own_step else { return };
        match self.chosen() {
            Some(at) if self.front[at].cost <= own.cost => self.own_step = None,
            Some(_) => {}
            None => {
                let cost = own.cost;
                self.front.retain(|candidate| candidate.cost < cost);
                self.front.extend(self.own_step.take());
            }
        }
    }
}
