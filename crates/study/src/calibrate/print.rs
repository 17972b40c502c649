//! A tree as JSON text, with numbers as they were written.

use crate::source::tree::{Member, Node, Tree};

/// Longest value on one line, in characters.
const LINE: usize = 100;

/// The text of a study with a newline at its end.
pub(super) fn text(root: &Node) -> String {
    let mut out = String::new();
    put(root, 0, &mut out);
    out.push('\n');
    out
}

fn put(node: &Node, depth: usize, out: &mut String) {
    let plain = one_line(node);
    // The root has a line for each key.
    if depth > 0 && plain.chars().count() <= LINE {
        out.push_str(&plain);
        return;
    }
    match &node.tree {
        Tree::Object(members) => {
            let put = |member: &Member, out: &mut String| {
                out.push_str(&quoted(&member.key));
                out.push_str(": ");
                put(&member.node, depth + 1, out);
            };
            lines(['{', '}'], members, depth, out, put);
        }
        Tree::List(items) => {
            let put = |item: &Node, out: &mut String| put(item, depth + 1, out);
            lines(['[', ']'], items, depth, out, put);
        }
        Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => out.push_str(&plain),
    }
}

/// Items between brackets, each on its line.
fn lines<T>(
    [open, close]: [char; 2],
    items: &[T],
    depth: usize,
    out: &mut String,
    put: impl Fn(&T, &mut String),
) {
    out.push(open);
    for (i, item) in items.iter().enumerate() {
        out.push_str(if i == 0 { "\n" } else { ",\n" });
        out.push_str(&"  ".repeat(depth + 1));
        put(item, out);
    }
    out.push('\n');
    out.push_str(&"  ".repeat(depth));
    out.push(close);
}

fn one_line(node: &Node) -> String {
    let joined = |items: Vec<String>| items.join(", ");
    match &node.tree {
        Tree::Object(members) if members.is_empty() => "{}".to_owned(),
        Tree::Object(members) => {
            let one =
                |member: &Member| format!("{}: {}", quoted(&member.key), one_line(&member.node));
            format!("{{ {} }}", joined(members.iter().map(one).collect()))
        }
        Tree::List(items) => format!("[{}]", joined(items.iter().map(one_line).collect())),
        Tree::Text(text) => quoted(text),
        Tree::Number(written) => written.clone(),
        Tree::Bool(value) => value.to_string(),
        Tree::Null => "null".to_owned(),
    }
}

/// A string of JSON.
fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::tree::parse;

    #[test]
    fn a_printed_tree_is_read_as_the_same() {
        let long = "x".repeat(80);
        let source = format!(
            r#"{{"a": 1e4, "b": [1, 2.50, "q\"\\\n"], "c": {{}}, "d": [], "e": {{"f": ["{long}", "{long}"], "g": null}}, "h": true}}"#
        );
        let tree = parse(&source).unwrap();
        let printed = text(&tree);
        assert!(printed.contains("1e4") && printed.contains("2.50"));
        let mut again = parse(&printed).unwrap();
        // The places differ; the text does not have them.
        again.at = tree.at;
        assert_eq!(text(&again), printed);
        let value = |text: &str| serde_json::from_str::<serde_json::Value>(text).unwrap();
        assert_eq!(value(&printed), value(&source));
    }
}
