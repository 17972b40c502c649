//! An object of the study file with its keys checked against those allowed.

use super::faults::{Faults, join, quoted, unknown};
use super::tree::{Member, Node, Tree};

/// The members of an object whose keys are allowed, in file order.
pub struct Object<'a> {
    at: usize,
    path: String,
    /// The keys with their values.
    pub members: Vec<&'a Member>,
}

impl<'a> Object<'a> {
    /// The members of `node`, which must be an object with the keys `allowed`. Every other key except `//` is a fault, and so is
    /// a repeated key.
    pub fn open(
        node: &'a Node,
        path: &str,
        allowed: &[&str],
        faults: &mut Faults,
    ) -> Option<Object<'a>> {
        Object::checked(node, path, Some(allowed), faults)
    }

    /// The same with any keys.
    pub fn of_any_keys(node: &'a Node, path: &str, faults: &mut Faults) -> Option<Object<'a>> {
        Object::checked(node, path, None, faults)
    }

    fn checked(
        node: &'a Node,
        path: &str,
        allowed: Option<&[&str]>,
        faults: &mut Faults,
    ) -> Option<Object<'a>> {
        let Tree::Object(listed) = &node.tree else {
            let keys = allowed.map(|keys| format!("an object with keys from {}", keys.join(", ")));
            faults.must_be(node, path, keys.as_deref().unwrap_or("an object"));
            return None;
        };
        let unknown_key = |key: &str| {
            let known = allowed.filter(|known| !known.contains(&key));
            known.map(|known| unknown("key", key, known))
        };
        let mut members: Vec<&Member> = Vec::new();
        for member in listed.iter().filter(|member| member.key != "//") {
            let path = join(path, &member.key);
            if let Some(message) = unknown_key(&member.key) {
                faults.add(member.node.at, &path, message);
            } else if members.iter().any(|first| first.key == member.key) {
                let message = format!("key {} is given twice in one object", quoted(&member.key));
                faults.add(member.at, &path, message);
            } else {
                members.push(member);
            }
        }
        Some(Object {
            at: node.at,
            path: path.to_owned(),
            members,
        })
    }

    /// The value of `key`, if it is given.
    pub fn get(&self, key: &str) -> Option<&'a Node> {
        self.members
            .iter()
            .find(|m| m.key == key)
            .map(|member| &member.node)
    }

    /// The value of `key`. If it is missing, that is a fault; `what` says what the key needs.
    pub fn need(&self, key: &str, what: &str, faults: &mut Faults) -> Option<&'a Node> {
        let found = self.get(key);
        if found.is_none() {
            self.missing(key, what, faults);
        }
        found
    }

    /// Decodes the items of the list under `key`, without those with a fault. Without the key there are no items.
    pub fn items<T>(
        &self,
        key: &str,
        faults: &mut Faults,
        decode: impl Fn(&Node, &str, &mut Faults) -> Option<T>,
    ) -> Vec<T> {
        let path = self.path(key);
        match self.get(key).map(|node| (node, &node.tree)) {
            None => Vec::new(),
            Some((_, Tree::List(items))) => {
                let items = items.iter().enumerate();
                items
                    .filter_map(|(i, item)| decode(item, &format!("{path}[{i}]"), faults))
                    .collect()
            }
            Some((node, _)) => {
                faults.must_be(node, &path, "a list");
                Vec::new()
            }
        }
    }

    /// Adds that `key` is missing, at the opening brace.
    pub fn missing(&self, key: &str, what: &str, faults: &mut Faults) {
        faults.add(self.at, &self.path(key), format!("missing: {what}"));
    }

    /// Adds a fault of the object, at the opening brace.
    pub fn fault(&self, message: impl Into<String>, faults: &mut Faults) {
        faults.add(self.at, &self.path, message);
    }

    /// The path of `key`.
    pub fn path(&self, key: &str) -> String {
        join(&self.path, key)
    }
}
