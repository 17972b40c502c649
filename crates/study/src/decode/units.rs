//! The key `units`.

use crate::source::faults::Faults;
use crate::source::field::{Keys, Kind, fields, needed};
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::units::Units;
use crate::value::text;
use slipgap_problem::problem::Problem;

/// The keys of `units`.
pub(crate) const KEYS: Keys = Keys::new(&fields![
    /// name of the unit of length, as in mm: 1 to 16 letters, digits and µ, first a letter or µ
    needed("length", Kind::Like(NAME)),
    /// name of the unit of force, as in kN
    needed("force", Kind::Like(NAME)),
    /// name of the unit of time, as in ms
    needed("time", Kind::Like(NAME)),
]);

/// The name of a unit.
pub(crate) const NAME: &str = "^[A-Za-zµ][A-Za-z0-9µ]{0,15}$";

/// Longest name of a unit, in characters.
const LONGEST: usize = 16;

impl Units {
    /// Decodes the key; `None` if it has a fault.
    pub(crate) fn decode(
        node: &Node,
        problem: Option<&dyn Problem>,
        faults: &mut Faults,
    ) -> Option<Units> {
        let path = "units";
        if let Some(problem) = problem.filter(|problem| problem.schema().units.is_empty()) {
            let name = problem.name();
            let message = match problem.schema().described {
                true => "a structure names its units in \"structure\": \"units\": \"t, kN, m, s\""
                    .to_owned(),
                false => {
                    format!("{name} has no units: all its parameters and results are dimensionless")
                }
            };
            faults.add(node.at, path, message);
            return None;
        }
        let object = Object::open(node, path, &KEYS, faults)?;
        let [length, force, time] = ["length", "force", "time"].map(|key| {
            let (node, path) = object.given(key, faults)?;
            label(node, &path, faults)
        });
        Some(Units {
            length: length?,
            force: force?,
            time: time?,
        })
    }
}

/// The name of a unit: it becomes part of a column's name and of a label in markup.
fn label(node: &Node, path: &str, faults: &mut Faults) -> Option<String> {
    let label = text(node, path, faults)?;
    let allowed = |(index, c): (usize, char)| {
        c == 'µ' || c.is_ascii_alphabetic() || index > 0 && c.is_ascii_digit()
    };
    let count = label.chars().count();
    if (1..=LONGEST).contains(&count) && label.chars().enumerate().all(allowed) {
        return Some(label);
    }
    let what =
        format!("the name of a unit: 1 to {LONGEST} letters, digits and µ, first a letter or µ");
    faults.must_be(node, path, &what);
    None
}
