//! The velocity-control model of friction.

use super::Bearing;
use crate::contact::element::{Element, VelocityFriction};
use crate::contact::prelude::*;

/// Velocity-control model [F (16)]: viscous up to rdot^E = nu |N|/c^C, then sliding at the friction limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VelocityControl {
    /// 1/c^C; beta in dimensionless units.
    pub compliance: f64,
    /// `nu |N| <N>`, >= 0.
    pub limit: f64,
}

impl VelocityControl {
    /// The name by which studies have the law without compliance.
    pub const RIGID_NAME: &'static str = "coulomb";
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

impl StoredEnergy for VelocityControl {}

impl Described for VelocityControl {
    const KIND: ContactKind = ContactKind::Friction;
    const NAME: &'static str = "velocity-control";
    const OF_VELOCITY: bool = true;
    const OFFERS: &'static [Offer] = &[
        Offer::new(Self::NAME, |given| {
            let limit = given.limit();
            let compliance = given.fluidity(limit)?;
            Ok(match (given.bearing()?, given.given("beta")) {
                ([ratio, rate], _) if ratio != 1.0 => Form::of(Bearing {
                    compliance,
                    limit,
                    ratio,
                    rate,
                }),
                (_, Some(_)) => Form::of(VelocityControl { compliance, limit }),
                (_, None) => {
                    let viscosity = given.viscosity(limit)?;
                    ClippedLine::Viscous { viscosity }.into()
                }
            })
        })
        .in_oscillator(
            "viscous up to the velocity rdot^E, then at the friction limit [F (16)]",
            of_oscillator![BETA, NU_RATIO, NU_RATE],
        )
        .in_structures(
            "friction, viscous up to the velocity rdot^E, then at the limit [F (16)]",
            of_structures![C, RDOT_E, NU_MIN, NU_RATE],
        ),
        Offer::new(VelocityControl::RIGID_NAME, |given| {
            Ok(Form {
                static_ratio: given.given("static_ratio").unwrap_or(1.0),
                ..ClippedLine::Coulomb.into()
            })
        })
        .in_oscillator(
            "without compliance: sticks below the friction limit, slides at it",
            &[],
        )
        .in_structures(
            "friction without compliance: sticks below the static limit, slides at the limit",
            &[&structure::STATIC_RATIO],
        ),
    ];
    const IN_PLANE: InPlane<Self> = Some(|law, on| {
        let viscous = Some([law.compliance, law.limit]);
        let law = (*law).into();
        AnyPlaneLaw::new(OfVelocity { law, viscous }, on)
    });
    const CLOSED_FORM: ClosedForm<Self> =
        ClosedForm::Driven(|law, velocity, _| Some((velocity / law.compliance).min(law.limit)));
}

impl Properties for VelocityControl {
    fn family(&self) -> Family {
        Family::Viscous(self.compliance, self.limit)
    }

    fn reach(&self) -> f64 {
        match self.compliance {
            0.0 => 1.0,
            compliance => 4.0 * compliance * self.limit,
        }
    }

    fn rate_under(&self, force: f64) -> Option<[f64; 2]> {
        (self.compliance > 0.0).then_some([self.compliance * force, self.compliance])
    }

    /// In the papers the normal force of a closed contact is negative.
    fn element(&self, _: f64, _: f64) -> Option<Box<dyn Element>> {
        let element = VelocityFriction::new(1.0 / self.compliance, self.limit, -1.0);
        Some(Box::new(element))
    }

    fn line(&self) -> Option<ClippedLine> {
        let viscosity = 1.0 / self.compliance;
        Some(match self.is_vertical() {
            true => ClippedLine::Coulomb,
            false => ClippedLine::Viscous { viscosity },
        })
    }
}

impl Law for VelocityControl {
    type Step<const L: usize> = Step<L>;

    fn at_limit(self, limit: f64) -> Self {
        VelocityControl { limit, ..self }
    }

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        let by_rate = (lanes(laws, |law| law.compliance) + on.end.h_rate).map(|c| 1.0 / c);
        Step {
            limit: lanes(laws, |law| law.limit),
            by_rate,
            by_force: on.start.h_rate * by_rate,
        }
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
