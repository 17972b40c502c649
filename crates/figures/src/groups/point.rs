//! The points of fragility curves.

use crate::DrawnCase;
use slipgap_statistics::binomial;
use slipgap_study::kinds::Fragility;

/// The cases of a curve at one value of the parameter along the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FragilityPoint {
    /// The value; NaN of a curve without a place.
    pub at: f64,
    /// Number of cases.
    pub cases: u64,
    /// How many of them have no value of the metric; these are left out of all that follows.
    pub empty: u64,
    /// How many exceed the limit.
    pub exceeded: u64,
    /// The part that exceeds; `None` if no case has a value.
    pub probability: Option<Probability>,
}

/// An estimated probability.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Probability {
    /// The fraction of the cases.
    pub value: f64,
    /// Lower end of the 95 % interval (Clopper and Pearson).
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

impl Probability {
    /// The part of `count` cases that exceed.
    pub(super) fn of(exceeded: u64, count: u64) -> Probability {
        let [low, high] = binomial::interval(exceeded, count);
        Probability {
            value: exceeded as f64 / count as f64,
            low,
            high,
        }
    }
}

/// The metric of a case; infinite if it has collapsed.
pub(crate) fn value(figure: &Fragility, shown: &DrawnCase) -> Option<f64> {
    let value = shown.metric(figure.y);
    let Some(collapse) = figure.collapse else {
        return value;
    };
    Some(value.filter(|y| *y < collapse).unwrap_or(f64::INFINITY))
}

impl FragilityPoint {
    pub(super) fn new(figure: &Fragility, at: f64, cases: &[&&DrawnCase]) -> FragilityPoint {
        let value = |shown: &&&DrawnCase| value(figure, shown);
        let values: Vec<f64> = cases.iter().filter_map(value).collect();
        let exceeded = values.iter().filter(|value| **value > figure.limit);
        let (exceeded, count) = (exceeded.count() as u64, values.len() as u64);
        FragilityPoint {
            at,
            cases: cases.len() as u64,
            empty: (cases.len() - values.len()) as u64,
            exceeded,
            probability: (count > 0).then(|| Probability::of(exceeded, count)),
        }
    }

    /// Number of cases with a value.
    pub fn count(&self) -> u64 {
        self.cases - self.empty
    }
}
