//! The keys of a study, and the names that they take.

use super::blocks::BLOCK_KEYS;
use super::spread::SHARED;
use crate::reduction::decode::KEY as REDUCTIONS;
use crate::source::field::{ANY, Keys, Kind, Rule, field, fields, needed};
use crate::structure::keys::KEY as MEASURED;
use crate::structure::named::shown::SHOWN;
use crate::structure::programs::KEY as PROGRAMS;
use slipgap_problem::problem;

/// The keys of a study, each with its meaning.
pub(crate) const OF_STUDY: Keys = Keys::new(&fields![
    /// schema for editors; slipgap ignores it
    field("$schema", Kind::Text),
    /// what the study shows, in one line
    field("title", Kind::Text),
    /// the problem to solve
    needed("problem", Kind::Words("problem", || problem::names().collect(), None)),
    /// parameters of the cases; a list is an axis
    field("parameters", Kind::Shared("parameters")),
    /// masses, bars, springs, contacts and loads of a study of structures
    field("structure", Kind::Any),
    MEASURED,
    PROGRAMS,
    /// several sets of parameters, whose cases follow one another
    field("blocks", LIST),
    SHARED,
    /// further metrics, each a column of results.csv: names, arithmetic such as "max(a3 - a2)/h", ratios such as "peak(gap.S) relative to gamma = 1", or objects such as {"drift": "max(a3 - a2)/h"}
    field("metrics", Kind::Shared("metrics")),
    REDUCTIONS,
    /// parameters over which the cases are an ensemble: one, or a list
    field("ensemble", Kind::Any),
    /// units of the parameters, for results in them; nothing is converted
    field("units", Kind::Any),
    SHOWN,
    /// converged (default), or once: each step is solved once with the matrices of the papers
    field("iteration", Kind::Words("iteration", || vec!["converged", "once"], None)),
    /// free parameters with their ranges and the metric to minimise, for `slipgap calibrate`
    field("calibrate", Kind::Any),
    /// parameters to choose and metrics to keep, for `slipgap recommend`
    field("recommend", Kind::Shared("recommend")),
    /// figures to draw
    field("figures", LIST),
    /// limits that `slipgap check` tests
    field("checks", LIST),
]);

/// The keys of a study, and those of its only block.
pub(crate) const KEYS: Keys = OF_STUDY.and(BLOCK_KEYS).rules(&[
    Rule::One(&["parameters", "blocks"], &[]),
    Rule::With(&["shared"], &[Rule::Has(&["blocks"])]),
]);

/// A list that its problem describes.
const LIST: Kind = Kind::List(&Kind::Any, [0, ANY]);
