//! Rayleigh and modal damping of a structure.

use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::structure::keys::{MODAL_DAMPING, RAYLEIGH};
use crate::structure::reading::reader::Reader;
use slipgap_problem::problem::structure::given::amount::Amount;
use slipgap_problem::problem::structure::parts::damping::{ModalDamping, Pair, Rayleigh};

/// The factors of M and K in C, or two damping ratios from which they follow.
pub(in crate::structure) fn rayleigh(
    object: &Object,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Rayleigh> {
    let (node, path) = object.given("rayleigh", faults)?;
    let object = Object::open(node, &path, &RAYLEIGH, faults)?;
    let given = |key: &&str| object.get(key).is_some();
    let factors = ["mass", "stiffness"];
    if !given(&"ratios") {
        if let Some(alone) = ["modes", "periods"].iter().find(|key| given(key)) {
            faults.add(node.at, &object.path(alone), "needs \"ratios\"");
        }
        let number = |key| reader.number(&object, key, faults);
        return Some(Rayleigh::Factors(factors.map(number)));
    }
    if factors.iter().any(given) {
        object.fault(
            "has ratios or the factors mass and stiffness, not both",
            faults,
        );
    }
    let of = match (given(&"modes"), given(&"periods")) {
        (true, false) => pair(&object, "modes", reader, faults).map(Pair::Modes),
        (false, true) => pair(&object, "periods", reader, faults).map(Pair::Periods),
        (false, false) | (true, true) => {
            object.fault("needs modes or periods beside ratios, one of them", faults);
            None
        }
    };
    let ratios = pair(&object, "ratios", reader, faults);
    let (ratios, of) = ratios.zip(of)?;
    Some(Rayleigh::Ratios { ratios, of })
}

/// Two numbers of `rayleigh`.
fn pair(object: &Object, key: &str, reader: &Reader, faults: &mut Faults) -> Option<[Amount; 2]> {
    let before = faults.count();
    let numbers = object.items(key, faults, |node, path, faults| {
        reader.amount(node, path, object.range(key), faults)
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
    if object.get(key)?.list().is_none() {
        return reader.number(object, key, faults).map(ModalDamping::Every);
    }
    let ratios = object.items(key, faults, |node, path, faults| {
        reader.amount(node, path, object.range(key), faults)
    });
    Some(ModalDamping::Each(ratios))
}
