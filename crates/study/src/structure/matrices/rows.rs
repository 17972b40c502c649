//! The rows of matrices of other programs, their supports, and the dofs that are tied to them.

use crate::source::faults::Faults;
use crate::source::tree::{Node, Tree};
use crate::structure::reading::files;
use crate::structure::reading::reader::Reader;
use crate::value::text;
use slipgap_system::system::import::{Dofs, ImportFault};

/// Most bytes of a file: 10^6 rows with 80 entries each.
pub(in crate::structure) const LARGEST: u64 = 2 << 30;

/// Rows with ties to them or forces of members, of a file or of its content.
pub(in crate::structure) fn with_more(
    (node, path): (&Node, &str),
    reader: &Reader,
    faults: &mut Faults,
    parse: impl FnOnce(&[u8]) -> Result<Dofs, ImportFault>,
) -> Option<Dofs> {
    if let Some(content) = node.text().filter(|text| text.contains('\n')) {
        return inline(content, (node, path), faults, parse);
    }
    let file = text(node, path, faults)?;
    files::read(&file, (node, path), LARGEST, reader, faults, parse)
}

/// The text of a file of rows from lists of node and direction, or of node, direction, X, Y and Z.
pub(in crate::structure) fn listed(rows: &[Node]) -> String {
    let cell = |node: &Node| match &node.tree {
        Tree::Text(text) => text.clone(),
        Tree::Number(number) => number.clone(),
        Tree::Object(_) | Tree::List(_) | Tree::Bool(_) | Tree::Null => String::new(),
    };
    let row = |node: &Node| {
        let cells = node.list().unwrap_or_default().iter().map(cell);
        cells.collect::<Vec<_>>().join(",")
    };
    let places = rows.first().is_some_and(|first| first.items().len() == 5);
    let header = if places {
        "node,direction,X,Y,Z"
    } else {
        "node,direction"
    };
    let lines = std::iter::once(header.to_owned()).chain(rows.iter().map(row));
    lines.collect::<Vec<_>>().join("\n")
}

/// Rows whose supports the study gives.
pub(in crate::structure) fn supported(dofs: Dofs, reader: &Reader) -> Result<Dofs, ImportFault> {
    let given = &reader.names.supports;
    let is_given = |support: usize| {
        let name = &dofs.supports[support];
        given.iter().any(|support| support.0 == *name)
    };
    let mut rows = dofs.rows().iter();
    let unknown =
        rows.find_map(|dof| Some((dof, dof.support.filter(|support| !is_given(*support))?)));
    let Some((dof, support)) = unknown else {
        return Ok(dofs);
    };
    let names: Vec<&str> = given.iter().map(|support| support.0.as_str()).collect();
    let message = match names.is_empty() {
        true => format!(
            "the study has no \"supports\", which give the motion of support {}",
            dofs.supports[support]
        ),
        false => format!(
            "no support {} under \"supports\"; there are {}",
            dofs.supports[support],
            names.join(", ")
        ),
    };
    Err(ImportFault {
        line: dof.line,
        message,
    })
}

/// The content of a file that stands in the study itself, as notebooks give it.
pub(in crate::structure) fn inline<T>(
    content: &str,
    (node, path): (&Node, &str),
    faults: &mut Faults,
    parse: impl FnOnce(&[u8]) -> Result<T, ImportFault>,
) -> Option<T> {
    let parsed = parse(content.as_bytes());
    parsed
        .map_err(|why| faults.add(node.at, path, why.to_string()))
        .ok()
}
