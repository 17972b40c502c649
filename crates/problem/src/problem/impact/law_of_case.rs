//! The contact laws of bars and their parameters.

use super::tables::law_parameters::rows;
use super::tables::{LAW, SCHEMA};
use crate::contact::number::Number;
use crate::contact::numbers::bars;
use crate::contact::offer::{Form, Place};
use crate::contact::{ContactKind, ContactLaw, GivenNumbers};
use crate::methods::Method;
use crate::problem::Case;
use crate::problem::numbers::parameter::Value;
use crate::problem::offered_laws::Own;
use std::sync::LazyLock;

static OWN: LazyLock<Vec<Own>> = LazyLock::new(|| Own::all(Place::Bars, &SCHEMA.parameters));

/// Their laws without compliance, with any numbers.
static RIGID: LazyLock<Vec<&str>> = LazyLock::new(|| {
    let is_vertical = |offered: &&Own| {
        let law = form(offered, |_, _| Some(1.0), [1.0; 3]);
        law.is_some_and(|form| form.given.law().properties().is_vertical())
    };
    let rigid = OWN.iter().filter(is_vertical);
    rigid.map(|law| law.offered.offer.name).collect()
});

/// The law of a case; `None` if it is not given.
fn law_of(case: &Case) -> Option<&'static Own> {
    Own::named(&OWN, case.name_at(LAW))
}

/// Whether a case has rigid contact.
pub(super) fn is_rigid(case: &Case) -> bool {
    RIGID.contains(&case.name_at(LAW))
}

/// Whether the law of a case has this number.
pub(super) fn has(case: &Case, number: &Number) -> bool {
    law_of(case).is_some_and(|law| number.is_in(law.numbers))
}

/// Fills in the restitution of a law that has one.
pub(super) fn fill_restitution(case: &mut Case) {
    let row = LAW + rows::RESTITUTION;
    if has(case, &bars::RESTITUTION) {
        let default = if is_rigid(case) { 0.0 } else { 1.0 };
        case.values[row] = case.values[row].or(Some(Value::Number(default)));
    }
}

/// The law of a case in its scales; `None` where a parameter is not given. A linear spring has this stiffness; `mass` is m1 m2/(m1 +
/// m2) of the whole bars.
///
/// The secant stiffness of a law with delta^1.5 is that of the linear spring at the overlap under the exact force F0, which is 1
/// here, so that k_h = k_I^1.5.
pub fn law(case: &Case, method: Method, stiffness: f64, mass: f64) -> Option<ContactLaw> {
    let value = |number: &Number, row: usize| match number.key == bars::K_H.key {
        true => Some(stiffness * stiffness.sqrt()),
        false => case.at(row),
    };
    let impulses = f64::from(method.has_impulses());
    let form = form(law_of(case)?, value, [stiffness, mass, impulses])?;
    let law = form.given.law();
    (law.kind() == ContactKind::Impact).then_some(law)
}

/// The form of a law with these numbers.
fn form(
    law: &Own,
    value: impl Fn(&Number, usize) -> Option<f64>,
    [stiffness, mass, impulses]: [f64; 3],
) -> Option<Form> {
    let others = [
        ("k", stiffness),
        ("colliding_mass", mass),
        ("impulses", impulses),
    ];
    let form = |given: &GivenNumbers| (law.offered.offer.form)(given).ok();
    law.make(value, &others, form)
}
