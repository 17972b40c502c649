//! The parts of a study in order, numbered from 0, made from its chunks on demand.

use super::chunk::{self, Part};
use super::shard::Shard;
use rayon::prelude::*;
use slipgap_study::Study;
use std::collections::VecDeque;
use std::ops::Range;

/// The parts that are left.
pub(crate) struct PartQueue<'a> {
    study: &'a Study,
    /// Only parts of this shard are left, if there is one.
    shard: Option<Shard>,
    chunks: Range<u64>,
    /// Number of the first part of the next chunk: of the parts in all chunks before it, also those of other shards.
    number: u64,
    parts: VecDeque<(u64, Part)>,
}

impl<'a> PartQueue<'a> {
    /// All parts of a study.
    pub(crate) fn new(study: &'a Study) -> PartQueue<'a> {
        PartQueue {
            study,
            shard: None,
            chunks: 0..chunk::count(study),
            number: 0,
            parts: VecDeque::new(),
        }
    }

    /// The parts of one shard.
    pub(crate) fn of_shard(study: &'a Study, shard: Shard) -> PartQueue<'a> {
        PartQueue {
            shard: Some(shard),
            ..PartQueue::new(study)
        }
    }

    /// The next `count` parts with the numbers that decide their shards, fewer at the end. In a large study this is the number of
    /// the chunk, so that a shard makes only its own chunks; else the number of the part.
    pub(crate) fn next(&mut self, count: usize) -> Vec<(u64, Part)> {
        let (study, shard) = (self.study, self.shard);
        let whole = chunk::owned_whole(study);
        let has = |number: u64| shard.is_none_or(|shard| shard.has(number));
        while self.parts.len() < count && !self.chunks.is_empty() {
            let missing = count - self.parts.len();
            let wanted = self.chunks.by_ref().filter(|chunk| !whole || has(*chunk));
            let chunks: Vec<u64> = wanted.take(missing).collect();
            let parts = |chunk: &u64| (*chunk, chunk::parts(study, *chunk));
            let new: Vec<(u64, Vec<Part>)> = chunks.par_iter().map(parts).collect();
            for (chunk, parts) in new {
                for part in parts {
                    let number = if whole { chunk } else { self.number };
                    self.number += 1;
                    if has(number) {
                        self.parts.push_back((number, part));
                    }
                }
            }
        }
        let count = count.min(self.parts.len());
        self.parts.drain(..count).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipgap_study::parse;

    #[test]
    fn the_shards_have_every_part_once_and_in_order() {
        // 400 betas with 3e6 steps at the smallest dT: parts of unequal numbers of cases in three chunks.
        let study = parse(
            "s.json",
            r#"{"problem": "friction-oscillator", "parameters": {"law": "velocity-control", "duration": 3,
            "beta": {"linspace": [1, 400, 400]}, "dT": {"geomspace": [0.5, 1e-6, 100]}}}"#,
        )
        .unwrap();
        let take = |mut queue: PartQueue, count: usize| {
            let mut found = Vec::new();
            loop {
                let next = queue.next(count);
                if next.is_empty() {
                    return found;
                }
                assert!(next.len() <= count);
                found.extend(
                    next.into_iter()
                        .map(|(n, part)| (n, part.start, part.first)),
                );
            }
        };
        let whole = take(PartQueue::new(&study), 3);
        let chunks = chunk::count(&study);
        let of_chunks = (0..chunks).flat_map(|chunk| chunk::parts(&study, chunk));
        let direct = (0..)
            .zip(of_chunks)
            .map(|(n, part)| (n, part.start, part.first));
        assert!(whole.iter().copied().eq(direct));
        assert!(chunks == 3 && whole.len() > 8);
        for of in [1, 2, 5, 100] {
            let mut joined = Vec::new();
            for index in 1..=of {
                let shard: Shard = format!("{index}/{of}").parse().unwrap();
                let of_shard = take(PartQueue::of_shard(&study, shard), 1 + index as usize);
                // Every N-th part, beginning with part I.
                let numbers = (index - 1..whole.len() as u64).step_by(of as usize);
                assert!(of_shard.iter().map(|part| part.0).eq(numbers), "{shard}");
                joined.extend(of_shard);
            }
            joined.sort_unstable();
            assert_eq!(joined, whole);
        }
    }

    #[test]
    fn a_shard_of_a_large_study_makes_only_its_own_chunks() {
        // 10^9 combinations in 3815 chunks. All would take minutes.
        let study = parse(
            "s.json",
            r#"{"problem": "friction-oscillator", "parameters": {"law": "velocity-control", "duration": 3, "dT": 0.5,
            "beta": {"linspace": [1, 2, 100000]}, "x0": {"linspace": [1, 2, 10000]}}}"#,
        )
        .unwrap();
        assert_eq!(chunk::count(&study), 3815);
        let mut queue = PartQueue::of_shard(&study, "814/1000".parse().unwrap());
        let found: Vec<(u64, u64)> = std::iter::from_fn(|| queue.next(2).pop())
            .map(|(number, part)| (number, part.start))
            .collect();
        assert_eq!(found, [(1813, 1813 << 18), (3813, 3813 << 18)]);
        let mut queue = PartQueue::of_shard(&study, "815/1000".parse().unwrap());
        let found: Vec<u64> = queue
            .next(9)
            .into_iter()
            .map(|(number, _)| number)
            .collect();
        assert_eq!(found, [814, 1814, 2814, 3814]);
    }
}
