//! The key `units`: names of the units that a study's parameters are in.

use super::object::Object;
use super::report::Faults;
use super::tree::Node;
use super::value::text;
use crate::problem::Problem;
use crate::problem::unit::Dimension;

/// The keys of `units`.
pub(super) const KEYS: [(&str, &str); 3] = [
    (
        "length",
        "name of the unit of length, as in mm: 1 to 16 letters, digits and µ, first a letter or µ",
    ),
    ("force", "name of the unit of force, as in kN"),
    ("time", "name of the unit of time, as in ms"),
];

/// What is wrong where a study asks for results in units without saying which.
pub(super) const NEEDS_UNITS: &str = "results in units need the key \"units\" of the study";

/// Longest name of a unit, in characters.
pub(super) const LONGEST: usize = 16;

/// Names of the units of a study's parameters. The program converts nothing: the units have to agree with each other.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Units {
    length: String,
    force: String,
    time: String,
}

impl Units {
    /// Decodes the key; `None` if it has a fault.
    pub(super) fn decode(
        node: &Node,
        problem: Option<&dyn Problem>,
        faults: &mut Faults,
    ) -> Option<Units> {
        let path = "units";
        if let Some(problem) = problem.filter(|problem| problem.schema().units.is_empty()) {
            let message = format!(
                "{} has no units: all its parameters and results are dimensionless",
                problem.name()
            );
            faults.add(node.at, path, message);
            return None;
        }
        let object = Object::open(node, path, &KEYS.map(|key| key.0), faults)?;
        let mut label = |(key, what): (&str, &str)| {
            let node = object.need(key, what, faults)?;
            label(node, &object.path(key), faults)
        };
        let [length, force, time] = KEYS.map(&mut label);
        Some(Units {
            length: length?,
            force: force?,
            time: time?,
        })
    }

    /// The unit of a dimension, as figures write it.
    pub fn of(&self, dimension: Dimension) -> String {
        self.joined(dimension, "/")
    }

    /// The name of a column in the units of the study: `peak_force` as `peak_force_in_kN`.
    pub fn column(&self, scaled: &str, dimension: Dimension) -> String {
        format!("{scaled}{IN}{}", self.joined(dimension, "_per_"))
    }

    /// A scaled title or symbol in units: `*F*/*F*_0_` as `*F* (kN)`.
    pub fn title(&self, problem: &dyn Problem, scaled: &str, dimension: Dimension) -> String {
        let mut known = problem.schema().units.iter();
        let scale = known.find(|unit| unit.dimension == dimension);
        let bare = scaled.replacen(scale.map_or("", |scale| &scale.over), "", 1);
        format!("{bare} ({})", self.of(dimension))
    }

    fn joined(&self, dimension: Dimension, over: &str) -> String {
        match dimension {
            Dimension::Time => self.time.clone(),
            Dimension::Length => self.length.clone(),
            Dimension::Velocity => format!("{}{over}{}", self.length, self.time),
            Dimension::Force => self.force.clone(),
        }
    }
}

/// What separates a metric from its unit in the name of a column; no name of a table has it.
pub(super) const IN: &str = "_in_";

/// The metric of which a column in units has the name.
pub fn scaled(column: &str) -> Option<&str> {
    column.split_once(IN).map(|(scaled, _)| scaled)
}

/// The name of a unit: it becomes part of a column's name and of a label in markup.
fn label(node: &Node, path: &str, faults: &mut Faults) -> Option<String> {
    let label = text(node, path, faults)?;
    let fits = |(place, c): (usize, char)| {
        c == 'µ' || c.is_ascii_alphabetic() || place > 0 && c.is_ascii_digit()
    };
    let count = label.chars().count();
    if (1..=LONGEST).contains(&count) && label.chars().enumerate().all(fits) {
        return Some(label);
    }
    let what =
        format!("the name of a unit: 1 to {LONGEST} letters, digits and µ, first a letter or µ");
    faults.must_be(node, path, &what);
    None
}
