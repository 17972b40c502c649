//! Laws from outside of this program.

use crate::contact::impact::PUSHES;
use crate::contact::prelude::*;
use std::fmt::{self, Debug};

/// Numbers that an [`OwnLaw`] may remember from step to step.
pub const STATES: usize = 8;

/// What an [`OwnLaw`] remembers; 0 at t = 0.
pub type OwnState = [f64; STATES];

/// A law that a user's program defines.
///
/// S should not fall with r and rdot, so that a step has one root; where it falls, a step has an answer of the law or is
/// [`Unsolved::Own`](crate::contact::Unsolved). An impact has S <= 0, and none while r > 0; friction has |S| within its limit. The law is
/// one of time steps: its exact motion is not known.
pub trait OwnLaw: Debug + Sync {
    /// The answer at the end of a step, with the state at its start.
    ///
    /// It is called several times in a step, also with motions that do not come about, and must have one answer for one step and state.
    fn answer(&self, step: &OwnStep, state: &OwnState) -> OwnAnswer;

    /// What its contact can do.
    fn kind(&self) -> ContactKind {
        ContactKind::Link
    }

    /// The largest dS/dr, for warnings; 0 for a law that is not elastic.
    fn largest_stiffness(&self) -> f64;

    /// Energy that the contact stores at r under S; all other work counts as dissipated.
    fn stored_energy(&self, _r: f64, _s: f64) -> f64 {
        0.0
    }
}

/// A step of a contact with an [`OwnLaw`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OwnStep {
    /// r and rdot at its start.
    pub from: [f64; 2],
    /// r and rdot at its end.
    pub to: [f64; 2],
    /// Its length.
    pub dt: f64,
    /// The friction limit at its end; 0 of an impact and a link.
    pub limit: f64,
}

/// The answer of an [`OwnLaw`] at the end of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OwnAnswer {
    /// S.
    pub force: f64,
    /// dS/dr and dS/drdot at the end of the step, >= 0: they make the search for the root fast, and do not change it.
    pub slopes: [f64; 2],
    /// The state at the end.
    pub state: OwnState,
}

/// Why the answer of an [`OwnLaw`] is not taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum OwnFault {
    /// S or a number of the state is NaN or infinite.
    NotFinite,
    /// S is not the law's answer to the end of the step: S falls there, or jumps.
    NoAnswer,
    /// Two calls with the same step and state differ.
    NotPure,
    /// An impact pulls, or presses while it is open.
    Pulls,
    /// |S| of friction is above its limit.
    BeyondLimit,
}

impl fmt::Display for OwnFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            OwnFault::NotFinite => "answers with NaN or infinity",
            OwnFault::NoAnswer => "has no answer at the end of the step: its force falls or jumps there; take a smaller dt",
            OwnFault::NotPure => "answers twice with different numbers to the same step and state",
            OwnFault::Pulls => "is an impact with S > 0, or with a force while r > 0",
            OwnFault::BeyondLimit => "is friction with abs(S) above its limit",
        })
    }
}

/// Largest difference between S and the law's answer, over their size: round-off of the root, and of a law with a high stiffness.
const ROUND_OFF: f64 = 1e-9;

/// Most times that a bracket doubles: a law that falls has its root beyond the answer to the free motion.
const DOUBLED: usize = 64;

/// A contact with an [`OwnLaw`].
#[derive(Debug, Clone, Copy)]
pub struct Own {
    law: &'static dyn OwnLaw,
    limit: f64,
}

impl Own {
    /// A contact with this law.
    pub fn new(law: &'static dyn OwnLaw) -> Own {
        Own { law, limit: 0.0 }
    }
}

impl PartialEq for Own {
    fn eq(&self, other: &Own) -> bool {
        std::ptr::addr_eq(self.law, other.law) && self.limit == other.limit
    }
}

/// The law over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    laws: [Own; L],
    on: StepFlexibility<L>,
}

/// The states of L contacts, and why a law's last answer is not taken.
#[derive(Debug, Clone, Copy)]
pub struct States<const L: usize>([(OwnState, Option<OwnFault>); L]);

impl<const L: usize> Default for States<L> {
    fn default() -> States<L> {
        States([(OwnState::default(), None); L])
    }
}

impl States<1> {
    /// Why the last answer is not taken.
    pub fn fault(&self) -> Option<OwnFault> {
        self.0[0].1
    }
}

impl StoredEnergy for Own {
    fn stored_energy(&self, r: f64, s: f64) -> f64 {
        self.law.stored_energy(r, s)
    }
}

impl Described for Own {
    const KIND: ContactKind = ContactKind::Link;
    const NAME: &'static str = "own";
    const OFFERS: &'static [Offer] = &[];
    const CLOSED_FORM: ClosedForm<Self> = ClosedForm::None("the law is that of a user's program");

    fn kind(&self) -> ContactKind {
        self.law.kind()
    }
}

impl Properties for Own {
    fn largest_stiffness(&self, _: f64) -> f64 {
        self.law.largest_stiffness()
    }

    fn bounds(&self) -> [f64; 2] {
        match self.kind() {
            ContactKind::Impact => PUSHES,
            ContactKind::Friction => [-self.limit, self.limit],
            ContactKind::Link => [f64::NEG_INFINITY, f64::INFINITY],
        }
    }

    fn only_in_steps(&self) -> Option<&'static str> {
        Some("has a law of a user's program, which is known at the ends of steps only")
    }
}

impl Law for Own {
    type Step<const L: usize> = Step<L>;

    fn at_limit(self, limit: f64) -> Self {
        match self.kind() {
            ContactKind::Friction => Own { limit, ..self },
            ContactKind::Impact | ContactKind::Link => self,
        }
    }

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        Step {
            laws: *laws,
            on: *on,
        }
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = States<L>;

    fn force(&self, trial: &Trial<L>, memory: &mut States<L>) -> Lane<L> {
        let mut force = trial.force;
        for l in 0..L {
            let [start, end] =
                [&self.on.start, &self.on.end].map(|point| [point.h.0[l], point.h_rate.0[l]]);
            let from = [trial.displacement.0[l], trial.velocity.0[l]];
            let free = [
                from[0] + trial.change.0[l] - start[0] * trial.force.0[l],
                trial.rate.0[l] - start[1] * trial.force.0[l],
            ];
            let (state, _) = memory.0[l];
            let given_law = self.laws[l];
            let step = |s: f64| OwnStep {
                from,
                to: [0, 1].map(|i| free[i] - end[i] * s),
                dt: self.on.dt.0[l],
                limit: given_law.limit,
            };
            // Of S = (r* - r)/h, where r is small beside its terms.
            let terms =
                from[0].abs() + trial.change.0[l].abs() + (start[0] * trial.force.0[l]).abs();
            let round_off = match end[0] > 0.0 {
                true => 4.0 * f64::EPSILON * terms / end[0],
                false => 0.0,
            };
            let answer = |s: f64| given_law.law.answer(&step(s), &state);
            let (s, is_root) = given_law.root(end, round_off, answer);
            let last = answer(s);
            let fault_of_law = given_law.fault(step(s).to[0], &last, &answer(s));
            let fault = fault_of_law.or((!is_root).then_some(OwnFault::NoAnswer));
            memory.0[l] = (last.state, fault);
            force.0[l] = s;
        }
        force
    }
}

impl Own {
    /// S = F(r* - h S, rdot* - h_rate S), and whether it is: the last S that was tried otherwise.
    fn root(
        &self,
        end: [f64; 2],
        round_off: f64,
        answer: impl Fn(f64) -> OwnAnswer,
    ) -> (f64, bool) {
        let value = |s: f64| s - answer(s).force;
        // Between 0 and the answer to the free motion, where F does not fall; else further on.
        let most = answer(0.0).force;
        let [mut low, mut high] = [most.min(0.0), most.max(0.0)];
        for _ in 0..DOUBLED {
            match most > 0.0 {
                true if value(high) < 0.0 => [low, high] = [high, 2.0 * high],
                false if value(low) > 0.0 => [low, high] = [2.0 * low, low],
                _ => break,
            }
        }
        let root = |with_slopes: bool| {
            roots::rising_once(low, high, most, |s| {
                let answered = answer(s);
                let slope = end[0] * answered.slopes[0] + end[1] * answered.slopes[1];
                [
                    s - answered.force,
                    if with_slopes { 1.0 + slope } else { f64::NAN },
                ]
            })
        };
        let checked = |s: f64| (s, is_root(s, round_off, &answer));
        // Slopes that are far too steep end the search before the root.
        match checked(root(true)) {
            (s, true) => (s, true),
            (_, false) => checked(root(false)),
        }
    }

    /// Why the law's answer to a step that ends at r is not taken; `again` is a second one.
    fn fault(&self, r: f64, answer: &OwnAnswer, again: &OwnAnswer) -> Option<OwnFault> {
        let bits =
            |answer_of: &OwnAnswer| (answer_of.force.to_bits(), answer_of.state.map(f64::to_bits));
        let is_finite = answer.force.is_finite() && answer.state.iter().all(|x| x.is_finite());
        let pulls = answer.force > 0.0 || (r > 0.0 && answer.force < 0.0);
        match self.kind() {
            _ if !is_finite => Some(OwnFault::NotFinite),
            _ if bits(answer) != bits(again) => Some(OwnFault::NotPure),
            ContactKind::Impact if pulls => Some(OwnFault::Pulls),
            ContactKind::Friction if answer.force.abs() > self.limit * (1.0 + ROUND_OFF) => {
                Some(OwnFault::BeyondLimit)
            }
            ContactKind::Impact | ContactKind::Friction | ContactKind::Link => None,
        }
    }
}

/// Whether S is the law's answer to it, or the answer rises through it within round-off: of a law with a high stiffness, or a step.
fn is_root(s: f64, round_off: f64, answer: impl Fn(f64) -> OwnAnswer) -> bool {
    let value = |s: f64| s - answer(s).force;
    let difference = value(s);
    let near = round_off + ROUND_OFF * s.abs().max((s - difference).abs());
    difference.abs() <= near || (value(s - near) <= 0.0 && value(s + near) >= 0.0)
}
