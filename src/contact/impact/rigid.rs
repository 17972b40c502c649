//! Contact without compliance.

use super::{Free, loop_of, resisting};
use crate::contact::{
    Cycle, Flexibility, Law, StepFlexibility, StepLaw, StoredEnergy, Trial, lanes,
};
use crate::lane::Lane;

/// r >= 0, S <= 0, r S = 0.
///
/// A method with displacements has r >= 0 at the end of each step; it needs h > 0. In a method with velocities and impulses
/// (Moreau 1988, Jean 1999) a contact that would overlap at the end of the step without its force (r* < 0) leaves it with
/// rdot' >= -e rdot(i) if it closes, else with rdot' >= 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rigid {
    /// e in 0..=1; only methods with impulses use it.
    pub restitution: f64,
    /// Whether the method acts by impulses. The work of the contact is then the loss of the impact, else an error.
    pub impulses: bool,
}

/// The law over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    start: Flexibility<L>,
    end: Flexibility<L>,
    restitution: Lane<L>,
    by_impulse: bool,
}

impl StoredEnergy for Rigid {
    fn stored_energy(&self, _: f64, _: f64) -> f64 {
        0.0
    }

    fn deflection(&self, _: f64) -> Option<[f64; 2]> {
        Some([0.0; 2])
    }

    fn conservative_force(&self, _: f64, s: f64) -> f64 {
        if self.impulses { 0.0 } else { s }
    }
}

impl Law for Rigid {
    type Step<const L: usize> = Step<L>;

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        Step {
            start: on.start,
            end: on.end,
            restitution: lanes(laws, |law| law.restitution),
            by_impulse: on.by_impulse,
        }
    }

    /// The axes: any force at r = 0, drawn up to `reach`.
    fn cycle(&self, reach: f64) -> Cycle {
        loop_of([[0.0, reach]].into_iter(), reach)
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = ();

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, _: &mut ()) -> Lane<L> {
        let free = Free::new(trial, &self.start);
        let (missing, by) = if self.by_impulse {
            // rdot' = -ddelta* + h_rate F >= -e rdot(i).
            let before = trial.velocity.smaller(Lane::splat(0.0));
            (free.closing - self.restitution * before, self.end.h_rate)
        } else {
            (free.overlap, self.end.h)
        };
        let active = missing.zip(
            free.overlap,
            |missing, overlap| if overlap > 0.0 { missing } else { 0.0 },
        );
        resisting(active.zip(
            by,
            |missing, by| if missing > 0.0 { missing / by } else { 0.0 },
        ))
    }
}
