//! Damping and impacts that are given twice, and no damping at all.

use super::doubt::Doubt;
use crate::contact::ContactKind;
use crate::problem::Case;
use crate::problem::structure::given::amount::Amount;
use crate::problem::structure::given::source::Kind;
use crate::problem::structure::parts::contact::Contact;
use crate::problem::structure::parts::damping::ModalDamping;
use crate::problem::structure::parts::template::{SpringNumbers, Template};
use crate::solve::Warning;
use crate::system::structure::Structure;
use std::collections::BTreeMap;

/// Damping in all modes beside other damping.
pub fn damped(template: &Template, case: &Case) -> Option<Doubt> {
    let acts = |amount: &Amount| amount.value(case).is_ok_and(|value| value != 0.0);
    let ratio = template
        .springs
        .iter()
        .find_map(|spring| match &spring.numbers {
            SpringNumbers::Period { ratio, .. } => ratio.as_ref().filter(|ratio| acts(ratio)),
            SpringNumbers::Stiffness { .. } => None,
        });
    let matrices = template.matrices.iter().find(|block| {
        let damping = block.in_case(case).damping.iter();
        damping
            .flat_map(|matrix| matrix.entries())
            .any(|(_, c)| c != 0.0)
    });
    let modal = template
        .modal_damping
        .iter()
        .flat_map(ModalDamping::amounts)
        .find(|ratio| acts(ratio));
    let amounts = template.rayleigh.amounts();
    let rayleigh = amounts.into_iter().find(|amount| acts(amount));
    let of_parts = ratio.is_some() || matrices.is_some();
    let given = [modal.is_some(), rayleigh.is_some(), of_parts];
    if given.iter().filter(|given| **given).count() < 2 {
        return None;
    }
    let parts = ratio
        .map(|ratio| ratio.path.clone())
        .or_else(|| matrices.map(|block| format!("{}.C", block.place.1)));
    let found = [
        modal.map(|amount| amount.path.clone()),
        rayleigh.map(|amount| amount.path.clone()),
        parts,
    ];
    let paths: Vec<String> = found.into_iter().flatten().collect();
    Some((Warning::DampedTwice, paths.join(" and ")))
}

/// Impacts under an earthquake without any damping.
pub fn none(template: &Template, case: &Case, structure: &Structure) -> Option<Doubt> {
    let impact = structure
        .contacts
        .iter()
        .find(|contact| contact.law.kind() == ContactKind::Impact)?;
    let ground = template.ground.iter().map(|(_, ground)| ground);
    let supports = template
        .supports
        .iter()
        .filter_map(|support| support.acceleration());
    let is_earthquake = ground.chain(supports).any(|motion| {
        let moves = |kind: &Kind| matches!(kind, Kind::Record { .. } | Kind::Synthetic { .. });
        let scale = motion.scale.as_ref().map(|scale| scale.value(case));
        moves(motion.source.kind()) && scale != Some(Ok(0.0))
    });
    let is_undamped = || structure.damping.entries().all(|(_, c)| c == 0.0);
    (is_earthquake && is_undamped())
        .then(|| (Warning::Undamped, format!("contact {}", impact.name)))
}

/// Two impacts that are the same but for their names.
pub fn impacts(template: &Template, case: &Case, structure: &Structure) -> Option<Doubt> {
    let mut known: BTreeMap<Vec<(usize, u64)>, &Contact> = BTreeMap::new();
    let pairs = template.contacts.iter().zip(&structure.contacts);
    let mut impacts = pairs.filter(|(_, contact)| contact.law.kind() == ContactKind::Impact);
    impacts.find_map(|(given, contact)| {
        let terms = contact.along.iter();
        let along = terms.map(|(node, factor)| (*node, factor.to_bits()));
        let other = known.insert(along.collect(), given)?;
        (numbers(given, case) == numbers(other, case)).then(|| {
            let text = format!("contacts {} and {}", other.name, given.name);
            (Warning::ImpactsTwice, text)
        })
    })
}

/// A number of a law by its key.
type Number<'a> = (&'a str, Option<f64>);

/// The law, the gap and the numbers of a contact in a case.
fn numbers<'a>(contact: &'a Contact, case: &'a Case) -> (&'a str, Option<f64>, Vec<Number<'a>>) {
    let value = |amount: &Amount| amount.value(case).ok();
    let amounts = contact.numbers.iter();
    let numbers = amounts.map(|(key, amount)| (*key, value(amount)));
    (
        contact.law.name(case),
        contact.gap.as_ref().and_then(value),
        numbers.collect(),
    )
}
