//! Lists of one length, such as times and values.

use crate::source::faults::Faults;
use crate::source::tree::{Node, Tree};
use crate::structure::keys::Keys;
use crate::structure::reading::reader::{Reader, open};
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_problem::problem::structure::given::amount::Amount;

/// Lists of one length under two keys, such as times and values.
pub(in crate::structure) fn table(
    node: &Node,
    path: &str,
    (keys, [times, values]): (Keys, [&str; 2]),
    reader: &Reader,
    faults: &mut Faults,
) -> Option<[Vec<Amount>; 2]> {
    let object = open(node, path, keys, faults)?;
    let mut list = |key: &str| {
        let node = object.need(key, "a list of numbers", faults)?;
        let path = object.path(key);
        let Tree::List(items) = &node.tree else {
            faults.must_be(node, &path, "a list of numbers");
            return None;
        };
        let before = faults.count();
        let read = items.iter().enumerate().filter_map(|(i, item)| {
            reader.amount(item, &format!("{path}[{i}]"), Range::Any, faults)
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
