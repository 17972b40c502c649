//! The cases of all blocks of a study, by their numbers.

use crate::block::Block;
use crate::filter::Filter;
use crate::select::{Selected, distinct};
use slipgap_problem::problem::numbers::parameter::{ColumnRule, Parameter, Value};
use slipgap_problem::problem::table::cases::Cases;
use slipgap_problem::problem::{Case, Problem, Violation};
use std::ops::Range;

/// The cases of the blocks of a study.
#[derive(Debug, Clone, Copy)]
pub struct Enumeration<'a> {
    /// The problem.
    pub problem: &'a dyn Problem,
    /// The blocks in order.
    pub blocks: &'a [Block],
}

impl<'a> Enumeration<'a> {
    /// Number of cases, or a larger number if they are not [counted](Enumeration::is_counted).
    pub fn len(self) -> u64 {
        let blocks = self.blocks.iter();
        blocks.map(|block| block.len(self.problem)).sum()
    }

    /// Whether there are no cases.
    pub fn is_empty(self) -> bool {
        self.len() == 0
    }

    /// Whether the cases are counted and numbered without gaps. In a block of more than 10^8 combinations, of which a
    /// condition must be tested one by one, the number of a case is that of its combination.
    pub fn is_counted(self) -> bool {
        !self.blocks.iter().any(Block::is_uncounted)
    }

    /// Number of raw combinations, at most the limit of the study.
    pub fn raw_len(self) -> u64 {
        self.blocks.iter().map(Block::raw_len).sum()
    }

    /// Case `index`, from 0, completed; `None` from `len` on, and for a combination that is no case.
    pub fn case(self, index: u64) -> Option<Case> {
        let (block, raw) = self.place(index)?;
        let case = block.completed(self.problem, raw);
        Some(Case {
            number: index,
            ..case
        })
    }

    /// The block of case `index`, and the combination of the case in it; `None` from `len` on.
    fn place(self, index: u64) -> Option<(&'a Block, u64)> {
        let mut rest = index;
        for block in self.blocks {
            let len = block.len(self.problem);
            if rest < len {
                return Some((block, block.raw_of(self.problem, rest)?));
            }
            rest -= len;
        }
        None
    }

    /// The rules that case `index` breaks. Only a large study has such cases.
    pub fn violations(self, index: u64) -> Vec<Violation> {
        let found = self.place(index);
        found.map_or_else(Vec::new, |(block, raw)| {
            let mut case = block.raw_case(self.problem, raw);
            match block.without_condition(&case) {
                Some(undecided) => vec![undecided],
                None => block.complete(self.problem, &mut case),
            }
        })
    }

    /// Rows of the parameters that are columns of tables, in the order of the problem's table.
    pub fn parameter_columns(self) -> Vec<usize> {
        let table = self.problem.parameters().iter().enumerate();
        let has_column = |(row, parameter): &(usize, &Parameter)| match parameter.column {
            ColumnRule::Always => true,
            ColumnRule::IfGiven => self.blocks.iter().any(|block| block.gives(*row)),
        };
        table.filter(has_column).map(|(row, _)| row).collect()
    }

    /// Number of the first case of a block.
    pub fn first_of(self, block: usize) -> u64 {
        let before = self.blocks.iter().take(block);
        before.map(|block| block.len(self.problem)).sum()
    }

    /// The block that case `index` belongs to.
    pub fn block_of(self, index: u64) -> Option<&'a Block> {
        let mut end = 0;
        self.blocks.iter().find(|block| {
            end += block.len(self.problem);
            index < end
        })
    }

    /// The cases among raw combinations `from..to` with their numbers.
    pub fn range(self, from: u64, to: u64) -> Selected<'a, (u64, Case)> {
        Box::new(self.parts(from, to).flat_map(move |(block, raws, number)| {
            let start = raws.start;
            let raws = raws.filter(|raw| block.is_case(self.problem, *raw));
            (number..).zip(raws).map(move |(next, raw)| {
                let uncounted = block.is_uncounted();
                let number = if uncounted {
                    number + raw - start
                } else {
                    next
                };
                let case = block.completed(self.problem, raw);
                (number, Case { number, ..case })
            })
        }))
    }

    /// Raw combination `raw` as a completed case; `None` if it is no case.
    pub fn combination(self, raw: u64) -> Option<Case> {
        let mut rest = raw;
        for block in self.blocks {
            if rest < block.raw_len() {
                let is_case = block.is_case(self.problem, rest);
                return is_case.then(|| block.completed(self.problem, rest));
            }
            rest -= block.raw_len();
        }
        None
    }

    /// The cases among raw combinations `from..to` as columns, and the number of the first; without any, that of the next case.
    pub fn columns(self, from: u64, to: u64) -> (u64, Cases) {
        let mut cases = Cases::new(self.problem.schema());
        let (mut case, mut first) = (Case::new(self.problem.schema()), None);
        let mut next_case = None;
        for (block, raws, number) in self.parts(from, to) {
            next_case.get_or_insert(number);
            if block.is_surely_empty(self.problem, &raws) {
                continue;
            }
            let (start, uncounted, mut next) = (raws.start, block.is_uncounted(), number);
            let (like, changing) = block.alike(self.problem);
            let mut alike = cases.alike(&like, &changing);
            if block.is_complete(self.problem) {
                let offset = number - *first.get_or_insert(number);
                let count = (raws.end - raws.start) as usize;
                alike.extend(offset, count, block.runs(raws));
                continue;
            }
            for raw in raws {
                let met = block.put_and_test(self.problem, raw, &mut case);
                if !met.unwrap_or(uncounted) {
                    continue;
                }
                if uncounted {
                    next = number + raw - start;
                }
                // Of a large block, not every case was tested when the study was read.
                let violations = match met {
                    Some(_) => block.complete(self.problem, &mut case),
                    None => block.without_condition(&case).into_iter().collect(),
                };
                let offset = next - *first.get_or_insert(next);
                alike.push(offset, &case, Violation::all(&violations));
                next += 1;
            }
        }
        (first.or(next_case).unwrap_or(0), cases)
    }

    /// Number of the first case among the raw combinations from `raw` on.
    pub fn first_from(self, raw: u64) -> u64 {
        let mut parts = self.parts(raw, self.raw_len());
        parts
            .next()
            .map_or_else(|| self.len(), |(_, _, number)| number)
    }

    /// The part of raw combinations `from..to` in each block, numbered from the start of the block, and the number of the
    /// first case there.
    fn parts(self, from: u64, to: u64) -> impl Iterator<Item = (&'a Block, Range<u64>, u64)> {
        let (mut start, mut cases) = (0, 0);
        self.blocks.iter().filter_map(move |block| {
            let (first, before) = (start, cases);
            start += block.raw_len();
            let raws = from.clamp(first, start) - first..to.clamp(first, start) - first;
            // The cases of the last block are not needed.
            if start < to {
                cases += block.len(self.problem);
            }
            let number = (!raws.is_empty()).then(|| before + block.rank(self.problem, raws.start));
            number.map(|number| (block, raws, number))
        })
    }

    /// The numbers of the cases that a filter selects, in rising order.
    pub fn select(self, filter: &'a Filter) -> Selected<'a, u64> {
        let mut end = 0;
        Box::new(self.blocks.iter().enumerate().flat_map(move |(i, block)| {
            let start = end;
            // The cases of the last block are not needed.
            if i + 1 < self.blocks.len() {
                end += block.len(self.problem);
            }
            let selected = block.select(self.problem, filter);
            selected.map(move |(_, number)| start + number)
        }))
    }

    /// The cases that a filter selects.
    pub fn cases(self, filter: &'a Filter) -> Selected<'a, Case> {
        Box::new(
            self.select(filter)
                .filter_map(move |index| self.case(index)),
        )
    }

    /// The different values of a parameter among the cases that a filter selects.
    pub fn levels(self, filter: &Filter, parameter: usize) -> Vec<Value> {
        let blocks = self.blocks.iter();
        distinct(blocks.flat_map(|block| block.levels(self.problem, filter, parameter)))
    }
}
