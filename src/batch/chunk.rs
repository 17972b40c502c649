//! Chunks: fixed ranges of raw combinations, divided into parts by work.
//!
//! The parts of a chunk depend only on its own cases, none of which is computed for it. Every process makes the same parts,
//! and a study with more values on its first axis keeps its former chunks.

use std::ops::Range;
use std::sync::Arc;

use crate::problem::cases::Cases;
use crate::study::Study;

/// Raw combinations of a chunk.
const CHUNK: u64 = MOST_ROWS as u64;

/// Largest number of cases of a part.
pub const MOST_ROWS: usize = 16_384;

/// Largest number of steps times modes of a part of several cases: some seconds, which each thread of a killed run loses.
pub const WORK: u64 = 1 << 30;

/// The starts of the parts of the chunk that contains `start`.
pub fn starts_in_same_chunk(start: u64) -> Range<u64> {
    let from = start / CHUNK * CHUNK;
    from..from.saturating_add(CHUNK)
}

/// Number of chunks of a study.
pub fn count(study: &Study) -> u64 {
    study.raw_len().div_ceil(CHUNK)
}

/// Cases that are computed, stored and loaded together: those of a chunk, or some of them if they are much work.
#[derive(Debug)]
pub struct Part {
    /// Its place in file names: the first raw combination of the chunk plus the number of the chunk's cases before the part.
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

/// The parts of chunk `index`; none if conditions exclude all its combinations.
pub fn parts(study: &Study, index: u64) -> Vec<Part> {
    let from = index * CHUNK;
    let (first, cases) = study.columns(from, (from + CHUNK).min(study.raw_len()));
    let mut shown = cases.shown();
    // A case that breaks a rule is not solved, and its number of steps may be meaningless.
    let work = (0..cases.len()).map(|row| match cases.may_be_solved(row) {
        true => study.work(shown.at(row)),
        false => 0,
    });
    let ranges = split_by_work(work);
    let chunk = Arc::new(cases);
    let part = |(rows, work): (Range<usize>, u64)| Part {
        start: from + rows.start as u64,
        first: first + rows.start as u64,
        work,
        chunk: chunk.clone(),
        rows,
    };
    ranges.into_iter().map(part).collect()
}

/// Ranges of rows with their work, each as long as possible within `WORK`. A row with more work has a range of its own.
fn split_by_work(work: impl Iterator<Item = u64>) -> Vec<(Range<usize>, u64)> {
    let mut ranges: Vec<(Range<usize>, u64)> = Vec::new();
    for (row, work) in work.enumerate() {
        match ranges.last_mut() {
            Some((rows, sum)) if sum.saturating_add(work) <= WORK => {
                rows.end = row + 1;
                *sum += work;
            }
            _ => ranges.push((row..row + 1, work)),
        }
    }
    ranges
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::parse;

    #[test]
    fn a_part_is_full_before_the_next_begins_and_stays_within_the_limit() {
        let half = WORK / 2;
        let ends = |work: &[u64]| -> Vec<usize> {
            let ranges: Vec<_> = split_by_work(work.iter().copied())
                .into_iter()
                .map(|(rows, sum)| {
                    assert_eq!(sum, work[rows.clone()].iter().sum::<u64>());
                    rows
                })
                .collect();
            let starts = ranges.iter().map(|rows| rows.start);
            assert!(
                starts.eq([0]
                    .into_iter()
                    .chain(ranges.iter().map(|rows| rows.end))
                    .take(ranges.len()))
            );
            ranges.iter().map(|rows| rows.end).collect()
        };
        assert_eq!(ends(&[]), [0; 0]);
        assert_eq!(ends(&[0, 0, 0]), [3]);
        assert_eq!(ends(&[half, half, 1]), [2, 3]);
        assert_eq!(
            ends(&[1, half, half, WORK, 3 * WORK, 1, 1]),
            [2, 3, 4, 5, 7]
        );
        // The sum of these two exceeds 64 bits.
        assert_eq!(ends(&[u64::MAX, u64::MAX]), [1, 2]);
    }

    /// From coarse to fine steps, for each of `betas` values of beta. The number of steps is 3/dT.
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
    fn parts_contain_every_case_once_in_order_with_limited_work() {
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
    fn an_extended_study_keeps_all_parts_except_the_last() {
        let (short, long) = (all(&study(300)), all(&study(500)));
        let range = |part: &Part| (part.start, part.first, part.rows.clone());
        let unchanged = short.len() - 1;
        assert!(unchanged > 5);
        for (short, long) in short.iter().zip(&long).take(unchanged) {
            assert_eq!(range(short), range(long));
        }
    }
}
