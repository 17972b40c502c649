//! A value of the study file as a number, a string, a name or a value of a parameter.

use super::source::faults::{Faults, any_of, in_words, quoted, shown, unknown};
use super::source::hint::{nearest, unit};
use super::source::tree::{Node, Tree};
use slipgap_problem::problem::PROBLEMS;
use slipgap_problem::problem::expression::unprintable;
use slipgap_problem::problem::expression::{ExpressionFault, Formula};
use slipgap_problem::problem::numbers::parameter::{Kind, Parameter, Range, Value, shortest};

/// What a number may be written as.
const NUMBER: &str = "a number or an expression in quotes such as \"8*pi\"";

/// A string.
pub fn text(node: &Node, path: &str, faults: &mut Faults) -> Option<String> {
    match &node.tree {
        Tree::Text(text) => match unprintable(text) {
            None => Some(text.clone()),
            Some(c) => {
                let message = format!("must be a string of printable characters, got {c}");
                faults.add(node.at, path, message);
                None
            }
        },
        Tree::Object(_) | Tree::List(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => {
            faults.must_be(node, path, "a string");
            None
        }
    }
}

/// A number in `range`, plain or as an expression.
pub fn number(node: &Node, path: &str, range: Range, faults: &mut Faults) -> Option<f64> {
    within(node, path, range, None, faults)
}

/// The same; `of` is its parameter, if it is the value of one.
pub fn within(
    node: &Node,
    path: &str,
    range: Range,
    of: Option<&Parameter>,
    faults: &mut Faults,
) -> Option<f64> {
    let x = finite(node, path, of, faults)?;
    if range.contains(x) {
        return Some(x);
    }
    out_of_range(node, path, x, &range.to_string(), faults);
    None
}

/// One of several names, as its index.
pub fn name(
    node: &Node,
    path: &str,
    what: &str,
    allowed: &[&str],
    faults: &mut Faults,
) -> Option<usize> {
    let Tree::Text(name) = &node.tree else {
        let names = format!("a name in quotes, one of {}", any_of(allowed));
        faults.must_be(node, path, &names);
        return None;
    };
    let found = allowed.iter().position(|known| known == name);
    if found.is_none() {
        faults.add(node.at, path, unknown(what, name, allowed));
    }
    found
}

/// A value of `parameter`, by its kind.
pub fn value(node: &Node, path: &str, parameter: &Parameter, faults: &mut Faults) -> Option<Value> {
    match parameter.kind {
        Kind::Number(range) => {
            within(node, path, range, Some(parameter), faults).map(Value::Number)
        }
        Kind::Whole { min, max } => {
            let x = finite(node, path, Some(parameter), faults)?;
            if x.fract() == 0.0 && x >= min as f64 && x <= max as f64 {
                return Some(Value::Whole(x as u64));
            }
            let range = format!("a whole number from {min} to {max}");
            out_of_range(node, path, x, &range, faults);
            None
        }
        Kind::Choice(choices) => {
            let names: Vec<&str> = choices.iter().map(|choice| choice.0).collect();
            let chosen = name(node, path, &parameter.name, &names, faults)?;
            Some(Value::Name(choices[chosen].0))
        }
    }
}

fn finite(node: &Node, path: &str, of: Option<&Parameter>, faults: &mut Faults) -> Option<f64> {
    match &node.tree {
        Tree::Number(written) => match written.parse::<f64>() {
            Ok(x) if x.is_finite() => return Some(x),
            _ => faults.must_be(node, path, "a finite number"),
        },
        Tree::Text(formula) => match Formula::number(formula, &[]).and_then(|f| f.value(&|_| None))
        {
            Ok(x) => return Some(x),
            Err(fault) => {
                let named = || of.and_then(|_| own_name(&fault));
                let what = parameters_in(formula)
                    .or_else(|| with_unit(formula, of))
                    .or_else(named)
                    .unwrap_or_else(|| in_words(&fault));
                faults.add(node.at, path, format!("{}: {what}", quoted(formula)));
            }
        },
        Tree::Object(_) | Tree::List(_) | Tree::Bool(_) | Tree::Null => {
            faults.must_be(node, path, NUMBER);
        }
    }
    None
}

/// The hint for a number with a unit; `None` for other texts. `of` is the parameter, if it is the value of one.
pub fn with_unit(text: &str, of: Option<&Parameter>) -> Option<String> {
    unit(text)?;
    let mut hint = "a number is written without a unit".to_owned();
    if let Some(parameter) = of {
        let name = &parameter.name;
        hint += &match &*parameter.unit {
            "1" => format!("; {name} is dimensionless: {}", parameter.meaning),
            unit => format!("; {name} is in {unit}: {}", parameter.meaning),
        };
    }
    Some(hint)
}

/// What an expression in a list or rule may not have.
const NO_NAMES: &str = "an expression with names of parameters is allowed as the value of a parameter, and in a list that has as many values as its partners in a \"zip\", not in a rule";

/// The hint for a name that may be that of a parameter of the study; `None` for one that is nearly that of a function.
fn own_name(fault: &ExpressionFault) -> Option<String> {
    let unknown = fault.unknown.as_deref()?;
    let allowed: Vec<&str> = unknown.allowed.iter().map(|name| &**name).collect();
    let is_number = unknown.name.parse::<f64>().is_ok();
    let may_be = unknown.name.is_ascii() && !is_number;
    (may_be && nearest(&unknown.name, &allowed).is_none())
        .then(|| format!("unknown name; {NO_NAMES}"))
}

/// The hint for an expression of parameters, which is not allowed here; `None` for other texts.
fn parameters_in(text: &str) -> Option<String> {
    PROBLEMS.iter().find_map(|problem| {
        let table = problem.parameters();
        let formula = Formula::number(text, table).ok()?;
        let names: Vec<&str> = formula
            .uses()
            .iter()
            .map(|row| &*table[*row].name)
            .collect();
        (!names.is_empty()).then(|| format!("names {}; {NO_NAMES}", names.join(", ")))
    })
}

/// Reports a number out of range. The message has the text of an expression and its value.
fn out_of_range(node: &Node, path: &str, x: f64, range: &str, faults: &mut Faults) {
    let mut message = format!("must be {range}, got {}", shown(node));
    if matches!(node.tree, Tree::Text(_)) {
        message = format!("{message} = {}", shortest(x));
    }
    faults.add(node.at, path, message);
}
