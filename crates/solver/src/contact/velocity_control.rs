//! The velocity-control model of friction.

use super::element::{Element, VelocityFriction};
use super::{Cycle, Law, StepFlexibility, StepLaw, StoredEnergy, Trial, lanes};
use crate::lane::Lane;

/// Velocity-control model [F (16)]: viscous up to rdot^E = nu |N|/c^C, then sliding at the friction limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VelocityControl {
    /// 1/c^C; beta in dimensionless units.
    pub compliance: f64,
    /// `nu |N| <N>`, >= 0.
    pub limit: f64,
}

/// The model over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    /// `nu |N| <N>`, >= 0; may change from step to step.
    pub limit: Lane<L>,
    /// S(i+1) of the viscous element for a unit of rdot, and for a unit of -S(i).
    by_rate: Lane<L>,
    by_force: Lane<L>,
}

impl StoredEnergy for VelocityControl {
    fn stored_energy(&self, _: f64, _: f64) -> f64 {
        0.0
    }
}

impl Law for VelocityControl {
    type Step<const L: usize> = Step<L>;

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        let by_rate = (lanes(laws, |law| law.compliance) + on.end.h_rate).map(|c| 1.0 / c);
        Step {
            limit: lanes(laws, |law| law.limit),
            by_rate,
            by_force: on.start.h_rate * by_rate,
        }
    }

    /// In the papers the normal force of a closed contact is negative.
    fn element(&self, _: f64, _: f64) -> Option<Box<dyn Element>> {
        let element = VelocityFriction::new(1.0 / self.compliance, self.limit, -1.0);
        Some(Box::new(element))
    }

    /// From -`reach` to `reach` [F Fig. 3]; a compliance of zero is the rigid law.
    fn cycle(&self, reach: f64) -> Cycle {
        let (width, limit) = (self.compliance * self.limit, self.limit);
        let points = vec![
            [-1.1 * reach, -limit],
            [-width, -limit],
            [-0.6 * width, -0.6 * limit],
            [0.6 * width, 0.6 * limit],
            [width, limit],
            [1.1 * reach, limit],
        ];
        (points, vec![2, 3])
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = ();

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, _: &mut ()) -> Lane<L> {
        (trial.rate * self.by_rate - trial.force * self.by_force).cut(self.limit)
    }
}
