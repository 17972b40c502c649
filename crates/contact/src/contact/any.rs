//! The law of a contact, any of the list at the end of this file.

use super::impact::*;
use super::offer::{self, Offered};
use super::plane::{AnyPlaneLaw, PlaneStep};
use super::*;
use crate::for_widest;
use crate::lane::Lane;

/// The laws.
macro_rules! laws {
    ($($law:ident),+ $(,)?) => {
        /// The law of a contact.
        ///
        /// A sliding contact dissipates S times the distance, and its elastic part stores S^2/(2 k^C):
        ///
        /// ```
        /// use slipgap_contact::contact::{ContactLaw, DisplacementControl, StoredEnergy, WhichLaw};
        ///
        /// let friction = DisplacementControl { compliance: 0.1, limit: 1.0 };
        /// let law = ContactLaw::DisplacementControl(friction);
        /// assert_eq!(law.which(), WhichLaw::DisplacementControl);
        /// assert_eq!(law.stored_energy(3.0, 1.0), 0.05);
        /// ```
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub enum ContactLaw {
            $(#[doc = concat!("See [`", stringify!($law), "`].")] $law($law)),+
        }

        /// The laws without their numbers.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        pub enum WhichLaw {
            $(#[doc = concat!("See [`", stringify!($law), "`].")] $law),+
        }

        impl WhichLaw {
            /// All laws.
            pub const ALL: &[WhichLaw] = &[$(WhichLaw::$law),+];
        }

        /// A law over the steps of a run, for L cases.
        #[derive(Debug, Clone, Copy)]
        pub enum AnyRunningLaw<const L: usize> {
            $(#[doc = concat!("Of [`", stringify!($law), "`].")] $law(RunningLaw<<$law as Law>::Step<L>, L>)),+
        }

        $(impl From<$law> for ContactLaw {
            fn from(law: $law) -> ContactLaw {
                ContactLaw::$law(law)
            }
        }

        impl OneLaw for $law {
            #[inline(always)]
            fn of(law: &ContactLaw) -> Option<&$law> {
                match law {
                    ContactLaw::$law(law) => Some(law),
                    _ => None,
                }
            }

            #[inline(always)]
            fn running<const L: usize>(law: &mut AnyRunningLaw<L>) -> Option<&mut RunningLaw<<$law as Law>::Step<L>, L>> {
                match law {
                    AnyRunningLaw::$law(law) => Some(law),
                    _ => None,
                }
            }
        })+

        impl ContactLaw {
            /// Which law it is.
            pub fn which(&self) -> WhichLaw {
                match self {
                    $(ContactLaw::$law(_) => WhichLaw::$law),+
                }
            }

            /// What its contact can do.
            pub fn kind(&self) -> ContactKind {
                match self {
                    $(ContactLaw::$law(law) => law.kind()),+
                }
            }

            /// Its name in text.
            pub fn name(&self) -> &'static str {
                match self {
                    $(ContactLaw::$law(_) => $law::NAME),+
                }
            }

            /// Whether S follows from rdot alone.
            pub fn of_velocity(&self) -> bool {
                match self {
                    $(ContactLaw::$law(_) => $law::OF_VELOCITY),+
                }
            }

            /// What its numbers tell.
            pub fn properties(&self) -> &dyn Properties {
                match self {
                    $(ContactLaw::$law(law) => law),+
                }
            }

            /// The law in a plane over a step; `None` for a law that does not slide in one.
            pub fn in_plane(&self, on: &PlaneStep) -> Option<AnyPlaneLaw> {
                match self {
                    $(ContactLaw::$law(law) => $law::IN_PLANE.map(|of| of(law, on))),+
                }
            }

            /// The law with another friction limit; an impact and a link have none.
            pub fn at_limit(&self, limit: f64) -> ContactLaw {
                match *self {
                    $(ContactLaw::$law(law) => ContactLaw::$law(law.at_limit(limit))),+
                }
            }

            /// The collision of two rigid masses, of m = m1 m2/(m1 + m2) and the closing speed; `None` for a law without one.
            pub fn collision(&self, mass: f64, speed: f64) -> Option<RigidImpact> {
                match self {
                    $(ContactLaw::$law(law) => match $law::CLOSED_FORM {
                        ClosedForm::Collision(collision) => Some(collision(law, mass, speed)),
                        ClosedForm::Driven(_) | ClosedForm::None(_) => None,
                    }),+
                }
            }

            /// S after a motion from rest with S = 0 at this rdot > 0 for this time; `None` without a closed form.
            pub fn driven(&self, velocity: f64, time: f64) -> Option<f64> {
                match self {
                    $(ContactLaw::$law(law) => match $law::CLOSED_FORM {
                        ClosedForm::Driven(driven) => driven(law, velocity, time),
                        ClosedForm::Collision(_) | ClosedForm::None(_) => None,
                    }),+
                }
            }

            /// The law over the steps of a run with a method of these flexibilities; all cases have a law of the first one's kind.
            pub fn running<const L: usize>(laws: &[ContactLaw; L], on: &[StepFlexibility<L>; 2]) -> AnyRunningLaw<L> {
                match laws[0] {
                    $(ContactLaw::$law(first) => {
                        AnyRunningLaw::$law(RunningLaw::of(&own_laws(laws, first), on))
                    }),+
                }
            }

            /// The law's curve, see [`Law::cycle`].
            pub fn cycle(&self, reach: f64) -> Cycle {
                match self {
                    $(ContactLaw::$law(law) => law.cycle(reach)),+
                }
            }
        }

        /// The offers of each law.
        const OFFERS: &[offer::OffersOf] = &[
            $((WhichLaw::$law, $law::KIND, [$law::OF_VELOCITY, $law::IN_PLANE.is_some()], $law::OFFERS)),+
        ];

        impl<const L: usize> AnyRunningLaw<L> {
            /// Other numbers of a law of the same kind in all lanes; the memory stays.
            pub fn change(&mut self, law: &ContactLaw, on: &[StepFlexibility<L>; 2]) {
                match (self, law) {
                    $((AnyRunningLaw::$law(running), ContactLaw::$law(law)) => {
                        running.parts = RunningLaw::of(&[*law; L], on).parts;
                    })+
                    // Of another kind it would have no memory.
                    (other, law) => *other = ContactLaw::running(&[*law; L], on),
                }
            }
        }

        impl StoredEnergy for ContactLaw {
            fn stored_energy(&self, r: f64, s: f64) -> f64 {
                match self {
                    $(ContactLaw::$law(law) => law.stored_energy(r, s)),+
                }
            }

            fn deflection(&self, s: f64) -> Option<Deflection> {
                match self {
                    $(ContactLaw::$law(law) => law.deflection(s)),+
                }
            }

            fn conservative_force(&self, r: f64, s: f64) -> f64 {
                match self {
                    $(ContactLaw::$law(law) => law.conservative_force(r, s)),+
                }
            }
        }

        impl<const L: usize> AnyRunningLaw<L> {
            fn own_correction(&self, displacement: Lane<L>) -> Lane<L> {
                match self {
                    $(AnyRunningLaw::$law(law) => law.correction(displacement)),+
                }
            }
        }

        // A function of its own: it is compiled once, and not in every loop over steps.
        for_widest! {
            fn answer<const L: usize>(law: &mut AnyRunningLaw<L>, part: usize, trial: &Trial<L>) -> Lane<L> {
                match law {
                    $(AnyRunningLaw::$law(law) => law.force(part, trial)),+
                }
            }
        }
    };
}

laws! {
    DisplacementControl, VelocityControl, ImpactSpring, KelvinVoigt, Hertz, HertzDamp, HuntCrossley, Ye, Jankowski,
    Rigid, Bearing, Tanh, Stribeck, BoucWen, Dahl, Lugre, Bilinear, GapYield, Restrainer, Viscous, Multilinear,
    HyperbolicGap, Pendulum, ImpactYield, Imk, Own,
}

/// All laws by the names of studies: impacts, friction, links.
pub static LAWS: [Offered; offer::count(OFFERS)] = ALL;
/// The same, for constants.
pub const ALL: [Offered; offer::count(OFFERS)] = {
    let (law, kind, [of_velocity, in_plane], offers) = OFFERS[0];
    let first = Offered {
        law,
        kind,
        of_velocity,
        in_plane,
        offer: &offers[0],
    };
    offer::collect(OFFERS, first)
};

impl ContactLaw {
    /// The clipped line that the law is, see [`Properties::line`].
    pub fn line(&self) -> Option<ClippedLine> {
        self.properties().line()
    }

    /// The law in continuous time, see [`Properties::evolution`].
    pub fn evolution(&self) -> Option<&dyn Evolution> {
        self.properties().evolution()
    }
}

impl<const L: usize> ContactResponse<L> for AnyRunningLaw<L> {
    fn force(&mut self, part: usize, trial: &Trial<L>) -> Lane<L> {
        answer(self, part, trial)
    }

    fn correction(&self, displacement: Lane<L>) -> Lane<L> {
        self.own_correction(displacement)
    }
}

impl AnyRunningLaw<1> {
    /// Why the last answer of an [`OwnLaw`] is not taken; `None` of other laws.
    pub fn own_fault(&mut self) -> Option<OwnFault> {
        Own::running(self).and_then(|running| running.memory.fault())
    }
}

/// One of the laws. A loop over steps is compiled for it alone where sweeps of millions have this law.
pub trait OneLaw: Law + Copy {
    /// The law, if it is this one.
    fn of(law: &ContactLaw) -> Option<&Self>;

    /// The law over the steps of a run, if it is this one.
    fn running<const L: usize>(
        law: &mut AnyRunningLaw<L>,
    ) -> Option<&mut RunningLaw<Self::Step<L>, L>>;

    /// The laws of all cases, if the first is this one; they have its kind.
    #[inline(always)]
    fn all<const L: usize>(laws: &[ContactLaw; L]) -> Option<[Self; L]> {
        Self::of(&laws[0]).map(|first| own_laws(laws, *first))
    }
}

/// The laws themselves, which all have the kind of the first.
// Arrays are filled by loops: with more than 16 lanes, maps of arrays are not inlined.
#[inline(always)]
fn own_laws<W: OneLaw, const L: usize>(laws: &[ContactLaw; L], first: W) -> [W; L] {
    let mut filled = [first; L];
    for (slot, law) in filled.iter_mut().zip(laws) {
        if let Some(law) = W::of(law) {
            *slot = *law;
        }
    }
    filled
}
