//! Chunks: fixed ranges of raw combinations, and the parts that they are cut into by work.
//!
//! The parts of a chunk follow from its own cases alone, without computing any: every process finds the same ones, chunk by
//! chunk, and a study with more values on its first axis keeps the chunks that it had.

use std::ops::Range;
use std::sync::Arc;

use crate::problem::cases::Cases;
use crate::study::Study;

/// Raw combinations of a chunk.
const RAW: u64 = MOST_ROWS as u64;

/// Most cases of a part.
pub const MOST_ROWS: usize = 16_384;

/// Steps times modes of a part: some seconds, the most that a killed run loses for each thread.
pub const WORK: u64 = 1 << 30;

/// The names that parts of the same chunk can have.
pub fn starts_near(start: u64) -> Range<u64> {
    let from = start / RAW * RAW;
    from..from.saturating_add(RAW)
}

/// Number of chunks of a study.
pub fn count(study: &Study) -> u64 {
    study.raw_len().div_ceil(RAW)
}

/// Cases that are computed, kept and found together: those of a chunk, or some of them where they are much work.
#[derive(Debug)]
pub struct Part {
    /// What names it: the first raw combination of its chunk, and on from there by the cases of the chunk before it.
    pub start: u64,
    /// Number of its first case.
    pub first: u64,
    /// Steps times modes of its cases.
    pub work: u64,
    chunk: Arc<Cases>,
    rows: Range<usize>,
}

impl Part {
    /// Its cases.
    pub fn cases(self) -> Cases {
        match self.rows.len() == self.chunk.len() {
            true => Arc::unwrap_or_clone(self.chunk),
            false => self.chunk.only(self.rows),
        }
    }
}

/// The parts of chunk `index`; none where a condition dropped all its combinations.
pub fn parts(study: &Study, index: u64) -> Vec<Part> {
    let from = index * RAW;
    let (first, cases) = study.columns(from, (from + RAW).min(study.raw_len()));
    let mut shown = cases.shown();
    // A case that breaks a rule is not solved, and its number of steps may mean nothing.
    let work = (0..cases.len()).map(|row| match cases.may_be_solved(row) {
        true => study.work(shown.at(row)),
        false => 0,
    });
    let cuts = cut(work);
    let chunk = Arc::new(cases);
    let part = |(rows, work): (Range<usize>, u64)| Part {
        start: from + rows.start as u64,
        first: first + rows.start as u64,
        work,
        chunk: chunk.clone(),
        rows,
    };
    cuts.into_iter().map(part).collect()
}

/// Rows in their order with their work, as many together as stay within `WORK`; one that alone is more is by itself.
fn cut(work: impl Iterator<Item = u64>) -> Vec<(Range<usize>, u64)> {
    let mut cuts: Vec<(Range<usize>, u64)> = Vec::new();
    for (row, work) in work.enumerate() {
        match cuts.last_mut() {
            Some((rows, sum)) if sum.saturating_add(work) <= WORK => {
                rows.end = row + 1;
                *sum += work;
            }
            _ => cuts.push((row..row + 1, work)),
        }
    }
    cuts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::parse;

    #[test]
    fn a_part_is_full_before_the_next_begins_and_holds_no_more() {
        let half = WORK / 2;
        let ends = |work: &[u64]| -> Vec<usize> {
            let cuts: Vec<_> = cut(work.iter().copied())
                .into_iter()
                .map(|(rows, sum)| {
                    assert_eq!(sum, work[rows.clone()].iter().sum::<u64>());
                    rows
                })
                .collect();
            let starts = cuts.iter().map(|rows| rows.start);
            assert!(
                starts.eq([0]
                    .into_iter()
                    .chain(cuts.iter().map(|rows| rows.end))
                    .take(cuts.len()))
            );
            cuts.iter().map(|rows| rows.end).collect()
        };
        assert_eq!(ends(&[]), [0; 0]);
        assert_eq!(ends(&[0, 0, 0]), [3]);
        assert_eq!(ends(&[half, half, 1]), [2, 3]);
        assert_eq!(
            ends(&[1, half, half, WORK, 3 * WORK, 1, 1]),
            [2, 3, 4, 5, 7]
        );
        // The sum of two such is beyond 64 bits.
        assert_eq!(ends(&[u64::MAX, u64::MAX]), [1, 2]);
    }

    /// From coarse to fine, for each of so many values of beta: steps are what their quotient says, 3/dT.
    fn study(betas: usize) -> Study {
        let text = format!(
            r#"{{"problem": "friction-oscillator", "parameters": {{"law": "velocity-control", "duration": 3,
            "beta": {{"linspace": [1, {betas}, {betas}]}}, "dT": {{"geomspace": [0.5, 1e-6, 100]}}}}}}"#
        );
        parse("s.json", &text).unwrap()
    }

    fn all(study: &Study) -> Vec<Part> {
        (0..count(study))
            .flat_map(|chunk| parts(study, chunk))
            .collect()
    }

    #[test]
    fn parts_hold_every_case_once_in_order_and_bounded_work() {
        let study = study(400);
        let parts = all(&study);
        // 400 times the sum of 3/dT, a geometric series of 3e6 (1 - r^100)/(1 - r) with r = 2e-6^(1/99).
        let series = 3e6 / (1.0 - 2e-6_f64.powf(1.0 / 99.0));
        let least = (400.0 * series / WORK as f64) as usize;
        assert!(
            least > 8 && (least..2 * least).contains(&parts.len()),
            "{}",
            parts.len()
        );
        let (mut next, mut starts) = (0, Vec::new());
        for part in parts {
            assert_eq!(part.first, next);
            starts.push(part.start);
            let cases = part.cases();
            let mut shown = cases.shown();
            let steps =
                |row: usize| (3.0 / shown.at(row).number("dT").unwrap() * (1.0 + 1e-12)) as u64;
            let work: u64 = (0..cases.len()).map(steps).sum();
            assert!(work <= WORK, "{work}");
            for row in 0..cases.len() {
                let number = |case: &crate::problem::Case| [case.number("beta"), case.number("dT")];
                assert_eq!(
                    number(cases.shown().at(row)),
                    number(&study.case(next).unwrap())
                );
                next += 1;
            }
        }
        assert_eq!(next, study.len());
        assert!(starts.is_sorted_by(|a, b| a < b));
    }

    #[test]
    fn an_extended_study_keeps_all_parts_but_the_last() {
        let (short, long) = (all(&study(300)), all(&study(500)));
        let cut = |part: &Part| (part.start, part.first, part.rows.clone());
        let kept = short.len() - 1;
        assert!(kept > 5);
        for (short, long) in short.iter().zip(&long).take(kept) {
            assert_eq!(cut(short), cut(long));
        }
    }
}
