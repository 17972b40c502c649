//! Files by a folder or a pattern: `{"files": "records/*.smc"}` as the value of a parameter, of `record` in the structure, or of `file`
//! in `measured`.
//! It becomes the list of the files, which is what the rest of the reader sees.

use super::choice::chosen;
use super::pattern::{Found, matching};
use crate::source::faults::{Faults, join, quoted};
use crate::source::folder::Folder;
use crate::source::object::Object;
use crate::source::tree::{Member, Node, Tree};
use crate::structure::keys::{FILES, KEY};
use crate::structure::reading::given::{members, texts};
use crate::value::text;

/// The key of measurements, and the parameter of their files.
const MEASURED: &str = KEY.name;

/// The name of a parameter, the offset and path of its files, and these.
type Listed = (String, usize, String, Found);

/// Puts the lists of files into the parameters of a study; `folder` is that of the study.
pub(crate) fn expand(root: &mut Node, folder: &Folder, faults: &mut Faults) {
    let mut named = Vec::new();
    let Some(structure) = root.member("structure") else {
        return;
    };
    take(structure, "", "structure", &mut named);
    if let Some(measured) = root.member(MEASURED) {
        // Tests that are compared as a sample are no axis.
        let way = measured.get("compare").map(texts).unwrap_or_default();
        let is_sample = way.contains(&"distribution");
        if let Some(file) = measured.member("file").filter(|node| has_files(node)) {
            let path = join(MEASURED, "file");
            match is_sample {
                true => {
                    let found = files(file, &path, folder, faults).unwrap_or_default();
                    file.tree = listed(file.at, found);
                }
                false => named.push((replaced(file, MEASURED.to_owned()), path)),
            }
        }
    }
    for (path, block) in blocks(root) {
        let Some(parameters) = block.member("parameters") else {
            continue;
        };
        let Tree::Object(members) = &mut parameters.tree else {
            continue;
        };
        for (new, _) in &named {
            if !members.iter().any(|known| known.key == new.key) {
                members.push(new.clone());
            }
        }
        let path = join(&path, "parameters");
        let (mut found, mut leader) = (Vec::new(), None);
        for given in members.iter_mut().filter(|given| has_files(&given.node)) {
            // The files of the structure are at fault there.
            let mut of_structure = named.iter().filter(|new| new.0.at == given.at);
            let path = match of_structure.next() {
                Some((_, path)) => path.clone(),
                None => join(&path, &given.key),
            };
            if let Some(files) = files(&given.node, &path, folder, faults) {
                if given.node.get("choose").is_some() {
                    leader = Some(found.len());
                }
                found.push((given.key.clone(), given.node.at, path, files));
            }
        }
        if let Some(leader) = leader {
            follow(&mut found, leader);
        }
        go_together(block, found, faults);
    }
}

/// Leaves of the other files those that go with the chosen ones, if there is one with each.
fn follow(found: &mut [Listed], leader: usize) {
    let stars: Vec<String> = found[leader].3.iter().map(|file| file.0.clone()).collect();
    for (_, _, _, files) in found {
        let has = |star: &String| files.iter().any(|file| file.0 == *star);
        if stars.iter().all(has) {
            files.retain(|file| stars.contains(&file.0));
        }
    }
}

/// Whether a value is an object with files.
fn has_files(node: &Node) -> bool {
    members(node).iter().any(|member| member.key == "files")
}

/// Takes the files out of the structure: `record` becomes the name of a parameter.
fn take(node: &mut Node, name: &str, path: &str, found: &mut Vec<(Member, String)>) {
    match &mut node.tree {
        Tree::Object(members) => {
            for member in members {
                let path = join(path, &member.key);
                if member.key == "record" && has_files(&member.node) {
                    let key = format!("record{name}");
                    found.push((replaced(&mut member.node, key), path));
                    continue;
                }
                // The ground in x is `record_x`, a support `record_left`.
                let parameter = match member.key.as_str() {
                    "ground" | "supports" | "contacts" => name.to_owned(),
                    key => format!("{name}_{key}"),
                };
                take(&mut member.node, &parameter, &path, found);
            }
        }
        Tree::List(items) => {
            for (i, item) in items.iter_mut().enumerate() {
                take(item, &format!("{name}_{i}"), &format!("{path}[{i}]"), found);
            }
        }
        Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => {}
    }
}

/// Puts the name of a parameter in the place of a value; gives the parameter with the value.
fn replaced(node: &mut Node, key: String) -> Member {
    let at = node.at;
    let tree = Tree::Text(key.clone());
    let node = std::mem::replace(node, Node { at, tree });
    Member { key, at, node }
}

/// The study, or its blocks, each with its path.
pub(in crate::structure) fn blocks(root: &mut Node) -> Vec<(String, &mut Node)> {
    if root.get("blocks").is_none() {
        return vec![(String::new(), root)];
    }
    match root.member("blocks").map(|node| &mut node.tree) {
        Some(Tree::List(items)) => {
            let items = items.iter_mut().enumerate();
            items
                .map(|(i, item)| (format!("blocks[{i}]"), item))
                .collect()
        }
        _ => Vec::new(),
    }
}

/// The files of an object, in the order of their names.
fn files(node: &Node, path: &str, folder: &Folder, faults: &mut Faults) -> Option<Found> {
    let object = Object::open(node, path, &FILES, faults)?;
    let (node, path) = object.given("files", faults)?;
    let pattern = text(node, &path, faults)?;
    let found = matching(&pattern, folder.path);
    match found {
        Ok(found) => match object.given("choose", faults) {
            Some((node, path)) => chosen(node, &path, found, folder, faults),
            None => Some(found),
        },
        Err(why) => {
            faults.add(node.at, &path, format!("{}: {why}", quoted(&pattern)));
            None
        }
    }
}

/// Puts the lists of a block in place. Those that are in no `zip` of the study become one: the files for which `*` is the same go
/// together.
fn go_together(block: &mut Node, mut found: Vec<Listed>, faults: &mut Faults) {
    let zipped: Vec<String> = block
        .get("zip")
        .map(|node| texts(node).into_iter().map(str::to_owned).collect())
        .unwrap_or_default();
    let free: Vec<usize> = (0..found.len())
        .filter(|i| !zipped.contains(&found[*i].0))
        .collect();
    if let [first, others @ ..] = &free[..]
        && !others.is_empty()
    {
        let order: Vec<String> = found[*first].3.iter().map(|file| file.0.clone()).collect();
        let leader = found[*first].0.clone();
        for other in others {
            let (_, at, path, files) = &mut found[*other];
            let index_of = |star: &str| order.iter().position(|known| known == star);
            let extra = files.iter().find(|file| index_of(&file.0).is_none());
            let missing = order
                .iter()
                .find(|star| !files.iter().any(|file| file.0 == **star));
            let why = match (extra, missing) {
                (Some((star, file)), _) => format!(
                    "{} has no partner in {leader}, with {} for *",
                    quoted(file),
                    quoted(star)
                ),
                (None, Some(star)) => {
                    format!("no file with {} for *, as {leader} has one", quoted(star))
                }
                (None, None) => {
                    files.sort_by_key(|file| index_of(&file.0));
                    continue;
                }
            };
            faults.add(
                *at,
                path,
                format!(
                    "{why}; files of several parameters go together, those with the same text for *"
                ),
            );
        }
        let files = free.iter().map(|i| &found[*i]);
        let names = files.map(|(name, at, ..)| Node {
            at: *at,
            tree: Tree::Text(name.clone()),
        });
        let group = Node {
            at: found[*first].1,
            tree: Tree::List(names.collect()),
        };
        add_zip(block, group);
    }
    for (name, at, _, files) in found {
        let given = block
            .member("parameters")
            .and_then(|node| node.member(&name));
        if let Some(given) = given {
            given.tree = listed(at, files);
        }
    }
}

/// The list of files, at one place of the study.
fn listed(at: usize, files: Found) -> Tree {
    let text = |file: (String, String)| Node {
        at,
        tree: Tree::Text(file.1),
    };
    Tree::List(files.into_iter().map(text).collect())
}

/// Adds a group to the `zip` of a block.
pub(in crate::structure) fn add_zip(block: &mut Node, group: Node) {
    if let Some(zip) = block.member("zip") {
        if let Tree::List(groups) = &mut zip.tree {
            groups.push(group);
        }
        return;
    }
    if let Tree::Object(members) = &mut block.tree {
        let at = group.at;
        let tree = Tree::List(vec![group]);
        members.push(Member {
            key: "zip".to_owned(),
            at,
            node: Node { at, tree },
        });
    }
}
