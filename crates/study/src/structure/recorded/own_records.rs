//! Records of the command line instead of synthetic motions: `--set record=..` for a structure whose study has no parameter `record`.
//!
//! The seeds become the numbers of the records, so that reductions, ensembles and figures over the seed are then over the records. Each
//! record is scaled to the peak that all synthetic motions have; `scale` of the study stays. A `start` of the command line is that of
//! the records, a `unit` their unit. Parameters that only the synthetic motions needed go.

use super::record_axis::{add_zip, blocks};
use crate::source::faults::{Faults, join, quoted};
use crate::source::tree::{Member, Node, Tree};
use crate::structure::reading::given::{given, texts, under};
use crate::structure::reading::reader::is_name;
use slipgap_system::system::loads::synthetic::PEAK;

/// The parameters that the command line may add.
pub(crate) const RECORD: &str = "record";
const START: &str = "start";
const UNIT: &str = "unit";

/// The parameter whose values are the seeds of the motions that records can replace; `None` if there are no such motions.
pub(crate) fn seed(root: &Node) -> Option<String> {
    let structure = root.get("structure")?;
    let mut seeds = Vec::new();
    under(structure, "seed", &mut seeds);
    let seed = seeds.into_iter().find(|seed| is_name(seed))?.to_owned();
    let parameters = given(root);
    let values = |name: &str| {
        let named = parameters.iter().filter(|(member, _)| member.key == name);
        named
            .map(|(member, _)| &member.node.tree)
            .collect::<Vec<_>>()
    };
    let listed = |tree: &&Tree| !matches!(tree, Tree::Text(_));
    let is_axis = !values(&seed).is_empty() && values(&seed).iter().all(listed);
    (is_axis && values(RECORD).is_empty()).then_some(seed)
}

/// Whether a study has a parameter `record` of files, or motions that records can replace.
pub(crate) fn takes_record(root: &Node) -> bool {
    let mut records = Vec::new();
    if let Some(structure) = root.get("structure") {
        under(structure, RECORD, &mut records);
    }
    records.contains(&RECORD) || seed(root).is_some()
}

/// Puts the records in the place of the synthetic motions of this seed.
pub(crate) fn replace(root: &mut Node, seed: &str, faults: &mut Faults) {
    // Keys of the records: a start for each, one unit for all.
    let mut keys = Vec::new();
    for (path, block) in blocks(root) {
        keys = number_records(block, seed, &path, faults);
    }
    let mut of_motions = Vec::new();
    if let Some(structure) = root.member("structure") {
        replace_motions(structure, seed, &keys, &mut of_motions);
    }
    drop_unused(root, of_motions);
}

/// Removes the parameters that only the synthetic motions needed, such as the frequency of their ground filter.
fn drop_unused(root: &mut Node, mut of_motions: Vec<String>) {
    while let Some(name) = of_motions.pop() {
        let mut names = Vec::new();
        named(root, &mut names);
        if names.contains(&name) {
            continue;
        }
        for (_, block) in blocks(root) {
            let parameters = block.member("parameters").map(|node| &mut node.tree);
            let Some(Tree::Object(members)) = parameters else {
                continue;
            };
            for member in members.iter().filter(|member| member.key == name) {
                named(&member.node, &mut of_motions);
            }
            members.retain(|member| member.key != name);
        }
    }
}

/// The names in the texts of a node, but for comments.
fn named(node: &Node, names: &mut Vec<String>) {
    match &node.tree {
        Tree::Text(text) => {
            let parts = text.split(|c: char| !(c.is_alphanumeric() || c == '_'));
            names.extend(parts.map(str::to_owned));
        }
        Tree::Object(members) => {
            let read = members
                .iter()
                .filter(|member| member.key != "//" && member.key != "title");
            read.for_each(|member| named(&member.node, names));
        }
        Tree::List(items) => items.iter().for_each(|item| named(item, names)),
        Tree::Number(_) | Tree::Bool(_) | Tree::Null => {}
    }
}

/// Numbers the records of a block by the seed; gives the keys of the motions that the command line has beside their files.
fn number_records(block: &mut Node, seed: &str, path: &str, faults: &mut Faults) -> Vec<Member> {
    let zipped = block.get("zip").map(texts).unwrap_or_default();
    let in_zip = zipped.contains(&seed);
    let Some(parameters) = block.member("parameters") else {
        return Vec::new();
    };
    let unit = take(parameters, UNIT);
    let Some(record) = parameters.member(RECORD) else {
        return Vec::new();
    };
    let at = record.at;
    if !matches!(record.tree, Tree::List(_)) {
        record.tree = Tree::List(vec![record.clone()]);
    }
    let count = record.items().len();
    let start = parameters
        .get(START)
        .map(|start| matches!(start.tree, Tree::List(_)));
    if let Some(seeds) = parameters.member(seed) {
        if in_zip {
            let message = format!(
                "cannot replace synthetic motions whose seed {} is in a zip",
                quoted(seed)
            );
            faults.add(at, &join(path, "zip"), message);
        }
        let number = |n: usize| Node {
            at,
            tree: Tree::Number(n.to_string()),
        };
        seeds.tree = Tree::List((1..=count).map(number).collect());
    }
    let mut names = vec![seed, RECORD];
    names.extend((start == Some(true)).then_some(START));
    let name = |name: &str| Node {
        at,
        tree: Tree::Text(name.to_owned()),
    };
    let tree = Tree::List(names.into_iter().map(name).collect());
    add_zip(block, Node { at, tree });
    let start = start.map(|_| Member {
        key: START.to_owned(),
        at,
        node: name(START),
    });
    start.into_iter().chain(unit).collect()
}

/// Takes a member out of an object.
fn take(node: &mut Node, key: &str) -> Option<Member> {
    let Tree::Object(members) = &mut node.tree else {
        return None;
    };
    let index = members.iter().position(|member| member.key == key)?;
    Some(members.remove(index))
}

/// Makes records of the synthetic motions of this seed.
fn replace_motions(node: &mut Node, seed: &str, keys: &[Member], of_motions: &mut Vec<String>) {
    let is_motion = node
        .get("synthetic")
        .and_then(|motion| motion.get("seed"))
        .is_some_and(|given| matches!(&given.tree, Tree::Text(name) if name == seed));
    match &mut node.tree {
        Tree::Object(members) if is_motion => {
            let at = node.at;
            let member = |key: &str, tree| Member {
                key: key.to_owned(),
                at,
                node: Node { at, tree },
            };
            members.retain(|member| {
                if member.key == "synthetic" {
                    named(&member.node, of_motions);
                }
                member.key != "synthetic"
            });
            members.push(member(RECORD, Tree::Text(RECORD.to_owned())));
            let goal = vec![
                member("pga", Tree::Number(PEAK.to_string())),
                member("unit", Tree::Text("g".to_owned())),
            ];
            members.push(member("scale_to", Tree::Object(goal)));
            members.extend(keys.iter().cloned());
        }
        Tree::Object(members) => {
            members
                .iter_mut()
                .for_each(|member| replace_motions(&mut member.node, seed, keys, of_motions));
        }
        Tree::List(items) => items
            .iter_mut()
            .for_each(|item| replace_motions(item, seed, keys, of_motions)),
        Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => {}
    }
}
