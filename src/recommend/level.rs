//! The search of a level: its candidates, in the order of their errors.

use super::{Candidate, CostLevel, EnergyChange, Request, SearchSpace, with_finer_step};
use crate::problem::Case;
use crate::problem::cases::Cases;

/// Candidates whose finer steps are solved together.
const TOGETHER: usize = 16;

/// The result of a level.
#[derive(Debug, Default)]
pub struct Found {
    /// The best candidate. If it reaches the target, it also does with the finer step.
    pub best: Option<Candidate>,
    /// The best candidate that reaches the target only with its own step.
    pub own_step: Option<Candidate>,
}

/// The errors of a solved case.
#[derive(Debug, Clone)]
struct CaseErrors {
    errors: Vec<f64>,
    /// The largest quotient of error and limit; infinite if the case has no solution or changes its energy too much.
    worst: f64,
    /// Whether the change of energy is not known to be within its limits.
    energy_unknown: bool,
}

/// The search of a level.
pub struct LevelSearch<'a> {
    space: &'a dyn SearchSpace,
    request: &'a Request,
    level: CostLevel,
    /// By case; `None` before it is solved.
    errors: Vec<Option<CaseErrors>>,
    /// Number of cases solved.
    pub solved: u64,
}

impl<'a> LevelSearch<'a> {
    pub fn new(
        space: &'a dyn SearchSpace,
        request: &'a Request,
        level: CostLevel,
    ) -> LevelSearch<'a> {
        LevelSearch {
            space,
            request,
            errors: vec![None; level.cases.len()],
            level,
            solved: 0,
        }
    }

    /// The best candidate whose `worst` is below `limit`. A neighbour is solved only if its candidate can still be below.
    pub fn best(&mut self, cost: u64, limit: f64) -> Found {
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
        let reaching = open.partition_point(|at| self.worst(*at) <= 1.0);
        let (reaching, missing) = open.split_at(reaching);
        let mut found = Found::default();
        for group in reaching.chunks(TOGETHER) {
            let converged = self.reach_with_finer_step(group);
            for (at, converged) in group.iter().zip(converged) {
                let wanted = converged || found.own_step.is_none();
                if !(wanted && self.keeps_energy(*at)) {
                    continue;
                }
                let candidate = Some(self.candidate(*at, cost, converged));
                if converged {
                    found.best = candidate;
                    return found;
                }
                found.own_step = candidate;
            }
        }
        let at = missing.iter().find(|at| self.keeps_energy(**at));
        found.best = at.map(|at| self.candidate(*at, cost, false));
        found
    }

    fn candidate(&self, at: usize, cost: u64, converged: bool) -> Candidate {
        let cases = &self.level.candidates[at];
        let largest = |target: usize| {
            let errors = cases.iter().filter_map(|case| self.errors[*case].as_ref());
            errors.map(|e| e.errors[target]).fold(0.0, f64::max)
        };
        Candidate {
            cases: cases.iter().map(|i| self.level.cases[*i].clone()).collect(),
            cost,
            errors: (0..self.request.targets.len()).map(largest).collect(),
            worst: self.worst(at),
            converged,
        }
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
            self.errors[*row as usize] = Some(self.errors_of(*row as usize, &metrics));
        }
        self.solved += rows.len() as u64;
    }

    fn errors_of(&self, case: usize, metrics: &[Option<f64>]) -> CaseErrors {
        let targets = &self.request.targets;
        let errors: Vec<f64> = targets.iter().map(|t| t.error(metrics)).collect();
        let quotients = errors.iter().zip(targets).map(|(e, t)| e / t.limit);
        let own = &self.level.cases[case];
        let [least, most] = self.space.energy_bounds(own, metrics);
        let worst = match least.within(self.request) {
            true => quotients.fold(0.0, f64::max),
            false => f64::INFINITY,
        };
        CaseErrors {
            errors,
            worst,
            energy_unknown: worst.is_finite() && !most.within(self.request),
        }
    }

    /// The largest quotient of error and limit of a candidate and its neighbours, of those that are solved.
    fn worst(&self, candidate: usize) -> f64 {
        let cases = self.level.candidates[candidate].iter();
        let errors = cases.filter_map(|case| self.errors[*case].as_ref());
        errors.map(|e| e.worst).fold(0.0, f64::max)
    }

    /// Whether candidates, without neighbours, reach the targets with the finer step, too.
    fn reach_with_finer_step(&mut self, candidates: &[usize]) -> Vec<bool> {
        let problem = self.space.problem();
        let mut cases = Cases::new(problem.schema());
        for at in candidates {
            let own = &self.level.cases[self.level.candidates[*at][0]];
            cases.push(&with_finer_step(problem, own));
        }
        let rows: Vec<u32> = (0..candidates.len() as u32).collect();
        let table = problem.sweep(&cases, &rows);
        self.solved += rows.len() as u64;
        let reach = |place: usize| {
            let metrics: Vec<Option<f64>> = table.row(place).collect();
            let mut targets = self.request.targets.iter();
            targets.all(|target| target.error(&metrics) <= target.limit)
        };
        (0..candidates.len()).map(reach).collect()
    }

    /// Whether neither a candidate nor a neighbour gains or loses too much energy. It solves cases with unknown changes.
    fn keeps_energy(&mut self, candidate: usize) -> bool {
        let cases = self.level.candidates[candidate].clone();
        cases.into_iter().all(|case| {
            let unknown = |errors: &CaseErrors| errors.energy_unknown;
            if !self.errors[case].as_ref().is_some_and(unknown) {
                return true;
            }
            self.solved += 1;
            let within = self.change(&self.level.cases[case]).within(self.request);
            if let Some(errors) = &mut self.errors[case] {
                errors.energy_unknown = false;
                if !within {
                    errors.worst = f64::INFINITY;
                }
            }
            within
        }) && self.worst(candidate).is_finite()
    }

    /// The change of energy of a case; one without a solution exceeds every limit.
    fn change(&self, case: &Case) -> EnergyChange {
        let solution = self.space.problem().solve(case, &[]);
        solution.map_or(EnergyChange::UNKNOWN, |s| {
            self.space.energy_change(case, &s)
        })
    }
}
