//! The keys of a study, and the names that they take.

use super::spread::SHARED;
use crate::reduction;
use crate::structure::keys::KEY as MEASURED;
use crate::structure::named::shown::SHOWN;

/// The keys of a study, each with its meaning.
pub(crate) const KEYS: [(&str, &str); 18] = [
    (
        "$schema",
        "location of the schema, for editors; slipgap ignores it",
    ),
    ("title", "what the study shows, in one line"),
    ("problem", "the problem to solve"),
    ("parameters", "parameters of the cases; a list is an axis"),
    (
        "structure",
        "masses, bars, springs, contacts and loads of a study of structures",
    ),
    MEASURED,
    (
        "blocks",
        "several sets of parameters instead of one; their cases follow one another",
    ),
    SHARED,
    (
        "metrics",
        "metrics in addition to the default ones, each a column of results.csv: a name, arithmetic such as \"max(a3 - a2)/h\", a ratio such as \"peak(gap.S) relative to gamma = 1\", or an object that names one, such as {\"drift\": \"max(a3 - a2)/h\"}",
    ),
    reduction::decode::KEY,
    (
        "ensemble",
        "a parameter or a list of parameters over which the cases are an ensemble",
    ),
    (
        "units",
        "units of the parameters, for results in them; nothing is converted",
    ),
    SHOWN,
    (
        "iteration",
        "converged (if left out), or once: each step is solved once with the matrices of the papers",
    ),
    (
        "calibrate",
        "free parameters with their ranges and the metric to minimise, for `slipgap calibrate`",
    ),
    (
        "recommend",
        "the parameters to choose and the metrics to keep within tolerances, for `slipgap recommend`",
    ),
    ("figures", "figures to draw"),
    ("checks", "limits that `slipgap check` tests"),
];

/// Names of the ways to solve a step.
pub(crate) const ITERATIONS: [&str; 2] = ["converged", "once"];
