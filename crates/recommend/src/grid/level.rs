//! The search of a level: its candidates, in the order of their errors.

use super::{Candidate, CostLevel, EnergyChange, Request, SearchSpace, refine, with_finer_step};
use slipgap_problem::problem::Case;
use slipgap_problem::problem::table::cases::Cases;

/// Candidates whose finer steps are solved together.
const TOGETHER: usize = 16;

/// Number of further conditions under which the metrics of a candidate must settle.
const HARDEST: usize = 8;

/// The result of a level.
#[derive(Debug, Default)]
pub struct Found {
    /// The best candidate. If it reaches the target, it also does with finer steps.
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
    /// By candidate: its own cases, without those of its neighbours; `None` before the further ones are added.
    own: Vec<Option<Vec<usize>>>,
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
            own: vec![None; level.candidates.len()],
            level,
            solved: 0,
        }
    }

    /// The best candidate whose `worst` is below `limit`. A neighbour is solved only if its candidate can still be below.
    pub fn best(&mut self, cost: u64, limit: f64) -> Found {
        let mut open: Vec<usize> = (0..self.level.candidates.len()).collect();
        let rounds = self.level.candidates.iter().map(Vec::len).max();
        for round in 0..rounds.unwrap_or(0) {
            let cells = open.iter();
            let cells = cells.filter_map(|at| self.level.candidates[*at].get(round).copied());
            self.solve(cells.collect());
            open.retain(|at| self.worst(*at) < limit);
        }
        open.sort_by(|a, b| self.worst(*a).total_cmp(&self.worst(*b)));
        let reaching = open.partition_point(|at| self.worst(*at) <= 1.0);
        let (reaching, missing) = open.split_at(reaching);
        let mut found = Found::default();
        // The first that misses the target, and those that miss it under the further conditions.
        let mut missed = Vec::new();
        for group in reaching.chunks(TOGETHER) {
            let first = group.iter().map(|at| self.level.candidates[*at][0]);
            let settled = self.hold_with_finer_steps(first.collect());
            for (at, settled) in group.iter().zip(settled) {
                let wanted = settled || found.own_step.is_none();
                if !(wanted && self.keeps_energy(*at)) {
                    continue;
                }
                if !self.reaches_further(*at) {
                    missed.push(*at);
                    continue;
                }
                let converged = settled && self.is_settled_further(*at);
                let candidate = || self.candidate(*at, cost, converged);
                if converged {
                    found.best = Some(candidate());
                    return found;
                }
                if found.own_step.is_none() {
                    found.own_step = Some(candidate());
                }
            }
        }
        if let Some(at) = missing.iter().find(|at| self.keeps_energy(**at)) {
            self.reaches_further(*at);
            missed.push(*at);
        }
        missed.retain(|at| self.worst(*at).is_finite());
        missed.sort_by(|a, b| self.worst(*a).total_cmp(&self.worst(*b)));
        let at = missed.first();
        found.best = at.map(|at| self.candidate(*at, cost, false));
        found
    }

    fn candidate(&self, at: usize, cost: u64, converged: bool) -> Candidate {
        let mut cases = self.level.candidates[at].clone();
        let worst = |case: &usize| self.errors[*case].as_ref().map_or(0.0, |e| e.worst);
        let own = self.own[at].iter().flatten();
        let hardest = own.max_by(|a, b| worst(a).total_cmp(&worst(b)));
        let place = hardest.and_then(|own| cases.iter().position(|case| case == own));
        if let Some(place) = place {
            cases.swap(0, place);
        }
        let largest = |target: usize| {
            let errors = cases.iter().filter_map(|case| self.errors[*case].as_ref());
            errors.map(|e| e.errors[target]).fold(0.0, f64::max)
        };
        Candidate {
            cost,
            errors: (0..self.request.targets.len()).map(largest).collect(),
            worst: self.worst(at),
            converged,
            cases: cases.iter().map(|i| self.level.cases[*i].clone()).collect(),
        }
    }

    /// Solves these cases, unless they are solved.
    fn solve(&mut self, mut rows: Vec<usize>) {
        rows.retain(|case| self.errors[*case].is_none());
        rows.sort_unstable();
        rows.dedup();
        let problem = self.space.problem();
        let mut cases = Cases::new(problem.schema());
        for row in &rows {
            cases.push(&self.level.cases[*row]);
        }
        let places: Vec<u32> = (0..rows.len() as u32).collect();
        let table = problem.sweep(&cases, &places);
        for (place, row) in rows.iter().enumerate() {
            let metrics: Vec<Option<f64>> = table.row(place).collect();
            self.errors[*row] = Some(self.errors_of(*row, &metrics));
        }
        self.solved += rows.len() as u64;
    }

    /// Whether a candidate and its neighbours reach the target under the further conditions, too, and keep their energy.
    fn reaches_further(&mut self, at: usize) -> bool {
        if self.own[at].is_none() {
            let of = &self.level.candidates[at];
            let first = of[0];
            let cases: Vec<Case> = of.iter().map(|i| self.level.cases[*i].clone()).collect();
            let further = self.space.further(&cases);
            let mut own = vec![first];
            own.extend(self.add(at, further.own));
            self.own[at] = Some(own);
            if self.worst(at) <= 1.0 {
                self.add(at, further.neighbours);
            }
        }
        self.worst(at) <= 1.0 && self.keeps_energy(at)
    }

    /// Adds cases to a candidate and solves them.
    fn add(&mut self, at: usize, cases: Vec<Case>) -> std::ops::Range<usize> {
        let first = self.level.cases.len();
        self.level.cases.extend(cases);
        let added = first..self.level.cases.len();
        self.errors.resize(added.end, None);
        self.level.candidates[at].extend(added.clone());
        self.solve(added.clone().collect());
        added
    }

    /// Whether a candidate reaches the target with finer steps under its further conditions, too: at all with half the step, at those
    /// with the largest errors until the metrics settle.
    fn is_settled_further(&mut self, at: usize) -> bool {
        let own = self.own[at].iter().flatten().skip(1).copied();
        let mut own: Vec<usize> = own.collect();
        let worst = |case: &usize| self.errors[*case].as_ref().map_or(0.0, |e| e.worst);
        own.sort_by(|a, b| worst(b).total_cmp(&worst(a)));
        let problem = self.space.problem();
        let mut halves = Cases::new(problem.schema());
        for case in &own {
            halves.push(&with_finer_step(problem, &self.level.cases[*case], 2));
        }
        let rows: Vec<u32> = (0..own.len() as u32).collect();
        let table = problem.sweep(&halves, &rows);
        self.solved += rows.len() as u64;
        let reaches = |place: usize| {
            let metrics: Vec<Option<f64>> = table.row(place).collect();
            let mut targets = self.request.targets.iter();
            targets.all(|target| target.error(&metrics) <= target.limit)
        };
        if !(0..own.len()).all(reaches) {
            return false;
        }
        own.truncate(HARDEST);
        let holds = self.hold_with_finer_steps(own);
        holds.into_iter().all(|holds| holds)
    }

    /// Whether these cases reach the targets with finer steps, too.
    fn hold_with_finer_steps(&mut self, cases: Vec<usize>) -> Vec<bool> {
        let cases: Vec<Case> = cases.iter().map(|i| self.level.cases[*i].clone()).collect();
        let targets = &self.request.targets;
        let refined = refine(self.space.problem(), targets, &cases, &mut self.solved);
        refined.iter().map(|refined| refined.holds()).collect()
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
