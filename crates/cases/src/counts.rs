//! Which combinations of a block meet its condition: their number, and the combination of each case number.
//!
//! The cases of a block are numbered without gaps, for which all combinations are tested when the study is read. This takes
//! 0.1 us for a combination. A block of very many combinations with a condition without a table is not counted: the number of
//! a case is that of its combination, and each part tests its own.

use super::block::{Block, CaseCounts};
use crate::formulas::derived::Condition;
use slipgap_problem::problem::{Case, NotComputed, Problem, Violation};
use std::ops::Range;

/// Combinations between two counts of cases.
const STRIDE: u64 = 4096;

/// Most combinations of a block that are counted, if its condition has no table: ten seconds.
const MOST_COUNTED: u64 = 100_000_000;

impl Block {
    /// Whether the number of a case is that of its combination, because there are too many combinations to test.
    pub fn is_uncounted(&self) -> bool {
        let without_table = |when: &Condition| when.formula.table.is_none();
        self.when.as_ref().is_some_and(without_table) && self.raw_len() > MOST_COUNTED
    }

    /// Whether combination `raw` is a case. If the condition of an uncounted block has no value, it is a case that cannot be
    /// solved.
    pub fn is_case(&self, problem: &dyn Problem, raw: u64) -> bool {
        let met = self.meets_condition(problem, raw);
        met.unwrap_or_else(|| self.is_uncounted())
    }

    /// Writes combination `raw` over `case`, before `Problem::complete`, and tests whether it is a case; `None` if the condition
    /// has no value.
    pub fn put_and_test(&self, problem: &dyn Problem, raw: u64, case: &mut Case) -> Option<bool> {
        match &self.when {
            Some(when) if when.formula.table.is_none() => {
                self.put(problem, raw, case);
                when.holds(&self.groups, case, &[])
            }
            Some(_) | None => {
                let met = self.meets_condition(problem, raw);
                if met == Some(true) {
                    self.put(problem, raw, case);
                }
                met
            }
        }
    }

    /// That the condition has no value for a case of an uncounted block. In other blocks this is a fault of the study.
    pub fn without_condition(&self, case: &Case) -> Option<Violation> {
        let when = self.when.as_ref().filter(|_| self.is_uncounted())?;
        let fault = when.formula.formula.value(&|row| case.values[row]).err()?;
        Some(Violation {
            parameter: "when".into(),
            message: NotComputed::new(&when.formula.formula, &when.text, case, fault).to_string(),
            at: None,
        })
    }

    /// The same; `None` if the condition has no value.
    fn meets_condition(&self, problem: &dyn Problem, raw: u64) -> Option<bool> {
        let Some(when) = &self.when else {
            return Some(true);
        };
        let positions = self.positions(raw);
        let looked_up = when.looked_up(&self.groups, &positions);
        looked_up.or_else(|| when.holds(&self.groups, &self.raw_case(problem, raw), &positions))
    }

    fn counts(&self, problem: &dyn Problem) -> &CaseCounts {
        self.counts.get_or_init(|| {
            let when = self.when.as_ref();
            match when.and_then(|when| when.formula.table.as_ref()) {
                Some(values) => CaseCounts::Tabled(running_count(values)),
                None => self.counted(problem),
            }
        })
    }

    fn counted(&self, problem: &dyn Problem) -> CaseCounts {
        let (mut counts, mut count, mut undecided) = (vec![0], 0, None);
        for raw in 0..self.raw_len() {
            match self.meets_condition(problem, raw) {
                Some(met) => count += u64::from(met),
                None => undecided = undecided.or(Some(raw)),
            }
            if (raw + 1) % STRIDE == 0 {
                counts.push(count);
            }
        }
        counts.push(count);
        CaseCounts::Counted { counts, undecided }
    }

    /// The first combination for which the condition has no value.
    pub fn undecided(&self, problem: &dyn Problem) -> Option<u64> {
        if self.when.is_none() || self.is_uncounted() {
            return None;
        }
        match self.counts(problem) {
            CaseCounts::Tabled(_) => None,
            CaseCounts::Counted { undecided, .. } => *undecided,
        }
    }

    /// Number of cases; of an uncounted block, of combinations.
    pub fn len(&self, problem: &dyn Problem) -> u64 {
        if self.when.is_none() || self.is_uncounted() {
            return self.raw_len();
        }
        match self.counts(problem) {
            CaseCounts::Tabled(before) => {
                before.last().copied().unwrap_or(0) * self.combinations_per_entry()
            }
            CaseCounts::Counted { counts, .. } => counts.last().copied().unwrap_or(0),
        }
    }

    /// Whether a table shows that no combination in this range is a case.
    pub fn is_surely_empty(&self, problem: &dyn Problem, raws: &Range<u64>) -> bool {
        let has_table = |when: &Condition| when.formula.table.is_some();
        let rank = |raw: u64| match raw == self.raw_len() {
            true => self.len(problem),
            false => self.rank(problem, raw),
        };
        self.when.as_ref().is_some_and(has_table) && rank(raws.start) == rank(raws.end)
    }

    /// Number of cases before combination `raw`; in an uncounted block, of combinations.
    pub fn rank(&self, problem: &dyn Problem, raw: u64) -> u64 {
        if self.when.is_none() || self.is_uncounted() {
            return raw;
        }
        match self.counts(problem) {
            CaseCounts::Tabled(before) => self.cases_before(before, raw),
            CaseCounts::Counted { counts, .. } => {
                let start = raw / STRIDE;
                let between = (start * STRIDE..raw).filter(|raw| self.is_case(problem, *raw));
                counts[start as usize] + between.count() as u64
            }
        }
    }

    /// The combination that is case `index` of the block.
    pub fn raw_of(&self, problem: &dyn Problem, index: u64) -> Option<u64> {
        if index >= self.len(problem) {
            return None;
        }
        if self.when.is_none() {
            return Some(index);
        }
        if self.is_uncounted() {
            return self.is_case(problem, index).then_some(index);
        }
        match self.counts(problem) {
            CaseCounts::Tabled(before) => Some(self.combination_of(before, index)),
            CaseCounts::Counted { counts, .. } => {
                let after = counts.partition_point(|count| *count <= index);
                let start = after.checked_sub(1)? as u64;
                let skip = (index - counts[start as usize]) as usize;
                let mut cases =
                    (start * STRIDE..self.raw_len()).filter(|raw| self.is_case(problem, *raw));
                cases.nth(skip)
            }
        }
    }

    /// Whether the condition depends on a group.
    fn in_condition(&self, group: usize) -> bool {
        let when = self.when.as_ref();
        when.is_some_and(|when| when.formula.on.contains(&group))
    }

    /// Number of combinations of the groups that the condition does not depend on.
    fn combinations_per_entry(&self) -> u64 {
        let others = (0..self.groups.len()).filter(|group| !self.in_condition(*group));
        others.map(|group| self.groups[group].len()).product()
    }

    /// Number of cases before combination `raw`, summed over the groups: those with the same positions in the groups before
    /// and an earlier position in the group. `before` is the list of [`CaseCounts::Tabled`].
    fn cases_before(&self, before: &[u64], raw: u64) -> u64 {
        // The entries with the positions so far are `first..first + span`.
        let (mut first, mut span) = (0, before.len() as u64 - 1);
        let (mut repeats, mut count) = (self.combinations_per_entry(), 0);
        let met = |from: u64, to: u64| before[to as usize] - before[from as usize];
        for (group, position) in self.positions(raw).into_iter().enumerate() {
            let len = self.groups[group].len();
            if self.in_condition(group) {
                span /= len;
                count += met(first, first + position * span) * repeats;
                first += position * span;
            } else {
                repeats /= len;
                count += position * met(first, first + span) * repeats;
            }
        }
        count
    }

    /// The combination that is case `index`, which must exist: the inverse of `cases_before`.
    fn combination_of(&self, before: &[u64], mut index: u64) -> u64 {
        let (mut first, mut span) = (0, before.len() as u64 - 1);
        let (mut repeats, mut raw) = (self.combinations_per_entry(), 0);
        let met = |from: u64, to: u64| before[to as usize] - before[from as usize];
        for (group, axes) in self.groups.iter().enumerate() {
            let len = axes.len();
            let position = if self.in_condition(group) {
                span /= len;
                // The first position at whose end there are more than `index` cases.
                let (mut low, mut high) = (0, len - 1);
                while low < high {
                    let middle = low + (high - low) / 2;
                    match met(first, first + (middle + 1) * span) * repeats > index {
                        true => high = middle,
                        false => low = middle + 1,
                    }
                }
                index -= met(first, first + low * span) * repeats;
                first += low * span;
                low
            } else {
                repeats /= len;
                let each = (met(first, first + span) * repeats).max(1);
                let position = index / each;
                index -= position * each;
                position
            };
            raw = raw * len + position;
        }
        raw
    }
}

/// The number of true values before each one, and in all.
fn running_count(values: &[f64]) -> Vec<u64> {
    let mut counts = vec![0];
    let mut count = 0;
    for value in values {
        count += u64::from(*value != 0.0);
        counts.push(count);
    }
    counts
}
