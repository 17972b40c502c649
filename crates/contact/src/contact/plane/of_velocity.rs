//! A law of velocity in a plane: the force of its scalar form along rdot.

use super::scalar::{along, running, scalar_slope};
use super::{AnyPlaneLaw, Over, PlaneLaw, PlaneStep, PlaneTrial, Root};
use crate::contact::pair::{self, Pair, length};
use crate::contact::{AnyRunningLaw, ContactLaw};

/// A law whose force is along rdot.
#[derive(Debug, Clone, Copy)]
pub struct OfVelocity {
    /// Its scalar form.
    pub law: ContactLaw,
    /// rdot/S and the limit of a law that is viscous up to its limit.
    pub viscous: Option<Pair>,
}

impl OfVelocity {
    /// A law without a viscous part of its own over a step.
    pub fn over<W: Into<ContactLaw> + Copy>(law: &W, on: &PlaneStep) -> AnyPlaneLaw {
        let law = (*law).into();
        AnyPlaneLaw::new(OfVelocity { law, viscous: None }, on)
    }
}

impl PlaneLaw for OfVelocity {
    type Step = AnyRunningLaw<1>;
    type Memory = ();

    fn step(&self, on: &PlaneStep) -> Self::Step {
        running(&self.law, on.h, on)
    }

    fn answer(&self, over: &Over<Self>, trial: &PlaneTrial) -> (Pair, ()) {
        (along(*over.step, &over.on, trial.rate, trial), ())
    }

    fn slopes(&self, over: &Over<Self>, root: &Root) -> (Pair, Pair) {
        let Root { moved, force, pace } = root;
        let size = length(*force);
        let speed = length(moved.rate);
        let inside = self.viscous.is_some_and(|[_, limit]| size < limit);
        let slope = match self.viscous {
            Some([compliance, _]) if inside => 1.0 / compliance,
            Some(_) => 0.0,
            None => scalar_slope(*over.step, &over.on.given(), moved, speed),
        };
        let across = if inside || speed == 0.0 {
            slope
        } else {
            size / speed
        };
        (pair::unit(*force), [pace * slope, pace * across])
    }

    fn has_state(&self) -> bool {
        false
    }

    fn bound(&self) -> f64 {
        f64::INFINITY
    }

    fn rate(&self, _: Pair, _: Pair) -> Pair {
        [0.0; 2]
    }

    fn corner(&self, speed: f64) -> f64 {
        match self.viscous {
            Some([compliance, limit]) => speed - compliance * limit,
            None => self.law.properties().corner(speed),
        }
    }
}
