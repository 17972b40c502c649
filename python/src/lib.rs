//! slipgap as a module of Python: `slipgap._slipgap`. The package `slipgap` has the functions with their types and
//! descriptions, and calls this module.

mod animation;
mod arrays;
mod calibrate;
mod case;
mod claims;
mod compare;
mod error;
mod given;
mod recommend;
mod results;
mod run;
mod units;
mod worker;

use pyo3::prelude::*;

/// The module `slipgap._slipgap`.
#[pymodule]
mod _slipgap {
    #[pymodule_export]
    use super::animation::Animation;
    #[pymodule_export]
    use super::animation::animate;
    #[pymodule_export]
    use super::calibrate::calibrate;
    #[pymodule_export]
    use super::case::exact::exact;
    #[pymodule_export]
    use super::case::solution::Solution;
    #[pymodule_export]
    use super::case::solve::solve;
    #[pymodule_export]
    use super::claims::claims;
    #[pymodule_export]
    use super::compare::compare;
    #[pymodule_export]
    use super::recommend::recommend;
    #[pymodule_export]
    use super::results::Results;
    #[pymodule_export]
    use super::results::arrow_table::Table;
    #[pymodule_export]
    use super::results::expand::{count, expand, titles};
    #[pymodule_export]
    use super::results::figure::Figure;
    #[pymodule_export]
    use super::run::run;
    #[pymodule_export]
    use super::schema;

    #[pymodule_export]
    #[expect(non_upper_case_globals, reason = "the name that Python has for it")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}

/// The JSON schema of study files as text.
#[pyfunction]
fn schema() -> String {
    slipgap::study::schema()
}
