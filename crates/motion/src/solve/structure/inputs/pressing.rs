//! Limits by the forces of other parts at the end of a step: it is done again from its start until they stay.

use super::loads::Inputs;
use crate::lane::Lane;

/// Largest change of a limit, as a part of it, that ends the rounds: round-off of the forces.
const STAYS: f64 = 1e-13;

/// Rounds after which a guess is the mean of the last two: limits that alternate do not settle by themselves.
const FREE: usize = 8;

/// Most rounds. Limits that move by half of their distance are near their end then.
const MOST: usize = 60;

/// What presses in a round, as at the end of the step.
#[derive(Debug)]
pub(crate) struct Pressing<const L: usize> {
    /// S of the contacts.
    pub(crate) force: Vec<Lane<L>>,
    /// u and u' of the nodes.
    pub(crate) motion: Vec<[Lane<L>; 2]>,
    /// Lanes whose limits stay. Their guess stays, too, so that their bits do not depend on other lanes.
    settled: [bool; L],
    rounds: usize,
}

impl<const L: usize> Pressing<L> {
    /// The first guess: as at the start of the step.
    pub(crate) fn new(force: Vec<Lane<L>>, motion: Vec<[Lane<L>; 2]>) -> Self {
        Pressing {
            force,
            motion,
            settled: [false; L],
            rounds: 0,
        }
    }

    /// Takes what presses at the end of the round; whether the step is done.
    pub(crate) fn follow(
        &mut self,
        (inputs, step): (&Inputs<L>, usize),
        force: &[Lane<L>],
        motion: &[[Lane<L>; 2]],
    ) -> bool {
        let limits = |force: &[Lane<L>], motion: &[[Lane<L>; 2]]| -> Vec<Lane<L>> {
            let all = inputs.limits(step, |c| force[c], |node| motion[node]);
            all.map(|(_, limit, _)| limit).collect()
        };
        let [used, next] = [limits(&self.force, &self.motion), limits(force, motion)];
        self.rounds += 1;
        let share = if self.rounds > FREE { 0.5 } else { 1.0 };
        for l in 0..L {
            if self.settled[l] {
                continue;
            }
            let stays = |(used, next): (&Lane<L>, &Lane<L>)| {
                let [used, next] = [used.0[l], next.0[l]];
                // Not a number: the lane has failed.
                next.is_nan() || (next - used).abs() <= STAYS * next.max(used)
            };
            if used.iter().zip(&next).all(stays) {
                self.settled[l] = true;
                continue;
            }
            let take = |own: &mut Lane<L>, new: &Lane<L>| own.0[l] += share * (new.0[l] - own.0[l]);
            for (own, new) in self.force.iter_mut().zip(force) {
                take(own, new);
            }
            for (own, new) in self.motion.iter_mut().zip(motion) {
                own.iter_mut()
                    .zip(new)
                    .for_each(|(own, new)| take(own, new));
            }
        }
        self.settled.iter().all(|settled| *settled) || self.rounds == MOST
    }
}
