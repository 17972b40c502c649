//! The velocity-control model of friction.

use super::element::{Element, VelocityFriction};
use super::numbers::{oscillator, structure};
use super::offer::{Form, In, InOscillator, Offer};
use super::{
    Bearing, ClosedForm, ContactKind, ContactLaw, Cycle, Described, Law, Properties,
    StepFlexibility, StepLaw, StoredEnergy, Trial, lanes,
};
use crate::lane::Lane;

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
        Offer {
            name: Self::NAME,
            also: &[],
            oscillator: Some(InOscillator {
                of: In {
                    meaning: "viscous up to the velocity rdot^E, then at the friction limit [F (16)]",
                    numbers: &[
                        &oscillator::BETA,
                        &oscillator::NU_RATIO,
                        &oscillator::NU_RATE,
                    ],
                },
                law: |given| {
                    let [compliance, ratio, rate] = given.all()?;
                    Some(with_ratio(compliance, 1.0, [ratio, rate]))
                },
            }),
            bars: None,
            structure: Some(In {
                meaning: "friction, viscous up to the velocity rdot^E, then at the limit [F (16)]",
                numbers: &[
                    &structure::C,
                    &structure::RDOT_E,
                    &structure::NU_MIN,
                    &structure::NU_RATE,
                ],
            }),
            form: |given| {
                let viscosity = given.viscosity(given.limit())?;
                let [ratio, rate] = given.bearing()?;
                if ratio == 1.0 {
                    return Ok(Form::Viscous { viscosity });
                }
                let law = with_ratio(1.0 / viscosity, given.limit(), [ratio, rate]);
                Ok(Form::Friction(law))
            },
        },
        Offer {
            name: VelocityControl::RIGID_NAME,
            also: &[],
            oscillator: Some(InOscillator {
                of: In {
                    meaning: "without compliance: sticks below the friction limit, slides at it",
                    numbers: &[],
                },
                law: |_| Some(with_ratio(0.0, 1.0, [1.0, 0.0])),
            }),
            bars: None,
            structure: Some(In {
                meaning: "friction without compliance: sticks below the static limit, slides at the limit",
                numbers: &[&structure::STATIC_RATIO],
            }),
            form: |given| {
                let static_ratio = given.need("static_ratio")?;
                Ok(Form::Coulomb { static_ratio })
            },
        },
    ];
    const CLOSED_FORM: ClosedForm<Self> =
        ClosedForm::Driven(|law, velocity, _| Some((velocity / law.compliance).min(law.limit)));
}

impl Properties for VelocityControl {
    fn shown(&self) -> Vec<(&'static str, f64)> {
        vec![("c =", 1.0 / self.compliance)]
    }

    fn reach(&self) -> f64 {
        match self.compliance {
            0.0 => 1.0,
            compliance => 4.0 * compliance * self.limit,
        }
    }

    fn bounds(&self) -> [f64; 2] {
        [-self.limit, self.limit]
    }

    fn over_velocity(&self) -> bool {
        true
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

/// The law with nu_min/nu and the rate of the coefficient: that of a bearing if they matter.
fn with_ratio(compliance: f64, limit: f64, [ratio, rate]: [f64; 2]) -> ContactLaw {
    match ratio == 1.0 {
        true => ContactLaw::VelocityControl(VelocityControl { compliance, limit }),
        false => ContactLaw::Bearing(Bearing {
            compliance,
            limit,
            ratio,
            rate,
        }),
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = ();

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, _: &mut ()) -> Lane<L> {
        (trial.rate * self.by_rate - trial.force * self.by_force).cut(self.limit)
    }
}
