//! Bindings that shadow the one of the statement just before.

/// The lines on which `let x = ..` follows `let x = ..` in a block.
pub fn of(text: &str) -> Vec<usize> {
    let mut before: Option<(usize, &str)> = None;
    let mut lines = Vec::new();
    for (i, line) in text.lines().enumerate() {
        let code = line.trim_start();
        if code.is_empty() || code.starts_with("//") {
            continue;
        }
        let indent = line.len() - code.len();
        if let Some(name) = bound(code) {
            if before.replace((indent, name)) == Some((indent, name)) {
                lines.push(i + 1);
            }
        } else if before.is_some_and(|(of_let, _)| {
            // A line that begins so ends the statement of `let`.
            let ends = code.starts_with([')', ']', '}', ';', '.']);
            indent < of_let || indent == of_let && !ends
        }) {
            before = None;
        }
    }
    lines
}

/// The name that a line binds alone.
fn bound(code: &str) -> Option<&str> {
    let pattern = code.strip_prefix("let ")?;
    let named = pattern.strip_prefix("mut ").unwrap_or(pattern);
    let (name, after) = named.split_at(named.find([' ', ':'])?);
    let is_name = name != "_" && name.chars().all(|c| c.is_alphanumeric() || c == '_');
    (is_name && (after.starts_with(": ") || after.starts_with(" ="))).then_some(name)
}
