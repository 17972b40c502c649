//! Why a case has no solution.

use crate::contact::{OwnFault, Unsolved};
use std::fmt;

/// Why a case has no solution.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Unsolvable {
    /// A parameter that the problem needs has no value.
    ParameterMissing,
    /// The motion leaves the range of double precision.
    OutOfRange,
    /// The equation of a step, from 1, has no solution.
    NoSolution {
        /// The step.
        step: usize,
    },
    /// The contacts have no forces at a step; 0 is the start.
    NoForces {
        /// The step.
        step: usize,
        /// Why.
        why: Unsolved,
    },
    /// The law of a user's program has no answer to a step that can be taken; 0 is the start.
    OwnLaw {
        /// The step.
        step: usize,
        /// Name of the contact.
        contact: String,
        /// Why.
        why: OwnFault,
    },
    /// 4/dt^2 M + 2/dt C + K is not positive definite.
    Indefinite {
        /// A node with a pivot that is not positive.
        node: String,
    },
    /// The same, because of a negative stiffness: shorter steps have a positive definite matrix.
    TooLongStep {
        /// A node with a pivot that is not positive.
        node: String,
        /// About the longest step that is allowed.
        longest: String,
    },
    /// The static loads have no equilibrium.
    NoEquilibrium {
        /// A node that nothing holds.
        node: String,
    },
    /// The mass matrix has no inverse.
    SingularMass,
    /// The un-iterated form would be too large.
    TooManyElements {
        /// Largest number of elements allowed.
        most: u32,
        /// Number of elements of the case.
        elements: u32,
    },
    /// The papers do not print the law of the case, so that there is no un-iterated form.
    NotPrinted,
    /// The exact motion that a metric needs cannot be computed, for this reason.
    Reference(String),
    /// The structure has too many nodes for its modes.
    NoModes,
    /// The parameters break rules of the problem, in these words.
    BrokenRules(String),
    /// A program of others does not compute the case, for this reason.
    Program(String),
    /// A reason that a store contains.
    Stored(String),
}

impl Unsolvable {
    /// The same with the name of the contact whose law has no answer.
    pub(crate) fn with_name<'a>(self, name: impl Fn(usize) -> &'a str) -> Unsolvable {
        let Unsolvable::NoForces {
            step,
            why: Unsolved::Own { contact, why },
        } = self
        else {
            return self;
        };
        Unsolvable::OwnLaw {
            step,
            contact: name(contact).to_owned(),
            why,
        }
    }
}

impl fmt::Display for Unsolvable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Unsolvable::ParameterMissing => f.write_str("a parameter is not given"),
            Unsolvable::OutOfRange => {
                f.write_str("the motion leaves the range of double precision")
            }
            Unsolvable::NoSolution { step } => write!(f, "step {step} has no solution"),
            Unsolvable::NoForces { step, why } => write!(f, "step {step}: {why}"),
            Unsolvable::OwnLaw { step, contact, why } => {
                write!(f, "step {step}: the law of contact {contact} {why}")
            }
            Unsolvable::Indefinite { node } => write!(
                f,
                "the matrix of a step, 4/dt^2 M + 2/dt C + K, is not positive definite at node {node}"
            ),
            Unsolvable::TooLongStep { node, longest } => write!(
                f,
                "the matrix of a step, 4/dt^2 M + 2/dt C + K, is not positive definite at node {node}: K pulls it away; allowed: dt up to about {longest}"
            ),
            Unsolvable::NoEquilibrium { node } => write!(
                f,
                "the static loads have no equilibrium: nothing holds node {node} against them"
            ),
            Unsolvable::SingularMass => f.write_str("the mass matrix has no inverse"),
            Unsolvable::TooManyElements { most, elements } => write!(
                f,
                "without iteration there may be at most {most} elements, got {elements}"
            ),
            Unsolvable::NotPrinted => f.write_str("the law has no un-iterated form"),
            Unsolvable::Reference(why) => write!(f, "no exact motion: {why}"),
            Unsolvable::NoModes => f.write_str("modal damping is allowed for at most 1000 nodes"),
            Unsolvable::BrokenRules(words)
            | Unsolvable::Program(words)
            | Unsolvable::Stored(words) => f.write_str(words),
        }
    }
}

impl std::error::Error for Unsolvable {}
