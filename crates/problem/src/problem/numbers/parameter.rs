//! The table of parameters, with one row for each, for decoding, schema, columns, `explain` and the documentation.

pub use crate::contact::number::Range;
pub use slipgap_notation::{Scale, real, shortest};

use super::text::{Table, Text, text};
use crate::contact::number::{Number, Usual, same};
use slipgap_notation::{capital, in_unit, unit as set};
use std::fmt;

/// One parameter of a problem.
#[derive(Debug, Clone)]
pub struct Parameter {
    /// Key in a study file and column of results.csv; `right.L` is key `L` of object `right`.
    pub name: Text,
    /// How figures write it, with its scale, in the markup of `figures::markup`.
    pub symbol: Text,
    /// Unit, or `1` for a dimensionless number.
    pub unit: Text,
    /// The unit that figures write behind the symbol and behind values; `None` where the symbol has the scale.
    pub shown_unit: Option<Text>,
    /// How figures write some of its names; the others as they are.
    pub shown_values: Table<(Text, Text)>,
    /// The values allowed.
    pub kind: Kind,
    /// Its value if the study does not give it.
    pub default: Default,
    /// The choice that must be made for this one to apply; `None` for a parameter that always applies.
    pub applies: Option<Condition>,
    /// Which tables have a column of it.
    pub column: ColumnRule,
    /// The column's name, if a metric has that of the parameter.
    pub heading: Option<&'static str>,
    /// One sentence for schema and documentation.
    pub meaning: Text,
}

/// The meaning of the names of a parameter that only labels cases.
pub const LABEL: &str = "label";

impl Parameter {
    /// Whether the parameter only labels cases: no part of the problem contains it.
    pub fn is_label(&self) -> bool {
        matches!(self.kind, Kind::Choice(names) if names.iter().all(|name| name.1 == LABEL))
    }

    /// A parameter that always applies, for tables.
    pub const fn new(
        names: [&'static str; 3],
        kind: Kind,
        default: Default,
        meaning: &'static str,
    ) -> Parameter {
        Parameter::row(names, kind, default, None, meaning)
    }

    /// A parameter that applies only if another parameter has one of these names.
    pub const fn only_for(
        names: [&'static str; 3],
        kind: Kind,
        default: Default,
        (governor, chosen): (&'static str, &'static [&'static str]),
        meaning: &'static str,
    ) -> Parameter {
        let applies = Condition {
            governor,
            names: chosen,
            collapses: false,
        };
        Parameter::row(names, kind, default, Some(applies), meaning)
    }

    /// A number of the laws of these names.
    pub const fn of_laws(number: &'static Number, laws: &'static [&'static str]) -> Parameter {
        let default = match number.usual {
            Usual::Needed => Default::Required,
            Usual::Is(x) => Default::Is(Value::Number(x)),
            Usual::Follows(text) => Default::Follows(Text::Borrowed(text)),
        };
        let names = [number.key, number.symbol, number.unit];
        let kind = Kind::Number(number.range);
        Parameter::only_for(names, kind, default, ("law", laws), number.meaning)
    }

    const fn row(
        [name, symbol, unit]: [&'static str; 3],
        kind: Kind,
        default: Default,
        applies: Option<Condition>,
        meaning: &'static str,
    ) -> Parameter {
        Parameter {
            name: Text::Borrowed(name),
            symbol: Text::Borrowed(symbol),
            unit: Text::Borrowed(unit),
            shown_unit: None,
            shown_values: Table::Borrowed(&[]),
            kind,
            default,
            applies,
            column: ColumnRule::Always,
            heading: None,
            meaning: Text::Borrowed(meaning),
        }
    }

    /// The same with another name of its column, since a metric has its own.
    pub const fn with_heading(mut self, heading: &'static str) -> Parameter {
        self.heading = Some(heading);
        self
    }

    /// The title of an axis along it, in markup.
    pub fn title(&self) -> String {
        let title = match self.symbol == self.name {
            true => self.symbol.to_string(),
            // In words.
            false => capital(&self.symbol),
        };
        match &self.shown_unit {
            Some(unit) => in_unit(&title, &set(unit)),
            None => title,
        }
    }

    /// A name of it as figures write it, in plain text.
    pub fn shown<'a>(&'a self, name: &'a str) -> &'a str {
        let mut known = self.shown_values.iter();
        known
            .find(|known| known.0 == name)
            .map_or(name, |known| &known.1)
    }

    /// Name of its column in tables.
    pub fn column_name(&self) -> &str {
        self.heading.unwrap_or(&self.name)
    }

    /// The same with a column only in the tables of studies that give the parameter. A new parameter with a default then
    /// changes no table of an older study.
    pub const fn with_column_if_given(mut self) -> Parameter {
        self.column = ColumnRule::IfGiven;
        self
    }
}

/// A choice that must be made for a parameter to apply: `law` is `velocity-control` or `tanh`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Condition {
    /// The parameter with the choice.
    pub governor: &'static str,
    /// Its names with which the parameter applies.
    pub names: &'static [&'static str],
    /// Whether a list of it is no axis for the other names, instead of a fault.
    pub collapses: bool,
}

impl Condition {
    /// Whether the parameter applies with this name of the governor.
    pub fn allows(&self, name: &str) -> bool {
        self.names.contains(&name)
    }

    /// The names in a sentence: "velocity-control or tanh".
    pub fn choices(&self) -> String {
        match self.names {
            [] => String::new(),
            [one] => (*one).into(),
            [first @ .., last] => format!("{} or {last}", first.join(", ")),
        }
    }
}

/// Which tables of results have a column of a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColumnRule {
    /// All.
    Always,
    /// Those of studies in which a block gives the parameter.
    IfGiven,
}

/// The row of a table with this name, for constants: a name that is not in the table does not compile.
pub const fn row_of(table: &[Parameter], name: &str) -> usize {
    let mut row = 0;
    while row < table.len() {
        if same(text(&table[row].name), name) {
            return row;
        }
        row += 1;
    }
    panic!("no such parameter")
}

/// The declared type of a parameter; decoding depends on nothing else.
#[derive(Debug, Clone, Copy)]
pub enum Kind {
    /// A real number in a range; a string is an expression.
    Number(Range),
    /// An integer from `min` to `max`.
    Whole {
        /// Smallest value allowed.
        min: u64,
        /// Largest value allowed.
        max: u64,
    },
    /// One of several names, each with its meaning.
    Choice(&'static [(&'static str, &'static str)]),
}

/// The value of a parameter that the study does not give.
#[derive(Debug, Clone)]
pub enum Default {
    /// It must be given, if it applies.
    Required,
    /// This value.
    Is(Value),
    /// It follows from others, as this text describes; `Problem::complete` fills it in.
    Follows(Text),
}

/// One value of one parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// Of a `Kind::Number`.
    Number(f64),
    /// Of a `Kind::Whole`.
    Whole(u64),
    /// Of a `Kind::Choice`: the name in the table.
    Name(&'static str),
}

impl Value {
    /// The name; empty for a number.
    pub fn name(self) -> &'static str {
        match self {
            Value::Name(name) => name,
            Value::Number(_) | Value::Whole(_) => "",
        }
    }

    /// The value as a number, for axes and sums; `None` for a name.
    pub fn as_f64(self) -> Option<f64> {
        match self {
            Value::Number(x) => Some(x),
            Value::Whole(n) => Some(n as f64),
            Value::Name(_) => None,
        }
    }

    /// The value as a cell of a table, in which a column of numbers has a point or an exponent.
    pub fn cell(self) -> String {
        match self {
            Value::Number(x) => real(x),
            Value::Whole(_) | Value::Name(_) => self.to_string(),
        }
    }

    /// A key that is different for different values of a parameter: all bits of a number, or a name.
    pub fn identity(self) -> (u64, &'static str) {
        match self {
            Value::Number(x) => (x.to_bits(), ""),
            Value::Whole(n) => (n, ""),
            Value::Name(name) => (0, name),
        }
    }

    /// Whether two values are the same in all bits, or both missing.
    pub fn identical(a: Option<Value>, b: Option<Value>) -> bool {
        match (a, b) {
            (Some(Value::Number(a)), Some(Value::Number(b))) => a.to_bits() == b.to_bits(),
            // Names in the table: mostly the same memory.
            (Some(Value::Name(a)), Some(Value::Name(b))) => std::ptr::eq(a, b) || a == b,
            (a, b) => a == b,
        }
    }

    /// Whether two values are the same: numbers within 1e-12 relative, names exactly.
    pub fn matches(self, other: Value) -> bool {
        match (self.as_f64(), other.as_f64()) {
            (Some(a), Some(b)) => (a - b).abs() <= 1e-12 * a.abs().max(b.abs()),
            (None, _) | (_, None) => self == other,
        }
    }

    /// Whether it matches one of `others`.
    pub fn is_one_of(self, others: &[Value]) -> bool {
        others.iter().any(|other| self.matches(*other))
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Number(x) => f.write_str(&shortest(*x)),
            Value::Whole(n) => write!(f, "{n}"),
            Value::Name(name) => f.write_str(name),
        }
    }
}
