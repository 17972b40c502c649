//! The candidates of a study in levels of one cost, each candidate made when it is needed.

use super::candidate::{Choice, choice, size};
use super::judge::Judge;
use crate::cost;
use rayon::prelude::*;
use slipgap_problem::problem::{Case, Problem};
use slipgap_study::{Alternative, AxisGroup, Candidates, Study};

/// A candidate: its block, and its positions in the groups of axes that are chosen.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Place {
    pub block: usize,
    pub positions: Vec<u64>,
}

/// Candidates of one cost, that of all their physical cases.
#[derive(Debug)]
pub(super) struct Level {
    /// The first of them.
    first: Place,
    pub cost: u64,
    size: u64,
    step: f64,
}

/// The candidates of a study.
#[derive(Debug)]
pub(super) struct Levels<'a> {
    study: &'a Study,
    blocks: Vec<Candidates<'a>>,
    /// By block and group of axes: whether it decides the cost, which is a product of steps, size and sub-steps.
    decisive: Vec<Vec<bool>>,
    /// The cheapest first.
    pub levels: Vec<Level>,
}

impl<'a> Levels<'a> {
    pub fn of(study: &'a Study) -> Levels<'a> {
        let mut levels = Levels {
            study,
            blocks: study.candidates(),
            decisive: Vec::new(),
            levels: Vec::new(),
        };
        let blocks = 0..levels.blocks.len();
        levels.decisive = blocks.map(|block| levels.decisive_of(block)).collect();
        levels
    }

    /// The first candidate of each block.
    pub fn firsts(&self) -> impl Iterator<Item = Place> {
        let blocks = self.decisive.iter().enumerate();
        blocks.map(|(block, groups)| Place {
            block,
            positions: vec![0; groups.len()],
        })
    }

    /// Finds the levels.
    pub fn sort(&mut self) {
        let blocks = 0..self.blocks.len();
        let mut levels = Vec::from_iter(blocks.flat_map(|block| self.levels_of(block)));
        levels.sort_by_key(|level| level.cost);
        self.levels = levels;
    }

    /// Number of candidates.
    pub fn count(&self) -> u64 {
        self.blocks.iter().map(Candidates::count).sum()
    }

    /// Fewest physical cases of a candidate.
    pub fn physical_cases(&self) -> usize {
        let counts = self.blocks.iter().map(Candidates::physical_cases);
        counts.min().unwrap_or(0)
    }

    /// All candidates, in the order of the cases.
    pub fn listed(&self) -> impl Iterator<Item = Alternative> + '_ {
        self.blocks.iter().flat_map(Candidates::listed)
    }

    fn problem(&self) -> &'a dyn Problem {
        &*self.study.problem
    }

    fn lens(&self, block: usize) -> Vec<u64> {
        self.blocks[block]
            .groups()
            .map(|group| group.len())
            .collect()
    }

    /// Writes a physical case of a candidate over `case`, and tests whether it is a case that breaks no rule.
    pub fn put(&self, candidate: &Place, physical: usize, case: &mut Case) -> bool {
        self.blocks[candidate.block].put(&candidate.positions, physical, case)
    }

    /// The first physical case of a candidate.
    fn first_case(&self, candidate: &Place) -> Case {
        let mut case = Case::new(self.problem().schema());
        self.put(candidate, 0, &mut case);
        case
    }

    fn decisive_of(&self, block: usize) -> Vec<bool> {
        let lens = self.lens(block);
        let positions = vec![0; lens.len()];
        let first = Place { block, positions };
        let cost = |candidate: &Place| cost(self.problem(), &self.first_case(candidate));
        let usual = cost(&first);
        let decides = |(group, len): (usize, &u64)| {
            let mut others = (1..*len).map(|position| first.at(group, position));
            others.any(|other| cost(&other) != usual)
        };
        lens.iter().enumerate().map(decides).collect()
    }

    fn levels_of(&self, block: usize) -> Vec<Level> {
        let positions = vec![0; self.decisive[block].len()];
        let firsts = self.combinations(&Place { block, positions }, true);
        let level = |first: Place| {
            let mut case = Case::new(self.problem().schema());
            let mut total: u64 = 0;
            for physical in 0..self.blocks[block].physical_cases() {
                self.put(&first, physical, &mut case);
                total = total.saturating_add(cost(self.problem(), &case));
            }
            let case = self.first_case(&first);
            Level {
                cost: total,
                size: size(self.problem(), &case),
                step: case
                    .at(self.problem().schema().step)
                    .unwrap_or(f64::INFINITY),
                first,
            }
        };
        firsts.into_par_iter().map(level).collect()
    }

    /// The candidates with all positions in the groups that decide the cost, or in those that do not; in the others that of `first`.
    fn combinations(&self, first: &Place, decisive: bool) -> Vec<Place> {
        let lens = self.lens(first.block);
        let mut places = vec![first.clone()];
        for (group, len) in lens.iter().enumerate() {
            if self.decisive[first.block][group] == decisive {
                let at =
                    |candidate: Place| (0..*len).map(move |position| candidate.at(group, position));
                places = places.into_iter().flat_map(at).collect();
            }
        }
        places
    }

    /// The candidates of a level.
    pub fn of_level(&self, level: &Level) -> Vec<Place> {
        self.combinations(&level.first, false)
    }

    /// The candidate of a place; `None` if it has no case.
    pub fn choice(&self, wanted: &Place, judge: &mut Judge) -> Option<Choice> {
        let candidate = self.blocks[wanted.block].candidate(&wanted.positions)?;
        Some(choice(candidate, judge))
    }

    /// The candidates that have the next smaller or the next larger value of one of these numbers.
    pub fn neighbours(&self, candidate: &Place, rows: &[usize]) -> Vec<Place> {
        let groups = self.blocks[candidate.block].groups().enumerate();
        let of_group = |(group, axes): (usize, &AxisGroup)| -> Vec<Place> {
            let mut listed = axes.axes.iter();
            let Some(axis) = listed.find(|axis| rows.contains(&axis.parameter)) else {
                return Vec::new();
            };
            let value = |position: u64| axis.values.at(position as usize).as_f64();
            let held = value(candidate.positions[group]).unwrap_or(f64::NAN);
            let others = (0..axes.len()).filter_map(|other| Some((value(other)?, other)));
            let [smaller, larger]: [Vec<(f64, u64)>; 2] = [
                others.clone().filter(|other| other.0 < held).collect(),
                others.filter(|other| other.0 > held).collect(),
            ];
            let smaller = smaller.iter().max_by(|a, b| a.0.total_cmp(&b.0));
            let larger = larger.iter().min_by(|a, b| a.0.total_cmp(&b.0));
            let next = smaller.into_iter().chain(larger);
            next.map(|other| candidate.at(group, other.1)).collect()
        };
        groups.flat_map(of_group).collect()
    }

    /// Whether a combination meets the condition of the block.
    fn has_cases(&self, candidate: &Place) -> bool {
        let candidates = &self.blocks[candidate.block];
        candidates.candidate(&candidate.positions).is_some()
    }

    /// The candidates with other meshes: for each number that decides the size the one with the next finer mesh, else one with another.
    pub fn meshes(&self, candidate: &Place) -> Vec<Place> {
        let size = |candidate: &Place| size(self.problem(), &self.first_case(candidate));
        let given = size(candidate);
        let of_group = |(group, len): (usize, u64)| -> Option<Place> {
            if !self.decisive[candidate.block][group] {
                return None;
            }
            let others: Vec<(u64, Place)> = (0..len)
                .map(|position| candidate.at(group, position))
                .filter(|other| self.has_cases(other))
                .map(|other| (size(&other), other))
                .filter(|other| other.0 != given)
                .collect();
            let finer = others.iter().filter(|other| other.0 > given);
            let next = finer.min_by_key(|other| other.0);
            next.or(others.first()).map(|other| other.1.clone())
        };
        let groups = self.lens(candidate.block).into_iter().enumerate();
        groups.filter_map(of_group).collect()
    }

    /// The candidate with the largest size, then with the smallest step, then the last one whose first case breaks no rule.
    pub fn finest(&self) -> Option<Place> {
        let finest = self.levels.iter().max_by(|a, b| {
            let steps = b.step.total_cmp(&a.step);
            a.size.cmp(&b.size).then(steps)
        })?;
        let mut case = Case::new(self.problem().schema());
        let mut places = self.of_level(finest).into_iter().rev();
        places.find(|candidate| self.put(candidate, 0, &mut case))
    }

    /// The candidates with the value before in each list that does not decide the cost.
    pub fn before(&self, candidate: &Place) -> impl Iterator<Item = Place> {
        let groups = candidate.positions.iter().enumerate();
        groups.filter_map(move |(group, position)| {
            let free = !self.decisive[candidate.block][group] && *position > 0;
            free.then(|| candidate.at(group, position - 1))
        })
    }
}

impl Place {
    /// The same with another position in a group.
    fn at(&self, group: usize, position: u64) -> Place {
        let mut other = self.clone();
        other.positions[group] = position;
        other
    }
}
