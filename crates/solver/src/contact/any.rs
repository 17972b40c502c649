//! The law of a contact, any of the list at the end of this file.

use super::element::Element;
use super::{
    Answer, Bearing, BoucWen, Cycle, Dahl, DisplacementControl, Hertz, HertzDamp, HuntCrossley,
    ImpactSpring, Jankowski, KelvinVoigt, Law, LawsVisitor, Lugre, Rigid, RunningLaw,
    StepFlexibility, StoredEnergy, Stribeck, Tanh, Trial, VelocityControl, Visitor, Ye,
};
use crate::lane::Lane;
use multiversion::multiversion;

/// The laws. Loops over steps are compiled once for each of the `direct` laws, which the recorded speeds are of, and once for all
/// others together, with a choice in every step.
macro_rules! laws {
    (direct: $($direct:ident),+; others: $($other:ident),* $(,)?) => {
        laws!(@all $($direct),+ $(, $other)*);

        impl ContactLaw {
            /// Runs the visitor with the laws themselves; all cases have a law of the first one's kind.
            pub fn accept<const L: usize, V: LawsVisitor<L>>(laws: &[ContactLaw; L], visitor: V) -> V::Output {
                match laws[0] {
                    $(ContactLaw::$direct(first) => {
                        visitor.visit(&own_laws(laws, first, $direct::of))
                    })+
                    _ => visitor.visit(laws),
                }
            }
        }

        impl<const L: usize> AnyLaw<L> {
            /// Runs the visitor with the law itself.
            pub fn accept(&mut self, visitor: impl Visitor<L>) {
                match self {
                    $(AnyLaw::$direct(law) => visitor.visit(law),)+
                    _ => visitor.visit(self),
                }
            }
        }
    };
    (@all $($law:ident),+) => {
        /// The law of a contact.
        ///
        /// A sliding contact dissipates S times the distance, and its elastic part stores S^2/(2 k^C):
        ///
        /// ```
        /// use slipgap_solver::contact::{ContactLaw, DisplacementControl, LawKind, StoredEnergy};
        ///
        /// let friction = DisplacementControl { compliance: 0.1, limit: 1.0 };
        /// let law = ContactLaw::DisplacementControl(friction);
        /// assert_eq!(law.kind(), LawKind::DisplacementControl);
        /// assert_eq!(law.stored_energy(3.0, 1.0), 0.05);
        /// ```
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub enum ContactLaw {
            $(#[doc = concat!("See [`", stringify!($law), "`].")] $law($law)),+
        }

        /// The laws.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        pub enum LawKind {
            $(#[doc = concat!("See [`", stringify!($law), "`].")] $law),+
        }

        /// A law over the steps of a run, for L cases.
        #[derive(Debug, Clone, Copy)]
        pub enum AnyLaw<const L: usize> {
            $(#[doc = concat!("Of [`", stringify!($law), "`].")] $law(RunningLaw<<$law as Law>::Step<L>, L>)),+
        }

        $(impl $law {
            fn of(law: &ContactLaw) -> Option<$law> {
                match law {
                    ContactLaw::$law(law) => Some(*law),
                    _ => None,
                }
            }
        })+

        impl ContactLaw {
            /// Which law it is.
            pub fn kind(&self) -> LawKind {
                match self {
                    $(ContactLaw::$law(_) => LawKind::$law),+
                }
            }

            /// The law over the steps of a run with a method of these flexibilities; all cases have a law of the first one's kind.
            pub fn running<const L: usize>(laws: &[ContactLaw; L], on: &[StepFlexibility<L>; 2]) -> AnyLaw<L> {
                match laws[0] {
                    $(ContactLaw::$law(first) => {
                        AnyLaw::$law(RunningLaw::of(&own_laws(laws, first, $law::of), on))
                    }),+
                }
            }

            /// The law's curve, see [`Law::cycle`].
            pub fn cycle(&self, reach: f64) -> Cycle {
                match self {
                    $(ContactLaw::$law(law) => law.cycle(reach)),+
                }
            }

            /// The law as the papers print it, at r under S; `None` if they do not.
            pub fn element(&self, r: f64, s: f64) -> Option<Box<dyn Element>> {
                match self {
                    $(ContactLaw::$law(law) => law.element(r, s)),+
                }
            }
        }

        impl<const L: usize> AnyLaw<L> {
            /// Other numbers of a law of the same kind in all lanes; the memory stays.
            pub fn change(&mut self, law: &ContactLaw, on: &[StepFlexibility<L>; 2]) {
                match (self, law) {
                    $((AnyLaw::$law(running), ContactLaw::$law(law)) => {
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

            fn deflection(&self, s: f64) -> Option<[f64; 2]> {
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

        // A function of its own: it is compiled once, and not in every loop over steps.
        #[multiversion(targets("x86_64+avx512f+avx512bw+avx512cd+avx512dq+avx512vl", "x86_64+avx2"))]
        fn answer<const L: usize>(law: &mut AnyLaw<L>, part: usize, trial: &Trial<L>) -> Lane<L> {
            match law {
                $(AnyLaw::$law(law) => law.force(part, trial)),+
            }
        }
    };
}

laws!(
    direct: DisplacementControl, VelocityControl, ImpactSpring;
    others: KelvinVoigt, Hertz, HertzDamp, HuntCrossley, Ye, Jankowski, Rigid,
        Bearing, Tanh, Stribeck, BoucWen, Dahl, Lugre
);

impl<const L: usize> Answer<L> for AnyLaw<L> {
    fn force(&mut self, part: usize, trial: &Trial<L>) -> Lane<L> {
        answer(self, part, trial)
    }
}

/// The laws themselves, which all have the kind of the first.
// Arrays are filled by loops: with more than 16 lanes, maps of arrays are not inlined.
#[inline(always)]
fn own_laws<W: Copy, const L: usize>(
    laws: &[ContactLaw; L],
    first: W,
    own: impl Fn(&ContactLaw) -> Option<W>,
) -> [W; L] {
    let mut all = [first; L];
    for (slot, law) in all.iter_mut().zip(laws) {
        if let Some(law) = own(law) {
            *slot = law;
        }
    }
    all
}
