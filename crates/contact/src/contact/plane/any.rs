//! A law in a plane over a step, any of the list in this file.

use super::{Directions, ElasticInPlane, OfVelocity, Over, PlaneLaw, PlaneStep, PlaneTrial, Root};
use crate::contact::laws::friction::*;
use crate::contact::pair::{self, Pair};

/// How a law of one direction acts in a plane, over a step; `None` for a law that does not slide in one.
pub type InPlane<W> = Option<fn(&W, &PlaneStep) -> AnyPlaneLaw>;

/// The laws in a plane.
macro_rules! plane_laws {
    ($($law:ident),+ $(,)?) => {
        /// A law in a plane over a step.
        #[derive(Debug, Clone, Copy)]
        pub enum AnyPlaneLaw {
            $(#[doc = concat!("Of [`", stringify!($law), "`].")] $law(RunningPlaneLaw<$law>)),+
        }

        /// What a law remembers from step to step.
        #[derive(Debug, Clone, Copy, Default, PartialEq)]
        pub enum PlaneMemory {
            /// Of a contact before its first step that nothing has moved.
            #[default]
            Nothing,
            $(#[doc = concat!("Of [`", stringify!($law), "`].")] $law(<$law as PlaneLaw>::Memory)),+
        }

        $(impl OnePlaneLaw for $law {
            fn running(law: RunningPlaneLaw<Self>) -> AnyPlaneLaw {
                AnyPlaneLaw::$law(law)
            }

            fn remembers(memory: Self::Memory) -> PlaneMemory {
                PlaneMemory::$law(memory)
            }

            fn remembered(memory: &PlaneMemory) -> Self::Memory {
                match memory {
                    PlaneMemory::$law(memory) => *memory,
                    _ => Self::Memory::default(),
                }
            }
        })+

        /// The answer of each law.
        macro_rules! of_each {
            ($any:expr, $own:ident => $answer:expr) => {
                match $any {
                    $(AnyPlaneLaw::$law($own) => $answer),+
                }
            };
        }
    };
}

plane_laws! { OfVelocity, ElasticInPlane, BoucWen, Lugre }

impl AnyPlaneLaw {
    /// A law over a step.
    pub fn new<W: OnePlaneLaw>(law: W, on: &PlaneStep) -> AnyPlaneLaw {
        let step = law.step(on);
        W::running(RunningPlaneLaw { law, step, on: *on })
    }

    /// S', and what the law remembers then.
    pub fn answer(&self, trial: &PlaneTrial, memory: &PlaneMemory) -> (Pair, PlaneMemory) {
        of_each!(self, law => law.answer(trial, memory))
    }

    /// 1/f' of r', or of rdot' in an explicit method, where the answer is `force`; `pace` is the change of rdot' for a unit of r'.
    pub fn directions(
        &self,
        trial: &PlaneTrial,
        memory: &PlaneMemory,
        force: Pair,
        pace: f64,
    ) -> Directions {
        of_each!(self, law => law.directions(trial, memory, force, pace))
    }

    /// S and the memory of a contact at r with rdot, at rest under `at_rest` before; unbent without it.
    pub fn at_start(&self, at_rest: Option<Pair>, r: Pair, rdot: Pair) -> (Pair, PlaneMemory) {
        of_each!(self, law => law.at_start(at_rest, r, rdot))
    }

    /// S of z, r and rdot; of a law without a state it follows from rdot.
    pub fn force(&self, z: Pair, r: Pair, rdot: Pair) -> Pair {
        of_each!(self, law => law.force(z, r, rdot))
    }

    /// See [`PlaneLaw::has_state`].
    pub fn has_state(&self) -> bool {
        of_each!(self, law => law.law.has_state())
    }

    /// See [`PlaneLaw::is_cut`].
    pub fn is_cut(&self) -> bool {
        of_each!(self, law => law.law.is_cut())
    }

    /// See [`PlaneLaw::bound`].
    pub fn bound(&self) -> f64 {
        of_each!(self, law => law.law.bound())
    }

    /// See [`PlaneLaw::rate`].
    pub fn rate(&self, z: Pair, rdot: Pair) -> Pair {
        of_each!(self, law => law.law.rate(z, rdot))
    }

    /// See [`PlaneLaw::state`].
    pub fn state(&self, at_rest: Option<Pair>, r: Pair) -> Pair {
        of_each!(self, law => law.law.state(at_rest, r))
    }

    /// See [`PlaneLaw::corner`].
    pub fn corner(&self, speed: f64) -> f64 {
        of_each!(self, law => law.law.corner(speed))
    }
}

/// One of the laws in a plane.
pub trait OnePlaneLaw: PlaneLaw {
    /// The law over a step, as any of the list.
    fn running(law: RunningPlaneLaw<Self>) -> AnyPlaneLaw;

    /// Its memory, as any of the list.
    fn remembers(memory: Self::Memory) -> PlaneMemory;

    /// Its own memory; that before the first step of another law's.
    fn remembered(memory: &PlaneMemory) -> Self::Memory;
}

/// A law over a step.
#[derive(Debug, Clone, Copy)]
pub struct RunningPlaneLaw<W: PlaneLaw> {
    law: W,
    step: W::Step,
    on: PlaneStep,
}

impl<W: OnePlaneLaw> RunningPlaneLaw<W> {
    fn over<'a>(&'a self, memory: &'a W::Memory) -> Over<'a, W> {
        Over {
            on: self.on,
            step: &self.step,
            memory,
        }
    }

    fn answer(&self, trial: &PlaneTrial, memory: &PlaneMemory) -> (Pair, PlaneMemory) {
        let memory = W::remembered(memory);
        let (force, after) = self.law.answer(&self.over(&memory), trial);
        (force, W::remembers(after))
    }

    fn directions(
        &self,
        trial: &PlaneTrial,
        memory: &PlaneMemory,
        force: Pair,
        pace: f64,
    ) -> Directions {
        let is_explicit = pace == f64::INFINITY;
        let moved = PlaneTrial {
            change: pair::map(trial.change, force, |c, s| c - self.on.h * s),
            rate: pair::map(trial.rate, force, |v, s| v - self.on.h_rate * s),
            ..*trial
        };
        let pace = if is_explicit { 1.0 } else { pace };
        let root = Root { moved, force, pace };
        let (along, stiffness) = match is_explicit && self.law.has_state() {
            true => ([1.0, 0.0], [0.0; 2]),
            false => self.law.slopes(&self.over(&W::remembered(memory)), &root),
        };
        Directions {
            along,
            slopes: stiffness.map(|k| if k > 0.0 { 1.0 / k } else { f64::INFINITY }),
        }
    }

    fn force(&self, z: Pair, r: Pair, rdot: Pair) -> Pair {
        if self.law.has_state() {
            return self.law.force(z, r, rdot);
        }
        let trial = PlaneTrial {
            velocity: rdot,
            rate: rdot,
            ..PlaneTrial::default()
        };
        let nothing = W::Memory::default();
        self.law.answer(&self.over(&nothing).given(), &trial).0
    }

    fn at_start(&self, at_rest: Option<Pair>, r: Pair, rdot: Pair) -> (Pair, PlaneMemory) {
        let z = self.law.state(at_rest, r);
        let memory = self.law.memory(z, at_rest.is_some());
        (self.force(z, r, rdot), W::remembers(memory))
    }
}
