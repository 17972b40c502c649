//! The range of a parameter that a design samples.

use crate::Scale;
use crate::source::faults::{Faults, join};
use crate::source::field::{self, Keys, Rule, field, fields};
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::value::within;
use slipgap_cases::axis::values::Distribution;
use slipgap_problem::problem::numbers::allowed::value_of;
use slipgap_problem::problem::numbers::parameter::{Kind, Parameter, Range, shortest};

/// The distributions, each with the meaning of its two numbers.
pub(crate) const INTERVALS: Keys = Keys::new(&fields![
    /// [a, b]: uniform distribution from a to b
    field("uniform", ENDS),
    /// [a, b]: uniform distribution of the logarithm from a to b
    field("loguniform", ENDS),
])
.rules(&[Rule::One(&["uniform", "loguniform"], &[])]);

const ENDS: field::Kind = field::Kind::List(&field::Kind::Number(Range::Any), [2, 2]);

/// A range and its distribution.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Interval {
    low: f64,
    high: f64,
    log: bool,
}

impl Interval {
    /// Whether `node` is an object with the key of an interval.
    pub fn is_interval(node: &Node) -> bool {
        let mut members = node.object().unwrap_or_default().iter();
        members.any(|member| INTERVALS.get(&member.key).is_some())
    }

    /// Decodes an interval. Both ends must be valid values of the parameter.
    pub fn decode(
        node: &Node,
        path: &str,
        parameter: &Parameter,
        faults: &mut Faults,
    ) -> Option<Interval> {
        let object = Object::open(node, path, &INTERVALS, faults)?;
        let member = object.one_of(&INTERVALS.names(), faults)?;
        let path = join(path, &member.key);
        let Some(ends) = member.node.list().filter(|items| items.len() == 2) else {
            faults.must_be(&member.node, &path, "[a, b]");
            return None;
        };
        if let Kind::Choice(_) = parameter.kind {
            faults.must_be(node, &path, "a name or a list of names");
            return None;
        }
        let mut end = |i: usize| {
            let path = format!("{path}[{i}]");
            let x = within(&ends[i], &path, Range::Any, Some(parameter), faults)?;
            if let Err(allowed) = value_of(x, parameter) {
                let message = format!("must be {allowed}, got {}", shortest(x));
                faults.add(ends[i].at, &path, message);
                return None;
            }
            Some(x)
        };
        let (low, high) = (end(0), end(1));
        let (low, high) = (low?, high?);
        let log = member.key == "loguniform";
        let message = match log {
            _ if low >= high => "must be greater than a",
            true if low <= 0.0 => "needs ends > 0",
            true if !(high / low).is_finite() => "b/a must be within the range of double precision",
            false if !(high - low).is_finite() => {
                "b - a must be within the range of double precision"
            }
            _ => return Some(Interval { low, high, log }),
        };
        faults.add(ends[1].at, &format!("{path}[1]"), message);
        None
    }

    /// Its ends.
    pub fn ends(self) -> [f64; 2] {
        [self.low, self.high]
    }

    /// The scale on which the distribution is uniform.
    pub fn scale(self) -> Scale {
        match self.log {
            true => Scale::Log,
            false => Scale::Linear,
        }
    }

    /// The distribution of a parameter.
    pub fn distribution(self, parameter: &Parameter) -> Distribution {
        Distribution {
            ends: [self.low, self.high],
            log: self.log,
            whole: matches!(parameter.kind, Kind::Whole { .. }),
        }
    }
}
