//! The faults found while a study is decoded, and the parts of their messages.

use std::fmt::Write;

use super::hint::{nearest, outside};
use super::place::{self, Texts};
use super::tree::{Node, Tree};
use crate::error::Fault;

/// The faults found so far, in any order.
#[derive(Default)]
pub struct Faults {
    first: Vec<(usize, String, String)>,
    /// Number of those beyond [`MOST_REPORTED`].
    more: usize,
}

/// Most faults of a file that are reported. A large file may have millions.
const MOST_REPORTED: usize = 10_000;

impl Faults {
    /// Adds a fault of the key `path` at byte `at`.
    pub fn add(&mut self, at: usize, path: &str, message: impl Into<String>) {
        if self.first.len() < MOST_REPORTED {
            // A message may have names of the study in it.
            let message = printable(&message.into()).replace(['\n', '\t'], " ");
            self.first.push((at, path.to_owned(), message));
        } else {
            self.more += 1;
        }
    }

    /// Adds the fault that a value is not `what`.
    pub fn must_be(&mut self, node: &Node, path: &str, what: &str) {
        let mut message = format!("must be {what}, got {}", shown(node));
        if matches!(node.tree, Tree::Null) {
            message += ", as None of Python is written; leave the key out instead";
        }
        self.add(node.at, path, message);
    }

    /// Number of faults. If it has not changed, no fault was added.
    pub fn count(&self) -> usize {
        self.first.len() + self.more
    }

    /// All of them with line and column, in file order, each once.
    pub fn in_file_order(mut self, mut texts: Texts) -> Vec<Fault> {
        self.first.sort_by_key(|(at, ..)| *at);
        self.first.dedup();
        if let (Some((at, ..)), 1..) = (self.first.last(), self.more) {
            let message = format!("and {} more faults", self.more);
            self.first.push((*at, String::new(), message));
        }
        let faults = self
            .first
            .into_iter()
            .enumerate()
            .map(|(i, (at, path, message))| {
                let (file, text, line, column) = texts.at(at);
                let file = file.to_owned();
                let shown = match i < MOST_SHOWN {
                    true => place::shown(text, line, column),
                    false => String::new(),
                };
                Fault {
                    file,
                    line,
                    column,
                    path,
                    message,
                    shown,
                }
            });
        faults.collect()
    }
}

/// Most faults whose lines are shown. Finding thousands of lines takes time.
const MOST_SHOWN: usize = 20;

use slipgap_problem::problem::expression::{ExpressionFault, UnknownName, printable};
pub use slipgap_problem::problem::expression::{quoted, shortened};

/// The path of `key` within `path`.
pub fn join(path: &str, key: &str) -> String {
    let key = shortened(key);
    if path.is_empty() {
        key
    } else {
        format!("{path}.{key}")
    }
}

/// A value for a message: on one line and not too long.
pub fn shown(node: &Node) -> String {
    match &node.tree {
        Tree::Object(_) => "an object".into(),
        Tree::List(items) if items.is_empty() => "[]".into(),
        Tree::List(_) => "a list".into(),
        Tree::Text(text) => quoted(text),
        Tree::Number(written) => shortened(written),
        Tree::Bool(value) => value.to_string(),
        Tree::Null => "null".into(),
    }
}

/// The message that a name is not one of those allowed, with the nearest one.
pub fn unknown(what: &str, name: &str, allowed: &[&str]) -> String {
    let mut message = format!("unknown {what} {}", quoted(name));
    if let Some(nearest) = nearest(name, allowed) {
        let _ = write!(message, ", did you mean \"{nearest}\"?");
    } else if let Some(sentence) = outside(name, allowed) {
        let _ = write!(message, ": {sentence}");
    }
    let _ = write!(message, "; allowed: {}", any_of(allowed));
    let is_free = nearest(name, allowed).is_none() && outside(name, allowed).is_none();
    if is_free && is_table(allowed) {
        match what {
            "key" => {
                message += "; a parameter of your own must be in an expression of another one or of \"when\""
            }
            "name" => message += "; a name of your own must be one of the \"parameters\"",
            _ => {}
        }
    }
    message
}

/// Whether these names have the parameters of the oscillator or the bars.
fn is_table(names: &[&str]) -> bool {
    let has = |two: [&str; 2]| two.iter().all(|name| names.contains(name));
    has(["alpha", "dT"]) || has(["gamma", "k_I"])
}

/// The message of a fault of an expression, with the nearest name for an unknown one.
pub fn in_words(fault: &ExpressionFault) -> String {
    match fault.unknown.as_deref() {
        Some(UnknownName {
            what,
            name,
            allowed,
        }) => {
            let allowed: Vec<&str> = allowed.iter().map(|name| &**name).collect();
            unknown(what, name, &allowed)
        }
        None => fault.message.clone(),
    }
}

/// Names in a message; `none` if there are none.
pub fn any_of(names: &[&str]) -> String {
    match names {
        [] => "none".into(),
        names => names.join(", "),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_unknown_name_in_an_expression_has_the_nearest_one() {
        use slipgap_problem::problem::expression::Formula;
        let table = slipgap_problem::problem::PROBLEMS[0].parameters();
        let words = |fault| in_words(&fault);
        let sqrt = words(Formula::number("sqr(2)", table).unwrap_err());
        assert!(
            sqrt.contains("did you mean \"sqrt\"?; allowed: pi, e"),
            "{sqrt}"
        );
        let law = words(Formula::condition("law == 'coulom'", table).unwrap_err());
        assert!(
            law.contains("did you mean \"coulomb\"?; allowed: "),
            "{law}"
        );
        let other = words(Formula::number("1 +", table).unwrap_err());
        assert!(!other.contains("allowed") && !other.is_empty(), "{other}");
    }

    #[test]
    fn a_message_stays_on_one_line() {
        assert_eq!(quoted("a\nb"), "\"a\\nb\"");
        assert!(quoted(&"x".repeat(1000)).chars().count() < 70);
    }

    #[test]
    fn faults_come_in_file_order_each_once() {
        let mut faults = Faults::default();
        faults.add(3, "b", "late");
        faults.add(0, "a", "early");
        faults.add(3, "b", "late");
        let messages: Vec<String> = faults
            .in_file_order(Texts::new("f", "x\ny\n"))
            .iter()
            .map(ToString::to_string)
            .collect();
        assert_eq!(messages, ["f:1:1: a: early", "f:2:2: b: late"]);
    }
}
