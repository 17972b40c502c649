//! The law of a contact in a case.

mod limit;

use super::contact::{Contact, Normal};
use crate::contact::number::Number;
use crate::contact::numbers::structure::TABLE;
use crate::contact::offer::{Offered, Place};
use crate::contact::{ContactKind, GivenNumbers, LAWS, LawFault};
use crate::problem::offered_laws::laws;
use crate::problem::structure::given::amount::Amount;
use crate::problem::{Case, Violation};
use crate::system::structure::{Limit, PressedBy, StructureLaw};
use limit::limit;
use serde_json::{Map, Value};
use std::sync::LazyLock;

/// The laws of contacts, each with its meaning.
pub static NAMES: &[(&str, &str)] = laws!(Structure, Which::All);

/// The law of this name.
pub fn law_named(name: &str) -> Option<&'static Offered> {
    Offered::named(Place::Structure, name)
}

/// The numbers of a contact with this law, as a study has them: those that `number` gives by their keys.
pub fn written_numbers(law: &str, number: impl Fn(&str) -> Option<f64>) -> Map<String, Value> {
    let offer = law_named(law).and_then(|law| law.at(Place::Structure));
    let keys = offer.map_or(&[][..], |offer| offer.numbers).iter();
    let given = keys.filter_map(|row| Some((row.key.to_owned(), number(row.key)?.into())));
    given.collect()
}

/// The numbers of contacts: those of several laws, then those that only one has.
pub static NUMBERS: LazyLock<Vec<&'static Number>> = LazyLock::new(|| {
    let mut numbers = TABLE.to_vec();
    for number in LAWS.iter().flat_map(Offered::structure_numbers) {
        if !number.is_in(&numbers) {
            numbers.push(number);
        }
    }
    numbers
});

/// The meaning of a number, with the laws that have it.
pub fn meaning(number: &Number) -> String {
    let names = |friction: bool| {
        let having = LAWS.iter().filter(|law| law.has(number.key));
        let of_kind = having.filter(|law| !friction || law.kind == ContactKind::Friction);
        let names: Vec<&str> = of_kind.map(|law| law.offer.name).collect();
        match names[..] {
            [ref first @ .., last] if !first.is_empty() => {
                format!("{} and {last}", first.join(", "))
            }
            _ => names.concat(),
        }
    };
    let text = number.meaning.replace("{laws}", &names(false));
    let text = text.replace("{friction}", &names(true));
    let imk_laws = "imk-bilinear, imk-peak-oriented and imk-pinching";
    text.replace(&format!(", {imk_laws}"), " and imk laws")
        .replace(imk_laws, "imk laws")
}

/// The law of a contact in a case.
///
/// `pressed_by` is what the normal force names. Without samples, sampled functions of time are only checked, and the limit is the one
/// at rest.
///
/// # Errors
/// A number that the law needs is missing or out of its range.
pub fn relation(
    contact: &Contact,
    case: &Case,
    metre: f64,
    (pressed_by, with_samples): (PressedBy, bool),
) -> Result<StructureLaw, Violation> {
    let name = contact.law.name(case);
    let Some((law, offer)) = law_named(name).and_then(|law| Some((law, law.offer.structure?)))
    else {
        return Err(violation(contact, format!("no law \"{name}\"")));
    };
    let (limit, at_rest) = match law.kind {
        ContactKind::Friction => limit(contact, case, metre, (pressed_by, with_samples))?,
        ContactKind::Impact | ContactKind::Link => (Limit::constant(0.0), 0.0),
    };
    let values = offer
        .numbers
        .iter()
        .map(|number| contact.value(number.key, case))
        .collect::<Result<Vec<Option<f64>>, Violation>>()?;
    let mut others = vec![("limit", at_rest)];
    if law.kind == ContactKind::Friction {
        for key in ["nu", "pressure_exponent"] {
            others.extend(contact.value(key, case)?.map(|value| (key, value)));
        }
    }
    let given = GivenNumbers {
        law: law.offer.name,
        numbers: offer.numbers,
        values: &values,
        table: &contact.table(case)?,
        others: &others,
    };
    let form = (law.offer.form)(&given).map_err(|fault| {
        let of_parts = matches!(contact.normal, Some(Normal::Parts(_)));
        let LawFault::NoLimit { instead, .. } = fault else {
            return violation(contact, fault.to_string());
        };
        if !of_parts {
            return violation(contact, fault.to_string());
        }
        let presses = pressing_names(contact);
        let message = format!(
            "the force of {presses} presses it, and how much it does at rest follows from the equilibrium, which needs {instead}; give {instead} instead"
        );
        violation(contact, message)
    })?;
    Ok(StructureLaw::new(form, limit))
}

/// The names of the contacts and springs that press a contact.
fn pressing_names(contact: &Contact) -> String {
    match &contact.normal {
        Some(Normal::Parts(parts)) => {
            let names: Vec<&str> = parts.iter().map(|part| part.name.as_str()).collect();
            names.join(", ")
        }
        Some(Normal::Constant(_) | Normal::Table(_) | Normal::Weight { .. }) | None => {
            String::new()
        }
    }
}

/// The laws of contacts that push, whose forces may be a normal force.
pub fn pressing_laws() -> impl Iterator<Item = &'static str> {
    let laws = LAWS.iter().filter(|law| law.at(Place::Structure).is_some());
    laws.filter(|law| law.kind == ContactKind::Impact)
        .map(|law| law.offer.name)
}

/// The restitution of a rigid impact in a case, with its place in the study; `None` for another law.
pub fn restitution<'a>(contact: &'a Contact, case: &Case) -> Option<(&'a Amount, f64)> {
    let given = contact.number("e")?;
    let law = law_named(contact.law.name(case))?;
    let rigid = law.has("e") && !(law.has("k") && contact.number("k").is_some());
    Some((given, given.value(case).ok()?)).filter(|_| rigid)
}

/// A rule that a contact breaks.
pub fn violation(contact: &Contact, message: impl Into<String>) -> Violation {
    Violation {
        parameter: contact.place.1.clone().into(),
        message: message.into(),
        at: Some(contact.place.0),
    }
}
