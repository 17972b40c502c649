//! Laws from outside of this program.

use crate::contact::impact::PUSHES;
use crate::contact::prelude::*;
use std::fmt::Debug;

/// Numbers that an [`OwnLaw`] may remember from step to step.
pub const STATES: usize = 8;

/// What an [`OwnLaw`] remembers; 0 at t = 0.
pub type OwnState = [f64; STATES];

/// A law that a user's program defines.
///
/// S must not fall with r and rdot, so that a step has one root. An impact has S <= 0, and none while r > 0; friction has |S| within its
/// limit. The law is one of time steps: its exact motion is not known.
pub trait OwnLaw: Debug + Sync {
    /// The answer at the end of a step, with the state at its start.
    ///
    /// It is called several times in a step; the state of the last call counts.
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

/// The states of L contacts.
#[derive(Debug, Clone, Copy)]
pub struct States<const L: usize>([OwnState; L]);

impl<const L: usize> Default for States<L> {
    fn default() -> States<L> {
        States([OwnState::default(); L])
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
    const CLOSED_FORM: ClosedForm<Self> = ClosedForm::Driven(|_, _, _| None);

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
                [&self.on.start, &self.on.end].map(|own| [own.h.0[l], own.h_rate.0[l]]);
            let from = [trial.displacement.0[l], trial.velocity.0[l]];
            let free = [
                from[0] + trial.change.0[l] - start[0] * trial.force.0[l],
                trial.rate.0[l] - start[1] * trial.force.0[l],
            ];
            let state = memory.0[l];
            let answer = |s: f64| {
                let to = [0, 1].map(|i| free[i] - end[i] * s);
                let Own { law, limit } = self.laws[l];
                let dt = self.on.dt.0[l];
                law.answer(
                    &OwnStep {
                        from,
                        to,
                        dt,
                        limit,
                    },
                    &state,
                )
            };
            // S = F(r* - h S, rdot* - h_rate S): between 0 and the answer to the free motion, as F does not fall.
            let most = answer(0.0).force;
            let s = roots::rising_once(most.min(0.0), most.max(0.0), most, |s| {
                let own = answer(s);
                let slope = end[0] * own.slopes[0] + end[1] * own.slopes[1];
                [s - own.force, 1.0 + slope]
            });
            memory.0[l] = answer(s).state;
            force.0[l] = s;
        }
        force
    }
}
