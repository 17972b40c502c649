//! Labels of cases: parameters that no part of the structure contains, in a `zip` with parameters that it does.

use crate::source::faults::{Faults, quoted};
use crate::source::tree::{Node, Tree};
use crate::structure::reading::given::{
    Choices, Choosing, given, interned_choices, members, texts,
};
use slipgap_problem::problem::expression::Formula;
use slipgap_problem::problem::expression::unprintable;
use slipgap_problem::problem::interned;
use slipgap_problem::problem::numbers::parameter::LABEL;
use slipgap_problem::problem::structure::tables::schema::{FIXED, named, of_method};

/// The parameters whose values are texts that are no numbers and that neither the structure nor another parameter contains, with
/// their texts.
pub(in crate::structure) fn labels(structure: &Node, root: &Node) -> Vec<(String, Choices)> {
    let given = given(root);
    let mut names: Vec<&str> = Vec::new();
    for (member, _) in &given {
        if !names.contains(&member.key.as_str()) {
            names.push(&member.key);
        }
    }
    let numbers: Vec<_> = names.iter().map(|name| named(name)).collect();
    let fixed = |name: &str| of_method(name) || FIXED.iter().any(|fixed| fixed.0 == name);
    let mut found = Vec::new();
    for name in names.iter().copied().filter(|name| !fixed(name)) {
        let own = || given.iter().filter(|(member, _)| member.key == name);
        let values: Vec<&str> = own().flat_map(|(member, _)| texts(&member.node)).collect();
        let only_texts = own().all(|(member, _)| is_text(&member.node));
        let number = |text: &&str| Formula::number(text, &numbers).is_ok();
        if !only_texts || values.iter().all(number) {
            continue;
        }
        let mut others = given.iter().filter(|(member, _)| member.key != name);
        if contains(structure, name) || others.any(|(member, _)| contains(&member.node, name)) {
            continue;
        }
        let mut choices: Vec<(&str, &str)> = Vec::new();
        for text in values.into_iter().map(interned) {
            if !choices.iter().any(|known| known.0 == text) {
                choices.push((text, LABEL));
            }
        }
        found.push((name.to_owned(), interned_choices(choices)));
    }
    found
}

/// Whether a value is a text or a list of texts.
fn is_text(node: &Node) -> bool {
    node.items().iter().all(|item| item.text().is_some())
}

/// Whether a text of a tree contains a name.
fn contains(node: &Node, name: &str) -> bool {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    match &node.tree {
        Tree::Text(text) => text.split(|c| !is_part(c)).any(|word| word == name),
        Tree::List(items) => items.iter().any(|item| contains(item, name)),
        Tree::Object(members) => members
            .iter()
            .any(|member| member.key != "//" && contains(&member.node, name)),
        Tree::Number(_) | Tree::Bool(_) | Tree::Null => false,
    }
}

/// Whether every list of values of a parameter is in a `zip` with a parameter that `used` accepts, and there is such a list.
pub(in crate::structure) fn is_label(root: &Node, name: &str, used: &dyn Fn(&str) -> bool) -> bool {
    let blocks = root.get("blocks").and_then(Node::list);
    let mut lists = 0;
    for block in std::iter::once(root).chain(blocks.unwrap_or_default()) {
        let Some(parameters) = block.get("parameters") else {
            continue;
        };
        let own = members(parameters).iter().find(|own| own.key == name);
        if !own.is_some_and(|own| matches!(own.node.tree, Tree::List(_) | Tree::Object(_))) {
            continue;
        }
        lists += 1;
        let groups = block.get("zip").and_then(Node::list).unwrap_or_default();
        let zipped = groups.iter().map(texts).any(|group| {
            group.contains(&name) && group.iter().any(|other| *other != name && used(other))
        });
        if !zipped {
            return false;
        }
    }
    lists > 0
}

/// Characters with which a spreadsheet takes a cell for a formula.
const FORMULA: [char; 4] = ['=', '+', '-', '@'];

/// Reports labels and names of records that no cell of a table can show as they are. A table has them without a mark that keeps
/// them from being a formula, so that programs read the same text as in the study.
pub(in crate::structure) fn report_texts_of_tables(
    node: &Node,
    path: &str,
    name: &str,
    choices: &Choosing,
    faults: &mut Faults,
) {
    let mut chosen = choices.parts.iter().chain(&choices.labels);
    if !chosen.any(|known| known.0 == name) {
        return;
    }
    match &node.tree {
        Tree::List(items) => {
            for (i, item) in items.iter().enumerate() {
                report_texts_of_tables(item, &format!("{path}[{i}]"), name, choices, faults);
            }
        }
        Tree::Text(text) => {
            if let Some(c) = unprintable(text) {
                let message =
                    format!("must be a string of printable characters on one line, got {c}");
                faults.add(node.at, path, message);
            } else if text.trim_start().starts_with(FORMULA) {
                let message = format!(
                    "must not begin with =, +, - or @, because a spreadsheet takes {} in results.csv for a formula",
                    quoted(text)
                );
                faults.add(node.at, path, message);
            }
        }
        Tree::Object(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => {}
    }
}
