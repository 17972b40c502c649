//! From the tree of a study file to a validated study, or to all its faults.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use sha2::{Digest, Sha256};

use super::blocks::{BESIDE, blocks};
use super::checks::check;
use super::figure::figures;
use super::object::Object;
use super::place::{self, Place};
use super::report::{Faults, nearest};
use super::rules::MOST_CASES;
use super::scope::Scope;
use super::tree::{self, Node, Tree};
use super::value::{self, name};
use super::{Check, Column, Figure, FigureKind, Study};
use crate::error::{Error, Fault};
use crate::problem::{self, Budget, PROBLEMS, Problem};

/// The keys of a study, each with what it holds.
pub(super) const KEYS: [(&str, &str); 9] = [
    (
        "$schema",
        "where editors find the schema; otherwise ignored",
    ),
    ("title", "what the study shows, in one line"),
    ("problem", "the problem whose cases are run"),
    (
        "parameters",
        "parameters of the cases; a list is an axis, and cases are the product of the axes, the last one fastest",
    ),
    (
        "blocks",
        "several sets of parameters in place of one; their cases follow one another",
    ),
    (
        "metrics",
        "columns of results.csv beyond those that every study of the problem has",
    ),
    (
        "iteration",
        "converged: each step is solved to its root, as all results of record are; once: by the papers' matrices and not iterated, the other reading of the papers; converged if left out",
    ),
    ("figures", "figures to draw"),
    ("checks", "tolerances that `slipgap check` holds"),
];

/// Names of the ways to solve a step.
pub(super) const ITERATIONS: [&str; 2] = ["converged", "once"];

/// Reads a study file of at most [`MOST_CASES`] raw combinations. Faults name the file as `file` does.
pub fn read(file: &Path) -> Result<Study, Error> {
    read_up_to(file, MOST_CASES)
}

/// The same with another limit to the number of raw combinations.
pub fn read_up_to(file: &Path, limit: u64) -> Result<Study, Error> {
    parse_up_to(&file.display().to_string(), &text_of(file)?, limit)
}

/// Most bytes of a file: lists of 10^6 values for several axes fit in.
const LARGEST: u64 = 64 << 20;

/// The text of a file of bounded size; other encodings than UTF-8 are refused.
pub(super) fn text_of(file: &Path) -> Result<String, Error> {
    let mut bytes = Vec::new();
    File::open(file)
        .and_then(|file| file.take(LARGEST + 1).read_to_end(&mut bytes))
        .map_err(Error::io("cannot read", file))?;
    if bytes.len() as u64 > LARGEST {
        let message = format!("larger than {} MiB; no study is", LARGEST >> 20);
        return Err(refused(&file.display().to_string(), "", 0, message));
    }
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let (good, bad) = error.as_bytes().split_at(at);
        let byte = bad.first().copied().unwrap_or_default();
        let message = format!("not UTF-8: byte 0x{byte:02x}; save the file as UTF-8");
        let good = String::from_utf8_lossy(good);
        refused(&file.display().to_string(), &good, good.len(), message)
    })
}

/// The tree of a text; `file` is its name in the fault of one that is no JSON.
pub(super) fn tree_of(file: &str, text: &str) -> Result<Node, Error> {
    tree::parse(text).map_err(|fault| refused(file, text, fault.at, fault.message))
}

/// Reads a study from its text; `file` is its name in faults.
pub fn parse(file: &str, text: &str) -> Result<Study, Error> {
    parse_up_to(file, text, MOST_CASES)
}

fn parse_up_to(file: &str, text: &str, limit: u64) -> Result<Study, Error> {
    let root = tree_of(file, text)?;
    let mut faults = Faults::default();
    match study(&root, text, limit, &mut faults) {
        Some(study) if faults.count() == 0 => Ok(study),
        _ => Err(Error::Faults(faults.in_file_order(file, text))),
    }
}

/// The one fault of a file that is no JSON.
fn refused(file: &str, text: &str, at: usize, message: String) -> Error {
    let (line, column) = Place::start(text).at(at);
    let shown = place::shown(text, line, column);
    Error::Faults(vec![Fault {
        file: file.to_owned(),
        line,
        column,
        path: String::new(),
        message,
        shown,
    }])
}

fn sha256(bytes: &[u8]) -> String {
    let digest = Sha256::digest(bytes);
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}

fn study(root: &Node, text: &str, limit: u64, faults: &mut Faults) -> Option<Study> {
    let keys: Vec<&str> = KEYS.iter().chain(&BESIDE).map(|key| key.0).collect();
    let object = Object::open(root, "", &keys, faults)?;
    let mut string = |key: &str| {
        let node = object.get(key)?;
        value::text(node, &object.path(key), faults)
    };
    string("$schema");
    let title = string("title").unwrap_or_default();
    let problem = problem(&object, faults);
    let blocks = blocks(&object, problem, limit, faults);
    // Without a problem the names of parameters and metrics mean nothing.
    let problem = problem?;
    let once = object
        .get("iteration")
        .and_then(|node| name(node, "iteration", "iteration", &ITERATIONS, faults))
        == Some(1);
    let scope = Scope {
        problem,
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
    Some(Study {
        title,
        problem,
        once,
        metrics: columns(problem, &asked, &figures, &checks),
        blocks: scope.blocks,
        figures,
        checks,
        sha256: sha256(text.as_bytes()),
    })
}

/// The problem by its name; a slip is a fault, but the problem that was meant serves to find further ones.
fn problem(object: &Object, faults: &mut Faults) -> Option<&'static dyn Problem> {
    let known: Vec<&str> = PROBLEMS.iter().map(|problem| problem.name()).collect();
    let node = object.need("problem", &format!("one of {}", known.join(", ")), faults)?;
    match (name(node, "problem", "problem", &known, faults), &node.tree) {
        (Some(row), _) => Some(PROBLEMS[row]),
        (None, Tree::Text(slip)) => problem::find(nearest(slip, &known)?),
        _ => None,
    }
}

/// The metrics that every study has, that the study lists, and that a figure or check needs, in the table's order.
fn columns(
    problem: &dyn Problem,
    asked: &[usize],
    figures: &[Figure],
    checks: &[Check],
) -> Vec<usize> {
    let drawn = figures.iter().flat_map(|figure| match &figure.kind {
        FigureKind::Metric { y, .. }
        | FigureKind::Convergence { y, .. }
        | FigureKind::Sobol { y } => y.clone(),
        FigureKind::Map { z, .. } => vec![*z],
        FigureKind::Scatter { x, y, colour, .. } => {
            let columns = [Some(x), Some(y), colour.as_ref()];
            let metric = |column: &Column| match column {
                Column::Metric(row) => Some(*row),
                Column::Parameter(_) => None,
            };
            columns.into_iter().flatten().filter_map(metric).collect()
        }
        FigureKind::Samples { y, .. } => vec![*y],
        FigureKind::Budget { y, .. } => {
            let budgets = y.iter().map(|row| &problem.budgets()[*row]);
            budgets.flat_map(Budget::metrics).collect()
        }
        FigureKind::History { .. }
        | FigureKind::Profile { .. }
        | FigureKind::Wave { .. }
        | FigureKind::Law => Vec::new(),
    });
    let checked = checks.iter().map(|check| check.metric);
    let listed = asked.iter().copied().chain(checked);
    let needed: Vec<usize> = listed.chain(drawn).collect();
    let metrics = problem.metrics().iter().enumerate();
    metrics
        .filter(|(row, metric)| metric.default || needed.contains(row))
        .map(|(row, _)| row)
        .collect()
}
