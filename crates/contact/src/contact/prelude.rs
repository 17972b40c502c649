//! What files of laws use.

pub(super) use super::number::{Number, Range, Usual};
pub(super) use super::numbers::{bars, of_oscillator, of_structures, oscillator, structure};
pub(super) use super::offer::{Form, Offer};
pub(super) use super::{
    AnyPlaneLaw, ClippedLine, ClosedForm, ContactKind, ContactLaw, Cycle, Deflection, Described,
    ElasticInPlane, Evolution, Family, Flexibility, GivenNumbers, InPlane, Law, LawFault,
    OfVelocity, Properties, StepFlexibility, StepLaw, StoredEnergy, Straight, Trial, curve, lanes,
    roots, saturation,
};
pub(super) use crate::lane::Lane;
