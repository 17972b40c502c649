//! The paths that a file names in its own crate, read from its tokens. What only tests have is left out.

use super::sources::Module;
use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// A path of names from the root of the crate.
pub type Path = Vec<String>;

/// What begins an item that ends with a semicolon or a block.
const ITEMS: [&str; 14] = [
    "async",
    "const",
    "enum",
    "extern",
    "fn",
    "impl",
    "macro_rules",
    "mod",
    "static",
    "struct",
    "trait",
    "type",
    "unsafe",
    "use",
];

/// The modules that only tests have, in files of their own.
pub fn test_modules(module: &Module) -> Vec<Path> {
    read(module).tests
}

/// The paths of the crate that a module names.
pub fn imports(module: &Module) -> Vec<Path> {
    read(module).paths
}

fn read(module: &Module) -> Reader {
    let tokens: TokenStream = module
        .text
        .parse()
        .unwrap_or_else(|why| panic!("{}: {why}", module.file.display()));
    let mut reader = Reader::default();
    reader.read(tokens, &module.path);
    reader
}

/// What is read so far.
#[derive(Default)]
struct Reader {
    paths: Vec<Path>,
    tests: Vec<Path>,
}

impl Reader {
    /// Reads the tokens of a module, or of a group in it.
    fn read(&mut self, tokens: TokenStream, module: &[String]) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let mut i = 0;
        while i < tokens.len() {
            let rest = &tokens[i..];
            i += if is_test_attribute(rest) {
                self.test_item(&rest[2..], module) + 2
            } else if is(rest, 0, "pub") && matches!(rest.get(1), Some(TokenTree::Group(_))) {
                // `pub(in crate::a)` names no import.
                2
            } else if is(rest, 0, "use") {
                let end = position(rest, |token| is_point(token, ';'));
                for path in tree(&rest[1..end]) {
                    self.add(&path, module);
                }
                end + 1
            } else if let (true, Some(TokenTree::Ident(name)), Some(TokenTree::Group(group))) =
                (is(rest, 0, "mod"), rest.get(1), rest.get(2))
            {
                self.read(group.stream(), &joined(module, &name.to_string()));
                3
            } else if ["crate", "super", "self"]
                .iter()
                .any(|root| is(rest, 0, root))
            {
                let path = names(rest);
                self.add(&path, module);
                3 * path.len() - 2
            } else {
                if let TokenTree::Group(group) = &tokens[i] {
                    self.read(group.stream(), module);
                }
                1
            };
        }
    }

    /// Adds a path if it is of this crate.
    fn add(&mut self, path: &[String], module: &[String]) {
        let mut base = module.to_vec();
        let mut rest = path;
        match path.first().map(String::as_str) {
            Some("crate") => (base, rest) = (Vec::new(), &path[1..]),
            Some("super" | "self") => {}
            _ => return,
        }
        while let Some(first) = rest
            .first()
            .filter(|first| ["super", "self"].contains(&first.as_str()))
        {
            if first == "super" {
                base.pop();
            }
            rest = &rest[1..];
        }
        base.extend_from_slice(rest);
        self.paths.push(base);
    }

    /// The number of tokens of an item that only tests have. A module in a file of its own is remembered.
    fn test_item(&mut self, rest: &[TokenTree], module: &[String]) -> usize {
        let mut start = 0;
        // Further attributes, and who sees it.
        while rest.get(start).is_some_and(|token| is_point(token, '#')) {
            start += 2;
        }
        if is(rest, start, "pub") {
            start += 1
                + usize::from(
                    matches!(rest.get(start + 1), Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis),
                );
        }
        if let (true, Some(TokenTree::Ident(name))) = (is(rest, start, "mod"), rest.get(start + 1))
            && rest
                .get(start + 2)
                .is_some_and(|token| is_point(token, ';'))
        {
            self.tests.push(joined(module, &name.to_string()));
        }
        let is_item = ITEMS.iter().any(|word| is(rest, start, word));
        let is_use = is(rest, start, "use");
        let ends = |token: &TokenTree| {
            if let TokenTree::Group(group) = token {
                return !is_use && group.delimiter() == Delimiter::Brace;
            }
            is_point(token, ';') || !is_item && is_point(token, ',')
        };
        start + position(&rest[start..], ends) + 1
    }
}

/// Whether tokens begin with `#[cfg(test)]`, or with such a condition that has more.
fn is_test_attribute(tokens: &[TokenTree]) -> bool {
    let [hash, TokenTree::Group(group), ..] = tokens else {
        return false;
    };
    let text = group.stream().to_string();
    let words: Vec<&str> = text
        .split(|c: char| !c.is_alphanumeric() && c != '_')
        .collect();
    is_point(hash, '#')
        && words.first() == Some(&"cfg")
        && words.contains(&"test")
        && !words.contains(&"not")
}

/// The paths of a tree of imports, as in `a::{b, c::{d, self}}`.
fn tree(tokens: &[TokenTree]) -> Vec<Path> {
    let mut paths = Vec::new();
    for part in tokens.split(|token| is_point(token, ',')) {
        let path_names = names(part);
        match part.last() {
            Some(TokenTree::Group(group)) => {
                let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
                let inner = tree(&tokens).into_iter();
                paths.extend(inner.map(|path| [path_names.clone(), path].concat()));
            }
            _ => paths.push(path_names),
        }
    }
    paths
}

/// The names at the beginning that `::` joins.
fn names(tokens: &[TokenTree]) -> Path {
    let mut names = Vec::new();
    for window in tokens.chunks(3) {
        let TokenTree::Ident(name) = &window[0] else {
            break;
        };
        names.push(name.to_string());
        if !(window.len() == 3 && is_point(&window[1], ':') && is_point(&window[2], ':')) {
            break;
        }
    }
    names
}

fn joined(module: &[String], name: &str) -> Path {
    [module, &[name.to_owned()]].concat()
}

/// The place of the first token that `is` accepts, or the number of tokens.
fn position(tokens: &[TokenTree], is: impl Fn(&TokenTree) -> bool) -> usize {
    tokens.iter().position(is).unwrap_or(tokens.len())
}

fn is(tokens: &[TokenTree], i: usize, word: &str) -> bool {
    matches!(tokens.get(i), Some(TokenTree::Ident(name)) if name == word)
}

fn is_point(token: &TokenTree, point: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == point)
}
