//! What a metric is divided by: the metric of a case that differs in some parameters only.

use slipgap_study::faults::{Faults, join};
use slipgap_study::scope::Scope;
use slipgap_study::tree::Node;
use slipgap_study::{Filter, Reference};

/// Most pairs of cases that are compared to find the partners. This takes less than a second.
const MOST_PAIRS: u64 = 10_000_000;

/// Decodes `over`. Every case that `chosen` selects must have one partner.
pub(super) fn over(
    node: &Node,
    path: &str,
    chosen: &Filter,
    scope: &Scope,
    faults: &mut Faults,
) -> Option<Reference> {
    let filter = scope.filter(node, path, faults)?;
    if filter.0.is_empty() {
        faults.must_be(node, path, "an object with at least one parameter");
        return None;
    }
    let table = scope.problem.parameters();
    if let Some((row, _)) = filter.0.iter().find(|(_, wanted)| wanted.len() > 1) {
        let message = "must be one value, since a metric is divided by that of one case";
        faults.add(node.at, &join(path, &table[*row].name), message);
        return None;
    }
    let over = Reference::new(filter, &*scope.problem, &scope.blocks);
    match fault(&over, chosen, scope) {
        Some(message) => {
            faults.add(node.at, path, message);
            None
        }
        None => Some(over),
    }
}

/// The first case without partner or with several, as a message.
fn fault(over: &Reference, chosen: &Filter, scope: &Scope) -> Option<String> {
    let [cases, others] = [chosen, &over.filter].map(|filter| scope.select(filter).count() as u64);
    if cases.saturating_mul(others) > MOST_PAIRS {
        return Some(format!(
            "compares {cases} cases with {others} others; allowed: at most {MOST_PAIRS} pairs; choose fewer in \"where\""
        ));
    }
    over.fault(chosen, scope, "\"over\"")
}
