//! Rayleigh and modal damping of a structure.

use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::source::tree::Tree;
use crate::structure::keys::{MODAL_DAMPING, RAYLEIGH, STRUCTURE, names, range};
use crate::structure::reading::reader::{Reader, open};
use slipgap_problem::problem::structure::given::amount::Amount;
use slipgap_problem::problem::structure::parts::damping::{ModalDamping, Pair, Rayleigh};

/// The factors of M and K in C, or two damping ratios from which they follow.
pub(in crate::structure) fn rayleigh(
    object: &Object,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Rayleigh> {
    let node = object.get("rayleigh")?;
    let object = open(node, &object.path("rayleigh"), RAYLEIGH, faults)?;
    let [mass, stiffness, ratios, modes, periods] = names(RAYLEIGH)[..] else {
        return None;
    };
    let factors = [mass, stiffness];
    if let Some(alone) = [modes, periods]
        .into_iter()
        .find(|key| object.get(key).is_some())
        && object.get(ratios).is_none()
    {
        faults.add(node.at, &object.path(alone), "needs \"ratios\"");
    }
    if object.get(ratios).is_none() {
        let given = |key| reader.optional(&object, key, range(RAYLEIGH, key), faults);
        return Some(Rayleigh::Factors(factors.map(given)));
    }
    if factors.iter().any(|key| object.get(key).is_some()) {
        object.fault(
            "has ratios or the factors mass and stiffness, not both",
            faults,
        );
    }
    let of = match (object.get(modes), object.get(periods)) {
        (Some(_), None) => pair(&object, modes, reader, faults).map(Pair::Modes),
        (None, Some(_)) => pair(&object, periods, reader, faults).map(Pair::Periods),
        (None, None) | (Some(_), Some(_)) => {
            object.fault("needs modes or periods beside ratios, one of them", faults);
            None
        }
    };
    let ratios = pair(&object, ratios, reader, faults);
    let (ratios, of) = ratios.zip(of)?;
    Some(Rayleigh::Ratios { ratios, of })
}

/// Two numbers of `rayleigh`.
fn pair(object: &Object, key: &str, reader: &Reader, faults: &mut Faults) -> Option<[Amount; 2]> {
    let before = faults.count();
    let numbers = object.items(key, faults, |node, path, faults| {
        reader.amount(node, path, range(RAYLEIGH, key), faults)
    });
    let count = numbers.len();
    let pair: Option<[Amount; 2]> = numbers.try_into().ok();
    if pair.is_none() && faults.count() == before {
        let at = object.get(key).map_or(0, |node| node.at);
        let message = format!("must be two numbers, got {count}");
        faults.add(at, &object.path(key), message);
    }
    pair
}

/// One damping ratio of all modes, or one for each.
pub(in crate::structure) fn modal_damping(
    object: &Object,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<ModalDamping> {
    let key = MODAL_DAMPING;
    let node = object.get(key)?;
    match &node.tree {
        Tree::List(_) => {
            let ratios = object.items(key, faults, |node, path, faults| {
                reader.amount(node, path, range(STRUCTURE, key), faults)
            });
            Some(ModalDamping::Each(ratios))
        }
        Tree::Object(_) | Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => {
            let ratio = reader.optional(object, key, range(STRUCTURE, key), faults)?;
            Some(ModalDamping::Every(ratio))
        }
    }
}
