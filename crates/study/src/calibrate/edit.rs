//! Studies made from the text of another one: what a search solves, and the errors at a point.

use super::nodes::{list, put, remove};
use crate::Study;
use crate::computed::sources::{self, Source};
use crate::error::Error;
use crate::source::faults::Faults;
use crate::source::input::Input;
use crate::source::object::Object;
use crate::source::tree::{Member, Node, Tree};
use crate::structure::keys::SOFTENED;

/// The key of the exact motion.
const REFERENCE: &str = "contacts_reference";

/// Keys of a study that need or show the results of several cases.
pub(super) const SHOWN: [&str; 4] = ["figures", "checks", "reductions", "ensemble"];

impl Input {
    /// The study with the metric that `calibrate` minimises as its only one, and what this is computed from: what a search solves.
    ///
    /// # Errors
    /// As of [`Input::study`].
    pub fn search_study(&self, limit: u64) -> Result<Study, Error> {
        self.edited(limit, |root| {
            let metrics = minimised(root);
            put_metrics(root, metrics);
        })
    }

    /// The study with the metrics that `recommend` keeps and these as its only ones, and what they are computed from.
    ///
    /// # Errors
    /// As of [`Input::study`].
    pub fn candidate_study(&self, more: &[&str], limit: u64) -> Result<Study, Error> {
        self.edited(limit, |root| {
            let at = root.at;
            let mut metrics = needed(root, sources::kept);
            for text in more {
                let tree = Tree::Text((*text).to_owned());
                if !metrics.iter().any(|known| known.tree == tree) {
                    metrics.push(Node { at, tree });
                }
            }
            put_metrics(root, metrics);
        })
    }

    /// The study with these errors as its only metrics, besides the one that `calibrate` minimises; its exact motion is that of the same
    /// laws.
    ///
    /// # Errors
    /// As of [`Input::study`]; and a metric has a fault.
    pub fn error_study(&self, metrics: &[String], limit: u64) -> Result<Study, Error> {
        self.edited(limit, |root| {
            let at = root.at;
            let text = |metric: &String| Node {
                at,
                tree: Tree::Text(metric.clone()),
            };
            let minimised_metric = minimised(root);
            put_metrics(
                root,
                minimised_metric
                    .into_iter()
                    .chain(metrics.iter().map(text))
                    .collect(),
            );
            if let Some(structure) = root.member("structure") {
                remove(structure, &[REFERENCE]);
                put(structure, REFERENCE, text(&SOFTENED.to_owned()));
            }
        })
    }

    /// Whether the structure has bars, the elements of which are a mesh.
    pub fn has_bars(&self) -> bool {
        let root = self.expanded().map(|expanded| expanded.root);
        root.is_ok_and(|mut root| {
            let structure = root.member("structure");
            structure.and_then(|node| node.member("bars")).is_some()
        })
    }
}

/// Puts these metrics in the place of all, and removes what shows others.
pub(super) fn put_metrics(root: &mut Node, metrics: Vec<Node>) {
    remove(root, &SHOWN);
    remove(root, &["metrics"]);
    put(root, "metrics", list(metrics));
}

/// The metric under `minimise`, after the metrics with names of the study that it contains.
pub(super) fn minimised(root: &Node) -> Vec<Node> {
    needed(root, |object| {
        sources::minimised(object).into_iter().collect()
    })
}

/// Some metrics, after those with names of the study that they contain.
fn needed(root: &Node, of: impl for<'a> Fn(&Object<'a>) -> Vec<Source<'a>>) -> Vec<Node> {
    let Some(object) = Object::of_any_keys(root, "", &mut Faults::default()) else {
        return Vec::new();
    };
    let wanted = of(&object);
    let listed = sources::listed(&object);
    let named: Vec<(&Member, &Source)> = listed
        .iter()
        .filter_map(|source| Some((source.name?, source)))
        .collect();
    let mut texts: Vec<&str> = wanted.iter().map(|source| source.text).collect();
    let mut kept: Vec<&Member> = Vec::new();
    while let Some(text) = texts.pop() {
        let words: Vec<&str> = text
            .split(|c: char| !(c.is_ascii_alphanumeric() || c == '_'))
            .collect();
        for (member, source) in &named {
            let is_known = kept.iter().any(|known| known.key == member.key);
            if words.contains(&member.key.as_str()) && !is_known {
                kept.push(member);
                texts.push(source.text);
            }
        }
    }
    // In the order of the file.
    let kept = named
        .iter()
        .filter(|(member, _)| kept.iter().any(|kept_member| kept_member.key == member.key));
    let object = |(member, source): &(&Member, &Source)| Node {
        at: source.at,
        tree: Tree::Object(vec![(*member).clone()]),
    };
    let metric = |source: &Source| Node {
        at: source.at,
        tree: Tree::Text(source.text.to_owned()),
    };
    kept.map(object).chain(wanted.iter().map(metric)).collect()
}
