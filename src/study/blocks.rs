//! The blocks of a study: one in `parameters`, or several in `blocks`.

use super::Block;
use super::object::Object;
use super::parameters::{Draft, parameters};
use super::report::Faults;
use super::rules;
use super::tree::{Node, Tree};
use crate::problem::Problem;

/// The blocks; none if one of them could not be decoded.
pub(super) fn blocks(
    object: &Object,
    problem: Option<&'static dyn Problem>,
    faults: &mut Faults,
) -> Vec<Block> {
    let before = faults.count();
    let (one, several) = (object.get("parameters"), object.get("blocks"));
    match (one, several) {
        (Some(_), Some(node)) => {
            let message = "stands in place of \"parameters\"; give one of the two";
            faults.add(node.at, "blocks", message);
        }
        (None, None) => {
            let what = "the parameters of the cases, or \"blocks\" of them";
            object.missing("parameters", what, faults);
        }
        _ => {}
    }
    // Both are decoded even so: every fault is told at once.
    let mut drafts = Vec::new();
    if let (Some(node), Some(problem)) = (one, problem) {
        drafts.extend(parameters(node, "parameters", problem.parameters(), faults));
    }
    drafts.extend(object.items("blocks", faults, |node, path, faults| {
        block(node, path, problem, faults)
    }));
    if let (None, Some(node)) = (one, several)
        && matches!(&node.tree, Tree::List(blocks) if blocks.is_empty())
    {
        faults.must_be(node, "blocks", "a list of at least one block");
    }
    let whole = faults.count() == before;
    let key = if several.is_some() {
        "blocks"
    } else {
        "parameters"
    };
    let at = several.or(one).map_or(0, |node| node.at);
    if !rules::count(&drafts, at, key, faults) {
        return Vec::new();
    }
    if let Some(problem) = problem {
        for draft in &drafts {
            rules::check(problem, draft, faults);
        }
    }
    // A case that breaks a rule is still a case that figures and checks may mean.
    match whole {
        true => drafts.iter().map(Draft::block).collect(),
        false => Vec::new(),
    }
}

/// One item of `blocks`.
fn block(
    node: &Node,
    path: &str,
    problem: Option<&'static dyn Problem>,
    faults: &mut Faults,
) -> Option<Draft> {
    let object = Object::open(node, path, &["parameters"], faults)?;
    let node = object.need("parameters", "the parameters of the block", faults)?;
    parameters(
        node,
        &object.path("parameters"),
        problem?.parameters(),
        faults,
    )
}
