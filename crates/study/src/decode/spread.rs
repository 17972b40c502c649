//! Blocks that a study writes in short: parameters that all blocks share, and lists with expressions of other parameters. What is
//! decoded has blocks alone.

use crate::source::field::{Field, Kind, field};
use crate::source::tree::{Member, Node, Tree};
use crate::structure::named::free_names::free_number;
use crate::structure::reading::given::{members, texts};
use slipgap_problem::problem::expression::Formula;
use slipgap_problem::problem::numbers::parameter::Parameter;

/// The key of parameters of all blocks, with its meaning.
pub(super) const SHARED: Field = field("shared", Kind::Shared("parameters"))
    .means("parameters of every block that does not give them itself");

/// Puts the shared parameters into each block. Without blocks they stay, which is a fault.
pub(super) fn share(root: &mut Node) {
    let shared = root
        .get(SHARED.name)
        .map(|node| (node.at, members(node).to_vec()));
    let (Some((at, shared)), Some(blocks)) = (shared, blocks(root)) else {
        return;
    };
    for block in blocks {
        let Tree::Object(keys) = &mut block.tree else {
            continue;
        };
        if keys.iter().all(|key| key.key != "parameters") {
            let tree = Tree::Object(Vec::new());
            let node = Node { at, tree };
            keys.push(key("parameters", node));
        }
        let parameters = block.member("parameters").map(|node| &mut node.tree);
        if let Some(Tree::Object(given)) = parameters {
            let is_new = |new: &&Member| given.iter().all(|known| known.key != new.key);
            let mut all_given: Vec<Member> = shared.iter().filter(is_new).cloned().collect();
            all_given.append(given);
            *given = all_given;
        }
    }
    if let Tree::Object(keys) = &mut root.tree {
        keys.retain(|key| key.key != SHARED.name);
    }
}

/// Makes of a block with a list of expressions of other parameters one block for each item.
pub(super) fn spread(root: &mut Node) {
    if let Some(blocks) = blocks(root) {
        *blocks = blocks.drain(..).flat_map(spread_block).collect();
        return;
    }
    if listed(root).is_none() {
        return;
    }
    let at = root.at;
    if let Tree::Object(keys) = &mut root.tree {
        let of_block = ["parameters", "zip", "when", "design"];
        let (moved, mut others): (Vec<Member>, Vec<Member>) = keys
            .drain(..)
            .partition(|key| of_block.contains(&&*key.key));
        let block = Node {
            at,
            tree: Tree::Object(moved),
        };
        let tree = Tree::List(spread_block(block));
        others.push(key("blocks", Node { at, tree }));
        *keys = others;
    }
}

/// The blocks of a block: itself, or one for each item of a list with expressions, in the order of the list.
fn spread_block(block: Node) -> Vec<Node> {
    let Some((names, count)) = listed(&block) else {
        return vec![block];
    };
    let of_item = |index: usize| {
        let mut one = block.clone();
        if let Some(Tree::Object(given)) = one.member("parameters").map(|node| &mut node.tree) {
            for parameter in given.iter_mut().filter(|given| names.contains(&given.key)) {
                if let Tree::List(items) = &mut parameter.node.tree {
                    parameter.node = items.swap_remove(index);
                }
            }
        }
        if let Some(Tree::List(groups)) = one.member("zip").map(|node| &mut node.tree) {
            groups.retain(|group| !zipped(group).iter().any(|name| names.contains(name)));
        }
        one
    };
    (0..count).map(of_item).flat_map(spread_block).collect()
}

/// The first list with expressions of other parameters of a block, with those that advance together with it, and the number of items.
/// Lists of other lengths are a fault, so that they stay.
fn listed(block: &Node) -> Option<(Vec<String>, usize)> {
    let given = members(block.get("parameters")?);
    let names = given.iter().map(|parameter| &*parameter.key);
    let table: Vec<Parameter> = names.map(free_number).collect();
    let first = given
        .iter()
        .find(|given| has_expressions(&given.node, &table))?;
    let zips = block.get("zip").and_then(Node::list).unwrap_or_default();
    let mut groups = zips.iter().map(zipped);
    let of_zip = groups.find(|group| group.contains(&first.key));
    let together = of_zip.unwrap_or_else(|| vec![first.key.clone()]);
    let length = |name: &String| {
        let parameter = given.iter().find(|given| given.key == *name)?;
        parameter.node.list().map(<[Node]>::len)
    };
    let count = length(&first.key)?;
    let all_alike = together.iter().all(|name| length(name) == Some(count));
    all_alike.then_some((together, count))
}

/// Whether a value is a list with an expression of one of these parameters. A list of names is one of labels, even if one of them is the
/// name of a parameter.
fn has_expressions(node: &Node, table: &[Parameter]) -> bool {
    let items = node.list().unwrap_or_default().iter();
    let texts: Vec<&str> = items.filter_map(Node::text).collect();
    let formulas = texts.iter().map(|text| Formula::number(text, table));
    let Ok(formulas) = formulas.collect::<Result<Vec<Formula>, _>>() else {
        return false;
    };
    let is_name = |text: &str| table.iter().any(|parameter| parameter.name == text);
    let mut both = texts.iter().zip(formulas);
    both.any(|(text, formula)| !formula.uses().is_empty() && !is_name(text))
}

/// The names of a group of a `zip`.
fn zipped(group: &Node) -> Vec<String> {
    texts(group).into_iter().map(str::to_owned).collect()
}

/// The blocks of a study.
fn blocks(root: &mut Node) -> Option<&mut Vec<Node>> {
    match root.member("blocks").map(|node| &mut node.tree) {
        Some(Tree::List(blocks)) => Some(blocks),
        Some(_) | None => None,
    }
}

fn key(name: &str, node: Node) -> Member {
    Member {
        key: name.to_owned(),
        at: node.at,
        node,
    }
}

#[cfg(test)]
mod tests {
    use crate::{Study, parse};

    fn study(text: &str) -> Result<Study, String> {
        parse("study.json", text).map_err(|error| error.to_string())
    }

    /// The values of a parameter in all cases.
    fn values(study: &Study, name: &str) -> Vec<Option<f64>> {
        study.cases().map(|case| case.number(name)).collect()
    }

    const OSCILLATOR: &str = r#"{"problem": "friction-oscillator", "parameters": {"law": "displacement-control", "duration": "4*pi","#;

    #[test]
    fn a_list_of_expressions_has_the_values_of_its_items() {
        let text = |rest: &str| format!("{OSCILLATOR} {rest}");
        let listed = study(&text(
            r#""alpha": [0.3, 0.5], "dT": ["alpha/10", "alpha/20", 0.02]}}"#,
        ))
        .unwrap();
        // One block for each item, in the order of the list.
        let wanted = [0.3 / 10.0, 0.5 / 10.0, 0.3 / 20.0, 0.5 / 20.0, 0.02, 0.02];
        assert_eq!(values(&listed, "dT"), wanted.map(Some));
        assert_eq!(
            values(&listed, "alpha"),
            [0.3, 0.5, 0.3, 0.5, 0.3, 0.5].map(Some)
        );
        // Two lists in a zip, with a third one of numbers, and one alone.
        let zipped = study(&text(
            r#""alpha": [0.3, 0.4], "x0": [12, 6], "dT": ["alpha/10", "alpha/20"]}, "zip": [["dT", "alpha", "x0"]]}"#,
        ))
        .unwrap();
        assert_eq!(values(&zipped, "dT"), [0.3 / 10.0, 0.4 / 20.0].map(Some));
        assert_eq!(values(&zipped, "x0"), [12.0, 6.0].map(Some));
        let both = study(&text(
            r#""alpha": 0.3, "a": ["2*alpha", "alpha"], "dT": ["a/10", "a/20"]}}"#,
        ))
        .unwrap();
        let product = [0.6 / 10.0, 0.6 / 20.0, 0.3 / 10.0, 0.3 / 20.0];
        assert_eq!(values(&both, "dT"), product.map(Some));
        // A zip with a list of another length, and a value that is not allowed, are faults at their places.
        let other = study(&text(
            r#""alpha": [0.3, 0.4, 0.5], "dT": ["alpha/10", "alpha/20"]}, "zip": [["dT", "alpha"]]}"#,
        ));
        let why = other.unwrap_err();
        assert!(why.contains("as many values"), "{why}");
        let negative = study(&text(r#""alpha": 0.3, "dT": ["alpha/10", "-alpha"]}}"#));
        let why = negative.unwrap_err();
        assert!(
            why.contains("1:") && why.contains("got \"-alpha\" = -0.3"),
            "{why}"
        );
    }

    #[test]
    fn labels_that_are_names_of_parameters_stay_labels() {
        let text = |girders: &str| {
            format!(
                r#"{{"problem": "structure", "parameters": {{"rigid": [1, 1000], "girders": {girders}, "dt": 0.01, "duration": 1}},
                  "zip": [["rigid", "girders"]], "metrics": ["last(m)"],
                  "structure": {{"masses": {{"m": 1}}, "springs": [{{"between": ["ground", "m"], "k": "rigid"}}]}}}}"#
            )
        };
        for labels in [r#"["bars", "rigid"]"#, r#"["rigid", "bars"]"#] {
            let labelled = study(&text(labels)).unwrap();
            assert_eq!(labelled.blocks.len(), 1);
            assert_eq!(values(&labelled, "rigid"), [1.0, 1000.0].map(Some));
        }
    }

    const PAIR: &str = r#""structure": {"masses": {"a": 1, "b": 1}, "start": {"a": {"v": 1}}, "contacts": {"c": {"law": "law",
        "between": ["a", "b"], "gap": "gap", "k": "k", "restitution": "e", "colliding_mass": 0.5}}}, "metrics": ["last(b.v)"]}"#;

    #[test]
    fn blocks_have_the_shared_parameters() {
        let laws = |blocks: &str| {
            let text = format!(
                r#"{{"problem": "structure", "shared": {{"gap": 0.1, "dt": 0.001, "duration": [0.5, 1], "k": 1e4}}, "blocks": [{blocks}], {PAIR}"#
            );
            study(&text)
        };
        let both = laws(
            r#"{"parameters": {"law": "impact-spring", "e": 1}}, {"parameters": {"law": "kelvin-voigt", "e": 0.5, "gap": 0.2}}"#,
        )
        .unwrap();
        let written_out = study(&format!(
            r#"{{"problem": "structure", "blocks": [
                {{"parameters": {{"gap": 0.1, "dt": 0.001, "duration": [0.5, 1], "k": 1e4, "law": "impact-spring", "e": 1}}}},
                {{"parameters": {{"dt": 0.001, "duration": [0.5, 1], "k": 1e4, "law": "kelvin-voigt", "e": 0.5, "gap": 0.2}}}}], {PAIR}"#
        ))
        .unwrap();
        let cases = |study: &Study| -> Vec<String> {
            study
                .cases()
                .map(|case| format!("{:?}", case.values))
                .collect()
        };
        assert_eq!(cases(&both), cases(&written_out));
        assert_eq!(both.len(), 4);
        let alone = study(&format!(
            r#"{{"problem": "structure", "shared": {{"gap": 0.1}}, "parameters": {{"dt": 0.001}}, {PAIR}"#
        ));
        assert!(
            alone
                .unwrap_err()
                .contains("shared: must be an object, next to \"blocks\"")
        );
    }
}
