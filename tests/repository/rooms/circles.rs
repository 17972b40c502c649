//! Circles of imports: modules of a folder that import one another, directly or by others, with all that is in their folders.

use super::imports::imports;
use super::sources::Crate;
use std::collections::{BTreeMap, BTreeSet};

/// Modules of a folder that each imports, with a file that does.
type Graph = BTreeMap<String, BTreeMap<String, String>>;

/// The circles of a crate as text, one for each set of modules.
pub fn of(tree: &Crate) -> Vec<String> {
    let mut folders: BTreeMap<Vec<String>, Graph> = BTreeMap::new();
    for module in tree.modules.iter().filter(|module| !module.is_test) {
        for path in imports(module) {
            let (from, to) = (&module.path[..], tree.module_of(&path));
            let common = from.iter().zip(to).take_while(|(a, b)| a == b).count();
            if let (Some(a), Some(b)) = (from.get(common), to.get(common)) {
                let graph = folders.entry(from[..common].to_vec()).or_default();
                let imported = graph.entry(a.clone()).or_default();
                imported.insert(b.clone(), module.file.display().to_string());
            }
        }
    }
    let circles = folders.iter().flat_map(|(folder, graph)| {
        let room = [vec![tree.name.clone()], folder.clone()].concat().join("/");
        let circles = circles(graph).into_iter();
        circles.map(move |circle| format!("{room}: {}", described(graph, &circle)))
    });
    circles.collect()
}

/// The modules that a module imports, directly or by others.
fn reached(graph: &Graph, from: &str) -> BTreeSet<String> {
    let mut reached = BTreeSet::new();
    let mut next = vec![from];
    while let Some(module) = next.pop() {
        for other in graph.get(module).into_iter().flat_map(BTreeMap::keys) {
            if reached.insert(other.clone()) {
                next.push(other);
            }
        }
    }
    reached
}

/// The sets of modules that all import one another.
fn circles(graph: &Graph) -> BTreeSet<BTreeSet<String>> {
    let reached_by: BTreeMap<&String, BTreeSet<String>> = graph
        .keys()
        .map(|module| (module, reached(graph, module)))
        .collect();
    let circle = |(from, reached): (&&String, &BTreeSet<String>)| {
        let back = |other: &&String| {
            reached_by
                .get(other)
                .is_some_and(|back| back.contains(*from))
        };
        reached
            .contains(*from)
            .then(|| reached.iter().filter(back).cloned().collect())
    };
    reached_by.iter().filter_map(circle).collect()
}

/// The imports between the modules of a circle, each with a file.
fn described(graph: &Graph, circle: &BTreeSet<String>) -> String {
    let mut lines = vec![circle.iter().cloned().collect::<Vec<_>>().join(", ")];
    for module in circle {
        let imported = graph[module]
            .iter()
            .filter(|(other, _)| circle.contains(*other));
        lines.extend(
            imported.map(|(other, file)| format!("    {module} imports {other} in {file}")),
        );
    }
    lines.join("\n")
}
