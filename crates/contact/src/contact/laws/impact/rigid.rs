//! Contact without compliance.

use super::rigid_impact::Duration;
use super::{Free, PUSHES, RigidImpact, loop_of, resisting};
use crate::contact::prelude::*;

/// r >= 0, S <= 0, r S = 0.
///
/// A method with displacements has r >= 0 at the end of each step; it needs h > 0. In a method with velocities and impulses
/// (Moreau 1988, Jean 1999) the contact is active in a step if the gap predicted for its middle, r(i) + dt/2 rdot(i), is not
/// positive. Then S' <= 0, rdot' + e rdot(i) >= 0, and one of both is 0: Newton's rule with the signed velocity before the step. No
/// position is corrected, so an overlap of up to dt times the closing speed remains while the contact is shut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rigid {
    /// e in 0..=1; only methods with impulses use it.
    pub restitution: f64,
    /// Whether the method acts by impulses. The work of the contact is then the loss of the impact, else an error.
    pub impulses: bool,
}

/// A rigid impact; whether its method acts by impulses is what the problem knows besides.
fn rigid(given: &GivenNumbers, restitution: f64) -> Form {
    let impulses = given.given("impulses").is_some_and(|x| x != 0.0);
    Form::of(Rigid {
        restitution,
        impulses,
    })
}

/// A rigid impact of a structure.
pub(in crate::contact) fn stop(given: &GivenNumbers, e: f64) -> Result<Form, LawFault> {
    match e <= 1.0 {
        true => Ok(rigid(given, e)),
        false => Err(LawFault::Restitution(e)),
    }
}

/// The law over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    start: Flexibility<L>,
    end: Flexibility<L>,
    restitution: Lane<L>,
    /// dt/2
    half: Lane<L>,
    by_impulse: bool,
}

impl StoredEnergy for Rigid {
    fn deflection(&self, _: f64) -> Option<Deflection> {
        Some(Deflection { r: 0.0, slope: 0.0 })
    }

    fn conservative_force(&self, _: f64, s: f64) -> f64 {
        if self.impulses { 0.0 } else { s }
    }
}

impl Described for Rigid {
    const KIND: ContactKind = ContactKind::Impact;
    const NAME: &'static str = "rigid";
    const OFFERS: &'static [Offer] = &[Offer::new(Self::NAME, |given| match given.given("restitution") {
        Some(restitution) => Ok(rigid(given, restitution)),
        None => stop(given, given.need("e")?),
    })
        .between_bars(
            "without compliance: r >= 0 at the end of a step; with moreau-jean instead restitution of the ends, and an overlap may remain (Moreau 1988, Jean 1999)",
            &[&bars::RESTITUTION],
        )
        .in_structures(
            "impact without compliance, with restitution e (Moreau 1988, Jean 1999)",
            &[&structure::E],
        )];
    const CLOSED_FORM: ClosedForm<Self> = ClosedForm::Collision(|law, _, _| RigidImpact {
        restitution: law.restitution,
        duration: Duration::Known(0.0),
        overlap: 0.0,
    });
}

impl Properties for Rigid {
    fn shown(&self) -> Vec<(&'static str, f64)> {
        vec![("e =", self.restitution)]
    }

    fn largest_stiffness(&self, _: f64) -> f64 {
        f64::INFINITY
    }

    fn bounds(&self) -> [f64; 2] {
        PUSHES
    }

    fn has_rigid_form(&self) -> bool {
        true
    }

    fn is_vertical(&self) -> bool {
        true
    }

    fn line(&self) -> Option<ClippedLine> {
        let restitution = self.restitution;
        Some(ClippedLine::Stop { restitution })
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
            half: on.dt * 0.5,
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
    fn correction(&self, displacement: Lane<L>) -> Lane<L> {
        displacement.map(|r| if r < 0.0 { -r } else { 0.0 })
    }

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, _: &mut ()) -> Lane<L> {
        let free = Free::new(trial, &self.start);
        let (active, by) = if self.by_impulse {
            // rdot' = -ddelta* + h_rate F >= -e rdot(i).
            let missing = free.closing - self.restitution * trial.velocity;
            let predicted = trial.displacement + self.half * trial.velocity;
            let active = |missing, predicted| if predicted <= 0.0 { missing } else { 0.0 };
            (missing.zip(predicted, active), self.end.h_rate)
        } else {
            (free.overlap, self.end.h)
        };
        resisting(active.zip(
            by,
            |missing, by| if missing > 0.0 { missing / by } else { 0.0 },
        ))
    }
}
