//! What a law in a plane says of itself.

use super::{PlaneStep, PlaneTrial};
use crate::contact::pair::{self, Pair};
use std::fmt::Debug;

/// A law of friction in a plane with its numbers, beside the [`Law`](crate::contact::Law) of one direction: one file, and its name in
/// the list of `any.rs`. The law of one direction refers to it by [`IN_PLANE`](crate::contact::Described::IN_PLANE).
pub trait PlaneLaw: Copy + Debug {
    /// What is known of a step before its motion, such as the scalar law over it; `()` for a law that needs nothing.
    type Step: Copy + Debug;
    /// What the law remembers from step to step besides S; `()` for a law without memory.
    type Memory: Copy + Debug + Default + PartialEq;

    /// What is known of a step.
    fn step(&self, on: &PlaneStep) -> Self::Step;

    /// S' of the root of a step, and what the law remembers then.
    fn answer(&self, over: &Over<Self>, trial: &PlaneTrial) -> (Pair, Self::Memory);

    /// The direction of the smaller slope, and dS/dr' along and across it.
    fn slopes(&self, over: &Over<Self>, root: &Root) -> (Pair, Pair);

    /// Whether the law has a state z: friction without the spring beside it, or the force of bristles. Without one, S follows from rdot.
    fn has_state(&self) -> bool {
        true
    }

    /// Whether z follows the motion up to its limit, without a bend.
    fn is_cut(&self) -> bool {
        false
    }

    /// The largest |z|.
    fn bound(&self) -> f64;

    /// dz/dt below the bound.
    fn rate(&self, z: Pair, rdot: Pair) -> Pair;

    /// S of z, r and rdot, for a law with a state.
    fn force(&self, z: Pair, _r: Pair, _rdot: Pair) -> Pair {
        pair::cut(z, self.bound())
    }

    /// z of a contact at r, at rest under `at_rest` before; of one that nothing has bent without it.
    fn state(&self, at_rest: Option<Pair>, _r: Pair) -> Pair {
        at_rest.unwrap_or_default()
    }

    /// What a law with this z remembers before its first step, after an equilibrium or not.
    fn memory(&self, _z: Pair, _at_rest: bool) -> Self::Memory {
        Self::Memory::default()
    }

    /// A number that changes its sign where S of a law without a state has a corner at this speed; 0 for a law without one.
    fn corner(&self, _speed: f64) -> f64 {
        0.0
    }
}

/// A step of a law.
#[derive(Debug)]
pub struct Over<'a, W: PlaneLaw> {
    /// What a force takes from its motion.
    pub on: PlaneStep,
    /// What the law knows of it.
    pub step: &'a W::Step,
    /// What the law remembers of those before.
    pub memory: &'a W::Memory,
}

/// The root of a step.
#[derive(Debug, Clone, Copy)]
pub struct Root {
    /// The contact at the start of the step, and its motion over it.
    pub moved: PlaneTrial,
    /// S'.
    pub force: Pair,
    /// Change of rdot' for a unit of r'.
    pub pace: f64,
}

impl<W: PlaneLaw> Over<'_, W> {
    /// The same step with a motion that is given.
    pub(in crate::contact) fn given(&self) -> Over<'_, W> {
        Over {
            on: self.on.given(),
            ..*self
        }
    }

    /// The slopes of a law from differences of its answer over `width`.
    pub(in crate::contact) fn slopes_by_differences(
        &self,
        law: &W,
        root: &Root,
        width: f64,
    ) -> (Pair, Pair) {
        let (given, moved) = (self.given(), &root.moved);
        let at = |change: Pair| {
            let more = pair::map(change, moved.change, |to, from| root.pace * (to - from));
            let rate = pair::map(moved.rate, more, |v, more| v + more);
            let moved = PlaneTrial {
                change,
                rate,
                ..*moved
            };
            law.answer(&given, &moved).0
        };
        pair::principal(pair::jacobian(at, moved.change, width))
    }
}
