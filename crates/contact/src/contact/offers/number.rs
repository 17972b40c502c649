//! A number of a law, as studies give it.

pub use crate::range::Range;

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
    pub(in crate::contact) const fn new(
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
    pub(in crate::contact) const fn usually(self, usual: Usual) -> Number {
        Number { usual, ..self }
    }

    /// The same, which a study may give in the place of another one.
    pub(in crate::contact) const fn instead_of(self, key: &'static str) -> Number {
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

/// Whether two names are the same, for constants.
pub const fn same(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    let mut same = 0;
    while same < a.len() && same < b.len() && a[same] == b[same] {
        same += 1;
    }
    same == a.len() && same == b.len()
}
