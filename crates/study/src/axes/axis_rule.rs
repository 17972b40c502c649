//! Axes given by a rule instead of a list. The ends of an axis are the given numbers to the bit; values between them that are decimals of
//! at most 15 digits are those decimals.

use crate::source::faults::{Faults, join};
use crate::source::field::{self, Keys, field, fields};
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::value::within;
use slipgap_cases::axis::spaced::{self, Rule};
use slipgap_cases::axis::values::Values;
use slipgap_problem::metrics::SLACK;
use slipgap_problem::problem::numbers::parameter::{Kind, Parameter, Range, Value};
use std::sync::Arc;

/// The rules, each with the meaning of its three numbers.
pub(crate) const RULES: Keys = Keys::new(&fields![
    /// [a, b, n]: n numbers from a to b, evenly spaced
    field("linspace", THREE),
    /// [a, b, n]: n numbers from a to b, with the same ratio between neighbours
    field("geomspace", THREE),
    /// [a, b, step]: a, a + step, ... up to b, with b if whole steps reach it
    field("range", THREE),
])
.rules(&[field::Rule::One(&["linspace", "geomspace", "range"], &[])]);

const THREE: field::Kind = field::Kind::List(&field::Kind::Number(Range::Any), [3, 3]);

/// In the order of [`RULES`].
const ALL: [Rule; 3] = [Rule::Linspace, Rule::Geomspace, Rule::Range];

/// Most values of an axis.
const MOST: f64 = 1e6;

/// The values of a rule, each in the range of the parameter. A whole-number parameter has the nearest whole numbers, each
/// once.
pub(crate) fn values(
    node: &Node,
    path: &str,
    parameter: &Parameter,
    faults: &mut Faults,
) -> Option<Values> {
    let before = faults.count();
    let object = Object::open(node, path, &RULES, faults)?;
    // An unknown key is reported already.
    if object.members.len() != 1 && faults.count() > before {
        return None;
    }
    let member = object.one_of(&RULES.names(), faults)?;
    let path = join(path, &member.key);
    let (rule, row) = ALL
        .into_iter()
        .zip(RULES.rows())
        .find(|(_, row)| row.0 == member.key)?;
    let Some(three) = member.node.list().filter(|items| items.len() == 3) else {
        faults.must_be(&member.node, &path, row.1);
        return None;
    };
    let item = |i: usize, faults: &mut Faults| {
        let path = format!("{path}[{i}]");
        within(&three[i], &path, Range::Any, Some(parameter), faults)
    };
    // All three are decoded first, so that every faulty number is reported.
    let (a, b, c) = (item(0, faults), item(1, faults), item(2, faults));
    let (a, b, c) = (a?, b?, c?);
    let mut refuse = |i: usize, message: &str| {
        faults.add(three[i].at, &format!("{path}[{i}]"), message.to_owned());
        None
    };
    let count = match rule {
        Rule::Range if c == 0.0 || (b - a) / c < 0.0 => {
            return refuse(2, "must be a step that leads from a to b");
        }
        Rule::Range => ((b - a) / c * (1.0 + SLACK)).floor() + 1.0,
        // The product of two very small numbers is 0, so the signs are compared.
        Rule::Geomspace if a == 0.0 || b == 0.0 || (a < 0.0) != (b < 0.0) => {
            return refuse(1, "must have the sign of a, and neither may be 0");
        }
        Rule::Geomspace | Rule::Linspace if c.fract() != 0.0 || c < 2.0 => {
            return refuse(2, "must be a whole number >= 2");
        }
        Rule::Geomspace | Rule::Linspace => c,
    };
    if count > MOST {
        return refuse(2, &format!("gives {count} values; allowed: at most {MOST}"));
    }
    let points = spaced::numbers(rule, [a, b, c], count as usize);
    to_values(points, &member.node, &path, parameter, faults)
}

/// The points as values of the parameter.
fn to_values(
    points: Vec<f64>,
    node: &Node,
    path: &str,
    parameter: &Parameter,
    faults: &mut Faults,
) -> Option<Values> {
    let mut refuse = |x: f64| {
        let allowed = match parameter.kind {
            Kind::Number(range) => range.to_string(),
            Kind::Whole { min, max } => format!("a whole number from {min} to {max}"),
            Kind::Choice(_) => "a name or a list of names".into(),
        };
        let x = Value::Number(x);
        faults.add(node.at, path, format!("must be {allowed}, got {x}"));
        None
    };
    let (min, max) = match parameter.kind {
        Kind::Number(range) => {
            let outside = |x: &&f64| !(x.is_finite() && range.contains(**x));
            return match points.iter().find(outside) {
                Some(x) => refuse(*x),
                None => Some(Values::Numbers(Arc::new(points))),
            };
        }
        Kind::Whole { min, max } => (min as f64, max as f64),
        // No number is a name.
        Kind::Choice(_) => (f64::INFINITY, 0.0),
    };
    let mut values = Vec::new();
    for x in points {
        let whole = x.round();
        if !(whole >= min && whole <= max) {
            return refuse(x);
        }
        values.push(Value::Whole(whole as u64));
    }
    values.dedup();
    Some(Values::Listed(values))
}
