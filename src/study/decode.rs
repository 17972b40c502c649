//! From the tree of a study file to a validated study, or to all its faults.

use std::path::Path;

use super::blocks::{BESIDE, blocks};
use super::checks::check;
use super::figure::figures;
use super::hint::nearest;
use super::input::Input;
use super::measure::{self, Measure};
use super::object::Object;
use super::report::Faults;
use super::rules::MOST_CASES;
use super::scope::Scope;
use super::tree::{Node, Tree};
use super::units::Units;
use super::value::{self, name};
use super::{Check, Figure, Study};
use crate::error::Error;
use crate::problem::{self, PROBLEMS, Problem};
use std::sync::Arc;

/// The keys of a study, each with what it holds.
pub(super) const KEYS: [(&str, &str); 10] = [
    (
        "$schema",
        "location of the schema, for editors; slipgap ignores it",
    ),
    ("title", "what the study shows, in one line"),
    ("problem", "the problem to solve"),
    (
        "parameters",
        "parameters of the cases; a list is an axis; the cases are all combinations of the axes, and the last axis varies fastest",
    ),
    (
        "blocks",
        "several sets of parameters instead of one; their cases follow one another",
    ),
    (
        "metrics",
        "metrics to compute in addition to the default ones; each is a column of results.csv",
    ),
    (
        "units",
        "names of the units of the parameters; results.csv then has the results in these units, too; nothing is converted",
    ),
    (
        "iteration",
        "converged (the default): each step is iterated to convergence; once: each step is solved once with the matrices of the papers, without iteration",
    ),
    ("figures", "figures to draw"),
    ("checks", "limits that `slipgap check` tests"),
];

/// Names of the ways to solve a step.
pub(super) const ITERATIONS: [&str; 2] = ["converged", "once"];

/// Reads a study file of at most [`MOST_CASES`] raw combinations. Faults name the file as `file` does.
pub fn read(file: &Path) -> Result<Study, Error> {
    Input::of_file(file)?.study(MOST_CASES)
}

/// Reads a study from its text; `file` is its name in faults.
pub fn parse(file: &str, text: &str) -> Result<Study, Error> {
    Input::new(file, text).study(MOST_CASES)
}

/// The study at `root`, of no more than `limit` raw combinations; what it was read from is left out.
pub(super) fn study(root: &Node, limit: u64, faults: &mut Faults) -> Option<Study> {
    let keys: Vec<&str> = KEYS.iter().chain(&BESIDE).map(|key| key.0).collect();
    let object = Object::open(root, "", &keys, faults)?;
    let mut string = |key: &str| {
        let node = object.get(key)?;
        value::text(node, &object.path(key), faults)
    };
    string("$schema");
    let title = string("title").unwrap_or_default();
    let problem = problem(&object, faults);
    let blocks = blocks(&object, problem.as_deref(), limit, faults);
    let units = object
        .get("units")
        .and_then(|node| Units::decode(node, problem.as_deref(), faults));
    // Without a problem the names of parameters and metrics mean nothing.
    let problem = problem?;
    let once = object
        .get("iteration")
        .and_then(|node| name(node, "iteration", "iteration", &ITERATIONS, faults))
        == Some(1);
    let measures = measure::measures(&*problem, units.as_ref());
    let scope = Scope {
        problem,
        measures,
        blocks,
        once,
    };
    let metrics = scope.metrics();
    let asked = object.items("metrics", faults, |node, path, faults| {
        name(node, path, "metric", &metrics, faults)
    });
    let figures = figures(&object, &scope, faults);
    let checks = object.items("checks", faults, |node, path, faults| {
        check(node, path, &scope, faults)
    });
    let metrics = columns(&*scope.problem, &scope.measures, &asked, &figures, &checks);
    Some(Study {
        title,
        problem: scope.problem,
        once,
        units,
        columns: measure::columns(&scope.measures, &metrics),
        metrics,
        measures: scope.measures,
        blocks: scope.blocks,
        figures,
        checks,
        settings: Vec::new(),
        sha256: String::new(),
    })
}

/// The problem by its name; a slip is a fault, but the problem that was meant serves to find further ones.
fn problem(object: &Object, faults: &mut Faults) -> Option<Arc<dyn Problem>> {
    let known: Vec<&str> = PROBLEMS.iter().map(|problem| problem.name()).collect();
    let node = object.need("problem", &format!("one of {}", known.join(", ")), faults)?;
    match (name(node, "problem", "problem", &known, faults), &node.tree) {
        (Some(row), _) => Some(PROBLEMS[row].clone()),
        (None, Tree::Text(slip)) => problem::find(nearest(slip, &known)?),
        _ => None,
    }
}

/// The metrics that every study has, that the study lists, and that a figure or check needs, in units or not, in the
/// table's order.
fn columns(
    problem: &dyn Problem,
    measures: &[Measure],
    asked: &[usize],
    figures: &[Figure],
    checks: &[Check],
) -> Vec<usize> {
    let shown = |figure: &Figure| figure.kind.decoded().measures(problem);
    let drawn = figures.iter().flat_map(shown);
    let checked = checks.iter().map(|check| check.metric);
    let listed = asked.iter().copied().chain(checked);
    let needed = listed.chain(drawn).map(|row| measures[row].metric);
    let needed: Vec<usize> = needed.collect();
    let metrics = problem.metrics().iter().enumerate();
    metrics
        .filter(|(row, metric)| metric.default || needed.contains(row))
        .map(|(row, _)| row)
        .collect()
}
