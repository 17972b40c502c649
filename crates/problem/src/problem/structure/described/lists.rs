//! Lists in the description of a case.

/// Most lines of a list.
const MOST_LINES: usize = 12;

/// A number of things, such as `1 node` or `2 nodes`.
pub(super) fn count(number: usize, what: &str) -> String {
    match number {
        1 => format!("1 {what}"),
        _ => format!("{number} {what}s"),
    }
}

/// Items on one line; the middle of a long list is left out.
pub(super) fn list(what: &str, items: Vec<String>) -> String {
    if items.is_empty() {
        return String::new();
    }
    let len = items.len();
    let shown = match len <= MOST_LINES {
        true => items.join(", "),
        false => format!(
            "{}, ... ({len} in all), {}",
            items[..MOST_LINES - 2].join(", "),
            items[len - 1]
        ),
    };
    format!("{what}: {shown}\n")
}

pub(super) fn lines(what: &str, items: Vec<String>) -> String {
    let listed: String = items.iter().map(|item| format!("  {item}\n")).collect();
    match items.is_empty() {
        true => String::new(),
        false => format!("{what}:\n{listed}"),
    }
}
