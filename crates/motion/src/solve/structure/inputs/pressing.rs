//! Limits by the forces of other parts at the end of a step: it is done again from its start until they stay.

use crate::lane::Lane;

/// Largest change of a limit, as a part of it, that ends the rounds: round-off of the forces.
const STAYS: f64 = 1e-13;

/// Rounds after which a guess that came no nearer is followed by half of its way: limits that alternate settle so.
const FREE: usize = 8;

/// Most rounds.
const MOST: usize = 60;

/// Largest change of a limit, as a part of it, that the last of these rounds may leave.
const SETTLED: f64 = 1e-9;

/// The limits that change, in the rounds of a step.
#[derive(Debug)]
pub(crate) struct Pressing<const L: usize> {
    limits: Vec<Guess<L>>,
    /// Lanes whose limits stay. They are not changed again, so that their bits do not depend on other lanes.
    settled: [bool; L],
    rounds: usize,
}

/// A limit.
#[derive(Debug, Clone, Copy)]
struct Guess<const L: usize> {
    /// With which a round is done, and what the end of the round has more.
    used: Lane<L>,
    missed: Lane<L>,
    /// The same of the round before.
    before: [Lane<L>; 2],
}

impl<const L: usize> Pressing<L> {
    /// For so many limits.
    pub(crate) fn new(limits: usize) -> Self {
        let zero = Lane::splat(0.0);
        let guess = Guess {
            used: zero,
            missed: zero,
            before: [zero; 2],
        };
        Pressing {
            limits: vec![guess; limits],
            settled: [false; L],
            rounds: 0,
        }
    }

    /// The limit with which a round is done.
    #[inline(always)]
    pub(crate) fn limit(&self, number: usize) -> Lane<L> {
        self.limits[number].used
    }

    /// Begins a step with the limits of its start.
    pub(crate) fn begin(&mut self, at_start: impl Fn(usize) -> Lane<L>) {
        for (number, guess) in self.limits.iter_mut().enumerate() {
            guess.used = at_start(number);
        }
        (self.settled, self.rounds) = ([false; L], 0);
    }

    /// Takes the limits at the end of a round. `None` if another one must follow, or the lanes whose limits did not settle.
    pub(crate) fn follow(&mut self, at_end: impl Fn(usize) -> Lane<L>) -> Option<[bool; L]> {
        let mut worst = Lane::splat(0.0);
        for (number, guess) in self.limits.iter_mut().enumerate() {
            let next = at_end(number);
            guess.missed = next - guess.used;
            for l in 0..L {
                let [missed, size] = [guess.missed.0[l].abs(), next.larger(guess.used).0[l]];
                // Not a number: the lane has failed.
                if missed > STAYS * size && !self.settled[l] {
                    worst.0[l] = worst.0[l].max(missed / size);
                }
            }
        }
        self.rounds += 1;
        for l in 0..L {
            self.settled[l] |= worst.0[l] == 0.0;
        }
        if self.settled.iter().all(|settled| *settled) {
            return Some([false; L]);
        }
        if self.rounds == MOST {
            return Some(worst.0.map(|missed| missed > SETTLED));
        }
        for l in (0..L).filter(|l| !self.settled[*l]) {
            guess_again(&mut self.limits, l, self.rounds);
        }
        None
    }
}

/// The limits of a lane for the next round: the secant of the last two, in the least squares of all limits (Anderson's mixing with
/// one round of memory; exact for one limit that depends on itself by a line).
fn guess_again<const L: usize>(limits: &mut [Guess<L>], l: usize, rounds: usize) {
    let sum = |term: &dyn Fn([f64; 2]) -> f64| -> f64 {
        let missed = |guess: &Guess<L>| [guess.missed.0[l], guess.before[1].0[l]];
        limits.iter().map(|guess| term(missed(guess))).sum()
    };
    let nearer = sum(&|[now, before]| now * now - 0.25 * before * before) < 0.0;
    let squares = sum(&|[now, before]| (now - before).powi(2));
    let back = match sum(&|[now, before]| now * (now - before)) / squares {
        back if rounds > 1 && back.is_finite() => back,
        _ => 0.0,
    };
    for guess in limits {
        let [used, missed] = [guess.used.0[l], guess.missed.0[l]];
        let [used_before, missed_before] = guess.before.map(|lanes| lanes.0[l]);
        (guess.before[0].0[l], guess.before[1].0[l]) = (used, missed);
        guess.used.0[l] = match rounds > FREE && !nearer {
            true => used + 0.5 * missed,
            false => {
                (used + missed - back * (used - used_before + missed - missed_before)).max(0.0)
            }
        };
    }
}
