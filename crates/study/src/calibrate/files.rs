//! The paths of files in a study that is written to another folder.

use super::nodes::blocks;
use crate::source::tree::{Node, Tree};
use std::path::{Component, Path, PathBuf};

/// Keys of a structure and of measurements whose texts are files, or parameters that choose one.
const FILES: [&str; 7] = ["file", "record", "M", "K", "C", "dofs", "pairs"];

/// Changes the paths of files from one folder to another.
pub(super) fn move_files(root: &mut Node, from: &Path, to: &Path) {
    let mut found = Vec::new();
    for key in ["structure", "measured"] {
        if let Some(node) = root.member(key) {
            texts_of_files(node, &mut |text| found.push(text.clone()));
        }
    }
    let mut change = |text: &mut String| {
        if let Some(moved) = moved(text, from, to) {
            *text = moved;
        }
    };
    for key in ["structure", "measured"] {
        if let Some(node) = root.member(key) {
            texts_of_files(node, &mut change);
        }
    }
    for block in blocks(root) {
        for name in &found {
            let parameters = block.member("parameters");
            if let Some(given) = parameters.and_then(|node| node.member(name)) {
                each_text(given, &mut change);
            }
        }
    }
}

/// Visits the texts under the keys of files.
fn texts_of_files(node: &mut Node, visit: &mut dyn FnMut(&mut String)) {
    match &mut node.tree {
        Tree::Object(members) => {
            for member in members {
                match FILES.contains(&member.key.as_str()) {
                    true => each_text(&mut member.node, visit),
                    false => texts_of_files(&mut member.node, visit),
                }
            }
        }
        Tree::List(items) => items
            .iter_mut()
            .for_each(|item| texts_of_files(item, visit)),
        Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => {}
    }
}

/// Visits a text, or those of a list.
fn each_text(node: &mut Node, visit: &mut dyn FnMut(&mut String)) {
    match &mut node.tree {
        Tree::Text(text) => visit(text),
        Tree::List(items) => items.iter_mut().for_each(|item| each_text(item, visit)),
        Tree::Object(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => {}
    }
}

/// The path of a file seen from another folder; `None` if there is no such file, or if it is absolute.
fn moved(text: &str, from: &Path, to: &Path) -> Option<String> {
    let file = from.join(text);
    if Path::new(text).is_absolute() || text.contains('\n') || !file.is_file() {
        return None;
    }
    let here = |path: &Path| match path.as_os_str().is_empty() {
        true => PathBuf::from("."),
        false => path.to_owned(),
    };
    let (file, to) = (file.canonicalize().ok()?, here(to).canonicalize().ok()?);
    let pairs = file.components().zip(to.components());
    let shared = pairs.take_while(|(a, b)| a == b).count();
    if shared == 0 {
        // Another drive of Windows.
        return file.to_str().map(str::to_owned);
    }
    let up = to.components().skip(shared).map(|_| "..".to_owned());
    let down = file.components().skip(shared).map(|part: Component| {
        let name = part.as_os_str().to_str();
        name.map(str::to_owned)
    });
    let parts: Option<Vec<String>> = up.map(Some).chain(down).collect();
    Some(parts?.join("/"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_leads_from_the_new_folder_to_the_same_file() {
        let folder = std::env::temp_dir().join(format!("slipgap-best-{}", std::process::id()));
        let [studies, out] = ["studies/tests", "figures/a/b"].map(|name| folder.join(name));
        std::fs::create_dir_all(&studies).unwrap();
        std::fs::create_dir_all(&out).unwrap();
        std::fs::write(studies.join("one.csv"), "t,u\n").unwrap();
        let from = folder.join("studies");
        let found = moved("tests/one.csv", &from, &out).unwrap();
        assert_eq!(found, "../../../studies/tests/one.csv");
        assert_eq!(std::fs::read(out.join(found)).unwrap(), b"t,u\n");
        assert_eq!(moved("tests/two.csv", &from, &out), None);
        std::fs::remove_dir_all(folder).unwrap();
    }
}
