//! The forms that `metrics` of a study may have, and the names that it may give.

use super::super::sources::{self, NAMED, members};
use crate::cases::scope::Scope;
use crate::source::faults::{Faults, join, quoted};
use crate::source::object::Object;
use crate::source::tree::{Member, Node, Tree};
use crate::value::text;
use slipgap_problem::problem::expression::{CONSTANTS, FUNCTIONS};

/// Reports items of `metrics` of another form.
pub(super) fn check_forms(node: &Node, faults: &mut Faults) {
    let what = "a list of metrics, or an object with their names";
    if !matches!(node.tree, Tree::List(_) | Tree::Object(_)) {
        faults.must_be(node, "metrics", what);
        return;
    }
    for (item, path) in sources::items(node, "metrics") {
        match &item.tree {
            Tree::Text(_) => {
                text(item, &path, faults);
            }
            Tree::Object(_) => members(item).for_each(|member| {
                check_entry(&member.node, &join(&path, &member.key), faults);
            }),
            Tree::List(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => faults.must_be(
                item,
                &path,
                "the name of a metric, or an object such as {\"drift\": \"max(a3 - a2)/h\"}",
            ),
        }
    }
}

/// Reports the faults of the form of a metric with a name.
fn check_entry(node: &Node, path: &str, faults: &mut Faults) {
    match &node.tree {
        Tree::Text(_) => {
            text(node, path, faults);
        }
        Tree::Object(_) => {
            let Some(object) = Object::open(node, path, &NAMED, faults) else {
                return;
            };
            object.given("value", faults);
            for member in &object.members {
                text(&member.node, &object.path(&member.key), faults);
            }
        }
        Tree::List(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => faults.must_be(
            node,
            path,
            "a string, or an object with value, unit and title",
        ),
    }
}

/// Why a metric cannot have a name; `None` if it can.
pub(super) fn refused(
    member: &Member,
    taken: bool,
    scope: &Scope,
    known: &[&str],
) -> Option<String> {
    let name = member.key.as_str();
    let shown = quoted(name);
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '_';
    if !name.chars().all(plain) || !name.starts_with(|c: char| c.is_ascii_alphabetic()) {
        return Some(format!(
            "{shown} cannot name a metric; a name is letters, digits and _, beginning with a letter"
        ));
    }
    let has_meaning = FUNCTIONS.iter().any(|function| function.0 == name)
        || CONSTANTS.contains(&name)
        || ["and", "or", "not", "case"].contains(&name);
    if has_meaning {
        return Some(format!(
            "{shown} has a meaning of its own; choose another name"
        ));
    }
    if scope.parameters().contains(&name) {
        return Some(format!("{shown} is a parameter; choose another name"));
    }
    if known.contains(&name) {
        return Some(format!(
            "{shown} is a metric of the problem; choose another name"
        ));
    }
    taken.then(|| format!("{shown} given twice"))
}
