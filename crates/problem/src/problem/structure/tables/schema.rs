//! The schema of a study of structures: its own parameters, metrics and channels.

use crate::problem::method::PARAMETERS;
use crate::problem::numbers::parameter::{ColumnRule, Default, Kind, Parameter, Range};
use crate::problem::numbers::unit::Dimension;
use crate::problem::structure::channels::channel::Channel;
use crate::problem::structure::channels::channel_words::Words;
use crate::problem::structure::metrics::metric::StructureMetric;
use crate::problem::structure::metrics::reduction::Reduction;
use crate::problem::structure::metrics::title::title as metric_title;
use crate::problem::structure::metrics::unit_names::UnitNames;
use crate::problem::table::schema::{Channel as Column, Metric, NO_VALUE, Quantity, TimeAxis};
use crate::problem::{Budget, Schema, Text, escape};
use slipgap_notation::{capital, unit};
use std::borrow::Cow::{self, Borrowed};
use std::sync::Arc;

/// Name of the problem in studies.
pub const NAME: &str = "structure";

/// What the problem is.
pub const MEANING: &str = "a structure of masses, bars and springs with any number of contacts, under loads and ground motion";

/// The parameters that every study of structures has, each with its meaning.
pub const FIXED: [(&str, &str); 2] = [
    ("dt", "time step; at most duration"),
    ("duration", "end of the motion"),
];

/// A parameter that the study names.
#[derive(Debug, Clone, Default)]
pub struct Named {
    /// Its name.
    pub name: String,
    /// The names that it chooses from; none for a number.
    pub choices: Option<&'static [(&'static str, &'static str)]>,
    /// The name and the unit that figures have instead of its own, if the study gives them.
    pub shown: Option<[String; 2]>,
    /// Its unit, if the parts that contain it and the units of the study tell it.
    pub unit: Option<String>,
    /// The names that figures have instead of files of records and of programs.
    pub shown_values: Vec<(String, String)>,
    /// Whether the structure itself contains it. If not, other parameters or a condition do, and a block may lack it.
    pub required: bool,
    /// The programs that alone have it; empty for a parameter of all methods.
    pub programs: &'static [&'static str],
}

/// A quantity of history figures.
#[derive(Debug, Clone)]
pub struct Drawn {
    /// Its name in a figure.
    pub name: String,
    /// Its channel.
    pub channel: Channel,
    /// Whether it is the error of the channel.
    pub error: bool,
    /// Byte offset and path of the text in the study.
    pub place: (usize, String),
}

/// The schema of these parameters, metrics and quantities. Channel i is that of quantity i. `units` are those of the study, such as
/// `t, kN, m, s`; titles have them, and the words of channels.
pub fn schema(
    named: &[Named],
    metrics: &[StructureMetric],
    drawn: &[Drawn],
    (units, words): (&str, Words),
) -> Arc<Schema> {
    let units = UnitNames::of(units);
    let of = |dimension: Dimension| units.map(|units| units.of_dimension(dimension));
    let parameters: Vec<Parameter> = named.iter().map(parameter).collect();
    let row = |name: &str| named.iter().position(|p| p.name == name).unwrap_or(0);
    let unit_of = |metric: &StructureMetric| {
        let given = units.and_then(|units| units.of_metric(metric, words));
        given.or_else(|| {
            let in_unit = metric.reduction.is_in_unit_of_channel();
            words.unit(metric.channel.as_ref().filter(|_| in_unit)?, |_| None)
        })
    };
    let metric = |metric: &StructureMetric| Metric {
        name: metric.name.clone().into(),
        symbol: in_unit(
            title(&metric_title(metric, words, units.map(|names| names.time))),
            unit_of(metric),
        )
        .into(),
        unit: unit_of(metric).map_or(Borrowed("1"), Text::Owned),
        meaning: Borrowed(metric.meaning()),
        default: true,
        empty: Borrowed(match metric.reduction == Reduction::Divergence {
            true => "never",
            false => NO_VALUE,
        }),
    };
    let channel = |drawn: &Drawn| Column {
        name: drawn.name.clone().into(),
        dimension: drawn.channel.dimension(),
        exact: false,
    };
    let quantity = |(channel, drawn): (usize, &Drawn)| Quantity {
        name: drawn.name.clone().into(),
        title: capital(&in_unit(
            title(&match drawn.error {
                true => format!("error of {}", words.channel(&drawn.channel)),
                false => words.channel(&drawn.channel),
            }),
            words.unit(&drawn.channel, of),
        ))
        .into(),
        channel,
        error: drawn.error,
    };
    Arc::new(Schema {
        name: Borrowed(NAME),
        meaning: Borrowed(MEANING),
        step: row(FIXED[0].0),
        duration: row(FIXED[1].0),
        described: true,
        parameters: parameters.into(),
        metrics: metrics.iter().map(metric).collect::<Vec<_>>().into(),
        contact_metric: None,
        channels: drawn.iter().map(channel).collect::<Vec<_>>().into(),
        quantities: drawn
            .iter()
            .enumerate()
            .map(quantity)
            .collect::<Vec<_>>()
            .into(),
        profiles: Cow::default(),
        budgets: budgets(metrics, of, words).into(),
        time: TimeAxis {
            column: Borrowed("t"),
            title: in_unit("Time *t*".to_owned(), of(Dimension::Time)).into(),
            in_pi: false,
        },
        place_title: Borrowed(""),
        later: Cow::default(),
        scales: Cow::default(),
        units: Cow::default(),
        alternatives: Cow::default(),
    })
}

/// A budget of each channel of which the study has the error and its parts.
fn budgets(
    metrics: &[StructureMetric],
    unit: impl Fn(Dimension) -> Option<String> + Copy,
    words: Words,
) -> Vec<Budget> {
    let row = |reduction: Reduction, channel: &Channel| {
        let same = |metric: &StructureMetric| {
            metric.is_exact(reduction) && metric.channel.as_ref() == Some(channel)
        };
        metrics.iter().position(same)
    };
    let of = |channel: &Channel| {
        let total = row(Reduction::RmsError, channel)?;
        let parts: Vec<(Text, usize)> = [
            ("regularisation", Reduction::RegularisationError),
            ("mesh", Reduction::MeshError),
            ("step", Reduction::StepError),
        ]
        .into_iter()
        .filter_map(|(name, part)| Some((Borrowed(name), row(part, channel)?)))
        .collect();
        (!parts.is_empty()).then(|| Budget {
            name: channel.name.clone().into(),
            title: in_unit(
                format!("Rms error of {}", title(&words.channel(channel))),
                words.unit(channel, unit),
            )
            .into(),
            total,
            parts: parts.into(),
        })
    };
    let channels = metrics.iter().filter_map(|metric| metric.channel.as_ref());
    let mut budgets: Vec<Budget> = Vec::new();
    for budget in channels.filter_map(of) {
        if !budgets.iter().any(|known| known.name == budget.name) {
            budgets.push(budget);
        }
    }
    budgets
}

/// A number with a free name.
pub fn named(name: &str) -> Parameter {
    parameter(&Named {
        name: name.to_owned(),
        ..Named::default()
    })
}

/// Whether a parameter belongs to the method of integration; its row is the one of all problems.
pub fn of_method(name: &str) -> bool {
    PARAMETERS.iter().any(|parameter| parameter.name == name)
}

fn parameter(named: &Named) -> Parameter {
    let known = PARAMETERS.iter().find(|known| known.name == named.name);
    let mut parameter = known.cloned().unwrap_or_else(|| own_parameter(named));
    if let (Some(choices), Some(_)) = (named.choices, known) {
        parameter.kind = Kind::Choice(choices);
    }
    let shown = named.shown_values.iter();
    let words = shown.map(|(value, words)| (value.clone().into(), words.clone().into()));
    parameter.shown_values = words.collect();
    if let Some(unit) = &named.unit {
        parameter.unit = unit.clone().into();
        parameter.shown_unit = Some(unit.clone().into());
    }
    if let Some([name, unit]) = &named.shown {
        parameter.symbol = escape(name).into();
        parameter.shown_unit = (!unit.is_empty()).then(|| unit.clone().into());
    }
    parameter
}

/// A parameter that only studies of structures have.
fn own_parameter(named: &Named) -> Parameter {
    let fixed = FIXED.iter().find(|fixed| fixed.0 == named.name);
    let range = fixed.map_or(Range::Any, |_| Range::Positive);
    let symbol = match fixed {
        Some(("dt", _)) => "Δ*t*".to_owned(),
        Some(_) => "*t*_end_".to_owned(),
        None if named.choices.is_some() => escape(&named.name),
        None => symbol(&named.name),
    };
    Parameter {
        name: named.name.clone().into(),
        symbol: symbol.into(),
        unit: Borrowed(match fixed {
            Some(_) => "the study's time",
            None if named.choices.is_some() => "1",
            None => "the study's units",
        }),
        shown_unit: None,
        shown_values: Vec::new().into(),
        kind: named.choices.map_or(Kind::Number(range), Kind::Choice),
        default: match named.required {
            true if named.programs.is_empty() => Default::Required,
            true | false => Default::Follows(Text::Borrowed("not needed by the structure")),
        },
        applies: super::of_programs(named.programs),
        column: ColumnRule::Always,
        heading: None,
        meaning: Borrowed(fixed.map_or("parameter of the study", |fixed| fixed.1)),
    }
}

/// Greek letters by their names.
const GREEK: [(&str, &str); 18] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ε"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("phi", "φ"),
    ("omega", "ω"),
];

/// A name as figures write it, in their markup: `k_I` as an italic k with the subscript I. A word keeps its `_`.
pub fn symbol(name: &str) -> String {
    let (base, below) = name.split_once('_').unwrap_or((name, ""));
    let greek = GREEK.iter().find(|letter| letter.0 == base);
    let base = greek.map_or(base, |letter| letter.1);
    if base.chars().count() > 2 {
        return escape(name);
    }
    let mut markup = format!("*{}*", escape(base));
    if !below.is_empty() {
        markup += &format!("_{}_", escape(below));
    }
    markup
}

/// A title with a unit behind it, as figures set it.
pub fn in_unit(title: String, shown: Option<String>) -> String {
    slipgap_notation::in_unit(&title, &unit(&shown.unwrap_or_default()))
}

/// A metric or channel as an axis title.
pub fn title(name: &str) -> String {
    escape(name).replace(" - ", " − ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_symbols() {
        for (name, markup) in [
            ("gamma", "*γ*"),
            ("k_I", "*k*_I_"),
            ("EA", "*EA*"),
            ("scale", "scale"),
            ("gap_factor", "gap\\_factor"),
            ("r_E_2", "*r*_E\\_2_"),
        ] {
            assert_eq!(symbol(name), markup);
        }
    }
}
