//! The schema of a problem: the tables that decoding, columns, figures, messages and documentation read. It is data of the
//! problem, so that a problem may build it from a study.

use super::parameter::{self, Parameter};
use super::text::text;
pub use super::text::{Table, Text};
use super::unit::{Dimension, Unit};
use std::borrow::Cow;

/// The tables of a problem.
#[derive(Debug, Clone)]
pub struct Schema {
    /// Its name in a study's `problem`.
    pub name: Text,
    /// What it is, in one sentence.
    pub meaning: Text,
    /// The parameters of a case.
    pub parameters: Table<Parameter>,
    /// The metrics; those of every study first.
    pub metrics: Table<Metric>,
    /// Row of a default metric that is empty exactly where no contact happens; `None` for a problem without impacts.
    pub contact_metric: Option<usize>,
    /// The channels of a history.
    pub channels: Table<Channel>,
    /// What history figures can draw; the first is the response itself.
    pub quantities: Table<Quantity>,
    /// What profile figures can draw; none for a problem without extent.
    pub profiles: Table<Profile>,
    /// The errors that budget figures can divide into parts.
    pub budgets: Table<Budget>,
    /// Rows of the parameters that are the time step and the duration.
    pub step: usize,
    /// See `step`.
    pub duration: usize,
    /// The time axis.
    pub time: TimeAxis,
    /// Title of the axis along the structure, for profiles.
    pub place_title: Text,
    /// Names of the numbers about the event that follows a case's own, for claims; none for a problem without such an event.
    pub later: Table<Text>,
    /// Symbols of the scales that results are given in, each with its formula and meaning.
    pub scales: Table<[Text; 2]>,
    /// The units of scaled results; none for a problem whose parameters have no units.
    pub units: Table<Unit>,
    /// Pairs of parameters of which one is given and the other follows.
    pub alternatives: Table<[Text; 2]>,
}

impl Schema {
    /// Name of the parameter that is the time step.
    pub fn step_name(&self) -> &str {
        &self.parameters[self.step].name
    }

    /// How many metrics every study has: the first of the table.
    pub fn default_metrics(&self) -> usize {
        self.metrics.iter().take_while(|m| m.default).count()
    }
}

/// The time axis of histories.
#[derive(Debug, Clone)]
pub struct TimeAxis {
    /// Its column in histories.
    pub column: Text,
    /// Its title, in the markup of `figures::markup`.
    pub title: Text,
    /// Whether its ticks are at multiples of pi.
    pub in_pi: bool,
}

/// A quantity over time, computed and exact: one column of a history, and one with `_exact` behind its name where `exact` is
/// set.
#[derive(Debug, Clone)]
pub struct Channel {
    /// Its column.
    pub name: Text,
    /// What it measures.
    pub dimension: Dimension,
    /// Whether histories have the column of the exact motion too.
    pub exact: bool,
}

impl Channel {
    /// A channel with its column of the exact motion, for tables.
    pub const fn with_exact(name: &'static str, dimension: Dimension) -> Channel {
        Channel {
            name: Cow::Borrowed(name),
            dimension,
            exact: true,
        }
    }

    /// A channel without it.
    pub const fn computed(name: &'static str, dimension: Dimension) -> Channel {
        Channel {
            name: Cow::Borrowed(name),
            dimension,
            exact: false,
        }
    }
}

/// One column of results.csv beyond the parameters.
#[derive(Debug, Clone)]
pub struct Metric {
    /// Column name.
    pub name: Text,
    /// How figures write it, with its scale.
    pub symbol: Text,
    /// Name of one of the schema's units, or `1`.
    pub unit: Text,
    /// Formula in words, for schema and documentation.
    pub meaning: Text,
    /// Whether every study has the column, or only those that ask for it.
    pub default: bool,
}

/// The row of a table of metrics that has this name, for constants: a name that is not there does not compile.
pub const fn metric_of(table: &[Metric], name: &str) -> usize {
    let mut row = 0;
    while row < table.len() {
        if parameter::same(text(&table[row].name), name) {
            return row;
        }
        row += 1;
    }
    panic!("no such metric")
}

/// A quantity that history figures can draw.
#[derive(Debug, Clone)]
pub struct Quantity {
    /// Its name in a figure's `y`.
    pub name: Text,
    /// Axis title, in the markup of `figures::markup`.
    pub title: Text,
    /// The channel, from 0.
    pub channel: usize,
    /// Whether it is the computed channel minus the exact one, not both.
    pub error: bool,
}

impl Quantity {
    /// A channel, computed and exact, for tables.
    pub const fn of(name: &'static str, title: &'static str, channel: usize) -> Quantity {
        Quantity {
            name: Cow::Borrowed(name),
            title: Cow::Borrowed(title),
            channel,
            error: false,
        }
    }

    /// The error of a channel.
    pub const fn error_of(name: &'static str, title: &'static str, channel: usize) -> Quantity {
        Quantity {
            name: Cow::Borrowed(name),
            title: Cow::Borrowed(title),
            channel,
            error: true,
        }
    }
}

/// An error and its parts, for budget figures.
#[derive(Debug, Clone)]
pub struct Budget {
    /// Its name in a figure's `y`.
    pub name: Text,
    /// Axis title, in the markup of `figures::markup`.
    pub title: Text,
    /// Row of the table of metrics.
    pub total: usize,
    /// The name of each part, and its row.
    pub parts: Table<(Text, usize)>,
}

impl Budget {
    /// Rows of the total and of its parts.
    pub fn metrics(&self) -> Vec<usize> {
        let parts = self.parts.iter().map(|part| part.1);
        std::iter::once(self.total).chain(parts).collect()
    }
}

/// A quantity along the structure that profile figures can draw.
#[derive(Debug, Clone)]
pub struct Profile {
    /// Its name in a figure's `y`.
    pub name: Text,
    /// Axis title, in the markup of `figures::markup`.
    pub title: Text,
}
