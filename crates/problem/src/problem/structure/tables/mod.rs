//! The schema of a study of structures, its columns, and the rows of matrices that it names.

pub(crate) mod history_columns;
pub mod named_rows;
pub mod schema;

use crate::problem::numbers::parameter::Condition;

/// That a parameter is one of these programs alone; `None` for one of all methods. For other methods its values are no axis.
pub fn of_programs(programs: &'static [&'static str]) -> Option<Condition> {
    (!programs.is_empty()).then_some(Condition {
        governor: "method",
        names: programs,
        collapses: true,
    })
}
