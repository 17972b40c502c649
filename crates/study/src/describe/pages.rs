//! The reference pages of study files: prose with lists from the tables that decode them.

use super::reference::{code, list, methods, problem_page, warnings};
use super::{figures, structure_page};
use crate::axes::axis_rule::RULES;
use crate::axes::design;
use crate::axes::interval::INTERVALS;
use crate::calibrate;
use crate::computed::sources::NAMED;
use crate::decode::blocks::BLOCK_KEYS;
use crate::decode::{self, checks, units};
use crate::figure::reduced;
use crate::reduction::OPERATORS;
use crate::source::field::Keys;
use slipgap_problem::problem::PROBLEMS;
use slipgap_problem::problem::expression::{CONSTANTS, FUNCTIONS};

/// The pages beside the general one, docs/study-files.md: one for each problem.
pub fn problem_pages() -> Vec<&'static str> {
    let problems = PROBLEMS.iter().map(|problem| problem.name());
    problems.chain([structure_page::PAGE]).collect()
}

/// docs/study-files-PROBLEM.md; `None` for a name that no problem has.
pub fn problem_reference(name: &str) -> Option<String> {
    if name == structure_page::PAGE {
        return Some(structure_page::reference());
    }
    let problem = PROBLEMS.iter().find(|problem| problem.name() == name)?;
    Some(problem_page(&**problem))
}

/// docs/study-files.md.
pub fn reference() -> String {
    let functions = FUNCTIONS.map(|function| function.0);
    include_str!("reference.md")
        .replace("{{study}}", &list(&decode::OF_STUDY.rows()))
        .replace("{{units}}", &list(&units::KEYS.rows()))
        .replace("{{rules}}", &list(&RULES.rows()))
        .replace("{{constants}}", &code(&CONSTANTS))
        .replace("{{functions}}", &code(&functions))
        .replace("{{beside}}", &list(&Keys::new(BLOCK_KEYS).rows()))
        .replace("{{intervals}}", &list(&INTERVALS.rows()))
        .replace("{{designs}}", &list(&design::KINDS))
        .replace("{{design}}", &list(&design::KEYS.rows()))
        .replace("{{methods}}", &methods())
        .replace("{{named}}", &list(&NAMED.rows()))
        .replace("{{figures}}", &figures::reference())
        .replace("{{words}}", &list(&OPERATORS))
        .replace("{{reduced}}", &code(&reduced::KINDS))
        .replace("{{calibrate}}", &list(&calibrate::decode::KEYS.rows()))
        .replace("{{recommend}}", &list(&calibrate::recommend::KEYS.rows()))
        .replace("{{checks}}", &list(&checks::KEYS.rows()))
        .replace("{{warnings}}", &warnings())
}
