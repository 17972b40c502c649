//! Cases of a study, and which of them a filter chooses.

pub(super) mod block;
pub(super) mod counts;
pub(super) mod derived;
pub(super) mod design;
pub(crate) mod scope;

use std::collections::HashSet;
use std::ops::Range;

use crate::problem::cases::Cases;
use crate::problem::parameter::Value;
use crate::problem::{Case, Problem, Violation};
use crate::study::{Block, Filter, Group, Study};

impl Block {
    /// The cases that `filter` chooses, as combination and case number of the block, rising. Axes are sieved before cases
    /// are made.
    pub(in crate::study) fn select<'a>(
        &'a self,
        problem: &'a dyn Problem,
        filter: &'a Filter,
    ) -> impl Iterator<Item = (u64, u64)> + 'a {
        self.select_among(u64::MAX, problem, filter)
    }

    /// The same among the first `most` combinations that the axes allow.
    pub(in crate::study) fn select_among<'a>(
        &'a self,
        most: u64,
        problem: &'a dyn Problem,
        filter: &'a Filter,
    ) -> impl Iterator<Item = (u64, u64)> + 'a {
        let kept: Vec<Vec<u64>> = self
            .groups
            .iter()
            .map(|group| group.sieve(filter))
            .collect();
        let on_axis = |row: usize| self.axes().any(|axis| axis.parameter == row);
        let settled = filter.0.iter().all(|(row, _)| on_axis(*row));
        let count: u64 = kept.iter().map(|kept| kept.len() as u64).product();
        let combinations = (0..count.min(most)).map(move |number| {
            let (mut rest, mut raw, mut stride) = (number, 0, 1);
            for (group, kept) in self.groups.iter().zip(&kept).rev() {
                let len = kept.len() as u64;
                raw += stride * kept[(rest % len) as usize];
                stride *= group.len();
                rest /= len;
            }
            raw
        });
        let chosen = combinations.filter(move |raw| {
            self.keeps(problem, *raw) && (settled || filter.matches(&self.completed(problem, *raw)))
        });
        // Case numbers rise with combinations, so that each is counted on from the one before.
        let (mut last, mut number) = (0, 0);
        chosen.map(move |raw| {
            if self.when.is_none() {
                return (raw, raw);
            }
            number = if raw - last > 4096 {
                self.rank(problem, raw)
            } else {
                number + (last..raw).filter(|r| self.keeps(problem, *r)).count() as u64
            };
            last = raw;
            (raw, number)
        })
    }

    /// Number of combinations that `select` goes through.
    pub(in crate::study) fn candidates(&self, filter: &Filter) -> u64 {
        let groups = self.groups.iter();
        groups
            .map(|group| group.sieve(filter).len() as u64)
            .product()
    }

    /// The different values of a parameter among the cases that `filter` may choose; none where it does not apply, or
    /// where it follows from others without an expression.
    pub(in crate::study) fn levels(
        &self,
        problem: &dyn Problem,
        filter: &Filter,
        parameter: usize,
    ) -> Vec<Value> {
        let axis_of = |group: &Group| group.axes.iter().position(|a| a.parameter == parameter);
        let group = self.groups.iter().find(|group| axis_of(group).is_some());
        let varies = group.is_some_and(|group| group.len() > 1)
            || self.derived.iter().any(|d| d.parameter == parameter);
        let mut raws = self.select(problem, filter).map(|(raw, _)| raw);
        let value = |raw: u64| self.raw_case(problem, raw).values[parameter];
        match (group, &self.when) {
            _ if !varies => raws.next().and_then(value).into_iter().collect(),
            (Some(group), None) if raws.next().is_some() => {
                let axis = &group.axes[axis_of(group).unwrap_or(0)];
                let kept = group.sieve(filter);
                distinct(kept.iter().map(|place| axis.values[*place as usize]))
            }
            (Some(_), None) => Vec::new(),
            _ => distinct(raws.filter_map(value)),
        }
    }
}

impl Block {
    /// Whether a parameter follows from others: by advancing together with one of them, or by an expression.
    pub fn follows(&self, parameter: usize, from: &[usize]) -> bool {
        let has = |group: usize, row: usize| {
            let axes = &self.groups[group].axes;
            axes.iter().any(|axis| axis.parameter == row)
        };
        let settled =
            |group: usize| self.groups[group].len() == 1 || from.iter().any(|row| has(group, *row));
        let mut groups = 0..self.groups.len();
        match self.derived.iter().find(|d| d.parameter == parameter) {
            Some(derived) => derived.rule.on.iter().all(|group| settled(*group)),
            None => groups.any(|group| has(group, parameter) && settled(group)),
        }
    }

    /// Whether the study gives a parameter's values, by a list or an expression.
    pub fn gives(&self, parameter: usize) -> bool {
        self.axes().any(|axis| axis.parameter == parameter)
            || self.derived.iter().any(|d| d.parameter == parameter)
    }
}

impl Group {
    /// Places whose values a filter lets through.
    fn sieve(&self, filter: &Filter) -> Vec<u64> {
        let wanted = |place: u64| {
            self.axes.iter().all(|axis| {
                let mut terms = filter.0.iter().filter(|(row, _)| *row == axis.parameter);
                terms.all(|(_, wanted)| axis.values[place as usize].is_one_of(wanted))
            })
        };
        (0..self.len()).filter(|place| wanted(*place)).collect()
    }
}

/// The values with repetitions dropped, in their order.
pub(in crate::study) fn distinct(values: impl Iterator<Item = Value>) -> Vec<Value> {
    let mut seen = HashSet::new();
    values
        .filter(|value| seen.insert(value.identity()))
        .collect()
}

impl Filter {
    /// Whether a completed case has one of the values of every parameter.
    pub fn matches(&self, case: &Case) -> bool {
        let has = |row: usize, wanted: &[Value]| {
            case.values
                .get(row)
                .copied()
                .flatten()
                .is_some_and(|value| value.is_one_of(wanted))
        };
        self.0.iter().all(|(row, wanted)| has(*row, wanted))
    }
}

impl Study {
    /// Number of cases.
    pub fn len(&self) -> u64 {
        let blocks = self.blocks.iter();
        blocks.map(|block| block.len(&*self.problem)).sum()
    }

    /// Whether there are no cases, which no study that was read allows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Number of raw combinations; at most the limit that the study was read with.
    pub fn raw_len(&self) -> u64 {
        self.blocks.iter().map(Block::raw_len).sum()
    }

    /// Case `index`, from 0, complete; `None` from `len` on.
    pub fn case(&self, index: u64) -> Option<Case> {
        case(&*self.problem, &self.blocks, index)
    }

    /// The rules that case `index` breaks, which only a case of a large study does.
    pub fn violations(&self, index: u64) -> Vec<Violation> {
        let found = place(&*self.problem, &self.blocks, index);
        found.map_or_else(Vec::new, |(block, raw)| {
            let mut case = block.raw_case(&*self.problem, raw);
            block.complete(&*self.problem, &mut case)
        })
    }

    /// What a completed case costs: steps times modes, with the references of the study's metrics.
    pub fn work(&self, case: &Case) -> u64 {
        let references = self.problem.reference_work(case, &self.metrics);
        self.problem.work(case).saturating_add(references)
    }

    /// Number of the first case of a block.
    pub fn first_of(&self, block: usize) -> u64 {
        let before = self.blocks.iter().take(block);
        before.map(|block| block.len(&*self.problem)).sum()
    }

    /// The block that case `index` belongs to.
    pub fn block_of(&self, index: u64) -> Option<&Block> {
        let mut end = 0;
        self.blocks.iter().find(|block| {
            end += block.len(&*self.problem);
            index < end
        })
    }

    /// All cases in order, made as they are asked for.
    pub fn cases(&self) -> impl Iterator<Item = Case> + '_ {
        self.range(0, self.raw_len()).map(|(_, case)| case)
    }

    /// The cases among raw combinations `from..to`, with their numbers, made as they are asked for.
    pub fn range(&self, from: u64, to: u64) -> impl Iterator<Item = (u64, Case)> + '_ {
        self.stretches(from, to).flat_map(|(block, raws, number)| {
            let raws = raws.filter(|raw| block.keeps(&*self.problem, *raw));
            (number..).zip(raws.map(|raw| block.completed(&*self.problem, raw)))
        })
    }

    /// Raw combination `raw` where it is a case, complete.
    pub fn combination(&self, raw: u64) -> Option<Case> {
        let mut rest = raw;
        for block in &self.blocks {
            if rest < block.raw_len() {
                let kept = block.keeps(&*self.problem, rest);
                return kept.then(|| block.completed(&*self.problem, rest));
            }
            rest -= block.raw_len();
        }
        None
    }

    /// The same as columns, with the number of the first.
    pub fn columns(&self, from: u64, to: u64) -> (u64, Cases) {
        let mut cases = Cases::new(self.problem.schema());
        let (mut case, mut first) = (Case::new(self.problem.schema()), None);
        for (block, raws, number) in self.stretches(from, to) {
            first.get_or_insert(number);
            for raw in raws.filter(|raw| block.keeps(&*self.problem, *raw)) {
                block.put(&*self.problem, raw, &mut case);
                // A large block was not checked case by case when the study was read.
                let violations = block.complete(&*self.problem, &mut case);
                match Violation::all(&violations) {
                    None => cases.push(&case),
                    Some(why) => cases.push_refused(&case, why),
                }
            }
        }
        (first.unwrap_or(0), cases)
    }

    /// What of raw combinations `from..to` lies in each block, by its own count, and the number of the first case there.
    fn stretches(&self, from: u64, to: u64) -> impl Iterator<Item = (&Block, Range<u64>, u64)> {
        let (mut start, mut cases) = (0, 0);
        self.blocks.iter().filter_map(move |block| {
            let (first, before) = (start, cases);
            start += block.raw_len();
            let raws = from.clamp(first, start) - first..to.clamp(first, start) - first;
            // The last block's cases need not be counted.
            if start < to {
                cases += block.len(&*self.problem);
            }
            let number =
                (!raws.is_empty()).then(|| before + block.rank(&*self.problem, raws.start));
            number.map(|number| (block, raws, number))
        })
    }

    /// The numbers of the cases that a filter chooses, rising.
    pub fn select<'a>(&'a self, filter: &'a Filter) -> impl Iterator<Item = u64> + 'a {
        select(&*self.problem, &self.blocks, filter)
    }
}

/// The numbers of the cases in all `blocks` that a filter chooses, rising.
pub(in crate::study) fn select<'a>(
    problem: &'a dyn Problem,
    blocks: &'a [Block],
    filter: &'a Filter,
) -> impl Iterator<Item = u64> + 'a {
    let mut end = 0;
    blocks.iter().enumerate().flat_map(move |(i, block)| {
        let start = end;
        // The last block's need not be counted.
        if i + 1 < blocks.len() {
            end += block.len(problem);
        }
        block
            .select(problem, filter)
            .map(move |(_, number)| start + number)
    })
}

/// Case `index` of all `blocks`, complete; `None` beyond the last.
pub(in crate::study) fn case(problem: &dyn Problem, blocks: &[Block], index: u64) -> Option<Case> {
    let (block, raw) = place(problem, blocks, index)?;
    Some(block.completed(problem, raw))
}

/// The block of case `index` of all `blocks`, and which combination of it the case is; `None` beyond the last.
fn place<'a>(problem: &dyn Problem, blocks: &'a [Block], index: u64) -> Option<(&'a Block, u64)> {
    let mut rest = index;
    for block in blocks {
        let len = block.len(problem);
        if rest < len {
            return Some((block, block.raw_of(problem, rest)?));
        }
        rest -= len;
    }
    None
}
