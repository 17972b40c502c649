//! Springs and dashpots.

use crate::source::faults::Faults;
use crate::source::field::Kind;
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::structure::contacts::plane;
use crate::structure::keys::SPRING;
use crate::structure::reading::reader::Reader;
use slipgap_problem::problem::structure::given::amount::{Amount, Source};
use slipgap_problem::problem::structure::parts::template::{Spring, SpringNumbers};

/// A spring, or one in each of two directions.
pub(in crate::structure) fn springs(
    node: &Node,
    path: &str,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Vec<Spring>> {
    let object = Object::open(node, path, &SPRING, faults)?;
    let name = object.text("name", faults).unwrap_or_default();
    let Some(node) = object.get("directions") else {
        let along = reader.along(&object, "a spring", faults);
        let numbers = numbers(&object, None, reader, faults);
        return Some(vec![Spring {
            name,
            along: along?,
            numbers: numbers?,
        }]);
    };
    if let Some(node) = object.get("along").or(object.get("direction")) {
        let message = "a spring with directions has between, and no along and no direction";
        faults.add(node.at, &object.path("directions"), message);
        return None;
    }
    let directions = plane::directions(node, &object.path("directions"), faults);
    let numbers_of_both = SPRING.fields();
    for field in numbers_of_both.filter(|field| matches!(field.kind, Kind::Several(..))) {
        let items = object.get(field.name).and_then(Node::list);
        if items.is_some_and(|items| items.len() != 2) {
            let message = format!("{} has a number for each direction, 2", field.name);
            object.fault(message, faults);
            return None;
        }
    }
    let pairs = plane::in_directions(&object, directions?, faults)?;
    let mut both = Vec::new();
    for (index, ([i, j], direction)) in pairs.into_iter().zip(directions?).enumerate() {
        let first = reader.side(&i.0, i.1, -1.0, faults);
        let second = reader.side(&j.0, j.1, 1.0, faults);
        let numbers = numbers(&object, Some(index), reader, faults);
        let ((_, mut along), (_, others)) = (first?, second?);
        along.extend(others);
        both.push(Spring {
            name: match name.is_empty() {
                true => String::new(),
                false => format!("{name}.{}", direction.name()),
            },
            along,
            numbers: numbers?,
        });
    }
    Some(both)
}

/// k and c, or a mass with its period; of the direction at this place.
fn numbers(
    object: &Object,
    index: Option<usize>,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<SpringNumbers> {
    let has = |key: &str| object.get(key).is_some();
    let by_period = ["mass", "period", "ratio"].map(has).contains(&true);
    if by_period && ["k", "c"].map(has).contains(&true) {
        object.fault("give k and c, or mass, period and ratio, not both", faults);
        return None;
    }
    let optional = |key: &str, faults: &mut Faults| {
        let (node, path) = object.given(key, faults)?;
        let (node, path) = match (node.list(), index) {
            (Some(items), Some(index)) => (items.get(index)?, format!("{path}[{index}]")),
            _ => (node, path),
        };
        reader.amount(node, &path, object.range(key), faults)
    };
    let needed = |key: &str, faults: &mut Faults| {
        object.needed(key, faults)?;
        optional(key, faults)
    };
    if by_period {
        let mut need = |key| needed(key, faults);
        let (mass, period) = (need("mass"), need("period"));
        let ratio = optional("ratio", faults);
        return Some(SpringNumbers::Period {
            mass: mass?,
            period: period?,
            ratio,
        });
    }
    let c = optional("c", faults);
    let k = match (object.get("k"), &c) {
        // A dashpot alone.
        (None, Some(c)) => Some(zero(c)),
        (None, None) => {
            object.fault("missing: k and c, or mass, period and ratio", faults);
            None
        }
        (Some(_), _) => needed("k", faults),
    };
    Some(SpringNumbers::Stiffness { k: k?, c })
}

/// The number 0 at the place of another.
fn zero(at: &Amount) -> Amount {
    Amount {
        source: Source::Number(0.0),
        ..at.clone()
    }
}
