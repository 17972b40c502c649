//! Metrics of textbook problems as rows: the texts of each together with what computes it.

use std::ops::Range;

/// A table of metrics, and the function that computes all of them in its order from what they share. A row has the names and the meaning of
/// a metric and its value, so that one without the other does not compile. The function is generic over lanes if it has a name for their
/// count.
macro_rules! metric_rows {
    (
        $(#[$doc:meta])*
        $default:ident $table:ident,
        $(#[$doc_of_values:meta])*
        fn $values:ident$([$lanes:ident])?($of:ident: $context:ty) -> $cell:ty;
        $($names:expr, $meaning:literal => $value:expr;)+
    ) => {
        $(#[$doc])*
        pub static $table: [$crate::problem::Metric; [$($meaning),+].len()] =
            [$($crate::problem::Metric::$default($names, $meaning)),+];

        $(#[$doc_of_values])*
        #[inline(always)]
        pub fn $values$(<const $lanes: usize>)?($of: $context) -> [$cell; [$($meaning),+].len()] {
            [$($value),+]
        }
    };
}

pub(in crate::problem) use metric_rows;

/// The groups of the metrics of a textbook problem: their rows, or their values.
pub struct Groups<T> {
    /// Those of all studies.
    pub default: T,
    /// The parts of the error.
    pub parts: T,
    /// Those of the exact motion.
    pub exact: T,
    /// What the method and the contact take, and the cost.
    pub taken: T,
    /// The errors of the references.
    pub errors: T,
}

impl<T> Groups<Vec<T>> {
    /// In the order of the table.
    pub fn in_order(self) -> Vec<T> {
        let Groups {
            mut default,
            parts,
            exact,
            taken,
            errors,
        } = self;
        for group in [parts, exact, taken, errors] {
            default.extend(group);
        }
        default
    }
}

impl Groups<usize> {
    /// The rows of the groups in the table, from the number of metrics of each.
    pub const fn rows(self) -> Groups<Range<usize>> {
        let parts = self.default + self.parts;
        let exact = parts + self.exact;
        let taken = exact + self.taken;
        Groups {
            default: 0..self.default,
            parts: self.default..parts,
            exact: parts..exact,
            taken: exact..taken,
            errors: taken..taken + self.errors,
        }
    }
}
