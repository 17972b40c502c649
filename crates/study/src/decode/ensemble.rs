//! The key `ensemble` of a study.

use crate::cases::ensemble::refuse_constant;
use crate::cases::scope::{Scope, names};
use crate::source::faults::Faults;
use crate::source::object::Object;

/// Most combinations of a study with an ensemble: its metrics are in memory together.
const MOST: u64 = 10_000_000;

/// Decodes the key; `None` without it, empty if it has a fault.
pub(super) fn ensemble(object: &Object, scope: &Scope, faults: &mut Faults) -> Option<Vec<usize>> {
    let node = object.get("ensemble")?;
    let (path, before) = (object.path("ensemble"), faults.count());
    let listed = names(node, &path, "parameter", &scope.parameters(), faults);
    let rows = listed.unwrap_or_default();
    let blocks = scope.blocks.iter();
    let count = blocks.fold(0, |sum: u64, block| sum.saturating_add(block.raw_len()));
    if count > MOST {
        let message = format!("{count} combinations; a study with an ensemble has at most {MOST}");
        faults.add(node.at, &path, message);
    } else if !scope.blocks.is_empty() {
        for (i, row) in rows.iter().enumerate() {
            refuse_constant(scope, *row, "an ensemble", node.item(&path, i), faults);
        }
    }
    Some(if faults.count() > before {
        Vec::new()
    } else {
        rows
    })
}
