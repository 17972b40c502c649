//! The members and items of a study that is edited.

use crate::source::tree::{Member, Node, Tree};

pub(super) fn list(items: Vec<Node>) -> Node {
    Node {
        at: 0,
        tree: Tree::List(items),
    }
}

pub(super) fn items(node: Option<Node>) -> Vec<Node> {
    match node.map(|node| node.tree) {
        Some(Tree::List(items)) => items,
        _ => Vec::new(),
    }
}

pub(super) fn members(node: &mut Node) -> Option<&mut Vec<Member>> {
    match &mut node.tree {
        Tree::Object(members) => Some(members),
        Tree::List(_) | Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => None,
    }
}

/// Puts a value under a key, at the end of the object if it is new.
pub(super) fn put(node: &mut Node, key: &str, value: Node) {
    if let Some(present) = node.member(key) {
        *present = value;
    } else if let Some(members) = members(node) {
        members.push(Member {
            key: key.to_owned(),
            at: 0,
            node: value,
        });
    }
}

/// Takes the value of a key.
pub(super) fn take(node: &mut Node, key: &str) -> Option<Node> {
    let members = members(node)?;
    let index = members.iter().position(|member| member.key == key)?;
    Some(members.remove(index).node)
}

/// Puts a remark before all other keys.
pub(super) fn put_remark(root: &mut Node, remark: &str) {
    if let Some(members) = members(root) {
        let node = Node {
            at: 0,
            tree: Tree::Text(remark.to_owned()),
        };
        let key = "//".to_owned();
        members.insert(0, Member { key, at: 0, node });
    }
}

/// The study, or its blocks.
pub(super) fn blocks(root: &mut Node) -> Vec<&mut Node> {
    let has = members(root).is_some_and(|top| top.iter().any(|member| member.key == "blocks"));
    if !has {
        return vec![root];
    }
    match root.member("blocks").map(|node| &mut node.tree) {
        Some(Tree::List(items)) => items.iter_mut().collect(),
        _ => Vec::new(),
    }
}

/// Removes keys of a study.
pub(super) fn remove(root: &mut Node, keys: &[&str]) {
    if let Tree::Object(members) = &mut root.tree {
        members.retain(|member| !keys.contains(&member.key.as_str()));
    }
}
