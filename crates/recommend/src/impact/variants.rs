//! The contact laws, methods and mass matrices of a search.

use super::FixedParameters;
use crate::{Setting, Variant, setting};
use slipgap_contact::contact::WhichLaw;
use slipgap_contact::contact::numbers::bars::RESTITUTION;
use slipgap_contact::contact::offer::{Offered, Place};
use slipgap_problem::problem::impact::BarImpact;

/// Targets of the restitution of laws with damping; without damping they are other laws of the list.
const RESTITUTIONS: [f64; 2] = [0.65, 0.9];

/// The same for a law that the user fixes.
const RESTITUTIONS_OF_ONE: [f64; 3] = [0.65, 0.9, 1.0];

/// Restitutions of the ends of the bars with rigid contact in the method of impulses.
const RIGID: [f64; 3] = [0.0, 0.5, 1.0];

/// All variants of the problem's tables, or those that the user does not exclude.
pub fn variants(fixed: &FixedParameters) -> Vec<Variant> {
    let only = fixed.choice.law;
    let laws = setting::choices(&BarImpact, "law").into_iter();
    // The force of rigid contact depends on the step: an answer for it holds with its own step only.
    let laws = laws.filter(|name| only.map_or(!is_rigid(name), |only| only == *name));
    let masses = masses(fixed.mass);
    let mut variants = Vec::new();
    for name in laws {
        for method in setting::methods(&BarImpact, fixed.choice.method) {
            for law in law(name, method.name, only.is_some()) {
                for mass in &masses {
                    let mass = Some(*mass);
                    let (law, method) = (law.clone(), method.clone());
                    variants.push(Variant { law, method, mass });
                }
            }
        }
    }
    variants
}

/// The mass matrices that are searched.
pub fn masses(only: Option<&'static str>) -> Vec<&'static str> {
    match only {
        Some(mass) => vec![mass],
        None => setting::choices(&BarImpact, "mass"),
    }
}

/// Whether a law is rigid contact.
pub fn is_rigid(name: &str) -> bool {
    Offered::named(Place::Bars, name).is_some_and(|law| law.law == WhichLaw::Rigid)
}

/// Whether rigid contact has a restitution with the method of this name.
pub fn has_impulses(method: &str) -> bool {
    setting::method_named(method).is_some_and(|method| method.has_impulses())
}

/// A law with a short list of restitutions.
fn law(name: &'static str, method: &str, one: bool) -> Vec<Setting> {
    let own = Offered::named(Place::Bars, name).and_then(|law| law.at(Place::Bars));
    let damped = own.is_some_and(|own| RESTITUTION.is_in(own.numbers));
    match is_rigid(name) {
        true if has_impulses(method) => Setting::each(name, "restitution", &RIGID),
        true => vec![Setting::new(name)],
        false if !damped => vec![Setting::new(name)],
        _ if one => Setting::each(name, "restitution", &RESTITUTIONS_OF_ONE),
        _ => Setting::each(name, "restitution", &RESTITUTIONS),
    }
}
