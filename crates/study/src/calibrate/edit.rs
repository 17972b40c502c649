//! Studies made from the text of another one: what a search solves, and the errors at a point.

use super::nodes::{list, put, remove};
use crate::Study;
use crate::computed::sources::{self, Source};
use crate::error::Error;
use crate::source::faults::Faults;
use crate::source::input::Input;
use crate::source::object::Object;
use crate::source::tree::{Member, Node, Tree};
use crate::structure::keys::REFERENCES;

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
            let metrics = needed(root);
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
            let own = needed(root);
            put_metrics(
                root,
                own.into_iter().chain(metrics.iter().map(text)).collect(),
            );
            if let Some(structure) = root.member("structure") {
                remove(structure, &[REFERENCE]);
                put(structure, REFERENCE, text(&REFERENCES[0].to_owned()));
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
pub(super) fn needed(root: &Node) -> Vec<Node> {
    let mut none = Faults::default();
    let Some(object) = Object::open(root, "", &["metrics", "calibrate"], &mut none) else {
        return Vec::new();
    };
    let Some(minimised) = sources::minimised(&object) else {
        return Vec::new();
    };
    let listed = sources::listed(&object);
    let named: Vec<(&Member, &Source)> = listed
        .iter()
        .filter_map(|own| Some((own.name?, own)))
        .collect();
    let mut texts = vec![minimised.text];
    let mut kept: Vec<&Member> = Vec::new();
    while let Some(text) = texts.pop() {
        let words: Vec<&str> = text
            .split(|c: char| !(c.is_ascii_alphanumeric() || c == '_'))
            .collect();
        for (member, own) in &named {
            let is_known = kept.iter().any(|known| known.key == member.key);
            if words.contains(&member.key.as_str()) && !is_known {
                kept.push(member);
                texts.push(own.text);
            }
        }
    }
    // In the order of the file.
    let kept = named
        .iter()
        .filter(|(member, _)| kept.iter().any(|own| own.key == member.key));
    let object = |(member, own): &(&Member, &Source)| Node {
        at: own.at,
        tree: Tree::Object(vec![(*member).clone()]),
    };
    let metric = Node {
        at: minimised.at,
        tree: Tree::Text(minimised.text.to_owned()),
    };
    kept.map(object).chain([metric]).collect()
}
