//! Names of the units that a study's parameters are in, and of the columns and titles in these units.

use slipgap_problem::problem::Problem;
use slipgap_problem::problem::numbers::unit::Dimension;

/// The message for results in units in a study without the key.
pub(crate) const NEEDS_UNITS: &str = "results in units need the key \"units\" of the study";

/// Names of the units of the parameters of a study. The program converts nothing; the units must be consistent.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Units {
    pub(crate) length: String,
    pub(crate) force: String,
    pub(crate) time: String,
}

impl Units {
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
            Dimension::Acceleration => format!("{}{over}{}2", self.length, self.time),
            Dimension::Force => self.force.clone(),
            Dimension::Energy => {
                let times = if over == "/" { " " } else { "_" };
                format!("{}{times}{}", self.force, self.length)
            }
        }
    }
}

/// The text between metric and unit in the name of a column. No name of a table contains it.
pub(crate) const IN: &str = "_in_";

/// The metric in the name of a column in units.
pub fn scaled(column: &str) -> Option<&str> {
    column.split_once(IN).map(|(scaled, _)| scaled)
}
