//! The search: levels in the order of their costs, somewhat beyond the first candidate that reaches all targets.

use super::{Answer, Candidate, CostLevel, Request, SearchSpace};
use crate::problem::Case;
use crate::problem::cases::Cases;
use rayon::prelude::*;

/// Largest cost of alternatives, relative to the recommended case.
const BEYOND: u64 = 2;

/// Levels searched at once. It does not depend on the number of threads, because the number of solved cases is printed.
const BATCH: usize = 16;

/// Searches a space.
pub fn search(space: &dyn SearchSpace, request: &Request) -> Answer {
    let mut order: Vec<(u64, usize)> = space.costs().into_iter().zip(0..).collect();
    order.sort_unstable();
    let mut answer = Answer::default();
    for batch in order.chunks(BATCH) {
        if answer.is_complete(batch[0].0) {
            break;
        }
        let smallest = answer.smallest();
        let results: Vec<(Option<Candidate>, u64)> = batch
            .par_iter()
            .map(|(cost, index)| {
                let mut level = LevelSearch::new(space, request, space.level(*index));
                (level.best(*cost, smallest), level.solved)
            })
            .collect();
        for (candidate, solved) in results {
            answer.solved += solved;
            answer.add(candidate);
        }
    }
    answer
}

impl Answer {
    /// The smallest `worst` so far.
    fn smallest(&self) -> f64 {
        self.front.last().map_or(f64::INFINITY, |last| last.worst)
    }

    /// Whether no candidate of this cost is needed: there is an answer, and there are two clearly better alternatives, or
    /// the cost is too high for one.
    fn is_complete(&self, cost: u64) -> bool {
        let Some(chosen) = self.chosen() else {
            return false;
        };
        let second = self.better(chosen).and_then(|first| self.better(first));
        second.is_some() || cost > BEYOND * self.front[chosen].cost
    }

    /// Adds a candidate that is not cheaper than the others, if it is better.
    fn add(&mut self, candidate: Option<Candidate>) {
        if let Some(candidate) = candidate.filter(|c| c.worst < self.smallest()) {
            self.front.pop_if(|last| last.cost == candidate.cost);
            self.front.push(candidate);
        }
    }
}

/// The errors of a solved case.
#[derive(Debug, Clone)]
struct CaseErrors {
    errors: Vec<f64>,
    /// The largest quotient of error and limit; infinite if the case has no solution or gains too much energy.
    worst: f64,
    /// Whether a gain of energy is unknown, because a loss is larger.
    gain_unknown: bool,
}

/// The search of a level.
struct LevelSearch<'a> {
    space: &'a dyn SearchSpace,
    request: &'a Request,
    level: CostLevel,
    /// By case; `None` before it is solved.
    errors: Vec<Option<CaseErrors>>,
    solved: u64,
}

impl<'a> LevelSearch<'a> {
    fn new(space: &'a dyn SearchSpace, request: &'a Request, level: CostLevel) -> LevelSearch<'a> {
        LevelSearch {
            space,
            request,
            errors: vec![None; level.cases.len()],
            level,
            solved: 0,
        }
    }

    /// The best candidate whose `worst` is below `limit`. A neighbour is solved only if its candidate can still be below.
    fn best(&mut self, cost: u64, limit: f64) -> Option<Candidate> {
        let mut cases = Cases::new(self.space.problem().schema());
        for case in &self.level.cases {
            cases.push(case);
        }
        let mut open: Vec<usize> = (0..self.level.candidates.len()).collect();
        let rounds = self.level.candidates.iter().map(Vec::len).max();
        for round in 0..rounds.unwrap_or(0) {
            self.solve(&cases, &open, round);
            open.retain(|at| self.worst(*at) < limit);
        }
        open.sort_by(|a, b| self.worst(*a).total_cmp(&self.worst(*b)));
        let at = open.into_iter().find(|at| self.keeps_energy(*at))?;
        let cases = &self.level.candidates[at];
        let largest = |target: usize| {
            let errors = cases.iter().filter_map(|case| self.errors[*case].as_ref());
            errors.map(|e| e.errors[target]).fold(0.0, f64::max)
        };
        Some(Candidate {
            cases: cases.iter().map(|i| self.level.cases[*i].clone()).collect(),
            cost,
            errors: (0..self.request.targets.len()).map(largest).collect(),
            worst: self.worst(at),
        })
    }

    /// Solves neighbour `round` of these candidates, unless it is solved.
    fn solve(&mut self, cases: &Cases, candidates: &[usize], round: usize) {
        let cells = candidates
            .iter()
            .filter_map(|at| self.level.candidates[*at].get(round));
        let unsolved = cells.filter(|case| self.errors[**case].is_none());
        let mut rows: Vec<u32> = unsolved.map(|case| *case as u32).collect();
        rows.sort_unstable();
        rows.dedup();
        let table = self.space.problem().sweep(cases, &rows);
        for (place, row) in rows.iter().enumerate() {
            let metrics: Vec<Option<f64>> = table.row(place).collect();
            self.errors[*row as usize] = Some(self.errors_of(&metrics));
        }
        self.solved += rows.len() as u64;
    }

    fn errors_of(&self, metrics: &[Option<f64>]) -> CaseErrors {
        let targets = &self.request.targets;
        let errors: Vec<f64> = targets.iter().map(|t| t.error(metrics)).collect();
        let quotients = errors.iter().zip(targets).map(|(e, t)| e / t.limit);
        let mut case = CaseErrors {
            worst: quotients.fold(0.0, f64::max),
            errors,
            gain_unknown: false,
        };
        if let (Some(limit), Some(rows)) = (self.request.energy_gain, self.space.energy_drifts()) {
            match rows.map(|row| metrics.get(row).copied().flatten()) {
                [Some(largest), Some(last)] if largest <= limit && last <= limit => {
                    case.gain_unknown = largest < -limit;
                }
                [_, _] => case.worst = f64::INFINITY,
            }
        }
        case
    }

    /// The largest quotient of error and limit of a candidate and its neighbours, of those that are solved.
    fn worst(&self, candidate: usize) -> f64 {
        let cases = self.level.candidates[candidate].iter();
        let errors = cases.filter_map(|case| self.errors[*case].as_ref());
        errors.map(|e| e.worst).fold(0.0, f64::max)
    }

    /// Whether neither a candidate nor a neighbour gains too much energy at any step. It solves cases with unknown gains.
    fn keeps_energy(&mut self, candidate: usize) -> bool {
        let cases = self.level.candidates[candidate].clone();
        cases.into_iter().all(|case| {
            let unknown = |errors: &CaseErrors| errors.gain_unknown;
            if !self.errors[case].as_ref().is_some_and(unknown) {
                return true;
            }
            self.solved += 1;
            let within = self.gain(&self.level.cases[case]) <= self.request.energy_gain;
            if let Some(errors) = &mut self.errors[case] {
                errors.gain_unknown = false;
                if !within {
                    errors.worst = f64::INFINITY;
                }
            }
            within
        }) && self.worst(candidate).is_finite()
    }

    /// The gain of energy of a case.
    fn gain(&self, case: &Case) -> Option<f64> {
        let solution = self.space.problem().solve(case, &[]);
        let gain = solution.map(|s| self.space.energy_gain(case, &s.computed));
        // A case without a solution exceeds every limit.
        gain.unwrap_or(Some(f64::INFINITY))
    }
}
