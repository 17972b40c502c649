//! The `figures` of a study.

use super::kinds::{self, COMMON, KINDS, Key, Kind, Takes};
use super::object::Object;
use super::report::{Faults, quoted};
use super::scope::Scope;
use super::taken::{Values, take};
use super::tree::Node;
use super::value::name;
use super::{Figure, FigureKind};
use crate::problem::Source;

/// Decodes one figure; `None` if it has a fault.
pub(super) fn figure(
    node: &Node,
    path: &str,
    scope: &Scope,
    faults: &mut Faults,
) -> Option<Figure> {
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
        filter: values.filter(),
        kind: assembled(kind?.name, &values, scope)?,
    };
    if !scope.blocks.is_empty() {
        super::fitness::check(&figure, &values, scope, faults);
    }
    (faults.count() == before).then_some(figure)
}

/// Reports keys that other kinds take, but not this one, and kinds that the problem does not have.
fn unfitting(object: &Object, kind: &Kind, scope: &Scope, faults: &mut Faults) {
    for member in &object.members {
        let takes = |keys: &[Key]| keys.iter().any(|key| key.name == member.key);
        if !takes(&COMMON) && !takes(kind.keys) {
            let message = format!(
                "a {} figure takes no \"{}\"; the kinds that do: {}",
                kind.name,
                member.key,
                kinds::takers(&member.key).join(", ")
            );
            faults.add(member.node.at, &object.path(&member.key), message);
        }
        if member.key == "kind" && kind.name == "profile" && scope.problem.profiles().is_empty() {
            let problem = scope.problem.name();
            let others = kinds::names().into_iter().filter(|name| *name != kind.name);
            let others: Vec<&str> = others.collect();
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
        },
        "profile" => FigureKind::Profile {
            y: values
                .rows("y")
                .unwrap_or_else(|| (0..scope.problem.profiles().len()).collect()),
            times: values.times("times"),
        },
        "metric" => FigureKind::Metric {
            x: values.row("x")?,
            y: values.rows("y")?,
            by: values.row("by"),
            x_scale: values.scale("x_scale"),
            y_scale: values.scale("y_scale"),
        },
        "map" => FigureKind::Map {
            x: values.row("x")?,
            y: values.row("y")?,
            z: values.row("z")?,
            scales: ["x_scale", "y_scale", "z_scale"].map(|key| values.scale(key)),
        },
        _ => FigureKind::Law,
    })
}

/// The first quantity, and the first that is an error.
fn response_and_error(scope: &Scope) -> Vec<usize> {
    let quantities = scope.problem.quantities();
    let error = quantities.iter().position(|quantity| {
        matches!(
            quantity.source,
            Source::DisplacementError | Source::VelocityError
        )
    });
    let response = (!quantities.is_empty()).then_some(0);
    response.into_iter().chain(error).collect()
}

/// Reports figures of the same name; case is ignored, as some file systems do.
pub(super) fn distinct_names(figures: &[(Figure, usize, String)], faults: &mut Faults) {
    let mut seen = std::collections::HashSet::new();
    for (figure, at, path) in figures {
        if !seen.insert(figure.name.to_ascii_lowercase()) {
            let message = format!(
                "{} is the name of an earlier figure; give each its own",
                quoted(&figure.name)
            );
            faults.add(*at, path, message);
        }
    }
}
