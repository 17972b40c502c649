//! A contact as a study describes it.

use super::along::Term;
use crate::problem::structure::given::amount::Amount;
use crate::problem::structure::given::chosen::Chosen;
use crate::problem::structure::given::shape::Scaled;
use crate::problem::structure::given::source::Source;
use crate::problem::{Case, Violation};
use crate::system::structure::PlaneRow;

/// A contact. The numbers that its law does not use are not looked at.
#[derive(Debug, Clone)]
pub struct Contact {
    /// Its name.
    pub name: String,
    /// Byte offset and path of the contact in the study.
    pub place: (usize, String),
    /// The nodes whose displacements make r.
    pub along: Vec<Term>,
    /// The direction of a contact in a plane, whose directions follow each other.
    pub row: Option<PlaneRow>,
    /// Its law.
    pub law: Chosen,
    /// r at rest; none for 0.
    pub gap: Option<Amount>,
    /// Force that presses.
    pub normal: Option<Normal>,
    /// Its table of r and S.
    pub table: Option<[Vec<Amount>; 2]>,
    /// Its numbers but the normal force and the table, by their keys ([`super::contact_law::NUMBERS`]).
    pub numbers: Vec<(&'static str, Amount)>,
}

impl Contact {
    /// A number, if the contact has it.
    pub fn number(&self, key: &str) -> Option<&Amount> {
        let found = self.numbers.iter().find(|number| number.0 == key);
        found.map(|(_, amount)| amount)
    }

    /// Its value in a case.
    ///
    /// # Errors
    /// It is out of its range.
    pub fn value(&self, key: &str, case: &Case) -> Result<Option<f64>, Violation> {
        self.number(key)
            .map(|amount| amount.value(case))
            .transpose()
    }

    /// The points of its table in a case; empty without one.
    ///
    /// # Errors
    /// A number is out of its range.
    pub fn table(&self, case: &Case) -> Result<Vec<[f64; 2]>, Violation> {
        let [r, s] = match &self.table {
            Some(table) => table,
            None => return Ok(Vec::new()),
        };
        let points = r.iter().zip(s);
        points
            .map(|(r, s)| Ok([r.value(case)?, s.value(case)?]))
            .collect()
    }
}

/// The normal force of a friction contact, positive when pressed.
#[derive(Debug, Clone)]
pub enum Normal {
    /// Constant.
    Constant(Amount),
    /// A function of time.
    Table(Source),
    /// W (1 + a/g).
    Weight {
        /// W.
        weight: Amount,
        /// a, the vertical acceleration.
        vertical: Scaled,
    },
    /// The forces of other contacts and of springs at the end of each step.
    Parts(Vec<PressingPart>),
}

/// A contact or a spring that a normal force names.
#[derive(Debug, Clone)]
pub struct PressingPart {
    /// Its name.
    pub name: String,
    /// Which one.
    pub part: Pressing,
    /// Byte offset and path of the name in the study.
    pub place: (usize, String),
}

/// A part that may press a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pressing {
    /// A contact, by its place in the list.
    Contact(usize),
    /// A spring, by its place in the list.
    Spring(usize),
}
