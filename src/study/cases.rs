//! Cases of a study, made one at a time from their number: a study of 10^9 cases takes no more memory than one of 10.

use std::collections::HashSet;

use super::{Block, Filter, Study};
use crate::problem::parameter::{Default, Value};
use crate::problem::{Case, Problem};

impl Block {
    /// Number of cases; at most 10^9 in a study that was read.
    pub fn len(&self) -> u64 {
        self.axes
            .iter()
            .map(|axis| axis.values.len() as u64)
            .product()
    }

    /// Whether there are no cases, which no study that was read allows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Case `index`, from 0, last axis fastest, with what it leaves out at its default but before
    /// `Problem::complete`; `index` must be less than `len`.
    pub(super) fn case(&self, problem: &dyn Problem, index: u64) -> Case {
        let mut case = Case::new(problem.parameters());
        let mut rest = index;
        for axis in self.axes.iter().rev() {
            let len = axis.values.len() as u64;
            case.values[axis.parameter] = Some(axis.values[(rest % len) as usize]);
            rest /= len;
        }
        for (row, parameter) in case.table.iter().enumerate() {
            if let (None, Default::Is(value)) = (case.values[row], parameter.default)
                && parameter
                    .applies
                    .is_none_or(|(governor, name)| case.choice(governor) == name)
            {
                case.values[row] = Some(value);
            }
        }
        case
    }

    /// The same, with the values that follow from others.
    pub(super) fn completed(&self, problem: &dyn Problem, index: u64) -> Case {
        let mut case = self.case(problem, index);
        // What it may violate was reported when the study was read.
        let _ = problem.complete(&mut case);
        case
    }

    /// The numbers of the cases that `filter` chooses, rising. Axes are sieved before cases are made.
    pub(super) fn select<'a>(
        &'a self,
        problem: &'static dyn Problem,
        filter: &'a Filter,
    ) -> impl Iterator<Item = u64> + 'a {
        let kept: Vec<Vec<u64>> = self.axes.iter().map(|axis| axis.sieve(filter)).collect();
        let on_axis = |row: usize| self.axes.iter().any(|axis| axis.parameter == row);
        let settled = filter.0.iter().all(|(row, _)| on_axis(*row));
        let count: u64 = kept.iter().map(|kept| kept.len() as u64).product();
        let numbers = (0..count).map(move |number| {
            let (mut rest, mut index, mut stride) = (number, 0, 1);
            for (axis, kept) in self.axes.iter().zip(&kept).rev() {
                let len = kept.len() as u64;
                index += stride * kept[(rest % len) as usize];
                stride *= axis.values.len() as u64;
                rest /= len;
            }
            index
        });
        numbers.filter(move |index| settled || filter.matches(&self.completed(problem, *index)))
    }

    /// The different values of a parameter among the cases that `filter` may choose; none where it is left to follow
    /// from others or does not apply.
    pub(super) fn levels(
        &self,
        problem: &'static dyn Problem,
        filter: &Filter,
        parameter: usize,
    ) -> Vec<Value> {
        let Some(first) = self.select(problem, filter).next() else {
            return Vec::new();
        };
        match self.axes.iter().find(|axis| axis.parameter == parameter) {
            Some(axis) => {
                let kept = axis.sieve(filter);
                distinct(kept.iter().map(|index| axis.values[*index as usize]))
            }
            None => self.case(problem, first).values[parameter]
                .into_iter()
                .collect(),
        }
    }
}

impl super::Axis {
    /// Positions of the values that a filter lets through.
    fn sieve(&self, filter: &Filter) -> Vec<u64> {
        let wanted = |value: Value| {
            let mut terms = filter.0.iter().filter(|(row, _)| *row == self.parameter);
            terms.all(|(_, wanted)| value.matches(*wanted))
        };
        (0..self.values.len() as u64)
            .filter(|index| wanted(self.values[*index as usize]))
            .collect()
    }
}

/// The values with repetitions dropped, in their order.
pub(super) fn distinct(values: impl Iterator<Item = Value>) -> Vec<Value> {
    let mut seen = HashSet::new();
    values
        .filter(|value| seen.insert(identity(*value)))
        .collect()
}

/// What tells a value from others of its parameter: all bits of a number, or a name.
pub(super) fn identity(value: Value) -> (u64, &'static str) {
    match value {
        Value::Number(x) => (x.to_bits(), ""),
        Value::Whole(n) => (n, ""),
        Value::Name(name) => (0, name),
    }
}

impl Filter {
    /// Whether a completed case has all the values.
    pub fn matches(&self, case: &Case) -> bool {
        let has = |row: usize, wanted: Value| {
            case.values
                .get(row)
                .copied()
                .flatten()
                .is_some_and(|value| value.matches(wanted))
        };
        self.0.iter().all(|(row, wanted)| has(*row, *wanted))
    }
}

impl Study {
    /// Number of cases, at most 10^9.
    pub fn len(&self) -> u64 {
        self.blocks.iter().map(Block::len).sum()
    }

    /// Whether there are no cases, which no study that was read allows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Case `index`, from 0, complete; `None` from `len` on.
    pub fn case(&self, index: u64) -> Option<Case> {
        case(self.problem, &self.blocks, index)
    }

    /// All cases in order, made as they are asked for.
    pub fn cases(&self) -> impl Iterator<Item = Case> + '_ {
        (0..self.len()).map_while(|index| self.case(index))
    }

    /// The numbers of the cases that a filter chooses, rising.
    pub fn select<'a>(&'a self, filter: &'a Filter) -> impl Iterator<Item = u64> + 'a {
        select(self.problem, &self.blocks, filter)
    }
}

/// The numbers of the cases in all `blocks` that a filter chooses, rising.
pub(super) fn select<'a>(
    problem: &'static dyn Problem,
    blocks: &'a [Block],
    filter: &'a Filter,
) -> impl Iterator<Item = u64> + 'a {
    let mut end = 0;
    blocks.iter().flat_map(move |block| {
        let start = end;
        end += block.len();
        block
            .select(problem, filter)
            .map(move |index| start + index)
    })
}

/// Case `index` of all `blocks`, complete; `None` beyond the last.
pub(super) fn case(problem: &dyn Problem, blocks: &[Block], index: u64) -> Option<Case> {
    let mut rest = index;
    for block in blocks {
        if rest < block.len() {
            return Some(block.completed(problem, rest));
        }
        rest -= block.len();
    }
    None
}
