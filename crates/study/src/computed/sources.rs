//! The texts of a study that name metrics.

use crate::figure::keys::Takes;
use crate::figure::kinds::KINDS;
use crate::reduction::decode;
use crate::source::faults::join;
use crate::source::field::{Keys, Kind, field, fields, needed};
use crate::source::object::Object;
use crate::source::tree::{Member, Node};
use slipgap_problem::problem::expression::FUNCTIONS;
use slipgap_problem::problem::structure::metrics::window::begins_with_limit;

/// The words before the values of a reference case.
pub const RELATIVE: &str = " relative to ";

/// The key of the metric that `calibrate` minimises.
pub const MINIMISE: &str = "minimise";

/// The key of the metrics that `recommend` keeps.
pub const WITHIN: &str = "within";

/// The keys of a metric with a name, each with its meaning.
pub(crate) const NAMED: Keys = Keys::new(&fields![
    /// the metric, arithmetic of metrics, or a ratio
    needed("value", Kind::Text),
    /// its unit, for figures; default none
    field("unit", Kind::Text),
    /// its title in figures; default the name
    field("title", Kind::Text),
]);

/// A text that names a metric.
#[derive(Debug, Clone)]
pub struct Source<'a> {
    /// The name that the study gives it.
    pub name: Option<&'a Member>,
    /// The text.
    pub text: &'a str,
    /// Byte offset of the string in the study.
    pub at: usize,
    /// Path of the string.
    pub path: String,
}

impl Source<'_> {
    /// Byte offset in the study of byte `offset` of the text.
    pub fn place(&self, offset: usize) -> usize {
        // With escapes, a text is shorter than what the study has.
        match self.text.contains(['"', '\\']) {
            true => self.at,
            false => self.at + 1 + offset,
        }
    }

    /// The text before the values of a reference case, if it has them, and these.
    pub fn parts(&self) -> (&str, Option<&str>) {
        match self.text.rsplit_once(RELATIVE) {
            Some((metric, values)) => (metric, Some(values)),
            None => (self.text, None),
        }
    }
}

fn source<'a>(node: &'a Node, path: String, name: Option<&'a Member>) -> Option<Source<'a>> {
    Some(Source {
        name,
        text: node.text()?,
        at: node.at,
        path,
    })
}

/// The items of a list with their paths; an object instead of the list is its one item.
pub fn items<'a>(node: &'a Node, path: &str) -> Vec<(&'a Node, String)> {
    let numbered = node.items().iter().enumerate();
    numbered
        .map(|(i, item)| (item, node.item(path, i).1))
        .collect()
}

/// The members of an object but remarks.
pub fn members(node: &Node) -> impl Iterator<Item = &Member> {
    let members = node.object().unwrap_or_default().iter();
    members.filter(|member| member.key != "//")
}

/// The texts under `metrics`.
pub fn listed<'a>(root: &Object<'a>) -> Vec<Source<'a>> {
    let mut found = Vec::new();
    let Some(node) = root.get("metrics") else {
        return found;
    };
    for (item, path) in items(node, "metrics") {
        found.extend(source(item, path.clone(), None));
        for member in members(item) {
            let path = join(&path, &member.key);
            let value = members(&member.node).find(|inner| inner.key == "value");
            found.extend(match value {
                Some(inner) => source(&inner.node, join(&path, &inner.key), Some(member)),
                None => source(&member.node, path, Some(member)),
            });
        }
    }
    found
}

/// The metrics of `reductions`.
pub fn reduced<'a>(root: &Object<'a>) -> Vec<Source<'a>> {
    let Some(node) = root.get(decode::KEY.name) else {
        return Vec::new();
    };
    let of = |(item, path): (&'a Node, String)| {
        let source_of_text = source(item, path, None)?;
        let metric = decode::parts(source_of_text.text)?.metric;
        let before = metric.as_ptr() as usize - source_of_text.text.as_ptr() as usize;
        Some(Source {
            at: source_of_text.place(before).saturating_sub(1),
            text: metric,
            ..source_of_text
        })
    };
    items(node, decode::KEY.name)
        .into_iter()
        .filter_map(of)
        .collect()
}

/// The metric that `calibrate` minimises.
pub fn minimised<'a>(root: &Object<'a>) -> Option<Source<'a>> {
    let node = root.get("calibrate")?;
    let minimised = members(node).find(|member| member.key == MINIMISE)?;
    let path = join("calibrate", MINIMISE);
    source(&minimised.node, path, None)
}

/// The metrics that `recommend` keeps.
pub fn kept<'a>(root: &Object<'a>) -> Vec<Source<'a>> {
    let recommend = root.get("recommend").into_iter().flat_map(members);
    let within = recommend.filter(|member| member.key == WITHIN);
    let metrics = within.flat_map(|member| members(&member.node));
    let source = |member: &'a Member| Source {
        name: None,
        text: &member.key,
        at: member.at,
        path: join(&join("recommend", WITHIN), &member.key),
    };
    metrics.map(source).collect()
}

/// The texts of checks, figures, `calibrate` and `recommend` where a metric is expected.
pub fn shown<'a>(root: &Object<'a>) -> Vec<Source<'a>> {
    let mut found: Vec<Source> = minimised(root).into_iter().chain(kept(root)).collect();
    for key in ["checks", "figures"] {
        let Some(node) = root.get(key) else {
            continue;
        };
        for (item, path) in items(node, key) {
            let takes = |name: &str| match key {
                "checks" => name == "metric",
                _ => takes_metric(item, name),
            };
            for member in members(item).filter(|member| takes(&member.key)) {
                let path = join(&path, &member.key);
                let texts = items(&member.node, &path).into_iter();
                found.extend(texts.filter_map(|(node, path)| source(node, path, None)));
            }
        }
    }
    found
}

/// Whether metrics stand under a key of a figure.
fn takes_metric(figure: &Node, key: &str) -> bool {
    let given = members(figure).filter(|member| member.key == "kind");
    let mut kinds = given.filter_map(|member| {
        let name = member.node.text()?;
        KINDS.iter().find(|kind| kind.name == name)
    });
    kinds.any(|kind| {
        kind.keys.iter().any(|key_kind| {
            use Takes::{Column, Columns, Metric, Metrics};
            key_kind.name == key && matches!(key_kind.kind, Metric | Metrics | Column | Columns)
        })
    })
}

/// Whether a text is arithmetic or a ratio, not only a name with or without brackets.
pub fn is_arithmetic(text: &str) -> bool {
    let text = text.trim();
    if text.contains(RELATIVE) {
        return true;
    }
    let mut depth = 0;
    let outside = text.chars().any(|c| {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        depth == 0 && "+-*/^".contains(c)
    });
    outside || is_call(text) || text.starts_with(|c: char| c.is_ascii_digit() || c == '(')
}

/// Whether a text is a function of numbers, such as `max(a, b)`.
fn is_call(text: &str) -> bool {
    let Some((name, inside)) = text.split_once('(') else {
        return false;
    };
    let (name, mut depth) = (name.trim(), 0);
    let has_comma = inside.char_indices().any(|(place, c)| {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        depth == 0 && c == ',' && !begins_with_limit(&inside[place + 1..])
    });
    let one = !["max", "min"].contains(&name);
    FUNCTIONS.iter().any(|function| function.0 == name) && (one || has_comma)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arithmetic_is_told_from_names() {
        for text in [
            "max(a3 - a2)/3.2",
            "sqrt(peak(a))",
            "max(peak(a), peak(b))",
            "max(min(a, from=1), peak(b, to=2))",
            "max(a, to=2)/3",
            "-peak(a)",
            "(peak(a))",
            "2",
            "peak(gap.S) relative to gamma = 1, n = 10",
        ] {
            assert!(is_arithmetic(text), "{text}");
        }
        for text in [
            "max(a3 - a2)",
            "max(a3 - a2, from=1, to=max(T, 2))",
            "min(a3 , from = -1)",
            "energy_error",
            "peek(p1 - p2)",
            "ground.Sa(1, 0.02)",
            "divergence(p1 - p2, 0.01)",
            "median peak(a) over seed",
        ] {
            assert!(!is_arithmetic(text), "{text}");
        }
    }
}
