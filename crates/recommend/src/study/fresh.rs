//! Members of the ensemble that the study does not have: whether a candidate keeps its metrics under other synthetic motions.

use super::candidate::Choice;
use super::judge::{Judge, all_of};
use super::reference_motion;
use crate::calibrate::Stopped;
use slipgap_problem::problem::Case;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::structure::StructureProblem;
use slipgap_problem::problem::structure::given::source::LARGEST_SEED;
use slipgap_problem::problem::table::cases::Cases;
use slipgap_study::alike::identity;
use std::collections::{BTreeSet, HashSet};

/// Fewest fresh values of a seed; a study with more values has as many fresh ones.
const FEWEST: usize = 5;

/// Fresh values of the seeds of a study.
pub(super) struct Fresh {
    /// The parameters that are seeds, each with its values.
    seeds: Vec<(usize, Vec<Value>)>,
    /// Whether the references of the fresh cases are known.
    is_referred: bool,
}

impl Fresh {
    /// The fresh seeds; `None` if no physical case has a seed of several values.
    pub fn of(judge: &Judge) -> Option<Fresh> {
        let structure = judge.study.problem.as_structure();
        let mut rows = structure.map_or(Vec::new(), StructureProblem::seeds);
        rows.retain(|row| judge.kept.contains(row));
        let seeds: Vec<(usize, Vec<Value>)> = rows
            .into_iter()
            .map(|row| (row, values(&judge.finest, row)))
            .collect();
        (!seeds.is_empty()).then_some(Fresh {
            seeds,
            is_referred: false,
        })
    }

    /// The largest quotient of error and tolerance of a candidate with the fresh seeds.
    pub fn quotient(&mut self, choice: &Choice, judge: &mut Judge) -> Result<f64, Stopped> {
        if !self.is_referred {
            let cases = self.cases(&judge.finest, judge);
            reference_motion::add(&cases, judge)?;
            self.is_referred = true;
        }
        let (free, values) = choice.free();
        let cases = all_of(&choice.cases(judge, free, &values));
        let mut fresh = Cases::new(judge.study.problem.schema());
        for case in self.cases(&cases, judge) {
            fresh.push(&case);
        }
        let judged = judge.judged(&fresh)?;
        Ok(judge.worst(&judged))
    }

    /// The cases that differ in more than their seeds, each with all fresh seeds.
    fn cases(&self, cases: &[Case], judge: &Judge) -> Vec<Case> {
        let is_seed = |row: &usize| self.seeds.iter().any(|seed| seed.0 == *row);
        let others = Vec::from_iter(judge.kept.iter().copied().filter(|row| !is_seed(row)));
        let mut known = HashSet::new();
        let first = cases
            .iter()
            .filter(|case| known.insert(identity(case, &others)));
        let count = self.seeds.iter().map(|seed| seed.1.len()).min();
        let with = |case: &Case| {
            let case = case.clone();
            (0..count.unwrap_or(0)).map(move |member| {
                let mut fresh = case.clone();
                for (row, values) in &self.seeds {
                    fresh.values[*row] = Some(values[member]);
                }
                fresh
            })
        };
        first.flat_map(with).collect()
    }
}

/// Whole numbers that no case has as this seed: the next larger ones, or the smallest of all.
fn values(cases: &[Case], row: usize) -> Vec<Value> {
    let seeds = cases.iter().filter_map(|case| case.at(row));
    let used: BTreeSet<u64> = seeds.map(|seed| seed as u64).collect();
    let count = used.len().max(FEWEST);
    let next = used.last().map_or(0, |last| last + 1);
    let numbers = (next..=u64::from(LARGEST_SEED)).chain(0..next);
    let free = numbers.filter(|seed| !used.contains(seed)).take(count);
    free.map(|seed| Value::Number(seed as f64)).collect()
}
