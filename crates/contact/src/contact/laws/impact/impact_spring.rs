//! The impact spring.

use super::{RigidImpact, stop};
use crate::contact::element::{Element, ImpactElement};
use crate::contact::prelude::*;

/// Impact spring `[I (7), (8)]`, `S = k_I <r> r`: it pushes while r < 0 and never pulls (the paper does not print the last r).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImpactSpring {
    /// k_I.
    pub stiffness: f64,
}

/// The spring over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    /// Flexibility for S(i).
    h: Lane<L>,
    /// 1/(1/k_I + h) with the flexibility for S(i+1).
    stiffness: Lane<L>,
}

/// The numbers of which `impact` has one, in messages.
const SPRING: &str = "k of the impact spring";
const STOP: &str = "e of a rigid impact";

impl StoredEnergy for ImpactSpring {
    fn stored_energy(&self, r: f64, s: f64) -> f64 {
        s * r * 0.5
    }

    #[inline(always)]
    fn deflection(&self, s: f64) -> Option<Deflection> {
        Some(Deflection {
            r: s / self.stiffness,
            slope: 1.0 / self.stiffness,
        })
    }
}

impl Described for ImpactSpring {
    const KIND: ContactKind = ContactKind::Impact;
    const NAME: &'static str = "impact-spring";
    const OFFERS: &'static [Offer] = &[
        Offer::new("impact", |given| {
            match (given.given("k"), given.given("e")) {
                (Some(stiffness), None) => Ok(Form::of(ImpactSpring { stiffness })),
                (None, Some(e)) => stop(given, e),
                (None, None) => Err(LawFault::Missing(SPRING, STOP)),
                (Some(_), Some(_)) => Err(LawFault::Both(SPRING, STOP)),
            }
        })
        .in_structures(
            "closes when r reaches 0; a spring k [I (7)], or rigid with restitution e",
            of_structures![K, E],
        ),
        Offer::new(Self::NAME, |given| {
            let stiffness = given.need("k")?;
            Ok(Form::of(ImpactSpring { stiffness }))
        })
        .also(&["linearspring", "penaltyspring"])
        .between_bars("linear spring [I (7)]", &[])
        .in_structures("impact with the spring k [I (7)]", &[&structure::K]),
    ];
    const CLOSED_FORM: ClosedForm<Self> = ClosedForm::Collision(|law, mass, speed| {
        RigidImpact::linear(law.stiffness, 0.0, mass, speed)
    });
}

impl Properties for ImpactSpring {
    fn family(&self) -> Family {
        Family::Spring(self.stiffness)
    }

    fn element(&self, _: f64, _: f64) -> Option<Box<dyn Element>> {
        Some(Box::new(ImpactElement::new(self.stiffness)))
    }

    fn line(&self) -> Option<ClippedLine> {
        let stiffness = self.stiffness;
        Some(ClippedLine::Spring { stiffness })
    }
}

impl Law for ImpactSpring {
    type Step<const L: usize> = Step<L>;

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        let compliance = lanes(laws, |law| 1.0 / law.stiffness);
        Step {
            h: on.start.h,
            stiffness: (compliance + on.end.h).map(|c| 1.0 / c),
        }
    }

    /// From -`reach` to `reach`.
    fn cycle(&self, reach: f64) -> Cycle {
        let points = vec![[-reach, -self.stiffness * reach], [0.0, 0.0], [reach, 0.0]];
        (points, Vec::new())
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = ();

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, _: &mut ()) -> Lane<L> {
        // h > 0, so r has the same sign with and without S(i+1).
        let predictor = trial.displacement + (trial.change - trial.force * self.h);
        (predictor * self.stiffness).smaller(Lane::splat(0.0))
    }
}
