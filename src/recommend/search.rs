//! The search: rungs by rising cost, a little beyond the first candidate that reaches all targets.

use super::{Answer, Request, Rung, Space, Tried};
use crate::problem::Case;
use crate::problem::cases::Cases;
use rayon::prelude::*;

/// How much dearer than the recommended case alternatives are looked for.
const BEYOND: u64 = 2;

/// Rungs searched at once. A number of its own, not that of the threads: the number of cases solved is printed.
const BATCH: usize = 16;

/// Searches a space.
pub fn search(space: &dyn Space, request: &Request) -> Answer {
    let mut order: Vec<(u64, usize)> = space.costs().into_iter().zip(0..).collect();
    order.sort_unstable();
    let mut answer = Answer::default();
    for batch in order.chunks(BATCH) {
        if answer.suffices(batch[0].0) {
            break;
        }
        let least = answer.least();
        let found: Vec<(Option<Tried>, u64)> = batch
            .par_iter()
            .map(|(cost, at)| {
                let mut level = Level::new(space, request, space.rung(*at));
                (level.best(*cost, least), level.solved)
            })
            .collect();
        for (tried, solved) in found {
            answer.solved += solved;
            answer.take(tried);
        }
    }
    answer
}

impl Answer {
    /// The smallest `worst` so far.
    fn least(&self) -> f64 {
        self.front.last().map_or(f64::INFINITY, |last| last.worst)
    }

    /// Whether nothing of this cost is needed any more: the answer is there, and two that are clearly better.
    fn suffices(&self, cost: u64) -> bool {
        let Some(chosen) = self.chosen() else {
            return false;
        };
        let twice = self.better(chosen).and_then(|first| self.better(first));
        twice.is_some() || cost > BEYOND * self.front[chosen].cost
    }

    /// Adds one that is not cheaper than the others, if it is better.
    fn take(&mut self, tried: Option<Tried>) {
        if let Some(tried) = tried.filter(|tried| tried.worst < self.least()) {
            self.front.pop_if(|last| last.cost == tried.cost);
            self.front.push(tried);
        }
    }
}

/// What is known of a case.
#[derive(Debug, Clone)]
struct Judged {
    misses: Vec<f64>,
    /// The largest miss over its limit; infinite where the case has no solution or gains too much energy.
    worst: f64,
    /// A gain of energy that a larger loss may hide.
    hidden: bool,
}

/// A rung being searched.
struct Level<'a> {
    space: &'a dyn Space,
    request: &'a Request,
    rung: Rung,
    judged: Vec<Option<Judged>>,
    solved: u64,
}

impl<'a> Level<'a> {
    fn new(space: &'a dyn Space, request: &'a Request, rung: Rung) -> Level<'a> {
        Level {
            space,
            request,
            judged: vec![None; rung.cases.len()],
            rung,
            solved: 0,
        }
    }

    /// The best candidate that is better than `least`. Neighbours are solved only of those that still can be.
    fn best(&mut self, cost: u64, least: f64) -> Option<Tried> {
        let mut cases = Cases::new(self.space.problem().schema());
        for case in &self.rung.cases {
            cases.push(case);
        }
        let mut alive: Vec<usize> = (0..self.rung.candidates.len()).collect();
        let rounds = self.rung.candidates.iter().map(Vec::len).max();
        for round in 0..rounds.unwrap_or(0) {
            self.solve(&cases, &alive, round);
            alive.retain(|at| self.worst(*at) < least);
        }
        alive.sort_by(|a, b| self.worst(*a).total_cmp(&self.worst(*b)));
        let at = alive.into_iter().find(|at| self.keeps_energy(*at))?;
        let tried = &self.rung.candidates[at];
        let miss = |target: usize| {
            let judged = tried.iter().filter_map(|case| self.judged[*case].as_ref());
            judged.map(|j| j.misses[target]).fold(0.0, f64::max)
        };
        Some(Tried {
            cases: tried.iter().map(|i| self.rung.cases[*i].clone()).collect(),
            cost,
            misses: (0..self.request.targets.len()).map(miss).collect(),
            worst: self.worst(at),
        })
    }

    /// Solves neighbour `round` of candidates, as far as that is still to be done.
    fn solve(&mut self, cases: &Cases, candidates: &[usize], round: usize) {
        let cells = candidates
            .iter()
            .filter_map(|at| self.rung.candidates[*at].get(round));
        let open = cells.filter(|case| self.judged[**case].is_none());
        let mut rows: Vec<u32> = open.map(|case| *case as u32).collect();
        rows.sort_unstable();
        rows.dedup();
        let found = self.space.problem().sweep(cases, &rows);
        for (place, row) in rows.iter().enumerate() {
            let metrics: Vec<Option<f64>> = found.row(place).collect();
            self.judged[*row as usize] = Some(self.judge(&metrics));
        }
        self.solved += rows.len() as u64;
    }

    fn judge(&self, metrics: &[Option<f64>]) -> Judged {
        let targets = &self.request.targets;
        let misses: Vec<f64> = targets.iter().map(|t| t.miss(metrics)).collect();
        let over = misses.iter().zip(targets).map(|(m, t)| m / t.limit);
        let mut judged = Judged {
            worst: over.fold(0.0, f64::max),
            misses,
            hidden: false,
        };
        if let (Some(limit), Some(rows)) = (self.request.energy_gain, self.space.energy_drifts()) {
            match rows.map(|row| metrics.get(row).copied().flatten()) {
                [Some(largest), Some(last)] if largest <= limit && last <= limit => {
                    judged.hidden = largest < -limit;
                }
                _ => judged.worst = f64::INFINITY,
            }
        }
        judged
    }

    /// The largest miss over its limit of a candidate and its neighbours, as far as they are solved.
    fn worst(&self, candidate: usize) -> f64 {
        let tried = self.rung.candidates[candidate].iter();
        let judged = tried.filter_map(|case| self.judged[*case].as_ref());
        judged.map(|j| j.worst).fold(0.0, f64::max)
    }

    /// Whether neither a candidate nor a neighbour gains more energy than allowed on the way to a larger loss.
    fn keeps_energy(&mut self, candidate: usize) -> bool {
        let tried = self.rung.candidates[candidate].clone();
        tried.into_iter().all(|case| {
            let hidden = |judged: &Judged| judged.hidden;
            if !self.judged[case].as_ref().is_some_and(hidden) {
                return true;
            }
            self.solved += 1;
            let within = self.gain(&self.rung.cases[case]) <= self.request.energy_gain;
            if let Some(judged) = &mut self.judged[case] {
                judged.hidden = false;
                if !within {
                    judged.worst = f64::INFINITY;
                }
            }
            within
        }) && self.worst(candidate).is_finite()
    }

    /// The gain of energy of a case by itself.
    fn gain(&self, case: &Case) -> Option<f64> {
        let solution = self.space.problem().solve(case, &[]);
        let gain = solution.map(|s| self.space.energy_gain(case, &s.computed));
        // Without a solution: more than any limit.
        gain.unwrap_or(Some(f64::INFINITY))
    }
}
