//! The values of an axis: a list, numbers of a rule, or points of a design, each computed when it is needed.

use super::design::Coordinates;
use slipgap_problem::problem::numbers::parameter::Value;
use std::borrow::Cow;
use std::sync::Arc;

/// The values of an axis.
#[derive(Debug, Clone)]
pub enum Values {
    /// As the study gives them.
    Listed(Vec<Value>),
    /// Numbers that a rule gives, often very many.
    Numbers(Arc<Vec<f64>>),
    /// As a design samples them.
    Sampled(Sampled),
}

/// The values of a parameter at the points of a design.
#[derive(Debug, Clone)]
pub struct Sampled {
    /// The points in the dimension of the parameter.
    pub coordinates: Coordinates,
    /// Number of points.
    pub points: u64,
    /// The distribution of the values.
    pub distribution: Distribution,
}

/// A distribution between two ends.
#[derive(Debug, Clone, Copy)]
pub struct Distribution {
    /// The ends.
    pub ends: [f64; 2],
    /// Whether the logarithm is uniform.
    pub log: bool,
    /// Whether the values are whole numbers.
    pub whole: bool,
}

impl Distribution {
    /// The value at `u`, 0 < u < 1. For a uniform distribution all whole numbers are equally likely; for one of the logarithm
    /// the value is rounded.
    pub fn at(self, u: f64) -> Value {
        let [low, high] = self.ends;
        let by_ratio = || (low * libm::pow(high / low, u)).clamp(low, high);
        match (self.whole, self.log) {
            (true, true) => Value::Whole(by_ratio().round() as u64),
            (true, false) => Value::Whole((low + u * (high - low + 1.0)).floor().min(high) as u64),
            (false, true) => Value::Number(by_ratio()),
            (false, false) => Value::Number(low + u * (high - low)),
        }
    }
}

impl Values {
    /// Number of values.
    pub fn len(&self) -> usize {
        match self {
            Values::Listed(values) => values.len(),
            Values::Numbers(numbers) => numbers.len(),
            Values::Sampled(sampled) => sampled.points as usize,
        }
    }

    /// Whether there are none. No valid study has such an axis.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The value at a position, which must be below the number of values.
    pub fn at(&self, position: usize) -> Value {
        match self {
            Values::Listed(values) => values[position],
            Values::Numbers(numbers) => Value::Number(numbers[position]),
            Values::Sampled(sampled) => {
                let u = sampled.coordinates.at(position as u64);
                sampled.distribution.at(u)
            }
        }
    }

    /// The values that are numbers, in order.
    pub fn numbers(&self) -> Cow<'_, [f64]> {
        match self {
            Values::Numbers(numbers) => Cow::Borrowed(numbers),
            others @ (Values::Listed(_) | Values::Sampled(_)) => {
                others.iter().filter_map(Value::as_f64).collect()
            }
        }
    }

    /// All values in order.
    pub fn iter(&self) -> impl Iterator<Item = Value> + '_ {
        (0..self.len()).map(|position| self.at(position))
    }
}

impl Default for Values {
    fn default() -> Values {
        Values::Listed(Vec::new())
    }
}

impl FromIterator<Value> for Values {
    fn from_iter<T: IntoIterator<Item = Value>>(values: T) -> Values {
        Values::Listed(values.into_iter().collect())
    }
}
