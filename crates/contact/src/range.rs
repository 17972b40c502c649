//! Ranges of real parameters.

use std::fmt;

/// Range of a real parameter; infinity and NaN are never allowed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Range {
    /// x > 0
    Positive,
    /// 0 < x <= 1
    Fraction,
    /// 0 <= x <= 1
    UpToOne,
    /// x = 0 or x = 1
    ZeroOrOne,
    /// 0.1 <= x <= 2
    FromTenthToTwo,
    /// x <= 1
    AtMostOne,
    /// x >= 1
    AtLeastOne,
    /// 1/2 <= x <= 1
    FromHalfToOne,
    /// x >= 1/2
    AtLeastHalf,
    /// -1/3 <= x <= 0
    HilberHughesTaylor,
    /// x >= 0
    NotNegative,
    /// x != 0
    NotZero,
    /// any finite x
    Any,
}

impl Range {
    /// Whether a finite number is in the range.
    pub fn contains(self, x: f64) -> bool {
        match self {
            Range::Positive => x > 0.0,
            Range::Fraction => x > 0.0 && x <= 1.0,
            Range::UpToOne => (0.0..=1.0).contains(&x),
            Range::ZeroOrOne => x == 0.0 || x == 1.0,
            Range::FromTenthToTwo => (0.1..=2.0).contains(&x),
            Range::AtMostOne => x <= 1.0,
            Range::AtLeastOne => x >= 1.0,
            Range::FromHalfToOne => (0.5..=1.0).contains(&x),
            Range::AtLeastHalf => x >= 0.5,
            Range::HilberHughesTaylor => (-1.0 / 3.0..=0.0).contains(&x),
            Range::NotNegative => x >= 0.0,
            Range::NotZero => x != 0.0,
            Range::Any => true,
        }
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Range::Positive => "> 0",
            Range::Fraction => "> 0 and <= 1",
            Range::UpToOne => "from 0 to 1",
            Range::ZeroOrOne => "0 or 1",
            Range::FromTenthToTwo => "from 0.1 to 2",
            Range::AtMostOne => "<= 1",
            Range::AtLeastOne => ">= 1",
            Range::FromHalfToOne => "from 1/2 to 1",
            Range::AtLeastHalf => ">= 1/2",
            Range::HilberHughesTaylor => "from -1/3 to 0",
            Range::NotNegative => ">= 0",
            Range::NotZero => "not 0",
            Range::Any => "a finite number",
        })
    }
}
