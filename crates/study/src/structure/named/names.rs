//! The names that a study gives its parameters.

use super::labels::{is_label, labels, report_texts_of_tables};
use crate::source::faults::{Faults, quoted};
use crate::source::hint::nearest;
use crate::source::tree::Node;
use crate::structure::keys::KEY;
use crate::structure::programs;
use crate::structure::reading::given::{Choices, Choosing, given, interned_choices, texts, under};
use crate::structure::reading::reader::is_name;
use slipgap_problem::problem::expression::FUNCTIONS;
use slipgap_problem::problem::expression::Formula;
use slipgap_problem::problem::interned;
use slipgap_problem::problem::method::PARAMETERS;
use slipgap_problem::problem::numbers::parameter::Parameter;
use slipgap_problem::problem::structure::metrics::metric::{OF_ALL, OF_PROGRAMS};
use slipgap_problem::problem::structure::parts::contact_law::NAMES;
use slipgap_problem::problem::structure::tables::schema::{FIXED, Named, of_method};
use slipgap_system::system::loads::Unit;

/// The key of measurements.
const MEASURED: &str = KEY.name;

/// The key of the unit of a record.
const UNIT: &str = "unit";

/// The parameters of a study whose values are names.
pub(in crate::structure) fn choices(structure: &Node, root: &Node) -> Choosing {
    Choosing {
        parts: parts(structure, root),
        labels: labels(structure, root),
    }
}

/// The parameters that choose a law, a file or its unit, with what they choose from.
fn parts(structure: &Node, root: &Node) -> Vec<(String, Choices)> {
    let given = given(root);
    let values = |name: &str| -> Vec<&str> {
        let own = given.iter().filter(|(member, _)| member.key == name);
        own.flat_map(|(member, _)| texts(&member.node)).collect()
    };
    let mut found: Vec<(String, Choices)> = Vec::new();
    for key in ["law", "record", UNIT, "M", "K", "C", MEASURED] {
        let mut names = Vec::new();
        // A mass may have the name of a matrix.
        match (key, structure.get("matrices")) {
            (MEASURED, _) => {
                let file = root.get(key).and_then(|node| node.get("file"));
                names.extend(file.into_iter().flat_map(texts));
                if let Some(supports) = structure.get("supports") {
                    under(supports, "file", &mut names);
                }
            }
            ("law" | "record" | UNIT, _) => under(structure, key, &mut names),
            (_, Some(matrices)) => under(matrices, key, &mut names),
            (_, None) => {}
        }
        for name in names {
            let is_given = given.iter().any(|(member, _)| member.key == name);
            if !is_given || found.iter().any(|known| known.0 == name) {
                continue;
            }
            let choices = match key {
                "law" => NAMES,
                UNIT => interned_choices(Unit::ALL.map(|unit| (unit.name(), key)).to_vec()),
                _ => {
                    let mut files: Vec<(&str, &str)> = Vec::new();
                    for file in values(name) {
                        let file = interned(file);
                        if !files.iter().any(|known| known.0 == file) {
                            let what = match key {
                                "record" | MEASURED => key,
                                _ => "matrix",
                            };
                            files.push((file, what));
                        }
                    }
                    interned_choices(files)
                }
            };
            found.push((name.to_owned(), choices));
        }
    }
    found
}

/// The parameters of all blocks in the order of the file. dt, duration and those of the method are always among them.
pub(in crate::structure) fn parameters(
    root: &Node,
    choices: &Choosing,
    faults: &mut Faults,
) -> Vec<Named> {
    let mut parameters: Vec<Named> = Vec::new();
    for (member, path) in given(root) {
        let name = &member.key;
        if parameters.iter().any(|known| known.name == *name) || of_method(name) {
            continue;
        }
        report_texts_of_tables(&member.node, &path, name, choices, faults);
        // Columns of results that are not parameters.
        let is_column = name == "case"
            || OF_ALL.contains(&name.as_str())
            || root.get(programs::KEY.name).is_some() && OF_PROGRAMS.contains(&name.as_str());
        if let Some(message) = name_fault(name, is_column) {
            faults.add(member.at, &path, message);
        }
        let of = |all: &[(String, Choices)]| {
            let known = all.iter().find(|known| known.0 == *name);
            known.map(|known| known.1)
        };
        let (part, label) = (of(&choices.parts), of(&choices.labels));
        parameters.push(Named {
            name: name.clone(),
            choices: part.or(label),
            shown: None,
            unit: None,
            shown_values: Vec::new(),
            programs: &[],
            required: part.is_some() || FIXED.iter().any(|fixed| fixed.0 == name),
        });
    }
    for (name, _) in FIXED {
        if !parameters.iter().any(|known| known.name == name) {
            parameters.push(Named {
                name: name.to_owned(),
                choices: None,
                shown: None,
                unit: None,
                shown_values: Vec::new(),
                programs: &[],
                required: true,
            });
        }
    }
    // One behind the other, as `method::of_case` reads them.
    parameters.extend(PARAMETERS.iter().map(|parameter| {
        Named {
            name: parameter.name.to_string(),
            choices: (parameter.name == PARAMETERS[0].name)
                .then(|| programs::choices(root))
                .flatten(),
            shown: None,
            unit: None,
            shown_values: Vec::new(),
            programs: &[],
            required: true,
        }
    }));
    parameters
}

/// Why a parameter cannot have this name, which may be that of another column; `None` if it can.
pub(super) fn name_fault(name: &str, is_column: bool) -> Option<String> {
    let has_meaning =
        FUNCTIONS.iter().any(|function| function.0 == name) || ["and", "or", "not"].contains(&name);
    let another = |why: &str| Some(format!("{} {why}; choose another name", quoted(name)));
    if is_column {
        return another("is a column of results.csv");
    }
    if has_meaning {
        return another("has a meaning in expressions");
    }
    (!is_name(name)).then(|| {
        format!(
            "{} cannot name a parameter; a name is letters, digits and _, not beginning with a digit",
            quoted(name)
        )
    })
}

/// Whether a value is an expression that contains parameters.
fn is_expression(node: &Node, table: &[Parameter]) -> bool {
    let formulas = texts(node)
        .into_iter()
        .map(|text| Formula::number(text, table));
    formulas.flatten().any(|formula| !formula.uses().is_empty())
}

/// Reports the parameters that neither the structure nor another parameter, a condition or a metric contains, and that are no labels.
/// An expression of parameters may be a column that only compares, such as a closed form, unless its name is close to another.
pub(in crate::structure) fn report_unused(
    root: &Node,
    parameters: &[Named],
    table: &[Parameter],
    in_metrics: impl Fn(&str) -> bool,
    faults: &mut Faults,
) {
    let given = given(root);
    let mut used = vec![false; parameters.len()];
    let mut conditions = Vec::new();
    under(root, "when", &mut conditions);
    let of_parameters = given.iter().flat_map(|(member, _)| texts(&member.node));
    let formulas = of_parameters.filter_map(|text| Formula::number(text, table).ok());
    let listed = conditions.into_iter();
    let conditions = listed.filter_map(|text| Formula::condition(text, table).ok());
    for formula in formulas.chain(conditions) {
        formula.uses().iter().for_each(|row| used[*row] = true);
    }
    for (used, named) in used.iter_mut().zip(parameters) {
        *used |= in_metrics(&named.name);
    }
    let is_used = |row: usize| {
        let named = &parameters[row];
        named.required || used[row] && named.choices.is_none()
    };
    let is_used_name = |name: &str| {
        let row = parameters.iter().position(|named| named.name == name);
        row.is_some_and(is_used)
    };
    for (row, named) in parameters.iter().enumerate() {
        if is_used(row) || is_label(root, &named.name, &is_used_name) {
            continue;
        }
        let own = given.iter().find(|(member, _)| member.key == named.name);
        if let Some((member, path)) = own {
            let name = quoted(&named.name);
            let rows = (0..parameters.len()).filter(|other| is_used(*other));
            let others: Vec<&str> = rows.map(|other| &*parameters[other].name).collect();
            let near = nearest(&named.name, &others);
            if near.is_none() && is_expression(&member.node, table) {
                continue;
            }
            let hint = near
                .map(|near| format!(", did you mean {}?", quoted(near)))
                .unwrap_or_default();
            let message = format!(
                "{name} is not used{hint}: no part of the structure and no expression contains it; a label of the cases is allowed as a \
                 list in a \"zip\" with a parameter that is used, a column for comparison as an expression of others"
            );
            faults.add(member.at, path, message);
        }
    }
}
