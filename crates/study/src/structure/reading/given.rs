//! The members of a study by their keys, before the structure is read, and the names that parameters choose from.

use crate::source::faults::join;
use crate::source::tree::{Member, Node, Tree};

/// The names that a parameter chooses from, each with its meaning.
pub(in crate::structure) type Choices = &'static [(&'static str, &'static str)];

/// The members of an object; none of another value.
pub(crate) fn members(node: &Node) -> &[Member] {
    match &node.tree {
        Tree::Object(members) => members,
        Tree::List(_) | Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => &[],
    }
}

/// The value of a key of an object.
pub(crate) fn member<'a>(node: &'a Node, key: &str) -> Option<&'a Node> {
    let mut members = members(node).iter();
    members
        .find(|member| member.key == key)
        .map(|member| &member.node)
}

/// The members of all `parameters` of a study, each with its path.
pub(in crate::structure) fn given(root: &Node) -> Vec<(&Member, String)> {
    let of = |node: &Node, path: &str| -> Vec<(usize, String)> {
        let members = members(node).iter().enumerate();
        let real = members.filter(|(_, member)| member.key != "//");
        real.map(|(i, member)| (i, join(path, &member.key)))
            .collect()
    };
    let mut found = Vec::new();
    let mut add = |node, path: &str| {
        for (i, path) in of(node, path) {
            found.push((&members(node)[i], path));
        }
    };
    if let Some(node) = member(root, "parameters") {
        add(node, "parameters");
    }
    if let Some(Tree::List(blocks)) = member(root, "blocks").map(|node| &node.tree) {
        for (i, block) in blocks.iter().enumerate() {
            if let Some(node) = member(block, "parameters") {
                add(node, &format!("blocks[{i}].parameters"));
            }
        }
    }
    found
}

/// The texts of a value: of one text, or of a list.
pub(crate) fn texts(node: &Node) -> Vec<&str> {
    match &node.tree {
        Tree::Text(text) => vec![text],
        Tree::List(items) => items.iter().flat_map(texts).collect(),
        Tree::Object(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => Vec::new(),
    }
}

/// Every text under `key` anywhere in a tree.
pub(in crate::structure) fn under<'a>(node: &'a Node, key: &str, found: &mut Vec<&'a str>) {
    match &node.tree {
        Tree::Object(members) => {
            for member in members {
                if member.key == key {
                    found.extend(texts(&member.node));
                }
                under(&member.node, key, found);
            }
        }
        Tree::List(items) => items.iter().for_each(|item| under(item, key, found)),
        Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => {}
    }
}

/// Whether one of these keys is anywhere in a tree.
pub(in crate::structure) fn has_key(node: &Node, keys: &[&str]) -> bool {
    match &node.tree {
        Tree::Object(members) => members
            .iter()
            .any(|member| keys.contains(&member.key.as_str()) || has_key(&member.node, keys)),
        Tree::List(items) => items.iter().any(|item| has_key(item, keys)),
        Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => false,
    }
}

/// The parameters whose values are names: those that choose a law or a record, and labels.
pub(in crate::structure) struct Choosing {
    /// Those that choose a law or a file, with what they choose from.
    pub parts: Vec<(String, Choices)>,
    /// Labels, with their texts.
    pub labels: Vec<(String, Choices)>,
}

/// A table of names that lives as long as the program, one for equal lists.
pub(in crate::structure) fn interned_choices(names: Vec<(&'static str, &'static str)>) -> Choices {
    use std::collections::BTreeSet;
    use std::sync::{Mutex, PoisonError};
    static TABLES: Mutex<BTreeSet<Choices>> = Mutex::new(BTreeSet::new());
    let mut tables = TABLES.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = tables.get(&names[..]) {
        return known;
    }
    let table: Choices = Box::leak(names.into_boxed_slice());
    tables.insert(table);
    table
}
