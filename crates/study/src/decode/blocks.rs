//! The blocks of a study: one under `parameters`, or several under `blocks`.

use super::resolve::resolve;
use super::spread::SHARED;
use super::validate::{has_good_case, validate, within_limit};
use crate::Block;
use crate::axes::design;
use crate::axes::draft::BlockDraft;
use crate::axes::parameters::parameters;
use crate::axes::zip::zip;
use crate::source::faults::{Faults, in_words, quoted};
use crate::source::field::{ANY, Field, Keys, Kind, field, fields, needed};
use crate::source::object::Object;
use crate::source::tree::{Node, Tree};
use crate::value::text;
use slipgap_problem::problem::Problem;
use slipgap_problem::problem::expression::Formula;

/// The blocks, of no more than `limit` raw combinations; none if one of them could not be decoded.
pub(crate) fn blocks(
    object: &Object,
    problem: Option<&dyn Problem>,
    limit: u64,
    faults: &mut Faults,
) -> Vec<Block> {
    let before = faults.count();
    let (one, several) = (object.get("parameters"), object.get("blocks"));
    match (one, several) {
        (Some(_), Some(node)) => {
            let message = "cannot be given together with \"parameters\"; give one of the two";
            faults.add(node.at, "blocks", message);
        }
        (None, None) => {
            let what = "the parameters of the cases, or \"blocks\" of them";
            object.missing("parameters", what, faults);
        }
        (Some(_), None) | (None, Some(_)) => {}
    }
    if let Some(node) = object.get(SHARED.name) {
        faults.add(
            node.at,
            SHARED.name,
            "must be an object, next to \"blocks\"",
        );
    }
    // Both are decoded, so that every fault is reported.
    let mut drafts = Vec::new();
    if let (Some(node), Some(problem)) = (one, problem) {
        drafts.extend(draft(object, node, problem, faults));
    }
    if one.is_none() {
        for key in BLOCK_KEYS.iter().map(|field| field.name) {
            if let Some(node) = object.get(key) {
                let message = "must be inside a block, next to its \"parameters\"";
                faults.add(node.at, key, message);
            }
        }
    }
    drafts.extend(object.items("blocks", faults, |node, path, faults| {
        let object = Object::open(node, path, &BLOCK, faults)?;
        let (node, _) = object.given("parameters", faults)?;
        draft(&object, node, problem?, faults)
    }));
    if let (None, Some(node)) = (one, several)
        && matches!(&node.tree, Tree::List(blocks) if blocks.is_empty())
    {
        faults.must_be(node, "blocks", "a non-empty list of blocks");
    }
    let mut complete = faults.count() == before;
    let key = if several.is_some() {
        "blocks"
    } else {
        "parameters"
    };
    let at = several.or(one).map_or(0, |node| node.at);
    if !within_limit(&drafts, limit, at, key, faults) {
        return Vec::new();
    }
    let Some(problem) = problem else {
        return Vec::new();
    };
    let mut blocks = Vec::new();
    for draft in &mut drafts {
        draft.sample(problem.parameters());
        let Some(block) = resolve(draft, problem, faults) else {
            complete = false;
            continue;
        };
        let choosing = object.get("recommend").is_some();
        if !(choosing && has_good_case(problem, &block)) {
            validate(problem, draft, &block, faults);
        }
        blocks.push(block);
    }
    // Figures and checks may select a case that breaks a rule.
    match complete {
        true => blocks,
        false => Vec::new(),
    }
}

/// The keys of a block in addition to `parameters`, each with its meaning.
pub(crate) const BLOCK_KEYS: &[Field] = &fields![
    /// groups of axes that advance together instead of being combined
    field("zip", Kind::List(&Kind::List(&Kind::Text, [2, ANY]), [0, ANY])),
    /// a condition that every case meets, as in "dt <= 0.5/n"; names are in single quotes
    field("when", Kind::Text),
    /// points that fill the ranges of parameters
    field("design", Kind::Object(&design::KEYS)),
];

/// A block.
const BLOCK: Keys = Keys::new(&fields![
    /// the parameters of the block
    needed("parameters", Kind::Any),
])
.and(BLOCK_KEYS);

/// The draft of a block: the parameters at `node` and the other keys of `object`.
fn draft(
    object: &Object,
    node: &Node,
    problem: &dyn Problem,
    faults: &mut Faults,
) -> Option<BlockDraft> {
    let table = problem.parameters();
    let mut draft = parameters(node, &object.path("parameters"), table, faults)?;
    if let Some(node) = object.get("zip") {
        zip(node, &object.path("zip"), table, &mut draft, faults);
    }
    if let Some(node) = object.get("when") {
        let path = object.path("when");
        draft.when =
            text(node, &path, faults).and_then(|text| match Formula::condition(&text, table) {
                Ok(formula) => Some((formula, node.at, text)),
                Err(fault) => {
                    let message = format!("{}: {}", quoted(&text), in_words(&fault));
                    faults.add(node.at, &path, message);
                    None
                }
            });
    }
    draft.design(object, faults);
    Some(draft)
}
