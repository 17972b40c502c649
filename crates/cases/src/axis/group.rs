//! The axes of a block, in groups.

use super::values::Values;
use crate::filter::Filter;

/// Axes that advance together.
#[derive(Debug, Clone)]
pub struct AxisGroup {
    /// At least one, all of one length.
    pub axes: Vec<Axis>,
}

/// The values of one parameter.
#[derive(Debug, Clone)]
pub struct Axis {
    /// Row of `problem.parameters()`.
    pub parameter: usize,
    /// At least one value.
    pub values: Values,
}

impl AxisGroup {
    /// Number of values.
    pub fn len(&self) -> u64 {
        self.axes.first().map_or(0, |axis| axis.values.len() as u64)
    }

    /// Whether the group has no values. No valid study has such a group.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether one of the axes has this parameter.
    pub fn has(&self, parameter: usize) -> bool {
        self.axes.iter().any(|axis| axis.parameter == parameter)
    }

    /// The positions whose values a filter accepts.
    pub fn positions(&self, filter: &Filter) -> Vec<u64> {
        let accepted = |position: u64| {
            self.axes.iter().all(|axis| {
                let mut terms = filter.0.iter().filter(|(row, _)| *row == axis.parameter);
                terms.all(|(_, wanted)| axis.values.at(position as usize).is_one_of(wanted))
            })
        };
        (0..self.len())
            .filter(|position| accepted(*position))
            .collect()
    }
}
