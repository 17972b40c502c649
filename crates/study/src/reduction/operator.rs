//! The operators of reductions: the table that decoding, schema and documentation read.

use slipgap_problem::problem::numbers::parameter::shortest;
use slipgap_statistics::quantile::quantile;

/// The words of the operators, each with its meaning.
pub(crate) const OPERATORS: [(&str, &str); 7] = [
    ("least", "the smallest value"),
    ("greatest", "the largest value"),
    (
        "best",
        "the value with the smallest magnitude, with its sign",
    ),
    (
        "worst",
        "the value with the largest magnitude, with its sign",
    ),
    ("mean", "the arithmetic mean"),
    ("median", "the quantile at 0.5"),
    (
        "quantile P of",
        "the quantile at P from 0 to 1, straight between the sorted values (definition 7 of Hyndman and Fan)",
    ),
];

/// What a reduced value is among the values of the cases.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Operator {
    /// The smallest.
    Least,
    /// The largest.
    Greatest,
    /// The one with the smallest magnitude.
    Best,
    /// The one with the largest magnitude.
    Worst,
    /// Their mean.
    Mean,
    /// Their quantile at this number from 0 to 1.
    Quantile(f64),
}

impl Operator {
    /// The operator in a row of [`OPERATORS`]; `None` for the last one, which needs a number.
    pub(super) fn at(row: usize) -> Option<Operator> {
        let operators = [
            Operator::Least,
            Operator::Greatest,
            Operator::Best,
            Operator::Worst,
            Operator::Mean,
            Operator::Quantile(0.5),
        ];
        operators.get(row).copied()
    }

    /// How figures write it before the symbol of a metric.
    pub fn title(self) -> String {
        match self {
            Operator::Least => "smallest".into(),
            Operator::Greatest => "largest".into(),
            Operator::Best => "best".into(),
            Operator::Worst => "worst".into(),
            Operator::Mean => "mean".into(),
            Operator::Quantile(0.5) => "median".into(),
            Operator::Quantile(p) => format!("quantile {} of", shortest(p)),
        }
    }

    /// Whether it is the value of one of the cases.
    pub fn is_of_a_case(self) -> bool {
        matches!(
            self,
            Operator::Least | Operator::Greatest | Operator::Best | Operator::Worst
        )
    }

    /// Whether `value` replaces the one before it, for operators that are the value of a case.
    pub(super) fn prefers(self, value: f64, before: f64) -> bool {
        match self {
            Operator::Least => value < before,
            Operator::Greatest => value > before,
            Operator::Best => value.abs() < before.abs(),
            Operator::Worst => value.abs() > before.abs(),
            Operator::Mean | Operator::Quantile(_) => false,
        }
    }

    /// The value of several, for the other words.
    pub(super) fn of(self, values: &[f64]) -> Option<f64> {
        match self {
            Operator::Quantile(p) => {
                let mut rising = values.to_vec();
                rising.sort_by(f64::total_cmp);
                quantile(&rising, p)
            }
            _ if values.is_empty() => None,
            Operator::Least
            | Operator::Greatest
            | Operator::Best
            | Operator::Worst
            | Operator::Mean => {
                let count = values.len() as f64;
                let mean = values.iter().sum::<f64>() / count;
                // The sum of large values may be beyond the largest number.
                let parts = || values.iter().map(|x| x / count).sum();
                Some(if mean.is_finite() { mean } else { parts() })
            }
        }
    }
}
