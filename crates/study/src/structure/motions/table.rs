//! Lists of one length, such as times and values.

use crate::source::faults::Faults;
use crate::source::field::Keys;
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::structure::reading::reader::Reader;
use slipgap_problem::problem::structure::given::amount::Amount;

/// Lists of one length under the first two keys, such as times and values.
pub(in crate::structure) fn table(
    node: &Node,
    path: &str,
    keys: &Keys,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<[Vec<Amount>; 2]> {
    lists(&Object::open(node, path, keys, faults)?, reader, faults)
}

/// The lists of an object.
pub(super) fn lists(
    object: &Object,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<[Vec<Amount>; 2]> {
    let [times, values, ..] = object.keys().names()[..] else {
        return None;
    };
    let mut list = |key: &str| {
        let node = object.need(key, "a list of numbers", faults)?;
        let path = object.path(key);
        let Some(items) = node.list() else {
            faults.must_be(node, &path, "a list of numbers");
            return None;
        };
        let before = faults.count();
        let read = items.iter().enumerate().filter_map(|(i, item)| {
            reader.amount(item, &format!("{path}[{i}]"), object.range(key), faults)
        });
        let amounts: Vec<Amount> = read.collect();
        (faults.count() == before).then_some(amounts)
    };
    let (t, f) = (list(times), list(values));
    let (t, f) = (t?, f?);
    if t.len() != f.len() || t.is_empty() {
        let message = format!(
            "needs as many numbers in {times} as in {values}, at least one, got {} and {}",
            t.len(),
            f.len()
        );
        object.fault(message, faults);
        return None;
    }
    Some([t, f])
}
