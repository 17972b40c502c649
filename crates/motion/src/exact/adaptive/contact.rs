//! A contact in continuous time.

use super::law_of_contact::{LawOfContact, flexibility};
use super::watched::{LimitAt, Motion, Watched};
use crate::contact::{AnyRunningLaw, ContactLaw, ContactResponse, Evolution, Trial};
use crate::lane::Lane;

/// Relative size of values that are round-off.
pub const ROUND_OFF: f64 = 1e-15;

/// The same of a force, the sum of some terms.
const BOUND: f64 = 4.0 * ROUND_OFF;

/// Part of r and rdot over which the slope of a force is a difference.
const SLOPE: f64 = 1e-6;

/// Part of the largest r so far, below which the sign of r of a contact that leaves rest is an error of the integration: a thousand
/// times its tolerance.
const LEAVES: f64 = 1e-9;

/// A contact between two ends of steps of the integration.
///
/// Most laws answer a motion: S follows from r, rdot and their values and S at the last end of a step. As a reversal and a first
/// touch end a step, this is the force of the law in continuous time. Laws with a state have its rate
/// ([`crate::contact::Evolution`]).
#[derive(Debug, Clone)]
pub struct Contact {
    law: ContactLaw,
    /// F of the springs behind which the contact is, if S is a state by them.
    brace: Option<f64>,
    /// How much of S the velocity loses at once: 0 where the contact is between masses.
    h_rate: f64,
    running: AnyRunningLaw<1>,
    /// r, rdot and S at the last end of a step.
    last: [f64; 3],
    /// S in equilibrium with static loads before t = 0; `None` without them.
    at_rest: Option<f64>,
    /// The side of the bound at which the state is; 0 if the bound is 0.
    bound: Option<f64>,
    /// Largest sizes of r and rdot so far: sums of the sizes of their terms, whose round-off they have.
    largest: [f64; 2],
    /// The size of S at the last end of a step, whose round-off it has.
    force_size: f64,
    /// Whether the contact has been at rest at r = 0 so far. If it closes from there, its closing speed is 0, and not an error of the
    /// integration, by which the law would divide.
    rests: bool,
}

impl Contact {
    /// A contact at r with rdot, which was at rest under S before, if static loads act; `memory` is what its law remembers of them.
    pub fn new(
        law: ContactLaw,
        h_rate: f64,
        [r, rdot]: [f64; 2],
        (at_rest, memory): (Option<f64>, Option<AnyRunningLaw<1>>),
    ) -> Contact {
        let on = [flexibility(h_rate); 2];
        let mut running = memory.unwrap_or_else(|| ContactLaw::running(&[law], &on));
        running.change(&law, &on);
        Contact {
            law,
            brace: None,
            h_rate,
            running,
            last: [r, rdot, at_rest.unwrap_or(0.0)],
            at_rest,
            bound: None,
            largest: [0.0; 2],
            force_size: 0.0,
            rests: law.properties().divides_by_closing_speed() && [r, rdot] == [0.0; 2],
        }
    }

    /// The same behind springs with this compliance.
    pub fn behind(self, brace: Option<f64>) -> Contact {
        Contact { brace, ..self }
    }

    /// z at the start; `None` for a law without a state.
    pub fn state(&self) -> Option<f64> {
        let law = self.law(None);
        let evolution = law.evolution()?;
        Some(evolution.at_start(self.at_rest, self.last[0]))
    }

    /// The law with this limit; `None` leaves it.
    fn law(&self, limit: Option<LimitAt>) -> LawOfContact {
        LawOfContact {
            law: limit.map_or(self.law, |limit| self.law.at_limit(limit.value)),
            brace: self.brace,
        }
    }

    /// S at a state. `rdot` is without the part that S takes at once.
    pub fn force(&self, [r, rdot]: [f64; 2], z: Option<f64>, limit: Option<LimitAt>) -> f64 {
        let law = self.law(limit);
        match (law.evolution(), z) {
            (Some(evolution), Some(z)) => {
                evolution.force(self.within(z, evolution.bound()), r, rdot)
            }
            _ => self.answer(&mut self.running.clone(), law.law, [r, rdot], limit),
        }
    }

    fn answer(
        &self,
        running: &mut AnyRunningLaw<1>,
        law: ContactLaw,
        [r, rdot]: [f64; 2],
        limit: Option<LimitAt>,
    ) -> f64 {
        if limit.is_some() {
            running.change(&law, &[flexibility(self.h_rate); 2]);
        }
        let [last_r, last_rdot, last_s] = self.last.map(|x| Lane([x]));
        let trial = Trial {
            displacement: last_r,
            velocity: last_rdot,
            force: last_s,
            change: Lane([r]) - last_r,
            rate: Lane([rdot]),
        };
        running.force(0, &trial).0[0]
    }

    /// dz/dt.
    pub fn rate(&self, z: f64, rdot: f64, limit: Option<LimitAt>) -> f64 {
        match self.law(limit).evolution() {
            Some(evolution) if self.bound.is_none() => {
                evolution.rate(self.within(z, evolution.bound()), rdot)
            }
            _ => 0.0,
        }
    }

    /// z at its bound, or not beyond it.
    fn within(&self, z: f64, bound: f64) -> f64 {
        match self.bound {
            Some(side) => side * bound,
            None => z.clamp(-bound, bound),
        }
    }

    /// How much faster than its bound z would leave it; not below 0 while it stays there.
    fn pressure(&self, side: f64, rdot: f64, limit: Option<LimitAt>) -> f64 {
        let rate = limit.map_or(0.0, |limit| limit.rate);
        let law = self.law(limit);
        law.evolution().map_or(0.0, |evolution| {
            side * evolution.rate(side * evolution.bound(), rdot) - rate
        })
    }

    /// What is watched at a state.
    pub fn watch(
        &self,
        [r, rdot]: [f64; 2],
        z: Option<f64>,
        limit: Option<LimitAt>,
        to: &mut Vec<Watched>,
    ) {
        let [r_scale, rdot_scale] = self.largest.map(|x| ROUND_OFF * x);
        let two_sided = |value: f64, least: f64| Watched {
            value,
            least,
            one_sided: false,
        };
        if self.rests {
            let [largest, _] = self.largest;
            to.push(Watched {
                value: if largest > 0.0 {
                    LEAVES * largest - r.abs()
                } else {
                    1.0
                },
                least: 0.0,
                one_sided: true,
            });
            to.push(two_sided(1.0, 0.0));
        } else {
            to.push(two_sided(r, r_scale));
            to.push(two_sided(rdot, rdot_scale));
        }
        let law = self.law(limit);
        match (law.evolution(), z) {
            (Some(evolution), Some(z)) => {
                let bound = evolution.bound();
                to.push(match self.bound {
                    Some(0.0) => Watched {
                        value: -bound,
                        least: 0.0,
                        one_sided: true,
                    },
                    None => Watched {
                        value: bound - z.abs(),
                        least: 0.0,
                        one_sided: true,
                    },
                    Some(side) => Watched {
                        value: self.pressure(side, rdot, limit),
                        least: ROUND_OFF * self.pressure(side, side * self.largest[1], limit).abs(),
                        one_sided: true,
                    },
                });
                let size = match bound.is_finite() {
                    true => bound,
                    false => self.least_state(0.0),
                };
                to.push(two_sided(z, ROUND_OFF * size));
            }
            _ => {
                let properties = law.law.properties();
                let [low, high] = properties.bounds();
                let s = self.force([r, rdot], z, limit);
                let inside = (s - low).min(high - s);
                // A force that stays at a bound comes off it by round-off.
                let side = match inside {
                    _ if inside <= 0.0 => 1.0,
                    _ if inside <= BOUND * self.force_size => 0.0,
                    _ => -1.0,
                };
                to.push(two_sided(side, 0.5));
                to.push(two_sided(properties.corner(rdot), 0.0));
            }
        }
    }

    /// S, and how much it would be for a motion as large as the terms of r and rdot: S has the round-off of this size.
    pub fn force_terms(&self, motion: Motion, z: Option<f64>, limit: Option<LimitAt>) -> f64 {
        let Motion { values, sizes } = motion;
        let force = self.force(values, z, limit);
        let change = |which: usize, sign: f64| {
            let mut moved = values;
            moved[which] += sign * SLOPE * sizes[which];
            (self.force(moved, z, limit) - force).abs() / SLOPE
        };
        let changes = [0, 1].map(|which| change(which, 1.0).max(change(which, -1.0)));
        force.abs() + changes[0] + changes[1]
    }

    /// The size of z below which it is round-off of r over the tolerance: the force of an elastic contact for an r as large as its terms,
    /// or as an r that does not matter, up to the bound.
    pub fn least_state(&self, least: f64) -> f64 {
        let size = |evolution: &dyn Evolution| {
            let elastic = evolution.rate(0.0, 1.0).abs() * self.largest[0].max(least);
            elastic.min(evolution.bound())
        };
        self.law(None).evolution().map_or(0.0, size)
    }

    /// Takes a state as the last one; returns z there.
    pub fn commit(
        &mut self,
        motion: Motion,
        z: Option<f64>,
        limit: Option<LimitAt>,
    ) -> Option<f64> {
        let Motion {
            values: [r, rdot],
            sizes,
        } = motion;
        self.largest = [0, 1].map(|i| self.largest[i].max(sizes[i]));
        let law = self.law(limit);
        if let (Some(evolution), Some(z)) = (law.evolution(), z) {
            let bound = evolution.bound();
            let z = self.within(z, bound);
            self.bound = match self.bound {
                _ if bound <= 0.0 => Some(0.0),
                Some(0.0) => None,
                Some(side) => {
                    let slack =
                        ROUND_OFF * self.pressure(side, side * self.largest[1], limit).abs();
                    Some(side).filter(|_| self.pressure(side, rdot, limit) >= -slack)
                }
                None if z.abs() >= bound => {
                    let side = 1.0_f64.copysign(z);
                    Some(side).filter(|_| self.pressure(side, rdot, limit) >= 0.0)
                }
                None => None,
            };
            return Some(z);
        }
        // The law answers from rest until the contact has left it.
        self.rests &= r.abs() <= LEAVES * self.largest[0];
        if self.rests {
            self.force_size = self.force_terms(motion, z, limit);
            return None;
        }
        let mut running = self.running;
        let s = self.answer(&mut running, law.law, [r, rdot], limit);
        self.running = running;
        self.last = [r, rdot, s];
        // From here: behind a long step that yields, a small way back would not leave the bound.
        self.force_size = self.force_terms(motion, z, limit);
        None
    }
}
