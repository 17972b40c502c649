//! Decodes the key `calibrate`.

use super::range::FreeRange;
use super::{Calibrate, Free};
use crate::Figure;
use crate::cases::scope::Scope;
use crate::computed::sources::{MINIMISE, items, members};
use crate::source::faults::{Faults, any_of, join, quoted, unknown};
use crate::source::field::{self, ANY, Keys, MOST_SEED, field, fields, needed};
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::value::{name, text};
use slipgap_problem::problem::numbers::parameter::{Kind, Parameter};

/// The keys besides the names of free parameters, each with its meaning.
pub(crate) const KEYS: Keys = Keys::new(&fields![
    /// the metric to minimise, such as "rms_error(deck.u, measured)", or arithmetic
    needed(MINIMISE, field::Kind::Text),
    /// seed of the search; default 1
    field("seed", field::Kind::Whole([0, MOST_SEED])),
    /// cases for each alternative, three quarters for the search and the rest for profiles; default 20000
    field("cases", field::Kind::Whole(LIMITS)),
    /// free parameters that vary from test to test, for their mean and scatter
    field("varies", field::Kind::Several(&field::Kind::Text, [1, ANY])),
]);

/// Names of the figures of a calibration, in the folder of those of the study.
pub const FIGURES: [&str; 2] = ["misfit", "measured"];

/// Cases of the search of an alternative, if the study does not say.
const CASES: u64 = 20_000;

/// Fewest and most cases of a search.
pub(crate) const LIMITS: [u64; 2] = [100, 1_000_000_000];

/// Most combinations of a study: each alternative has a search of its own.
const MOST: u64 = 1000;

/// Decodes the key; `None` without it or with a fault.
pub(crate) fn calibrate(root: &Object, scope: &Scope, faults: &mut Faults) -> Option<Calibrate> {
    let node = root.get("calibrate")?;
    let (path, before) = (root.path("calibrate"), faults.count());
    if !scope.problem.schema().described {
        let message = "only a study with \"problem\": \"structure\" has this key";
        faults.add(node.at, &path, message);
        return None;
    }
    let names = scope.parameters();
    let keys = KEYS.names();
    let allowed = [&names[..], &keys].concat();
    let object = Object::of_keys(node, &path, &allowed, faults)?.with(&KEYS);
    let free = free(&object, &keys, scope, faults);
    if free.is_empty() && faults.count() == before {
        let message = format!(
            "names no free parameter; give the range of one, as in \"k_h\": {{\"log\": [1e4, 1e7]}}; parameters: {}",
            any_of(&names)
        );
        object.fault(message, faults);
    }
    let blocks = scope.blocks.iter();
    let count = blocks.fold(0, |sum: u64, block| sum.saturating_add(block.raw_len()));
    if count > MOST {
        let message = format!(
            "{count} combinations; a study with \"calibrate\" has at most {MOST} tests and alternatives, each with a search of its own"
        );
        faults.add(node.at, &path, message);
    }
    let minimise = minimise(&object, scope, faults);
    let mut whole = |key: &str, usual: u64| match object.get(key) {
        Some(_) => object.whole(key, faults),
        None => Some(usual),
    };
    let (seed, cases) = (whole("seed", 1), whole("cases", CASES));
    let tests = root.get("measured").and_then(|node| file(node, &names));
    let varies = varies(&object, (&free, tests), scope, faults);
    (faults.count() == before).then_some(Calibrate {
        free,
        varies,
        minimise: minimise?,
        seed: seed?,
        cases: cases?,
        tests,
    })
}

/// The free parameters: the members of an object but those with its `own` keys.
pub(super) fn free(
    object: &Object,
    keys: &[&str],
    scope: &Scope,
    faults: &mut Faults,
) -> Vec<Free> {
    let names = scope.parameters();
    let mut free = Vec::new();
    for member in &object.members {
        let row = names.iter().position(|name| *name == member.key);
        let Some(row) = row.filter(|_| !keys.contains(&member.key.as_str())) else {
            continue;
        };
        let path = object.path(&member.key);
        if let Some(message) = unsuitable(scope, row) {
            faults.add(member.at, &path, message);
            continue;
        }
        let parameter = &scope.problem.parameters()[row];
        let range = FreeRange::decode(&member.node, &path, parameter, faults);
        free.extend(range.map(|range| Free {
            parameter: row,
            range,
        }));
    }
    free
}

/// Rows of the free parameters under `varies`.
fn varies(
    object: &Object,
    (free, tests): (&[Free], Option<usize>),
    scope: &Scope,
    faults: &mut Faults,
) -> Vec<usize> {
    let Some(node) = object.get("varies") else {
        return Vec::new();
    };
    let path = object.path("varies");
    if tests.is_none() {
        let message = "needs several tests: \"file\" of \"measured\" as an axis, such as {\"files\": \"tests/*.csv\"}";
        faults.add(node.at, &path, message);
        return Vec::new();
    }
    let table = scope.problem.parameters();
    let names: Vec<&str> = free
        .iter()
        .map(|parameter| &*table[parameter.parameter].name)
        .collect();
    let row = |one: &Node| {
        let index = name(one, &path, "free parameter", &names, faults)?;
        Some(free[index].parameter)
    };
    node.items().iter().filter_map(row).collect()
}

/// Row of the parameter that chooses the file of measurements.
fn file(measured: &Node, names: &[&str]) -> Option<usize> {
    let file = measured.get("file")?.text()?;
    names.iter().position(|name| *name == file)
}

/// Reports figures with the name of one of a calibration.
pub(crate) fn refuse_figures(root: &Object, figures: &[Figure], faults: &mut Faults) {
    let Some(node) = root
        .get("figures")
        .filter(|_| root.get("calibrate").is_some())
    else {
        return;
    };
    for figure in figures
        .iter()
        .filter(|figure| FIGURES.contains(&figure.name.as_str()))
    {
        let message = format!(
            "{} is the name of a figure of `slipgap calibrate`; choose another name",
            quoted(&figure.name)
        );
        let figure_at = items(node, "figures")
            .into_iter()
            .find_map(|(drawn, path)| {
                let mut members = members(drawn);
                let name = members.find(|member| member.key == "name")?;
                let is_it = name.node.text() == Some(&*figure.name);
                is_it.then(|| (name.node.at, join(&path, "name")))
            });
        let (at, path) = figure_at.unwrap_or((node.at, "figures".to_owned()));
        faults.add(at, &path, message);
    }
}

/// Why a parameter cannot be free; `None` if it can.
fn unsuitable(scope: &Scope, row: usize) -> Option<String> {
    let schema = scope.problem.schema();
    let parameter: &Parameter = &schema.parameters[row];
    let name = quoted(&parameter.name);
    match parameter.kind {
        Kind::Number(_) => {}
        Kind::Whole { .. } => {
            return Some(format!(
                "{name} is a whole number; only parameters with any number as their value can be free; as an axis its values are \
                 alternatives"
            ));
        }
        Kind::Choice(_) => {
            return Some(format!(
                "the values of {name} are names; only numbers can be free; as an axis its values are alternatives"
            ));
        }
    }
    if [schema.step, schema.duration].contains(&row) {
        return Some(format!(
            "{name} is no property of the structure, so that it cannot be free; as an axis its values are alternatives"
        ));
    }
    let mut derived = scope.blocks.iter().flat_map(|block| &block.derived);
    if let Some(derived) = derived.find(|derived| derived.parameter == row) {
        return Some(format!(
            "{name} is given by the expression {}; name the parameters that it follows from, or give it one value",
            quoted(&derived.text)
        ));
    }
    let mut axes = scope.blocks.iter().flat_map(|block| block.axes());
    if axes.any(|axis| axis.parameter == row && axis.values.len() > 1) {
        return Some(format!(
            "{name} is an axis; a free parameter has one value in \"parameters\", which `slipgap run` uses"
        ));
    }
    if !scope.blocks.is_empty() && !scope.blocks.iter().any(|block| block.gives(row)) {
        return Some(format!(
            "{name} has no value in \"parameters\"; give it one, which `slipgap run` uses"
        ));
    }
    None
}

/// Row of the measure under `minimise`.
fn minimise(object: &Object, scope: &Scope, faults: &mut Faults) -> Option<usize> {
    let (node, path) = object.given(MINIMISE, faults)?;
    let text = text(node, &path, faults)?;
    measure(&text, (node.at, &path), "minimise", scope, faults)
}

/// Row of the measure with this name at an offset and path; `verb` is what is done with it.
pub(super) fn measure(
    text: &str,
    (at, path): (usize, &str),
    verb: &str,
    scope: &Scope,
    faults: &mut Faults,
) -> Option<usize> {
    let mut measures = scope.measures.iter();
    let Some(row) = measures.position(|measure| measure.name == text.trim()) else {
        faults.add(at, path, unknown("metric", text, &scope.metrics()));
        return None;
    };
    let measure = &scope.measures[row];
    let late = measure
        .computed
        .as_ref()
        .is_some_and(|computed| computed.late);
    if measure.reduction.is_some() || late {
        let message = format!(
            "{} needs several cases; {verb} a metric of one case, or arithmetic of such metrics",
            quoted(text)
        );
        faults.add(at, path, message);
        return None;
    }
    Some(row)
}
