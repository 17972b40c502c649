//! The `figures` of a study.

mod axis;
mod fitness;
pub(super) mod keys;
pub(super) mod kinds;
pub(super) mod limits;
mod sampled;
pub(super) mod taken;
mod vary;

use std::collections::HashSet;

use crate::study::object::Object;
use crate::study::report::{Faults, join, quoted};
use crate::study::scope::Scope;
use crate::study::tree::Node;
use crate::study::value::name;
use crate::study::{Figure, FigureKind};
use keys::{COMMON, Key, Takes};
use kinds::{KINDS, Kind};
use taken::{Taken, Values, take};

/// Decodes all figures, leaving out those with a fault; names must differ by more than case, which some file systems
/// ignore.
pub(in crate::study) fn figures(
    object: &Object,
    scope: &Scope,
    faults: &mut Faults,
) -> Vec<Figure> {
    let named = object.items("figures", faults, |node, path, faults| {
        let (figure, at) = figure(node, path, scope, faults)?;
        Some((figure, at, join(path, "name")))
    });
    let mut seen = HashSet::new();
    for (figure, at, path) in &named {
        if !seen.insert(figure.name.to_ascii_lowercase()) {
            let name = quoted(&figure.name);
            let message =
                format!("{name} is the name of an earlier figure; each figure needs its own name");
            faults.add(*at, path, message);
        }
    }
    named.into_iter().map(|(figure, ..)| figure).collect()
}

/// Decodes one figure, with the place of its name; `None` if it has a fault.
fn figure(node: &Node, path: &str, scope: &Scope, faults: &mut Faults) -> Option<(Figure, usize)> {
    let before = faults.count();
    let object = Object::open(node, path, &kinds::all_keys(), faults)?;
    let all = kinds::names();
    let kind = object
        .need("kind", &format!("one of {}", all.join(", ")), faults)
        .and_then(|node| name(node, &object.path("kind"), "kind", &all, faults))
        .map(|row| &KINDS[row]);
    if let Some(kind) = kind {
        unfitting(&object, kind, scope, faults);
    }
    let keys = COMMON.iter().chain(kind.map_or(&[][..], |kind| kind.keys));
    let mut taken = Vec::new();
    if let (Some(kind), Some(node)) = (kind, object.get("kind")) {
        taken.push(("kind", node, Taken::Text(kind.name.to_owned())));
    }
    for key in keys.filter(|key| key.takes != Takes::Kind) {
        let found = match key.required {
            true => object.need(key.name, key.meaning, faults),
            false => object.get(key.name),
        };
        if let Some(node) = found {
            let value = take(key, node, &object.path(key.name), scope, faults);
            taken.extend(value.map(|value| (key.name, node, value)));
        }
    }
    if faults.count() > before {
        return None;
    }
    let values = Values { node, path, taken };
    let figure = Figure {
        name: values.text("name")?,
        title: values.text("title"),
        note: values.text("note"),
        width: values.width("width"),
        ranges: ["x_range", "y_range"].map(|key| values.range(key)),
        filter: values.filter(),
        kind: assembled(kind?.name, &values, scope)?,
    };
    limits::check(&figure, &values, faults);
    let at = values.at("where");
    if !scope.blocks.is_empty() && scope.countable(&figure.filter, at, path, faults) {
        fitness::check(&figure, &values, scope, faults);
    }
    (faults.count() == before).then(|| (figure, values.at("name")))
}

/// Reports keys that other kinds take, but not this one, and kinds that the problem does not have.
fn unfitting(object: &Object, kind: &Kind, scope: &Scope, faults: &mut Faults) {
    for member in &object.members {
        let takes = |keys: &[Key]| keys.iter().any(|key| key.name == member.key);
        if !takes(&COMMON) && !takes(kind.keys) {
            let message = format!(
                "a {} figure has no key \"{}\"; kinds with this key: {}",
                kind.name,
                member.key,
                kinds::takers(&member.key).join(", ")
            );
            faults.add(member.node.at, &object.path(&member.key), message);
        }
        if member.key == "kind" && kind.needs_extent() && scope.once {
            let message = format!(
                "a {} figure needs converged steps (\"iteration\": \"converged\")",
                kind.name
            );
            faults.add(member.node.at, &object.path("kind"), message);
        } else if member.key == "kind"
            && kind.needs_extent()
            && scope.problem.schema().profiles.is_empty()
        {
            let problem = scope.problem.name();
            let others = KINDS.iter().filter(|other| !other.needs_extent());
            let others: Vec<&str> = others.map(|other| other.name).collect();
            let message = format!("{problem} has no profiles; allowed: {}", others.join(", "));
            faults.add(member.node.at, &object.path("kind"), message);
        }
    }
}

/// The kind with what it needs, defaults filled in.
fn assembled(kind: &str, values: &Values, scope: &Scope) -> Option<FigureKind> {
    Some(match kind {
        "history" => FigureKind::History {
            y: values
                .rows("y")
                .unwrap_or_else(|| response_and_error(scope)),
            by: values.row("by"),
            panels: values.row("panels"),
            in_units: values.switch("in_units"),
        },
        "profile" => FigureKind::Profile {
            y: values
                .rows("y")
                .unwrap_or_else(|| (0..scope.problem.schema().profiles.len()).collect()),
            times: values.times("times"),
        },
        "wave" => FigureKind::Wave {
            y: match values.row("y") {
                Some(row) => row,
                None => scope.problem.schema().profiles.len().checked_sub(1)?,
            },
        },
        "metric" => FigureKind::Metric {
            x: values.row("x")?,
            y: values.rows("y")?,
            by: values.row("by"),
            x_scale: values.scale("x_scale"),
            y_scale: values.scale("y_scale"),
        },
        "convergence" => FigureKind::Convergence {
            x: match values.row("x") {
                Some(row) => row,
                None => {
                    let table = scope.problem.parameters();
                    table
                        .iter()
                        .position(|p| p.name == scope.problem.schema().step_name())?
                }
            },
            y: values.rows("y")?,
            by: values.row("by"),
        },
        "budget" => FigureKind::Budget {
            x: values.row("x")?,
            y: values
                .rows("y")
                .unwrap_or_else(|| (0..scope.problem.schema().budgets.len()).collect()),
            panels: values.row("panels"),
        },
        "map" => FigureKind::Map {
            x: values.row("x")?,
            y: values.row("y")?,
            z: values.row("z")?,
            scales: ["x_scale", "y_scale", "z_scale"].map(|key| values.scale(key)),
            marks: values.marks("marks"),
            ridge: values.ridge("ridge"),
        },
        "scatter" => FigureKind::Scatter {
            x: values.column("x")?,
            y: values.column("y")?,
            colour: values.column("colour"),
            scales: ["x_scale", "y_scale", "colour_scale"].map(|key| values.scale(key)),
        },
        "samples" => FigureKind::Samples {
            parameters: sampled::parameters(scope, &values.filter()),
            y: values.row("y")?,
            y_scale: values.scale("y_scale"),
        },
        "sobol" => FigureKind::Sobol {
            y: values.rows("y")?,
        },
        _ => FigureKind::Law,
    })
}

/// The first quantity, and the first that is an error.
fn response_and_error(scope: &Scope) -> Vec<usize> {
    let quantities = &scope.problem.schema().quantities;
    let error = quantities.iter().position(|quantity| quantity.error);
    let response = (!quantities.is_empty()).then_some(0);
    response.into_iter().chain(error).collect()
}
