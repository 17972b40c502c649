//! Hertz's law with a damping factor, F = k_h delta^1.5 (1 + kappa ddelta/v0), or 0 if that is negative, for laws that
//! differ in their formula of kappa.

use crate::contact::impact::collision::DampedHertz;
use prelude::*;

/// What [`damped_hertz`] uses, for files with another formula.
pub(in crate::contact) mod prelude {
    pub(in crate::contact) use super::{Step, cycle};
    pub(in crate::contact) use crate::contact::impact::{
        ClosingSpeed, Free, Hertz, RigidImpact, hertz, loop_of, resisting,
    };
    pub(in crate::contact) use crate::contact::prelude::*;
}

/// The law over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    pub(in crate::contact) hertz: hertz::Step<L>,
    /// kappa.
    pub(in crate::contact) damping: Lane<L>,
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = ClosingSpeed<L>;

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, memory: &mut ClosingSpeed<L>) -> Lane<L> {
        let free = Free::new(trial, &self.hertz.start);
        let v0 = memory.of_step(trial, &free);
        resisting(
            self.hertz
                .push(&free, self.damping.zip(v0, |kappa, v0| kappa / v0)),
        )
    }
}

/// A law with a formula of kappa; a file has one.
macro_rules! damped_hertz {
    ($($(#[$doc:meta])+ $law:ident $name:literal $(also $($also:literal),+)?: $meaning:literal, $restitution:ident => $kappa:expr;)+) => {$(
        $(#[$doc])+
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct $law {
            /// k_h, force over length^1.5.
            pub stiffness: f64,
            /// kappa, without dimension.
            pub damping: f64,
        }

        impl $law {
            /// For a target of the coefficient of restitution in (0, 1]; 1 gives no damping.
            pub fn new(stiffness: f64, restitution: f64) -> Self {
                let $restitution = restitution;
                $law { stiffness, damping: $kappa }
            }
        }

        impl StoredEnergy for $law {
            fn stored_energy(&self, r: f64, _: f64) -> f64 {
                hertz::stored_energy(self.stiffness, r)
            }

            fn conservative_force(&self, r: f64, _: f64) -> f64 {
                hertz::conservative_force(self.stiffness, r)
            }
        }

        impl Described for $law {
            const KIND: ContactKind = ContactKind::Impact;
            const NAME: &'static str = $name;
            const OFFERS: &'static [Offer] = &[Offer::new(Self::NAME, |given| {
                let (k_h, restitution) = (given.need("k_h")?, given.need("restitution")?);
                Ok(Form::of($law::new(k_h, restitution)).with_restitution(restitution))
            })
                .also(&[$($($also),+)?])
                .between_bars(
                    $meaning,
                    &[&bars::K_H, &bars::RESTITUTION],
                )
                .in_structures(
                    $meaning,
                    of_structures![K_H, RESTITUTION],
                )];
            const CLOSED_FORM: ClosedForm<Self> = ClosedForm::Collision(|law, mass, speed| {
                RigidImpact::hertz(law.stiffness, law.damping, mass, speed)
            });
        }

        impl Properties for $law {
            fn family(&self) -> Family {
                Family::Hertz(self.stiffness)
            }

            fn undamped(&self) -> Option<ContactLaw> {
                let stiffness = self.stiffness;
                Some(Hertz { stiffness }.into())
            }

            fn divides_by_closing_speed(&self) -> bool {
                true
            }
        }

        impl Law for $law {
            type Step<const L: usize> = Step<L>;

            #[inline(always)]
            fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
                Step {
                    hertz: hertz::Step::new(lanes(laws, |law| law.stiffness), on),
                    damping: lanes(laws, |law| law.damping),
                }
            }

            /// A collision of two rigid masses up to the overlap `reach`. Its shape depends on kappa only.
            fn cycle(&self, reach: f64) -> Cycle {
                cycle(self.stiffness, self.damping, reach)
            }
        }
    )+};
}

pub(in crate::contact) use damped_hertz;

/// A collision of two rigid masses up to the overlap `reach`.
pub(in crate::contact) fn cycle(stiffness: f64, damping: f64, reach: f64) -> Cycle {
    let collision = DampedHertz { damping };
    let branch = |closing: bool| {
        (0..=hertz::POINTS).map(move |i| {
            // Points are near one another at the largest overlap, where the speed changes like the root of the distance to it.
            let p = f64::from(i) / f64::from(hertz::POINTS);
            let (overlap, speed) = (reach * (1.0 - p) * (1.0 + p), collision.speed(p, closing));
            [
                overlap,
                hertz::push(stiffness, overlap) * (1.0 + damping * speed),
            ]
        })
    };
    loop_of(branch(true).rev().chain(branch(false)), reach)
}
