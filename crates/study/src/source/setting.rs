//! `NAME=VALUE` of the command line: a value of a parameter that replaces the one in the study.

use super::faults::{Faults, join, quoted, shortened, shown};
use super::tree::{self, Member, Node, SyntaxFault, Tree};
use slipgap_problem::problem;
use std::fmt;

/// A parameter and its value, as written on the command line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Setting {
    text: String,
    /// Byte offset of `=`.
    equals: usize,
}

/// A text that is not `NAME=VALUE`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SettingFault;

impl fmt::Display for SettingFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("must be NAME=VALUE, as in dT=0.1 or alpha=[0.1, 1]")
    }
}

impl std::error::Error for SettingFault {}

impl Setting {
    /// Parses `NAME=VALUE`.
    ///
    /// # Errors
    /// There is no `=`, or no name before it.
    pub fn new(text: &str) -> Result<Setting, SettingFault> {
        let name = |name: &str| {
            let mut parts = name.trim().split('.');
            parts.all(|part| {
                !part.is_empty() && part.chars().all(|c| c.is_alphanumeric() || c == '_')
            })
        };
        match text.find('=').filter(|equals| name(&text[..*equals])) {
            Some(equals) => Ok(Setting {
                text: text.to_owned(),
                equals,
            }),
            None => Err(SettingFault),
        }
    }

    /// The text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The name of the setting in faults: on one line and not too long.
    pub(crate) fn source(&self) -> String {
        let text = shortened(&self.text).replace("\\\"", "\"");
        format!("--set {text}")
    }

    pub(crate) fn name(&self) -> &str {
        self.text[..self.equals].trim()
    }

    /// The value, with offsets from the first byte of the text. A value that is not JSON is a string, such as a name or an
    /// expression.
    fn value(&self) -> Result<Node, SyntaxFault> {
        let written = &self.text[self.equals + 1..];
        let trimmed = written.trim();
        let at = self.equals + 1 + (written.len() - written.trim_start().len());
        match tree::parse(trimmed) {
            Ok(mut node) => {
                node.move_by(at);
                Ok(node)
            }
            // An expression or a name does not begin like this.
            Err(fault) if trimmed.starts_with(['[', '{', '"']) => Err(SyntaxFault {
                at: fault.at + at,
                message: fault.message.replace("the file ends", "the value ends"),
            }),
            Err(_) => Ok(Node {
                at,
                tree: Tree::Text(trimmed.to_owned()),
            }),
        }
    }
}

/// Puts the settings into a study; offset `starts[i]` is the first byte of setting `i`.
pub(crate) fn put_all(
    root: &mut Node,
    settings: &[Setting],
    starts: &[usize],
    faults: &mut Faults,
) {
    for (i, (setting, start)) in settings.iter().zip(starts).enumerate() {
        if settings[..i]
            .iter()
            .any(|first| first.name() == setting.name())
        {
            let message = format!("{} is set twice", quoted(setting.name()));
            faults.add(*start, "", message);
        }
        match setting.value() {
            Ok(mut value) => {
                value.move_by(*start);
                put(root, setting, &value, *start, faults);
            }
            Err(fault) => faults.add(start + fault.at, "", fault.message),
        }
    }
}

/// Puts a value into every block that gives the parameter, or into all blocks if none does.
fn put(root: &mut Node, setting: &Setting, value: &Node, start: usize, faults: &mut Faults) {
    let names: Vec<&str> = setting.name().split('.').collect();
    if let ([name, _, ..], true) = (&names[..], is_described(root)) {
        let message = format!(
            "a parameter of a structure has no key {}; --set changes parameters, as in {name}=2, and a part of the structure follows \
             by an expression that contains the parameter",
            quoted(&names[1..].join("."))
        );
        faults.add(start, &format!("parameters.{}", setting.name()), message);
        return;
    }
    let mut blocks = blocks(root);
    let given = blocks.iter().any(|(_, node)| gives(node, &names));
    for (path, node) in &mut blocks {
        if !given || gives(node, &names) {
            insert(node, path, &names, value, start, faults);
        }
    }
}

/// Whether the study describes its system, so that its parameters have free names without keys.
fn is_described(root: &mut Node) -> bool {
    let name = root.get("problem").and_then(Node::text);
    name.is_some_and(problem::is_described)
}

/// The `parameters` of a study that are objects, each with its path. Decoding reports the others.
fn blocks(root: &mut Node) -> Vec<(String, &mut Node)> {
    let mut found = Vec::new();
    let Tree::Object(members) = &mut root.tree else {
        return found;
    };
    for member in members {
        if member.key == "parameters" {
            found.push(("parameters".into(), &mut member.node));
        } else if member.key == "blocks"
            && let Tree::List(items) = &mut member.node.tree
        {
            for (i, item) in items.iter_mut().enumerate() {
                let path = format!("blocks[{i}].parameters");
                found.extend(item.member("parameters").map(|node| (path, node)));
            }
        }
    }
    found.retain(|(_, node)| matches!(node.tree, Tree::Object(_)));
    found
}

/// Whether an object has a value under the nested keys `names`.
fn gives(node: &Node, names: &[&str]) -> bool {
    let Some((first, rest)) = names.split_first() else {
        return true;
    };
    let mut members = node.object().unwrap_or_default().iter();
    members.any(|member| member.key == *first && gives(&member.node, rest))
}

fn insert(
    node: &mut Node,
    path: &str,
    names: &[&str],
    value: &Node,
    start: usize,
    faults: &mut Faults,
) {
    let Some((first, rest)) = names.split_first() else {
        *node = value.clone();
        return;
    };
    if !matches!(node.tree, Tree::Object(_)) {
        let message = format!(
            "must be an object with the key {}, got {}",
            quoted(&names.join(".")),
            shown(node)
        );
        faults.add(start, path, message);
        return;
    }
    let inner = join(path, first);
    match node.member(first) {
        Some(inside) => insert(inside, &inner, rest, value, start, faults),
        None => {
            let mut inside = Node {
                at: value.at,
                tree: Tree::Object(Vec::new()),
            };
            insert(&mut inside, &inner, rest, value, start, faults);
            if let Tree::Object(members) = &mut node.tree {
                members.push(Member {
                    key: (*first).to_owned(),
                    at: start,
                    node: inside,
                });
            }
        }
    }
}
