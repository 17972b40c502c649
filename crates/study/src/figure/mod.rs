//! The `figures` of a study.

mod checker;
mod choice;
pub(super) mod decoded_value;
mod ensembles;
pub(super) mod extent;
pub(super) mod keys;
pub mod kinds;
mod limits;
pub mod reduced;
mod reductions;
mod sampled;
mod values;
mod vary;

use std::collections::HashSet;

use crate::Figure;
use crate::faults::{Faults, join, quoted};
use crate::object::Object;
use crate::scope::Scope;
use crate::tree::Node;
use crate::value::name;
use checker::Checker;
use decoded_value::take;
use keys::{COMMON, Key, Takes};
use kinds::{KINDS, Kind, Needs};
use values::{DecodedValue, Values};

/// Decodes all figures, leaving out those with a fault; names must differ by more than case, which some file systems
/// ignore.
pub(crate) fn figures(object: &Object, scope: &Scope, faults: &mut Faults) -> Vec<Figure> {
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
    let object = Object::of_keys(node, path, &kinds::all_keys(), faults)?;
    let kind_names = kinds::names();
    let kind = object
        .need("kind", &format!("one of {}", kind_names.join(", ")), faults)
        .and_then(|node| name(node, &object.path("kind"), "kind", &kind_names, faults))
        .map(|row| &KINDS[row]);
    if let Some(kind) = kind {
        unsuitable(&object, kind, scope, faults);
    }
    let keys = COMMON.iter().chain(kind.map_or(&[][..], |kind| kind.keys));
    let mut taken = Vec::new();
    if let (Some(kind), Some(node)) = (kind, object.get("kind")) {
        taken.push(("kind", node, DecodedValue::Text(kind.name.to_owned())));
    }
    for key in keys.filter(|key| key.kind != Takes::Kind) {
        let found = match key.needed {
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
        colour: values.given_switch("colour") != Some(false),
        markers: values.switch("markers"),
        filter: values.filter(),
        kind: (kind?.decode)(&values, scope)?,
    };
    let mut checker = Checker {
        figure: &figure,
        values: &values,
        scope,
        reduced: None,
        faults,
        before,
    };
    let table = kind?;
    checker.reduced = reductions::check(table.name, table.keys, &mut checker);
    let kind = figure.kind.decoded();
    limits::check(&mut checker);
    kind.check_keys(&mut checker);
    let at = values.at("where");
    if !scope.blocks.is_empty() && scope.countable(&figure.filter, at, path, checker.faults) {
        kind.check_cases(&mut checker);
    }
    (faults.count() == before).then(|| (figure, values.at("name")))
}

/// Why a problem without laws or budgets of its own has no figures of a kind; `None` if it has.
fn lacking(kind: &Kind, scope: &Scope) -> Option<&'static str> {
    match kind.name {
        "law" if scope.problem.schema().described => {
            Some("a structure has no law figure; a curve of a contact's r and S draws its loop")
        }
        "budget" if scope.problem.schema().budgets.is_empty() => Some(
            "a budget needs rms_error and its parts of one channel in \"metrics\", such as rms_error(x), regularisation_error(x) and step_error(x)",
        ),
        _ => None,
    }
}

/// Reports keys of other kinds, and kinds that the problem does not have.
fn unsuitable(object: &Object, kind: &Kind, scope: &Scope, faults: &mut Faults) {
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
        if member.key == "kind"
            && let Some(message) = lacking(kind, scope)
        {
            faults.add(member.node.at, &object.path("kind"), message);
        }
        if member.key == "kind" && kind.needs == Needs::Ensemble && scope.ensemble.is_none() {
            let message = format!(
                "a {} figure needs the key \"ensemble\" of the study, as in \"ensemble\": \"seed\"",
                kind.name
            );
            faults.add(member.node.at, &object.path("kind"), message);
        }
        if member.key == "kind" && kind.needs_convergence() && scope.once {
            let message = format!(
                "a {} figure needs converged steps (\"iteration\": \"converged\")",
                kind.name
            );
            faults.add(member.node.at, &object.path("kind"), message);
        } else if member.key == "kind" && !kind.suits(&*scope.problem) {
            let problem = scope.problem.name();
            let lacks = match kind.needs {
                Needs::Structure => "no structure to draw",
                Needs::OneContact => "no single contact",
                Needs::Profiles | Needs::Nothing | Needs::Ensemble => "no profiles",
            };
            let suitable = KINDS.iter().filter(|other| other.suits(&*scope.problem));
            let others: Vec<&str> = suitable.map(|other| other.name).collect();
            let message = format!("{problem} has {lacks}; allowed: {}", others.join(", "));
            faults.add(member.node.at, &object.path("kind"), message);
        }
    }
}
