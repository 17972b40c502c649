//! Hertz's law with a damping factor, F = k_h delta^1.5 (1 + kappa ddelta/v0), or 0 if that is negative, with three formulas for
//! kappa.

use super::collision::DampedHertz;
use super::{ClosingSpeed, Free, hertz, loop_of, resisting};
use crate::contact::{Cycle, Law, StepFlexibility, StepLaw, StoredEnergy, Trial, lanes};
use crate::lane::Lane;

/// The law over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    hertz: hertz::Step<L>,
    /// kappa.
    damping: Lane<L>,
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

/// A law for each formula of kappa.
macro_rules! laws {
    ($($(#[$doc:meta])+ $law:ident: $restitution:ident => $kappa:expr;)+) => {$(
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

laws! {
    /// kappa = 3 (1 - e^2)/4 (Lankarani and Nikravesh 1990; for pounding Muthukumar and DesRoches 2006).
    HertzDamp: e => 0.75 * (1.0 - e) * (1.0 + e);
    /// kappa = 3 (1 - e)/2 (Hunt and Crossley 1975).
    HuntCrossley: e => 1.5 * (1.0 - e);
    /// kappa = 8 (1 - e)/(5 e) (Ye, Li and Zhu 2009).
    Ye: e => 1.6 * (1.0 - e) / e;
}

fn cycle(stiffness: f64, damping: f64, reach: f64) -> Cycle {
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
