//! Chunks: fixed ranges of raw combinations, divided into parts by work.
//!
//! The parts of a chunk depend only on its own cases, none of which is computed for it. Every process makes the same parts,
//! and a study with more values on its first axis keeps its former chunks, unless it becomes large.
//!
//! A study is large if it has more than 4096 chunks. Its chunks are longer, its parts are in sub-folders of the store, and its
//! shards have whole chunks, so that a shard makes no cases of others.

use std::ops::Range;
use std::sync::Arc;

use slipgap_problem::problem::table::cases::Cases;
use slipgap_study::Study;

/// Raw combinations of a chunk; in a large study a power of two times as many.
const CHUNK: u64 = 16_384;

/// Most chunks of a study that is not large.
const MOST_CHUNKS: u64 = 4096;

/// Largest number of cases of a part.
pub const MOST_ROWS: usize = 1 << 18;

/// Chunks of a large study of which the parts are in one folder. Chunks of much work have several parts.
const CHUNKS_OF_FOLDER: u64 = 1024;

/// Largest number of steps times modes of a part of several cases: some seconds, which each thread of a killed run loses.
pub const WORK: u64 = 1 << 30;

/// Whether the study is so large that its chunks are longer and its parts are in sub-folders.
pub fn is_large(study: &Study) -> bool {
    study.raw_len() > MOST_CHUNKS * CHUNK
}

/// Whether a shard has whole chunks of the study instead of every N-th part.
pub fn owned_whole(study: &Study) -> bool {
    is_large(study)
}

/// Raw combinations of a chunk of the study: as few as make at most 4096 chunks.
fn len(study: &Study) -> u64 {
    length(study.raw_len())
}

fn length(combinations: u64) -> u64 {
    let times = combinations.div_ceil(MOST_CHUNKS * CHUNK);
    (times.max(1).next_power_of_two() * CHUNK).min(MOST_ROWS as u64)
}

/// The number of parts to compute at a time, if it is `wanted` for parts of usual length: memory does not grow with chunks.
pub fn parts_at_a_time(study: &Study, wanted: usize) -> usize {
    let times = (len(study) / CHUNK) as usize;
    (wanted / times).max(rayon::current_num_threads())
}

/// The starts of the parts of the chunk that contains `start`.
pub fn starts_in_same_chunk(study: &Study, start: u64) -> Range<u64> {
    let len = len(study);
    let from = start / len * len;
    from..from.saturating_add(len)
}

/// The sub-folder of the store with the part that has this start; `None` if the study is not large.
pub fn folder(study: &Study, start: u64) -> Option<u64> {
    is_large(study).then(|| start / len(study) / CHUNKS_OF_FOLDER)
}

/// Number of chunks of a study.
pub fn count(study: &Study) -> u64 {
    study.raw_len().div_ceil(len(study))
}

/// The raw combinations of chunk `index`.
pub fn combinations(study: &Study, index: u64) -> Range<u64> {
    let from = index * len(study);
    from..(from + len(study)).min(study.raw_len())
}

/// The chunk that contains raw combination `raw`.
pub fn of_combination(study: &Study, raw: u64) -> u64 {
    raw / len(study)
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
    /// Number of its cases.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether it has no cases; there is no such part.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

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
    let Range { start: from, end } = combinations(study, index);
    let (first, cases) = study.columns(from, end);
    let ranges = split_by_work(study.costs(&cases));
    let chunk = Arc::new(cases);
    let part = |(rows, work): (Range<usize>, u64)| Part {
        start: from + rows.start as u64,
        first: first + chunk.offset(rows.start),
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
    use slipgap_study::parse;

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
                let number = |case: &slipgap_problem::problem::Case| {
                    [case.number("beta"), case.number("dT")]
                };
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

    #[test]
    fn large_studies_have_longer_chunks() {
        let lengths = |combinations: u64| length(combinations);
        assert_eq!([1, 16_385, 67_108_864].map(lengths), [16_384; 3]);
        assert_eq!([67_108_865, 134_217_728].map(lengths), [32_768; 2]);
        assert_eq!([134_217_729, 268_435_456].map(lengths), [65_536; 2]);
        assert_eq!(
            [1 << 30, 1 << 31, 1_000_000_000_000].map(lengths),
            [262_144; 3]
        );
    }

    /// 10^12 combinations, of which some 785 of 1000 are cases; the condition has too many values for a table.
    fn large() -> Study {
        let text = r#"{"problem": "friction-oscillator", "parameters": {"law": "velocity-control", "dT": 0.5, "duration": 3,
            "beta": {"linspace": [0.001, 1, 1000000]}, "x0": {"linspace": [0.001, 1, 1000000]}},
            "when": "beta^2 + x0^2 < 1"}"#;
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), text).unwrap();
        slipgap_study::Input::of_file(file.path())
            .unwrap()
            .study(u64::MAX)
            .unwrap()
    }

    #[test]
    fn a_chunk_of_a_large_study_is_made_without_the_others() {
        let study = large();
        assert!(!study.enumeration().is_counted() && is_large(&study));
        assert_eq!(count(&study), 3_814_698);
        // Combinations 382 976 to 645 119 of a row of 10^6. beta is 0.9001, so that the condition is met up to x0 = 0.4357.
        let index = 3_433_229;
        let parts = parts(&study, index);
        let (mut last, mut cases_in_all) = (0, 0);
        for part in parts {
            let (start, first) = (part.start, part.first);
            assert_eq!(start, index * 262_144 + cases_in_all);
            assert_eq!(folder(&study, start), Some(index / 1024));
            let cases = part.cases();
            let mut shown = cases.shown();
            for row in 0..cases.len() {
                let number = first + cases.offset(row);
                // The number of the combination: x0 varies fastest.
                let at = |i: u64| 0.001 + 0.999 * i as f64 / 999_999.0;
                let expected = [at(number / 1_000_000), at(number % 1_000_000)];
                let case = shown.at(row);
                for (name, expected) in [("beta", expected[0]), ("x0", expected[1])] {
                    assert!((case.number(name).unwrap() - expected).abs() < 1e-12);
                }
                assert!(expected[0].powi(2) + expected[1].powi(2) < 1.0);
                assert!(number > last);
                last = number;
            }
            cases_in_all += cases.len() as u64;
        }
        let beta: f64 = 0.001 + 0.999 * 900_000.0 / 999_999.0;
        let met = (((1.0 - beta * beta).sqrt() - 0.001) / 0.999 * 999_999.0).ceil() as u64;
        assert_eq!(cases_in_all, met - 382_976);
        assert!(study.case(last).is_some() && study.case(1_000_000_000_000 - 1).is_none());
    }

    #[test]
    fn references_are_counted_as_work() {
        let study = |more: &str| {
            let text = format!(
                r#"{{"problem": "bar-impact", {more} "parameters": {{"gamma": {{"linspace": [0.5, 1, 64]}}, "duration": 1.5,
                "n": 20, "dt": {{"geomspace": [0.01, 0.0001, 64]}}}}}}"#
            );
            parse("s.json", &text).unwrap()
        };
        // 1.5/dt steps of 42 modes, a geometric series: 64 gammas times 3.2e5 steps.
        let work = |study: &Study| all(study).iter().map(|part| part.work).sum::<u64>();
        let steps =
            64.0 * 150.0 * (1.0 - 100_f64.powf(64.0 / 63.0)) / (1.0 - 100_f64.powf(1.0 / 63.0));
        let plain = work(&study("")) as f64;
        assert!(
            (plain / (42.0 * steps) - 1.0).abs() < 1e-3,
            "{plain} {steps}"
        );
        // Measured on the same core: 45 to 65 ns for a mode and step with the parts of the error, 16 to 31 ns for each element of
        // the full matrix if each step is solved once; 2 ns for a mode and step without.
        let budget = work(&study(r#""metrics": ["step_error_r"],"#)) as f64;
        assert!(
            (20.0..35.0).contains(&(budget / plain)),
            "{}",
            budget / plain
        );
        let once = work(&study(r#""iteration": "once","#)) as f64;
        assert!(
            (8.0 * 42.0..16.0 * 42.0).contains(&(once / plain)),
            "{}",
            once / plain
        );
        for study in [
            study(""),
            study(r#""metrics": ["step_error_r"],"#),
            study(r#""iteration": "once","#),
        ] {
            for part in all(&study) {
                assert!(part.work <= WORK || part.rows.len() == 1, "{}", part.work);
            }
        }
    }
}
