//! Runs that are killed, without space, or disturbed. In every case all files with final names are complete, and the next run
//! leaves exactly the same files with the same bytes as an undisturbed run.
//!
//! Each test has a short form and a long one, which `make torture` runs. TORTURE=N makes the long ones N times as long.
#![cfg(unix)]

#[path = "../../common/bench.rs"]
mod bench;
mod damaged;
mod full;
mod killed;
mod no_locks;
mod scene;
mod shards;
mod threads;
mod together;
mod traced;
mod tree;

pub(crate) use bench::{Bench, Done};
pub(crate) use scene::Scene;
pub(crate) use tree::{Tree, differences, program};

/// Number of rounds of a long form.
pub(crate) fn long(rounds: u64) -> u64 {
    let factor = std::env::var("TORTURE").ok().and_then(|n| n.parse().ok());
    rounds * factor.unwrap_or(1)
}

/// Reproducible random numbers (SplitMix64).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// A number below `end`.
    pub(crate) fn below(&mut self, end: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) % end.max(1)
    }
}
