//! Search for the right pattern.

use super::Unsolved;
use super::active_set::ActiveSet;
use super::step::Step;

/// Rounds that change all wrong contacts although these have not become fewer.
const TRIES: usize = 3;

impl ActiveSet {
    /// Changes the pattern until it is right, and gives its forces. Returns the number of patterns.
    pub(super) fn pivot(&mut self, step: Step, force: &mut [f64]) -> Result<usize, Unsolved> {
        // The same code with a known number of contacts is up to twice as fast.
        match force.len() {
            2 => self.pivot_sized(2, step, force),
            3 => self.pivot_sized(3, step, force),
            4 => self.pivot_sized(4, step, force),
            5 => self.pivot_sized(5, step, force),
            6 => self.pivot_sized(6, step, force),
            contacts => self.pivot_sized(contacts, step, force),
        }
    }

    #[inline(always)]
    fn pivot_sized(
        &mut self,
        contacts: usize,
        step: Step,
        force: &mut [f64],
    ) -> Result<usize, Unsolved> {
        let (step, force) = (step.of(contacts), &mut force[..contacts]);
        self.adapt(contacts, step);
        let [mut least, mut left] = [contacts + 1, TRIES];
        for round in 1..=most_rounds(contacts) {
            if !self.factor() {
                return Err(Unsolved::Singular);
            }
            if !self.follow(contacts, step, force) {
                return Err(Unsolved::TooManyRounds);
            }
            let mut wrong = 0;
            let mut last = None;
            for i in 0..contacts {
                if let Some(at) = self.better_place(i, step, force) {
                    wrong += 1;
                    last = Some((i, at));
                }
            }
            let Some((i, at)) = last else {
                return match self.is_unique(step, force) {
                    true => Ok(round),
                    false => Err(Unsolved::Singular),
                };
            };
            if wrong < least {
                [least, left] = [wrong, TRIES];
            } else if left > 0 {
                left -= 1;
            } else {
                self.put(i, at);
                continue;
            }
            self.change_all(step, force);
        }
        Err(Unsolved::TooManyRounds)
    }

    /// Changes the places of all wrong contacts.
    fn change_all(&mut self, step: Step, force: &[f64]) {
        for i in 0..force.len() {
            if let Some(at) = self.better_place(i, step, force) {
                self.put(i, at);
            }
        }
    }
}

/// Far more than a step has ever needed; the rule of Murty has no small bound.
fn most_rounds(contacts: usize) -> usize {
    1000 + 100 * contacts
}
