//! An object of the study file with its keys checked against those allowed.

use super::faults::{Faults, join, quoted, unknown};
use super::field::{Field, Keys};
use super::tree::{Member, Node};
use slipgap_problem::problem::numbers::parameter::Range;

/// The members of an object whose keys are allowed, in file order.
pub struct Object<'a> {
    at: usize,
    path: String,
    keys: Keys,
    /// The keys with their values.
    pub members: Vec<&'a Member>,
}

impl<'a> Object<'a> {
    /// The members of `node`, which must be an object with these keys. Every other key except `//` is a fault, and so is a
    /// repeated key.
    pub fn open(
        node: &'a Node,
        path: &str,
        keys: &Keys,
        faults: &mut Faults,
    ) -> Option<Object<'a>> {
        Some(Object::of_keys(node, path, &keys.names(), faults)?.with(keys))
    }

    /// The same with keys that are names of something.
    pub fn of_keys(
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

    /// With the declarations of its keys.
    pub fn with(self, keys: &Keys) -> Object<'a> {
        Object {
            keys: *keys,
            ..self
        }
    }

    fn checked(
        node: &'a Node,
        path: &str,
        allowed: Option<&[&str]>,
        faults: &mut Faults,
    ) -> Option<Object<'a>> {
        let Some(listed) = node.object() else {
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
            keys: Keys::new(&[]),
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

    /// Its keys.
    pub fn keys(&self) -> &Keys {
        &self.keys
    }

    /// The declaration of a key.
    pub fn field(&self, key: &str) -> Option<&'static Field> {
        self.keys.get(key)
    }

    /// The range of the numbers under `key`.
    pub fn range(&self, key: &str) -> Range {
        self.keys.range(key)
    }

    /// The value of `key` with its path, if it is given. If it is missing but needed, that is a fault.
    pub fn given(&self, key: &str, faults: &mut Faults) -> Option<(&'a Node, String)> {
        let node = self.get(key).or_else(|| {
            self.field(key)
                .filter(|field| field.needed)
                .and_then(|_| self.needed(key, faults))
        })?;
        Some((node, self.path(key)))
    }

    /// The value of `key`. If it is missing, that is a fault with the meaning of the key.
    pub fn needed(&self, key: &str, faults: &mut Faults) -> Option<&'a Node> {
        let what = self
            .field(key)
            .map_or(String::new(), |field| match field.kind.words() {
                Some((None, names)) => format!("one of {}", names.join(", ")),
                _ => field.meaning.to_owned(),
            });
        self.need(key, &what, faults)
    }

    /// The object under `key`, with the keys of its declaration.
    pub fn object(&self, key: &str, faults: &mut Faults) -> Option<Object<'a>> {
        let (node, path) = self.given(key, faults)?;
        Object::open(node, &path, self.field(key)?.kind.keys()?, faults)
    }

    /// The only member with one of these keys. Another number of them is a fault.
    pub fn one_of(&self, keys: &[&str], faults: &mut Faults) -> Option<&'a Member> {
        let given = self.members.iter().copied();
        let given: Vec<_> = given.filter(|one| keys.contains(&&*one.key)).collect();
        let [member] = given[..] else {
            let message = format!("must have exactly one of {}", keys.join(", "));
            self.fault(message, faults);
            return None;
        };
        Some(member)
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
        let Some(node) = self.get(key) else {
            return Vec::new();
        };
        let Some(items) = node.list() else {
            faults.must_be(node, &path, "a list");
            return Vec::new();
        };
        let items = items.iter().enumerate();
        items
            .filter_map(|(i, item)| decode(item, &format!("{path}[{i}]"), faults))
            .collect()
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
