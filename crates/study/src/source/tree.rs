//! JSON text as a tree with the place of every key and value. Repeated keys remain.
//!
//! serde_json is the only parser. It gives raw values, which are slices of the text; their offsets are the places.

use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
use serde_json::value::RawValue;

use super::hint::unit;
use super::place::offset_of;

/// Most levels of nesting: more than any study needs, and few enough for a small stack.
const DEEPEST: usize = 32;

/// A value and the byte offset of its first character.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// The offset, in bytes.
    pub at: usize,
    /// The value.
    pub tree: Tree,
}

/// A JSON value; numbers stay as they are written.
#[derive(Debug, Clone, PartialEq)]
pub enum Tree {
    /// An object with its keys in order.
    Object(Vec<Member>),
    /// A list.
    List(Vec<Node>),
    /// A string without its escapes.
    Text(String),
    /// A number as it is written.
    Number(String),
    /// `true` or `false`.
    Bool(bool),
    /// `null`.
    Null,
}

/// One key of an object, with its own offset, and its value.
#[derive(Debug, Clone, PartialEq)]
pub struct Member {
    /// The key.
    pub key: String,
    /// The offset of the key, in bytes.
    pub at: usize,
    /// The value.
    pub node: Node,
}

impl Node {
    /// Adds `by` bytes to the offset of the node and of everything in it.
    pub fn move_by(&mut self, by: usize) {
        self.at += by;
        match &mut self.tree {
            Tree::Object(members) => {
                for member in members {
                    member.at += by;
                    member.node.move_by(by);
                }
            }
            Tree::List(items) => items.iter_mut().for_each(|item| item.move_by(by)),
            Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => {}
        }
    }

    /// The first value of an object under `key`.
    pub fn member(&mut self, key: &str) -> Option<&mut Node> {
        let Tree::Object(members) = &mut self.tree else {
            return None;
        };
        let mut members = members.iter_mut();
        let member = members.find(|member| member.key == key)?;
        Some(&mut member.node)
    }

    /// The members of an object; `None` for another value.
    pub fn object(&self) -> Option<&[Member]> {
        match &self.tree {
            Tree::Object(members) => Some(members),
            Tree::List(_) | Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => None,
        }
    }

    /// The first value of an object under `key`.
    pub fn get(&self, key: &str) -> Option<&Node> {
        let mut members = self.object()?.iter();
        Some(&members.find(|member| member.key == key)?.node)
    }

    /// The items of a list; `None` for another value.
    pub fn list(&self) -> Option<&[Node]> {
        match &self.tree {
            Tree::List(items) => Some(items),
            Tree::Object(_) | Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => None,
        }
    }

    /// The items of a list; another value is its only one.
    pub fn items(&self) -> &[Node] {
        self.list().unwrap_or(std::slice::from_ref(self))
    }

    /// The offset and path of item `i` of a list; those of the value itself without such an item.
    pub fn item(&self, path: &str, i: usize) -> (usize, String) {
        match self.list().and_then(|items| items.get(i)) {
            Some(item) => (item.at, format!("{path}[{i}]")),
            None => (self.at, path.to_owned()),
        }
    }

    /// A string; `None` for another value.
    pub fn text(&self) -> Option<&str> {
        match &self.tree {
            Tree::Text(text) => Some(text),
            Tree::Object(_) | Tree::List(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => None,
        }
    }
}

/// The first thing that is not JSON: byte offset, and what is wrong.
#[derive(Debug, PartialEq)]
pub struct SyntaxFault {
    /// The offset, in bytes.
    pub at: usize,
    /// What is wrong.
    pub message: String,
}

/// Parses a text strictly by RFC 8259.
pub fn parse(text: &str) -> Result<Node, SyntaxFault> {
    if text.trim().is_empty() {
        let message = "the file is empty; a study is a JSON object, { ... }".into();
        return Err(SyntaxFault { at: 0, message });
    }
    // This finds every fault except half a surrogate pair, without recursion for any depth.
    let root: &RawValue = serde_json::from_str(text).map_err(|e| syntax(text, text, &e))?;
    build(text, root.get(), 0)
}

/// The node of `part`, a value within `text`.
fn build(text: &str, part: &str, depth: usize) -> Result<Node, SyntaxFault> {
    let at = offset_within(text, part);
    if depth > DEEPEST {
        let message = format!("nested more than {DEEPEST} levels deep; allowed: at most {DEEPEST}");
        return Err(SyntaxFault { at, message });
    }
    let bad = |e| syntax(text, part, &e);
    let tree = match part.as_bytes().first() {
        Some(b'{') => {
            let Members(raw) = serde_json::from_str(part).map_err(bad)?;
            let mut members = Vec::with_capacity(raw.len());
            let mut end = at + 1;
            for (key, value) in raw {
                // Between the previous value and the quote of the key there are only blanks and a comma.
                let key_at = end + text[end..].find('"').unwrap_or(0);
                let node = build(text, value.get(), depth + 1)?;
                end = node.at + value.get().len();
                members.push(Member {
                    key,
                    at: key_at,
                    node,
                });
            }
            Tree::Object(members)
        }
        Some(b'[') => {
            let raw: Vec<&RawValue> = serde_json::from_str(part).map_err(bad)?;
            let items = raw.iter().map(|item| build(text, item.get(), depth + 1));
            Tree::List(items.collect::<Result<_, _>>()?)
        }
        Some(b'"') => Tree::Text(serde_json::from_str(part).map_err(bad)?),
        Some(b't') => Tree::Bool(true),
        Some(b'f') => Tree::Bool(false),
        Some(b'n') => Tree::Null,
        _ => Tree::Number(part.to_owned()),
    };
    Ok(Node { at, tree })
}

/// The offset of `part`, a slice of `text`.
fn offset_within(text: &str, part: &str) -> usize {
    part.as_ptr() as usize - text.as_ptr() as usize
}

/// Keys and raw values in file order, with repeated keys.
struct Members<'a>(Vec<(String, &'a RawValue)>);

impl<'de> Deserialize<'de> for Members<'de> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Collect;
        impl<'de> Visitor<'de> for Collect {
            type Value = Members<'de>;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("an object")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Members<'de>, A::Error> {
                let mut members = Vec::new();
                while let Some(member) = map.next_entry()? {
                    members.push(member);
                }
                Ok(Members(members))
            }
        }
        deserializer.deserialize_map(Collect)
    }
}

/// The fault that serde_json found in `part`, with its offset in the text and a hint, if there is one.
fn syntax(text: &str, part: &str, error: &serde_json::Error) -> SyntaxFault {
    let start = offset_within(text, part);
    if error.is_eof() {
        let message = format!("the file ends too early: {}", reason(error));
        let at = text.trim_end().len();
        return SyntaxFault { at, message };
    }
    let reason = reason(error);
    let mut at = start + offset_of(part, error.line(), error.column());
    if reason.starts_with("control character") {
        // Only for these, serde_json gives the place before.
        at += 1;
    }
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    let message = match hint(&reason, text[..at].trim_end(), &text[at..]) {
        Some(hint) => format!("not valid JSON: {reason}; {hint}"),
        None => format!("not valid JSON: {reason}"),
    };
    SyntaxFault { at, message }
}

/// The message of serde_json without its line and column.
fn reason(error: &serde_json::Error) -> String {
    let message = error.to_string();
    match message.rfind(" at line ") {
        Some(end) => message[..end].to_owned(),
        None => message,
    }
}

/// What to write instead, from the reason and the text before and at the fault.
fn hint(reason: &str, before: &str, rest: &str) -> Option<&'static str> {
    let found = rest.chars().next()?;
    let number = "numbers are written as in 0.5, 5 or 1e-3";
    Some(match (reason, found) {
        ("expected ident" | "expected value", 'N') if rest.starts_with("None") => {
            "None of Python is null, and no number is null: leave the key out"
        }
        ("expected ident" | "expected value", 'T' | 'F')
            if rest.starts_with("True") || rest.starts_with("False") =>
        {
            "True and False of Python are true and false"
        }
        ("invalid number" | "expected value", 'I' | 'N') => "NaN and Infinity are not allowed",
        ("invalid number", _) => number,
        ("expected value" | "key must be a string", '}' | ']') if before.ends_with(',') => {
            "no comma is allowed after the last one"
        }
        ("expected value", '.' | '+') => number,
        ("expected value", '\u{feff}') => {
            "the file begins with a byte-order mark; save it as UTF-8 without one"
        }
        ("expected value" | "key must be a string", c)
            if c.is_alphabetic() || "'‘’“”".contains(c) =>
        {
            "write names and expressions in double quotes, \"...\""
        }
        (_, '/' | '#') => "comments are not allowed; write a remark as a \"//\" key",
        (_, '\n' | '\r') => "a string must end on the line on which it begins",
        ("expected `,` or `}`" | "expected `,` or `]`", '"') => "a comma is missing before this",
        ("expected `,` or `}`" | "expected `,` or `]`", _) if has_unit(before, rest) => {
            "a number is written without a unit"
        }
        _ => return None,
    })
}

/// Whether a number is before the fault and a unit at it.
fn has_unit(before: &str, rest: &str) -> bool {
    let word = rest.split([',', '}', ']', '\n']).next().unwrap_or_default();
    before.ends_with(|c: char| c.is_ascii_digit()) && unit(&format!("1 {word}")).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(at: usize, written: &str) -> Node {
        let tree = Tree::Number(written.into());
        Node { at, tree }
    }

    #[test]
    fn places_and_repeated_keys_remain() {
        let node = parse("  {\"α\" : 1e999,\r\n\"α\":[ -0 ,null]}\n").unwrap();
        let list = Tree::List(vec![
            number(25, "-0"),
            Node {
                at: 29,
                tree: Tree::Null,
            },
        ]);
        let member = |at, node| Member {
            key: "α".into(),
            at,
            node,
        };
        let tree = Tree::Object(vec![
            member(3, number(10, "1e999")),
            member(18, Node { at: 23, tree: list }),
        ]);
        assert_eq!(node, Node { at: 2, tree });
    }

    #[test]
    fn text_that_is_not_json_is_refused_at_its_place() {
        for (text, at, says) in [
            ("", 0, "empty"),
            (" \n ", 0, "empty"),
            ("\u{feff}{}", 0, "byte-order mark"),
            ("{\"a\": NaN}", 6, "NaN and Infinity are not"),
            ("{\"a\": -Infinity}", 7, "Infinity are not"),
            ("{'a': 1}", 1, "double quotes"),
            ("{a: 1}", 1, "double quotes"),
            ("{\"a\": alpha}", 6, "double quotes"),
            ("{\"a\": 1 // so\n}", 8, "remark"),
            ("{\"a\": 1,}", 8, "no comma"),
            ("[1,]", 3, "no comma"),
            ("{\"a\": 1 \"b\": 2}", 8, "a comma is missing"),
            ("{\"a\" 1}", 5, "expected `:`"),
            ("[01]", 2, "numbers are written"),
            ("[1.]", 3, "numbers are written"),
            ("[.5]", 1, "numbers are written"),
            ("[+5]", 1, "numbers are written"),
            ("{\"a\": 0.05 s}", 11, "without a unit"),
            ("[1, 7850kg/m^3 , 2]", 8, "without a unit"),
            ("[2 pi]", 3, "expected `,`"),
            ("[0x1F]", 2, "expected `,`"),
            ("[\"α\u{1}b\"]", 4, "control character"),
            ("[\"a\nb\"]", 3, "on the line on which"),
            ("[\u{b}1]", 1, "expected value"),
            ("[\u{a0}1]", 1, "expected value"),
            ("[\"\\q\"]", 3, "escape"),
            ("[\"\\ud800\"]", 8, "escape"),
            ("{\"\\udc00\": 1}", 7, "surrogate"),
            ("{} {}", 3, "trailing characters"),
            ("{\"a\": [1, 2", 11, "ends too early"),
            ("{\"a\": \"b", 8, "ends too early"),
            ("{\"a\": \"b\n", 8, "on the line on which"),
            ("{\"a\": tru}", 9, "expected ident"),
        ] {
            let fault = parse(text).expect_err(text);
            assert!(fault.message.contains(says), "{text:?}: {}", fault.message);
            assert_eq!(fault.at, at, "{text:?}: {}", fault.message);
        }
    }

    #[test]
    fn deep_nesting_is_refused_without_recursion() {
        let deep = "[".repeat(100_000) + &"]".repeat(100_000);
        assert_eq!(parse(&deep).unwrap_err().at, DEEPEST + 1);
        let cut = "{\"a\":".repeat(100_000);
        assert!(parse(&cut).unwrap_err().message.contains("ends too early"));
    }
}
