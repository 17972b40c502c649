//! The contact laws of bars and their parameters.

use crate::contact::{ContactLaw, ImpactSpring};
use crate::problem::Case;
use crate::problem::parameter::Parameter;

/// Parameters of the laws, after those of the bars in the table; the stiffness of the spring is among the latter.
pub(super) static PARAMETERS: [Parameter; 0] = [];

/// The law of a case with an impact spring of this stiffness, in the case's scales; `None` where a parameter is not given.
pub fn law(_case: &Case, stiffness: f64) -> Option<ContactLaw> {
    Some(ContactLaw::ImpactSpring(ImpactSpring { stiffness }))
}
