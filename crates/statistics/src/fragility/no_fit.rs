//! Why data have no fragility function.

use std::fmt;

/// Why data have no fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoFit {
    /// A trial exceeds at a value that is not positive, where the probability is zero.
    NotPositive,
    /// No trial exceeds.
    None,
    /// Every trial exceeds.
    All,
    /// All trials that exceed are at values no smaller than all others: any smaller dispersion is more likely.
    Separable,
    /// The most likely probability does not rise.
    NotRising,
    /// There are less capacities or cases than this.
    Few(usize),
    /// A value or the limit is not positive, so that it has no logarithm.
    NoLogarithm,
    /// All capacities are the same, or all cases are at one value or on one line.
    Equal,
    /// The metric does not rise with the value beyond its scatter.
    NotRisingEnough,
    /// So many members do not exceed at the largest value.
    Beyond(usize),
    /// So many members exceed at the smallest value.
    Before(usize),
}

impl fmt::Display for NoFit {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            NoFit::Few(least) => return write!(f, "less than {least} values"),
            NoFit::Beyond(count) => {
                return write!(
                    f,
                    "{count} of the ensemble do not exceed the limit at the largest value"
                );
            }
            NoFit::Before(count) => {
                return write!(
                    f,
                    "{count} of the ensemble exceed the limit at the smallest value"
                );
            }
            NoFit::NoLogarithm => {
                "a value or the limit is not positive, so that it has no logarithm"
            }
            NoFit::Equal => "the values have no scatter",
            NoFit::NotRisingEnough => "the metric does not rise with x beyond its scatter",
            NoFit::NotPositive => "a case exceeds the limit at a value that is not positive",
            NoFit::None => "no case exceeds the limit",
            NoFit::All => "every case exceeds the limit",
            NoFit::Separable => {
                "no value exceeds in some cases below one that does not exceed in others"
            }
            NoFit::NotRising => "the probability does not rise",
        })
    }
}
