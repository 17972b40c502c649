//! The range of a free parameter.

use crate::source::faults::{Faults, quoted};
use crate::source::field::{Keys, Kind, fields, needed};
use crate::source::object::Object;
use crate::source::tree::{Node, Tree};
use crate::value::within;
use slipgap_problem::problem::numbers::allowed::value_of;
use slipgap_problem::problem::numbers::parameter::{Parameter, Range, shortest};

/// The key of a range whose logarithm is searched.
pub(crate) const LOG: Keys = Keys::new(&fields![
    /// [a, b]: range from a to b of which the logarithm is searched, for numbers over several powers of ten
    needed("log", Kind::List(&Kind::Number(Range::Any), [2, 2])),
]);

/// What a range looks like.
const FORM: &str = "a range [a, b] or {\"log\": [a, b]}";

/// A range with its scale.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeRange {
    /// The ends, rising.
    pub ends: [f64; 2],
    /// Whether its logarithm is searched.
    pub log: bool,
}

impl FreeRange {
    /// The value at `u` from 0 to 1.
    pub fn at(self, u: f64) -> f64 {
        let [low, high] = self.ends;
        let x = match self.log {
            true => low * libm::pow(high / low, u),
            false => low + u * (high - low),
        };
        x.clamp(low, high)
    }

    /// The place of a value, from 0 to 1 within the range.
    pub fn unit(self, x: f64) -> f64 {
        let [low, high] = self.ends;
        match self.log {
            true => libm::log(x / low) / libm::log(high / low),
            false => (x - low) / (high - low),
        }
    }

    /// Decodes the range of a parameter. Both ends must be valid values of it.
    pub(super) fn decode(
        node: &Node,
        path: &str,
        parameter: &Parameter,
        faults: &mut Faults,
    ) -> Option<FreeRange> {
        let (ends, path, log) = match &node.tree {
            Tree::List(items) => (&items[..], path.to_owned(), false),
            Tree::Object(_) => {
                let before = faults.count();
                let object = Object::open(node, path, &LOG, faults)?;
                if faults.count() > before {
                    // An unknown key is most often this one.
                    return None;
                }
                let (log, path) = object.given("log", faults)?;
                let Some(items) = log.list() else {
                    faults.must_be(log, &path, "[a, b]");
                    return None;
                };
                (items, path, true)
            }
            Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => {
                faults.must_be(node, path, FORM);
                return None;
            }
        };
        let [first, last] = ends else {
            let message = format!("must be {FORM}, got a list of {}", ends.len());
            faults.add(node.at, &path, message);
            return None;
        };
        let mut end = |node: &Node, i: usize| {
            let path = format!("{path}[{i}]");
            let x = within(node, &path, Range::Any, Some(parameter), faults)?;
            if let Err(allowed) = value_of(x, parameter) {
                let name = quoted(&parameter.name);
                let message = format!("{name} must be {allowed}, got {}", shortest(x));
                faults.add(node.at, &path, message);
                return None;
            }
            if log && x <= 0.0 {
                let message = format!("must be > 0 for a logarithm, got {}", shortest(x));
                faults.add(node.at, &path, message);
                return None;
            }
            Some(x)
        };
        let (low, high) = (end(first, 0), end(last, 1));
        let (low, high) = (low?, high?);
        let message = match log {
            _ if low >= high => {
                let [low, high] = [low, high].map(shortest);
                format!("must be greater than a = {low}, got {high}")
            }
            true if !(high / low).is_finite() => {
                "b/a must be within the range of double precision".to_owned()
            }
            false if !(high - low).is_finite() => {
                "b - a must be within the range of double precision".to_owned()
            }
            _ => {
                return Some(FreeRange {
                    ends: [low, high],
                    log,
                });
            }
        };
        faults.add(last.at, &format!("{path}[1]"), message);
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_are_kept_to_the_bit_and_the_place_is_the_inverse() {
        for log in [false, true] {
            let range = FreeRange {
                ends: [0.3, 7e5],
                log,
            };
            assert_eq!([range.at(0.0), range.at(1.0)], range.ends);
            for u in [0.1, 0.25, 0.8] {
                // Round-off of a power and a logarithm.
                assert!((range.unit(range.at(u)) - u).abs() < 1e-14);
            }
        }
        let decades = FreeRange {
            ends: [1e2, 1e6],
            log: true,
        };
        // The middle of four powers of ten is two powers above the first.
        assert!((decades.at(0.5) / 1e4 - 1.0).abs() < 1e-14);
    }
}
