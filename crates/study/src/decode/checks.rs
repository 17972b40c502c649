//! The key `checks` of a study.

use crate::cases::scope::Scope;
use crate::source::faults::{Faults, any_of};
use crate::source::field::{Keys, Kind, Rule, field, fields, needed};
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::value::name;
use crate::{Check, Filter};
use slipgap_problem::problem::numbers::parameter::shortest;

/// The keys of a check.
pub(crate) const KEYS: Keys = Keys::new(&fields![
    /// the metric to check
    needed("metric", Kind::Shared("column")),
    /// which cases to check: a value or a list for parameters
    field("where", Kind::Shared("where")),
    /// smallest value allowed
    field("min", Kind::Constant),
    /// largest value allowed
    field("max", Kind::Constant),
])
.rules(&[Rule::Any(&["min", "max"], &[])]);

/// Decodes a check; `None` if it has a fault.
pub(crate) fn check(node: &Node, path: &str, scope: &Scope, faults: &mut Faults) -> Option<Check> {
    let before = faults.count();
    let object = Object::open(node, path, &KEYS, faults)?;
    let metrics = scope.metrics();
    let metric = object
        .need("metric", &format!("one of {}", any_of(&metrics)), faults)
        .and_then(|node| name(node, &object.path("metric"), "metric", &metrics, faults));
    let filter = match object.get("where") {
        Some(node) => scope.filter(node, &object.path("where"), faults),
        None => Some(Filter::default()),
    };
    let mut limit = |key: &str| {
        let node = object.get(key)?;
        object.number(key, faults).map(|x| (x, node))
    };
    let (min, max) = (limit("min"), limit("max"));
    if object.get("min").is_none() && object.get("max").is_none() {
        object.fault("missing: \"min\", \"max\" or both", faults);
    }
    if let (Some((min, _)), Some((max, node))) = (min, max)
        && min > max
    {
        let (min, max) = (shortest(min), shortest(max));
        let message = format!("must be >= min = {min}, got {max}");
        faults.add(node.at, &object.path("max"), message);
    }
    if faults.count() > before {
        return None;
    }
    Some(Check {
        metric: metric?,
        filter: filter?,
        min: min.map(|limit| limit.0),
        max: max.map(|limit| limit.0),
    })
}
