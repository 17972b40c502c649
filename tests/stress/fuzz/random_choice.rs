//! Random choices, determined by a seed.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// A source of choices.
pub struct RandomChoice(ChaCha8Rng);

impl RandomChoice {
    pub fn new(seed: u64) -> RandomChoice {
        RandomChoice(ChaCha8Rng::seed_from_u64(seed))
    }

    /// An integer below `end`, which is not 0.
    pub fn below(&mut self, end: usize) -> usize {
        (self.0.next_u64() % end as u64) as usize
    }

    /// True with the probability 1/n.
    pub fn once_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    /// One of several.
    pub fn of<'a, T: ?Sized>(&mut self, several: &[&'a T]) -> &'a T {
        several[self.below(several.len())]
    }

    /// A number from `a` to `b`, of three digits.
    pub fn between(&mut self, a: f64, b: f64) -> f64 {
        let x = a + (b - a) * (self.below(1001) as f64 / 1000.0);
        (x * 1000.0).round() / 1000.0
    }
}
