//! Studies and pages as a user has them: faults, the language, findings and advice tested by results.

#[path = "../common/mod.rs"]
mod common;

mod advice;
mod answers;
mod bad_studies;
mod every_case;
mod findings;
mod guide;
mod samples;
mod study_language;
mod units;
mod versions;
