//! The search of many candidates, level by level: few physical cases reject most of a level, the others are then solved in all.

use super::candidate::{Choice, decide};
use super::fresh::Fresh;
use super::judge::Judge;
use super::levels::{Levels, Place};
use super::trial::trial;
use super::verdict::State;
use crate::calibrate::Stopped;
use rayon::prelude::*;
use slipgap_problem::problem::Case;
use slipgap_problem::problem::table::cases::Cases;
use std::cmp::Ordering;

/// Levels searched at once. It does not depend on the number of threads, because the number of solved cases is printed.
const BATCH: usize = 16;

/// Physical cases in which all candidates of a level are solved: those that rejected most before.
const SURVEY: usize = 4;

/// Candidates that are then solved in all physical cases at once, those with the smallest errors first.
const TOGETHER: usize = 16;

/// Cases of one sweep.
const LANES: usize = 64;

/// Work after which a search ends, in steps times modes or nodes: a core computes about 5e8 in a second.
const MOST_WORK: u64 = 50_000_000_000;

/// What a search finds.
#[derive(Debug)]
pub(super) struct Found {
    /// Candidates that are better than all cheaper ones, and the first of each kind that keep the metrics, the cheapest first.
    pub choices: Vec<Choice>,
    /// The recommended one.
    pub chosen: Option<usize>,
    /// Number of candidates compared, the cheapest.
    pub compared: u64,
}

/// A candidate of which some physical cases are solved.
#[derive(Debug, Clone)]
struct Open {
    place: Place,
    cost: u64,
    /// The largest quotient of error and tolerance so far.
    worst: f64,
}

impl Open {
    /// The cheapest first, then those with the smallest errors.
    fn compare(&self, other: &Open) -> Ordering {
        let errors = self.worst.total_cmp(&other.worst);
        self.cost.cmp(&other.cost).then(errors)
    }
}

/// A search.
pub(super) struct Search<'a, 'b> {
    levels: &'a Levels<'b>,
    judge: &'a mut Judge<'b>,
    fresh: Option<Fresh>,
    /// The physical cases, those first that reject most candidates, and how many each did.
    order: Vec<usize>,
    rejected: Vec<u64>,
    /// The smallest of the largest quotients so far.
    least: f64,
    /// The first candidate that keeps the metrics only with its own step or mesh.
    first: Option<usize>,
    found: Found,
    work: u64,
}

impl<'a, 'b> Search<'a, 'b> {
    pub fn new(levels: &'a Levels<'b>, judge: &'a mut Judge<'b>) -> Search<'a, 'b> {
        let count = levels.physical_cases();
        Search {
            levels,
            fresh: Fresh::of(judge),
            judge,
            order: (0..count).collect(),
            rejected: vec![0; count],
            least: f64::INFINITY,
            first: None,
            found: Found {
                choices: Vec::new(),
                chosen: None,
                compared: 0,
            },
            work: 0,
        }
    }

    /// Searches up to the first candidate that keeps the metrics in all further tests, if the work allows it.
    pub fn run(mut self) -> Result<Found, Stopped> {
        for batch in self.levels.levels.chunks(BATCH) {
            if self.work > MOST_WORK {
                break;
            }
            let open = batch.iter().flat_map(|level| {
                let places = self.levels.of_level(level).into_iter();
                places.map(|candidate| Open {
                    place: candidate,
                    cost: level.cost,
                    worst: 0.0,
                })
            });
            let open: Vec<Open> = open.collect();
            self.found.compared += open.len() as u64;
            let keeping = self.survey(open)?;
            if self.try_each(keeping)? {
                break;
            }
        }
        Ok(self.sorted())
    }

    /// The candidates found, those that miss a tolerance only if they are better than all cheaper ones.
    fn sorted(self) -> Found {
        let Found {
            choices,
            chosen,
            compared,
        } = self.found;
        let chosen = chosen.or(self.first);
        let mut marked: Vec<(bool, Choice)> = choices
            .into_iter()
            .enumerate()
            .map(|(at, choice)| (Some(at) == chosen, choice))
            .collect();
        marked.sort_by(|(_, a), (_, b)| a.cost.cmp(&b.cost).then(a.worst.total_cmp(&b.worst)));
        let mut least = f64::INFINITY;
        marked.retain(|(_, choice)| {
            let is_better = choice.worst < least;
            least = least.min(choice.worst);
            is_better || choice.state == State::Keeps
        });
        Found {
            chosen: marked.iter().position(|pair| pair.0),
            choices: marked.into_iter().map(|pair| pair.1).collect(),
            compared,
        }
    }

    /// Whether a candidate may be the answer, or is better than all so far.
    fn is_open(&self, open: &Open) -> bool {
        open.worst <= 1.0 || open.worst < self.least
    }

    /// The candidates of some levels that keep the metrics in all physical cases, before their energy is known.
    fn survey(&mut self, mut open: Vec<Open>) -> Result<Vec<Open>, Stopped> {
        let rejected = &self.rejected;
        self.order
            .sort_by_key(|physical| u64::MAX - rejected[*physical]);
        let order = self.order.clone();
        let (few, others) = order.split_at(order.len().min(SURVEY));
        for physical in few {
            let pairs = (0..open.len()).map(|at| (at, *physical)).collect();
            self.solve(&mut open, pairs)?;
            let before = open.len();
            open.retain(|candidate| self.is_open(candidate));
            self.rejected[*physical] += (before - open.len()) as u64;
        }
        open.sort_by(Open::compare);
        let mut keeping = Vec::new();
        let mut rest = open.into_iter().peekable();
        while rest.peek().is_some() {
            let open = rest.by_ref().filter(|candidate| self.is_open(candidate));
            let mut some: Vec<Open> = open.take(TOGETHER).collect();
            for physical in others.chunks(SURVEY) {
                let candidates = 0..some.len();
                let pairs = physical
                    .iter()
                    .flat_map(|case| candidates.clone().map(|at| (at, *case)))
                    .collect();
                self.solve(&mut some, pairs)?;
                some.retain(|candidate| self.is_open(candidate));
            }
            some.sort_by(Open::compare);
            for candidate in some {
                if candidate.worst <= 1.0 {
                    keeping.push(candidate);
                } else if self.is_open(&candidate) {
                    self.improve(&candidate)?;
                }
            }
        }
        keeping.sort_by(Open::compare);
        Ok(keeping)
    }

    /// Solves candidates in physical cases, each by its place among `open`.
    fn solve(&mut self, open: &mut [Open], pairs: Vec<(usize, usize)>) -> Result<(), Stopped> {
        if self.judge.is_stopped() {
            return Err(Stopped);
        }
        let (levels, judge) = (self.levels, &*self.judge);
        let schema = judge.study.problem.schema();
        let quotients = |pairs: &[(usize, usize)]| {
            let (mut cases, mut case) = (Cases::new(schema), Case::new(schema));
            for (row, (at, physical)) in pairs.iter().enumerate() {
                let allowed = levels.put(&open[*at].place, *physical, &mut case);
                cases.push_at(row as u64, &case, (!allowed).then(String::new));
            }
            judge.quotients(&cases)
        };
        let quotients: Vec<Vec<f64>> = pairs.par_chunks(LANES).map(quotients).collect();
        for ((at, _), quotient) in pairs.iter().zip(quotients.into_iter().flatten()) {
            open[*at].worst = open[*at].worst.max(quotient);
        }
        self.judge.solved += pairs.len() as u64;
        let costs = pairs.iter().map(|(at, _)| open[*at].cost);
        self.work += costs.sum::<u64>() / levels.physical_cases().max(1) as u64;
        Ok(())
    }

    /// The candidate with all errors, warnings and changes of energy.
    fn decided(&mut self, candidate: &Place) -> Result<Option<Choice>, Stopped> {
        let Some(mut choice) = self.levels.choice(candidate, self.judge) else {
            return Ok(None);
        };
        decide(&mut choice, self.judge)?;
        Ok(Some(choice))
    }

    /// Lists a candidate that misses a tolerance, if it is better than all so far.
    fn improve(&mut self, open: &Open) -> Result<(), Stopped> {
        if let Some(choice) = self.decided(&open.place)?
            && choice.worst < self.least
        {
            self.least = choice.worst;
            self.list(choice);
        }
        Ok(())
    }

    /// Lists a candidate; returns its place.
    fn list(&mut self, choice: Choice) -> usize {
        self.found.choices.push(choice);
        self.found.choices.len() - 1
    }

    /// Tests candidates further, in this order; true if one of them is recommended.
    fn try_each(&mut self, keeping: Vec<Open>) -> Result<bool, Stopped> {
        for open in keeping {
            let Some(mut choice) = self.decided(&open.place)? else {
                continue;
            };
            if choice.state != State::Keeps {
                continue;
            }
            let rows = self.judge.recommend.neighbours.clone();
            let mut near = Vec::new();
            for candidate in self.levels.neighbours(&open.place, &rows) {
                near.extend(self.decided(&candidate)?);
            }
            let places = self.levels.meshes(&open.place).into_iter();
            let choices = places.filter_map(|candidate| self.levels.choice(&candidate, self.judge));
            let meshes: Vec<Choice> = choices.collect();
            let others = [near.as_slice(), &meshes];
            let is_first = self.first.is_none();
            let trial = trial(&choice, others, is_first, &mut self.fresh, self.judge)?;
            choice.trial = Some(trial);
            self.least = self.least.min(1.0);
            if trial.holds() {
                self.found.chosen = Some(self.list(choice));
                return Ok(true);
            }
            let is_answer = trial.is_robust() && is_first;
            let kind = |trial: super::Trial| (trial.is_converged(), trial.is_robust());
            let mut listed = self.found.choices.iter().filter_map(|known| known.trial);
            if is_answer || !listed.any(|known| kind(known) == kind(trial)) {
                let at = self.list(choice);
                self.first = self.first.or(is_answer.then_some(at));
            }
        }
        Ok(false)
    }
}
