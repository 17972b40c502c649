//! Normal forces by other contacts and by springs.

use crate::source::faults::{Faults, unknown};
use crate::source::tree::{Node, Tree};
use crate::structure::keys::PRESSING;
use crate::structure::reading::reader::{Part, open};
use crate::value::text;
use slipgap_problem::problem::structure::parts::{
    contact::{Contact, Normal, Pressing, PressingPart},
    template::Spring,
};

/// Contacts with those that their normal forces are, NAME.N.
pub(in crate::structure) fn with_pressing(parts: Vec<Part>) -> Vec<Part> {
    let mut contacts = Vec::with_capacity(parts.len());
    for part in parts {
        let (name, node, path) = &part;
        let pressing = match &node.tree {
            Tree::Object(members) => members.iter().find(|member| member.key == "N"),
            Tree::List(_) | Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => None,
        };
        let pressing = pressing.filter(|member| is_contact(&member.node));
        let presses = pressing.map(|member| (by(name), &member.node, format!("{path}.N")));
        contacts.push(part);
        contacts.extend(presses);
    }
    contacts
}

/// The name of the contact that presses this one.
fn by(name: &str) -> String {
    format!("{name}.N")
}

/// Whether a normal force is a contact.
pub(super) fn is_contact(node: &Node) -> bool {
    match &node.tree {
        Tree::Object(members) => members.iter().any(|member| member.key == "law"),
        Tree::List(_) | Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => false,
    }
}

/// The contact that the normal force of the contact of this name is; of a law in a list it has none.
pub(super) fn by_contact(
    name: Option<&str>,
    (at, path): (usize, &str),
    faults: &mut Faults,
) -> Option<Vec<PressingPart>> {
    let Some(name) = name else {
        let message = "a law in a list has no contact in its N: write it beside, and its name here";
        faults.add(at, path, message);
        return None;
    };
    Some(vec![PressingPart {
        name: by(name),
        part: Pressing::Contact(0),
        place: (at, path.to_owned()),
    }])
}

/// The parts that a normal force names: one, or a list.
pub(super) fn parts(node: &Node, path: &str, faults: &mut Faults) -> Option<Vec<PressingPart>> {
    let object = open(node, path, PRESSING, faults)?;
    let (key, meaning) = PRESSING[0];
    let node = object.need(key, meaning, faults)?;
    let path = object.path(key);
    let part = |node: &Node, path: String, faults: &mut Faults| {
        Some(PressingPart {
            name: text(node, &path, faults)?,
            part: Pressing::Contact(0),
            place: (node.at, path),
        })
    };
    let Tree::List(items) = &node.tree else {
        return Some(vec![part(node, path, faults)?]);
    };
    if items.is_empty() {
        faults.must_be(node, &path, "a name, or a list of one name or more");
        return None;
    }
    let items = items.iter().enumerate();
    let parts: Vec<_> = items
        .map(|(i, item)| part(item, format!("{path}[{i}]"), faults))
        .collect();
    parts.into_iter().collect()
}

/// Finds the parts that the normal forces of contacts name, and reports names that are none or that come twice.
pub(super) fn find(contacts: &mut [Contact], springs: &[Spring], faults: &mut Faults) {
    let names: Vec<String> = contacts
        .iter()
        .map(|contact| contact.name.clone())
        .collect();
    for contact in contacts {
        let Some(Normal::Parts(parts)) = &mut contact.normal else {
            continue;
        };
        for i in 0..parts.len() {
            let again = parts[..i].iter().any(|before| before.name == parts[i].name);
            let part = &mut parts[i];
            let index = names.iter().position(|name| *name == part.name);
            let named = |spring: &Spring| !spring.name.is_empty() && spring.name == part.name;
            let message = match (index, springs.iter().position(named)) {
                _ if again => format!("{} presses already", part.name),
                (Some(_), _) if part.name == contact.name => {
                    "a contact does not press itself".to_owned()
                }
                (Some(number), _) => {
                    part.part = Pressing::Contact(number);
                    continue;
                }
                (None, Some(number)) => {
                    part.part = Pressing::Spring(number);
                    continue;
                }
                (None, None) => {
                    let springs = springs.iter().map(|spring| spring.name.as_str());
                    let listed = names.iter().map(String::as_str).chain(springs);
                    let known: Vec<&str> = listed.filter(|name| !name.is_empty()).collect();
                    unknown("contact or spring", &part.name, &known)
                }
            };
            faults.add(part.place.0, &part.place.1, message);
        }
    }
}
