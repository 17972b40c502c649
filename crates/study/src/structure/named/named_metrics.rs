//! The metrics and channels that a study names, which become the tables of its problem.

use crate::computed::sources::{self, Source, is_arithmetic};
use crate::reduction::decode;
use crate::source::faults::{Faults, join, quoted};
use crate::source::hint::nearest;
use crate::source::object::Object;
use crate::source::tree::{Node, Tree};
use slipgap_problem::problem::expression::printable;
use slipgap_problem::problem::structure::channels::channel::{Channel, UNKNOWN};
use slipgap_problem::problem::structure::channels::names::Names;
use slipgap_problem::problem::structure::metrics::metric::{StructureMetric, looks_like_metric};
use slipgap_problem::problem::structure::metrics::pieces::{Piece, pieces};
use slipgap_problem::problem::structure::metrics::reduction::Reduction;
use slipgap_problem::problem::structure::tables::schema::Drawn;

/// The metrics in the list `metrics`, and those that reductions, checks, figures and searches name.
pub(in crate::structure) fn metrics(
    root: &Object,
    names: &Names,
    faults: &mut Faults,
) -> Vec<StructureMetric> {
    let mut metrics: Vec<StructureMetric> = Vec::new();
    let mut add = |text: &str, at: usize, path: &str, faults: &mut Faults| {
        if metrics.iter().any(|known| known.name == text.trim()) {
            return;
        }
        match StructureMetric::parse(text, names) {
            Ok(metric) => {
                if metric.needs_exact() {
                    let channel = metric.channel.as_ref();
                    refuse_energy(channel, text, (at, path), faults);
                }
                metrics.push(StructureMetric {
                    place: (at, path.to_owned()),
                    ..metric
                });
            }
            Err(why) => {
                faults.add(
                    at,
                    path,
                    format!("{}: {}", quoted(text), hinted(&why, names)),
                );
                // The name is known from here on, so that it is reported once.
                metrics.push(StructureMetric {
                    place: (at, path.to_owned()),
                    ..StructureMetric::named(text.trim(), Reduction::EnergyError)
                });
            }
        }
    };
    let named: Vec<&str> = sources::listed(root).iter().filter_map(name).collect();
    let asked = sources::listed(root).into_iter();
    for own in asked.chain(sources::reduced(root)) {
        // The text of a metric with a name, and of a reduction, may be another name.
        let is_name = own.name.is_some() && !own.text.contains('(') || named.contains(&own.text);
        match is_plain(own.text) {
            true if is_name && !looks_like_metric(own.text) => {}
            true => add(own.text, own.at, &own.path, faults),
            false => parts(&own, &mut |text, at| add(text, at, &own.path, faults)),
        }
    }
    for key in ["checks", "figures"] {
        if let Some(node) = root.get(key) {
            each_text(node, key, &mut |text, at, path| {
                if looks_like_metric(text) && is_plain(text) {
                    add(text, at, path, faults);
                }
            });
        }
    }
    let minimised = sources::minimised(root).into_iter();
    let searched = minimised.chain(sources::kept(root));
    for own in searched.filter(|own| is_plain(own.text)) {
        let is_name = !own.text.contains('(') || named.contains(&own.text);
        if !is_name || looks_like_metric(own.text) {
            add(own.text, own.at, &own.path, faults);
        }
    }
    for own in sources::shown(root) {
        if is_arithmetic(own.text) && decode::parts(own.text).is_none() && !is_plain(own.text) {
            parts(&own, &mut |text, at| add(text, at, &own.path, faults));
        }
    }
    metrics
}

/// The name that a study gives a metric.
fn name<'a>(own: &Source<'a>) -> Option<&'a str> {
    own.name.map(|member| member.key.as_str())
}

/// Whether a text is one reduction of a channel, perhaps with a fault, and no arithmetic.
fn is_plain(text: &str) -> bool {
    let text = text.trim();
    let count = |bracket: char| text.chars().filter(|c| *c == bracket).count();
    match &pieces(text)[..] {
        [Piece::Metric(range), ..] if *range == (0..text.len()) => true,
        // Without its closing bracket.
        [Piece::Name(_), ..] if looks_like_metric(&format!("{text})")) => count('(') > count(')'),
        _ => !is_arithmetic(text),
    }
}

/// The reductions of channels in arithmetic, each with its byte offset in the study.
fn parts<'a>(own: &Source<'a>, visit: &mut dyn FnMut(&'a str, usize)) {
    let (metric, _) = own.parts();
    for piece in pieces(metric) {
        if let Piece::Metric(range) = piece {
            visit(&own.text[range.clone()], own.place(range.start));
        }
    }
}

/// Whether arithmetic of metrics contains the name of a parameter.
pub(in crate::structure) fn names_parameter(root: &Object, name: &str) -> bool {
    let listed = sources::listed(root).into_iter();
    let listed_or_reduced = listed.chain(sources::reduced(root));
    let mut metrics = listed_or_reduced.chain(sources::shown(root));
    metrics.any(|own| {
        let (metric, _) = own.parts();
        let is_it =
            |piece: Piece| matches!(piece, Piece::Name(range) if metric[range.clone()] == *name);
        pieces(metric).into_iter().any(is_it)
    })
}

/// Reports an error of an energy.
fn refuse_energy(
    channel: Option<&Channel>,
    text: &str,
    (at, path): (usize, &str),
    faults: &mut Faults,
) {
    if channel.is_some_and(Channel::has_energy) {
        let message = format!(
            "{}: the exact motion has no energies by kind; compare u, v, a or forces",
            quoted(text)
        );
        faults.add(at, path, message);
    }
}

/// Why a text is no channel, with the nearest channel to an unknown name.
pub(in crate::structure) fn hinted(why: &str, names: &Names) -> String {
    let why = printable(why);
    let unknown = why
        .strip_prefix(UNKNOWN)
        .and_then(|rest| rest.split_once('\''));
    let hint = unknown.and_then(|(word, rest)| {
        let channels: Vec<String> = names.channels().collect();
        let known: Vec<&str> = channels.iter().map(String::as_str).collect();
        let nearest = nearest(word, &known)?;
        Some(format!("{UNKNOWN}{word}', did you mean '{nearest}'?{rest}"))
    });
    hint.unwrap_or_else(|| why.to_string())
}

/// The kinds of figure that draw channels, with the keys that name them.
const KINDS: [(&str, &[&str]); 5] = [
    ("history", &["y"]),
    ("curve", &["x", "y"]),
    ("orbit", &["x", "y"]),
    ("response", &["y"]),
    ("spectrum", &["of"]),
];

/// The channels that history figures and curves draw; `error(CHANNEL)` is the error of one.
pub(in crate::structure) fn drawn(root: &Object, names: &Names, faults: &mut Faults) -> Vec<Drawn> {
    let mut all: Vec<Drawn> = Vec::new();
    let Some(figures) = root.get("figures").and_then(Node::list) else {
        return all;
    };
    for (i, figure) in figures.iter().enumerate() {
        let Some(members) = figure.object() else {
            continue;
        };
        let kind = figure.get("kind").and_then(Node::text);
        let of_kind = KINDS.iter().find(|known| Some(known.0) == kind);
        let keys = of_kind.map(|known| known.1).unwrap_or_default();
        for member in members
            .iter()
            .filter(|member| keys.contains(&member.key.as_str()))
        {
            let path = format!("figures[{i}].{}", member.key);
            each_text(&member.node, &path, &mut |text, at, path| {
                if all.iter().any(|known| known.name == text) {
                    return;
                }
                let inside = text
                    .strip_prefix("error(")
                    .and_then(|rest| rest.strip_suffix(')'));
                let channel = Channel::parse(inside.unwrap_or(text), names).unwrap_or_else(|why| {
                    let message = format!("{}: {}", quoted(text), hinted(&why, names));
                    faults.add(at, path, message);
                    let (name, terms) = (text.to_owned(), Vec::new());
                    Channel { name, terms }
                });
                if inside.is_some() {
                    refuse_energy(Some(&channel), text, (at, path), faults);
                }
                all.push(Drawn {
                    name: text.to_owned(),
                    channel,
                    error: inside.is_some(),
                    place: (at, path.to_owned()),
                });
            });
        }
    }
    all
}

/// Reports `error(CHANNEL)` of figures in a study without exact motions.
pub(in crate::structure) fn report_errors_without_reference(
    root: &Object,
    drawn: &[Drawn],
    has_reference: bool,
    faults: &mut Faults,
) {
    let (Some(node), false) = (root.get("figures"), has_reference) else {
        return;
    };
    each_text(node, "figures", &mut |text, at, path| {
        if drawn.iter().any(|drawn| drawn.error && drawn.name == text) {
            let message = format!(
                "{} needs \"contacts_reference\" in \"structure\": softened or rigid",
                quoted(text)
            );
            faults.add(at, path, message);
        }
    });
}

/// Every text in a tree, with its place.
fn each_text(node: &Node, path: &str, visit: &mut dyn FnMut(&str, usize, &str)) {
    match &node.tree {
        Tree::Text(text) => visit(text, node.at, path),
        Tree::List(items) => {
            for (i, item) in items.iter().enumerate() {
                each_text(item, &format!("{path}[{i}]"), visit);
            }
        }
        Tree::Object(members) => {
            for member in members {
                each_text(&member.node, &join(path, &member.key), visit);
            }
        }
        Tree::Number(_) | Tree::Bool(_) | Tree::Null => {}
    }
}
