//! The impact spring.

use super::element::{Element, ImpactElement};
use super::{Cycle, Law, StepFlexibility, StepLaw, StoredEnergy, Trial, lanes};
use crate::lane::Lane;

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

impl StoredEnergy for ImpactSpring {
    fn stored_energy(&self, r: f64, s: f64) -> f64 {
        s * r * 0.5
    }

    #[inline(always)]
    fn deflection(&self, s: f64) -> Option<[f64; 2]> {
        Some([s / self.stiffness, 1.0 / self.stiffness])
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

    fn element(&self, _: f64, _: f64) -> Option<Box<dyn Element>> {
        Some(Box::new(ImpactElement::new(self.stiffness)))
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
