//! The keys of a study, and the names that they take.

use super::blocks::BLOCK_KEYS;
use crate::reduction;
use crate::source::field::{ANY, Keys, Kind, field, needed};
use crate::structure::keys::KEY as MEASURED;
use crate::structure::named::shown::SHOWN;
use slipgap_problem::problem;

/// The keys of a study, each with its meaning.
pub(crate) const OF_STUDY: Keys = Keys::new(&[
    field(
        "$schema",
        Kind::Text,
        "location of the schema, for editors; slipgap ignores it",
    ),
    field("title", Kind::Text, "what the study shows, in one line"),
    needed(
        "problem",
        Kind::Words("problem", || problem::names().collect(), None),
        "the problem to solve",
    ),
    field(
        "parameters",
        Kind::Shared("parameters"),
        "parameters of the cases; a list is an axis",
    ),
    field(
        "structure",
        Kind::Any,
        "masses, bars, springs, contacts and loads of a study of structures",
    ),
    MEASURED,
    field(
        "blocks",
        LIST,
        "several sets of parameters instead of one; their cases follow one another",
    ),
    field(
        "metrics",
        Kind::Shared("metrics"),
        "metrics in addition to the default ones, each a column of results.csv: a name, arithmetic such as \"max(a3 - a2)/h\", a ratio such as \"peak(gap.S) relative to gamma = 1\", or an object that names one, such as {\"drift\": \"max(a3 - a2)/h\"}",
    ),
    reduction::decode::KEY,
    field(
        "ensemble",
        Kind::Any,
        "a parameter or a list of parameters over which the cases are an ensemble",
    ),
    field(
        "units",
        Kind::Any,
        "units of the parameters, for results in them; nothing is converted",
    ),
    SHOWN,
    field(
        "iteration",
        Kind::Words("iteration", || vec!["converged", "once"], None),
        "converged (if left out), or once: each step is solved once with the matrices of the papers",
    ),
    field(
        "calibrate",
        Kind::Any,
        "free parameters with their ranges and the metric to minimise, for `slipgap calibrate`",
    ),
    field(
        "recommend",
        Kind::Shared("recommend"),
        "the parameters to choose and the metrics to keep within tolerances, for `slipgap recommend`",
    ),
    field("figures", LIST, "figures to draw"),
    field("checks", LIST, "limits that `slipgap check` tests"),
]);

/// The keys of a study, and those of its only block.
pub(crate) const KEYS: Keys = OF_STUDY.and(BLOCK_KEYS);

/// A list that its problem describes.
const LIST: Kind = Kind::List(&Kind::Any, [0, ANY]);
