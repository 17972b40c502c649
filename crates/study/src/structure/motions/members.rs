//! The motions of a set: the values of the parameters that choose them, and of those in a `zip` with them.

use crate::source::faults::{Faults, quoted};
use crate::source::tree::{Node, Tree};
use crate::structure::reading::given::{given, member, texts};
use crate::structure::reading::reader::Reader;
use crate::value::number;
use slipgap_problem::problem::expression::Formula;
use slipgap_problem::problem::interned;
use slipgap_problem::problem::numbers::parameter::{Kind, Range, Value};
use slipgap_problem::problem::structure::given::amount;
use slipgap_problem::problem::structure::given::shape::Scaled;
use slipgap_problem::problem::structure::given::source;
use std::collections::BTreeSet;

/// The values of one motion of a set, by the rows of their parameters.
type Member = Vec<(usize, Value)>;

/// The motions of the set of these functions; `used` has the rows of all parameters in them.
///
/// # Errors
/// Why they are not known.
pub(super) fn of_set(
    functions: &[&Scaled],
    used: &BTreeSet<usize>,
    reader: &Reader,
) -> Result<Vec<Member>, String> {
    let choosers: BTreeSet<usize> = functions
        .iter()
        .flat_map(|function| choosers(function))
        .collect();
    let Some(first) = choosers.first() else {
        return Ok(vec![Vec::new()]);
    };
    let mut listed: Vec<Member> = Vec::new();
    for block in blocks(reader.root) {
        let Some(parameters) = member(block, "parameters") else {
            continue;
        };
        let name = |row: usize| &*reader.table[row].name;
        if member(parameters, name(*first)).is_none() {
            continue;
        }
        let zips = match member(block, "zip").map(|node| &node.tree) {
            Some(Tree::List(groups)) => groups.iter().map(texts).collect(),
            _ => Vec::new(),
        };
        let found = zips.into_iter().find(|zip| zip.contains(&name(*first)));
        let zip = found.unwrap_or_else(|| vec![name(*first)]);
        let is_axis = |row: &&usize| {
            let axis = member(parameters, name(**row));
            axis.is_some_and(|node| matches!(&node.tree, Tree::List(items) if items.len() > 1))
        };
        let apart = choosers.iter().filter(is_axis);
        if let Some(row) = apart.into_iter().find(|row| !zip.contains(&name(**row))) {
            return Err(format!(
                "{} and {} choose motions of one station and must be in one \"zip\"",
                name(*first),
                name(*row)
            ));
        }
        listed.extend(rows(parameters, &zip, reader)?);
    }
    let mut known: Vec<Member> = Vec::new();
    for member in listed {
        if !known.contains(&member) {
            known.push(member);
        }
    }
    let rows: BTreeSet<usize> = known.iter().flatten().map(|value| value.0).collect();
    match follower(used, &rows, reader) {
        Some(row) => Err(format!(
            "{} follows from a parameter that changes with the motion; give it as a list in the \"zip\" of {}",
            reader.table[row].name, reader.table[*first].name
        )),
        None => Ok(known),
    }
}

/// The values of these parameters that occur together in a case, by their rows.
///
/// # Errors
/// A parameter has no list of values.
pub(super) fn combinations(chosen: &[usize], reader: &Reader) -> Result<Vec<Member>, String> {
    let mut found: Vec<Member> = Vec::new();
    for block in blocks(reader.root) {
        let Some(parameters) = member(block, "parameters") else {
            continue;
        };
        let name = |row: usize| &*reader.table[row].name;
        if chosen
            .iter()
            .any(|row| member(parameters, name(*row)).is_none())
        {
            continue;
        }
        let zips = match member(block, "zip").map(|node| &node.tree) {
            Some(Tree::List(groups)) => groups.iter().map(texts).collect(),
            _ => Vec::new(),
        };
        let mut combined: Vec<Member> = vec![Vec::new()];
        let mut left = chosen.to_vec();
        while let Some(first) = left.first().copied() {
            let zip = zips.iter().find(|zip| zip.contains(&name(first)));
            let (tied, others) = left
                .into_iter()
                .partition(|row| *row == first || zip.is_some_and(|zip| zip.contains(&name(*row))));
            left = others;
            let group: Vec<usize> = tied;
            let names: Vec<&str> = group.iter().map(|row| name(*row)).collect();
            let values = rows(parameters, &names, reader)?;
            let with = |before: &Member| -> Vec<Member> {
                let both = values.iter().map(|added| [&before[..], added].concat());
                both.collect()
            };
            combined = combined.iter().flat_map(with).collect();
        }
        for mut member in combined {
            member.sort_by_key(|value| value.0);
            if !found.contains(&member) {
                found.push(member);
            }
        }
    }
    Ok(found)
}

/// The rows of the parameters that choose a function.
fn choosers(function: &Scaled) -> Vec<usize> {
    match function.source.kind() {
        source::Kind::Record { rows, .. } => rows.clone(),
        source::Kind::Synthetic { seed, .. } => match &seed.source {
            amount::Source::Expression(expression) => expression.formula.uses().to_vec(),
            amount::Source::Number(_) => Vec::new(),
        },
        source::Kind::Sine { .. } | source::Kind::Table { .. } | source::Kind::Pulse(..) => {
            Vec::new()
        }
    }
}

/// The study, or its blocks.
fn blocks(root: &Node) -> Vec<&Node> {
    match member(root, "blocks").map(|node| &node.tree) {
        Some(Tree::List(blocks)) => blocks.iter().collect(),
        _ => vec![root],
    }
}

/// The values of the parameters of a `zip`, one row for each place in their lists.
fn rows(parameters: &Node, zip: &[&str], reader: &Reader) -> Result<Vec<Member>, String> {
    let mut combined: Vec<Member> = Vec::new();
    for name in zip {
        let row = reader.table.iter().position(|row| row.name == *name);
        let Some((row, node)) = row.zip(member(parameters, name)) else {
            continue;
        };
        let one = std::slice::from_ref(node);
        let items = match &node.tree {
            Tree::List(items) => items,
            Tree::Object(_) | Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => one,
        };
        let read = items.iter().map(|item| value(item, row, reader));
        let values = read.collect::<Option<Vec<Value>>>().ok_or_else(|| {
            format!(
                "{} must be a list of values, so that the motions are known",
                quoted(name)
            )
        })?;
        combined.resize(combined.len().max(values.len()), Vec::new());
        for (member, value) in combined.iter_mut().zip(values) {
            member.push((row, value));
        }
    }
    Ok(combined)
}

/// A value of a parameter.
fn value(node: &Node, row: usize, reader: &Reader) -> Option<Value> {
    match (&reader.table[row].kind, &node.tree) {
        (Kind::Choice(_), Tree::Text(text)) => Some(Value::Name(interned(text))),
        (Kind::Choice(_), _) => None,
        (Kind::Whole { .. }, _) => None,
        (Kind::Number(_), _) => {
            number(node, "", Range::Any, &mut Faults::default()).map(Value::Number)
        }
    }
}

/// A used parameter that follows by expressions from those of the motions.
fn follower(used: &BTreeSet<usize>, rows: &BTreeSet<usize>, reader: &Reader) -> Option<usize> {
    let given = given(reader.root);
    let mut changing = rows.clone();
    // A chain of expressions has at most as many links as there are parameters.
    for _ in reader.table {
        for (given, _) in &given {
            let row = reader.table.iter().position(|row| row.name == given.key);
            let follows = |text: &&str| {
                let formula = Formula::number(text, reader.table);
                formula.is_ok_and(|formula| formula.uses().iter().any(|row| changing.contains(row)))
            };
            if let Some(row) = row
                && texts(&given.node).iter().any(follows)
            {
                changing.insert(row);
            }
        }
    }
    used.intersection(&changing)
        .find(|row| !rows.contains(row))
        .copied()
}
