//! Which cases a filter selects, and the values of a parameter among them.

use super::block::Block;
use super::filter::Filter;
use super::group::Group;
use crate::problem::parameter::Value;
use crate::problem::{Case, Problem};
use std::collections::HashSet;

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
            .map(|group| group.positions(filter))
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
            self.is_case(problem, *raw)
                && (settled || filter.matches(&self.completed(problem, *raw)))
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
                number + (last..raw).filter(|r| self.is_case(problem, *r)).count() as u64
            };
            last = raw;
            (raw, number)
        })
    }

    /// Number of combinations that `select` goes through.
    pub(in crate::study) fn candidates(&self, filter: &Filter) -> u64 {
        let groups = self.groups.iter();
        groups
            .map(|group| group.positions(filter).len() as u64)
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
                let kept = group.positions(filter);
                distinct(kept.iter().map(|place| axis.values[*place as usize]))
            }
            (Some(_), None) => Vec::new(),
            _ => distinct(raws.filter_map(value)),
        }
    }

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
            Some(derived) => derived.formula.on.iter().all(|group| settled(*group)),
            None => groups.any(|group| has(group, parameter) && settled(group)),
        }
    }

    /// Whether the study gives a parameter's values, by a list or an expression.
    pub fn gives(&self, parameter: usize) -> bool {
        self.axes().any(|axis| axis.parameter == parameter)
            || self.derived.iter().any(|d| d.parameter == parameter)
    }
}

/// The values with repetitions dropped, in their order.
pub(in crate::study) fn distinct(values: impl Iterator<Item = Value>) -> Vec<Value> {
    let mut seen = HashSet::new();
    values
        .filter(|value| seen.insert(value.identity()))
        .collect()
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
pub(super) fn place<'a>(
    problem: &dyn Problem,
    blocks: &'a [Block],
    index: u64,
) -> Option<(&'a Block, u64)> {
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
