//! Shards: a study divided among processes that share nothing but the folder of its store.
//!
//! Shard I of N has every N-th part, beginning with part I. It takes no lock and removes no file. A part has the same bytes and,
//! with its checksum, the same name from every process, so that a part written twice is one file.

use super::chunk;
use super::compute;
use super::queue::PartQueue;
use super::run_part::{KeptPart, keep_part};
use super::store::Store;
use indicatif::ProgressBar;
use rayon::prelude::*;
use slipgap_study::Study;
use slipgap_study::error::Error;
use std::fmt;
use std::str::FromStr;

/// Number of parts for each thread that are computed at a time.
const PARTS: usize = 4;

/// One of N shards.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// From 1 to `of`.
    index: u64,
    of: u64,
}

impl Shard {
    /// Whether the shard has the part with this number, from 0.
    pub fn has(self, part: u64) -> bool {
        shard_of(part, self.of) == self.index
    }
}

/// The shard, from 1, that has the part with this number, from 0, if there are `of` shards.
pub fn shard_of(part: u64, of: u64) -> u64 {
    part % of.max(1) + 1
}

/// A text that is not `I/N`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ShardFault;

impl fmt::Display for ShardFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("must be I/N with whole numbers 1 <= I <= N, as in 3/16")
    }
}

impl std::error::Error for ShardFault {}

impl FromStr for Shard {
    type Err = ShardFault;

    /// Reads `I/N`.
    fn from_str(text: &str) -> Result<Shard, ShardFault> {
        let shard = text.split_once('/').and_then(|(index, of)| {
            let [index, of] = [index, of].map(|number| number.parse().ok());
            let (index, of) = (index?, of?);
            (1 <= index && index <= of).then_some(Shard { index, of })
        });
        shard.ok_or(ShardFault)
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.of)
    }
}

/// What a shard has done. All its parts are in the store.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct ShardResult {
    /// Number of parts of the shard.
    pub parts: u64,
    /// Number of these that were computed; the others were in the store.
    pub computed: u64,
    /// Number of cases in the computed parts that could not be solved.
    pub unsolved: u64,
}

/// Computes the parts of a shard that the store does not have, and saves them.
///
/// # Errors
/// The first part that cannot be saved.
pub fn run_shard(
    study: &Study,
    shard: Shard,
    store: &Store,
    bar: &ProgressBar,
) -> Result<ShardResult, Error> {
    compute::keep_memory();
    let mut queue = PartQueue::of_shard(study, shard);
    let count = chunk::parts_at_a_time(study, PARTS * rayon::current_num_threads());
    let mut result = ShardResult::default();
    loop {
        let parts = queue.next(count);
        if parts.is_empty() {
            return Ok(result);
        }
        let parts = parts.into_par_iter();
        let kept: Vec<KeptPart> = parts
            .map(|(_, part)| keep_part(study, part, bar, store))
            .collect::<Result<_, Error>>()?;
        for part in kept {
            result.parts += 1;
            result.computed += u64::from(part.computed);
            result.unsolved += part.unsolved;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shard_is_a_number_of_a_count() {
        for text in ["1/1", "3/16", "16/16", "7/1000000"] {
            assert_eq!(text.parse::<Shard>().unwrap().to_string(), text);
        }
        let wrong = [
            "",
            "/",
            "3",
            "0/4",
            "5/4",
            "1/0",
            "-1/4",
            "1/4/2",
            "1.5/4",
            "a/b",
            " 1/4",
            "1 / 4",
            "1/99999999999999999999",
        ];
        for text in wrong {
            let why = text.parse::<Shard>().unwrap_err();
            assert!(why.to_string().contains("1 <= I <= N"), "{text}");
        }
    }

    #[test]
    fn shards_have_every_nth_part_from_their_own() {
        let has = |shard: &str| -> Vec<u64> {
            let shard: Shard = shard.parse().unwrap();
            (0..8).filter(|part| shard.has(*part)).collect()
        };
        assert_eq!(has("1/3"), [0, 3, 6]);
        assert_eq!(has("3/3"), [2, 5]);
        assert_eq!(has("9/9"), [8_u64; 0]);
        assert_eq!(has("1/1").len(), 8);
    }
}
