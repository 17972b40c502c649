//! The schema of a problem: the tables for decoding, columns, figures, messages and documentation. It is data of the problem, so
//! that a problem may build it from a study.

use crate::problem::numbers::parameter::Parameter;
use crate::problem::numbers::text::text;
pub use crate::problem::numbers::text::{Table, Text};
use crate::problem::numbers::unit::{Dimension, Unit};
use std::borrow::Cow;
use std::sync::Arc;

/// The tables of a problem.
///
/// The parameters that are not given have their defaults; `[F]` releases the mass at 12 Delta:
///
/// ```
/// use slipgap_problem::problem::{self, numbers::parameter::Value};
///
/// let problem = problem::find("friction-oscillator").expect("a problem");
/// let schema = problem.schema();
/// let case = schema.case(&[("law", Value::Name("displacement-control")), ("alpha", Value::Number(0.1))]);
/// assert_eq!(case.number("x0"), Some(12.0));
/// assert_eq!(case.choice("initial_slip"), "unloaded");
/// // beta applies to the velocity-control model only.
/// assert_eq!(case.number("beta"), None);
/// assert_eq!(schema.step_name(), "dT");
/// ```
#[derive(Debug, Clone)]
pub struct Schema {
    /// Its name in a study's `problem`.
    pub name: Text,
    /// What it is, in one sentence.
    pub meaning: Text,
    /// Whether the study describes the system, with contacts of its own. If not, there is one contact, whose law is among the
    /// parameters, and the steps have the un-iterated form of the papers.
    pub described: bool,
    /// The parameters of a case.
    pub parameters: Table<Parameter>,
    /// The metrics; the default ones first.
    pub metrics: Table<Metric>,
    /// Row of a default metric that is empty if and only if there is no contact; `None` for a problem without impacts.
    pub contact_metric: Option<usize>,
    /// The channels of a history.
    pub channels: Table<Channel>,
    /// The quantities of history figures; the first one is the response.
    pub quantities: Table<Quantity>,
    /// The quantities of profile figures; none for a problem without extent.
    pub profiles: Table<Profile>,
    /// The errors of budget figures.
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
    /// Pairs of parameters; one is given and the other follows from it.
    pub alternatives: Table<[Text; 2]>,
}

impl Schema {
    /// Name of the parameter that is the time step.
    pub fn step_name(&self) -> &str {
        &self.parameters[self.step].name
    }

    /// The same with further parameters behind the others.
    pub fn with_parameters(&self, further: Vec<Parameter>) -> Arc<Schema> {
        let mut schema = self.clone();
        schema.parameters.to_mut().extend(further);
        Arc::new(schema)
    }

    /// Number of default metrics, which are the first ones of the table.
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

/// A quantity over time, computed and exact: one column of a history, and one with `_exact` after its name if `exact` is
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
    /// Its text in figures, with its scale.
    pub symbol: Text,
    /// Name of one of the schema's units, or `1`.
    pub unit: Text,
    /// Formula in words, for schema and documentation.
    pub meaning: Text,
    /// Whether all studies have the column; if not, a study selects it.
    pub default: bool,
    /// What an empty value means, in a legend.
    pub empty: Text,
}

/// What an empty value means, if the metric does not say more.
pub const NO_VALUE: &str = "no value";

impl Metric {
    /// A column of all studies, for tables.
    pub const fn new(names: [&'static str; 3], meaning: &'static str) -> Metric {
        Metric::row(names, meaning, true)
    }

    /// A column of the studies that select it.
    pub const fn selected(names: [&'static str; 3], meaning: &'static str) -> Metric {
        Metric::row(names, meaning, false)
    }

    /// The same with names that are made of parts.
    pub fn built([name, symbol, unit]: [String; 3], meaning: String) -> Metric {
        Metric {
            name: name.into(),
            symbol: symbol.into(),
            unit: unit.into(),
            meaning: meaning.into(),
            ..Metric::selected([""; 3], "")
        }
    }

    const fn row(
        [name, symbol, unit]: [&'static str; 3],
        meaning: &'static str,
        default: bool,
    ) -> Metric {
        Metric {
            name: Cow::Borrowed(name),
            symbol: Cow::Borrowed(symbol),
            unit: Cow::Borrowed(unit),
            meaning: Cow::Borrowed(meaning),
            default,
            empty: Cow::Borrowed(NO_VALUE),
        }
    }
}

/// The row of a table of metrics with this name, for constants: a name that is not in the table does not compile.
pub const fn metric_of(table: &[Metric], name: &str) -> usize {
    let mut row = 0;
    while row < table.len() {
        if crate::contact::number::same(text(&table[row].name), name) {
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
