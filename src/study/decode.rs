//! From the tree of a study file to a validated study, or to all its faults.

use std::path::Path;

use sha2::{Digest, Sha256};

use super::object::Object;
use super::parameters::{Draft, parameters};
use super::place::Place;
use super::report::{Faults, join, nearest};
use super::scope::{Scope, names};
use super::tree::{self, Node, Tree};
use super::value::{name, text};
use super::{Check, Figure, FigureKind, Study, checks, figures, rules};
use crate::error::{Error, Fault};
use crate::problem::{self, PROBLEMS, Problem};

/// The keys of a study, each with what it holds.
pub(super) const KEYS: [(&str, &str); 8] = [
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
    ("figures", "figures to draw"),
    ("checks", "tolerances that `slipgap check` holds"),
];

/// Reads a study file. Faults name the file as `file` does.
pub fn read(file: &Path) -> Result<Study, Error> {
    let bytes = std::fs::read(file).map_err(Error::io("cannot read", file))?;
    let shown = file.display().to_string();
    match std::str::from_utf8(&bytes) {
        Ok(text) => parse(&shown, text),
        Err(error) => {
            let (good, bad) = bytes.split_at(error.valid_up_to());
            let good = String::from_utf8_lossy(good);
            let byte = bad.first().copied().unwrap_or_default();
            let message = format!("not UTF-8: byte 0x{byte:02x}; save the file as UTF-8");
            Err(refused(&shown, &good, good.len(), message))
        }
    }
}

/// Reads a study from its text; `file` is its name in faults.
pub fn parse(file: &str, text: &str) -> Result<Study, Error> {
    let root = match tree::parse(text) {
        Ok(root) => root,
        Err(fault) => return Err(refused(file, text, fault.at, fault.message)),
    };
    let mut faults = Faults::default();
    let study = study(&root, &mut faults);
    match study {
        Some(study) if faults.count() == 0 => Ok(Study {
            sha256: sha256(text.as_bytes()),
            ..study
        }),
        _ => Err(Error::Faults(faults.in_file_order(file, text))),
    }
}

/// The one fault of a file that is no JSON.
fn refused(file: &str, text: &str, at: usize, message: String) -> Error {
    let (line, column) = Place::start(text).at(at);
    Error::Faults(vec![Fault {
        file: file.to_owned(),
        line,
        column,
        path: String::new(),
        message,
    }])
}

fn sha256(bytes: &[u8]) -> String {
    let digest = Sha256::digest(bytes);
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}

fn study(root: &Node, faults: &mut Faults) -> Option<Study> {
    let object = Object::open(root, "", &KEYS.map(|key| key.0), faults)?;
    let mut string = |key: &str| {
        let node = object.get(key)?;
        text(node, &object.path(key), faults)
    };
    string("$schema");
    let title = string("title").unwrap_or_default();
    let problem = problem(&object, faults);
    let drafts = blocks(&object, problem, faults);
    // Without a problem the names of parameters and metrics mean nothing.
    let scope = Scope {
        problem: problem?,
        blocks: drafts
            .map(|drafts| drafts.iter().map(Draft::block).collect())
            .unwrap_or_default(),
    };
    let asked = match object.get("metrics") {
        Some(Node {
            tree: Tree::List(items),
            ..
        }) if items.is_empty() => Vec::new(),
        Some(node) => {
            names(node, "metrics", "metric", &scope.metrics(), faults).unwrap_or_default()
        }
        None => Vec::new(),
    };
    let figures = list(&object, "figures", faults, |node, path, faults| {
        let figure = figures::figure(node, path, &scope, faults)?;
        let at = match &node.tree {
            Tree::Object(members) => members.iter().find(|member| member.key == "name"),
            _ => None,
        };
        let at = at.map_or(node.at, |member| member.node.at);
        Some((figure, at, join(path, "name")))
    });
    figures::distinct_names(&figures, faults);
    let checks = list(&object, "checks", faults, |node, path, faults| {
        checks::check(node, path, &scope, faults)
    });
    let figures: Vec<Figure> = figures.into_iter().map(|(figure, ..)| figure).collect();
    Some(Study {
        title,
        problem: scope.problem,
        metrics: columns(scope.problem, &asked, &figures, &checks),
        blocks: scope.blocks,
        figures,
        checks,
        sha256: String::new(),
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

/// The blocks with their places, if all of them could be decoded.
fn blocks(
    object: &Object,
    problem: Option<&'static dyn Problem>,
    faults: &mut Faults,
) -> Option<Vec<Draft>> {
    let before = faults.count();
    let table = problem.map(|problem| problem.parameters());
    let (key, node, drafts) = match (object.get("parameters"), object.get("blocks")) {
        (Some(_), Some(blocks)) => {
            let message = "stands in place of \"parameters\"; give one of the two";
            faults.add(blocks.at, "blocks", message);
            return None;
        }
        (None, None) => {
            let what = "the parameters of the cases, or \"blocks\" of them";
            object.missing("parameters", what, faults);
            return None;
        }
        (Some(node), None) => {
            let draft = parameters(node, "parameters", table?, faults);
            ("parameters", node, draft.into_iter().collect())
        }
        (None, Some(node)) => {
            let drafts = list(object, "blocks", faults, |node, path, faults| {
                let block = Object::open(node, path, &["parameters"], faults)?;
                let node = block.need("parameters", "the parameters of the block", faults)?;
                parameters(node, &block.path("parameters"), table?, faults)
            });
            let empty = matches!(&node.tree, Tree::List(blocks) if blocks.is_empty());
            if empty {
                faults.must_be(node, "blocks", "a list of at least one block");
            }
            ("blocks", node, drafts)
        }
    };
    let whole = faults.count() == before;
    if !rules::count(&drafts, node.at, key, faults) {
        return None;
    }
    for draft in &drafts {
        rules::check(problem?, draft, faults);
    }
    // A case that breaks a rule is still a case that figures and checks may mean.
    whole.then_some(drafts)
}

/// Decodes the items of the list under `key`, leaving out those with a fault.
fn list<T>(
    object: &Object,
    key: &str,
    faults: &mut Faults,
    decode: impl Fn(&Node, &str, &mut Faults) -> Option<T>,
) -> Vec<T> {
    let Some(node) = object.get(key) else {
        return Vec::new();
    };
    let Tree::List(items) = &node.tree else {
        faults.must_be(node, key, "a list of objects, [{ ... }, ...]");
        return Vec::new();
    };
    let items = items.iter().enumerate();
    items
        .filter_map(|(i, item)| decode(item, &format!("{key}[{i}]"), faults))
        .collect()
}

/// The metrics that every study has, that the study lists, and that a figure or check needs, in the table's order.
fn columns(
    problem: &dyn Problem,
    asked: &[usize],
    figures: &[Figure],
    checks: &[Check],
) -> Vec<usize> {
    let drawn = figures.iter().flat_map(|figure| match &figure.kind {
        FigureKind::Metric { y, .. } => y.as_slice(),
        FigureKind::Map { z, .. } => std::slice::from_ref(z),
        FigureKind::History { .. } | FigureKind::Profile { .. } | FigureKind::Law => &[],
    });
    let checked = checks.iter().map(|check| &check.metric);
    let needed: Vec<usize> = asked.iter().chain(drawn).chain(checked).copied().collect();
    let metrics = problem.metrics().iter().enumerate();
    metrics
        .filter(|(row, metric)| metric.default || needed.contains(row))
        .map(|(row, _)| row)
        .collect()
}
