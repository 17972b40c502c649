//! Friction in a plane: r = (r1, r2), S = (S1, S2), with |S| within the limit in every direction.
//!
//! Most laws follow from their scalar form. A law of velocity has the force of the scalar law along rdot. An elastic law has it along
//! its trial force: the radial return, which allows for the turn of the force. A spring beside the friction, that of a pendulum or of hardening, acts in both directions alone.
//! Two laws have a form of their own: Bouc-Wen, whose force turns towards the motion as the isotropic model of Park, Wen and Ang (1986),
//! and LuGre, whose bristles relax towards the direction of the motion.
//!
//! Each answer is the force of the one root of a step, as that of a scalar law. It has no preferred direction.

mod bouc_wen;
mod continuous;
mod elastic;
mod lugre;
mod scalar;
#[cfg(test)]
mod tests;

pub use super::pair::{Pair, dot, length};

use super::coupled::curved::Directions;
use super::pair;
use super::{AnyRunningLaw, ContactLaw, InPlane, LAWS, Lugre};
use elastic::Elastic;
use scalar::{along, running, scalar_slope};

/// A law of friction in a plane, with what it needs of a step.
#[derive(Debug, Clone, Copy)]
pub struct PlaneLaw {
    form: Form,
    /// Stiffness of the spring beside the friction.
    spring: f64,
    on: PlaneStep,
}

#[derive(Debug, Clone, Copy)]
enum Form {
    /// The scalar law along rdot.
    OfVelocity {
        step: AnyRunningLaw<1>,
        /// rdot/S and the limit of a law that is viscous up to its limit.
        viscous: Option<Pair>,
    },
    /// The scalar law along the trial force.
    Elastic(Elastic),
    BoucWen(super::BoucWen),
    Lugre(Lugre),
}

/// What a unit of force takes from the motion of a step.
#[derive(Debug, Clone, Copy)]
pub struct PlaneStep {
    /// From r'.
    pub h: f64,
    /// From rdot'.
    pub h_rate: f64,
    /// Length of the step.
    pub dt: f64,
}

/// A contact at the start of a step, and its motion over the step without its force at the end.
#[derive(Debug, Clone, Copy, Default)]
pub struct PlaneTrial {
    /// r.
    pub displacement: Pair,
    /// rdot.
    pub velocity: Pair,
    /// S.
    pub force: Pair,
    /// r' - r.
    pub change: Pair,
    /// rdot'.
    pub rate: Pair,
}

/// What a law remembers from step to step.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PlaneMemory {
    /// Friction without the spring beside it, or the force of the bristles.
    pub(super) friction: Pair,
    /// Change of the bristles in the last step over its length.
    pub(super) rate: Pair,
    /// What an elastic law adds to its trial force in the next step, because its friction turns; and whether it slid.
    pub(super) turn: Pair,
    pub(super) slides: bool,
    /// |rdot| at the start of the last step of an elastic law.
    pub(super) speed: f64,
    /// Length of the last step.
    pub(super) dt: f64,
    /// Whether there was a step or an equilibrium.
    pub(super) begun: bool,
}

/// The names of the laws of structures that slide in a plane.
pub fn names() -> impl Iterator<Item = &'static str> {
    let offered = LAWS.iter().filter(|law| law.in_plane);
    let offered = offered.filter(|law| law.offer.structure.is_some());
    offered.map(|law| law.offer.name)
}

/// Whether a law slides in a plane.
pub fn slides_in_plane(law: &ContactLaw) -> bool {
    law.properties().in_plane().is_some()
}

/// A number that changes its sign where the force in a plane has a corner at this speed; 0 for a law without one.
pub fn corner(law: &ContactLaw, speed: f64) -> f64 {
    match law.properties().in_plane() {
        Some(InPlane::OfVelocity {
            viscous: Some([compliance, limit]),
        }) => speed - compliance * limit,
        _ => law.properties().corner(speed),
    }
}

impl PlaneLaw {
    /// The law in a step; `None` for a law that does not slide in a plane.
    pub fn new(law: &ContactLaw, on: PlaneStep) -> Option<PlaneLaw> {
        let (form, spring) = match law.properties().in_plane()? {
            InPlane::OfVelocity { viscous } => {
                let step = running(law, on.h, &on);
                (Form::OfVelocity { step, viscous }, 0.0)
            }
            InPlane::Elastic(own) => {
                let h = on.h / (1.0 + own.spring * on.h);
                let step = running(&own.law.into(), h, &on);
                (Form::Elastic(Elastic { own, step }), own.spring)
            }
            InPlane::BoucWen(own) => (Form::BoucWen(own), 0.0),
            InPlane::Lugre(own) => (Form::Lugre(own), 0.0),
        };
        Some(PlaneLaw { form, spring, on })
    }

    /// S', and what the law remembers then.
    pub fn answer(&self, trial: &PlaneTrial, memory: &PlaneMemory) -> (Pair, PlaneMemory) {
        self.answer_on(trial, memory, &self.on, 0)
    }

    /// S' of a motion that is given.
    fn follow(&self, trial: &PlaneTrial, memory: &PlaneMemory) -> Pair {
        let rigid = PlaneStep {
            h: 0.0,
            h_rate: 0.0,
            ..self.on
        };
        self.answer_on(trial, memory, &rigid, 1).0
    }

    fn answer_on(
        &self,
        trial: &PlaneTrial,
        memory: &PlaneMemory,
        on: &PlaneStep,
        part: usize,
    ) -> (Pair, PlaneMemory) {
        match &self.form {
            Form::OfVelocity { step, .. } => {
                let force = along(*step, part, trial.rate, trial);
                (force, *memory)
            }
            Form::Elastic(elastic) => elastic.answer(trial, memory, on, part),
            Form::BoucWen(law) => (bouc_wen::answer(law, on, trial), *memory),
            Form::Lugre(law) => lugre::answer(law, on, trial, memory),
        }
    }

    /// Friction of a contact at r that nothing has moved yet.
    fn unbent(&self, r: Pair) -> Pair {
        match &self.form {
            Form::Elastic(elastic) => elastic.unbent(r),
            Form::OfVelocity { .. } | Form::BoucWen(_) | Form::Lugre(_) => [0.0; 2],
        }
    }

    /// 1/f' of r', or of rdot' in an explicit method, where the answer is `force`; `pace` is the change of rdot' for a unit of r'.
    pub fn directions(
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
        let (along, stiffness) = match &self.form {
            Form::OfVelocity { step, viscous } => {
                let size = length(force);
                let speed = length(moved.rate);
                let inside = viscous.is_some_and(|[_, limit]| size < limit);
                let slope = match viscous {
                    Some([compliance, _]) if inside => 1.0 / compliance,
                    Some(_) => 0.0,
                    None => scalar_slope(*step, &moved, speed),
                };
                let across = if inside || speed == 0.0 {
                    slope
                } else {
                    size / speed
                };
                (pair::unit(force), [pace * slope, pace * across])
            }
            _ if is_explicit => ([1.0, 0.0], [0.0; 2]),
            Form::Elastic(elastic) => {
                let law = &elastic.own.law;
                let part = elastic.coefficient(&moved, memory);
                let start = elastic.start(trial, memory, &self.on);
                let trial = pair::map(start, moved.change, |s, c| s + c / law.compliance);
                let k = 1.0 / law.compliance;
                let size = length(trial);
                let own = match size <= law.limit {
                    true => [k, k],
                    false => [0.0, law.limit * k / size],
                };
                (pair::unit(trial), own.map(|k| part * k + self.spring))
            }
            Form::BoucWen(_) | Form::Lugre(_) => {
                let at = |change: Pair| {
                    let more = pair::map(change, moved.change, |to, from| pace * (to - from));
                    let moved = PlaneTrial {
                        change,
                        rate: pair::map(moved.rate, more, |v, more| v + more),
                        ..moved
                    };
                    self.follow(&moved, memory)
                };
                let slopes = pair::jacobian(at, moved.change, self.width());
                pair::principal(slopes)
            }
        };
        Directions {
            along,
            slopes: stiffness.map(|k| if k > 0.0 { 1.0 / k } else { f64::INFINITY }),
        }
    }

    /// A displacement that is small for the law.
    fn width(&self) -> f64 {
        1e-6 * match &self.form {
            Form::BoucWen(law) => law.compliance * law.limit,
            Form::Lugre(law) => law.static_limit / law.sigma0,
            Form::OfVelocity { .. } | Form::Elastic(_) => 1.0,
        }
    }

    /// S and the memory of a contact at r with rdot, at rest under `at_rest` before; unbent without it.
    pub fn at_start(&self, at_rest: Option<Pair>, r: Pair, rdot: Pair) -> (Pair, PlaneMemory) {
        let friction = self.state(at_rest, r);
        let memory = PlaneMemory {
            friction,
            begun: at_rest.is_some() || self.spring != 0.0,
            ..PlaneMemory::default()
        };
        (self.force(friction, r, rdot), memory)
    }
}
