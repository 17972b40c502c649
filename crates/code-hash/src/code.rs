//! The tokens of a source file that are code.

use proc_macro2::{Delimiter, Group, LexError, TokenStream, TokenTree};

/// The tokens of a file on one line, without comments, documentation and items of tests.
///
/// # Errors
/// The text is not a sequence of tokens of Rust.
pub(crate) fn code(text: &str) -> Result<String, LexError> {
    let tokens: TokenStream = text.parse()?;
    Ok(without_docs_and_tests(tokens).to_string())
}

fn without_docs_and_tests(tokens: TokenStream) -> TokenStream {
    let mut kept = Vec::new();
    let mut rest = tokens.into_iter().peekable();
    let mut in_test = false;
    while let Some(token) = rest.next() {
        if is_sign(&token, '#') {
            let inner = rest.next_if(|next| is_sign(next, '!'));
            if let Some(TokenTree::Group(attribute)) = rest.peek() {
                let attribute = attribute.stream().to_string();
                let is_doc = attribute.starts_with("doc");
                in_test |= attribute == "cfg (test)" || attribute == "cfg(test)";
                if is_doc || in_test {
                    rest.next();
                    continue;
                }
            }
            kept.push(token);
            kept.extend(inner);
            continue;
        }
        if in_test {
            // The item ends with its body or a semicolon.
            in_test = !is_sign(&token, ';') && !is_body(&token);
            continue;
        }
        if let TokenTree::Group(group) = token {
            let inside = without_docs_and_tests(group.stream());
            kept.push(TokenTree::Group(Group::new(group.delimiter(), inside)));
        } else {
            kept.push(token);
        }
    }
    kept.into_iter().collect()
}

fn is_sign(token: &TokenTree, sign: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == sign)
}

fn is_body(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace)
}
