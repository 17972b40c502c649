//! Why numbers make no law.

use std::fmt;

/// Why the numbers of a contact make no law. Displayed as a rule that they break.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum LawFault {
    /// A law or a number, and what it needs besides.
    Needs(&'static str, &'static str),
    /// A law with neither of two numbers, both described.
    Missing(&'static str, &'static str),
    /// Two numbers of which only one may be given, both described.
    Both(&'static str, &'static str),
    /// One of two numbers that are given together.
    Together(&'static str, &'static str),
    /// The limit at rest, from which this number would follow.
    NoLimit {
        /// The limit.
        limit: f64,
        /// The number.
        instead: &'static str,
    },
    /// A restitution above 1.
    Restitution(f64),
    /// A table with a fault, described.
    Table(&'static str),
    /// A number that has to be positive.
    NotPositive(&'static str),
    /// A number above another one, both by their keys.
    AtMost {
        /// The number.
        key: &'static str,
        /// Its value.
        value: f64,
        /// The other one.
        most: &'static str,
        /// Its value.
        limit: f64,
    },
    /// nu_min above nu.
    LeastFriction {
        /// nu.
        nu: f64,
        /// nu_min.
        least: f64,
    },
}

impl fmt::Display for LawFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LawFault::Needs(one, other) => write!(f, "{one} needs {other}"),
            LawFault::Missing(one, other) => write!(f, "missing: {one}, or {other}"),
            LawFault::Both(one, other) => write!(f, "give {one} or {other}, not both"),
            LawFault::Together(one, other) => write!(f, "give {one} and {other} together"),
            LawFault::NoLimit { limit, instead } => {
                write!(f, "the limit at rest is {limit}; give {instead} instead")
            }
            LawFault::Restitution(e) => write!(f, "e must be from 0 to 1, got {e}"),
            LawFault::Table(why) => write!(f, "table: {why}"),
            LawFault::NotPositive(key) => write!(f, "{key} must be > 0"),
            LawFault::AtMost {
                key,
                value,
                most,
                limit,
            } => write!(f, "{key} must be at most {most} = {limit}, got {value}"),
            LawFault::LeastFriction { nu, least } => {
                write!(f, "nu_min must be at most nu = {nu}, got {least}")
            }
        }
    }
}

impl std::error::Error for LawFault {}
