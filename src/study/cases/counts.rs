//! Which combinations of a block its condition keeps as cases: counted, and found again by number.

use crate::problem::Problem;
use crate::study::Block;

/// The counts of a block with a condition.
#[derive(Debug, Clone)]
pub(in crate::study) enum Kept {
    /// Where the condition's values are known for all sets of what it depends on: how many sets before each meet it, and
    /// how many do at all. No combination has to be made.
    Known(Vec<u64>),
    /// Otherwise the number of cases before every `STRIDE`-th combination, and at the end; and the first combination for
    /// which the condition has no value.
    Counted(Vec<u64>, Option<u64>),
}

/// Combinations between two counts of cases.
const STRIDE: u64 = 4096;

impl Block {
    /// Whether combination `raw` is a case.
    pub(in crate::study) fn keeps(&self, problem: &dyn Problem, raw: u64) -> bool {
        self.decides(problem, raw) == Some(true)
    }

    /// The same; `None` where the condition has no value.
    fn decides(&self, problem: &dyn Problem, raw: u64) -> Option<bool> {
        let Some(when) = &self.when else {
            return Some(true);
        };
        let digits = self.digits(raw);
        let known = when.tabled(self, &digits);
        known.or_else(|| when.holds(self, &self.raw_case(problem, raw), &digits))
    }

    fn kept(&self, problem: &dyn Problem) -> &Kept {
        self.kept.get_or_init(|| {
            let known = self.when.as_ref().and_then(|when| when.rule.table.as_ref());
            match known {
                Some(values) => Kept::Known(before(values)),
                None => self.counted(problem),
            }
        })
    }

    fn counted(&self, problem: &dyn Problem) -> Kept {
        let (mut counts, mut count, mut undecided) = (vec![0], 0, None);
        for raw in 0..self.raw_len() {
            match self.decides(problem, raw) {
                Some(kept) => count += u64::from(kept),
                None => undecided = undecided.or(Some(raw)),
            }
            if (raw + 1) % STRIDE == 0 {
                counts.push(count);
            }
        }
        counts.push(count);
        Kept::Counted(counts, undecided)
    }

    /// The first combination for which the condition has no value.
    pub(in crate::study) fn undecided(&self, problem: &dyn Problem) -> Option<u64> {
        self.when.as_ref()?;
        match self.kept(problem) {
            Kept::Known(_) => None,
            Kept::Counted(_, undecided) => *undecided,
        }
    }

    /// Number of cases.
    pub(in crate::study) fn len(&self, problem: &dyn Problem) -> u64 {
        if self.when.is_none() {
            return self.raw_len();
        }
        match self.kept(problem) {
            Kept::Known(before) => before.last().copied().unwrap_or(0) * self.around(),
            Kept::Counted(counts, _) => counts.last().copied().unwrap_or(0),
        }
    }

    /// Number of cases before combination `raw`.
    pub(in crate::study) fn rank(&self, problem: &dyn Problem, raw: u64) -> u64 {
        if self.when.is_none() {
            return raw;
        }
        match self.kept(problem) {
            Kept::Known(before) => self.cases_before(before, raw),
            Kept::Counted(counts, _) => {
                let start = raw / STRIDE;
                let between = (start * STRIDE..raw).filter(|raw| self.keeps(problem, *raw));
                counts[start as usize] + between.count() as u64
            }
        }
    }

    /// The combination that is case `index` of the block.
    pub(in crate::study) fn raw_of(&self, problem: &dyn Problem, index: u64) -> Option<u64> {
        if index >= self.len(problem) {
            return None;
        }
        if self.when.is_none() {
            return Some(index);
        }
        match self.kept(problem) {
            Kept::Known(before) => Some(self.at_place(before, index)),
            Kept::Counted(counts, _) => {
                let start = counts.partition_point(|count| *count <= index);
                let start = start.checked_sub(1)? as u64;
                let skip = (index - counts[start as usize]) as usize;
                let mut within =
                    (start * STRIDE..self.raw_len()).filter(|raw| self.keeps(problem, *raw));
                within.nth(skip)
            }
        }
    }

    /// Whether the condition depends on a group.
    fn decisive(&self, group: usize) -> bool {
        let when = self.when.as_ref();
        when.is_some_and(|when| when.rule.on.contains(&group))
    }

    /// Number of combinations of the groups that the condition does not depend on.
    fn around(&self) -> u64 {
        let others = (0..self.groups.len()).filter(|group| !self.decisive(*group));
        others.map(|group| self.groups[group].len()).product()
    }

    /// Number of cases before combination `raw`: group by group, those that have the same places before the group and an
    /// earlier one in it. `before` counts sets as in [`Kept::Known`].
    fn cases_before(&self, before: &[u64], raw: u64) -> u64 {
        // The sets that begin with the places so far are `first..first + span`.
        let (mut first, mut span) = (0, before.len() as u64 - 1);
        let (mut around, mut count) = (self.around(), 0);
        let met = |from: u64, to: u64| before[to as usize] - before[from as usize];
        for (group, digit) in self.digits(raw).into_iter().enumerate() {
            let len = self.groups[group].len();
            if self.decisive(group) {
                span /= len;
                count += met(first, first + digit * span) * around;
                first += digit * span;
            } else {
                around /= len;
                count += digit * met(first, first + span) * around;
            }
        }
        count
    }

    /// The combination that is case `index`, which there must be; the reverse of `cases_before`.
    fn at_place(&self, before: &[u64], mut index: u64) -> u64 {
        let (mut first, mut span) = (0, before.len() as u64 - 1);
        let (mut around, mut raw) = (self.around(), 0);
        let met = |from: u64, to: u64| before[to as usize] - before[from as usize];
        for (group, axes) in self.groups.iter().enumerate() {
            let len = axes.len();
            let digit = if self.decisive(group) {
                span /= len;
                // The first place up to whose end there are more cases than `index`.
                let (mut low, mut high) = (0, len - 1);
                while low < high {
                    let middle = low + (high - low) / 2;
                    match met(first, first + (middle + 1) * span) * around > index {
                        true => high = middle,
                        false => low = middle + 1,
                    }
                }
                index -= met(first, first + low * span) * around;
                first += low * span;
                low
            } else {
                around /= len;
                let each = (met(first, first + span) * around).max(1);
                let digit = index / each;
                index -= digit * each;
                digit
            };
            raw = raw * len + digit;
        }
        raw
    }
}

/// How many of the first values are true, for each number of them.
fn before(values: &[f64]) -> Vec<u64> {
    let mut counts = vec![0];
    let mut count = 0;
    for value in values {
        count += u64::from(*value != 0.0);
        counts.push(count);
    }
    counts
}
