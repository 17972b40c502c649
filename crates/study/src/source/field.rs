//! The keys of an object of a study, declared once: decoding, schema and pages read these tables.

use slipgap_problem::problem::numbers::parameter::Range;

/// A key of an object.
#[derive(Debug, Clone, Copy)]
pub struct Field<K = Kind> {
    /// The key.
    pub name: &'static str,
    /// What its value is.
    pub kind: K,
    /// Whether the object must have it.
    pub needed: bool,
    /// One sentence for messages, schema and pages.
    pub meaning: &'static str,
}

/// Names, which a table of another crate may have.
type Names = fn() -> Vec<&'static str>;

/// Names with their meanings.
type Meanings = fn() -> &'static [(&'static str, &'static str)];

/// Largest seed: every whole number up to it is a double.
pub const MOST_SEED: u64 = 1 << 53;

/// No limit of the length of a list.
pub const ANY: usize = usize::MAX;

/// What the value of a key is.
#[derive(Debug, Clone, Copy)]
pub enum Kind {
    /// Something that a function of its own decodes.
    Any,
    /// A number or an expression.
    Number(Range),
    /// A number or an expression in the first range, of which a run warns outside of the second: an editor shows it there.
    Likely(Range, Range),
    /// The same as a number without parameters.
    Constant,
    /// A whole number from the first to the second, or an expression.
    Whole([u64; 2]),
    /// A whole number from 1, as a number.
    Count(u64),
    /// A string.
    Text,
    /// A string of this form, a regular expression.
    Like(&'static str),
    /// One of several names; the messages call it this, and the first is the usual one if there is a usual one.
    Words(&'static str, Names, Option<Usual>),
    /// One of several names, which have meanings.
    Meant(Meanings),
    /// The name of a parameter that chooses one of several names; one of these in other letters is a mistake.
    Chooses(Meanings),
    /// A value that the schema has as a definition, by its name.
    Shared(&'static str),
    /// An object.
    Object(&'static Keys),
    /// An object with free keys.
    Named(&'static Kind),
    /// An object with the names of parts as keys.
    Parts(&'static Kind),
    /// An object of nodes with their factors.
    Factors,
    /// Two different directions.
    Directions,
    /// A list of at least and at most so many.
    List(&'static Kind, [usize; 2]),
    /// One, or a list of at least and at most so many.
    Several(&'static Kind, [usize; 2]),
    /// One of several kinds.
    OneOf(&'static [Kind]),
}

/// That the first name is the one of a key that is left out.
#[derive(Debug, Clone, Copy)]
pub struct Usual;

/// The keys of an object, and what they need of each other.
#[derive(Debug, Clone, Copy)]
pub struct Keys {
    /// Of a key that comes twice, the last one is that of the object.
    parts: [&'static [Field]; 3],
    /// All of them hold.
    pub rules: &'static [Rule],
}

/// What the keys of an object need of each other. Decoding has a message of its own for each.
#[derive(Debug, Clone, Copy)]
pub enum Rule {
    /// Exactly one of these keys and of these lists of rules.
    One(&'static [&'static str], &'static [&'static [Rule]]),
    /// One of them or several.
    Any(&'static [&'static str], &'static [&'static [Rule]]),
    /// All of these lists of rules.
    All(&'static [&'static [Rule]]),
    /// All of these keys.
    Has(&'static [&'static str]),
    /// None of these keys.
    No(&'static [&'static str]),
    /// Not all of these keys together.
    NotAll(&'static [&'static str]),
    /// With one of these keys, the rules.
    With(&'static [&'static str], &'static [Rule]),
}

/// A key that may be left out.
pub const fn field<K: Copy>(name: &'static str, kind: K) -> Field<K> {
    Field {
        name,
        kind,
        needed: false,
        meaning: "",
    }
}

/// A key that is needed.
pub const fn needed<K: Copy>(name: &'static str, kind: K) -> Field<K> {
    field(name, kind).needed()
}

impl<K: Copy> Field<K> {
    /// The same key with this meaning.
    pub const fn means(self, meaning: &'static str) -> Field<K> {
        Field {
            meaning: meaning.trim_ascii(),
            ..self
        }
    }

    /// The same key where it is needed.
    pub const fn needed(self) -> Field<K> {
        Field {
            needed: true,
            ..self
        }
    }
}

/// Keys, each with its meaning as the documentation before it.
macro_rules! fields {
    ($($(#[doc = $meaning:literal])? $field:ident $(($($argument:tt)*))?),* $(,)?) => {
        [$($field $(($($argument)*))? $(.means($meaning))?),*]
    };
}
pub(crate) use fields;

impl Keys {
    /// These keys.
    pub const fn new(fields: &'static [Field]) -> Keys {
        Keys {
            parts: [fields, &[], &[]],
            rules: &[],
        }
    }

    /// These keys, too.
    pub const fn and(self, more: &'static [Field]) -> Keys {
        let [first, second, _] = self.parts;
        let parts = match second {
            [] => [first, more, &[]],
            [..] => [first, second, more],
        };
        Keys { parts, ..self }
    }

    /// With these rules.
    pub const fn rules(self, rules: &'static [Rule]) -> Keys {
        Keys { rules, ..self }
    }

    /// The keys in order.
    pub fn fields(&self) -> impl Iterator<Item = &'static Field> + use<> {
        self.parts.into_iter().flatten()
    }

    /// The names of the keys.
    pub fn names(&self) -> Vec<&'static str> {
        self.fields().map(|field| field.name).collect()
    }

    /// The keys with their meanings, for pages.
    pub fn rows(&self) -> Vec<(&'static str, &'static str)> {
        self.fields()
            .map(|field| (field.name, field.meaning))
            .collect()
    }

    /// The key of this name.
    pub fn get(&self, key: &str) -> Option<&'static Field> {
        self.fields().filter(|field| field.name == key).last()
    }

    /// The range of the numbers under a key.
    pub fn range(&self, key: &str) -> Range {
        let field = self.get(key);
        field.map_or(Range::Any, |field| field.kind.range())
    }
}

impl Kind {
    /// The keys of a value that is an object.
    pub fn keys(&self) -> Option<&'static Keys> {
        if let Kind::OneOf(kinds) = self {
            return kinds.iter().find_map(Kind::keys);
        }
        let Kind::Object(keys) = self else {
            return None;
        };
        Some(keys)
    }

    /// The range of the numbers of a value.
    pub fn range(&self) -> Range {
        match self {
            Kind::Number(range) | Kind::Likely(range, _) => *range,
            Kind::Whole([0, _]) => Range::NotNegative,
            Kind::Whole(_) | Kind::Count(_) => Range::Positive,
            Kind::List(one, _) | Kind::Several(one, _) => one.range(),
            Kind::OneOf(kinds) => kinds.first().map_or(Range::Any, Kind::range),
            Kind::Any
            | Kind::Constant
            | Kind::Text
            | Kind::Like(_)
            | Kind::Words(..)
            | Kind::Meant(_)
            | Kind::Chooses(_)
            | Kind::Shared(_)
            | Kind::Object(_)
            | Kind::Named(_)
            | Kind::Parts(_)
            | Kind::Factors
            | Kind::Directions => Range::Any,
        }
    }

    /// The names that a value may have, and what messages call it; a name with a meaning is what its key says.
    pub fn words(&self) -> Option<(Option<&'static str>, Vec<&'static str>)> {
        match self {
            Kind::Words(what, names, _) => Some((Some(*what), names())),
            Kind::Meant(meanings) => Some((None, meanings().iter().map(|row| row.0).collect())),
            Kind::OneOf(kinds) => kinds.iter().find_map(Kind::words),
            Kind::Any
            | Kind::Number(_)
            | Kind::Likely(..)
            | Kind::Constant
            | Kind::Whole(_)
            | Kind::Count(_)
            | Kind::Text
            | Kind::Like(_)
            | Kind::Chooses(_)
            | Kind::Shared(_)
            | Kind::Object(_)
            | Kind::Named(_)
            | Kind::Parts(_)
            | Kind::Factors
            | Kind::Directions
            | Kind::List(..)
            | Kind::Several(..) => None,
        }
    }
}
