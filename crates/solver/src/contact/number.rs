//! A number of a law, as studies give it.

use std::fmt;

/// A number of a law: its declaration, the only one.
#[derive(Debug)]
pub struct Number {
    /// Its key in studies.
    pub key: &'static str,
    /// How figures write it, in markup.
    pub symbol: &'static str,
    /// Its unit; `1` for a number without one.
    pub unit: &'static str,
    /// The values allowed.
    pub range: Range,
    /// Its value if a study does not give it.
    pub usual: Usual,
    /// The key that it may take the place of: a study gives one of both.
    pub instead_of: Option<&'static str>,
    /// One sentence for schema and pages. `{laws}` is where the laws that have it are listed, `{friction}` those of friction.
    pub meaning: &'static str,
}

/// The value of a number that a study does not give.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Usual {
    /// The law needs it.
    Needed,
    /// This value.
    Is(f64),
    /// It follows from others, as this text describes, or the law does without it.
    Follows(&'static str),
}

impl Number {
    /// A number that the law needs, with key, symbol and unit.
    pub const fn new(
        [key, symbol, unit]: [&'static str; 3],
        range: Range,
        meaning: &'static str,
    ) -> Number {
        Number {
            key,
            symbol,
            unit,
            range,
            usual: Usual::Needed,
            instead_of: None,
            meaning,
        }
    }

    /// The same with a value where a study gives none.
    pub const fn usually(self, usual: Usual) -> Number {
        Number { usual, ..self }
    }

    /// The same, which a study may give in the place of another one.
    pub const fn instead_of(self, key: &'static str) -> Number {
        Number {
            instead_of: Some(key),
            ..self
        }
    }

    /// Whether these numbers contain it.
    pub const fn is_in(&self, numbers: &[&Number]) -> bool {
        let mut i = 0;
        while i < numbers.len() {
            if same(self.key, numbers[i].key) {
                return true;
            }
            i += 1;
        }
        false
    }
}

/// Range of a real parameter; infinity and NaN are never allowed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Range {
    /// x > 0
    Positive,
    /// 0 < x <= 1
    Fraction,
    /// 0 <= x <= 1
    UpToOne,
    /// x >= 1
    AtLeastOne,
    /// 1/2 <= x <= 1
    FromHalfToOne,
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
            Range::AtLeastOne => x >= 1.0,
            Range::FromHalfToOne => (0.5..=1.0).contains(&x),
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
            Range::AtLeastOne => ">= 1",
            Range::FromHalfToOne => "from 1/2 to 1",
            Range::HilberHughesTaylor => "from -1/3 to 0",
            Range::NotNegative => ">= 0",
            Range::NotZero => "not 0",
            Range::Any => "a finite number",
        })
    }
}

/// Whether two names are the same, for constants.
pub const fn same(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    let mut same = 0;
    while same < a.len() && same < b.len() && a[same] == b[same] {
        same += 1;
    }
    same == a.len() && same == b.len()
}
