//! The parameters of the contact laws of bars.

use crate::contact::numbers::bars;
use crate::contact::{Described, ImpactSpring};
use crate::problem::numbers::parameter::{Default, Kind, Parameter, Value, row_of};
use crate::problem::offered_laws::{law_names, laws};

/// Parameters of the laws, after those of the bars in the table; the stiffness of the linear spring is among the latter. The numbers
/// that only one law has follow.
pub static PARAMETERS: [Parameter; 3] = [
    Parameter::new(
        ["law", "law", "1"],
        Kind::Choice(laws!(Bars, Which::All)),
        Default::Is(Value::Name(ImpactSpring::NAME)),
        "contact law",
    )
    .with_column_if_given(),
    Parameter::of_laws(&bars::K_H, law_names!(Bars, Which::With(&bars::K_H)))
        .with_column_if_given(),
    Parameter::of_laws(
        &bars::RESTITUTION,
        law_names!(Bars, Which::With(&bars::RESTITUTION)),
    )
    .with_heading("target_restitution")
    .with_column_if_given(),
];

/// Rows of the parameters in their table.
pub mod rows {
    use super::{PARAMETERS, row_of};

    pub const K_H: usize = row_of(&PARAMETERS, "k_h");
    pub const RESTITUTION: usize = row_of(&PARAMETERS, "restitution");
}
