//! The contact laws of bars and their parameters.

use super::tables::LAW;
use super::tables::laws::rows;
use crate::contact::number::Number;
use crate::contact::numbers::bars;
use crate::contact::offer::{Offered, Place, most_numbers};
use crate::contact::{ALL, ContactKind, ContactLaw, GivenNumbers, WhichLaw};
use crate::methods::Method;
use crate::problem::Case;
use crate::problem::numbers::parameter::Value;

/// The law of a case; `None` if it is not given.
pub(super) fn law_of(case: &Case) -> Option<&'static Offered> {
    Offered::named(Place::Bars, case.name_at(LAW))
}

/// Whether a case has rigid contact.
pub(super) fn is_rigid(case: &Case) -> bool {
    law_of(case).is_some_and(|law| law.law == WhichLaw::Rigid)
}

/// Whether a law has this number.
pub(super) fn has(law: &Offered, number: &Number) -> bool {
    law.offer.bars.is_some_and(|own| number.is_in(own.numbers))
}

/// Fills in the restitution of a law that has one.
pub(super) fn fill_restitution(case: &mut Case) {
    let row = LAW + rows::RESTITUTION;
    let Some(law) = law_of(case).filter(|law| has(law, &bars::RESTITUTION)) else {
        return;
    };
    let default = match law.law {
        WhichLaw::Rigid => 0.0,
        _ => 1.0,
    };
    case.values[row] = case.values[row].or(Some(Value::Number(default)));
}

/// Most numbers of a law.
const MOST: usize = most_numbers(&ALL, Place::Bars);

/// The law of a case in its scales; `None` where a parameter is not given. A linear spring has this stiffness; `mass` is m1 m2/(m1 +
/// m2) of the whole bars.
///
/// The secant stiffness of a law with delta^1.5 is that of the linear spring at the overlap under the exact force F0, which is 1
/// here, so that k_h = k_I^1.5.
pub fn law(case: &Case, method: Method, stiffness: f64, mass: f64) -> Option<ContactLaw> {
    let offer = law_of(case)?.offer;
    let own = offer.bars?;
    let mut values = [None; MOST];
    for (value, number) in values.iter_mut().zip(own.numbers) {
        *value = match number.key {
            "k_h" => Some(stiffness * stiffness.sqrt()),
            "restitution" => case.at(LAW + rows::RESTITUTION),
            key => case.number(key),
        };
    }
    let given = GivenNumbers {
        law: offer.name,
        numbers: own.numbers,
        values: &values[..own.numbers.len()],
        table: &[],
        others: &[
            ("k", stiffness),
            ("colliding_mass", mass),
            ("impulses", f64::from(method.has_impulses())),
        ],
    };
    let law = (offer.form)(&given).ok()?.given.law();
    (law.kind() == ContactKind::Impact).then_some(law)
}
