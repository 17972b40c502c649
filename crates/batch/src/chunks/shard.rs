//! Shards: a study divided among processes that share nothing but the folder of its store.
//!
//! Shard I of N has every N-th part, beginning with part I. It takes no lock and removes no file. A part has the same bytes and,
//! with its checksum, the same name from every process, so that a part written twice is one file.

use std::fmt;
use std::str::FromStr;

/// One of N shards.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// From 1 to `of`.
    index: u64,
    of: u64,
}

impl Shard {
    /// All shards, if there are `of`.
    pub fn all(of: u64) -> impl Iterator<Item = Shard> {
        (1..=of).map(move |index| Shard { index, of })
    }

    /// Its number, from 1.
    pub fn index(self) -> u64 {
        self.index
    }

    /// The number of shards.
    pub fn of(self) -> u64 {
        self.of
    }

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
