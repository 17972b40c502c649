//! Tests whether a picture is well-formed XML: one root, closed tags, quoted attributes, known entities, and only characters
//! that XML 1.0 allows.

/// The first fault, if any.
pub fn fault(text: &str) -> Option<String> {
    let allowed = |c: char| matches!(c, '\t' | '\n' | '\r' | ' '..='\u{d7ff}' | '\u{e000}'..='\u{fffd}' | '\u{10000}'..);
    if let Some(c) = text.chars().find(|c| !allowed(*c)) {
        return Some(format!("character {c:?}"));
    }
    let (mut open, mut roots) = (Vec::new(), 0);
    let mut rest = text;
    while let Some(start) = rest.find('<') {
        if let Some(bad) = outside(&rest[..start]) {
            return Some(bad);
        }
        if open.is_empty() && !rest[..start].trim().is_empty() {
            return Some("text outside the root".into());
        }
        let Some(end) = end_of_tag(&rest[start..]) else {
            return Some("a tag without end".into());
        };
        let tag = &rest[start + 1..start + end];
        rest = &rest[start + end + 1..];
        if tag.starts_with('?') || tag.starts_with('!') {
            continue;
        }
        if let Some(name) = tag.strip_prefix('/') {
            if open.pop() != Some(name.trim()) {
                return Some(format!("</{name}> closes nothing"));
            }
            continue;
        }
        let inner = tag.strip_suffix('/').unwrap_or(tag);
        let name = inner.split_whitespace().next().unwrap_or_default();
        if let Some(bad) = attributes(&inner[name.len()..]) {
            return Some(format!("<{tag}>: {bad}"));
        }
        roots += usize::from(open.is_empty());
        if inner.len() == tag.len() {
            open.push(name);
        }
    }
    if !open.is_empty() || roots != 1 || !rest.trim().is_empty() {
        return Some(format!("{roots} roots, {open:?} open, {rest:?} at the end"));
    }
    None
}

/// The `>` that ends a tag, not one in quotes.
fn end_of_tag(text: &str) -> Option<usize> {
    let mut quote = None;
    text.char_indices().find_map(|(i, c)| {
        match (quote, c) {
            (None, '>') => return Some(i),
            (None, '"' | '\'') => quote = Some(c),
            (Some(q), c) if q == c => quote = None,
            _ => {}
        }
        None
    })
}

/// A faulty `&` outside tags or in an attribute.
fn outside(text: &str) -> Option<String> {
    for (i, _) in text.match_indices('&') {
        let end = text[i..].find(';')?;
        let name = &text[i + 1..i + end];
        if !["amp", "lt", "gt", "quot", "apos"].contains(&name) && !name.starts_with('#') {
            return Some(format!("entity {name}"));
        }
    }
    None
}

fn attributes(text: &str) -> Option<String> {
    let mut rest = text.trim();
    let mut seen = Vec::new();
    while !rest.is_empty() {
        let Some((name, value)) = rest.split_once('=') else {
            return Some(format!("attribute {rest}"));
        };
        if seen.contains(&name) {
            return Some(format!("attribute {name} twice"));
        }
        seen.push(name);
        let quote = value.chars().next().filter(|c| ['"', '\''].contains(c));
        let Some((quote, end)) = quote.and_then(|q| Some((q, value[1..].find(q)?))) else {
            return Some(format!("attribute {name} without quotes"));
        };
        let inner = &value[1..=end];
        if inner.contains('<') || inner.contains(quote) {
            return Some(format!("attribute {name}: {inner}"));
        }
        if let Some(bad) = outside(inner) {
            return Some(bad);
        }
        rest = value[end + 2..].trim_start();
    }
    None
}

#[test]
fn faults_are_found() {
    for bad in [
        "<a>",
        "<a></b>",
        "<a/><b/>",
        "<a b=c/>",
        "<a b='1' b='2'/>",
        "<a>&x;</a>",
        "<a>\u{fffe}</a>",
        "a",
        "<a b='<'/>",
    ] {
        assert!(fault(bad).is_some(), "{bad}");
    }
    for good in [
        "<?xml version=\"1.0\"?><a b=\"1>2\" c='\"'><b/>x &lt; y</a>\n",
        "<a/>",
    ] {
        assert_eq!(fault(good), None, "{good}");
    }
}
