//! The displacement-control model of friction.

use crate::contact::element::{DisplacementFriction, Element};
use crate::contact::prelude::*;

/// Displacement-control model [F (9)]: elastic up to r^E = nu |N|/k^C about the slip, then sliding at the friction limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DisplacementControl {
    /// 1/k^C; alpha in dimensionless units.
    pub compliance: f64,
    /// `nu |N| <N>`, >= 0.
    pub limit: f64,
}

/// The model over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    /// `nu |N| <N>`, >= 0; may change from step to step.
    pub limit: Lane<L>,
    /// S(i+1) of the elastic element for a unit of change and for a unit of S(i).
    by_change: Lane<L>,
    by_force: Lane<L>,
}

impl StoredEnergy for DisplacementControl {
    fn stored_energy(&self, _: f64, s: f64) -> f64 {
        0.5 * self.compliance * s * s
    }
}

impl Described for DisplacementControl {
    const KIND: ContactKind = ContactKind::Friction;
    const NAME: &'static str = "displacement-control";
    const OFFERS: &'static [Offer] = &[Offer::new(Self::NAME, |given| {
        let limit = given.limit();
        Ok(match given.given("alpha") {
            Some(compliance) => Form::of(DisplacementControl { compliance, limit }),
            None => ClippedLine::Elastic {
                stiffness: given.stiffness()?,
            }
            .into(),
        })
    })
    .in_oscillator(
        "elastic up to the displacement r^E, then sliding at the friction limit [F (9)]",
        &[&oscillator::ALPHA],
    )
    .in_structures(
        "friction, elastic up to the displacement r^E, then sliding at the limit [F (9)]",
        of_structures![K, R_E],
    )];
    const IN_PLANE: InPlane<Self> =
        Some(|law, on| AnyPlaneLaw::new(ElasticInPlane::from(*law), on));
    const CLOSED_FORM: ClosedForm<Self> = ClosedForm::Driven(|law, velocity, time| {
        Some((velocity * time / law.compliance).min(law.limit))
    });
}

impl Properties for DisplacementControl {
    fn family(&self) -> Family {
        Family::Elastic(self.compliance, self.limit)
    }

    fn evolution(&self) -> Option<&dyn Evolution> {
        Some(self)
    }

    /// In the papers the normal force of a closed contact is negative.
    fn element(&self, r: f64, s: f64) -> Option<Box<dyn Element>> {
        let slip = r - s * self.compliance;
        let element = DisplacementFriction::new(1.0 / self.compliance, self.limit, -1.0, slip, s);
        Some(Box::new(element))
    }

    fn line(&self) -> Option<ClippedLine> {
        let stiffness = 1.0 / self.compliance;
        Some(ClippedLine::Elastic { stiffness })
    }
}

impl Law for DisplacementControl {
    type Step<const L: usize> = Step<L>;

    fn at_limit(self, limit: f64) -> Self {
        DisplacementControl { limit, ..self }
    }

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        let compliance = lanes(laws, |law| law.compliance);
        let by_change = (compliance + on.end.h).map(|c| 1.0 / c);
        Step {
            limit: lanes(laws, |law| law.limit),
            by_change,
            by_force: (compliance - on.start.h) * by_change,
        }
    }

    /// From rest to `reach`, to -`reach` and back [F Fig. 3]; a compliance of zero is the rigid law.
    fn cycle(&self, reach: f64) -> Cycle {
        let width = self.compliance * self.limit;
        let limit = self.limit;
        let unloading = |t: f64| [reach - 2.0 * width * t, (1.0 - 2.0 * t) * limit];
        let loading = |t: f64| [2.0 * width * t - reach, (2.0 * t - 1.0) * limit];
        let points = vec![
            [0.0, 0.0],
            [width, limit],
            unloading(0.0),
            unloading(0.3),
            unloading(0.7),
            unloading(1.0),
            loading(0.0),
            loading(0.3),
            loading(0.7),
            loading(1.0),
            [width, limit],
        ];
        (points, vec![3, 4, 7, 8])
    }
}

/// z is S.
impl Evolution for DisplacementControl {
    fn rate(&self, _: f64, rdot: f64) -> f64 {
        rdot / self.compliance
    }

    fn bound(&self) -> f64 {
        self.limit
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = ();

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, _: &mut ()) -> Lane<L> {
        // Stick: S = k^C (r - r^S) [F (9)] at both ends of the step, so S(i+1) = S(i) + k^C (r(i+1) - r(i)). The limit is the
        // return mapping that [F] does not print: beyond it the slip r^S = r - S/k^C follows the contact. For N >= 0 the limit
        // is zero, so that an open contact has no slip.
        (trial.change * self.by_change + trial.force * self.by_force).cut(self.limit)
    }
}
